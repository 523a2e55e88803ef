// Films made in the page: MP4, WebM, slides, and pictures as a ZIP archive, of the frames that `poinsot render` draws.

import {input, part} from './bar.js';
import {message_of} from './figure.js';
import {AlphaPairs, FrameEncoder, bitrate_of, film_qualities, key_frame_interval, working_codec} from './film_encoder.js';
import {FilmFile, has_film_writer, load_film_writer, most_mp4_chapters} from './film_file.js';
import {bytes_of_base64} from './loader.js';
import {ZipWriter, joined_bytes, png_file} from './png_frames.js';
import {Program, ProgramError} from './program.js';
import {write_slides} from './slides.js';
/** @import {FilmKind} from './film_encoder.js' */
/** @import {FileSink, FilmContents, FilmHashes} from './film_file.js' */
/** @import {Page} from './page.js' */
/** @import {Words} from './words.js' */

/**
 * @typedef {{name: string, text: string, files: Record<string, string>, overrides: string[]}} FilmScene
 * @typedef {{kind: FilmKind, width: number, height: number, rate: number, quality: string, span: FilmSpan}} FilmSettings
 * @typedef {{kind: 'whole'|'chapter'|'stop'|'seconds', index: number, first_s?: number, last_s?: number}} FilmSpan
 *   A chapter, or what leads to a stop: from the stop before it, or from the beginning. After the last stop: to the end. Seconds: the frames
 *   from the first to the last.
 * @typedef {{title: string, width: number, height: number, numerator: number, denominator: number, n_frames: number,
 *   transparent: boolean, chapters: number[], stops: number[]}} FilmDescription
 *   The first frames of chapters and stops.
 */

/** Of a frame: the most that H.264 codes (Rec. ITU-T H.264, table A-1), and of a picture: what a tab has memory for. */
const most_frame_pixels = 139264 * 256;
const most_picture_pixels = 8192 * 8192;

const estimate_after_ms = 300;
const most_sample_pixels = 960 * 540;
/** About what the record in a picture takes. */
const record_bytes = 2500;

/** Lets the page answer; other than timers and frames, it is not slowed down where the tab is hidden. @returns {Promise<void>} */
function let_page_answer() {
  return new Promise((resolve) => {
    const {port1, port2} = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  });
}

/** The first and the last frame of a span: one frame at least. @param {FilmDescription} film @param {FilmSpan} span @returns {[number, number]} */
export function frames_of_span(film, {kind, index, first_s = 0, last_s = Infinity}) {
  const end = film.n_frames - 1;
  if (kind === 'seconds') {
    const rate = film.numerator / film.denominator;
    const from = Math.min(Math.ceil(first_s * rate - 1e-6), end);
    return [from, Math.max(from, Math.min(Math.floor(last_s * rate + 1e-6), end))];
  }
  const marks = kind === 'chapter' ? film.chapters : film.stops;
  const first = kind === 'whole' ? 0 : marks[kind === 'chapter' ? index : index - 1] ?? 0;
  const last = kind === 'whole' ? end : kind === 'chapter' ? (marks[index + 1] ?? film.n_frames) - 1 : marks[index] ?? end;
  return [Math.min(first, end), Math.min(Math.max(first, last), end)];
}

export class FilmCancelled extends Error {}

/** Makes one film; `progress` is called after each frame. */
export class FilmRun {
  /** @param {Program} program of its own @param {(done: number, n_frames: number) => void} progress @param {AbortSignal} signal */
  constructor(program, progress, signal) {
    this.program = program;
    this.progress = progress;
    this.signal = signal;
    /** Set where the browser takes the graphics away. */
    this.is_lost = false;
  }

  /** @param {number} done @param {number} n_frames */
  async go_on(done, n_frames) {
    this.progress(done, n_frames);
    await let_page_answer();
    if (this.signal.aborted) throw new FilmCancelled('cancelled');
    if (this.is_lost) throw new Error('lost');
  }

  /** Pictures of the frames in a ZIP archive. @param {FilmDescription} film @param {[number, number]} span @param {string} name @param {ZipWriter} zip @param {string} maker */
  async pictures(film, [first, last], name, zip, maker) {
    const digits = Math.max(4, String(last).length);
    for (let frame = first; frame <= last; ++frame) {
      const pixels = this.program.filmFrame(frame, 'pixels');
      await this.go_on(frame - first, last - first + 1);
      const record = this.program.filmRecord([first, last], maker, {}, 3);
      await zip.add(`${name}_${String(frame).padStart(digits, '0')}.png`, await png_file(pixels, film.width, film.height, 'poinsot', record));
    }
    await zip.finish();
  }

