// The workbench: examples, text of the scene, files, drafts, and what it saves.

import {input, part, save_as} from './bar.js';
import {Drafts} from './drafts.js';
import {new_editor} from './editor.js';
import {message_of} from './figure.js';
import {has_film_writer} from './film_file.js';
import {is_too_long, state_of} from './link.js';
import {packed_text, unpacked_text} from './link_text.js';
import {block, bytes_of_base64} from './loader.js';
import {made_scene, may_hold_scene} from './made_file.js';
import {Measure, painted} from './measure.js';
import {ZipWriter} from './png_frames.js';
import './pptx.js';
import {ProgramError} from './program.js';
import {as_toml, difference_of, edit_of, edited, removal_of, value_in} from './scene_text.js';
import {the_page} from './scripting.js';
import {Words, all_words, motion_said} from './words.js';
import {base64_of_bytes, files_of_zip, in_archive, table_among} from './zip_reader.js';
/** @import {ReadableFile} from './zip_reader.js' */
/** @import {Draft, Kept} from './drafts.js' */
/** @import {Finding} from './editor.js' */
/** @import {Choices} from './figure.js' */
/** @import {Page} from './page.js' */
/** @import {Program} from './program.js' */

/**
 * @typedef {{name: string, title: string, text: string, files: Record<string, string>, thumbnail: string}} GalleryScene
 * @typedef {{schema: string, scenes: GalleryScene[], starts: GalleryScene[], template: string, no_script: Record<string, string>}} WorkbenchData
 * @typedef {{kind: 'file'|'example'|'new', name: string, text: string}} SceneSource where a scene comes from: the name of its file, and its first text
 */

/** @type {Kept} */
const kept_whole = {text: true, lacks: []};
const write_after_ms = 250;
const most_rows = 20000;
/** Of a file that is read whole; of a larger one, a film, both ends hold its record. */
const most_read_bytes = 64e6;
/** Files of an archive that are asked for a scene. */
const most_made_files = 8;
/** As in workbench.css. */
const small_screen = matchMedia('(max-width: 760px)');

