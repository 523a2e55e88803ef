// Films made in the page: MP4, WebM, slides, and pictures as a ZIP archive, of the frames that `poinsot render` draws.

import {input, part} from './bar.js';
import {message_of} from './figure.js';
import {AlphaPairs, FrameEncoder, bitrate_of, film_qualities, key_frame_interval, working_codec} from './film_encoder.js';
import {FilmFile, has_film_writer, load_film_writer} from './film_file.js';
import {bytes_of_base64} from './loader.js';
import {ZipWriter, joined_bytes, png_file} from './png_frames.js';
import {Program, ProgramError} from './program.js';
import {write_slides} from './slides.js';
/** @import {FilmKind} from './film_encoder.js' */
/** @import {FileSink, FilmContents, FilmHashes} from './film_file.js' */
/** @import {Page} from './page.js' */

/**
 * @typedef {{kind: FilmKind, width: number, height: number, rate: number, quality: string, span: FilmSpan}} FilmSettings
 * @typedef {{kind: 'whole'|'chapter'|'stop', index: number}} FilmSpan
 *   A chapter, or what leads to a stop: from the stop before it, or from the beginning. After the last stop: to the end.
 * @typedef {{title: string, width: number, height: number, numerator: number, denominator: number, n_frames: number,
 *   transparent: boolean, chapters: number[], stops: number[]}} FilmDescription
 *   The first frames of chapters and stops.
 */

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

/** The first and the last frame of a span. @param {FilmDescription} film @param {FilmSpan} span @returns {[number, number]} */
function frames_of_span(film, {kind, index}) {
  const last = film.n_frames - 1;
  if (kind === 'chapter') return [film.chapters[index] ?? 0, (film.chapters[index + 1] ?? film.n_frames) - 1];
  if (kind === 'stop') return [film.stops[index - 1] ?? 0, Math.min(film.stops[index] ?? last, last)];
  return [0, last];
}

class FilmCancelled extends Error {}

/** Makes one film; `progress` is called after each frame. */
export class FilmRun {
  /** @param {Program} program of its own @param {(done: number, n_frames: number) => void} progress */
  constructor(program, progress) {
    this.program = program;
    this.progress = progress;
    this.is_cancelled = false;
    /** Set where the browser takes the graphics away. */
    this.is_lost = false;
  }

  /** @param {number} done @param {number} n_frames */
  async go_on(done, n_frames) {
    this.progress(done, n_frames);
    await let_page_answer();
    if (this.is_cancelled) throw new FilmCancelled('cancelled');
    if (this.is_lost) throw new Error('lost');
  }