  /** A film of the frames; null where it is in the sink. WebM keeps transparency. @param {FilmDescription} film @param {[number, number]} span @param {FilmContents} contents @param {FileSink|null} sink */
  async video(film, [first, last], contents, sink) {
    const n_frames = last - first + 1;
    const every = key_frame_interval(film);
    const file = new FilmFile(contents, sink);
    const keeps_alpha = film.transparent && contents.kind === 'webm';
    /** @type {FrameEncoder[]} */
    const encoders = [];
    try {
      await file.start();
      if (keeps_alpha) {
        const pairs = new AlphaPairs(file);
        encoders.push(new FrameEncoder(film, contents.codec, (index, packet) => pairs.picture(index, packet)),
          new FrameEncoder(film, contents.codec, (index, packet) => pairs.alpha(index, packet)));
      } else {
        encoders.push(new FrameEncoder(film, contents.codec, (index, packet) => file.add(index, packet)));
      }
      const n_pixels = film.width * film.height;
      for (let k = 0; k < n_frames; ++k) {
        const planes = this.program.filmFrame(first + k, keeps_alpha ? 'with alpha' : 'planes');
        await this.go_on(k, n_frames);
        for (const [number, encoder] of encoders.entries()) {
          const grey = new Uint8Array(n_pixels / 2).fill(128);
          const given = number === 0 ? planes.subarray(0, 1.5 * n_pixels) : joined_bytes([planes.subarray(1.5 * n_pixels), grey]);
          await encoder.add(given, k % every === 0);
        }
      }
      for (const encoder of encoders) await encoder.finish();
      const bytes = await file.finish();
      this.progress(n_frames, n_frames);
      return bytes;
    } catch (error) {
      await file.cancel();
      throw error;
    } finally {
      for (const encoder of encoders) encoder.close();
    }
  }
}

/** What writes presentations; the workbench alone has it. @type {{write: typeof write_slides|null}} */
export const presentations = {write: null};

/** What a kind of film ends its name with, and its type. @type {Record<FilmKind, [string, string]>} */
export const film_files = {
  mp4: ['.mp4', 'video/mp4'], webm: ['.webm', 'video/webm'], png: ['.zip', 'application/zip'], slides: ['_slides.zip', 'application/zip'],
  pptx: ['.pptx', 'application/vnd.openxmlformats-officedocument.presentationml.presentation'],
};

/** A file that the user chooses; null: the browser has none, undefined: the user chose none. @param {string} name @param {FilmKind} kind @returns {Promise<any>} */
async function chosen_file(name, kind) {
  const show = /** @type {any} */ (window).showSaveFilePicker;
  if (typeof show !== 'function' || window.self !== window.top) return null;
  const [suffix, type] = film_files[kind];
  try {
    return await show.call(window, {suggestedName: name, types: [{accept: {[type]: [suffix.slice(suffix.indexOf('.'))]}}]});
  } catch (error) {
    return error instanceof DOMException && error.name === 'AbortError' ? undefined : null;
  }
}

/** The scene of a film, as the page shows it now. @param {Page} page @param {FilmSettings} settings @returns {FilmScene} */
export function film_scene(page, settings) {
  const {name, text, files} = page.figure.data ?? page.data;
  return {name, text, files, overrides: page.overrides(settings)};
}

/** Refuses what no browser can do, before anything is begun. @param {FilmSettings} settings @param {Words} words */
function check_size({kind, width, height}, words) {
  const is_whole = [width, height].every((side) => Number.isInteger(side) && side > 0);
  const most = kind === 'png' ? most_picture_pixels : most_frame_pixels;
  if (is_whole && width * height > most)
    throw new RangeError(words.of('film_size').replace('{size}', `${width} × ${height}`).replace('{most}', String(Math.floor(1e-6 * most))));
  if (is_whole && kind !== 'png' && (width % 2 !== 0 || height % 2 !== 0)) throw new RangeError(words.of('film_even'));
}

/** What a failure is in one sentence. @param {unknown} error @param {Words} words @param {FilmRun|null} run */
function sentence_of(error, words, run) {
  if (error instanceof FilmCancelled) return words.of('film_cancelled');
  if (error instanceof DOMException && error.name === 'QuotaExceededError') return words.of('film_disk');
  // The module hears of the loss before the canvas does.
  if (run && (run.is_lost || run.program.gl?.isContextLost())) return words.of('film_lost');
  if (error instanceof ProgramError || error instanceof RangeError) return message_of(error);
  return `${words.of('film_failed')} ${message_of(error)}`;
}

