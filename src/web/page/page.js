// The page: options, keys, link, screen readers, and when the figure starts and rests.

const idle_after_ms = 2500;
const settled_after_ms = 400;

class Page {
  constructor() {
    this.data = scene_data();
    this.words = new Words(this.data.language);
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
        failed: (kind, message) => (kind === 'draw' ? this.#show_message(message) : this.#fail(kind, message)),
      });
    const words = () => this.words;
    this.bar = new Bar(this.figure, words, () => this.changed());
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
    this.controls = new Controls(part('controls'), words, (key, value) => this.set_soon(key, value));
    this.grips = new Grips(this.figure, part('views'), {
      drags: (thing) => this.#drags(thing),
      set_soon: (key, value) => this.set_soon(key, value),
      words,
      take_back: (values) => this.#reload({values}),
    });
    this.films = new FilmPanel(this);
    this.notes = new Notes(part('notes'), words, (event) => this.#key(event), (film_s) => {
      const {program, loaded, is_lost} = this.figure;
      return program && loaded && !is_lost ? this.figure.image(film_s, 480, Math.round((480 * loaded.film_height) / loaded.film_width)) : null;
    });
    /** Called after a scene is loaded. @type {() => void} */
    this.on_loaded = () => {};
    /** Values that are set at the next frame. @type {Map<string, string>} */
    this.coming = new Map();
    /** Whether the colours follow the system and were not chosen. */
    this.follows_system = false;
    this.idle_timer = 0;
    this.settle_timer = 0;
    this.regime = '';
    document.body.classList.toggle('embedded', this.embedded);
    this.#colour(document.documentElement.dataset['ground'] ?? '#ffffff', null);
    this.figure.choices = this.#read_fragment();
    this.#name();
    this.#wire();
    this.#fit();
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
      await this.figure.start(() => this.data);
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
      this.#open_options(false);
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
    if (this.words.code !== loaded.language) {
      this.words = new Words(loaded.language);
      document.documentElement.lang = this.words.code;
      this.#name();
    }
    this.#colour(loaded.theme.background, loaded.theme.text);
    this.bar.mark();
    if (loaded.next && !this.embedded) {
      part('onward').setAttribute('href', encodeURIComponent(loaded.next));
      part('onward').textContent = `${this.words.of('next')}: ${loaded.next.slice(0, -5).replaceAll('_', ' ')}`;
    }
    this.views.place(loaded.panels, this.figure.ratio);
    this.controls.show(loaded.controls);
    this.films.show();
    this.#show_elements();
    const text = [loaded.motion, ...loaded.notes].filter(Boolean).join('\n');
    if (text !== this.regime) {
      const strong = document.createElement('strong');
      strong.textContent = loaded.motion;
      part('regime').replaceChildren(strong, ...loaded.notes.map((note) => `\n${note}`));
    }
    this.regime = text;
    part('section-change').hidden = loaded.controls.length === 0 && !text;
    part('original').hidden = loaded.controls.length === 0;
    this.#head('change', loaded.controls.length > 0 ? 'change' : 'motion');
    part('hint').textContent = [this.#drags('omega') && this.words.of('drag_omega'), this.#drags('plane') && this.words.of('drag_plane')]
      .filter(Boolean).join(' ');
    this.#fit();
    if (this.failure === 'lost' && !this.figure.is_lost) {
      this.failure = '';
      part('sentence').hidden = true;
    }
    this.on_loaded();
  }

  /** Whether the film is over and another page follows. */
  #at_end() {
    const {loaded, film} = this.figure;
    return Boolean(loaded?.next) && !this.embedded && !film.playing && film.at_s >= film.plan.length_s;
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
      try {
        history.replaceState(null, '', `#${this.fragment()}`);
      } catch {
        // A sandboxed page has no address of its own.
      }
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

  // ── The state in the address ────────────────────────────────────────────────────────────

  fragment() {
    const {film} = this.figure;
    const {values, shown, names, theme} = this.figure.choices;
    const has_moved = !film.untouched || this.views.list().length > 0 || values.size > 0;
    const look = this.follows_system ? '' : theme || (this.#system_is_dark ? 'scene' : '');
    return fragment_of({at_s: has_moved ? film.at_s : null, speed: film.speed, views: this.views.list(), values, shown, names, theme: look});
  }

  /** Takes instant, speed and views from the address. @returns {Choices} the choices that it holds */
  #read_fragment() {
    const state = state_of(location.hash);
    const {film} = this.figure;
    // A drag sets both.
    const controls = [...this.data.controls, ...(this.data.controls.includes('start.omega_rad_s') ? ['start.attitude'] : [])];
    if (state.at_s === null) film.untouched = true;
    else film.seek(state.at_s);
    film.speed = state.speed;
    this.follows_system = state.theme === '' && this.#system_is_dark;
    this.views.set(state.views);
    this.figure.set_views(state.views);
    return {
      values: new Map([...state.values].filter(([key]) => controls.includes(key))),
      shown: state.shown,
      names: state.names,
      theme: this.follows_system ? 'dark' : ['light', 'dark'].includes(state.theme) ? state.theme : '',
    };
  }

  /** Whether the system's dark colours are those of this page: a frame has the colours of the page around it, and a scene its own, if it sets any. */
  get #system_is_dark() {
    const sets_colours = /^\s*(theme\s*=|\[style\]|style\.)/m.test(this.data.text) || this.data.overrides.some((text) => /^(theme|style\.)/.test(text));
    return !this.embedded && !sets_colours && !document.body.classList.contains('workbench') && matchMedia('(prefers-color-scheme: dark)').matches;
  }

  /** The address of this instant, view and values. */
  link() {
    return `${location.href.replace(/#.*$/, '')}#${this.fragment()}`;
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
        this.controls.show_message(last, message_of(error));
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
    this.figure.reload({values: new Map([...this.figure.choices.values, ...changes])});
    this.#settle();
  }

  /** Reads the scene with changed choices; shows the message if the program refuses. @param {Partial<Choices>} changes */
  #reload(changes) {
    try {
      this.figure.reload(changes);
      part('sentence').hidden = !this.failure;
    } catch (error) {
      this.#show_message(error);
      this.#show_elements();
    }
    this.#settle();
  }

  /** Whether viewers may drag the tip of ω, or the plane. @param {string} thing */
  #drags(thing) {
    const has = (/** @type {string} */ key) => this.figure.loaded?.controls.some((c) => c.key === key) ?? false;
    const has_momentum = /^\s*(start\.)?momentum_kg_m2_s\s*=/m.test(this.data.text);
    return has('start.omega_rad_s') || (thing === 'plane' && has('start.energy_J') && has_momentum);
  }

  // ── The options ────────────────────────────────────────────────────────────────

  /** @param {boolean} open */
  #open_options(open) {
    part('options').hidden = !open;
    document.body.classList.toggle('with-options', open);
    part('show-options').setAttribute('aria-expanded', String(open));
    this.#fit();
  }

  /** Names a section of the options. @param {string} section @param {string} word */
  #head(section, word) {
    const heading = part(`section-${section}`).querySelector('h2');
    if (heading) heading.textContent = this.words.of(word);
  }

  #name() {
    const {words} = this;
    for (const section of ['change', 'show', 'view', 'save', 'keys']) this.#head(section, section);
    for (const [id, word] of [['original', 'original'], ['scene-view', 'scene_view'], ['save-png', 'save_png'], ['save-svg', 'save_svg'],
      ['copy-link', 'copy_link']]) part(/** @type {string} */ (id)).textContent = words.of(/** @type {string} */ (word));
    for (const [id, word] of [['png-width', 'width'], ['png-height', 'height']]) {
      const label = input(/** @type {string} */ (id)).closest('label')?.querySelector('span');
      if (label) label.textContent = words.of(/** @type {string} */ (word));
    }
    part('bar').setAttribute('aria-label', words.of('figure'));
    part('options').setAttribute('aria-label', words.of('options'));
    input('link').setAttribute('aria-label', words.of('link'));
    this.bar.name();
    this.#name_keys();
    this.#name_themes();
  }

  #name_keys() {
    /** @type {[string[], string][]} */
    const rows = [
      [['Space'], 'key_play'], [['←', '→'], 'key_frame'], [['Page ↑', 'Page ↓'], 'key_stop'], [['Home', 'End'], 'key_ends'],
      [['1', '…', '9'], 'key_digits'], [['[', ']'], 'key_speed'], [['J'], 'backwards'], [['B', 'W'], 'key_blank'], [['R'], 'repeat'], [['Shift', '← ↑ → ↓'], 'key_turn'],
      [['Alt', '← ↑ → ↓'], 'key_pan'], [['+', '−'], 'key_zoom'], [['C'], 'scene_view'], [['F'], 'full_screen'],
      [['T'], 'look'], [['N'], 'notes'], [['L'], 'copy_link'], [['O'], 'options'],
    ];
    part('keys').replaceChildren(...rows.flatMap(([keys, word]) => {
      const term = document.createElement('dt');
      for (const key of keys) {
        const cap = document.createElement('kbd');
        cap.textContent = key;
        term.append(cap, ' ');
      }
      const meaning = document.createElement('dd');
      meaning.textContent = this.words.of(word);
      return [term, meaning];
    }));
  }

  #name_themes() {
    part('theme').setAttribute('aria-label', this.words.of('look'));
    part('theme').replaceChildren(...['', 'light', 'dark'].map((theme) => {
      const label = document.createElement('label');
      const radio = document.createElement('input');
      const text = document.createElement('span');
      radio.type = 'radio';
      radio.name = 'theme';
      radio.value = theme;
      radio.checked = theme === this.figure.choices.theme;
      radio.addEventListener('change', () => this.set_theme(theme));
      text.textContent = this.words.of(theme || 'of_scene');
      label.append(radio, text);
      return label;
    }));
  }

  /** @param {string} theme */
  set_theme(theme) {
    this.follows_system = false;
    this.#reload({theme});
    this.#name_themes();
  }

  #show_elements() {
    const {loaded, choices} = this.figure;
    if (!loaded) return;
    const rows = [{name: '', summary: '', offered: true}, ...loaded.elements].filter((row) => row.offered !== false);
    const boxes = () => [...part('elements').querySelectorAll('input')];
    if (boxes().map((box) => `${box.name},`).join('') !== rows.map((row) => `${row.name},`).join('')) {
      part('elements').replaceChildren(...rows.map(({name, summary}) => {
        const label = document.createElement('label');
        const box = document.createElement('input');
        box.type = 'checkbox';
        box.name = name;
        box.addEventListener('change', () => this.#reload(name === '' ? {names: box.checked ? null : false} : {shown: this.#shown_with(name, box.checked)}));
        label.title = summary;
        label.append(box, name === '' ? this.words.of('names') : this.words.element(name));
        return label;
      }));
    }
    for (const box of boxes())
      box.checked = box.name === '' ? choices.names !== false : loaded.elements.some((e) => e.name === box.name && e.shown);
  }

  /** The elements that are shown after one is shown or hidden. @param {string} name @param {boolean} shown */
  #shown_with(name, shown) {
    return (this.figure.loaded?.elements ?? []).filter((e) => (e.name === name ? shown : e.shown)).map((e) => e.name);
  }

  async #copy_link() {
    const link = this.link();
    const field = input('link');
    field.value = link;
    try {
      await navigator.clipboard.writeText(link);
      part('copy-link').textContent = this.words.of('copied');
      window.setTimeout(() => { part('copy-link').textContent = this.words.of('copy_link'); }, 1600);
    } catch {
      // Where the clipboard is closed, the viewer copies by hand.
      this.#open_options(true);
      field.hidden = false;
      field.select();
    }
  }

  /** Offers a file for download. @param {Blob} blob @param {string} suffix */
  save(blob, suffix) {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(blob);
    link.download = `${this.data.name}${suffix}`;
    link.click();
    window.setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  }

  // ── Size ────────────────────────────────────────────────────────────────────────────────

  /** The picture fills the stage; on a small screen held upright, what the options leave of it. */
  #fit() {
    const {clientWidth, clientHeight} = part('stage');
    const upright = clientHeight > clientWidth && clientWidth < 640;
    const free = upright && !part('options').hidden ? clientHeight - part('options').clientHeight : clientHeight;
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
      const busy = !part('options').hidden || !part('speeds').hidden || part('bar').matches(':hover') || part('bar').querySelector(':focus-visible');
      document.body.classList.toggle('idle', this.figure.film.playing && !busy);
    }, idle_after_ms);
  }

  #wire() {
    part('show-options').addEventListener('click', () => this.#open_options(part('options').hidden));
    part('close').addEventListener('click', () => {
      this.#open_options(false);
      part('show-options').focus();
    });
    part('begin').addEventListener('click', () => {
      this.start().then(() => {
        this.figure.film.play();
        this.changed();
      }, () => {});
    });
    part('say').addEventListener('click', () => this.notes.toggle());
    part('blank').addEventListener('pointerdown', () => this.#blank(''));
    part('original').addEventListener('click', () => this.#reload({values: new Map()}));
    part('scene-view').addEventListener('click', () => this.views.reset());
    part('save-png').addEventListener('click', () => {
      const [width, height] = [input('png-width'), input('png-height')].map((field) => Math.min(16384, Math.max(16, Math.round(field.valueAsNumber) || 1080)));
      this.figure.png(width ?? 1920, height ?? 1080).then((blob) => this.save(blob, '.png'), (error) => this.#show_message(error));
    });
    part('save-svg').addEventListener('click', () => {
      try {
        this.save(new Blob([this.svg()], {type: 'image/svg+xml'}), '.svg');
      } catch (error) {
        this.#show_message(error);
      }
    });
    part('copy-link').addEventListener('click', () => void this.#copy_link());
    part('stage').addEventListener('click', () => {
      if (!this.figure.program && this.failure !== 'no-webgl' && this.failure !== 'no-wasm') this.start().catch(() => {});
      else if (this.failure === 'lost') this.#restart();
    });
    document.addEventListener('keydown', (event) => this.#key(event));
    for (const name of ['pointermove', 'pointerdown', 'keydown', 'focusin']) document.addEventListener(name, () => this.#wake(), {passive: true});
    document.addEventListener('visibilitychange', () => { this.figure.last_ms = 0; });
    const sizes = new ResizeObserver(() => this.#fit());
    sizes.observe(part('stage'));
    sizes.observe(part('options'));
    window.addEventListener('hashchange', () => {
      const choices = this.#read_fragment();
      if (this.figure.program) this.#reload(choices);
      else this.figure.choices = choices;
    });
  }

  /** @param {unknown} error */
  #show_message(error) {
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

  /** The program's own keys; all others go to the page around this one. @param {KeyboardEvent} event */
  #key(event) {
    const target = event.target instanceof HTMLElement ? event.target : null;
    const typing = target?.matches('input[type=number], input[type=text], textarea, select') ?? false;
    const is_pressed = (target?.matches('button, input[type=checkbox], input[type=radio]') ?? false) && [' ', 'Enter'].includes(event.key);
    const slides = (target?.matches('input[type=range]:not(#scrub), input[type=radio]') ?? false) && /^(Arrow|Home|End|Page)/.test(event.key);
    if (!part('blank').hidden) {
      this.#blank('');
      event.preventDefault();
      return;
    }
    if (event.key === 'Escape' && this.#escape()) return;
    if (typing || is_pressed || slides || event.ctrlKey || event.metaKey) return;
    if (this.figure.program && this.#act(event)) {
      event.preventDefault();
      return;
    }
    if (this.embedded) {
      const {key, code, shiftKey, altKey, repeat} = event;
      window.parent.postMessage({type: 'poinsot-key', key, code, shiftKey, altKey, repeat}, '*');
    }
  }

  /** Covers the page, as presenters' remotes and slide programs do; '' shows it again. @param {string} colour */
  #blank(colour) {
    const cover = part('blank');
    cover.hidden = colour === '';
    cover.style.background = colour;
  }

  /** Closes what is open; false: nothing was. */
  #escape() {
    if (!part('speeds').hidden) this.bar.close_speeds();
    else if (!part('options').hidden) this.#open_options(false);
    else return this.grips.take_back();
    return true;
  }

  /** @param {KeyboardEvent} event @returns {boolean} whether the key is one of this page */
  #act(event) {
    const {film} = this.figure;
    const panel = this.views.active();
    const arrows = /** @type {Record<string, [number, number]>} */ ({ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]});
    const arrow = arrows[event.key];
    if (arrow && event.shiftKey && panel >= 0) this.views.turn(panel, 5 * arrow[0], 5 * arrow[1]);
    else if (arrow && event.altKey && panel >= 0) this.views.pan(panel, 0.04 * arrow[0], 0.04 * arrow[1]);
    else if (event.shiftKey && arrow) return false;
    else if (/^[0-9]$/.test(event.key) && !event.altKey) film.to_chapter(Number(event.key));
    else {
      const action = this.#actions(panel)[event.key.length === 1 ? event.key.toLowerCase() : event.key];
      if (!action || event.altKey) return false;
      action();
    }
    this.changed();
    return true;
  }

  /** @param {number} panel @returns {Record<string, () => void>} */
  #actions(panel) {
    const {film} = this.figure;
    const zoom = (/** @type {number} */ factor) => { if (panel >= 0) this.views.zoom(panel, factor); };
    return {
      ' ': () => film.toggle(),
      ArrowRight: () => film.step(1),
      ArrowLeft: () => film.step(-1),
      ArrowUp: () => film.previous(),
      ArrowDown: () => film.next(),
      PageDown: () => { if (this.#at_end()) part('onward').click(); else film.next(); },
      PageUp: () => film.previous(),
      Home: () => film.seek(0),
      End: () => film.seek(film.plan.length_s),
      '[': () => this.bar.shift_speed(-1),
      ']': () => this.bar.shift_speed(1),
      j: () => this.bar.set_speed(-film.speed),
      b: () => this.#blank('black'),
      '.': () => this.#blank('black'),
      w: () => this.#blank('white'),
      ',': () => this.#blank('white'),
      r: () => { film.repeat = !film.repeat; },
      c: () => this.views.reset(),
      '+': () => zoom(1.15),
      '=': () => zoom(1.15),
      '-': () => zoom(1 / 1.15),
      f: () => this.bar.full_screen(),
      t: () => this.set_theme(this.figure.loaded && document.documentElement.classList.contains('dark') ? 'light' : 'dark'),
      n: () => this.notes.toggle(),
      l: () => void this.#copy_link(),
      o: () => this.#open_options(part('options').hidden),
    };
  }
}
