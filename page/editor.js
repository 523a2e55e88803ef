// An editor of scenes: line numbers, completions and help from the schema, messages at their place.

/**
 * @typedef {{type?: string, description?: string, enum?: unknown[], default?: unknown, items?: Schema, anyOf?: Schema[],
 *   properties?: Record<string, Schema>}} Schema
 * @typedef {{message: string, line: number, column: number}} Finding
 */

class Editor {
  /** @param {Schema} schema @param {(text: string) => void} changed */
  constructor(schema, changed) {
    this.schema = schema;
    this.changed = changed;
    this.field = /** @type {HTMLTextAreaElement} */ (part('text'));
    /** @type {string[]} */
    this.offered = [];
    this.chosen = 0;
    /** @type {number[]} */
    this.marked = [];
    this.field.addEventListener('input', () => {
      this.#number_lines();
      this.#help();
      this.#offer(false);
      this.changed(this.field.value);
    });
    this.field.addEventListener('keydown', (event) => this.#key(event));
    for (const name of ['click', 'keyup']) this.field.addEventListener(name, () => this.#help());
    this.field.addEventListener('blur', () => window.setTimeout(() => this.#close(), 150));
    this.field.addEventListener('scroll', () => {
      part('gutter').scrollTop = this.field.scrollTop;
      this.#close();
    });
    part('completions').addEventListener('pointerdown', (event) => {
      const item = event.target instanceof Element ? event.target.closest('li') : null;
      if (!item) return;
      event.preventDefault();
      this.#take([...part('completions').children].indexOf(item));
    });
  }

  get text() {
    return this.field.value;
  }

  /** @param {string} text */
  set text(text) {
    this.field.value = text;
    this.field.setSelectionRange(0, 0);
    this.field.scrollTop = 0;
    this.marked = [];
    this.#number_lines();
    this.#help();
  }

  /** Marks the lines of these findings. @param {Finding[]} findings */
  mark(findings) {
    this.marked = findings.map((f) => f.line);
    this.#number_lines();
  }

  /** Puts the cursor on a line and column, both from 1. @param {number} line @param {number} column */
  go(line, column) {
    const lines = this.field.value.split('\n');
    const before = lines.slice(0, line - 1).reduce((sum, text) => sum + text.length + 1, 0);
    // Columns count characters, a text area counts UTF-16 units.
    const within = [...(lines[line - 1] ?? '')].slice(0, Math.max(0, column - 1)).join('').length;
    this.field.focus();
    this.field.setSelectionRange(before + within, before + within);
    this.field.scrollTop = Math.max(0, (line - 6) * 21);
    this.#help();
  }

  #number_lines() {
    const n = this.field.value.split('\n').length;
    part('gutter').replaceChildren(...Array.from({length: n}, (_, i) => {
      const line = document.createElement(this.marked.includes(i + 1) ? 'b' : 'span');
      line.textContent = String(i + 1);
      return [line, '\n'];
    }).flat());
  }

  /** The line of the cursor up to it and as a whole, and the table that it stands in. */
  #place() {
    const {value, selectionStart} = this.field;
    const before = value.slice(0, selectionStart);
    const line_begin = before.lastIndexOf('\n') + 1;
    const line_end = value.indexOf('\n', selectionStart);
    const line = value.slice(line_begin, line_end < 0 ? value.length : line_end);
    let table = '';
    for (const text of value.slice(0, line_begin).split('\n')) {
      const header = /^\s*\[\[?\s*([A-Za-z0-9_.-]+)\s*\]?\]/.exec(text);
      if (header) table = header[1] ?? '';
    }
    return {line, typed: before.slice(line_begin), table, begin: line_begin};
  }

  /** The schema at a dotted path: of a table, of an item of an array, or of a key. @param {string} path @returns {Schema|undefined} */
  #at(path) {
    /** @type {Schema|undefined} */
    let here = this.schema;
    for (const name of path.split('.').filter(Boolean)) {
      const inside = Editor.table_of(here);
      here = inside?.properties?.[name];
      if (!here) return undefined;
    }
    return here;
  }

  /** The part of a schema that has keys. @param {Schema|undefined} schema @returns {Schema|undefined} */
  static table_of(schema) {
    if (!schema) return undefined;
    if (schema.properties) return schema;
    if (schema.items?.properties) return schema.items;
    return schema.anyOf?.map((s) => Editor.table_of(s)).find(Boolean);
  }

  /** The names that a value may have. @param {Schema|undefined} schema @returns {unknown[]} */
  static names_of(schema) {
    if (!schema) return [];
    if (schema.enum) return schema.enum;
    if (schema.type === 'boolean') return [true, false];
    return [...(schema.items ? Editor.names_of(schema.items) : []), ...(schema.anyOf ?? []).flatMap((s) => Editor.names_of(s))];
  }

  /** Says what the key of the cursor means. */
  #help() {
    const {line, table} = this.#place();
    const key = /^\s*([A-Za-z0-9_.-]+)\s*=/.exec(line)?.[1] ?? /^\s*([A-Za-z0-9_.-]+)\s*$/.exec(line)?.[1];
    const header = /^\s*\[\[?\s*([A-Za-z0-9_.-]+)/.exec(line)?.[1];
    const path = header ?? (key ? (table ? `${table}.${key}` : key) : table);
    const found = path ? this.#at(path) : undefined;
    const name = document.createElement('b');
    name.textContent = found ? path ?? '' : '';
    const keys = Object.keys(Editor.table_of(found)?.properties ?? {});
    const text = found?.description ?? (keys.length > 0 ? keys.join(', ') : '');
    part('help').replaceChildren(name, text ? ` ${text}` : '');
  }

  /** Offers what may stand at the cursor. @param {boolean} asked by the viewer, also where nothing is typed */
  #offer(asked) {
    const {typed, table} = this.#place();
    const value = /^\s*([A-Za-z0-9_.-]+)\s*=\s*(.*)$/.exec(typed);
    let word = '';
    /** @type {string[]} */
    let all = [];
    if (/^\s*#/.test(typed)) all = [];
    else if (value) {
      word = /["A-Za-z0-9_-]*$/.exec(value[2] ?? '')?.[0] ?? '';
      const schema = this.#at(table ? `${table}.${value[1]}` : value[1] ?? '');
      all = Editor.names_of(schema).map((name) => (typeof name === 'string' ? JSON.stringify(name) : String(name)));
    } else if (/^\s*\[/.test(typed)) {
      word = typed.trimStart();
      all = Object.entries(this.schema.properties ?? {}).filter(([, s]) => Editor.table_of(s))
        .map(([name, s]) => (s.type === 'array' ? `[[${name}]]` : `[${name}]`));
    } else {
      word = typed.trimStart();
      all = Object.keys(Editor.table_of(this.#at(table))?.properties ?? {}).map((name) => `${name} = `);
    }
    const bare = word.replace(/^["[]+/, '').toLowerCase();
    this.offered = all.filter((name) => name !== word && name.replace(/^["[]+/, '').toLowerCase().startsWith(bare));
    this.word = word;
    if (this.offered.length === 0 || (!asked && bare === '')) {
      this.#close();
      return;
    }
    this.chosen = 0;
    this.#list();
  }

  #list() {
    const list = part('completions');
    const {typed} = this.#place();
    const line = this.field.value.slice(0, this.field.selectionStart).split('\n').length;
    list.replaceChildren(...this.offered.map((name, i) => {
      const item = document.createElement('li');
      item.setAttribute('role', 'option');
      item.setAttribute('aria-selected', String(i === this.chosen));
      item.textContent = name;
      return item;
    }));
    list.style.left = `${Math.min(60 + typed.length * 8.4, Math.max(0, part('sheet').clientWidth - 220))}px`;
    const top = line * 21 + 14 - this.field.scrollTop;
    list.style.top = `${Math.max(0, Math.min(top, part('sheet').clientHeight - 120))}px`;
    list.hidden = false;
    list.children[this.chosen]?.scrollIntoView({block: 'nearest'});
  }

  #close() {
    part('completions').hidden = true;
  }

  /** @param {number} index */
  #take(index) {
    const name = this.offered[index];
    if (name === undefined) return;
    const at = this.field.selectionStart;
    const from = at - (this.word?.length ?? 0);
    // A closing quote that stands there already is not written twice.
    const after = this.field.value.slice(at);
    const end = name.endsWith('"') && after.startsWith('"') ? at + 1 : at;
    this.field.setRangeText(name, from, end, 'end');
    this.#close();
    this.#number_lines();
    this.#help();
    this.changed(this.field.value);
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    event.stopPropagation();
    if (event.key === ' ' && event.ctrlKey) {
      event.preventDefault();
      this.#offer(true);
      return;
    }
    if (part('completions').hidden) return;
    if (event.key === 'ArrowDown' || event.key === 'ArrowUp') {
      const n = this.offered.length;
      this.chosen = (this.chosen + (event.key === 'ArrowDown' ? 1 : n - 1)) % n;
      this.#list();
    } else if (event.key === 'Enter' || event.key === 'Tab') this.#take(this.chosen);
    else if (event.key === 'Escape') this.#close();
    else return;
    event.preventDefault();
  }
}
