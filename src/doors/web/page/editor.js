// The editor of scenes: CodeMirror, with completions, help and messages from the schema; without npm's packages, a plain text area.

import {part} from './bar.js';
import {block, unpacked} from './loader.js';
import {languages} from './words.js';
/** @import {TextEdit} from './scene_text.js' */
/** @import {Words} from './words.js' */

/**
 * @typedef {{type?: string, description?: string, enum?: unknown[], default?: unknown, items?: Schema, anyOf?: Schema[],
 *   properties?: Record<string, Schema>}} Schema
 * @typedef {{message: string, line: number, column: number}} Finding
 * @typedef {{text: string, state?: unknown}} KeptText the text, and what the editor needs to undo its changes after a reload
 */

/** What the schema says of a place in a scene. */
class SceneKeys {
  /** @param {Schema} schema */
  constructor(schema) {
    this.schema = schema;
  }

  /** The line of an offset, what of it stands before the offset, and the table in which it stands. @param {string} text @param {number} at */
  static place(text, at) {
    const before = text.slice(0, at);
    const begin = before.lastIndexOf('\n') + 1;
    const end = text.indexOf('\n', at);
    let table = '';
    for (const row of text.slice(0, begin).split('\n')) {
      const header = /^\s*\[\[?\s*([A-Za-z0-9_.-]+)\s*\]?\]/.exec(row);
      if (header) table = header[1] ?? '';
    }
    return {line: text.slice(begin, end < 0 ? text.length : end), typed: before.slice(begin), table};
  }

  /** The schema at a dotted path: of a table, of an item of an array, or of a key. @param {string} path @returns {Schema|undefined} */
  at(path) {
    /** @type {Schema|undefined} */
    let here = this.schema;
    for (const name of path.split('.').filter(Boolean)) {
      here = SceneKeys.table_of(here)?.properties?.[name];
      if (!here) return undefined;
    }
    return here;
  }

  /** The part of a schema that has keys. @param {Schema|undefined} schema @returns {Schema|undefined} */
  static table_of(schema) {
    if (!schema) return undefined;
    if (schema.properties) return schema;
    if (schema.items?.properties) return schema.items;
    return schema.anyOf?.map((s) => SceneKeys.table_of(s)).find(Boolean);
  }

  /** The names that a value may have. @param {Schema|undefined} schema @returns {unknown[]} */
  static names_of(schema) {
    if (!schema) return [];
    if (schema.enum) return schema.enum;
    if (schema.type === 'boolean') return [true, false];
    return [...(schema.items ? SceneKeys.names_of(schema.items) : []), ...(schema.anyOf ?? []).flatMap((s) => SceneKeys.names_of(s))];
  }

