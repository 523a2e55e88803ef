// Drafts: scenes that are being written, kept in this browser until they are older than most others.

/** @import {KeptText} from './editor.js' */
/** @import {SceneSource} from './workbench.js' */

/**
 * @typedef {{id: string, writer: string, at_ms: number, name: string, source: SceneSource, kept: KeptText, files: Record<string, string>}} Draft
 *   `writer`: the visit to the page that wrote it last; `files`: as base64, those that the text names.
 */

const draft_prefix = 'poinsot-draft-';
const most_drafts = 8;
/** Characters of one draft, of the 5 million that a browser grants a page. */
const most_draft_characters = 1.8e6;
/** Of what the editor needs to undo changes. */
const most_state_characters = 3e5;

export class Drafts {
  constructor() {
    this.writer = Drafts.#fresh();
    this.id = Drafts.#fresh();
    this.has_written = false;
  }

  static #fresh() {
    return `${Date.now().toString(36)}${Math.random().toString(36).slice(2, 8)}`;
  }

  /** The store of the browser; null where it refuses one. */
  static store() {
    try {
      return window.localStorage;
    } catch {
      return null;
    }
  }

  /** All drafts, the latest first. @returns {Draft[]} */
  list() {
    const store = Drafts.store();
    /** @type {Draft[]} */
    const drafts = [];
    for (let i = 0; store && i < store.length; ++i) {
      const key = store.key(i) ?? '';
      if (!key.startsWith(draft_prefix)) continue;
      try {
        const draft = JSON.parse(store.getItem(key) ?? '');
        if (typeof draft.kept.text === 'string' && typeof draft.name === 'string' && draft.source && draft.files) drafts.push(draft);
      } catch {
        // Of another program, or damaged.
      }
    }
    return drafts.sort((a, b) => b.at_ms - a.at_ms);
  }

  /** The draft that follows is another one: the last stays as it is. */
  begin() {
    this.id = Drafts.#fresh();
    this.has_written = false;
  }

  /** What follows is written to this draft. @param {Draft} draft */
  go_on(draft) {
    this.id = draft.id;
    this.has_written = false;
  }

  /** @param {string} id */
  remove(id) {
    Drafts.store()?.removeItem(draft_prefix + id);
  }

  /**
   * Keeps a scene; false: the browser did not.
   * @param {{name: string, source: SceneSource, kept: KeptText, files: Record<string, string>}} scene
   */
  keep({name, source, kept, files}) {
    const store = Drafts.store();
    if (!store) return false;
    // Another tab goes on with this draft.
    const {writer} = this;
    if (this.has_written && !store.getItem(draft_prefix + this.id)?.startsWith(JSON.stringify({id: this.id, writer}).slice(0, -1))) this.begin();
    const draft = {id: this.id, writer, at_ms: Date.now(), name, source};
    const text_alone = {text: kept.text};
    const has_short_state = JSON.stringify(kept.state ?? '').length <= most_state_characters;
    // The files are left out where there is no room for them.
    const versions = [{...draft, kept: has_short_state ? kept : text_alone, files}, {...draft, kept: text_alone, files: {}}].map((version) => JSON.stringify(version));
    /** The other drafts, which are needed only now and then. @type {Draft[]|null} */
    let others = null;
    const oldest = (/** @type {number} */ n_stay) => (others ??= this.list().filter(({id}) => id !== this.id)).splice(n_stay);
    if (!this.has_written) for (const old of oldest(most_drafts - 1)) this.remove(old.id);
    for (const version of versions) {
      if (version.length > most_draft_characters && version !== versions[1]) continue;
      for (;;) {
        try {
          store.setItem(draft_prefix + this.id, version);
          this.has_written = true;
          return true;
        } catch {
          // The store is full: the oldest draft makes room.
          oldest(Infinity);
          const old = /** @type {Draft[]} */ (/** @type {unknown} */ (others)).pop();
          if (!old) break;
          this.remove(old.id);
        }
      }
    }
    return false;
  }
}
