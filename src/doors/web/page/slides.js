// The slides of a scene: a film for each stop, as `poinsot render --slides` makes them.

import {FrameEncoder, key_frame_interval} from './film_encoder.js';
import {FilmFile, sha256_of, utf8} from './film_file.js';
import {png_file} from './png_frames.js';
/** @import {FilmCodec} from './film_encoder.js' */
/** @import {FilmHashes} from './film_file.js' */
/** @import {FilmDescription, FilmRun} from './make_film.js' */
/** @import {ZipWriter} from './png_frames.js' */

/**
 * @typedef {{title: string, note: string, film: string, loop: string|null, captions: string|null, loop_captions: string|null,
 *   png: string, loop_s: number, first_frame: number, last_frame: number}} SlideRow
 * @typedef {{slides_of: string, scene_sha256: string, language: string, size: [number, number], slides: SlideRow[]}} SlidePlan  slides.json
 * @typedef {{name: string, captions: string|null, first: number, last: number}} SlideFilm
 * @typedef {{frame: number, is_key: boolean, uses: [SlideFilm, number][]}} SlideStep
 *   A frame to encode, and the films that hold its packet, each with the number of the frame in it.
 */

/** The frames of a slide's loop. @param {SlideRow} slide @param {FilmDescription} film */
export function n_loop_frames(slide, film) {
  return Math.round((slide.loop_s * film.numerator) / film.denominator);
}

/**
 * In which order the frames of all films are encoded, by one encoder. A slide's last frame is encoded alone; its packet also begins the
 * next film, whose frames refer to it. So the films meet in the same pixels.
 * @param {SlidePlan} plan @param {FilmDescription} film @returns {SlideStep[]}
 */
function steps_of_slides(plan, film) {
  const every = key_frame_interval(film);
  /** @type {SlideStep[]} */
  const steps = [];
  for (const slide of plan.slides) {
    const {first_frame: first, last_frame: last} = slide;
    const main = {name: slide.film, captions: slide.captions, first, last};
    const before = steps[steps.length - 1];
    if (before) before.uses.push([main, 0]);
    // The frames before the last one.
    const add = (/** @type {SlideFilm} */ one, /** @type {number} */ from) => {
      for (let frame = from; frame < last; ++frame)
        steps.push({frame, is_key: (frame - one.first) % every === 0, uses: [[one, frame - one.first]]});
    };
    add(main, before ? first + 1 : first);
    if (before && first === last) continue;
    /** @type {SlideStep} */
    const shared = {frame: last, is_key: true, uses: [[main, last - first]]};
    if (slide.loop) {
      const loop = {name: slide.loop, captions: slide.loop_captions, first: last + 1 - n_loop_frames(slide, film), last};
      add(loop, loop.first);
      shared.uses.push([loop, last - loop.first]);
    }
    steps.push(shared);
  }
  return steps;
}

/**
 * Makes the films, one after the other, and hands over their files with those of their captions.
 * @param {FilmRun} run @param {FilmDescription} film @param {SlidePlan} plan @param {FilmCodec} codec @param {string} maker
 * @param {(name: string, bytes: Uint8Array<ArrayBuffer>) => Promise<void>} save
 */
export async function make_slide_films(run, film, plan, codec, maker, save) {
  const steps = steps_of_slides(plan, film);
  /** @type {Map<SlideFilm, FilmFile>} */
  const open = new Map();
  const encoder = new FrameEncoder(film, codec, async (index, packet) => {
    for (const [one, frame] of /** @type {SlideStep} */ (steps[index]).uses) {
      const texts = run.program.filmTexts([one.first, one.last], one.name);
      let file = open.get(one);
      if (!file) {
        const record = (/** @type {FilmHashes} */ hashes) => run.program.filmRecord([one.first, one.last], maker, hashes, 1);
        file = new FilmFile({kind: 'mp4', codec, shape: film, texts: {...texts, chapters: []}, record}, null);
        open.set(one, file);
        await file.start();
      }
      await file.add(frame, packet);
      if (one.first + frame !== one.last) continue;
      open.delete(one);
      const bytes = await file.finish();
      if (bytes) await save(one.name, bytes);
      if (one.captions) await save(one.captions, utf8(texts.captions));
    }
  });
  try {
    for (const [k, step] of steps.entries()) {
      const planes = run.program.filmFrame(step.frame, 'planes');
      await run.go_on(k, steps.length);
      await encoder.add(planes, step.is_key);
    }
    await encoder.finish();
    run.progress(steps.length, steps.length);
  } finally {
    encoder.close();
    for (const file of open.values()) await file.cancel();
  }
}

/** The picture of a frame. @param {FilmRun} run @param {FilmDescription} film @param {number} frame @param {string} maker */
export function slide_still(run, film, frame, maker) {
  return png_file(run.program.filmFrame(frame, 'pixels'), film.width, film.height, 'poinsot', run.program.filmRecord([frame, frame], maker, {}, 2));
}

/** The files of `poinsot render --slides`, without its PDFs, in an archive. @param {FilmRun} run @param {FilmDescription} film @param {FilmCodec} codec @param {string} maker @param {ZipWriter} zip */
export async function write_slides(run, film, codec, maker, zip) {
  /** @type {SlidePlan} */
  const plan = JSON.parse(run.program.filmSlides());
  /** @type {[string, string][]} */
  const hashes = [];
  const add = async (/** @type {string} */ name, /** @type {Uint8Array<ArrayBuffer>} */ bytes) => {
    hashes.push([name, await sha256_of(bytes)]);
    await zip.add(name, bytes);
  };
  await make_slide_films(run, film, plan, codec, maker, add);
  for (const slide of plan.slides) await add(slide.png, await slide_still(run, film, slide.last_frame, maker));
  await zip.add('slides.json', utf8(run.program.filmSlides(hashes.sort())));
  await zip.finish();
}