/**
 * Makes a film. It throws one sentence, in an Error, and leaves no file then.
 * @param {Page} page @param {FilmScene} scene @param {FilmSettings} settings
 * @param {{progress: (done: number, n_frames: number) => void, signal: AbortSignal, began?: (run: FilmRun) => void, file?: any}} how
 *   `file`: where the browser writes it
 * @returns {Promise<{blob: Blob|null, remarks: string[]}>} null: it is in the file
 */
export async function make_film(page, scene, settings, {progress, signal, began = () => {}, file = null}) {
  const {words} = page;
  const {kind} = settings;
  /** @type {FilmRun|null} */
  let run = null;
  /** @type {FileSink|null} */
  let sink = null;
  try {
    check_size(settings, words);
    const [suffix, type] = film_files[kind];
    // A context of its own: the figure may rest, or be given another scene.
    const canvas = document.createElement('canvas');
    const bytes = await page.program_bytes();
    const program = await Program.start(bytes.module, bytes.fonts, canvas);
    const it = new FilmRun(program, progress, signal);
    run = it;
    began(it);
    canvas.addEventListener('webglcontextlost', () => { it.is_lost = true; });
    for (const [name, text] of Object.entries(scene.files)) program.addFile(name, bytes_of_base64(text));
    const film = program.openFilm(scene.text, scene.name, scene.overrides);
    const span = frames_of_span(film, settings.span);
    const codec = kind === 'png' ? null : await working_codec(kind, film, settings.quality);
    if (kind !== 'png' && !codec) throw new RangeError(words.of('film_no_encoder'));
    const remarks = [];
    if (kind !== 'png' && kind !== 'webm' && film.transparent) remarks.push(words.of('film_opaque'));
    if (codec && kind !== 'webm' && codec.codec !== 'avc') remarks.push(`${words.of('film_no_h264')} ${codec.name}.`);
    const how = codec ? `${codec.name} (${codec.config.codec}) by WebCodecs, ${codec.config.bitrate} bit/s` : 'PNG';
    const maker = `${navigator.userAgent}; ${how}`;
    sink = file ? /** @type {FileSink} */ (await file.createWritable()) : null;
    /** @type {Blob|null} */
    let blob = null;
    if (codec) await load_film_writer();
    if (codec && (kind === 'mp4' || kind === 'webm')) {
      const texts = program.filmTexts(span, scene.name + suffix);
      const n_left_out = kind === 'mp4' ? texts.chapters.length - most_mp4_chapters : 0;
      if (n_left_out > 0) remarks.push(words.of('film_chapters').replace('{n}', String(n_left_out)));
      const record = (/** @type {FilmHashes} */ hashes) => program.filmRecord(span, maker, hashes);
      const bytes = await it.video(film, span, {kind, codec, shape: film, texts, record}, sink);
      if (bytes) blob = new Blob([bytes], {type});
    } else {
      /** @type {Blob[]} */
      const parts = [];
      const memory = {write: async (/** @type {Uint8Array<ArrayBuffer>} */ part) => { parts.push(new Blob([part])); }};
      const target = sink ?? memory;
      const zip = new ZipWriter((bytes) => target.write(bytes));
      if (!codec) await it.pictures(film, span, scene.name, zip, maker);
      else await (kind === 'pptx' && presentations.write ? presentations.write : write_slides)(it, film, codec, maker, zip);
      if (!sink) blob = new Blob(parts, {type});
    }
    await sink?.close();
    return {blob, remarks};
  } catch (error) {
    const sentence = sentence_of(error, words, run);
    await sink?.abort().catch(() => {});
    await remove_empty(file);
    throw new Error(sentence, {cause: error});
  } finally {
    run?.program.stop();
  }
}

/** Removes the empty file that a browser makes where the user chose one. @param {any} file */
async function remove_empty(file) {
  try {
    if (file && (await file.getFile()).size === 0) await file.remove();
  } catch {
    // The browser cannot.
  }
}

