// The lecturer's window: a clock, the note of the stop, the next stop with its picture. Without pop-up windows, a part of the page.

/** @import {Film, FilmPlan} from './film.js' */
/** @import {Words} from './words.js' */

/**
 * Where a scene stands among those of the page: stops of the scenes before it, and of all; the planned time of the scenes before it; its title,
 * and that of the scene that follows.
 * @typedef {{n_stops_before: number, n_stops: number, planned_before_s: number, title: string, next_title: string}} Place
 */

export class Notes {
  /**
   * @param {HTMLElement} fallback part of the page for where windows are not allowed @param {() => Words} words @param {(event: KeyboardEvent) => void} keys
   * @param {(film_s: number) => ImageData|null} picture of a second of film
   * @param {() => Place} place
   */
  constructor(fallback, words, keys, picture, place) {
    this.fallback = fallback;
    this.place = place;
    this.words = words;
    this.keys = keys;
    this.picture = picture;
    /** @type {Window|null} */
    this.window = null;
    /** @type {Document|null} */
    this.page = null;
    /** When the lecture began: when the film first moved. */
    this.began_ms = 0;
    /** Pictures of seconds of film, of this plan. @type {Map<number, ImageData>} */
    this.pictures = new Map();
    /** @type {FilmPlan|null} */
    this.plan = null;
    this.is_drawing = false;
    /** The second of film that is shown; -1: none. */
    this.pictured_s = -1;
    /** @type {Film|null} */
    this.film = null;
    this.timer = 0;
  }

  get is_open() {
    return this.page !== null && !(this.window?.closed ?? false);
  }

  toggle() {
    if (this.is_open) this.close();
    else this.open();
  }

  open() {
    this.pictured_s = -1;
    try {
      this.window = window.open('', '', 'popup,width=720,height=760');
    } catch {
      this.window = null;
    }
    this.page = this.window?.document ?? document;
    const root = this.window ? this.page.body : this.fallback;
    root.replaceChildren();
    if (this.window) {
      const style = this.page.createElement('style');
      style.textContent = document.getElementById('page-style')?.textContent ?? '';
      this.page.head.append(style);
      this.page.title = this.words().of('notes');
      this.page.documentElement.lang = this.words().code;
      root.className = 'notes-window';
      this.window.addEventListener('keydown', this.keys);
    } else this.fallback.hidden = false;
    for (const name of ['clock', 'where', 'note', 'next', 'picture']) {
      const part = this.page.createElement(name === 'note' ? 'p' : name === 'picture' ? 'canvas' : 'div');
      part.className = `notes-${name}`;
      root.append(part);
    }
    // The clock runs only while this window is open.
    this.timer = window.setInterval(() => this.show(this.film), 1000);
    this.show(this.film);
  }

  close() {
    window.clearInterval(this.timer);
    this.window?.close();
    this.fallback.hidden = true;
    this.window = null;
    this.page = null;
  }

  /** @param {Film|null} film */
  show(film) {
    this.film = film;
    if (film && !film.untouched) this.began_ms ||= Date.now();
    if (!this.page || !film) return;
    if (this.window?.closed) {
      this.close();
      return;
    }
    const words = this.words();
    const {stops} = film.plan;
    const coming = film.coming_stop();
    const stop = stops[coming];
    const waits = film.waiting >= 0;
    const after = stops[waits ? coming + 1 : coming];
    const passed_s = this.began_ms ? (Date.now() - this.began_ms) / 1000 : 0;
    const now = new Date().toLocaleTimeString(words.code, {hour: '2-digit', minute: '2-digit'});
    // On the way to a stop, what to say there; after the last, what was said.
    const shown = stop ?? stops[stops.length - 1];
    const place = this.place();
    const planned = shown?.planned_s == null ? [] : [`${words.of('planned')} ${clock_text(place.planned_before_s + shown.planned_s)}`];
    this.#write('clock', [now, `${words.of('elapsed')} ${clock_text(passed_s)}`, ...planned,
      `${words.of('film')} ${clock_text(film.at_s)} / ${clock_text(film.plan.length_s)}`].join(' · '));
    const number = stops.length > 0 ? `${place.n_stops_before + (stop ? coming : stops.length - 1) + 1} / ${place.n_stops}` : '';
    this.#write('where', [number, shown?.title || film.chapter()?.title || place.title].filter(Boolean).join(' · '));
    this.#write('note', shown?.note ?? '');
    const at = waits && after?.planned_s != null ? `${clock_text(place.planned_before_s + after.planned_s)} · ` : '';
    this.#write('next', `${words.of('next')}: ${at}${after ? after.title || clock_text(after.at_s) : place.next_title || words.of('end')}`);
    this.#draw(film, after ? after.at_s : film.plan.length_s);
  }

  /** Shows a second of the film. While the film stands, draws the pictures of all stops, one a call. @param {Film} film @param {number} film_s */
  #draw(film, film_s) {
    const {plan} = film;
    const canvas = /** @type {HTMLCanvasElement|null|undefined} */ (this.#part('picture'));
    if (!canvas) return;
    if (this.plan !== plan) {
      this.plan = plan;
      this.pictures.clear();
      this.pictured_s = -1;
    }
    const image = this.pictures.get(film_s);
    if (image && this.pictured_s !== film_s) {
      this.pictured_s = film_s;
      canvas.width = image.width;
      canvas.height = image.height;
      canvas.getContext('2d')?.putImageData(image, 0, 0);
    }
    const missing = [film_s, ...(film.playing ? [] : plan.stops.map((stop) => stop.at_s))].find((at_s) => !this.pictures.has(at_s));
    if (missing === undefined || this.is_drawing) return;
    this.is_drawing = true;
    // After the picture of the page.
    window.setTimeout(() => {
      this.is_drawing = false;
      const made = this.is_open && this.plan === plan ? this.picture(missing) : null;
      if (!made) return;
      this.pictures.set(missing, made);
      if (missing === film_s) this.show(this.film);
    });
  }

  /** @param {string} name */
  #part(name) {
    return (this.window ? this.page?.body : this.fallback)?.querySelector(`.notes-${name}`);
  }

  /** @param {string} name @param {string} text */
  #write(name, text) {
    const part = this.#part(name);
    if (part && part.textContent !== text) part.textContent = text;
  }
}

/** Minutes and seconds: "2:05". @param {number} seconds */
function clock_text(seconds) {
  const whole = Math.floor(seconds);
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, '0')}`;
}
