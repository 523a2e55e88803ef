// Measuring: a recording of ω(t) with its flights, and the scene of the one that is picked.

import {input, part, save_as} from './bar.js';
import {message_of} from './figure.js';
import {unpacked} from './loader.js';
import {OmegaChart} from './measure_chart.js';
import {ProgramError, WasmModule} from './program.js';
import {Recorder, is_caught, longest_record_s, table_of_rows} from './record.js';
import {all_words} from './words.js';
import {base64_of_bytes, files_of_zip, in_archive, table_among} from './zip_reader.js';
/** @import {Words} from './words.js' */

/**
 * @typedef {{number: number, begin_s: number, end_s: number, rate_rad_s: number, residual_rad_s?: number, residual_rad?: number, refusal?: string}} TableFlight
 * @typedef {{is_recording: boolean, flights: TableFlight[], best?: number, refusal?: string, rows: ArrayLike<number>}} MeasuredTable
 * @typedef {{fit: Record<string, any>, words: string[], scene: string, table?: string}} FittedFlight
 *   `fit`: as `poinsot fit --json` prints it; `table`: the rows of the scene, if they are others than those of the table.
 */

/** @type {Record<string, string[]>} */
const measure_words = {
  measure: ['Measure', 'Messen', 'Mesurer', 'Medir', 'Misura', '測定'],
  measure_open: ['Choose a table …', 'Tabelle wählen …', 'Choisir un tableau…', 'Elegir una tabla…', 'Scegli una tabella…', '表を選ぶ…'],
  measure_hint: ['Drop a measured ω(t) here: a table (CSV) of the app phyphox, or any that poinsot fit reads.',
    'Ziehen Sie ein gemessenes ω(t) hierher: eine Tabelle (CSV) der App phyphox oder jede andere, die poinsot fit liest.',
    'Déposez ici un ω(t) mesuré : un tableau (CSV) de l’application phyphox, ou tout autre que lit poinsot fit.',
    'Suelte aquí una ω(t) medida: una tabla (CSV) de la aplicación phyphox o cualquiera que lea poinsot fit.',
    'Trascini qui una ω(t) misurata: una tabella (CSV) dell’app phyphox, o una qualsiasi che poinsot fit legge.',
    '測定した ω(t) の表 (CSV) をここにドロップしてください。アプリ phyphox の表や、poinsot fit が読む表です。'],
  measure_flights: ['Flights', 'Flüge', 'Vols', 'Vuelos', 'Voli', '飛行'],
  measure_flight: ['Flight', 'Flug', 'Vol', 'Vuelo', 'Volo', '飛行'],
  measure_residual: ['residual', 'Rest', 'résidu', 'residuo', 'residuo', '残差'],
  measure_chart: ['Measured ω(t), all of the table', 'Gemessenes ω(t), die ganze Tabelle', 'ω(t) mesuré, tout le tableau', 'ω(t) medida, toda la tabla', 'ω(t) misurata, tutta la tabella', '測定した ω(t)、表全体'],
  measure_zoom: ['Measured ω(t) of the flight', 'Gemessenes ω(t) des Fluges', 'ω(t) mesuré du vol', 'ω(t) medida del vuelo', 'ω(t) misurata del volo', '飛行中に測定した ω(t)'],
  measure_numbers: ['What the fit says', 'Was die Anpassung sagt', 'Ce que dit l’ajustement', 'Lo que dice el ajuste', 'Che cosa dice il fit', 'あてはめの結果'],
  record: ['Record', 'Aufnehmen', 'Enregistrer', 'Grabar', 'Registra', '記録'],
  record_stop: ['Stop', 'Stopp', 'Arrêter', 'Parar', 'Ferma', '停止'],
  record_save: ['Save recording', 'Aufnahme speichern', 'Enregistrer le tableau', 'Guardar grabación', 'Salva registrazione', '記録を保存'],
  record_runs: ['The recording runs; Stop ends it.', 'Die Aufnahme läuft; Stopp beendet sie.', 'L’enregistrement est en cours ; Arrêter le termine.', 'La grabación está en marcha; Parar la termina.', 'La registrazione è in corso; Ferma la termina.', '記録中です。「停止」で終わります。'],
  record_wait: ['Waiting for the gyroscope …', 'Wartet auf das Gyroskop …', 'En attente du gyroscope…', 'Esperando el giroscopio…', 'In attesa del giroscopio…', 'ジャイロスコープを待っています…'],
  record_throw: ['Spin the phone and let it fly for half a second, onto something soft. The recording ends by itself after the catch.',
    'Lassen Sie das Telefon sich drehend eine halbe Sekunde fliegen, auf etwas Weiches. Die Aufnahme endet nach dem Fang von selbst.',
    'Lancez le téléphone en rotation, une demi-seconde, sur quelque chose de mou. L’enregistrement s’arrête de lui-même après la réception.',
    'Lance el teléfono girando durante medio segundo, sobre algo blando. La grabación termina sola tras la recogida.',
    'Lanci il telefono in rotazione per mezzo secondo, su qualcosa di morbido. La registrazione finisce da sola dopo la presa.',
    '電話を回しながら、柔らかいものの上へ0.5秒ほど投げてください。受け止めると記録は自動で終わります。'],
  record_needs: ['To record, open this page on a phone, from an address that begins with https. Or record with the app phyphox, and drop its table (CSV) here.',
    'Zum Aufnehmen öffnen Sie diese Seite auf einem Telefon, von einer Adresse, die mit https beginnt. Oder nehmen Sie mit der App phyphox auf, und ziehen Sie ihre Tabelle (CSV) hierher.',
    'Pour enregistrer, ouvrez cette page sur un téléphone, à une adresse qui commence par https. Ou enregistrez avec l’application phyphox et déposez son tableau (CSV) ici.',
    'Para grabar, abra esta página en un teléfono, desde una dirección que empiece por https. O grabe con la aplicación phyphox y suelte aquí su tabla (CSV).',
    'Per registrare, apra questa pagina su un telefono, da un indirizzo che comincia con https. Oppure registri con l’app phyphox e trascini qui la sua tabella (CSV).',
    '記録するには、このページを電話で、https で始まるアドレスから開いてください。または、アプリ phyphox で記録した表 (CSV) をここにドロップしてください。'],
  record_refused: ['This page may not read the gyroscope; allow it motion sensors in the browser’s settings, load the page again, and press Record.',
    'Diese Seite darf das Gyroskop nicht lesen; erlauben Sie ihr in den Einstellungen des Browsers Bewegungssensoren, laden Sie sie neu, und drücken Sie Aufnehmen.',
    'Cette page ne peut pas lire le gyroscope ; autorisez-lui les capteurs de mouvement dans les réglages du navigateur, rechargez-la, puis appuyez sur Enregistrer.',
    'Esta página no puede leer el giroscopio; permítale los sensores de movimiento en los ajustes del navegador, recárguela y pulse Grabar.',
    'Questa pagina non può leggere il giroscopio; le permetta i sensori di movimento nelle impostazioni del browser, la ricarichi e prema Registra.',
    'このページはジャイロスコープを読めません。ブラウザーの設定でモーションセンサーを許可し、ページを再読み込みして「記録」を押してください。'],
};
Object.assign(all_words, measure_words);

