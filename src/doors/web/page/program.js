// The program itself: the WebAssembly module poinsot.wasm, its calls of OpenGL as WebGL 2, and its
// functions with arguments and results of JavaScript. This file knows no page. A test compares the types of its results with the
// answers of the module.

/** @import {FilmTexts} from './film_file.js' */
/** @import {Grip} from './grips.js' */
/** @import {FilmDescription} from './make_film.js' */

/**
 * @typedef {{name: string, kind: string, x: number, y: number, width: number, height: number,
 *   has_view: boolean, azimuth_deg: number, elevation_deg: number, distance: number}} Panel
 *   A panel and the camera that the scene gives it; pixels of the canvas, y down.
 * @typedef {{panel: number, azimuth_deg?: number, elevation_deg?: number, roll_deg?: number,
 *   distance?: number, zoom?: number, shift_x?: number, shift_y?: number}} View
 *   How a viewer changed a panel's camera. The shifts move the picture to the right and up, in
 *   heights of the panel.
 * @typedef {{key: string, label: string, unit: string, kind: 'boolean'|'choice'|'integer'|'number'|'vector',
 *   value: boolean|number|string|number[], min: number|null, max: number|null, step: number|null, choices?: string[]}} Control
 * @typedef {{title: string, caption: string, language: string,
 *   theme: {name: string, background: string, text: string}, first_time_s: number,
 *   last_time_s: number, film_length_s: number, opens_at_s: number, loops: boolean, frames_per_s: number,
 *   width: number, height: number, film_width: number, film_height: number, motion: string, regime: string, next: string, flips: {one_s: number, interval_s: number|null, times_s?: number[]}|null,
 *   polhode_axis: 'smallest'|'largest'|null, drags: {omega: boolean, plane: boolean}, notes: string[],
 *   panels: Panel[], chapters: {at_s: number, title: string}[],
 *   stops: {at_s: number, title: string, loop_s: number|null, note: string, planned_s: number|null}[],
 *   controls: Control[], elements: {name: string, summary: string, overlay: boolean, offered: boolean, shown: boolean}[]}} Loaded
 *   Chapters, stops and opens_at_s are at seconds of the film; the other times are the motion's.
 * @typedef {{time_s: number, omega_body: number[], space_from_body: number[],
 *   herpolhode: number[], angles?: number[]}} Digits
 *   `angles`: θ, φ and ψ of a heavy top, rad.
 */

/** What the program refuses, with the place in the scene where there is one. */
export class ProgramError extends Error {
  /** @param {{kind: string, message: string, file?: string, line?: number, column?: number}} error */
  constructor(error) {
    super(error.message);
    this.name = 'ProgramError';
    /** 'scene', 'input', 'environment', 'no-webgl', 'no-wasm' or 'crash'. */
    this.kind = error.kind;
    this.file = error.file || '';
    this.line = error.line || 0;
    this.column = error.column || 0;
  }
}

/** Memory of the module; its views are made anew after it has grown. */
class ModuleMemory {
  constructor() {
    /** @type {WebAssembly.Memory|null} */
    this.memory = null;
    this.bytes = new Uint8Array(0);
    this.ints = new Int32Array(0);
  }

  /** @param {WebAssembly.Memory} memory */
  set(memory) {
    this.memory = memory;
    this.refresh();
  }

  refresh() {
    const {buffer} = /** @type {WebAssembly.Memory} */ (this.memory);
    if (this.bytes.buffer === buffer) return;
    this.bytes = new Uint8Array(buffer);
    this.ints = new Int32Array(buffer);
  }

  /** @param {number} at @param {number} size */
  text(at, size) {
    this.refresh();
    return new TextDecoder().decode(this.bytes.subarray(at, at + size));
  }

  /** A text that ends with a zero. @param {number} at */
  c_text(at) {
    this.refresh();
    return this.text(at, this.bytes.indexOf(0, at) - at);
  }

  /** @param {number} at @param {number} n */
  floats(at, n) {
    this.refresh();
    return new Float32Array(this.bytes.buffer, at, n);
  }

  /** @param {number} at @param {number} n @returns {number[]} */
  doubles(at, n) {
    this.refresh();
    return Array.from(new Float64Array(this.bytes.buffer, at, n));
  }