/** @type {Record<string, string[]>} */
const workbench_words = {
  new: ['New', 'Neu', 'Nouveau', 'Nuevo', 'Nuovo', '新規'],
  gallery: ['Examples', 'Beispiele', 'Exemples', 'Ejemplos', 'Esempi', '例'],
  open: ['Open …', 'Öffnen …', 'Ouvrir…', 'Abrir…', 'Apri…', '開く…'],
  save_scene: ['Save scene', 'Szene speichern', 'Enregistrer la scène', 'Guardar la escena', 'Salva la scena', 'シーンを保存'],
  export_page: ['Save page', 'Seite speichern', 'Enregistrer la page', 'Guardar la página', 'Salva la pagina', 'ページを保存'],
  export_csv: ['Save data (CSV)', 'Daten speichern (CSV)', 'Enregistrer les données (CSV)', 'Guardar los datos (CSV)', 'Salva i dati (CSV)', 'データを保存 (CSV)'],
  reading: ['Reading', 'Liest', 'Lecture de', 'Leyendo', 'Lettura di', '読み込み中:'],
  text: ['Text of the scene', 'Text der Szene', 'Texte de la scène', 'Texto de la escena', 'Testo della scena', 'シーンのテキスト'],
  tab_text: ['Text', 'Text', 'Texte', 'Texto', 'Testo', 'テキスト'],
  tabs: ['Figure or text', 'Bild oder Text', 'Figure ou texte', 'Figura o texto', 'Figura o testo', '図とテキスト'],
  search: ['Search', 'Suchen', 'Chercher', 'Buscar', 'Cerca', '検索'],
  search_none: ['No example has these words.', 'Kein Beispiel enthält diese Wörter.', 'Aucun exemple ne contient ces mots.', 'Ningún ejemplo contiene estas palabras.', 'Nessun esempio contiene queste parole.', 'この語を含む例はありません。'],
  look_dark: ['Dark desk', 'Dunkle Arbeitsfläche', 'Bureau sombre', 'Escritorio oscuro', 'Scrivania scura', '暗い作業画面'],
  look_light: ['Light desk', 'Helle Arbeitsfläche', 'Bureau clair', 'Escritorio claro', 'Scrivania chiara', '明るい作業画面'],
  drafts: ['Kept in this browser', 'In diesem Browser aufbewahrt', 'Conservé dans ce navigateur', 'Guardado en este navegador', 'Conservato in questo browser', 'このブラウザーに保存されたシーン'],
  draft_offer: ['This browser has kept your scene “{name}” of {time}.', 'Dieser Browser hat Ihre Szene „{name}“ von {time} aufbewahrt.', 'Ce navigateur a conservé votre scène « {name} » de {time}.', 'Este navegador ha guardado su escena «{name}» de {time}.', 'Questo browser ha conservato la Sua scena «{name}» delle {time}.', 'このブラウザーに {time} のシーン「{name}」が残っています。'],
  draft_take: ['Go on with it', 'Daran weiterarbeiten', 'Continuer', 'Continuar', 'Continua', '続ける'],
  draft_leave: ['Start anew', 'Neu beginnen', 'Recommencer', 'Empezar de nuevo', 'Ricomincia', '新しく始める'],
  link_damaged: ['The link holds no whole scene: it was cut off or changed. Ask for it again.', 'Der Link enthält keine ganze Szene: Er wurde abgeschnitten oder verändert. Erbitten Sie ihn noch einmal.', 'Le lien ne contient pas de scène entière : il a été coupé ou modifié. Redemandez-le.', 'El enlace no contiene una escena entera: se cortó o se cambió. Pídalo otra vez.', 'Il link non contiene una scena intera: è stato tagliato o modificato. Lo chieda di nuovo.', 'リンクが途中で切れたか変更されたため、シーンを読めません。もう一度リンクをもらってください。'],
  link_unknown: ['There is no example “{scene}” here.', 'Ein Beispiel „{scene}“ gibt es hier nicht.', 'Il n’y a pas d’exemple « {scene} » ici.', 'Aquí no hay ningún ejemplo «{scene}».', 'Qui non c’è un esempio «{scene}».', '例「{scene}」はありません。'],
  link_long: ['The scene is too long for a link; save it, and send the file.', 'Die Szene ist zu lang für einen Link; speichern Sie sie, und senden Sie die Datei.', 'La scène est trop longue pour un lien ; enregistrez-la et envoyez le fichier.', 'La escena es demasiado larga para un enlace; guárdela y envíe el archivo.', 'La scena è troppo lunga per un link: la salvi e invii il file.', 'シーンが長すぎてリンクにできません。保存してファイルを送ってください。'],
  link_files: ['A link cannot hold {files}; save the scene, and send the archive.', 'Ein Link kann {files} nicht enthalten; speichern Sie die Szene, und senden Sie das Archiv.', 'Un lien ne peut pas contenir {files} ; enregistrez la scène et envoyez l’archive.', 'Un enlace no puede contener {files}; guarde la escena y envíe el archivo.', 'Un link non può contenere {files}: salvi la scena e invii l’archivio.', 'リンクには {files} を含められません。シーンを保存してアーカイブを送ってください。'],
  qr: ['QR code', 'QR-Code', 'Code QR', 'Código QR', 'Codice QR', 'QRコード'],
  qr_is: ['A phone that is pointed at it opens this scene.', 'Ein Telefon, das darauf gerichtet wird, öffnet diese Szene.', 'Un téléphone pointé dessus ouvre cette scène.', 'Un teléfono que lo enfoque abre esta escena.', 'Un telefono puntato su di esso apre questa scena.', '電話のカメラを向けると、このシーンが開きます。'],
  qr_file: ['A phone cannot open a file of this computer. Open the workbench from an address that begins with https, and take its code.', 'Ein Telefon kann keine Datei dieses Computers öffnen. Öffnen Sie die Arbeitsfläche von einer Adresse, die mit https beginnt, und nehmen Sie deren Code.', 'Un téléphone ne peut pas ouvrir un fichier de cet ordinateur. Ouvrez l’atelier à une adresse qui commence par https, et prenez son code.', 'Un teléfono no puede abrir un archivo de este ordenador. Abra el taller desde una dirección que empiece por https y tome su código.', 'Un telefono non può aprire un file di questo computer. Apra il banco di lavoro da un indirizzo che comincia con https e prenda il suo codice.', '電話はこのコンピューターのファイルを開けません。https で始まるアドレスからこのページを開き、そのコードを使ってください。'],
  qr_long: ['The scene is too long for a QR code; copy its link, or save it.', 'Die Szene ist zu lang für einen QR-Code; kopieren Sie ihren Link, oder speichern Sie sie.', 'La scène est trop longue pour un code QR ; copiez son lien ou enregistrez-la.', 'La escena es demasiado larga para un código QR; copie su enlace o guárdela.', 'La scena è troppo lunga per un codice QR: copi il suo link o la salvi.', 'シーンが長すぎて QR コードにできません。リンクをコピーするか、保存してください。'],
  no_place: ['The text has no place for {key}; write it there.', 'Der Text hat keinen Platz für {key}; schreiben Sie es hinein.', 'Le texte n’a pas de place pour {key} ; écrivez-le.', 'El texto no tiene lugar para {key}; escríbalo.', 'Il testo non ha posto per {key}: lo scriva.', 'テキストに {key} を書き込めません。手で書いてください。'],
  draft_lacks: ['without {files}', 'ohne {files}', 'sans {files}', 'sin {files}', 'senza {files}', '{files} なし'],
  unkept_text: ['This browser cannot keep this text: it is too long, or the browser’s store is full. Save the scene before you leave the page.',
    'Dieser Browser kann diesen Text nicht aufbewahren: Er ist zu lang, oder der Speicher des Browsers ist voll. Speichern Sie die Szene, bevor Sie die Seite verlassen.',
    'Ce navigateur ne peut pas conserver ce texte : il est trop long, ou la mémoire du navigateur est pleine. Enregistrez la scène avant de quitter la page.',
    'Este navegador no puede guardar este texto: es demasiado largo, o el almacén del navegador está lleno. Guarde la escena antes de salir de la página.',
    'Questo browser non può conservare questo testo: è troppo lungo, o la memoria del browser è piena. Salvi la scena prima di lasciare la pagina.',
    'このテキストは長すぎるか、ブラウザーの保存領域がいっぱいのため、保存できません。ページを離れる前にシーンを保存してください。'],
  unkept_files: ['This browser keeps the text, but has no room for {files}. Save the scene before you leave the page, or remove old scenes under New.',
    'Dieser Browser bewahrt den Text auf, hat aber keinen Platz für {files}. Speichern Sie die Szene, bevor Sie die Seite verlassen, oder entfernen Sie unter Neu alte Szenen.',
    'Ce navigateur conserve le texte, mais n’a pas la place pour {files}. Enregistrez la scène avant de quitter la page, ou supprimez d’anciennes scènes sous Nouveau.',
    'Este navegador guarda el texto, pero no tiene sitio para {files}. Guarde la escena antes de salir de la página, o elimine escenas antiguas en Nuevo.',
    'Questo browser conserva il testo, ma non ha posto per {files}. Salvi la scena prima di lasciare la pagina, o elimini vecchie scene sotto Nuovo.',
    'テキストは保存されていますが、{files} を保存する空きがありません。ページを離れる前にシーンを保存するか、「新規」で古いシーンを削除してください。'],
  draft_remove: ['Remove', 'Entfernen', 'Supprimer', 'Eliminar', 'Elimina', '削除'],
  file_here: ['{file} is at hand, but the scene does not name it.', '{file} liegt bereit, aber die Szene nennt die Datei nicht.', '{file} est là, mais la scène ne le nomme pas.', '{file} está disponible, pero la escena no lo nombra.', '{file} è disponibile, ma la scena non lo nomina.', '{file} を読み込みましたが、シーンには名前がありません。'],
  file_begin: ['Begin a scene with it', 'Eine Szene damit beginnen', 'Commencer une scène avec ce fichier', 'Empezar una escena con él', 'Inizia una scena con esso', 'これでシーンを始める'],
  made_none: ['{file} holds no scene: poinsot did not make it, or another program removed its record.', '{file} enthält keine Szene: poinsot hat die Datei nicht gemacht, oder ein anderes Programm hat ihre Angaben entfernt.', '{file} ne contient pas de scène : poinsot ne l’a pas fait, ou un autre programme a retiré ses données.', '{file} no contiene ninguna escena: poinsot no lo hizo, u otro programa quitó sus datos.', '{file} non contiene una scena: non è di poinsot, o un altro programma ha tolto i suoi dati.', '{file} にはシーンがありません。poinsot が作ったものでないか、別のプログラムが記録を消しました。'],
  start_moments: ['Moments of inertia', 'Trägheitsmomente', 'Moments d’inertie', 'Momentos de inercia', 'Momenti d’inerzia', '慣性モーメント'],
  start_moments_is: ['A body by its three principal moments', 'Ein Körper durch seine drei Hauptträgheitsmomente', 'Un corps par ses trois moments principaux', 'Un cuerpo por sus tres momentos principales', 'Un corpo dai suoi tre momenti principali', '三つの主慣性モーメントで決まる物体'],
  start_shape: ['Shape', 'Form', 'Forme', 'Forma', 'Forma', '形'],
  start_shape_is: ['A box, ellipsoid, cylinder …: here a book that is thrown', 'Quader, Ellipsoid, Zylinder …: hier ein geworfenes Buch', 'Un pavé, un ellipsoïde, un cylindre… : ici un livre lancé', 'Un prisma, un elipsoide, un cilindro…: aquí un libro lanzado', 'Un parallelepipedo, un ellissoide, un cilindro…: qui un libro lanciato', '直方体、楕円体、円柱など。ここでは投げた本'],
  start_mesh: ['Mesh', 'Netz', 'Maillage', 'Malla', 'Mesh', 'メッシュ'],
  start_mesh_is: ['A body of any shape, from a file (.obj, .stl)', 'Ein Körper beliebiger Form, aus einer Datei (.obj, .stl)', 'Un corps de forme quelconque, d’un fichier (.obj, .stl)', 'Un cuerpo de cualquier forma, de un archivo (.obj, .stl)', 'Un corpo di forma qualsiasi, da un file (.obj, .stl)', 'ファイル (.obj, .stl) による任意の形の物体'],
  start_top: ['Heavy top', 'Schwerer Kreisel', 'Toupie pesante', 'Peonza pesada', 'Trottola pesante', '重いこま'],
  start_top_is: ['A symmetric top that its weight turns', 'Ein symmetrischer Kreisel unter seinem Gewicht', 'Une toupie symétrique soumise à son poids', 'Una peonza simétrica bajo su peso', 'Una trottola simmetrica soggetta al suo peso', '重さで回る対称こま'],
  start_measured: ['Measured', 'Gemessen', 'Mesuré', 'Medido', 'Misurato', '測定値'],
  start_measured_is: ['A gyroscope’s table beside the exact motion', 'Die Tabelle eines Gyroskops neben der exakten Bewegung', 'Le tableau d’un gyroscope à côté du mouvement exact', 'La tabla de un giroscopio junto al movimiento exacto', 'La tabella di un giroscopio accanto al moto esatto', 'ジャイロスコープの表と厳密な運動'],
};
Object.assign(all_words, workbench_words);