  /** Pictures of the frames in a ZIP archive. @param {FilmDescription} film @param {[number, number]} span @param {string} name @param {ZipWriter} zip @param {string} record */
  async pictures(film, [first, last], name, zip, record) {
    const digits = Math.max(4, String(last).length);
    for (let frame = first; frame <= last; ++frame) {
      const pixels = this.program.filmFrame(frame, 'pixels');
      await this.go_on(frame - first, last - first + 1);
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
const film_files = {
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

/** The section "Film" of the options. */
export class FilmSection {
  /** @param {Page} page */
  constructor(page) {
    this.page = page;
    /** @type {FilmRun|null} */
    this.run = null;
    /** Whether a film is made or about to be. */
    this.is_making = false;
    this.is_cancelled = false;
    this.signature = '';
    /** When the second frame began: the first one takes longer, as it compiles the shaders. */
    this.second_ms = 0;
    part('section-film').hidden = !has_film_writer();
    part('film-make').addEventListener('click', () => void this.make(this.settings()));
    part('film-cancel').addEventListener('click', () => {
      this.is_cancelled = true;
      if (this.run) this.run.is_cancelled = true;
    });
    for (const id of ['film-kind', 'film-span', 'film-width', 'film-height', 'film-rate', 'film-quality']) part(id).addEventListener('change', () => this.#hint());
    window.addEventListener('beforeunload', (event) => {
      if (this.is_making) event.preventDefault();
    });
  }

  /** Offers what the scene has. */
  show() {
    const {loaded} = this.page.figure;
    if (!loaded || !has_film_writer()) return;
    const {words} = this.page;
    const signature = JSON.stringify([words.code, loaded.film_width, loaded.film_height, loaded.frames_per_s, loaded.chapters, loaded.stops]);
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
    options('film-span', [
      ['whole', words.of('film_whole')],
      ...chapters.map(({title}, k) => /** @type {[string, string]} */ ([`chapter ${k}`, `${k + 1}. ${title}`])),
      ...stops.map(({title}, k) => /** @type {[string, string]} */ ([`stop ${k}`, `→ ${words.of('stop')} ${k + 1} ${title}`])),
      ...(stops.length > 0 ? [/** @type {[string, string]} */ ([`stop ${stops.length}`, `→ ${words.of('end')}`])] : []),
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
    // An estimate: a picture takes about a twentieth of its pixels' bytes.
    const bytes = kind === 'png' ? length_s * rate * width * height * 0.15
      : (length_s * bitrate_of(quality, {width, height, numerator: rate, denominator: 1})) / 8;
    const number = (/** @type {number} */ x, /** @type {number} */ digits) => new Intl.NumberFormat(words.code, {maximumSignificantDigits: digits}).format(x);
    const camera = this.page.views.list().length > 0 ? ` ${words.of('film_camera')}` : '';
    part('film-hint').textContent = Number.isFinite(bytes) ? `${number(length_s, 4)} s, ≲ ${number(bytes / 1e6, 2)} MB.${camera}` : '';
  }

  /** @param {string} text */
  #say(text) {
    part('film-message').textContent = text;
  }

  /** What a failure is in one sentence. @param {unknown} error */
  #sentence(error) {
    const {words} = this.page;
    if (error instanceof FilmCancelled) return words.of('film_cancelled');
    if (error instanceof DOMException && error.name === 'QuotaExceededError') return words.of('film_disk');
    // The module hears of the loss before the canvas does.
    if (this.run && (this.run.is_lost || this.run.program.gl?.isContextLost())) return words.of('film_lost');
    if (error instanceof ProgramError || error instanceof RangeError) return message_of(error);
    return `${words.of('film_failed')} ${message_of(error)}`;
  }

  /** Makes a film and saves it; says what went wrong. @param {FilmSettings} settings @returns {Promise<Blob|null>} the film, where it is in memory */
  async make(settings) {
    const {page} = this;
    const {words} = page;
    // From the first press on, while the user chooses a file and the module starts.
    if (this.is_making) return null;
    this.is_making = true;
    this.is_cancelled = false;
    this.#busy(true);
    this.#say('');
    /** @type {FileSink|null} */
    let sink = null;
    try {
      const [suffix, type] = film_files[settings.kind];
      const file = await chosen_file(`${page.data.name}${suffix}`, settings.kind);
      if (file === undefined) return null;
      // A context of its own: the figure may rest, or be given another scene.
      const canvas = document.createElement('canvas');
      const bytes = await page.program_bytes();
      const program = await Program.start(bytes.module, bytes.fonts, canvas);
      const run = new FilmRun(program, (done, n_frames) => this.#progress(done, n_frames));
      run.is_cancelled = this.is_cancelled;
      this.run = run;
      canvas.addEventListener('webglcontextlost', () => { run.is_lost = true; });
      for (const [name, text] of Object.entries(page.data.files)) program.addFile(name, bytes_of_base64(text));
      const film = program.openFilm(page.data.text, page.data.name, page.overrides(settings));
      const span = frames_of_span(film, settings.span);
      if (settings.kind !== 'png' && (film.width % 2 !== 0 || film.height % 2 !== 0)) throw new RangeError(words.of('film_even'));
      const {kind} = settings;
      const codec = kind === 'png' ? null : await working_codec(kind, film, settings.quality);
      if (kind !== 'png' && !codec) throw new RangeError(words.of('film_no_encoder'));
      if (kind !== 'png' && kind !== 'webm' && film.transparent) this.#say(words.of('film_opaque'));
      const how = codec ? `${codec.name} (${codec.config.codec}) by WebCodecs, ${codec.config.bitrate} bit/s` : 'PNG';
      const maker = `${navigator.userAgent}; ${how}`;
      /** @type {Blob|null} */
      let blob = null;
      sink = file ? await file.createWritable() : null;
      if (codec) await load_film_writer();
      if (codec && (kind === 'mp4' || kind === 'webm')) {
        const texts = program.filmTexts(span, page.data.name + suffix);
        const record = (/** @type {FilmHashes} */ hashes) => program.filmRecord(span, maker, hashes);
        const bytes = await run.video(film, span, {kind, codec, shape: film, texts, record}, sink);
        if (bytes) blob = new Blob([bytes], {type});
      } else {
        /** @type {Blob[]} */
        const parts = [];
        const memory = {write: async (/** @type {Uint8Array<ArrayBuffer>} */ part) => { parts.push(new Blob([part])); }};
        const zip = new ZipWriter((bytes) => (sink ?? memory).write(bytes));
        if (!codec) await run.pictures(film, span, page.data.name, zip, program.filmRecord(span, maker));
        else await (kind === 'pptx' && presentations.write ? presentations.write : write_slides)(run, film, codec, maker, zip);
        if (!sink) blob = new Blob(parts, {type});
      }
      await sink?.close();
      sink = null;
      if (blob) page.save(blob, suffix);
      this.#say([words.of('film_saved'), codec && settings.kind !== 'webm' && codec.codec !== 'avc' && `${words.of('film_no_h264')} ${codec.name}.`].filter(Boolean).join(' '));
      return blob;
    } catch (error) {
      this.#say(this.#sentence(error));
      // What is written so far lies under no name, and goes.
      await sink?.abort().catch(() => {});
      return null;
    } finally {
      this.run?.program.stop();
      this.run = null;
      this.is_making = false;
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
