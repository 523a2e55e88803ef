// The picture in the page: starts the program, draws when something changed, and only then.

import {Film} from './film.js';
import {bytes_of_base64} from './loader.js';
import {Program, ProgramError} from './program.js';
/** @import {SceneData} from './loader.js' */
/** @import {Loaded, View} from './program.js' */

const longest_step_s = 0.25; // between two frames: a hidden page does not jump
const most_pixels = 3840 * 2400;
const most_side_px = 16384; // of a picture as a file

/**
 * The factor on the size of all type with which a picture of this size, in CSS pixels, is easy to read: captions of 12 pixels or more, and
 * on an upright screen not more than a few words a line. @param {number} width @param {number} height
 */
function type_scale_of(width, height) {
  const caption_px = (26 / 1080) * height; // as the program sets it
  const most = Math.min(1, (0.038 * width) / caption_px);
  return Math.min(1.6, Math.max(12 / caption_px, most));
}

const most_enlarged = 2; // type of more than twice its size leaves no room for the figure

/** What went wrong, in words. @param {unknown} error */
export function message_of(error) {
  if (error && typeof error === 'object' && 'message' in error) return String(error.message);
  return String(error);
}

/**
 * What a viewer chose: overrides of the scene, elements, names and colours.
 * @typedef {{values: Map<string, string>, shown: string[]|null, names: boolean|null, theme: string}} Choices
 */

/** @returns {Choices} */
function no_choices() {
  return {values: new Map(), shown: null, names: null, theme: ''};
}

export class Figure {
  /**
   * @param {{stage: HTMLElement, picture: HTMLElement, poster: HTMLImageElement}} parts
   * @param {{drawn: () => void, loaded: () => void, failed: (kind: string, message: string) => void,
   *   bytes: () => Promise<{module: Uint8Array<ArrayBuffer>, fonts: Uint8Array<ArrayBuffer>}>}} hooks
   */
  constructor(parts, hooks) {
    this.parts = parts;
    this.hooks = hooks;
    /** @type {Program|null} */
    this.program = null;
    /** @type {Loaded|null} */
    this.loaded = null;
    // Any instant is within it until a scene is loaded.
    this.film = new Film({length_s: Infinity, frames_per_s: 30, loops: false, stops: [], chapters: []});
    /** @type {SceneData|null} */
    this.data = null;
    /** Those of the loaded scene; before the start, those of the address. */
    this.choices = no_choices();
    /** @type {View[]} */
    this.views = [];
    this.is_lost = false;
    this.frame = 0;
    this.last_ms = 0;
    /** By how many seconds the body beside the construction is ahead, while it turns alone; null: it does not. @type {number|null} */
    this.beside_s = null;
    this.is_resized = false;
    /** How far the browser has enlarged the page since it was opened. */
    this.enlarged = 1;
    /** That of the picture that is seen. */
    this.type_scale = 0;
    /** Whether the module has started anew and not drawn yet. */
    this.is_revived = false;
    /** Whether the module is starting anew; drawing fails until it has started. */
    this.is_reviving = false;
    /** Called before the next frame, at most once. @type {(() => void)|null} */
    this.before_next = null;
    new ResizeObserver(() => {
      this.is_resized = true;
      this.invalidate();
    }).observe(parts.picture);
    this.#watch_ratio();
  }

