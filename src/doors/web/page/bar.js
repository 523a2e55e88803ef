// The bar below the picture: play, stops, the rail of the film, speed.

/** @import {Figure} from './figure.js' */
/** @import {Words} from './words.js' */

const speeds = [0.125, 0.25, 0.5, 1, 2, 4, 8];

/** An element of the page by its id. @param {string} id @returns {HTMLElement} */
export function part(id) {
  return /** @type {HTMLElement} */ (document.getElementById(id));
}

/** @param {string} id @returns {HTMLInputElement} */
export function input(id) {
  return /** @type {HTMLInputElement} */ (document.getElementById(id));
}

/** Offers a file for download. @param {Blob} blob @param {string} name */
export function save_as(blob, name) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  window.setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

/** @param {string} id @param {string} name */
function set_icon(id, name) {
  part(id).querySelector('use')?.setAttribute('href', `#i-${name}`);
}

export class Bar {
  /** @param {Figure} figure @param {() => Words} words @param {{changed: () => void, next: () => void, previous: () => void}} events */
  constructor(figure, words, {changed, next, previous}) {
    this.figure = figure;
    this.words = words;
    this.changed = changed;
    const {film} = figure;
    const act = (/** @type {string} */ id, /** @type {() => void} */ action) => part(id).addEventListener('click', () => {
      action();
      changed();
    });
    act('play', () => film.toggle());
    act('next', next);
    act('previous', previous);
    part('full').addEventListener('click', () => this.full_screen());
    input('scrub').addEventListener('input', () => {
      film.pause();
      film.seek(input('scrub').valueAsNumber);
      changed();
    });
    part('speed').addEventListener('click', () => this.#toggle_speeds());
    document.addEventListener('pointerdown', (event) => {
      const inside = event.target instanceof Node && (part('speeds').contains(event.target) || part('speed').contains(event.target));
      if (!inside) this.close_speeds();
    });
  }

  full_screen() {
    if (document.fullscreenElement) void document.exitFullscreen();
    else document.documentElement.requestFullscreen?.().catch(() => {});
  }

  /** Puts the words of the language on the buttons. */
  name() {
    const words = this.words();
    for (const [id, word] of [['previous', 'previous_stop'], ['next', 'next_stop'], ['show-options', 'options'], ['say', 'notes'], ['full', 'full_screen'],
      ['begin', 'start_figure'], ['close', 'close']]) {
      part(/** @type {string} */ (id)).setAttribute('aria-label', words.of(/** @type {string} */ (word)));
      part(/** @type {string} */ (id)).title = words.of(/** @type {string} */ (word));
    }
    input('scrub').setAttribute('aria-label', words.of('time'));
    part('full').hidden = !document.fullscreenEnabled;
  }

  /** Marks chapters and stops on the rail. */
  mark() {
    const {film} = this.figure;
    const {chapters, stops, length_s} = film.plan;
    input('scrub').max = String(length_s);
    const at = (/** @type {number} */ at_s) => `${(100 * at_s) / (length_s || 1)}%`;
    const marks = (/** @type {Array<{at_s: number, title: string}>} */ list) => list.map(({at_s, title}) => {
      const mark = document.createElement('i');
      mark.style.left = at(at_s);
      mark.title = title;
      return mark;
    });
    part('say').hidden = !stops.some((stop) => stop.title || stop.note);
    part('chapters').replaceChildren(...marks(chapters.filter((c) => c.at_s > 0)));
    part('stops').replaceChildren(...marks(stops));
  }

  /** Shows where the film is. */
  show() {
    const {film} = this.figure;
    const words = this.words();
    const {length_s, stops} = film.plan;
    const playing = film.playing && !(film.is_looping && !film.leaving);
    const word = film.is_looping && !film.leaving ? 'go_on' : film.playing ? 'pause' : film.waiting >= 0 ? 'go_on' : 'play';
    set_icon('play', playing ? 'pause' : word === 'go_on' ? 'go-on' : 'play');
    part('play').setAttribute('aria-label', words.of(word));
    part('play').title = words.of(word);
    const scrub = input('scrub');
    scrub.value = String(film.at_s);
    part('done').style.setProperty('--part', String(length_s > 0 ? film.at_s / length_s : 0));
    [...part('stops').children].forEach((mark, i) => {
      mark.classList.toggle('now', i === film.waiting);
      mark.classList.toggle('leaving', i === film.waiting && film.leaving);
      mark.classList.toggle('passed', (stops[i]?.at_s ?? 0) <= film.at_s + 1e-9);
    });
    const time = this.time_text();
    // A press in a loop is answered at once, and obeyed at the seam.
    part('time').textContent = film.leaving ? words.of('at_seam') : time;
    const stop = stops[film.waiting];
    const place = [time, film.chapter()?.title, stop && `${words.of('stop')} ${film.waiting + 1} ${stop.title}`].filter(Boolean).join(', ');
    if (scrub.getAttribute('aria-valuetext') !== place) scrub.setAttribute('aria-valuetext', place);
    part('speed').textContent = `${this.#number(film.speed)}×`;
    part('speed').setAttribute('aria-label', `${words.of('speed')} ${this.#number(film.speed)}×`);
  }

  /** "t = 3.25 s": the motion's time, with digits that suit the film's span. */
  time_text() {
    const {figure} = this;
    const loaded = figure.loaded;
    if (!loaded) return '';
    const span_s = Math.abs(loaded.last_time_s - loaded.first_time_s) || 1;
    const digits = Math.min(9, Math.max(0, Math.ceil(2.9 - Math.log10(span_s))));
    const number = new Intl.NumberFormat(this.words().code, {minimumFractionDigits: digits, maximumFractionDigits: digits, useGrouping: false});
    return `t = ${number.format(figure.time_s).replace('-', '−')} s`;
  }

  /** @param {number} x */
  #number(x) {
    return new Intl.NumberFormat(this.words().code, {maximumSignificantDigits: 4, useGrouping: false}).format(x).replace('-', '−');
  }

