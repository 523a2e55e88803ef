// Drafts: scenes that are being written, kept in this browser until they are older than most others.

/**
 * @typedef {{id: string, writer: string, at_ms: number, name: string, source: SceneSource, kept: KeptText, files: Record<string, string>}} Draft
 *   `writer`: the visit to the page that wrote it last; `files`: as base64, those that the text names.
 */

const draft_prefix = 'poinsot-draft-';
const most_drafts = 8;
/** Characters of one draft, of the 5 million that a browser grants a page. */
const most_draft_characters = 1.8e6;

class Drafts {
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
    if (this.has_written && this.list().find((draft) => draft.id === this.id)?.writer !== this.writer) this.begin();
    const draft = {id: this.id, writer: this.writer, at_ms: Date.now(), name, source};
    // What can be undone, and then the files, are left out where there is no room for them.
    const versions = [{...draft, kept, files}, {...draft, kept: {text: kept.text}, files}, {...draft, kept: {text: kept.text}, files: {}}];
    const others = this.list().filter(({id}) => id !== this.id);
    for (const old of others.splice(most_drafts - 1)) this.remove(old.id);
    for (const version of versions) {
      const text = JSON.stringify(version);
      if (text.length > most_draft_characters && version !== versions[2]) continue;
      for (;;) {
        try {
          store.setItem(draft_prefix + this.id, text);
          this.has_written = true;
          return true;
        } catch {
          // The store is full: the oldest draft makes room.
          const oldest = others.pop();
          if (!oldest) break;
          this.remove(oldest.id);
        }
      }
    }
    return false;
  }
}