  /** Pixels for WebGL, by the type of a component; null for none. @param {number} at @param {number} type */
  pixels(at, type) {
    if (at === 0) return null;
    this.refresh();
    const {buffer} = this.bytes;
    if (type === 0x1406) return new Float32Array(buffer, at);
    if (type === 0x1403 || type === 0x140b) return new Uint16Array(buffer, at);
    return new Uint8Array(buffer, at);
  }
}

/**
 * The functions of OpenGL that the module imports. OpenGL numbers its objects, WebGL holds them.
 * @param {ModuleMemory} memory
 * @param {() => WebGL2RenderingContext} context
 */
function gl_functions(memory, context) {
  /** @type {any[]} */
  let objects = [null];
  /** @type {(WebGLUniformLocation|null)[]} */
  let locations = [];
  /** @param {any} object */
  const put = (object) => objects.push(object) - 1;
  /** @param {number} k */
  const take = (k) => {
    const object = objects[k];
    objects[k] = null;
    return object;
  };
  /** @param {(gl: WebGL2RenderingContext) => any} make */
  const makers = (make) => (/** @type {number} */ n, /** @type {number} */ at) => {
    for (let k = 0; k < n; ++k) {
      memory.refresh();
      memory.ints[(at >> 2) + k] = put(make(context()));
    }
  };
  /** @param {(gl: WebGL2RenderingContext, object: any) => void} remove */
  const removers = (remove) => (/** @type {number} */ n, /** @type {number} */ at) => {
    memory.refresh();
    for (let k = 0; k < n; ++k) remove(context(), take(memory.ints[(at >> 2) + k]));
  };
  /** @param {number} at @param {number} value */
  const store = (at, value) => {
    memory.refresh();
    memory.ints[at >> 2] = value;
  };
  /** @param {string} text @param {number} most @param {number} at */
  const store_text = (text, most, at) => {
    memory.refresh();
    const bytes = new TextEncoder().encode(text || '').subarray(0, most - 1);
    memory.bytes.set(bytes, at);
    memory.bytes[at + bytes.length] = 0;
  };
  /** @param {number} k */
  const location = (k) => (k < 0 ? null : locations[k]);
  /** @type {Record<string, (...given: any[]) => any>} */
  const functions = {
    glAttachShader: (program, shader) => context().attachShader(objects[program], objects[shader]),
    glBindBuffer: (target, k) => context().bindBuffer(target, objects[k]),
    glBindFramebuffer: (target, k) => context().bindFramebuffer(target, objects[k]),
    glBindRenderbuffer: (target, k) => context().bindRenderbuffer(target, objects[k]),
    glBindTexture: (target, k) => context().bindTexture(target, objects[k]),
    glBindVertexArray: (k) => context().bindVertexArray(objects[k]),
    glBufferData: (target, size, at, usage) => {
      memory.refresh();
      if (at === 0) context().bufferData(target, size, usage);
      else context().bufferData(target, memory.bytes.subarray(at, at + size), usage);
    },
    glCompileShader: (k) => context().compileShader(objects[k]),
    glCreateProgram: () => put(context().createProgram()),
    glCreateShader: (kind) => put(context().createShader(kind)),
    glDeleteBuffers: removers((gl, object) => gl.deleteBuffer(object)),
    glDeleteFramebuffers: removers((gl, object) => gl.deleteFramebuffer(object)),
    glDeleteProgram: (k) => context().deleteProgram(take(k)),
    glDeleteRenderbuffers: removers((gl, object) => gl.deleteRenderbuffer(object)),
    glDeleteShader: (k) => context().deleteShader(take(k)),
    glDeleteTextures: removers((gl, object) => gl.deleteTexture(object)),
    glDeleteVertexArrays: removers((gl, object) => gl.deleteVertexArray(object)),
    glDetachShader: (program, shader) => context().detachShader(objects[program], objects[shader]),
    glFramebufferRenderbuffer: (target, attachment, kind, k) =>
      context().framebufferRenderbuffer(target, attachment, kind, objects[k]),
    glFramebufferTexture2D: (target, attachment, kind, k, level) =>
      context().framebufferTexture2D(target, attachment, kind, objects[k], level),
    glGenBuffers: makers((gl) => gl.createBuffer()),
    glGenFramebuffers: makers((gl) => gl.createFramebuffer()),
    glGenRenderbuffers: makers((gl) => gl.createRenderbuffer()),
    glGenTextures: makers((gl) => gl.createTexture()),
    glGenVertexArrays: makers((gl) => gl.createVertexArray()),
    glGetIntegerv: (name, at) => store(at, context().getParameter(name)),
    glGetProgramInfoLog: (k, most, _, at) => store_text(context().getProgramInfoLog(objects[k]) || '', most, at),
    glGetProgramiv: (k, name, at) => store(at, Number(context().getProgramParameter(objects[k], name))),
    glGetShaderInfoLog: (k, most, _, at) => store_text(context().getShaderInfoLog(objects[k]) || '', most, at),
    glGetShaderiv: (k, name, at) => store(at, Number(context().getShaderParameter(objects[k], name))),
    glGetUniformLocation: (k, name) => {
      const found = context().getUniformLocation(objects[k], memory.c_text(name));
      return found ? locations.push(found) - 1 : -1;
    },
    glLinkProgram: (k) => context().linkProgram(objects[k]),
    glReadPixels: (x, y, width, height, format, type, at) =>
      context().readPixels(x, y, width, height, format, type, memory.pixels(at, type)),
    glShaderSource: (k, n, texts) => {
      memory.refresh();
      context().shaderSource(objects[k], memory.c_text(memory.ints[texts >> 2]));
    },
    glTexImage2D: (target, level, internal, width, height, border, format, type, at) =>
      context().texImage2D(target, level, internal, width, height, border, format, type,
                           /** @type {any} */ (memory.pixels(at, type))),
    glTexSubImage2D: (target, level, x, y, width, height, format, type, at) =>
      context().texSubImage2D(target, level, x, y, width, height, format, type,
                              /** @type {any} */ (memory.pixels(at, type))),
    glUniform1i: (k, value) => context().uniform1i(location(k), value),
    glUniform2fv: (k, n, at) => context().uniform2fv(location(k), memory.floats(at, 2 * n)),
    glUniform3fv: (k, n, at) => context().uniform3fv(location(k), memory.floats(at, 3 * n)),
    glUniform4fv: (k, n, at) => context().uniform4fv(location(k), memory.floats(at, 4 * n)),
    glUniformMatrix3fv: (k, n, transposed, at) =>
      context().uniformMatrix3fv(location(k), transposed !== 0, memory.floats(at, 9 * n)),
    glUniformMatrix4fv: (k, n, transposed, at) =>
      context().uniformMatrix4fv(location(k), transposed !== 0, memory.floats(at, 16 * n)),
    glUseProgram: (k) => context().useProgram(objects[k]),
  };
  // These take and return numbers alone.
  for (const name of [
    'ActiveTexture', 'BlendEquation', 'BlendFunc', 'BlitFramebuffer', 'CheckFramebufferStatus', 'Clear', 'ClearColor',
    'DepthFunc', 'Disable', 'DrawArrays', 'DrawElements', 'Enable', 'EnableVertexAttribArray', 'GenerateMipmap', 'GetError',
    'PixelStorei', 'RenderbufferStorage', 'Scissor', 'TexParameteri', 'VertexAttribPointer', 'Viewport',
  ]) {
    const called = name[0].toLowerCase() + name.slice(1);
    functions[`gl${name}`] = (...given) => /** @type {any} */ (context())[called](...given);
  }
  return {
    functions,
    forget() {
      objects = [null];
      locations = [];
    },
  };
}