  /** What the key or table of this line means. @param {string} text @param {number} at @returns {{name: string, meaning: string}} */
  help(text, at) {
    const {line, table} = SceneKeys.place(text, at);
    const key = /^\s*([A-Za-z0-9_.-]+)\s*=/.exec(line)?.[1] ?? /^\s*([A-Za-z0-9_.-]+)\s*$/.exec(line)?.[1];
    const header = /^\s*\[\[?\s*([A-Za-z0-9_.-]+)/.exec(line)?.[1];
    const path = header ?? (key ? (table ? `${table}.${key}` : key) : table);
    const found = path ? this.at(path) : undefined;
    const keys = Object.keys(SceneKeys.table_of(found)?.properties ?? {});
    return {name: found ? path : '', meaning: found?.description ?? keys.join(', ')};
  }

  /**
   * What may stand at an offset in place of `word`, which is written there.
   * @param {string} text @param {number} at @param {boolean} asked by the viewer, also where nothing is typed
   * @returns {{word: string, offers: {label: string, meaning: string}[]}}
   */
  offers(text, at, asked) {
    const {typed, table} = SceneKeys.place(text, at);
    const value = /^\s*([A-Za-z0-9_.-]+)\s*=\s*(.*)$/.exec(typed);
    let word = typed.trimStart();
    /** @type {{label: string, meaning: string}[]} */
    let all = [];
    if (/^\s*#/.test(typed)) all = [];
    else if (value) {
      word = /["A-Za-z0-9_-]*$/.exec(value[2] ?? '')?.[0] ?? '';
      const schema = this.at(table ? `${table}.${value[1]}` : value[1] ?? '');
      all = SceneKeys.names_of(schema).map((name) => ({label: typeof name === 'string' ? JSON.stringify(name) : String(name), meaning: ''}));
    } else if (/^\s*\[/.test(typed)) {
      all = Object.entries(this.schema.properties ?? {}).filter(([, s]) => SceneKeys.table_of(s))
        .map(([name, s]) => ({label: s.type === 'array' ? `[[${name}]]` : `[${name}]`, meaning: s.description ?? ''}));
    } else {
      all = Object.entries(SceneKeys.table_of(this.at(table))?.properties ?? {})
        .map(([name, s]) => ({label: `${name} = `, meaning: s.description ?? ''}));
    }
    const bare = word.replace(/^["[]+/, '').toLowerCase();
    const offers = all.filter(({label}) => label !== word && label.replace(/^["[]+/, '').toLowerCase().startsWith(bare));
    return {word, offers: asked || bare !== '' ? offers : []};
  }
}

/** The offset of a line and column, both from 1; columns count characters. @param {string} text @param {number} line @param {number} column */
function offset_of(text, line, column) {
  const lines = text.split('\n');
  const k = Math.min(Math.max(1, line), lines.length) - 1;
  const before = lines.slice(0, k).reduce((sum, row) => sum + row.length + 1, 0);
  return before + [...(lines[k] ?? '')].slice(0, Math.max(0, column - 1)).join('').length;
}

/** Says what stands at the cursor. @param {SceneKeys} keys @param {string} text @param {number} at */
function show_help(keys, text, at) {
  const {name, meaning} = keys.help(text, at);
  const strong = document.createElement('b');
  strong.textContent = name;
  part('help').replaceChildren(strong, meaning ? ` ${meaning}` : '');
}

/** A text area. It has the methods of CodeEditor, and no completions. */
class PlainEditor {
  /** @param {SceneKeys} keys @param {() => void} changed @param {Words} words */
  constructor(keys, changed, words) {
    this.field = document.createElement('textarea');
    this.field.id = 'text';
    this.field.spellcheck = false;
    this.field.setAttribute('aria-label', words.of('text'));
    this.field.setAttribute('aria-describedby', 'help findings');
    part('sheet').replaceChildren(this.field);
    const help = () => show_help(keys, this.text, this.field.selectionStart);
    this.field.addEventListener('input', changed);
    for (const name of ['input', 'click', 'keyup']) this.field.addEventListener(name, help);
    // The keys of the figure are not for here.
    this.field.addEventListener('keydown', (event) => event.stopPropagation());
  }

  get text() {
    return this.field.value;
  }
  set text(text) {
    this.field.value = text;
    this.field.setSelectionRange(0, 0);
  }

  /** @returns {KeptText} */
  get kept() {
    return {text: this.text};
  }
  set kept(kept) {
    this.text = kept.text;
  }

  /** Changes the text in place of the viewer. @param {TextEdit} edit */
  replace({from, to, insert}) {
    const {selectionStart} = this.field;
    this.field.setRangeText(insert, from, to, selectionStart <= from ? 'preserve' : 'end');
  }

  /** @param {boolean} _is_held */
  hold(_is_held) {}

  /** @param {Finding[]} _findings */
  mark(_findings) {}

  /** @param {number} line @param {number} column */
  go(line, column) {
    const at = offset_of(this.text, line, column);
    this.field.focus();
    this.field.setSelectionRange(at, at);
  }
}

/** CodeMirror. */
class CodeEditor {
  /** @param {any} tools of page/text_editor/entry.js @param {SceneKeys} keys @param {() => void} changed @param {Words} words */
  constructor(tools, keys, changed, words) {
    this.tools = tools;
    const {EditorState, EditorView} = tools;
    /** @type {any[]} */
    this.extensions = [
      tools.lineNumbers(), tools.highlightActiveLineGutter(), tools.lintGutter(), tools.codeFolding(), tools.foldGutter(),
      tools.foldService.of((/** @type {any} */ state, /** @type {number} */ from) => CodeEditor.#fold(state, from)),
      tools.history(), tools.drawSelection(), tools.highlightActiveLine(), tools.highlightSelectionMatches(),
      tools.StreamLanguage.define(tools.toml), tools.syntaxHighlighting(tools.classHighlighter),
      tools.bracketMatching(), tools.closeBrackets(), tools.search({top: true}),
      tools.autocompletion({override: [(/** @type {any} */ context) => CodeEditor.#offer(keys, context)], icons: false}),
      tools.hoverTooltip((/** @type {any} */ view, /** @type {number} */ at) => CodeEditor.#explain(keys, view, at)),
      tools.keymap.of([...tools.closeBracketsKeymap, ...tools.searchKeymap, ...tools.historyKeymap, ...tools.foldKeymap, ...tools.completionKeymap,
        ...tools.defaultKeymap]),
      EditorView.lineWrapping,
      EditorView.contentAttributes.of({id: 'text', 'aria-label': words.of('text'), 'aria-describedby': 'help findings', autocapitalize: 'off', tabindex: '0'}),
      EditorState.phrases.of(Object.fromEntries(Object.entries(editor_phrases).map(([name, row]) => [name, row[languages.indexOf(words.code)]]))),
      EditorState.tabSize.of(4),
      EditorView.updateListener.of((/** @type {any} */ update) => {
        if (update.docChanged && !this.is_replacing) changed();
        if (update.docChanged || update.selectionSet) show_help(keys, this.text, update.state.selection.main.head);
      }),
    ];
    /** Whether a change is not the viewer's. */
    this.is_replacing = false;
    /** When the gesture that changes values began; 0: there is none. */
    this.held_ms = 0;
    part('sheet').replaceChildren();
    this.view = new EditorView({parent: part('sheet'), state: EditorState.create({extensions: this.extensions})});
    // The keys of the figure are not for here.
    this.view.dom.addEventListener('keydown', (/** @type {Event} */ event) => event.stopPropagation());
  }

  get text() {
    return this.view.state.doc.toString();
  }
  set text(text) {
    this.view.setState(this.tools.EditorState.create({doc: text, extensions: this.extensions}));
    this.view.scrollDOM.scrollTop = 0;
  }

  /** @returns {KeptText} */
  get kept() {
    return {text: this.text, state: this.view.state.toJSON({history: this.tools.historyField})};
  }
  set kept({text, state}) {
    this.text = text;
    if (!state) return;
    try {
      const kept = this.tools.EditorState.fromJSON(state, {extensions: this.extensions}, {history: this.tools.historyField});
      if (kept.doc.toString() === text) this.view.setState(kept);
    } catch {
      // Of another version of the editor: what can be undone is lost, the text is not.
    }
  }

  /** Changes the text in place of the viewer: one step of undo, or of the gesture that goes on. @param {TextEdit} edit */
  replace({from, to, insert}) {
    const {Transaction, isolateHistory} = this.tools;
    // Changes of the same time are one step of history.
    const annotations = this.held_ms > 0 ? [Transaction.time.of(this.held_ms)] : [isolateHistory.of('full')];
    this.is_replacing = true;
    this.view.dispatch({changes: {from, to, insert}, annotations});
    this.is_replacing = false;
  }

  /** Begins or ends a gesture whose changes are undone together. @param {boolean} is_held */
  hold(is_held) {
    if (is_held === this.held_ms > 0) return;
    this.view.dispatch({annotations: this.tools.isolateHistory.of('full')});
    this.held_ms = is_held ? Date.now() : 0;
  }

  /** Marks what these findings are about. @param {Finding[]} findings */
  mark(findings) {
    const {doc} = this.view.state;
    const marks = findings.filter((f) => f.line > 0).map(({message, line, column}) => {
      const {from, to, text} = doc.line(Math.min(line, doc.lines));
      const at = Math.min(Math.max(from, offset_of(this.text, line, column)), to);
      const word = /^([\w.-]+|"[^"]*"|\S)/.exec(text.slice(at - from))?.[0] ?? '';
      return {from: word ? at : from, to: word ? at + word.length : to, severity: 'error', message};
    });
    this.view.dispatch(this.tools.setDiagnostics(this.view.state, marks));
  }

  /** Puts the cursor on a line and column, both from 1. @param {number} line @param {number} column */
  go(line, column) {
    const anchor = offset_of(this.text, line, column);
    this.view.dispatch({selection: {anchor}, effects: this.tools.EditorView.scrollIntoView(anchor, {y: 'center'})});
    this.view.focus();
  }

  /** A table folds from the end of its header to its last line that is not empty. @param {any} state @param {number} from */
  static #fold(state, from) {
    const is_header = (/** @type {string} */ text) => /^\s*\[/.test(text);
    const {doc} = state;
    const header = doc.lineAt(from);
    if (!is_header(header.text)) return null;
    let last = header;
    for (let n = header.number + 1; n <= doc.lines && !is_header(doc.line(n).text); ++n)
      if (doc.line(n).text.trim() !== '') last = doc.line(n);
    return last === header ? null : {from: header.to, to: last.to};
  }

  /** @param {SceneKeys} keys @param {any} context */
  static #offer(keys, context) {
    const {word, offers} = keys.offers(context.state.doc.toString(), context.pos, context.explicit);
    if (offers.length === 0) return null;
    const apply = (/** @type {any} */ view, /** @type {any} */ offer, /** @type {number} */ from, /** @type {number} */ to) => {
      // A closing quote or bracket that stands there already is not written twice.
      const after = view.state.sliceDoc(to, to + 2);
      const n = ['"', ']]', ']'].find((end) => offer.label.endsWith(end) && after.startsWith(end))?.length ?? 0;
      view.dispatch({changes: {from, to: to + n, insert: offer.label}, selection: {anchor: from + offer.label.length}, userEvent: 'input.complete'});
    };
    return {from: context.pos - word.length, filter: false, options: offers.map(({label, meaning}) => ({label, apply, info: meaning || undefined}))};
  }

  /** @param {SceneKeys} keys @param {any} view @param {number} at */
  static #explain(keys, view, at) {
    const {from, to, text} = view.state.doc.lineAt(at);
    const key = /^\s*(\[*[A-Za-z0-9_.-]+\]*)/.exec(text);
    if (!key || at > from + key[0].length) return null;
    const {name, meaning} = keys.help(view.state.doc.toString(), to);
    if (!name || !meaning) return null;
    const dom = document.createElement('div');
    const strong = document.createElement('b');
    strong.textContent = name;
    dom.className = 'explained';
    dom.append(strong, ` ${meaning}`);
    return {pos: from, end: from + key[0].length, above: true, create: () => ({dom})};
  }
}

/** @param {Schema} schema @param {() => void} changed by the viewer @param {Words} words */
export function new_editor(schema, changed, words) {
  const keys = new SceneKeys(schema);
  if (block('text-editor')) {
    // The page's policy allows the script by its hash.
    const script = document.createElement('script');
    script.textContent = new TextDecoder().decode(unpacked('text-editor'));
    document.head.append(script);
  }
  const tools = /** @type {any} */ (globalThis).text_editor;
  return tools ? new CodeEditor(tools, keys, changed, words) : new PlainEditor(keys, changed, words);
}

/** What CodeMirror says, by its English words. @type {Record<string, string[]>} */
const editor_phrases = {
  'Find': ['Find', 'Suchen', 'Chercher', 'Buscar', 'Cerca', '検索'],
  'Replace': ['Replace', 'Ersetzen', 'Remplacer par', 'Reemplazar', 'Sostituisci', '置換'],
  'next': ['next', 'weiter', 'suivant', 'siguiente', 'successivo', '次へ'],
  'previous': ['previous', 'zurück', 'précédent', 'anterior', 'precedente', '前へ'],
  'all': ['all', 'alle', 'tout', 'todo', 'tutto', 'すべて'],
  'match case': ['match case', 'Groß/klein', 'casse', 'mayúsculas', 'maiuscole', '大文字と小文字を区別'],
  'regexp': ['regexp', 'Regex', 'regex', 'regex', 'regex', '正規表現'],
  'by word': ['by word', 'ganze Wörter', 'mot entier', 'palabra', 'parola', '単語単位'],
  'replace': ['replace', 'ersetzen', 'remplacer', 'reemplazar', 'sostituisci', '置換'],
  'replace all': ['replace all', 'alle ersetzen', 'tout remplacer', 'reemplazar todo', 'sostituisci tutto', 'すべて置換'],
  'close': ['close', 'schließen', 'fermer', 'cerrar', 'chiudi', '閉じる'],
  'Go to line': ['Go to line', 'Gehe zu Zeile', 'Aller à la ligne', 'Ir a la línea', 'Vai alla riga', '行へ移動'],
  'go': ['go', 'los', 'aller', 'ir', 'vai', '移動'],
  'Fold line': ['Fold line', 'Zeile einklappen', 'Replier la ligne', 'Plegar línea', 'Comprimi riga', '折りたたむ'],
  'Unfold line': ['Unfold line', 'Zeile ausklappen', 'Déplier la ligne', 'Desplegar línea', 'Espandi riga', '展開する'],
  'folded code': ['folded lines', 'eingeklappte Zeilen', 'lignes repliées', 'líneas plegadas', 'righe compresse', '折りたたまれた行'],
  'unfold': ['unfold', 'ausklappen', 'déplier', 'desplegar', 'espandi', '展開'],
  'Completions': ['Completions', 'Vorschläge', 'Propositions', 'Sugerencias', 'Suggerimenti', '候補'],
  'Diagnostics': ['Messages', 'Meldungen', 'Messages', 'Mensajes', 'Messaggi', 'メッセージ'],
  'No diagnostics': ['No messages', 'Keine Meldungen', 'Aucun message', 'Sin mensajes', 'Nessun messaggio', 'メッセージはありません'],
};
