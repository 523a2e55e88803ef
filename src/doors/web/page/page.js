// The page: joins the figure with its controls, tells screen readers, and decides when the figure starts and rests.

import {Address} from './address.js';
import {Bar, part, save_as} from './bar.js';
import {Figure, message_of} from './figure.js';
import {Grips} from './grips.js';
import {action_of, is_for_field} from './keys.js';
import {add_texts, bytes_of_base64, scene_data, unpacked} from './loader.js';
import {Notes} from './notes.js';
import {Options} from './options.js';
import {ProgramError} from './program.js';
import {Views} from './view.js';
import {Words} from './words.js';
/** @import {Choices} from './figure.js' */
/** @import {DraggedValues} from './grips.js' */
/** @import {SceneData} from './loader.js' */

/**
 * @typedef {{value: (key: string) => string|null, write: (changes: Map<string, string|null>) => void, open_link: (choices: Choices) => void,
 *   link: () => {scene: string, text: string}, link_fault: () => Promise<string>}} ValueStore
 *   `write` throws the program's refusal; null takes a key away. `link`: the scene of a link, by its name or by its packed text; `link_fault`:
 *   what a link cannot hold of the scene, in a sentence.
 */

const idle_after_ms = 2500;
const settled_after_ms = 400;

export class Page {
  constructor() {
    this.data = scene_data();
    /** The scenes that this page shows, one after the other. */
    this.scenes = [this.data, ...this.data.following];
    /** Which of them it shows. */
    this.place = 0;
    this.words = new Words(this.data.language);
    /** Whether the words have a language of their own, not the scene's. */
    this.has_language = false;
    this.embedded = window.self !== window.top;
    /** @type {Promise<void>|null} */
    this.starting = null;
    this.failure = '';
    /** The module is unpacked once. @type {Promise<{module: Uint8Array<ArrayBuffer>, fonts: Uint8Array<ArrayBuffer>}>|null} */
    this.bytes = null;
    this.figure = new Figure(
      {stage: part('stage'), picture: part('picture'), poster: /** @type {HTMLImageElement} */ (part('poster'))},
      {
        bytes: () => this.program_bytes(),
        drawn: () => this.#drawn(),
        loaded: () => this.#loaded(),
        failed: (kind, message) => (kind === 'draw' ? this.show_message(message) : this.#fail(kind, message)),
      });
    const words = () => this.words;
    this.bar = new Bar(this.figure, words, {changed: () => this.changed(), next: () => this.next(), previous: () => this.previous()});
    this.views = new Views(part('views'), {
      changed: () => {
        this.grips.let_go();
        this.figure.set_views(this.views.list());
        this.#settle();
      },
      hovered: (x, y, panel) => this.grips.at(x, y, panel) !== null,
      picked: (x, y, panel) => this.grips.take(x, y, panel),
      dragged: (x, y) => this.grips.drag(x, y),
      dropped: () => {
        this.grips.drop();
        this.#settle();
      },
      touched: () => document.body.classList.add('begun'),
      words,
      zooms_by_wheel: () => !this.embedded || document.body.classList.contains('begun'),
    });
    this.grips = new Grips(this.figure, part('views'), {
      drags: (thing) => this.drags(thing),
      set_soon: (key, value) => this.set_soon(key, value),
      words,
      values: (keys) => new Map(keys.map((key) => [key, this.store ? this.store.value(key) : this.figure.choices.values.get(key) ?? null])),
      take_back: (values) => this.#take_back(values),
      lasts: () => this.store !== null,
    });
    this.address = new Address(this);
    this.options = new Options(this);
    this.notes = new Notes(part('notes'), words, (event) => this.#key(event), (film_s) => {
      const {program, loaded, is_lost} = this.figure;
      return program && loaded && !is_lost ? this.figure.image(film_s, 480, Math.round((480 * loaded.film_height) / loaded.film_width)) : null;
    }, () => {
      // The scene that runs may have another number of stops than when the page was written.
      const stops = this.scenes.map((scene, k) => (k === this.place ? this.figure.film.plan.stops.length : scene.n_stops));
      const sum = (/** @type {number[]} */ counts) => counts.reduce((all, count) => all + count, 0);
      return {n_stops_before: sum(stops.slice(0, this.place)), n_stops: sum(stops), planned_before_s: sum(this.scenes.slice(0, this.place).map((scene) => scene.planned_s)), title: this.figure.loaded?.title ?? '', next_title: this.scenes[this.place + 1]?.title ?? ''};
    });
    /** What keeps values, the text of the workbench; null: they are choices of this visit. @type {ValueStore|null} */
    this.store = null;
    /** Called after a scene is loaded. @type {() => void} */
    this.on_loaded = () => {};
    /** Values that are set at the next frame. @type {Map<string, string>} */
    this.coming = new Map();
    this.idle_timer = 0;
    this.settle_timer = 0;
    document.body.classList.toggle('embedded', this.embedded);
    this.#colour(document.documentElement.dataset['ground'] ?? '#ffffff', null);
    this.figure.choices = this.address.read();
    /** Until it is over, a page of several scenes has no texts; those may set colours, which the system's then do not replace. */
    this.texts = add_texts(this.scenes).then(() => {
      if (this.scenes.length > 1) this.figure.choices = this.address.read();
    });
    this.#name();
    this.#wire();
    this.fit();
  }