const catch_looked_for_ms = 500;
const first_row_within_ms = 2500;
/** Seconds of a recording that are shown, and searched for a flight. */
const live_s = 10;

/** The fit of the program, in a module of its own. */
export class FitModule extends WasmModule {
  /** @param {Uint8Array} bytes */
  static async start(bytes) {
    const it = new FitModule();
    try {
      await it.instantiate(await WebAssembly.compile(/** @type {any} */ (bytes)), {});
    } catch (error) {
      throw new ProgramError({kind: 'no-wasm', message: message_of(error)});
    }
    return it;
  }

  /** Reads a table and fits its flights; throws the program's refusal. @param {Uint8Array} bytes @param {string} name @returns {MeasuredTable} */
  read(bytes, name) {
    this.with_items([bytes, name], (...at) => this.call('read_table', ...at));
    return {...JSON.parse(this.answer()), rows: this.numbers()};
  }

  /** A flight of that table. @param {number} number @param {string} scene_table the name that the scene gives its rows @returns {FittedFlight} */
  flight(number, scene_table) {
    this.with_items([scene_table], (...at) => this.call('flight', number, ...at));
    return JSON.parse(this.answer());
  }

  /** Begins and ends of the flights in rows, s. @param {number[]} rows */
  find(rows) {
    this.with_items([new Uint8Array(new Float64Array(rows).buffer)], (at) => this.call('find_flights', at, rows.length / 4));
    return this.numbers();
  }
}

