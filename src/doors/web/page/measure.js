// Measuring: a recording of ω(t) with its flights, and the scene of the one that is picked.

import {input, part, save_as} from './bar.js';
import {message_of} from './figure.js';
import {unpacked} from './loader.js';
import {OmegaChart} from './measure_chart.js';
import {ProgramError, WasmModule} from './program.js';
import {falls_of, why_poor} from './poor_throw.js';
import {RecordSignals} from './record_signals.js';
import {Recorder, is_caught, longest_record_s, table_of_rows} from './record.js';
import {throw_story} from './throw_story.js';
import {all_words} from './words.js';
import {base64_of_bytes, files_of_zip, in_archive, table_among} from './zip_reader.js';
/** @import {ThrowStory} from './throw_story.js' */
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
  throw_phone: ['Your phone', 'Ihr Telefon', 'Votre téléphone', 'Su teléfono', 'Il suo telefono', '電話'],
  throw_body: ['The body', 'Der Körper', 'Le corps', 'El cuerpo', 'Il corpo', '物体'],
  throw_once: ['{who} turned over once, after {at} s, about its middle axis{air}.', '{who} schlug einmal um, nach {at} s, um seine mittlere Achse{air}.', '{who} s’est retourné une fois, après {at} s, autour de son axe moyen{air}.', '{who} se dio la vuelta una vez, a los {at} s, sobre su eje intermedio{air}.', '{who} si è capovolto una volta, dopo {at} s, attorno al suo asse intermedio{air}.', '{who}は中間の軸のまわりで、{at} 秒後に一度反転しました{air}。'],
  throw_often: ['{who} turned over {n} times, first after {at} s, about its middle axis{air}.', '{who} schlug {n}-mal um, zuerst nach {at} s, um seine mittlere Achse{air}.', '{who} s’est retourné {n} fois, la première après {at} s, autour de son axe moyen{air}.', '{who} se dio la vuelta {n} veces, la primera a los {at} s, sobre su eje intermedio{air}.', '{who} si è capovolto {n} volte, la prima dopo {at} s, attorno al suo asse intermedio{air}.', '{who}は中間の軸のまわりで {n} 回反転し、最初は {at} 秒後でした{air}。'],
  throw_short: ['{who} turned about its middle axis, and {length} s were too short to turn over{air}.', '{who} drehte sich um seine mittlere Achse, und {length} s waren zu kurz zum Umschlagen{air}.', '{who} a tourné autour de son axe moyen, et {length} s étaient trop courtes pour se retourner{air}.', '{who} giró sobre su eje intermedio, y {length} s fueron pocos para darse la vuelta{air}.', '{who} ha ruotato attorno al suo asse intermedio, e {length} s erano troppo pochi per capovolgersi{air}.', '{who}は中間の軸のまわりで回りましたが、{length} 秒では反転に足りませんでした{air}。'],
  throw_wobbles_0: ['{who} wobbled about the axis of its largest moment, {turns} turns in {length} s, and did not turn over{air}.', '{who} taumelte um die Achse seines größten Moments, {turns} Umdrehungen in {length} s, und schlug nicht um{air}.', '{who} a oscillé autour de l’axe de son plus grand moment, {turns} tours en {length} s, sans se retourner{air}.', '{who} osciló sobre el eje de su mayor momento, {turns} vueltas en {length} s, sin darse la vuelta{air}.', '{who} ha oscillato attorno all’asse del suo momento maggiore, {turns} giri in {length} s, senza capovolgersi{air}.', '{who}は最大モーメントの軸のまわりで {length} 秒に {turns} 回転し、反転しませんでした{air}。'],
  throw_wobbles_2: ['{who} wobbled about its long axis, {turns} turns in {length} s, and did not turn over{air}.', '{who} taumelte um seine lange Achse, {turns} Umdrehungen in {length} s, und schlug nicht um{air}.', '{who} a oscillé autour de son grand axe, {turns} tours en {length} s, sans se retourner{air}.', '{who} osciló sobre su eje largo, {turns} vueltas en {length} s, sin darse la vuelta{air}.', '{who} ha oscillato attorno al suo asse lungo, {turns} giri in {length} s, senza capovolgersi{air}.', '{who}は長い軸のまわりで {length} 秒に {turns} 回転し、反転しませんでした{air}。'],
  throw_air: ['; it lost {lost} % of its spin to the air', '; {lost} % seines Dralls verlor es an die Luft', ' ; l’air lui a pris {lost} % de sa rotation', '; perdió en el aire el {lost} % de su giro', '; ha perso nell’aria il {lost} % della sua rotazione', '。空気で回転の {lost} % を失いました'],
  throw_ratios: ['Its moments of inertia, the middle and the smallest of the largest: {two}, {three}.', 'Seine Trägheitsmomente, das mittlere und das kleinste vom größten: {two}; {three}.', 'Ses moments d’inertie, le moyen et le plus petit, rapportés au plus grand : {two} ; {three}.', 'Sus momentos de inercia, el intermedio y el menor respecto al mayor: {two}; {three}.', 'I suoi momenti d’inerzia, l’intermedio e il minore rispetto al maggiore: {two}; {three}.', '慣性モーメント（最大を 1 として中間、最小）: {two}、{three}。'],
  throw_title: ['My throw, {time}', 'Mein Wurf, {time}', 'Mon lancer, {time}', 'Mi lanzamiento, {time}', 'Il mio lancio, {time}', '{time} に投げた電話'],
  throw_more: ['Numbers', 'Zahlen', 'Nombres', 'Números', 'Numeri', '数値'],
  throw_again: ['Throw again', 'Noch einmal werfen', 'Relancer', 'Lanzar otra vez', 'Lancia di nuovo', 'もう一度投げる'],
  poor_never_free: ['The phone was never in free fall: throw it, so that it flies for half a second.', 'Das Telefon war nie im freien Fall: Werfen Sie es, sodass es eine halbe Sekunde fliegt.', 'Le téléphone n’a jamais été en chute libre : lancez-le pour qu’il vole une demi-seconde.', 'El teléfono no estuvo en caída libre: láncelo para que vuele medio segundo.', 'Il telefono non è mai stato in caduta libera: lo lanci, così che voli mezzo secondo.', '電話は自由落下しませんでした。0.5秒ほど飛ぶように投げてください。'],
  poor_too_short: ['The flight was too short: throw the phone higher, for half a second or more.', 'Der Flug war zu kurz: Werfen Sie das Telefon höher, eine halbe Sekunde oder länger.', 'Le vol était trop court : lancez le téléphone plus haut, une demi-seconde ou plus.', 'El vuelo fue demasiado corto: lance el teléfono más alto, medio segundo o más.', 'Il volo è stato troppo corto: lanci il telefono più in alto, per mezzo secondo o più.', '飛行が短すぎました。もっと高く、0.5秒以上飛ぶように投げてください。'],
  poor_too_slow: ['The phone hardly turned: give it more spin, one turn in the flight or more.', 'Das Telefon drehte sich kaum: Geben Sie ihm mehr Drall, eine Umdrehung im Flug oder mehr.', 'Le téléphone a à peine tourné : donnez-lui plus de rotation, au moins un tour en vol.', 'El teléfono apenas giró: dele más giro, una vuelta o más en el vuelo.', 'Il telefono ha girato appena: gli dia più rotazione, un giro in volo o più.', '電話はほとんど回りませんでした。飛んでいる間に1回転以上するように回してください。'],
  poor_too_fast: ['The phone turned faster than its gyroscope measures (2000° a second): throw it with less spin.', 'Das Telefon drehte sich schneller, als sein Gyroskop misst (2000° in der Sekunde): Werfen Sie es mit weniger Drall.', 'Le téléphone a tourné plus vite que ne mesure son gyroscope (2000° par seconde) : lancez-le avec moins de rotation.', 'El teléfono giró más rápido de lo que mide su giroscopio (2000° por segundo): láncelo con menos giro.', 'Il telefono ha girato più in fretta di quanto misura il suo giroscopio (2000° al secondo): lo lanci con meno rotazione.', '電話がジャイロスコープの限界（毎秒2000°）より速く回りました。回転を弱めて投げてください。'],
  poor_one_axis: ['The phone turned about one axis alone, which tells nothing about the others: throw it end over end.', 'Das Telefon drehte sich nur um eine Achse, was nichts über die anderen sagt: Werfen Sie es so, dass es sich überschlägt.', 'Le téléphone a tourné autour d’un seul axe, ce qui ne dit rien des autres : lancez-le en culbute.', 'El teléfono giró sobre un solo eje, lo que no dice nada de los demás: láncelo dando volteretas.', 'Il telefono ha girato attorno a un solo asse, e ciò non dice nulla degli altri: lo lanci a capriola.', '電話は一つの軸のまわりだけで回ったため、ほかの軸のことが分かりません。前後に宙返りするように投げてください。'],
  record_no_gyroscope: ['This phone has no gyroscope, or its browser does not give it. Take another phone, or another browser.', 'Dieses Telefon hat kein Gyroskop, oder sein Browser gibt es nicht frei. Nehmen Sie ein anderes Telefon oder einen anderen Browser.', 'Ce téléphone n’a pas de gyroscope, ou son navigateur ne le donne pas. Prenez un autre téléphone ou un autre navigateur.', 'Este teléfono no tiene giroscopio, o su navegador no lo da. Use otro teléfono u otro navegador.', 'Questo telefono non ha un giroscopio, o il suo browser non lo dà. Prenda un altro telefono o un altro browser.', 'この電話にはジャイロスコープがないか、ブラウザーが使わせません。別の電話かブラウザーを使ってください。'],
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
/** Of |L|: less is not spoken of. */
const least_loss = 0.01;
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
    this.recorded = {name: '', text: '', time: ''};
    this.n_recorded = 0;
    /** What the throw that is shown did, in words. */
    this.said = '';
    /** @type {RecordSignals|null} */
    this.signals = null;
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
    this.#unfold(false);
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
      this.#show_result(false);
      this.#say('', `${name}${read.is_recording ? `, flight ${number}` : ''}: ${flight?.refusal ?? ''}`, true);
      return;
    }
    this.#say('', '');
    const is_own = name === this.recorded.name;
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
    const {fit} = fitted;
    this.said = this.#story_in_words(throw_story({moments: fit.moments, axes: fit.axes}, read.rows, flight.begin_s, flight.end_s), is_own);
    part('measure-sentence').textContent = this.said;
    const ratio = (/** @type {number} */ k) => ratio_in_words(fit.moments[k], fit.moments_sd[k], this.words.code);
    part('measure-ratios').textContent = this.words.of('throw_ratios').replace('{two}', ratio(1)).replace('{three}', ratio(2));
    this.#show_result(true);
    const title = is_own ? `title = ${JSON.stringify(this.words.of('throw_title').replace('{time}', this.recorded.time))}\n` : '';
    this.open_scene(stem, title + fitted.scene, {[scene_table]: base64_of_bytes(rows)});
  }

  /** The sentence that a thrower waits for. @param {ThrowStory} story @param {boolean} is_own whether it is of the phone itself */
  #story_in_words({axis, n_flips, first_flip_s, length_s, n_turns, lost}, is_own) {
    const number = (/** @type {number} */ x, /** @type {number} */ digits) => x.toLocaleString(this.words.code, {minimumFractionDigits: digits, maximumFractionDigits: digits});
    const word = n_flips === null ? `throw_wobbles_${axis}` : n_flips === 0 ? 'throw_short' : n_flips === 1 ? 'throw_once' : 'throw_often';
    const air = lost < least_loss ? '' : this.words.of('throw_air').replace('{lost}', number(100 * lost, 0));
    return this.words.of(word).replace('{who}', this.words.of(is_own ? 'throw_phone' : 'throw_body')).replace('{at}', number(first_flip_s ?? 0, 2))
      .replace('{n}', String(n_flips)).replace('{length}', number(length_s, 2)).replace('{turns}', number(n_turns, 1)).replace('{air}', air);
  }

  /** On a small screen a result is the picture: what it says comes first, and the rest behind a press. @param {boolean} is_there */
  #show_result(is_there) {
    part('measure-said').hidden = !is_there;
    document.body.classList.toggle('has-throw', is_there);
    part('record').textContent = this.words.of(is_there ? 'throw_again' : 'record');
    if (!is_there) this.said = '';
    this.#unfold(false);
  }

  /** @param {boolean} is_unfolded */
  #unfold(is_unfolded) {
    document.body.classList.toggle('unfolded', is_unfolded);
    part('measure-more').setAttribute('aria-expanded', String(is_unfolded));
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
    const signals = new RecordSignals();
    this.signals = signals;
    document.body.classList.add('records');
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
        this.#say(recorder.lacks_gyroscope ? 'record_no_gyroscope' : 'record_needs', '', true);
        return;
      }
      // A throw that the rows do not show as a free body's is felt as a fall.
      const flights = module.find(late_rows(rows));
      if (last_s > longest_record_s || is_caught(rows, flights.length > 0 ? flights : falls_of(recorder.accelerations).slice(-2))) void this.stop();
    }, catch_looked_for_ms);
  }

  #show_live() {
    const {recorder} = this;
    if (!recorder) return;
    const {rows} = recorder;
    const to_s = rows[rows.length - 4] ?? 0;
    if (rows.length <= 8) this.#say('record_throw');
    if (rows.length === 4) this.signals?.begun();
    part('measure-time').textContent = `${to_s.toFixed(1)} s`;
    part('measure-charts').hidden = false;
    this.whole.canvas.hidden = true;
    this.zoom.show({rows: late_rows(rows), from_s: Math.max(0, to_s - live_s), to_s: Math.max(to_s, live_s), bands: []});
  }

  /** Ends the recording and fits it. */
  async stop() {
    const rows = this.recorder?.rows ?? [];
    const why = this.recorder ? why_poor(rows, this.recorder.accelerations) : '';
    this.#end_recording();
    if (rows.length === 0) {
      this.#say('record_needs', '', true);
      return;
    }
    ++this.n_recorded;
    this.recorded = {name: `recording${this.n_recorded > 1 ? `_${this.n_recorded}` : ''}.csv`, text: table_of_rows(rows),
      time: new Date().toLocaleTimeString(this.words.code, {hour: '2-digit', minute: '2-digit'})};
    part('record-save').hidden = false;
    await this.take(this.recorded.name, new TextEncoder().encode(this.recorded.text));
    // For one who throws, not for a table.
    if (why && part('measure-message').classList.contains('refused')) this.#say(`poor_${why}`, '', true);
  }

  #end_recording() {
    window.clearInterval(this.timer);
    this.recorder?.stop();
    this.signals?.ended((this.recorder?.rows.length ?? 0) > 0);
    this.signals = null;
    document.body.classList.remove('records');
    this.recorder = null;
    part('record').hidden = !Recorder.is_possible;
    part('record-stop').hidden = true;
    part('measure-close').hidden = false;
    part('measure-time').textContent = '';
  }

  // ── What is shown ───────────────────────────────────────────────────────────────────────

  #name() {
    for (const [id, word] of [['measure-open', 'measure'], ['measure-file-open', 'measure_open'], ['record', 'record'],
      ['record-stop', 'record_stop'], ['record-save', 'record_save'], ['measure-more', 'throw_more']]) part(/** @type {string} */ (id)).textContent = this.words.of(/** @type {string} */ (word));
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
    part('measure-more').addEventListener('click', () => this.#unfold(!document.body.classList.contains('unfolded')));
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
    this.#show_result(false);
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
    // Of the scene before, which is no answer to a throw.
    document.body.classList.toggle('refused-throw', is_refusal);
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

/** "0.932 ± 0.003": to two digits of the deviation. @param {number} value @param {number} sd @param {string} language */
function ratio_in_words(value, sd, language) {
  const digits = sd > 0 ? Math.min(6, Math.max(1, 1 - Math.floor(Math.log10(sd)))) : 6;
  const number = (/** @type {number} */ x) => x.toLocaleString(language, {minimumFractionDigits: digits, maximumFractionDigits: digits});
  return `${number(value)}\u00a0±\u00a0${number(sd)}`;
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
