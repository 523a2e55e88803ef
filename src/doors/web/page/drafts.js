// Drafts: scenes that are being written, kept in this browser until they are older than most others.

/** @import {KeptText} from './editor.js' */
/** @import {SceneSource} from './workbench.js' */

/**
 * @typedef {{id: string, writer: string, at_ms: number, name: string, source: SceneSource, kept: KeptText, files: Record<string, string>, lacks?: string[]}} Draft
 *   `writer`: the visit to the page that wrote it last; `files`: as base64, those that the text names; `lacks`: those for which there was no room.
 * @typedef {{text: boolean, lacks: string[]}} Kept whether the browser keeps the text, and the files of the scene that it does not keep
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
   * Keeps a scene. Other drafts than the oldest beyond `most_drafts` stay; for a text, not for files, the oldest give up their files.
   * What does not help is undone.
   * @param {{name: string, source: SceneSource, kept: KeptText, files: Record<string, string>}} scene
   * @returns {Kept}
   */
  keep({name, source, kept, files}) {
    const all = Object.keys(files);
    const nothing = {text: false, lacks: all};
    const store = Drafts.store();
    if (!store) return nothing;
    // Another tab goes on with this draft.
    const {writer} = this;
    if (this.has_written && !store.getItem(draft_prefix + this.id)?.startsWith(JSON.stringify({id: this.id, writer}).slice(0, -1))) this.begin();
    // A scene that is no example never needs its first text again.
    const draft = {id: this.id, writer, at_ms: Date.now(), name, source: source.kind === 'example' ? source : {...source, text: ''}};
    const text_alone = {text: kept.text};
    const has_short_state = JSON.stringify(kept.state ?? '').length <= most_state_characters;
    const whole = JSON.stringify({...draft, kept: has_short_state ? kept : text_alone, files, lacks: []});
    const text = JSON.stringify({...draft, kept: text_alone, files: {}, lacks: all});
    const others = this.list().filter(({id}) => id !== this.id);
    const surplus = this.has_written ? [] : others.splice(most_drafts - 1);
    /** Drafts that have made room, as they were. @type {[string, string][]} */
    const moved = [];
    const shorten = (/** @type {Draft} */ old, /** @type {Draft|null} */ shorter) => {
      const key = draft_prefix + old.id;
      moved.push([key, store.getItem(key) ?? '']);
      store.removeItem(key);
      if (shorter) store.setItem(key, JSON.stringify(shorter));
    };
    const drop_surplus = () => {
      for (const old of surplus.splice(0)) shorten(old, null);
    };
    const with_files = others.filter((old) => Object.keys(old.files).length > 0).reverse();
    /** From what takes no room of others to what does. @type {[version: string, make_room: () => void][]} */
    const attempts = [[whole, () => {}], [whole, drop_surplus], [text, () => {}],
      ...with_files.map((old) => /** @type {[string, () => void]} */ ([text, () => shorten(old, {...old, files: {}, lacks: Object.keys(old.files)})]))];
    for (const [version, make_room] of attempts) {
      if (version.length > most_draft_characters) continue;
      try {
        make_room();
        store.setItem(draft_prefix + this.id, version);
      } catch {
        continue;
      }
      drop_surplus();
      this.has_written = true;
      return {text: true, lacks: version === whole ? [] : all};
    }
    try {
      for (const [key, before] of moved) store.setItem(key, before);
    } catch {
      // Another page of this origin has taken the room at this instant.
    }
    return nothing;
  }
}