/** The WebAssembly modules that were compiled, by their bytes. @type {WeakMap<object, Promise<WebAssembly.Module>>} */
const compiled_modules = new WeakMap();

/** A module of WebAssembly, and how its functions take and give texts, bytes and numbers. */
export class WasmModule {
  constructor() {
    /** @type {Record<string, any>} */
    this.exports = {};
    this.memory = new ModuleMemory();
    /** What the module wrote before it ended itself. */
    this.printed = '';
  }

  /** @param {WebAssembly.Module} module @param {Record<string, Record<string, any>>} imports */
  async instantiate(module, imports) {
    for (const {module: from, name} of WebAssembly.Module.imports(module)) {
      imports[from] = imports[from] || {};
      if (!imports[from][name]) imports[from][name] = this.#system(name);
    }
    const instance = await WebAssembly.instantiate(module, imports);
    this.exports = instance.exports;
    this.memory.set(this.exports.memory);
    this.exports.__wasm_call_ctors();
  }

  /** What the module's C library asks of a system: a clock, and nothing else. @param {string} name */
  #system(name) {
    const not_there = 52;
    /** @param {number[]} given */
    return (...given) => {
      this.memory.refresh();
      if (name === 'clock_time_get') {
        new DataView(this.memory.bytes.buffer).setBigUint64(given[2], BigInt(Math.round(1e6 * performance.now())), true);
        return 0;
      }
      if (name === 'environ_sizes_get') {
        this.memory.ints[given[0] >> 2] = 0;
        this.memory.ints[given[1] >> 2] = 0;
        return 0;
      }
      if (name === 'environ_get') return 0;
      if (name === 'fd_write') {
        // Messages of the C++ library before it ends the program.
        let written = 0;
        let text = '';
        for (let k = 0; k < given[2]; ++k) {
          const at = this.memory.ints[(given[1] >> 2) + 2 * k];
          const size = this.memory.ints[(given[1] >> 2) + 2 * k + 1];
          text += this.memory.text(at, size);
          written += size;
        }
        this.memory.ints[given[3] >> 2] = written;
        this.printed = text;
        return 0;
      }
      if (name === 'proc_exit') throw new WebAssembly.RuntimeError(`the program ended with ${given[0]}`);
      return not_there;
    };
  }

  /** Copies bytes into the module's memory. @param {Uint8Array} bytes */
  put(bytes) {
    const at = this.exports.take(bytes.length || 1);
    this.memory.refresh();
    this.memory.bytes.set(bytes, at);
    return at;
  }

  /** Passes texts and bytes to a function for the time of its call. @param {(Uint8Array|string)[]} items @param {(...at: number[]) => any} call */
  with_items(items, call) {
    const held = items.map((item) => {
      const bytes = typeof item === 'string' ? new TextEncoder().encode(item) : item;
      return [this.put(bytes), bytes.length];
    });
    try {
      return call(...held.flat());
    } finally {
      for (const [at] of held) this.exports.give_back(at);
    }
  }

  /** Calls a function of the module; throws what it refuses. @param {string} name @param {any[]} given @returns {any} */
  call(name, ...given) {
    try {
      if (this.exports[name](...given)) return undefined;
    } catch (error) {
      throw new ProgramError({kind: 'crash', message: this.printed || String(/** @type {Error} */ (error).message || error)});
    }
    throw new ProgramError(JSON.parse(this.answer()));
  }

  answer() {
    return this.memory.text(this.exports.answer_at(), this.exports.answer_size());
  }

  numbers() {
    return this.memory.doubles(this.exports.numbers_at(), this.exports.n_numbers());
  }
}