/** The section "Film" of the options. */
export class FilmSection {
  /** @param {Page} page */
  constructor(page) {
    this.page = page;
    /** Ends the film that is made or about to be; null: none is. @type {AbortController|null} */
    this.making = null;
    /** @type {FilmRun|null} */
    this.run = null;
    this.signature = '';
    /** Of the next estimate of the size. */
    this.estimate_timer = 0;
    /** When the second frame began: the first one takes longer, as it compiles the shaders. */
    this.second_ms = 0;
    part('section-film').hidden = !has_film_writer();
    part('film-make').addEventListener('click', () => void this.make(this.settings()));
    part('film-cancel').addEventListener('click', () => this.making?.abort());
    for (const id of ['film-kind', 'film-span', 'film-width', 'film-height', 'film-rate', 'film-quality']) part(id).addEventListener('change', () => this.#hint());
    window.addEventListener('beforeunload', (event) => {
      if (this.making) event.preventDefault();
    });
  }

  /** Offers what the scene has. */
  show() {
    const {loaded} = this.page.figure;
    if (!loaded || !has_film_writer()) return;
    const {words} = this.page;
    const signature = JSON.stringify([words.code, loaded.film_width, loaded.film_height, loaded.frames_per_s, loaded.film_length_s, loaded.chapters, loaded.stops]);
    if (signature === this.signature) return;
    this.signature = signature;
    const options = (/** @type {string} */ id, /** @type {[string, string][]} */ rows, chosen = rows[0]?.[0]) => {
      const list = /** @type {HTMLSelectElement} */ (part(id));
      list.replaceChildren(...rows.map(([value, text]) => new Option(text, value)));
      list.value = chosen ?? '';
    };
    const has_slides = loaded.stops.length + loaded.chapters.length > 0;
    options('film-kind', [['mp4', 'MP4'], ['webm', 'WebM'], ['png', words.of('film_pictures')],
      ...(has_slides ? [/** @type {[string, string]} */ (['slides', words.of('film_slides')])] : []),
      // The workbench alone has what writes them.
      ...(has_slides && presentations.write ? [/** @type {[string, string]} */ (['pptx', 'PowerPoint (.pptx)'])] : [])]);
    options('film-quality', Object.keys(film_qualities).map((name) => [name, words.of(`quality_${name}`)]), 'lecture');
    const {chapters, stops} = loaded;
    const last = stops[stops.length - 1];
    // After a stop at the film's end, nothing follows.
    const has_rest = last && last.at_s < loaded.film_length_s - 1.5 / loaded.frames_per_s;
    options('film-span', [
      ['whole', words.of('film_whole')],
      ...chapters.map(({title}, k) => /** @type {[string, string]} */ ([`chapter ${k}`, `${k + 1}. ${title}`])),
      ...stops.map(({title}, k) => /** @type {[string, string]} */ ([`stop ${k}`, `→ ${words.of('stop')} ${k + 1} ${title}`])),
      ...(has_rest ? [/** @type {[string, string]} */ ([`stop ${stops.length}`, `→ ${words.of('end')}`])] : []),
    ]);
    input('film-width').value = String(loaded.film_width);
    input('film-height').value = String(loaded.film_height);
    input('film-rate').value = String(loaded.frames_per_s);
    this.#name();
    this.#hint();
  }

  #name() {
    const {words} = this.page;
    for (const [id, word] of [['film-kind', 'film_kind'], ['film-span', 'film_span'], ['film-width', 'width'], ['film-height', 'height'],
      ['film-rate', 'film_rate'], ['film-quality', 'film_quality']]) {
      const label = part(/** @type {string} */ (id)).closest('label')?.querySelector('span');
      if (label) label.textContent = words.of(/** @type {string} */ (word));
    }
    const heading = part('section-film').querySelector('h2');
    if (heading) heading.textContent = words.of('film_section');
    part('film-make').textContent = words.of('film_make');
    part('film-cancel').textContent = words.of('film_cancel');
    part('film-done').setAttribute('aria-label', words.of('film_section'));
  }

  /** @returns {FilmSettings} */
  settings() {
    const chosen = (/** @type {string} */ id) => /** @type {HTMLSelectElement} */ (part(id)).value;
    const [kind = 'whole', index = '0'] = chosen('film-span').split(' ');
    return {
      kind: /** @type {FilmKind} */ (chosen('film-kind')), quality: chosen('film-quality'),
      width: Math.round(input('film-width').valueAsNumber), height: Math.round(input('film-height').valueAsNumber), rate: input('film-rate').valueAsNumber,
      span: {kind: /** @type {FilmSpan['kind']} */ (kind), index: Number(index)},
    };
  }

