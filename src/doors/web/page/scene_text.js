// Places of values in the text of a scene, so that one of them can be changed and the rest stays as it is. Source: TOML 1.0.

/** A change of a text: what stands from `from` to `to` is replaced. @typedef {{from: number, to: number, insert: string}} TextEdit */

/**
 * A value by its path, as --set names it ("start.omega_rad_s", "body.masses[1].at_m[0]"), and the line of its key.
 * @typedef {{from: number, to: number, table: string, line: {from: number, to: number}|null}} PlacedValue `line`: null within arrays and inline tables
 */

class Places {
  /** @param {string} text that the program accepts */
  constructor(text) {
    this.text = text;
    this.at = 0;
    /** @type {Map<string, PlacedValue>} */
    this.values = new Map();
    /** The end of the last line of each table that has a header; of the root, if it has keys. @type {Map<string, number>} */
    this.tables = new Map();
    /** The ends of the last values in inline tables, and of their brackets that open. @type {Map<string, {at: number, is_empty: boolean}>} */
    this.inlines = new Map();
    /** How many items each array of tables has. @type {Map<string, number>} */
    this.counts = new Map();
    /** Where the first header stands. */
    this.first_header = text.length;
    this.#read();
  }

  #read() {
    let table = '';
    for (this.#skip(true); this.at < this.text.length; this.#skip(true)) {
      const from = this.at;
      const is_header = this.#takes('[');
      if (is_header) {
        this.first_header = Math.min(this.first_header, from);
        const is_item = this.#takes('[');
        table = this.#resolved(this.#key());
        if (is_item) {
          const n = this.counts.get(table) ?? 0;
          this.counts.set(table, n + 1);
          table += `[${n}]`;
        }
        this.#need(']');
        if (is_item) this.#need(']');
      } else this.#pair(table, table, from);
      const end = this.text.indexOf('\n', this.at);
      this.at = end < 0 ? this.text.length : end;
      this.tables.set(table, this.at);
      const last = [...this.values.values()].pop();
      if (!is_header && last?.line) last.line = {from, to: this.at};
    }
  }

  /** A key with its value. @param {string} path of the table @param {string} table @param {number} from of its line; -1: within an inline table */
  #pair(path, table, from) {
    const name = `${path}${path ? '.' : ''}${this.#key().join('.')}`;
    this.#need('=');
    this.#skip(false);
    this.#value(name, table, from >= 0 ? {from, to: from} : null);
  }

  /** @param {string} name @param {string} table @param {PlacedValue['line']} line */
  #value(name, table, line) {
    const {text} = this;
    const from = this.at;
    const quotes = ['"""', "'''", '"', "'"].find((mark) => text.startsWith(mark, from));
    if (quotes) {
      const inner = quotes.startsWith('"') ? /\\[^]|[^]/y : /[^]/y;
      this.at += quotes.length;
      while (!text.startsWith(quotes, this.at)) {
        inner.lastIndex = this.at;
        const part = inner.exec(text);
        if (!part) throw new Error('a string has no end');
        this.at += part[0].length;
      }
      this.at += quotes.length;
      // Up to two quotes may stand before the three that end a string.
      for (let n = 0; n < 2 && quotes.length === 3 && text[this.at] === quotes[0]; ++n) ++this.at;
    } else if (this.#takes('[')) {
      for (let k = 0; this.#skip(true), !this.#takes(']'); ++k) {
        this.#value(`${name}[${k}]`, table, null);
        this.#skip(true);
        this.#takes(',');
      }
    } else if (this.#takes('{')) {
      this.inlines.set(name, {at: this.at, is_empty: true});
      for (this.#skip(true); !this.#takes('}'); this.#skip(true)) {
        this.#pair(name, table, -1);
        this.inlines.set(name, {at: this.at, is_empty: false});
        this.#skip(true);
        this.#takes(',');
      }
    } else {
      const bare = /[^,\]}\r\n#]*/y;
      bare.lastIndex = from;
      this.at += (bare.exec(text)?.[0] ?? '').trimEnd().length;
      if (this.at === from) throw new Error('a value is missing');
    }
    this.values.delete(name);
    this.values.set(name, {from, to: this.at, table, line});
  }

  /** The parts of a key. @returns {string[]} */
  #key() {
    const parts = [];
    do {
      this.#skip(false);
      const part = /"((?:[^"\\\n]|\\.)*)"|'([^'\n]*)'|([A-Za-z0-9_-]+)/y;
      part.lastIndex = this.at;
      const found = part.exec(this.text);
      if (!found) throw new Error('a key is missing');
      this.at += found[0].length;
      parts.push(found[1] ?? found[2] ?? found[3] ?? '');
      this.#skip(false);
    } while (this.#takes('.'));
    return parts;
  }

  /** The path of a header: of an array of tables, its last item. @param {string[]} parts */
  #resolved(parts) {
    return parts.reduce((path, part, k) => {
      const name = `${path}${path ? '.' : ''}${part}`;
      const n = k + 1 < parts.length ? this.counts.get(name) : undefined;
      return n ? `${name}[${n - 1}]` : name;
    }, '');
  }

  /** Leaves out blanks; with line ends, comments too. @param {boolean} with_lines */
  #skip(with_lines) {
    const blanks = with_lines ? /(?:[ \t\r\n]|#[^\n]*)*/y : /[ \t]*/y;
    blanks.lastIndex = this.at;
    this.at += blanks.exec(this.text)?.[0].length ?? 0;
  }

  /** @param {string} letter */
  #takes(letter) {
    if (this.text[this.at] !== letter) return false;
    ++this.at;
    return true;
  }

  /** @param {string} letter */
  #need(letter) {
    this.#skip(false);
    if (!this.#takes(letter)) throw new Error(`"${letter}" is missing`);
  }
}