export class Program extends WasmModule {
  /**
   * Starts the program on a canvas; without one it computes and does not draw. Rejects with a
   * ProgramError of kind 'no-wasm' or 'no-webgl'.
   * @param {Uint8Array} module_bytes
   * @param {Uint8Array} font_bytes
   * @param {HTMLCanvasElement|OffscreenCanvas|null} canvas
   * @returns {Promise<Program>}
   */
  static async start(module_bytes, font_bytes, canvas) {
    const program = new Program(font_bytes);
    try {
      let compiled = compiled_modules.get(module_bytes);
      if (!compiled) {
        compiled = WebAssembly.compile(/** @type {any} */ (module_bytes));
        compiled_modules.set(module_bytes, compiled);
      }
      program.module = await compiled;
      await program.#instantiate();
    } catch (error) {
      throw new ProgramError({kind: 'no-wasm', message: String(/** @type {Error} */ (error).message || error)});
    }
    if (canvas) program.#open(canvas);
    return program;
  }

  /** @param {Uint8Array} font_bytes */
  constructor(font_bytes) {
    super();
    this.font_bytes = font_bytes;
    /** @type {WebAssembly.Module|null} */
    this.module = null;
    /** @type {WebGL2RenderingContext|null} */
    this.gl = null;
    /** @type {Map<string, Uint8Array>} */
    this.files = new Map();
    /** The scene that was loaded last. @type {{text: string, name: string, overrides: string[], width: number, height: number, type_scale?: number}|null} */
    this.last = null;
    this.imported = gl_functions(this.memory, () => /** @type {WebGL2RenderingContext} */ (this.gl));
    this.has_integer_light = false;
    /** The values of a view in the order in which the module takes them. @type {(keyof Omit<View, 'panel'>)[]} */
    this.view_names = [];
  }