export class Measure {
  /** @param {Words} words @param {(name: string, text: string, files: Record<string, string>) => void} open shows a scene with its files */
  constructor(words, open) {
    this.words = words;
    this.open_scene = open;
    /** @type {Promise<FitModule>|null} */
    this.module = null;
    this.whole = new OmegaChart(/** @type {HTMLCanvasElement} */ (part('measure-whole')), false);
    this.zoom = new OmegaChart(/** @type {HTMLCanvasElement} */ (part('measure-zoom')), true);
    /** The table that was read last. @type {{name: string, bytes: Uint8Array, read: MeasuredTable}|null} */
    this.table = null;
    this.picked = 0;
    /** The recording that runs. @type {Recorder|null} */
    this.recorder = null;
    this.timer = 0;
    /** The last recording, as a table. */
    this.recorded = {name: '', text: ''};
    this.n_recorded = 0;
    this.#name();
    this.#wire();
    // Nobody drops files on a phone.
    const is_phone = matchMedia('(pointer: coarse)').matches;
    this.#say(!Recorder.is_possible ? 'record_needs' : is_phone ? 'record_throw' : 'measure_hint');
  }

  get is_open() {
    return !part('measure').hidden;
  }

  /** Whether a recording runs: nothing but its own button ends it before the catch. */
  get is_recording() {
    return this.recorder !== null;
  }