/** The places in a text; null: it is no TOML. @param {string} text */
function places_of(text) {
  try {
    return new Places(text);
  } catch {
    return null;
  }
}

/** The text of a value; null: the text has none. @param {string} text @param {string} key */
export function value_in(text, key) {
  const value = places_of(text)?.values.get(key);
  return value ? text.slice(value.from, value.to) : null;
}

/**
 * The change that gives a key a value in its place, or in its table if it has none. Null: the text has no place for it.
 * @param {string} text @param {string} key as for --set @param {string} value TOML @returns {TextEdit|null}
 */
export function edit_of(text, key, value) {
  const places = places_of(text);
  if (!places) return null;
  const old = places.values.get(key);
  if (old) return {from: old.from, to: old.to, insert: value};
  if (key.endsWith(']')) return null;
  const dot = key.lastIndexOf('.');
  const [table, name] = dot < 0 ? ['', key] : [key.slice(0, dot), key.slice(dot + 1)];
  const at = (/** @type {number} */ place, /** @type {string} */ insert) => ({from: place, to: place, insert});
  const inline = places.inlines.get(table);
  if (inline) return at(inline.at, `${inline.is_empty ? ' ' : ', '}${name} = ${value}`);
  const end = places.tables.get(table);
  if (end !== undefined) return at(end, `\n${name} = ${value}`);
  if (table === '') return at(places.first_header, `${name} = ${value}\n\n`);
  if (places.values.has(table) || table.endsWith(']')) return null;
  // A table without a header, whose keys have dots.
  const beside = [...places.values].filter(([path, {line}]) => line && path.startsWith(`${table}.`)).pop()?.[1];
  if (beside?.line) return at(beside.line.to, `\n${beside.table ? key.slice(beside.table.length + 1) : key} = ${value}`);
  return at(text.length, `${text.endsWith('\n') || text === '' ? '' : '\n'}\n[${table}]\n${name} = ${value}\n`);
}

/** The change that takes a key and its line away. Null: it has no line of its own. @param {string} text @param {string} key @returns {TextEdit|null} */
export function removal_of(text, key) {
  const line = places_of(text)?.values.get(key)?.line;
  if (!line) return null;
  // With the end of the line before it: a text keeps its last line end.
  return line.from > 0 ? {from: line.from - 1, to: line.to, insert: ''} : {from: 0, to: Math.min(line.to + 1, text.length), insert: ''};
}

/** The text after a change. @param {string} text @param {TextEdit} edit */
export function edited(text, {from, to, insert}) {
  return text.slice(0, from) + insert + text.slice(to);
}

/** The shortest change from one text to another. @param {string} before @param {string} after @returns {TextEdit} */
export function difference_of(before, after) {
  const most = Math.min(before.length, after.length);
  let from = 0;
  while (from < most && before[from] === after[from]) ++from;
  let same = 0;
  while (same < most - from && before[before.length - 1 - same] === after[after.length - 1 - same]) ++same;
  return {from, to: before.length - same, insert: after.slice(from, after.length - same)};
}

/** A value as TOML: what is none is a string, as for --set. @param {string} value */
export function as_toml(value) {
  return /^\s*(["'[{]|[+-]?(\d|\.\d|inf\b|nan\b)|true\s*$|false\s*$)/.test(value) ? value : JSON.stringify(value);
}