  async #instantiate() {
    await this.instantiate(/** @type {WebAssembly.Module} */ (this.module),
      {gl: this.imported.functions, page: {has_integer_light: () => (this.has_integer_light ? 1 : 0)}});
    this.call('view_names');
    this.view_names = JSON.parse(this.answer());
    this.#add_fonts();
    for (const [name, bytes] of this.files) this.#add_file(name, bytes);
  }

  #add_fonts() {
    // Each font as a line "NAME N_BYTES" and its table.
    for (let rest = this.font_bytes; rest.length > 0;) {
      const line = rest.indexOf(10);
      const [name, size] = new TextDecoder().decode(rest.subarray(0, line)).split(' ');
      const table = rest.subarray(line + 1, line + 1 + Number(size));
      const named = new TextEncoder().encode(name);
      this.exports.add_font(this.put(named), named.length, this.put(table), table.length);
      rest = rest.subarray(line + 1 + Number(size));
    }
  }

  /** @param {string} name @param {Uint8Array} bytes */
  #add_file(name, bytes) {
    this.with_items([name, bytes], (...at) => this.exports.add_file(...at));
  }

  /** @param {HTMLCanvasElement|OffscreenCanvas} canvas */
  #open(canvas) {
    const gl = /** @type {WebGL2RenderingContext|null} */ (
      canvas.getContext('webgl2', {alpha: true, antialias: false, depth: false, stencil: false, premultipliedAlpha: true}));
    if (!gl) throw new ProgramError({kind: 'no-webgl', message: 'this browser has no WebGL 2'});
    this.gl = gl;
    this.#ask_extensions();
  }

  #ask_extensions() {
    const gl = /** @type {WebGL2RenderingContext} */ (this.gl);
    const floats = gl.getExtension('EXT_color_buffer_float') || gl.getExtension('EXT_color_buffer_half_float');
    this.has_integer_light = Boolean(gl.getExtension('EXT_texture_norm16'));
    if (!floats && !gl.isContextLost())
      throw new ProgramError({kind: 'no-webgl', message: 'this browser cannot draw into textures with 16 bits a component'});
  }

  /** Adds a file that the scene names, before it is loaded. @param {string} name @param {Uint8Array} bytes */
  addFile(name, bytes) {
    this.files.set(name, bytes);
    this.#add_file(name, bytes);
  }

  /**
   * Reads a scene. If it is refused, the scene before it stays.
   * @param {string} text
   * @param {string} name for messages
   * @param {string[]} overrides 'key=value', as for --set
   * @param {{width: number, height: number, type_scale?: number, theme?: string, language?: string, shown?: string[]}} options
   *   pixels of the canvas, and a factor on the size of all type
   * @returns {Loaded}
   */
  load(text, name, overrides, options) {
    const all = overrides.slice();
    if (options.theme) all.push(`theme=${JSON.stringify(options.theme)}`);
    if (options.language) all.push(`language=${JSON.stringify(options.language)}`);
    if (options.shown) all.push(`show=${JSON.stringify(options.shown)}`);
    // NUL ends an override, so that a value with NUL would set another key.
    if (all.some((item) => item.includes('\0'))) throw new Error('a value holds the character NUL; leave it out');
    const {width, height, type_scale = 1} = options;
    this.with_items([text, name, all.map((item) => `${item}\0`).join('')],
               (...at) => this.call('load', ...at, width, height, type_scale));
    this.last = {text, name, overrides: all, width, height, type_scale};
    return JSON.parse(this.answer());
  }

  /** After a crash: starts the module anew, with the scene that was loaded last. */
  async restart() {
    this.imported.forget();
    await this.#instantiate();
    if (!this.last) return;
    const {text, name, overrides, width, height, type_scale} = this.last;
    this.load(text, name, overrides, {width, height, type_scale});
  }

  /** Lays out anew. @param {number} width @param {number} height @param {number} [type_scale] @returns {Panel[]} */
  resize(width, height, type_scale = 1) {
    this.call('resize', width, height, type_scale);
    if (this.last) Object.assign(this.last, {width, height, type_scale});
    return JSON.parse(this.answer());
  }

  /** Replaces the viewers' changes of cameras; [] gives the scene's own back. @param {View[]} views */
  setViews(views) {
    const numbers = new Float64Array(views.flatMap((view) => [view.panel, ...this.view_names.map((name) => view[name] ?? NaN)]));
    this.with_items([new Uint8Array(numbers.buffer)], (at) => this.call('set_views', at, views.length));
  }

  /**
   * Draws an instant into the canvas. In this and the following functions, `film_s` is the second
   * of the film; without it, the first that shows the instant: a film may halt while elements fade.
   * @param {number} t @param {number} [film_s]
   * @param {number} [beside_later_s] by which the body beside the construction is ahead
   */
  draw(t, film_s = NaN, beside_later_s = 0) {
    if (!this.gl || this.gl.isContextLost()) return;
    this.call('draw', t, film_s, beside_later_s);
  }

  /** Computes what `draw` hands to WebGL, and nothing else; for measurements. @param {number} t */
  prepare(t) {
    this.call('prepare', t);
  }

  /** The instant that a second of the film shows. @param {number} film_s @returns {number} */
  timeAt(film_s) {
    return this.exports.time_at(film_s);
  }

  /** The first second of the film that shows an instant. @param {number} t @returns {number} */
  filmSecondAt(t) {
    return this.exports.film_second_at(t);
  }

  /** The digits of `poinsot sample`. @param {number} t @returns {Digits} */
  at(t) {
    this.call('at', t);
    const n = this.numbers();
    return {
      time_s: t,
      omega_body: n.slice(0, 3),
      space_from_body: n.slice(3, 7),
      herpolhode: n.slice(7, 10),
      ...(n.length > 10 && {angles: n.slice(10)}),
    };
  }

  /** The state as a sentence in the scene's language. @param {number} t @param {number} [film_s] @returns {string} */
  state(t, film_s = NaN) {
    this.call('state', t, film_s);
    return this.answer();
  }

  /** The instant as the text of an SVG file. @param {number} t @param {number} [film_s] @returns {string} */
  svg(t, film_s = NaN) {
    this.call('svg', t, film_s);
    return this.answer();
  }

  /**
   * A picture of any size: R, G, B and alpha of its pixels, not premultiplied.
   * @param {number} t @param {number} width @param {number} height @param {number} [film_s]
   * @returns {Uint8ClampedArray}
   */
  pixels(t, width, height, film_s = NaN) {
    this.call('pixels', t, film_s, width, height);
    const at = this.exports.answer_at();
    this.memory.refresh();
    return new Uint8ClampedArray(this.memory.bytes.slice(at, at + this.exports.answer_size()).buffer);
  }

  /**
   * Opens a film of a scene beside the figure; size, rate and quality are among the overrides.
   * @param {string} text @param {string} name @param {string[]} overrides @returns {FilmDescription}
   */
  openFilm(text, name, overrides) {
    if (overrides.some((item) => item.includes('\0'))) throw new Error('a value holds the character NUL; leave it out');
    this.with_items([text, name, overrides.map((item) => `${item}\0`).join('')], (...at) => this.call('open_film', ...at));
    return JSON.parse(this.answer());
  }

  /** The bytes of a film's frame: straight R, G, B and alpha, the planes Y', Cb and Cr on white, or not on white and followed by alpha. @param {number} frame @param {'pixels'|'planes'|'with alpha'} kind */
  filmFrame(frame, kind) {
    this.call('film_frame', frame, ['pixels', 'planes', 'with alpha'].indexOf(kind));
    const at = this.exports.answer_at();
    this.memory.refresh();
    return this.memory.bytes.slice(at, at + this.exports.answer_size());
  }

  /**
   * The record of a film's frames.
   * @param {[number, number]} span first and last frame @param {string} maker the browser and its encoder
   * @param {{packets?: string, file?: string}} [hashes] @param {0|1|2|3} [kind]
   *   A film, that of a slide, or the picture, of a slide or among others, that `filmFrame` has drawn last.
   */
  filmRecord(span, maker, {packets = '', file = ''} = {}, kind = 0) {
    const gl = /** @type {WebGL2RenderingContext} */ (this.gl);
    const texts = [`WebGL: ${gl.getParameter(gl.RENDERER)}`, maker, packets, file].map((text) => `${text}\0`);
    this.with_items([texts.join('')], (...at) => this.call('film_record', ...at, ...span, kind));
    return this.answer();
  }

  /** Language, chapters and captions of a film's frames. @param {[number, number]} span @param {string} name of the file @returns {FilmTexts} */
  filmTexts(span, name) {
    this.with_items([name], (...at) => this.call('film_texts', ...at, ...span));
    return JSON.parse(this.answer());
  }

  /** The text of slides.json, which lists its files by name and SHA-256. @param {[string, string][]} [hashes] */
  filmSlides(hashes = []) {
    this.with_items([hashes.map(([name, hash]) => `${name}\0${hash}\0`).join('')], (...at) => this.call('film_slides', ...at));
    return this.answer();
  }

  /** Holds the cameras of an instant, also for other values, or lets them go. @param {boolean} holds @param {number} t @param {number} [film_s] */
  hold(holds, t, film_s = NaN) {
    this.call('hold', t, film_s, Number(holds));
  }

  /**
   * What can be dragged, and where on the canvas: 'omega' at the tips of ω and of ρ, 'plane' where L meets the
   * invariable plane.
   * @param {number} t @param {number} [film_s]
   * @returns {Grip[]}
   */
  grips(t, film_s = NaN) {
    this.call('grips', t, film_s);
    return JSON.parse(this.answer());
  }

  /**
   * The start, at t = 0, of the free motion whose grip is at a pixel at this instant: ω in body axes, then the attitude
   * w, x, y, z. Null where the motion is not free.
   * @param {number} t @param {Grip} grip @param {number} x @param {number} y @param {number} [film_s]
   * @returns {{omega: number[], attitude: number[]}|null}
   */
  startAt(t, grip, x, y, film_s = NaN) {
    this.call('start_at', t, film_s, grip.panel, grip.thing === 'omega' ? 0 : 1, x, y);
    const start = this.numbers();
    return start.length === 7 ? {omega: start.slice(0, 3), attitude: start.slice(3)} : null;
  }

  /**
   * The components in body axes of the ω whose tip is seen at a pixel, with the energy of the instant.
   * @param {number} t @param {number} panel @param {number} x @param {number} y @param {number} [film_s]
   * @returns {number[]|null}
   */
  omegaAt(t, panel, x, y, film_s = NaN) {
    this.call('omega_at', t, film_s, panel, x, y);
    const omega = this.numbers();
    return omega.length === 3 ? omega : null;
  }

  /**
   * The kinetic energy with which the invariable plane, moved along L at constant |L|, meets L nearest to a pixel.
   * @param {number} t @param {number} panel @param {number} x @param {number} y @param {number} [film_s]
   * @returns {number|null}
   */
  energyAt(t, panel, x, y, film_s = NaN) {
    this.call('energy_at', t, film_s, panel, x, y);
    return this.numbers()[0] ?? null;
  }

  /** Gives the WebGL context back. The canvas cannot be drawn into any more. */
  stop() {
    const gl = this.gl;
    this.contextLost();
    this.gl = null;
    const lose = gl && gl.getExtension('WEBGL_lose_context');
    if (lose) lose.loseContext();
  }

  /** Call it when the canvas says webglcontextlost, after preventDefault. */
  contextLost() {
    if (this.gl) this.exports.lose_context();
    this.imported.forget();
  }

  /** Call it when the canvas says webglcontextrestored; then draw. */
  contextRestored() {
    this.#ask_extensions();
  }
}