  /** While a recording runs, says how to end it; false: none runs. */
  #refuses() {
    if (this.is_recording) this.#say('record_runs');
    return this.is_recording;
  }

  /** @param {boolean} is_open */
  show(is_open) {
    if (!is_open && this.#refuses()) return;
    part('measure').hidden = !is_open;
    part('measure-open').setAttribute('aria-expanded', String(is_open));
    document.body.classList.toggle('measures', is_open);
  }

  /** Reads a table, or the one in an archive, and shows the flight that says most about the body. @param {string} name @param {Uint8Array<ArrayBuffer>} bytes */
  async take(name, bytes) {
    if (this.#refuses()) return;
    this.show(true);
    this.table = null;
    this.picked = 0;
    this.#show_table();
    this.#say('', `${this.words.of('reading')} ${name} …`);
    try {
      if (/\.zip$/i.test(name)) {
        const table = await in_archive(name, () => table_among(files_of_zip(bytes)));
        if (!table) throw new Error(`${name}: there is no table (.csv) in it; export the recording as CSV`);
        bytes = await in_archive(name, table.read);
        name = table.name;
      }
      const module = await this.#started();
      await painted();
      const read = module.read(bytes, name);
      this.table = {name, bytes, read};
      this.#say('', read.refusal ?? '', Boolean(read.refusal));
      this.#show_table();
      if (read.best) this.pick(read.best, module);
    } catch (error) {
      this.#fail(error);
    }
  }

  /** Shows a flight and its scene. @param {number} number @param {FitModule} module */
  pick(number, module) {
    if (!this.table) return;
    const {name, bytes, read} = this.table;
    const flight = read.flights.find((one) => one.number === number);
    this.picked = number;
    this.#show_flight();
    if (!flight || flight.refusal) {
      part('measure-words').replaceChildren();
      this.#say('', `${name}${read.is_recording ? `, flight ${number}` : ''}: ${flight?.refusal ?? ''}`, true);
      return;
    }
    this.#say('', '');
    const stem = name.replace(/\.[a-z]+$/i, '') + (read.is_recording ? `_flight_${number}` : '');
    const scene_table = read.is_recording ? `${stem}.csv` : name;
    const fitted = module.flight(number, scene_table);
    part('measure-words').replaceChildren(...fitted.words.map((line) => {
      const row = document.createElement('li');
      row.textContent = line;
      row.classList.toggle('note', line.startsWith('note:'));
      return row;
    }));
    const rows = fitted.table === undefined ? bytes : new TextEncoder().encode(fitted.table);
    this.open_scene(stem, fitted.scene, {[scene_table]: base64_of_bytes(rows)});
  }

  // ── Recording ───────────────────────────────────────────────────────────────────────────

  /** Call it from a press. */
  async record() {
    if (!Recorder.is_possible) {
      this.#say('record_needs', '', true);
      return;
    }
    if (this.#refuses()) return;
    const recorder = new Recorder(() => this.#show_live());
    this.recorder = recorder;
    part('record').hidden = true;
    part('record-stop').hidden = false;
    // Near the thumb that holds the phone.
    part('measure-close').hidden = true;
    part('record-save').hidden = true;
    this.table = null;
    this.#show_table();
    this.#say('record_wait');
    // Asks the viewer before anything else is waited for.
    const is_allowed = await recorder.start();
    if (this.recorder !== recorder) {
      recorder.stop();
      return;
    }
    if (!is_allowed) {
      this.#end_recording();
      this.#say('record_refused', '', true);
      return;
    }
    const module = await this.#started().catch((error) => this.#fail(error));
    if (module && this.recorder === recorder) this.#watch(recorder, module);
  }

  /** Ends the recording when the phone is caught, after its longest time, or where no gyroscope is. @param {Recorder} recorder @param {FitModule} module */
  #watch(recorder, module) {
    const began_ms = performance.now();
    this.timer = window.setInterval(() => {
      const {rows} = recorder;
      const last_s = rows[rows.length - 4] ?? 0;
      if (rows.length === 0) {
        if (performance.now() - began_ms < first_row_within_ms) return;
        this.#end_recording();
        this.#say('record_needs', '', true);
      } else if (last_s > longest_record_s || is_caught(rows, module.find(late_rows(rows)))) void this.stop();
    }, catch_looked_for_ms);
  }

  #show_live() {
    const {recorder} = this;
    if (!recorder) return;
    const {rows} = recorder;
    const to_s = rows[rows.length - 4] ?? 0;
    if (rows.length <= 8) this.#say('record_throw');
    part('measure-time').textContent = `${to_s.toFixed(1)} s`;
    part('measure-charts').hidden = false;
    this.whole.canvas.hidden = true;
    this.zoom.show({rows: late_rows(rows), from_s: Math.max(0, to_s - live_s), to_s: Math.max(to_s, live_s), bands: []});
  }

  /** Ends the recording and fits it. */
  async stop() {
    const rows = this.recorder?.rows ?? [];
    this.#end_recording();
    if (rows.length === 0) {
      this.#say('record_needs', '', true);
      return;
    }
    ++this.n_recorded;
    this.recorded = {name: `recording${this.n_recorded > 1 ? `_${this.n_recorded}` : ''}.csv`, text: table_of_rows(rows)};
    part('record-save').hidden = false;
    await this.take(this.recorded.name, new TextEncoder().encode(this.recorded.text));
  }

  #end_recording() {
    window.clearInterval(this.timer);
    this.recorder?.stop();
    this.recorder = null;
    part('record').hidden = !Recorder.is_possible;
    part('record-stop').hidden = true;
    part('measure-close').hidden = false;
    part('measure-time').textContent = '';
  }

  // ── What is shown ───────────────────────────────────────────────────────────────────────

  #name() {
    for (const [id, word] of [['measure-open', 'measure'], ['measure-file-open', 'measure_open'], ['record', 'record'],
      ['record-stop', 'record_stop'], ['record-save', 'record_save']]) part(/** @type {string} */ (id)).textContent = this.words.of(/** @type {string} */ (word));
    for (const [id, word] of [['measure', 'measure'], ['measure-close', 'close'], ['measure-whole', 'measure_chart'], ['measure-zoom', 'measure_zoom'],
      ['measure-flights', 'measure_flights'], ['measure-words', 'measure_numbers'], ['measure-file', 'measure_open']])
      part(/** @type {string} */ (id)).setAttribute('aria-label', this.words.of(/** @type {string} */ (word)));
    part('measure-charts').hidden = true;
    part('record').hidden = !Recorder.is_possible;
  }

  #wire() {
    part('measure-open').addEventListener('click', () => this.show(!this.is_open));
    part('measure-close').addEventListener('click', () => {
      this.show(false);
      part('measure-open').focus();
    });
    part('measure-file-open').addEventListener('click', () => input('measure-file').click());
    input('measure-file').addEventListener('change', () => {
      const file = input('measure-file').files?.[0];
      input('measure-file').value = '';
      if (file) void file.arrayBuffer().then((bytes) => this.take(file.name, new Uint8Array(bytes)));
    });
    part('record').addEventListener('click', () => void this.record());
    part('record-stop').addEventListener('click', () => void this.stop());
    part('record-save').addEventListener('click', () => save_as(new Blob([this.recorded.text], {type: 'text/csv'}), this.recorded.name));
    part('measure-whole').addEventListener('click', (event) => this.#pick_at(event.offsetX));
    part('measure').addEventListener('keydown', (event) => {
      // The keys of the figure are not for here.
      event.stopPropagation();
      if (event.key === 'Escape') part('measure-close').click();
    });
    window.addEventListener('beforeunload', (event) => {
      if (this.is_recording) event.preventDefault();
    });
  }

  /** Picks the flight that is nearest to a place on the chart. @param {number} x CSS pixels */
  #pick_at(x) {
    const t = this.whole.time_at(x);
    const distance = (/** @type {TableFlight} */ flight) => Math.max(flight.begin_s - t, t - flight.end_s);
    const near = [...(this.table?.read.flights ?? [])].sort((a, b) => distance(a) - distance(b))[0];
    const button = near && /** @type {HTMLInputElement|null} */ (document.querySelector(`#measure-flights input[value="${near.number}"]`));
    if (button) button.click();
  }

  #show_table() {
    const read = this.table?.read;
    part('measure-charts').hidden = !read;
    this.whole.canvas.hidden = !read?.is_recording;
    part('measure-flights').hidden = !read?.is_recording;
    part('measure-words').replaceChildren();
    part('measure-flights').replaceChildren(...(read?.is_recording ? read.flights : []).map((flight) => this.#row_of(flight)));
    this.#show_flight();
  }

  /** @param {TableFlight} flight */
  #row_of(flight) {
    const row = document.createElement('label');
    const button = document.createElement('input');
    button.type = 'radio';
    button.name = 'flight';
    button.value = String(flight.number);
    button.addEventListener('change', () => void this.#started().then((module) => this.pick(flight.number, module)).catch((error) => this.#fail(error)));
    const name = document.createElement('b');
    name.textContent = `${flight.number}`;
    button.setAttribute('aria-label', `${this.words.of('measure_flight')} ${flight.number}`);
    const text = document.createElement('span');
    text.textContent = `${flight.begin_s.toFixed(2)}–${flight.end_s.toFixed(2)} s`;
    const size = document.createElement('small');
    const left = flight.residual_rad ?? flight.residual_rad_s;
    const unit = flight.residual_rad === undefined ? 'rad/s' : 'rad';
    size.textContent = `|ω| ${flight.rate_rad_s.toFixed(1)} rad/s${left === undefined ? '' : `, ${this.words.of('measure_residual')} ${left.toPrecision(2)} ${unit}`}`;
    row.append(button, name, text, size);
    return row;
  }

  #show_flight() {
    const read = this.table?.read;
    if (!read) return;
    const {rows, flights} = read;
    const first_s = rows[0] ?? 0;
    const last_s = rows[rows.length - 4] ?? 0;
    const bands = (read.is_recording ? flights : []).map((flight) => ({...flight, picked: flight.number === this.picked}));
    this.whole.show({rows, from_s: first_s, to_s: last_s, bands});
    const shown = flights.find((flight) => flight.number === this.picked) ?? flights[0];
    const beside_s = read.is_recording && shown ? 0.2 * (shown.end_s - shown.begin_s) : 0;
    this.zoom.show({rows, bands, from_s: (shown?.begin_s ?? first_s) - beside_s, to_s: (shown?.end_s ?? last_s) + beside_s});
    const button = /** @type {HTMLInputElement|null} */ (document.querySelector(`#measure-flights input[value="${this.picked}"]`));
    if (!button) return;
    button.checked = true;
    // Only the list moves, not the page.
    const list = part('measure-flights');
    const row = /** @type {HTMLElement} */ (button.parentElement);
    list.scrollTop = Math.min(Math.max(list.scrollTop, row.offsetTop + row.offsetHeight - list.clientHeight), row.offsetTop);
  }

  /** Says a word of `measure_words`, or a text. @param {string} word @param {string} [text] @param {boolean} [is_refusal] */
  #say(word, text = '', is_refusal = false) {
    const message = part('measure-message');
    message.textContent = word ? this.words.of(word) : text;
    message.classList.toggle('refused', is_refusal);
  }

  /** @param {unknown} error */
  #fail(error) {
    // A module that ended itself is started anew.
    if (error instanceof ProgramError && error.kind !== 'input') this.module = null;
    this.#say('', message_of(error), true);
  }

  #started() {
    return (this.module ??= FitModule.start(unpacked('fit-module')));
  }
}

/** Waits until what was changed is painted: a large file takes seconds. */
export async function painted() {
  // A frame's callbacks run before it is painted, and the next task after it.
  await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
}

/** The last rows of a recording. @param {number[]} rows */
function late_rows(rows) {
  const last_s = rows[rows.length - 4] ?? 0;
  let k = rows.length;
  while (k > 0 && (rows[k - 4] ?? 0) > last_s - live_s) k -= 4;
  return rows.slice(k);
}
