// What other scripts can do with the page: the object `poinsot`. `time_s` counts seconds of the motion, `film_s` seconds of the film.

import {toml_of} from './controls.js';
import {film_qualities} from './film_encoder.js';
import {has_film_writer} from './film_file.js';
import {FilmCancelled, film_files, film_scene, make_film, presentations} from './make_film.js';
import {Page} from './page.js';
/** @import {FilmKind} from './film_encoder.js' */
/** @import {FilmSettings} from './make_film.js' */
/** @import {View} from './program.js' */

/**
 * @typedef {{kind?: FilmKind, width?: number, height?: number, fps?: number, first_s?: number, last_s?: number, quality?: string,
 *   signal?: AbortSignal, progress?: (done: number, n_frames: number) => void}} FilmOptions `first_s`, `last_s`: seconds of the film
 */

/** @param {Page} page @param {FilmOptions} options @returns {Promise<Blob>} */
async function film_of(page, options) {
  await page.start();
  const {loaded} = page.figure;
  if (!loaded) throw new Error('the figure has not started; wait for poinsot.ready');
  const {kind = 'mp4', width = loaded.film_width, height = loaded.film_height, fps = loaded.frames_per_s, first_s = 0, last_s = loaded.film_length_s,
    quality = 'lecture', signal = new AbortController().signal, progress = () => {}, ...others} = options;
  const refuse = (/** @type {string} */ what) => { throw new RangeError(`poinsot.film: ${what}`); };
  const unknown = Object.keys(others)[0];
  if (unknown) refuse(`there is no option ${unknown}; give kind, width, height, fps, first_s, last_s, quality, signal or progress`);
  const kinds = Object.keys(film_files).filter((name) => (name !== 'pptx' || presentations.write) && (has_film_writer() || name === 'png'));
  if (!kinds.includes(kind)) refuse(`kind "${kind}" is none of ${kinds.join(', ')}`);
  if (!(quality in film_qualities)) refuse(`quality "${quality}" is none of ${Object.keys(film_qualities).join(', ')}`);
  if (!(first_s >= 0 && first_s <= last_s && Number.isFinite(last_s))) refuse(`first_s ${first_s} and last_s ${last_s} are no span of the film; give 0 ≤ first_s ≤ last_s`);
  signal.throwIfAborted();
  /** @type {FilmSettings} */
  const settings = {kind, width, height, rate: fps, quality, span: {kind: 'seconds', index: 0, first_s, last_s}};
  try {
    const {blob} = await make_film(page, film_scene(page, settings), settings, {progress, signal});
    return /** @type {Blob} */ (blob);
  } catch (error) {
    if (error instanceof Error && error.cause instanceof FilmCancelled) throw signal.reason;
    throw error;
  }
}

/** @param {Page} page */
function scripting(page) {
  const {figure} = page;
  const started = () => {
    if (!figure.program) throw new Error('the figure has not started; wait for poinsot.ready');
    return figure.program;
  };
  /** @param {number} seconds @param {string} name @param {string} clock */
  const finite = (seconds, name, clock) => {
    if (!Number.isFinite(seconds)) throw new TypeError(`poinsot.${name}(${seconds}): give a second of the ${clock} as a number`);
    return seconds;
  };
  return Object.freeze({
    /** A promise of the first picture; asking for it starts the figure. */
    get ready() {
      return page.start();
    },
    /** The motion at any time, as `poinsot sample` has it. @param {number} time_s */
    at: (time_s) => started().at(Number(time_s)),
    /** Shows a second of the motion. @param {number} time_s */
    seek(time_s) {
      started();
      figure.film.seek(figure.film_second_of(finite(time_s, 'seek', 'motion')));
      page.changed();
    },
    /** Shows a second of the film, the clock of [[stops]], [[keyframes]] and captions. @param {number} film_s */
    seek_film(film_s) {
      started();
      figure.film.seek(finite(film_s, 'seek_film', 'film'));
      page.changed();
    },
    /** Goes to a stop, and plays its loop if it has one. @param {number} number from 1 */
    seek_stop(number) {
      started();
      const n_stops = figure.film.plan.stops.length;
      if (!Number.isInteger(number) || number < 1 || number > n_stops)
        throw new RangeError(`poinsot.seek_stop(${number}): ${n_stops > 0 ? `give a number from 1 to ${n_stops}` : 'this scene has no stops'}`);
      figure.film.to_stop(number);
      page.changed();
    },
    /** The second of the motion that a second of the film shows. @param {number} film_s */
    time_at(film_s) {
      started();
      return figure.time_of(finite(film_s, 'time_at', 'film'));
    },
    /** The first second of the film that shows a second of the motion: the nearest where none does. @param {number} time_s */
    film_at(time_s) {
      started();
      return figure.film_second_of(finite(time_s, 'film_at', 'motion'));
    },
    play() {
      figure.film.pause();
      figure.film.play();
      page.changed();
    },
    pause() {
      figure.film.pause();
      page.changed();
    },
    next() {
      figure.film.next();
      page.changed();
    },
    previous() {
      figure.film.previous();
      page.changed();
    },
    /** Sets keys of the scene, as --set does; rejects with the program's message. @param {Record<string, unknown>} values */
    async set(values) {
      await page.start();
      page.set(new Map(Object.entries(values).map(([key, value]) => [key, toml_of(value)])));
    },
    /** Turns a panel, or all that have a view; null: the scene's camera. @param {(Partial<View>)|null} view */
    view(view) {
      if (view === null) {
        page.views.reset();
        return;
      }
      const {panel, ...values} = view;
      page.views.panels.forEach((place, index) => {
        if (place.has_view && (panel === undefined || panel === index)) page.views.change(index, values);
      });
    },
    /** This instant as a PNG file. @param {number} [width] @param {number} [height] */
    png: (width = figure.canvas.width, height = figure.canvas.height) => figure.png(width, height),
    /**
     * A film, as the form "Film" makes it. Rejects with one sentence, or with the reason of the signal. By default the whole film, MP4, with the
     * size and rate of the scene. `progress` gets the number of frames that are done, and of all.
     * @param {FilmOptions} [options]
     */
    film: (options = {}) => film_of(page, options),
    /** This instant as SVG. */
    svg: () => page.svg(),
    /** The second of the film that the page shows, and the film's length. */
    get film_s() {
      return figure.film.at_s;
    },
    get film_length_s() {
      return figure.loaded?.film_length_s ?? 0;
    },
    /** The stops, in order. */
    get stops() {
      return figure.film.plan.stops.map(({at_s, title, note, loop_s}) => ({film_s: at_s, time_s: figure.time_of(at_s), title, note, loop_s}));
    },
    /** The number of the stop at which the film stands or loops, from 1; 0: none. */
    get stop() {
      return figure.film.waiting + 1;
    },
    /** The second of the motion that the page shows, and the first and last one of the film. */
    get time_s() {
      return figure.time_s;
    },
    get first_time_s() {
      return figure.loaded?.first_time_s ?? 0;
    },
    get last_time_s() {
      return figure.loaded?.last_time_s ?? 0;
    },
  });
}

export const the_page = new Page();
/** @type {any} */ (window)['poinsot'] = scripting(the_page);
the_page.watch_sight();