  /** A window that moves to another screen gets other pixels. */
  #watch_ratio() {
    const before = {ratio: window.devicePixelRatio, px: window.innerWidth * window.devicePixelRatio};
    const same = window.matchMedia(`(resolution: ${before.ratio}dppx)`);
    same.addEventListener('change', () => {
      // An enlarged page has the same pixels and a smaller layout; on another screen, the same layout.
      const {devicePixelRatio: ratio, innerWidth} = window;
      if (Math.abs((innerWidth * ratio) / before.px - 1) < 0.03) this.enlarged *= ratio / before.ratio;
      this.is_resized = true;
      this.invalidate();
      this.#watch_ratio();
    }, {once: true});
  }

  get canvas() {
    return /** @type {HTMLCanvasElement} */ (this.parts.picture.querySelector('canvas'));
  }

  /** Pixels of the canvas for one CSS pixel. */
  get ratio() {
    return this.canvas.width / Math.max(1, this.parts.picture.clientWidth);
  }

  /** The size of the picture in pixels of the screen. */
  size() {
    const {clientWidth, clientHeight} = this.parts.picture;
    const fit = Math.sqrt(most_pixels / Math.max(1, clientWidth * clientHeight));
    const ratio = Math.min(window.devicePixelRatio || 1, Math.max(fit, 0.1));
    return {width: Math.max(16, Math.round(clientWidth * ratio)), height: Math.max(16, Math.round(clientHeight * ratio)),
      type_scale: Math.min(most_enlarged, Math.max(1, this.enlarged) * type_scale_of(Math.max(16, clientWidth), Math.max(16, clientHeight)))};
  }

  /** Starts the program and draws the first picture. @param {() => SceneData} data_now @param {SceneData} known that the program accepts, where the other is refused */
  async start(data_now, known) {
    const {module, fonts} = await this.hooks.bytes();
    const program = await Program.start(module, fonts, this.canvas);
    // The workbench may have another text by now.
    const data = data_now();
    this.#watch_context(this.canvas);
    for (const [name, bytes] of Object.entries(data.files)) program.addFile(name, bytes_of_base64(bytes));
    this.program = program;
    this.is_lost = false;
    this.is_revived = false;
    try {
      this.#load(data, this.choices);
    } catch (error) {
      // A link may hold choices or a scene that the program refuses: the scene itself, or that of the page, is shown then.
      try {
        this.#load(data, no_choices());
      } catch (refusal) {
        if (data.text === known.text) throw refusal;
        this.#load(known, no_choices());
      }
      this.hooks.failed('draw', message_of(error));
    }
    this.#draw();
  }

  /** Gives the graphics context back and leaves the last picture. */
  rest() {
    if (!this.program) return;
    this.film.pause();
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    const old = this.canvas;
    if (!this.is_lost) this.#draw();
    const last = /** @type {HTMLImageElement} */ (this.parts.picture.querySelector('#last'));
    last.src = old.toDataURL('image/png');
    last.hidden = false;
    this.program.stop();
    this.program = null;
    // A canvas keeps its lost context: the next start needs a new one.
    const fresh = /** @type {HTMLCanvasElement} */ (old.cloneNode(false));
    old.replaceWith(fresh);
  }

  /** @param {HTMLCanvasElement} canvas */
  #watch_context(canvas) {
    canvas.addEventListener('webglcontextlost', (event) => {
      if (canvas !== this.canvas || !this.program) return;
      event.preventDefault();
      this.program.contextLost();
      this.is_lost = true;
      this.hooks.failed('lost', '');
    });
    canvas.addEventListener('webglcontextrestored', () => {
      if (canvas !== this.canvas || !this.program) return;
      this.program.contextRestored();
      this.is_lost = false;
      this.hooks.loaded();
      this.invalidate();
    });
  }

  /** Reads the scene with these choices; throws the program's refusal. @param {SceneData} data @param {Choices} choices */
  #load(data, choices) {
    const program = /** @type {Program} */ (this.program);
    const {width, height, type_scale} = this.size();
    const overrides = [...data.overrides, ...[...choices.values].map(([key, value]) => `${key}=${value}`)];
    if (choices.names !== null) overrides.push(`labels=${choices.names}`);
    // An empty list would show what the scene shows by default.
    const shown = choices.shown?.length === 0 ? ['title'] : choices.shown;
    if (choices.shown?.length === 0) overrides.push('overlays=false');
    this.loaded = program.load(data.text, data.name, overrides, {
      width, height, type_scale, theme: choices.theme || undefined, shown: shown ?? undefined,
    });
    this.data = data;
    this.choices = choices;
    // Setting the size of a canvas clears it, so only a scene that will be drawn does.
    if (this.canvas.width !== width) this.canvas.width = width;
    if (this.canvas.height !== height) this.canvas.height = height;
    this.is_resized = false;
    program.setViews(this.views);
    const {loaded} = this;
    this.film.change({
      length_s: loaded.film_length_s, frames_per_s: loaded.frames_per_s, loops: loaded.loops,
      stops: loaded.stops, chapters: loaded.chapters,
    });
    // Where the scene is seen first, until somebody moves the film.
    if (this.film.untouched && loaded.opens_at_s > 0) this.film.at_s = loaded.opens_at_s;
    this.hooks.loaded();
  }

  /** Reads the scene with changed choices; after a refusal the picture stays as it was. Throws the refusal. @param {Partial<Choices>} changes @param {SceneData|null} [data] another scene */
  reload(changes, data = this.data) {
    if (!this.program || !data) throw new Error('the figure has not started');
    try {
      this.#load(data, {...this.choices, ...changes});
    } catch (error) {
      this.#revive(error);
      throw error;
    }
    this.invalidate();
  }

  /** After a crash the module starts anew, with the scene that it had. @param {unknown} error */
  #revive(error) {
    if (!(error instanceof ProgramError) || error.kind !== 'crash') return;
    if (this.is_reviving) return;
    this.is_reviving = true;
    const program = /** @type {Program} */ (this.program);
    program.restart().then(() => {
      program.setViews(this.views);
      this.is_revived = true;
      this.invalidate();
    }, () => this.#give_up(error)).finally(() => { this.is_reviving = false; });
  }

  /** @param {unknown} error */
  #give_up(error) {
    this.program = null;
    this.hooks.failed('no-start', message_of(error));
  }

  /** The motion's time at a second of the film. @param {number} film_s */
  time_of(film_s) {
    return this.program && this.loaded ? this.program.timeAt(film_s) : 0;
  }

  /** The second of the film that shows a time of the motion: the nearest where none does. @param {number} time_s */
  film_second_of(time_s) {
    const length_s = this.loaded?.film_length_s ?? 0;
    if (!this.program || !(time_s > this.time_of(0))) return 0;
    return time_s >= this.time_of(length_s) ? length_s : this.program.filmSecondAt(time_s);
  }

  get time_s() {
    return this.time_of(this.film.at_s);
  }

  /** @param {View[]} views */
  set_views(views) {
    this.views = views;
    this.program?.setViews(views);
    this.invalidate();
  }

  /** Asks for a frame. Without a request none is drawn. */
  invalidate() {
    if (this.frame === 0 && this.program) this.frame = requestAnimationFrame((ms) => this.#tick(ms));
  }

  /** @param {number} ms */
  #tick(ms) {
    this.frame = 0;
    if (!this.program || !this.loaded || this.is_lost) return;
    const step_s = this.last_ms > 0 ? Math.min((ms - this.last_ms) / 1000, longest_step_s) : 0;
    this.before_next?.();
    this.before_next = null;
    this.film.advance(step_s);
    if (this.beside_s !== null) this.beside_s += step_s;
    try {
      this.#draw();
      this.is_revived = false;
    } catch (error) {
      this.film.pause();
      if (this.is_revived) {
        // It would crash again and again.
        this.#give_up(error);
        return;
      }
      this.#revive(error);
      this.hooks.failed('draw', message_of(error));
    }
    const goes_on = this.film.playing || this.beside_s !== null;
    this.last_ms = goes_on ? ms : 0;
    if (goes_on) this.invalidate();
  }

  #draw() {
    const {program} = this;
    if (!program || !this.loaded) return;
    if (this.is_resized) {
      const {width, height, type_scale} = this.size();
      this.is_resized = false;
      if (width !== this.canvas.width || height !== this.canvas.height || type_scale !== this.type_scale) {
        this.type_scale = type_scale;
        this.canvas.width = width;
        this.canvas.height = height;
        this.loaded.panels = program.resize(width, height, type_scale);
      }
    }
    program.draw(this.time_s, this.film.at_s, this.beside_s ?? 0);
    this.hooks.drawn();
  }

  /** The picture of a second of film. @param {number} film_s @param {number} width @param {number} height */
  image(film_s, width, height) {
    const pixels = /** @type {Program} */ (this.program).pixels(this.time_of(film_s), width, height, film_s);
    return new ImageData(new Uint8ClampedArray(pixels), width, height);
  }

  /** A picture of this instant as a file. @param {number} width @param {number} height @param {string} [type] @returns {Promise<Blob>} */
  async png(width, height, type = 'image/png') {
    const {program} = this;
    if (!program) throw new Error('the figure has not started');
    if (![width, height].every((side) => Number.isInteger(side) && side >= 1 && side <= most_side_px))
      throw new RangeError(`a picture of ${width} × ${height} pixels: give two whole numbers from 1 to ${most_side_px}`);
    const image = this.image(this.film.at_s, width, height);
    const canvas = document.createElement('canvas');
    canvas.width = width;
    canvas.height = height;
    /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d')).putImageData(image, 0, 0);
    return new Promise((resolve, reject) => {
      canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('the browser made no picture'))), type, 0.85);
    });
  }
}