  /** The module and its fonts. */
  program_bytes() {
    return (this.bytes ??= Promise.all([unpacked('program-module'), unpacked('program-fonts')]).then(([module, fonts]) => ({module, fonts})));
  }

  // ── Starting and resting ────────────────────────────────────────────────────────────────

  /** Starts the figure if it does not run. @returns {Promise<void>} */
  start() {
    if (this.figure.program) return Promise.resolve();
    this.starting ??= this.#start().finally(() => { this.starting = null; });
    return this.starting;
  }

  async #start() {
    part('begin').hidden = true;
    // Here already, so that the picture keeps its size.
    part('bar').hidden = false;
    part('bar').inert = true;
    part('sentence').hidden = true;
    try {
      await this.texts;
      await this.figure.start(() => this.data, /** @type {SceneData} */ (this.scenes[0]));
      this.data = this.figure.data ?? this.data;
    } catch (error) {
      const kind = error instanceof ProgramError && error.kind.startsWith('no-') ? error.kind : 'no-start';
      this.figure.program = null;
      this.#fail(kind, message_of(error));
      throw error instanceof Error ? error : new Error(message_of(error));
    }
    this.failure = '';
    part('bar').inert = false;
    this.#wake();
  }

  /** @param {string} kind @param {string} [detail] */
  #fail(kind, detail = '') {
    this.failure = kind;
    const names = /** @type {Record<string, string>} */ ({'no-webgl': 'no_webgl', 'no-wasm': 'no_wasm', lost: 'lost'});
    const sentence = this.words.of(names[kind] ?? 'no_start');
    part('sentence').textContent = kind === 'no-start' && detail ? `${sentence} ${detail}` : sentence;
    part('sentence').hidden = false;
    document.body.classList.remove('drawn');
    if (kind !== 'lost') {
      part('bar').hidden = true;
      this.options.open(false);
    }
  }

  /** Starts embedded figures when they are in sight, and lets them rest when they are not. */
  watch_sight() {
    if (!this.embedded) {
      this.start().catch(() => {});
      return;
    }
    if (this.figure.film.untouched) this.figure.film.at_s = this.data.poster_at_s;
    part('begin').hidden = false;
    let timer = 0;
    let seen = false;
    const rest = () => {
      if (seen || !this.figure.program) return;
      this.figure.rest();
      document.body.classList.remove('drawn');
    };
    new IntersectionObserver((entries) => {
      seen = entries[entries.length - 1]?.isIntersecting ?? false;
      window.clearTimeout(timer);
      timer = window.setTimeout(() => {
        if (seen && !this.failure) this.start().catch(() => {});
        else if (this.starting) this.starting.then(rest, () => {});
        else rest();
      }, seen ? 120 : 400);
    }, {threshold: 0.05}).observe(part('stage'));
  }

  // ── What the program says ───────────────────────────────────────────────────────────────

  #loaded() {
    const {loaded} = this.figure;
    if (!loaded) return;
    if (!this.has_language) this.#take_words(loaded.language);
    this.#colour(loaded.theme.background, loaded.theme.text);
    this.bar.mark();
    const following = this.scenes[this.place + 1];
    if (following || (loaded.next && !this.embedded)) {
      part('onward').setAttribute('href', following ? `#scene=${encodeURIComponent(following.name)}` : encodeURIComponent(loaded.next));
      part('onward').textContent = `${this.words.of('next')}: ${following?.title || loaded.next.slice(0, -5).replaceAll('_', ' ')}`;
    }
    if (this.scenes.length > 1) {
      document.title = loaded.title;
      this.figure.canvas.setAttribute('aria-label', loaded.title);
    }
    this.views.place(loaded.panels, this.figure.ratio);
    this.options.show(loaded);
    this.fit();
    if (this.failure === 'lost' && !this.figure.is_lost) {
      this.failure = '';
      part('sentence').hidden = true;
    }
    this.on_loaded();
  }

  /** Speaks one language whatever that of the scene. @param {string} language */
  speak(language) {
    this.has_language = true;
    this.#take_words(language);
  }

  /** @param {string} language */
  #take_words(language) {
    if (this.words.code === language) return;
    this.words = new Words(language);
    document.documentElement.lang = this.words.code;
    this.#name();
  }

  /** Whether the film is over and another scene or page follows. */
  #at_end() {
    const {loaded, film} = this.figure;
    return film.is_over && (this.place + 1 < this.scenes.length || (Boolean(loaded?.next) && !this.embedded));
  }

  /** Takes one of the page's scenes, by its name, for the next time that it is read; '' is the first. @param {string} name */
  take_scene(name) {
    const place = name ? this.scenes.findIndex((scene) => scene.name === name) : 0;
    if (place < 0 || this.scenes[place] === this.data || this.scenes.length === 1) return;
    this.place = place;
    this.data = /** @type {SceneData} */ (this.scenes[place]);
  }

  /** Shows another of the page's scenes, from its beginning or at its end. Full screen, notes and look stay. @param {number} place @param {boolean} at_end */
  show_scene(place, at_end) {
    const data = this.scenes[place];
    const {figure} = this;
    if (!data || !figure.program) return;
    this.grips.let_go();
    this.grips.forget();
    this.take_scene(data.name);
    for (const [name, bytes] of Object.entries(data.files)) figure.program.addFile(name, bytes_of_base64(bytes));
    this.views.reset();
    const {film} = figure;
    film.pause();
    film.seek(0);
    film.untouched = true;
    try {
      figure.reload({values: new Map(), shown: null}, data);
    } catch (error) {
      this.show_message(error);
      return;
    }
    if (at_end) film.seek(film.plan.length_s);
    part('sentence').hidden = true;
    this.#settle();
    this.changed();
  }

  #drawn() {
    document.body.classList.add('drawn');
    const {loaded, film} = this.figure;
    if (loaded && this.views.panels !== loaded.panels) this.views.place(loaded.panels, this.figure.ratio);
    this.bar.show();
    part('onward').hidden = !this.#at_end();
    this.notes.show(film);
    this.grips.show();
    document.body.classList.toggle('playing', film.playing);
    if (!film.playing) this.#settle();
  }

  /** After the last change: says the state to screen readers, and keeps it in the address. */
  #settle() {
    window.clearTimeout(this.settle_timer);
    this.settle_timer = window.setTimeout(() => {
      const {figure} = this;
      if (!figure.program || figure.film.playing) return;
      const state = figure.program.state(figure.time_s, figure.film.at_s);
      if (part('state').textContent !== state) part('state').textContent = state;
      this.address.keep();
    }, settled_after_ms);
  }

  /** The page follows the ground of the picture. @param {string} ground @param {string|null} text */
  #colour(ground, text) {
    if (!/^#[0-9a-f]{6}$/i.test(ground)) return;
    const [r = 0, g = 0, b = 0] = [1, 3, 5].map((i) => parseInt(ground.slice(i, i + 2), 16));
    const dark = 0.2126 * r + 0.7152 * g + 0.0722 * b < 128;
    const root = document.documentElement;
    root.classList.toggle('dark', dark);
    root.style.setProperty('--ground', ground);
    root.style.setProperty('--text', text ?? (dark ? '#e8eaf0' : '#1b1d22'));
  }

  // ── Values ──────────────────────────────────────────────────────────────────────────────

  /** Sets a value before the next frame. @param {string} key @param {string} value */
  set_soon(key, value) {
    this.coming.set(key, value);
    this.figure.before_next = () => {
      const coming = this.coming;
      this.coming = new Map();
      try {
        this.set(coming);
      } catch (error) {
        const last = [...coming.keys()].pop() ?? '';
        this.options.controls.show_message(last, message_of(error));
      }
    };
    this.figure.invalidate();
  }

  /** The overrides of a film as it is chosen now. @param {{width: number, height: number, rate: number, quality: string}} film @returns {string[]} */
  overrides({width, height, rate, quality}) {
    const {values, names, theme, shown} = this.figure.choices;
    return [...this.data.overrides, ...[...values].map(([key, value]) => `${key}=${value}`),
      ...(names === null ? [] : [`labels=${names}`]), ...(theme ? [`theme=${JSON.stringify(theme)}`] : []),
      ...(shown ? [`show=${JSON.stringify(shown.length > 0 ? shown : ['title'])}`] : []), ...(shown?.length === 0 ? ['overlays=false'] : []),
      `film.size=${width}x${height}`, `film.fps=${rate}`, `film.quality=${quality}`];
  }

  /** Sets values as --set does; throws the program's refusal. @param {Map<string, string>} changes */
  set(changes) {
    if (this.store) this.store.write(changes);
    else this.figure.reload({values: new Map([...this.figure.choices.values, ...changes])});
    this.#settle();
  }

  /** @param {DraggedValues} values */
  #take_back(values) {
    if (this.store) {
      this.store.write(values);
      return;
    }
    const all = new Map(this.figure.choices.values);
    for (const [key, value] of values) {
      if (value === null) all.delete(key);
      else all.set(key, value);
    }
    this.reload({values: all});
  }

  /** Reads the scene with changed choices; shows the message if the program refuses. @param {Partial<Choices>} changes */
  reload(changes) {
    try {
      this.figure.reload(changes);
      part('sentence').hidden = !this.failure;
    } catch (error) {
      this.show_message(error);
      this.options.show_elements();
    }
    this.#settle();
  }

  /** Whether viewers may drag the tip of ω, or the plane. @param {string} thing */
  drags(thing) {
    const {loaded} = this.figure;
    return loaded !== null && (thing === 'plane' ? loaded.drags.plane : loaded.drags.omega);
  }

  /** Puts the words of the language on the page. */
  #name() {
    part('bar').setAttribute('aria-label', this.words.of('figure'));
    this.bar.name();
    this.options.name();
  }

  /** Offers a file for download. @param {Blob} blob @param {string} suffix @param {string} [name] by default, the scene's */
  save(blob, suffix, name = this.data.name) {
    save_as(blob, name + suffix);
  }

  // ── Size ────────────────────────────────────────────────────────────────────────────────

  /** The picture fills the stage; on a small screen held upright, what the options leave of it. */
  fit() {
    const {clientWidth, clientHeight} = part('stage');
    const upright = clientHeight > clientWidth && clientWidth < 640;
    const free = upright && this.options.is_open ? clientHeight - part('options').clientHeight : clientHeight;
    part('picture').style.height = `${free}px`;
  }

  // ── Events ──────────────────────────────────────────────────────────────────────────────

  /** After the film was moved or started. */
  changed() {
    this.#wake();
    this.figure.invalidate();
    this.bar.show();
  }

  #wake() {
    document.body.classList.remove('idle');
    window.clearTimeout(this.idle_timer);
    if (!this.figure.film.playing) return;
    this.idle_timer = window.setTimeout(() => {
      const busy = this.options.is_open || !part('speeds').hidden || part('bar').matches(':hover') || part('bar').querySelector(':focus-visible');
      document.body.classList.toggle('idle', this.figure.film.playing && !busy);
    }, idle_after_ms);
  }

  #wire() {
    part('begin').addEventListener('click', () => {
      this.start().then(() => {
        this.figure.film.play();
        this.changed();
      }, () => {});
    });
    part('say').addEventListener('click', () => this.notes.toggle());
    part('onward').addEventListener('click', (event) => {
      if (this.place + 1 >= this.scenes.length) return;
      event.preventDefault();
      this.show_scene(this.place + 1, false);
    });
    part('blank').addEventListener('pointerdown', () => this.blank(''));
    part('stage').addEventListener('click', () => {
      if (!this.figure.program && this.failure !== 'no-webgl' && this.failure !== 'no-wasm') this.start().catch(() => {});
      else if (this.failure === 'lost') this.#restart();
    });
    document.addEventListener('keydown', (event) => this.#key(event));
    for (const name of ['pointermove', 'pointerdown', 'keydown', 'focusin']) document.addEventListener(name, () => this.#wake(), {passive: true});
    document.addEventListener('visibilitychange', () => { this.figure.last_ms = 0; });
    const sizes = new ResizeObserver(() => this.fit());
    sizes.observe(part('stage'));
    sizes.observe(part('options'));
    window.addEventListener('hashchange', () => {
      const {data} = this;
      let choices = this.address.read();
      if (this.figure.program && this.data !== data) {
        this.show_scene(this.place, false);
        choices = this.address.read();
      }
      if (this.store) this.store.open_link(choices);
      else if (this.figure.program) this.reload(choices);
      else this.figure.choices = choices;
    });
  }

  /** @param {unknown} error */
  show_message(error) {
    part('sentence').textContent = message_of(error);
    part('sentence').hidden = false;
  }

  /** Starts again after a lost context that the browser does not give back. */
  #restart() {
    this.figure.program?.stop();
    this.figure.program = null;
    this.figure.is_lost = false;
    const old = this.figure.canvas;
    old.replaceWith(old.cloneNode(false));
    this.start().catch(() => {});
  }

  svg() {
    const {program} = this.figure;
    if (!program) throw new Error('the figure has not started');
    return program.svg(this.figure.time_s, this.figure.film.at_s);
  }

  /** Acts on a key of the page; all others go to the page around this one. @param {KeyboardEvent} event */
  #key(event) {
    if (!part('blank').hidden) {
      this.blank('');
      event.preventDefault();
      return;
    }
    if (event.key === 'Escape' && this.#escape()) return;
    if (is_for_field(event) || event.ctrlKey || event.metaKey) return;
    const act = this.figure.program ? action_of(event) : undefined;
    if (act && act(this) !== false) {
      this.changed();
      event.preventDefault();
    } else if (this.embedded) {
      const {key, code, shiftKey, altKey, repeat} = event;
      window.parent.postMessage({type: 'poinsot-key', key, code, shiftKey, altKey, repeat}, '*');
    }
  }

  /** Closes what is open; false: nothing was. */
  #escape() {
    if (!part('speeds').hidden) this.bar.close_speeds();
    else if (this.options.is_open) this.options.open(false);
    else return this.grips.take_back();
    return true;
  }

  /** To the next stop or chapter; from the end of the film to the next scene or page. */
  next() {
    if (this.#at_end()) part('onward').click();
    else this.figure.film.next();
  }

  /** To the stop or chapter before; from the beginning of the film to the end of the scene before. */
  previous() {
    const {film} = this.figure;
    if (this.place > 0 && (film.untouched || film.at_s <= 0) && !film.playing) this.show_scene(this.place - 1, true);
    else film.previous();
  }

  /** Covers the page, as presenters' remotes and slide programs do; '' shows it again. @param {string} colour */
  blank(colour) {
    const cover = part('blank');
    cover.hidden = colour === '';
    cover.style.background = colour;
  }
}