/** JSON for a script element: it cannot close the element. @param {unknown} value */
function script_json(value) {
  return JSON.stringify(value).replace(/[<>&\u2028\u2029]/g, (c) => `\\u${c.charCodeAt(0).toString(16).padStart(4, '0')}`);
}

/** @param {string} text */
function escaped(text) {
  return text.replace(/[&<>"']/g, (c) => `&#${c.charCodeAt(0)};`);
}

/** The title of a scene, as it stands in its text. @param {string} text */
function title_in(text) {
  const before_tables = text.split(/^\s*\[/m)[0] ?? '';
  return /^\s*title\s*=\s*(?:"((?:[^"\\]|\\.)*)"|'([^']*)')/m.exec(before_tables)?.slice(1).find((title) => title !== undefined) ?? '';
}

/** A text after changes of its values; null: it has no place for one of them. @param {string} text @param {Map<string, string|null>} values */
function edited_by(text, values) {
  for (const [key, value] of values) {
    if (value === null && value_in(text, key) === null) continue;
    const edit = value === null ? removal_of(text, key) : edit_of(text, key, as_toml(value));
    if (!edit) return null;
    text = edited(text, edit);
  }
  return text;
}

/** What makes QR codes; null: it was not there when the workbench was built. @returns {any} */
function qr_maker() {
  return /** @type {any} */ (globalThis).text_editor?.qrcode ?? null;
}

/** The modules of a text's QR code as a path in SVG, with the margin of four that readers need; null: it is too long. @param {string} text */
function qr_path(text) {
  const code = qr_maker()(0, 'L');
  try {
    code.addData(text, 'Byte');
    code.make();
  } catch {
    return null;
  }
  const n = code.getModuleCount();
  let path = '';
  for (let row = 0; row < n; ++row) for (let column = 0; column < n; ++column) if (code.isDark(row, column)) path += `M${column + 4} ${row + 4}h1v1h-1z`;
  return {path, size: n + 8};
}

/** A title as the name of a file, without its suffix. @param {string} title */
function file_name_of(title) {
  return title.replace(/\$[^$]*\$/g, ' ').normalize('NFKD').replace(/[\u0300-\u036f]/g, '').normalize('NFC').toLowerCase()
    .replace(/[^\p{L}\p{N}]+/gu, '_').slice(0, 60).replace(/^_+|_+$/g, '');
}

/** A file's name without folder and suffix. @param {string} name */
function stem_of(name) {
  return name.replace(/^.*\//, '').replace(/\.[^.]*$/, '');
}

/** The first and last bytes of a large file. @param {File} file */
async function ends_of(file) {
  return new Uint8Array(await new Blob([file.slice(0, most_read_bytes / 2), file.slice(-most_read_bytes / 2)]).arrayBuffer());
}

class Workbench {
  /** @param {Page} page */
  constructor(page) {
    this.page = page;
    /** @type {WorkbenchData} */
    this.data = JSON.parse(block('workbench-data'));
    this.words = new Words(navigator.language.slice(0, 2));
    page.speak(this.words.code);
    this.timer = 0;
    /** Choices that the next accepted text gets. @type {Partial<Choices>} */
    this.changes = {};
    /** Files dropped or of the gallery, as base64. @type {Record<string, string>} */
    this.files = {...page.data.files};
    /** Files at hand that no scene has named yet. @type {Map<string, ReadableFile>} */
    this.unread = new Map();
    /** The files that a program has. @type {WeakMap<Program, Map<string, string>>} */
    this.given = new WeakMap();
    this.drafts = new Drafts();
    /** @type {SceneSource} */
    this.source = {kind: 'example', name: page.data.name, text: page.data.text};
    /** Whether the text is the viewer's work, and what of it the browser keeps. */
    this.is_edited = false;
    /** @type {Kept} */
    this.kept = kept_whole;
    this.editor = new_editor(JSON.parse(this.data.schema), () => this.#soon(), this.words);
    this.editor.text = page.data.text;
    this.#name();
    this.#wire();
    this.#show_cards();
    this.#show_tab('figure');
    page.on_loaded = () => this.#find();
    this.measure = new Measure(this.words, (name, text, files) => this.open({kind: 'file', name, text}, files, true));
    // A way in for those who come to throw.
    if (/[#&]measure$/.test(location.hash)) this.measure.show(true);
    /** Whether the program has refused the text that it was given last. */
    this.is_refused = false;
    /** The text that was packed last for a link; `packed` is null if it is too long. @type {{text: string, packed: string|null}} */
    this.link_text = {text: '', packed: null};
    page.store = {
      value: (key) => value_in(this.editor.text, key),
      write: (values) => this.#write_values(values),
      open_link: (choices) => void this.#open_link(choices),
      link: () => this.#link(),
      link_fault: () => this.#link_fault(),
    };
    void this.#open_link(page.figure.choices).then(() => {
      this.#offer_draft();
      // A text that is refused at the start is refused at its line.
      return page.start();
    }).then(() => page.figure.data?.text !== this.editor.text && this.#write(), () => {});
  }

  /** The name of what is saved, without its suffix: that of the scene's file or, for a new scene, its title. */
  get name() {
    const {kind, name, text} = this.source;
    const title = title_in(this.editor.text);
    if (kind === 'file' || (kind === 'example' && title === title_in(text))) return name;
    return file_name_of(title) || 'scene';
  }

  /** The files that the text names. */
  get named_files() {
    const {text} = this.editor;
    return Object.fromEntries(Object.entries(this.files).filter(([name]) => text.includes(name)));
  }

  // ── Links ───────────────────────────────────────────────────────────────────────────────

  /** Opens the scene of the address, an example by its name or a text of its own, with its values. @param {Choices} choices of the address */
  async #open_link({shown, names, theme}) {
    const {page} = this;
    // The text holds all values.
    page.figure.choices = {...page.figure.choices, values: new Map()};
    const state = state_of(location.hash);
    const {values} = state;
    const example = this.data.scenes.find(({name}) => name === state.scene);
    const text = state.text ? await unpacked_text(state.text) : null;
    const fault = is_too_long(location.hash) || (state.text && text === null) ? 'link_damaged' : state.scene && !example && !state.text ? 'link_unknown' : '';
    if (fault) {
      void page.start().then(() => page.show_message(new Error(this.words.of(fault).replace('{scene}', () => state.scene))), () => {});
      return;
    }
    /** @type {SceneSource|null} */
    const source = text !== null ? {kind: 'new', name: '', text} : example ? {kind: 'example', name: example.name, text: example.text} : null;
    const is_other = source && (source.text !== this.editor.text || source.kind !== this.source.kind);
    if (source && is_other) {
      this.open(source, example && text === null ? example.files : this.#known_files(source.text));
      // Instant and views once more, for the scene that they belong to.
      page.address.read();
    }
    const changed = edited_by(this.editor.text, values);
    if (changed === null || (!is_other && changed === this.editor.text && !page.figure.program)) return;
    if (changed !== this.editor.text) {
      this.editor.text = changed;
      this.is_edited = true;
    }
    this.#write({shown, names, theme});
  }

  /** The files of examples and starting points that a text names. @param {string} text @returns {Record<string, string>} */
  #known_files(text) {
    const all = Object.assign({}, ...[...this.data.scenes, ...this.data.starts].map(({files}) => files));
    return Object.fromEntries(Object.entries(all).filter(([name]) => text.includes(name)));
  }

  /** The scene of a link to this one: '' for both is not known yet, or is too long. */
  #link() {
    const {text} = this.editor;
    if (this.source.kind === 'example' && text === this.source.text) return {scene: this.source.name, text: ''};
    return {scene: '', text: this.link_text.text === text ? this.link_text.packed ?? '' : ''};
  }

  /** Packs the text for links, and puts it into the address. */
  async #pack_link() {
    const {text} = this.editor;
    if (text === this.link_text.text) return;
    const packed = await packed_text(text);
    if (text !== this.editor.text) return;
    this.link_text = {text, packed};
    if (this.page.figure.program && !this.page.figure.film.playing) this.page.address.keep();
  }

  /** What a link cannot hold of this scene; '' if it holds all. */
  async #link_fault() {
    const {scene} = this.#link();
    await this.#pack_link();
    const known = this.#known_files(this.editor.text);
    const lacks = Object.keys(this.named_files).filter((name) => known[name] !== this.files[name]);
    if (lacks.length > 0) return this.words.of('link_files').replace('{files}', () => lacks.join(', '));
    return !scene && this.link_text.packed === null ? this.words.of('link_long') : '';
  }

  /** Shows the link to the scene as a QR code, for the phones of a class. */
  async #show_qr() {
    const fault = await this.#link_fault();
    const link = this.page.address.link();
    const code = fault || !link.startsWith('http') ? null : qr_path(link);
    const svg = part('qr-code');
    svg.toggleAttribute('hidden', !code);
    part('qr-text').textContent = fault || this.words.of(!link.startsWith('http') ? 'qr_file' : code ? 'qr_is' : 'qr_long');
    if (code) {
      svg.setAttribute('viewBox', `0 0 ${code.size} ${code.size}`);
      svg.querySelector('rect')?.setAttribute('width', String(code.size));
      svg.querySelector('rect')?.setAttribute('height', String(code.size));
      svg.querySelector('path')?.setAttribute('d', code.path);
    }
    /** @type {HTMLDialogElement} */ (part('qr')).showModal();
  }

  // ── Values ──────────────────────────────────────────────────────────────────────────────

  /** Writes values into the text; throws the program's refusal, after which the text is as it was. @param {Map<string, string|null>} values */
  #write_values(values) {
    const {page, editor} = this;
    // What was typed comes first.
    if (this.timer) this.#write();
    const before = editor.text;
    const text = edited_by(before, values);
    if (text === null) throw new Error(this.words.of('no_place').replace('{key}', () => [...values.keys()].join(', ')));
    if (text === before) return;
    const is_accepted = page.data.text === before && page.figure.program !== null;
    if (is_accepted) {
      const data = {...page.data, text};
      page.figure.reload({}, data);
      page.data = data;
    }
    editor.replace(difference_of(before, text));
    this.is_edited = true;
    this.#soon();
  }

  #name() {
    const {words} = this;
    for (const [id, word] of [['new-open', 'new'], ['gallery-open', 'gallery'], ['file-open', 'open'], ['file-save', 'save_scene'], ['export-page', 'export_page'],
      ['export-csv', 'export_csv'], ['qr-open', 'qr'], ['film-open', 'film_section'], ['tab-text', 'tab_text'], ['tab-figure', 'figure'], ['offer-take', 'draft_take'], ['offer-leave', 'draft_leave'],
      ['drafts-head', 'drafts'], ['gallery-none', 'search_none']]) part(/** @type {string} */ (id)).textContent = words.of(/** @type {string} */ (word));
    for (const [id, word] of [['writing', 'text'], ['tabs', 'tabs'], ['gallery-search', 'search'], ['new', 'new'], ['gallery', 'gallery'], ['qr', 'qr'], ['qr-code', 'qr']])
      part(/** @type {string} */ (id)).setAttribute('aria-label', words.of(/** @type {string} */ (word)));
    input('gallery-search').placeholder = words.of('search');
    for (const [id, word] of [['new', 'new'], ['gallery', 'gallery'], ['qr', 'qr']]) {
      const heading = part(/** @type {string} */ (id)).querySelector('h2');
      if (heading) heading.textContent = words.of(/** @type {string} */ (word));
    }
    for (const button of document.querySelectorAll('.dialog-close')) button.setAttribute('aria-label', words.of('close'));
    // What the motion is, in words, under the figure.
    const motion = document.createElement('p');
    motion.id = 'motion-words';
    part('bar').after(motion);
    // The options leave room for it.
    new ResizeObserver(() => document.documentElement.style.setProperty('--below', `${motion.offsetHeight}px`)).observe(motion);
    this.#name_look();
  }

  #wire() {
    for (const id of ['new', 'gallery']) {
      const dialog = /** @type {HTMLDialogElement} */ (part(id));
      part(`${id}-open`).addEventListener('click', () => {
        this.#keep();
        this.#show_drafts();
        dialog.showModal();
      });
      // The keys of the figure are not for here.
      dialog.addEventListener('keydown', (event) => event.stopPropagation());
    }
    part('qr-open').hidden = !qr_maker();
    part('qr-open').addEventListener('click', () => void this.#show_qr());
    part('qr').addEventListener('keydown', (event) => event.stopPropagation());
    part('file-open').addEventListener('click', () => input('file').click());
    input('file').addEventListener('change', () => {
      void this.#take([...(input('file').files ?? [])]);
      input('file').value = '';
    });
    part('file-save').addEventListener('click', () => void this.#save_scene());
    part('film-open').hidden = !has_film_writer();
    part('film-open').addEventListener('click', () => {
      this.#show_tab('figure');
      this.page.options.open(true);
      part('film-kind').focus({preventScroll: true});
      part('section-film').scrollIntoView();
    });
    part('export-csv').addEventListener('click', () => save_as(new Blob([this.csv()], {type: 'text/csv'}), `${this.name}.csv`));
    part('export-page').addEventListener('click', () => void this.page_of_scene().then(
      (text) => save_as(new Blob([text], {type: 'text/html'}), `${this.name}.html`), (error) => this.#find(error)));
    input('gallery-search').addEventListener('input', () => this.#search(input('gallery-search').value));
    part('look').addEventListener('click', () => this.#set_look(this.#is_dark ? 'light' : 'dark'));
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.#name_look());
    small_screen.addEventListener('change', () => this.#name_landmark());
    for (const tab of ['text', 'figure']) {
      part(`tab-${tab}`).addEventListener('click', () => this.#show_tab(tab));
      part(`tab-${tab}`).addEventListener('keydown', (event) => {
        event.stopPropagation();
        if (event.key !== 'ArrowLeft' && event.key !== 'ArrowRight') return;
        const other = tab === 'text' ? 'figure' : 'text';
        this.#show_tab(other);
        part(`tab-${other}`).focus();
      });
    }
    // A value that is dragged is one step of undo: until the last frame of the drag.
    document.addEventListener('pointerdown', (event) => {
      if (event.target instanceof Node && !part('writing').contains(event.target)) this.editor.hold(true);
    }, {capture: true});
    for (const name of ['pointerup', 'pointercancel'])
      document.addEventListener(name, () => requestAnimationFrame(() => requestAnimationFrame(() => this.editor.hold(false))), {capture: true});
    // Before the editor, which keeps its keys for itself.
    document.addEventListener('keydown', (event) => {
      if (!(event.ctrlKey || event.metaKey) || event.shiftKey || event.altKey || event.key.toLowerCase() !== 's') return;
      event.preventDefault();
      void this.#save_scene();
    }, {capture: true});
    document.addEventListener('dragover', (event) => {
      event.preventDefault();
      document.body.classList.add('dropping');
    });
    document.addEventListener('dragleave', () => document.body.classList.remove('dropping'));
    document.addEventListener('drop', (event) => {
      event.preventDefault();
      document.body.classList.remove('dropping');
      void this.#take([...(event.dataTransfer?.files ?? [])]);
    });
    document.addEventListener('visibilitychange', () => this.#keep());
    window.addEventListener('pagehide', () => this.#keep());
    window.addEventListener('beforeunload', (event) => {
      if (!this.#keep()) event.preventDefault();
    });
  }

  // ── Light and dark, tabs ────────────────────────────────────────────────────────────────

  get #is_dark() {
    return document.documentElement.dataset['desk'] === 'dark';
  }

  /** Takes the colours that were chosen, or those of the system. */
  #name_look() {
    const system = matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light';
    let chosen = null;
    try {
      chosen = window.localStorage.getItem('poinsot-look');
    } catch {
      // The browser keeps nothing.
    }
    this.#show_look(chosen === 'dark' || chosen === 'light' ? chosen : system);
  }

  /** @param {string} look */
  #show_look(look) {
    document.documentElement.dataset['desk'] = look;
    const word = this.words.of(look === 'dark' ? 'look_light' : 'look_dark');
    part('look').setAttribute('aria-label', word);
    part('look').title = word;
  }

  /** @param {string} look */
  #set_look(look) {
    try {
      window.localStorage.setItem('poinsot-look', look);
    } catch {
      // It lasts until the page is left.
    }
    this.#show_look(look);
  }

  /** On a small screen, one of both is seen. @param {string} shown */
  #show_tab(shown) {
    document.body.classList.toggle('shows-text', shown === 'text');
    for (const tab of ['text', 'figure']) {
      part(`tab-${tab}`).setAttribute('aria-selected', String(tab === shown));
      part(`tab-${tab}`).tabIndex = tab === shown ? 0 : -1;
    }
    this.#name_landmark();
  }

  /** On a small screen the text is the main part of the page while the figure is hidden. */
  #name_landmark() {
    const is_main = small_screen.matches && document.body.classList.contains('shows-text');
    part('writing').setAttribute('role', is_main ? 'main' : 'region');
  }

  // ── Examples, starting points ───────────────────────────────────────────────────────────

  #show_cards() {
    const card = (/** @type {GalleryScene} */ scene, /** @type {'example'|'new'} */ kind, /** @type {string} */ name, /** @type {string} */ meaning) => {
      const button = document.createElement('button');
      const picture = document.createElement('img');
      const title = document.createElement('span');
      button.type = 'button';
      button.dataset['words'] = `${scene.name} ${scene.title} ${scene.text}`.toLowerCase();
      picture.src = scene.thumbnail;
      picture.alt = '';
      picture.loading = 'lazy';
      title.textContent = name;
      button.append(picture, title);
      if (meaning) {
        const small = document.createElement('small');
        small.textContent = meaning;
        button.append(small);
      }
      button.addEventListener('click', () => {
        button.closest('dialog')?.close();
        this.open({kind, name: scene.name, text: scene.text}, scene.files);
      });
      return button;
    };
    part('scenes').replaceChildren(...this.data.scenes.map((scene) => card(scene, 'example', scene.title, '')));
    const order = ['moments', 'shape', 'mesh', 'top', 'measured'];
    const starts = [...this.data.starts].sort((a, b) => order.indexOf(a.name) - order.indexOf(b.name));
    part('starts').replaceChildren(...starts.map((scene) =>
      card(scene, 'new', this.words.of(`start_${scene.name}`), this.words.of(`start_${scene.name}_is`))));
    this.#search('');
  }

  /** Shows the examples in whose name, title or text all these words are. @param {string} query */
  #search(query) {
    const wanted = query.toLowerCase().split(/\s+/);
    let n = 0;
    for (const button of /** @type {NodeListOf<HTMLElement>} */ (part('scenes').querySelectorAll('button'))) {
      button.hidden = !wanted.every((word) => button.dataset['words']?.includes(word));
      if (!button.hidden) ++n;
    }
    part('gallery-none').hidden = n > 0;
  }

  // ── Drafts ──────────────────────────────────────────────────────────────────────────────

  /** Keeps the scene in the browser if it is the viewer's work; false: a part of it would be lost with the page. */
  #keep() {
    if (this.is_edited) this.kept = this.drafts.keep({name: this.name, source: this.source, kept: this.editor.kept, files: this.named_files});
    this.#show_unkept();
    return this.kept.text && this.kept.lacks.length === 0;
  }

  /** Says what the browser does not keep. */
  #show_unkept() {
    const {text, lacks} = this.kept;
    const said = !text ? this.words.of('unkept_text') : lacks.length > 0 ? this.words.of('unkept_files').replace('{files}', () => lacks.join(', ')) : '';
    const before = part('findings').querySelector('.unkept');
    if (said === (before?.textContent ?? '')) return;
    before?.remove();
    if (!said) return;
    const row = document.createElement('p');
    row.className = 'unkept';
    row.textContent = said;
    part('findings').append(row);
  }

  /** A time of day, with its date if it was not today. @param {number} at_ms */
  #time(at_ms) {
    const at = new Date(at_ms);
    const time = at.toLocaleTimeString(this.words.code, {hour: '2-digit', minute: '2-digit'});
    return at.toDateString() === new Date().toDateString() ? time : `${at.toLocaleDateString(this.words.code, {day: 'numeric', month: 'short'})}, ${time}`;
  }

  /** Offers the latest draft. */
  #offer_draft() {
    const draft = this.drafts.list()[0];
    if (!draft) return;
    // The link of a reload holds it.
    if (draft.kept.text === this.editor.text) {
      this.drafts.go_on(draft);
      this.source = draft.source;
      this.is_edited = true;
      this.files = {...this.files, ...draft.files};
      this.editor.kept = draft.kept;
      this.#write();
      return;
    }
    part('offer-text').textContent = this.words.of('draft_offer').replace('{name}', () => title_in(draft.kept.text) || draft.name)
      .replace('{time}', this.#time(draft.at_ms));
    part('offer').hidden = false;
    document.body.classList.add('offers');
    part('offer-take').addEventListener('click', () => this.open(draft.source, draft.files, true, draft));
    part('offer-leave').addEventListener('click', () => this.#close_offer());
  }

  #close_offer() {
    part('offer').hidden = true;
    document.body.classList.remove('offers');
  }

  #show_drafts() {
    const drafts = this.drafts.list();
    part('drafts-head').hidden = drafts.length === 0;
    part('drafts').replaceChildren(...drafts.map((draft) => {
      const row = document.createElement('li');
      const [take, remove] = [document.createElement('button'), document.createElement('button')];
      const title = title_in(draft.kept.text) || draft.name;
      const time = document.createElement('small');
      const lacks = draft.lacks?.length ? `, ${this.words.of('draft_lacks').replace('{files}', () => draft.lacks?.join(', ') ?? '')}` : '';
      time.textContent = this.#time(draft.at_ms) + lacks;
      take.type = remove.type = 'button';
      take.append(title, ' ', time);
      take.addEventListener('click', () => {
        /** @type {HTMLDialogElement} */ (part('new')).close();
        this.open(draft.source, draft.files, true, draft);
      });
      remove.textContent = this.words.of('draft_remove');
      remove.setAttribute('aria-label', `${this.words.of('draft_remove')}: ${title}, ${time.textContent}`);
      remove.className = 'plain';
      remove.addEventListener('click', () => {
        this.drafts.remove(draft.id);
        this.#show_drafts();
      });
      row.append(take, remove);
      return row;
    }));
  }

  // ── Scenes and files ────────────────────────────────────────────────────────────────────

  /**
   * Opens a scene; the one before stays a draft.
   * @param {SceneSource} source @param {Record<string, string>} files @param {boolean} [is_edited] whether it is worth keeping
   * @param {Draft|null} [draft] that goes on
   */
  open(source, files, is_edited = false, draft = null) {
    window.clearTimeout(this.timer);
    this.#keep();
    if (draft) this.drafts.go_on(draft);
    else this.drafts.begin();
    this.#close_offer();
    this.source = source;
    this.is_edited = is_edited;
    this.kept = kept_whole;
    if (draft) this.editor.kept = draft.kept;
    else this.editor.text = source.text;
    this.files = {...this.files, ...files};
    this.page.views.reset();
    this.page.figure.film.seek(0);
    this.page.figure.film.pause();
    this.page.figure.film.untouched = true;
    this.#show_tab('figure');
    this.#write({values: new Map(), shown: null});
    this.#keep();
  }

  /** Opens scenes, keeps the files that scenes name, and measures tables that the scene does not name. @param {File[]} dropped */
  async #take(dropped) {
    if (dropped.length === 0) return;
    try {
      /** @type {ReadableFile[]} */
      const files = [];
      await this.#show_reading(dropped.map((file) => file.name));
      for (const file of dropped) {
        const read = async () => new Uint8Array(await file.arrayBuffer());
        if (!/\.(zip|pptx)$/i.test(file.name)) files.push({name: file.name, read: file.size > most_read_bytes ? () => ends_of(file) : read});
        else {
          const bytes = await read();
          const is_presentation = /\.pptx$/i.test(file.name);
          for (const one of await in_archive(file.name, () => files_of_zip(bytes)))
            if (!is_presentation || one.name.startsWith('ppt/media/')) files.push({name: one.name, read: () => in_archive(file.name, one.read)});
        }
      }
      const scene = files.find(({name}) => name.toLowerCase().endsWith('.toml'));
      const table = table_among(files);
      if (table && !scene && (this.measure.is_open || !this.editor.text.includes(table.name))) {
        this.#find();
        await this.measure.take(table.name, await table.read());
        return;
      }
      if (!scene && !table && (await this.#take_made(files))) return;
      const text = scene ? new TextDecoder().decode(await scene.read()) : this.editor.text;
      for (const file of files) {
        // The new file takes the place of one of the same name.
        if (file !== scene) this.unread.set(file.name, file);
      }
      const taken = await this.#read_named(text);
      if (scene) this.open({kind: 'file', name: stem_of(scene.name), text}, taken);
      else {
        this.files = {...this.files, ...taken};
        this.#write();
        this.#keep();
        this.#show_unnamed(files.map(({name}) => name).filter((name) => !text.includes(name)));
      }
    } catch (error) {
      this.#find(error);
    }
  }

  /** Opens the scene of a picture, film or page that poinsot made, and that the text does not name; false: there is none. @param {ReadableFile[]} files */
  async #take_made(files) {
    const names = files.filter(({name}) => may_hold_scene(name) && !this.editor.text.includes(name)).slice(0, most_made_files);
    for (const file of names) {
      const made = made_scene(await file.read());
      if (!made) continue;
      const text = edited_by(made.text, new Map(made.overrides.map((pair) => [pair.slice(0, pair.indexOf('=')), pair.slice(pair.indexOf('=') + 1)])));
      if (text === null) throw new Error(this.words.of('no_place').replace('{key}', () => made.overrides.join(', ')));
      this.open({kind: 'file', name: made.name || stem_of(file.name), text}, {...this.#known_files(text), ...made.files}, true);
      const {figure} = this.page;
      if (made.time_s !== null && figure.program && !this.is_refused) {
        figure.film.seek(figure.film_second_of(made.time_s));
        this.page.changed();
      }
      return true;
    }
    const other = names.find(({name}) => !/\.png$/i.test(name));
    if (!other) return false;
    throw new Error(this.words.of('made_none').replace('{file}', () => other.name));
  }

  /** Reads the files at hand that a text names and that were not read before, as base64. @param {string} text */
  async #read_named(text) {
    /** @type {Record<string, string>} */
    const taken = {};
    for (const [name, file] of this.unread) {
      if (!text.includes(name)) continue;
      this.unread.delete(name);
      taken[name] = base64_of_bytes(await file.read());
    }
    return taken;
  }

  /** Says which files the program reads, and waits until that is painted: a large mesh takes seconds. @param {string[]} names */
  async #show_reading(names) {
    const row = document.createElement('p');
    row.textContent = `${this.words.of('reading')} ${names.join(', ')} …`;
    part('findings').replaceChildren(row);
    await painted();
  }

  /** Says of files that the scene does not name them; a mesh may begin a scene. @param {string[]} names */
  #show_unnamed(names) {
    const start = this.data.starts.find(({name}) => name === 'mesh');
    for (const name of names) {
      const row = document.createElement('p');
      row.className = 'unnamed';
      row.textContent = this.words.of('file_here').replace('{file}', () => name);
      if (start && /\.(obj|stl)$/i.test(name)) {
        const button = document.createElement('button');
        button.type = 'button';
        button.className = 'plain';
        button.textContent = this.words.of('file_begin');
        const text = start.text.replace('"bracket.obj"', () => JSON.stringify(name)).replace('"My mesh"', () => JSON.stringify(name.replace(/\.[a-z]+$/i, '')));
        button.addEventListener('click', () => this.open({kind: 'new', name, text}, {}, true));
        row.append(' ', button);
      }
      part('findings').append(row);
    }
  }

  /** Saves the text; with the files that it names, as an archive. */
  async #save_scene() {
    const text = new TextEncoder().encode(this.editor.text);
    const files = Object.entries(this.named_files);
    if (files.length === 0) {
      save_as(new Blob([text], {type: 'application/toml'}), `${this.name}.toml`);
      return;
    }
    /** @type {Uint8Array<ArrayBuffer>[]} */
    const parts = [];
    const archive = new ZipWriter(async (bytes) => { parts.push(bytes); });
    await archive.add(`${this.name}.toml`, text);
    for (const [name, bytes] of files) await archive.add(name, bytes_of_base64(bytes));
    await archive.finish();
    save_as(new Blob(parts, {type: 'application/zip'}), `${this.name}.zip`);
  }

  /** After a change by the viewer. */
  #soon() {
    this.is_edited = true;
    window.clearTimeout(this.timer);
    this.timer = window.setTimeout(() => {
      this.timer = 0;
      // Values that were written are read already.
      if (this.editor.text !== this.page.data.text || this.is_refused) this.#write();
      else void this.#pack_link();
      this.#keep();
    }, write_after_ms);
  }

  /** Gives the text to the program. @param {Partial<Choices>} [changes] kept until the program accepts a text */
  #write(changes = {}) {
    const {page} = this;
    window.clearTimeout(this.timer);
    this.timer = 0;
    this.changes = {...this.changes, ...changes};
    void this.#pack_link();
    const named = [...this.unread.keys()].filter((name) => this.editor.text.includes(name));
    if (named.length > 0) {
      void this.#read_and_write(named);
      return;
    }
    const data = {...page.data, name: this.name, text: this.editor.text, files: this.files};
    try {
      const {program} = page.figure;
      if (!program) {
        // The next start shows this text.
        page.figure.choices = {...page.figure.choices, ...this.changes};
        page.data = data;
        return;
      }
      const given = this.given.get(program) ?? new Map();
      this.given.set(program, given);
      for (const [file, bytes] of Object.entries(this.files)) {
        if (given.get(file) === bytes) continue;
        program.addFile(file, bytes_of_base64(bytes));
        given.set(file, bytes);
      }
      page.figure.reload(this.changes, data);
      this.changes = {};
      this.is_refused = false;
      page.data = data;
    } catch (error) {
      this.is_refused = true;
      page.data = {...page.data, name: data.name};
      this.#find(error);
    }
  }

  /** Reads files that the text has just named, and gives the text to the program. @param {string[]} names */
  async #read_and_write(names) {
    await this.#show_reading(names);
    try {
      const taken = await this.#read_named(this.editor.text);
      this.files = {...this.files, ...taken};
    } catch (error) {
      this.#find(error);
      return;
    }
    this.#write();
    this.#keep();
  }

  /** Shows what the program found in the text. @param {unknown} [error] */
  #find(error) {
    /** @type {Finding[]} */
    const findings = [];
    const rows = [];
    if (error) {
      const {file, line, column} = error instanceof ProgramError ? error : {file: '', line: 0, column: 0};
      // The program names a scene without its suffix.
      const place = line > 0 ? `${file && file !== this.name ? file : `${this.name}.toml`}:${line}:${column}: ` : '';
      const finding = {message: message_of(error), line, column};
      findings.push(finding);
      const button = document.createElement('button');
      button.type = 'button';
      button.textContent = place + finding.message;
      button.addEventListener('click', () => this.editor.go(Math.max(1, finding.line), finding.column));
      rows.push(button);
    } else {
      const {loaded} = this.page.figure;
      for (const text of loaded ? loaded.notes : []) {
        const row = document.createElement('p');
        row.textContent = text;
        rows.push(row);
      }
      if (loaded) {
        const strong = document.createElement('strong');
        // Of a stepped motion, what the throw that it was fitted to did.
        strong.textContent = motion_said(loaded, this.words) || (this.measure?.said ?? '');
        // In the words of `poinsot check`; a small screen leaves them out.
        const exact = document.createElement(strong.textContent ? 'span' : 'em');
        exact.textContent = loaded.regime;
        part('motion-words').replaceChildren(strong, ' ', exact);
      }
    }
    part('findings').replaceChildren(...rows);
    this.#show_unkept();
    part('tab-text').classList.toggle('has-refusal', findings.length > 0);
    this.editor.mark(findings);
  }

  /** The motion at the film's frames, with the columns of `poinsot sample`. */
  csv() {
    const {figure} = this.page;
    const {program} = figure;
    if (!program) return '';
    const {length_s, frames_per_s} = figure.film.plan;
    const n = Math.min(most_rows, Math.max(1, Math.round(length_s * frames_per_s)));
    const states = Array.from({length: n}, (_, k) => program.at(figure.time_of(k / frames_per_s)));
    const rows = states.map((state) =>
      [state.time_s, ...state.omega_body, ...state.space_from_body, ...state.herpolhode, ...(state.angles ?? [])].join(','));
    const names = ['time_s', 'omega_body_1', 'omega_body_2', 'omega_body_3', 'q_w', 'q_x', 'q_y', 'q_z',
      'herpolhode_x', 'herpolhode_y', 'herpolhode_z', ...(states[0]?.angles ? ['theta_rad', 'phi_rad', 'psi_rad'] : [])];
    return `${names.join(',')}\n${rows.join('\n')}\n`;
  }

  /** A page of this scene, as `poinsot render -o PAGE.html` writes it. */
  async page_of_scene() {
    const {page} = this;
    const {figure} = page;
    const {loaded} = figure;
    const width = 1280;
    const height = Math.round((width * (loaded?.height ?? page.data.height)) / (loaded?.width ?? page.data.width));
    const language = loaded?.language ?? 'en';
    const poster = await figure.png(width, height, 'image/jpeg');
    // The text that the program accepted last, and its files.
    const {text} = page.data;
    const files = Object.fromEntries(Object.entries(page.data.files).filter(([name]) => text.includes(name)));
    const scene = {...page.data, files, controls: loaded?.controls.map((c) => c.key) ?? [],
      overrides: [...figure.choices.values].map(([key, value]) => `${key}=${value}`), language, width: loaded?.width ?? page.data.width, height: loaded?.height ?? page.data.height,
      poster_at_s: figure.film.at_s, title: loaded?.title ?? '', n_stops: loaded?.stops.length ?? 0, planned_s: 0, following: []};
    /** @type {Record<string, string>} */
    const values = {
      language: escaped(language), 'no-script': escaped(this.data.no_script[language] ?? ''), ground: escaped(loaded?.theme.background ?? '#ffffff'), title: escaped(loaded?.title ?? page.data.name),
      poster: `data:${poster.type};base64,${base64_of_bytes(new Uint8Array(await poster.arrayBuffer()))}`,
      scene: script_json(scene), fonts: block('program-fonts'), 'page-scripts': block('page-scripts'), 'film-writer': block('film-writer'), module: block('program-module'),
    };
    return this.data.template.replace(/\{\{([a-z-]+)\}\}/g, (place, name) => values[name] ?? place);
  }
}

const the_workbench = new Workbench(the_page);