  /** Says how long the film is and about how large. */
  #hint() {
    const {loaded} = this.page.figure;
    const {words} = this.page;
    if (!loaded) return;
    const {kind, width, height, rate, quality, span} = this.settings();
    const has_span = kind !== 'slides' && kind !== 'pptx';
    /** @type {HTMLSelectElement} */ (part('film-span')).disabled = !has_span;
    const from = !has_span ? 0 : span.kind === 'chapter' ? loaded.chapters[span.index]?.at_s ?? 0 : span.kind === 'stop' ? loaded.stops[span.index - 1]?.at_s ?? 0 : 0;
    const marks = !has_span ? undefined : span.kind === 'chapter' ? loaded.chapters[span.index + 1] : span.kind === 'stop' ? loaded.stops[span.index] : undefined;
    const length_s = Math.max(0, (marks?.at_s ?? loaded.film_length_s) - from);
    const number = (/** @type {number} */ x, /** @type {number} */ digits) => new Intl.NumberFormat(words.code, {maximumSignificantDigits: digits}).format(x);
    const camera = this.page.views.list().length > 0 ? ` ${words.of('film_camera')}` : '';
    const say = (/** @type {number} */ bytes, /** @type {string} */ relation) => {
      part('film-hint').textContent = !Number.isFinite(length_s) ? '' : `${number(length_s, 4)} s${Number.isFinite(bytes) ? `, ${relation} ${number(bytes / 1e6, 2)} MB` : ''}.${camera}`;
    };
    window.clearTimeout(this.estimate_timer);
    if (kind !== 'png') {
      say((length_s * bitrate_of(quality, {width, height, numerator: rate, denominator: 1})) / 8, '≲');
      return;
    }
    say(NaN, '');
    const timer = window.setTimeout(() => void this.#picture_bytes(width, height, from, length_s, () => timer === this.estimate_timer && !this.making)
      .then((bytes) => timer === this.estimate_timer && !this.making && say(bytes * Math.max(1, length_s * rate), '≈'), () => {}), estimate_after_ms);
    this.estimate_timer = timer;
  }

  /**
   * About how many bytes a picture takes: by three of the span, small ones for large pictures. Lines grow less than areas, as in films.
   * @param {number} width @param {number} height @param {number} from_s @param {number} length_s @param {() => boolean} goes_on
   */
  async #picture_bytes(width, height, from_s, length_s, goes_on) {
    const shrink = Math.min(1, Math.sqrt(most_sample_pixels / (width * height)));
    const [w = 16, h = 16] = [width, height].map((side) => Math.max(1, Math.round(side * shrink)));
    let sum = 0;
    for (const place of [1 / 6, 1 / 2, 5 / 6]) {
      await let_page_answer();
      if (!goes_on()) return NaN;
      const image = this.page.figure.image(from_s + place * length_s, w, h);
      sum += (await png_file(new Uint8Array(image.data.buffer), w, h, 'poinsot', '')).length;
    }
    return (sum / 3) * ((width * height) / (w * h)) ** 0.8 + record_bytes;
  }

  /** @param {string} text */
  #say(text) {
    part('film-message').textContent = text;
  }

  /** Makes a film and saves it; says what went wrong. @param {FilmSettings} settings @returns {Promise<Blob|null>} the film, where it is in memory */
  async make(settings) {
    const {page} = this;
    const {words} = page;
    // From the first press on, while the user chooses a file and the module starts.
    if (this.making) return null;
    const making = new AbortController();
    this.making = making;
    this.#busy(true);
    this.#say('');
    try {
      const scene = film_scene(page, settings);
      const [suffix] = film_files[settings.kind];
      check_size(settings, words);
      const file = await chosen_file(scene.name + suffix, settings.kind);
      if (file === undefined) return null;
      const {blob, remarks} = await make_film(page, scene, settings,
        {progress: (done, n_frames) => this.#progress(done, n_frames), signal: making.signal, began: (run) => { this.run = run; }, file});
      if (blob) page.save(blob, suffix, scene.name);
      this.#say([words.of('film_saved'), ...remarks].join(' '));
      return blob;
    } catch (error) {
      this.#say(message_of(error));
      return null;
    } finally {
      this.making = null;
      this.run = null;
      this.#busy(false);
    }
  }

  /** @param {number} done @param {number} n_frames */
  #progress(done, n_frames) {
    const bar = /** @type {HTMLProgressElement} */ (part('film-done'));
    bar.value = done / n_frames;
    if (done === 1) this.second_ms = performance.now();
    const left_s = done > 1 ? ((performance.now() - this.second_ms) / 1000 / (done - 1)) * (n_frames - done) : NaN;
    const left = Number.isFinite(left_s) ? `, ${this.page.words.of('film_left')} ${left_s < 90 ? `${Math.ceil(left_s)} s` : `${Math.ceil(left_s / 60)} min`}` : '';
    part('film-hint').textContent = `${done} / ${n_frames}${left}`;
  }

  /** @param {boolean} busy */
  #busy(busy) {
    part('film-done').hidden = !busy;
    /** @type {HTMLProgressElement} */ (part('film-done')).value = 0;
    part('film-cancel').hidden = !busy;
    part('film-make').hidden = busy;
    if (!busy) this.#hint();
  }
}