  /** @param {number} speed */
  set_speed(speed) {
    const {film} = this.figure;
    if (Number.isFinite(speed) && speed !== 0) film.speed = Math.min(1e6, Math.max(-1e6, speed));
    this.changed();
  }

  /** To the next speed of the list; the direction stays. @param {number} by 1: faster, -1: slower */
  shift_speed(by) {
    const {speed} = this.figure.film;
    const size = Math.abs(speed);
    const next = by > 0 ? speeds.find((s) => s > size * 1.001) : [...speeds].reverse().find((s) => s < size * 0.999);
    this.set_speed(Math.sign(speed) * (next ?? size * 2 ** by));
  }

  close_speeds() {
    part('speeds').hidden = true;
    part('speed').setAttribute('aria-expanded', 'false');
  }

  #toggle_speeds() {
    const list = part('speeds');
    if (!list.hidden) {
      this.close_speeds();
      return;
    }
    const {film} = this.figure;
    const words = this.words();
    const choices = speeds.map((speed) => {
      const button = document.createElement('button');
      button.type = 'button';
      button.textContent = `${this.#number(speed)}×`;
      button.setAttribute('aria-pressed', String(Math.abs(film.speed) === speed));
      button.addEventListener('click', () => {
        this.set_speed(Math.sign(film.speed) * speed);
        this.close_speeds();
        part('speed').focus();
      });
      return button;
    });
    const labelled = (/** @type {string} */ name, /** @type {HTMLInputElement} */ field) => {
      const label = document.createElement('label');
      label.append(words.of(name), field);
      return label;
    };
    const any = document.createElement('input');
    any.type = 'number';
    any.step = 'any';
    any.value = String(film.speed);
    any.addEventListener('change', () => this.set_speed(any.valueAsNumber));
    const check = (/** @type {boolean} */ on, /** @type {(on: boolean) => void} */ action) => {
      const box = document.createElement('input');
      box.type = 'checkbox';
      box.checked = on;
      box.addEventListener('change', () => {
        action(box.checked);
        any.value = String(film.speed);
        this.changed();
      });
      return box;
    };
    list.replaceChildren(...choices, labelled('speed', any),
      labelled('backwards', check(film.speed < 0, (on) => { film.speed = Math.abs(film.speed) * (on ? -1 : 1); })),
      labelled('repeat', check(film.repeat, (on) => { film.repeat = on; })));
    list.hidden = false;
    part('speed').setAttribute('aria-expanded', 'true');
    (choices[speeds.indexOf(Math.abs(film.speed))] ?? any).focus();
  }
}
