// A presentation of a scene's slides, as `poinsot render -o SCENE.pptx` writes it. The module of the workbench holds its texts.

import {utf8} from './film_file.js';
import {unpacked} from './loader.js';
import {presentations} from './make_film.js';
import {FitModule} from './measure.js';
import {make_slide_films, n_loop_frames, slide_still} from './slides.js';
/** @import {FilmCodec} from './film_encoder.js' */
/** @import {FilmDescription, FilmRun} from './make_film.js' */
/** @import {ZipWriter} from './png_frames.js' */
/** @import {SlidePlan} from './slides.js' */

/** The texts of a presentation, by their names. @param {string[]} texts as src/doors/web/module/fit_module.cpp reads them @returns {Promise<string[]>} */
async function presentation_parts(texts) {
  const module = await FitModule.start(unpacked('fit-module'));
  module.with_items([texts.map((text) => `${text}\0`).join('')], (...at) => module.call('presentation', ...at));
  return JSON.parse(module.answer());
}

/** @param {FilmRun} run @param {FilmDescription} film @param {FilmCodec} codec @param {string} maker @param {ZipWriter} zip */
async function write_presentation(run, film, codec, maker, zip) {
  /** @type {SlidePlan} */
  const plan = JSON.parse(run.program.filmSlides());
  const title = film.title || plan.slides_of;
  const texts = [title, plan.slides_of, plan.scene_sha256, plan.language, String(plan.size[0]), String(plan.size[1])];
  // Until a film plays, its slide shows the picture with which the slide before ended; print-outs show the stop.
  /** @type {Map<number, string>} */
  const posters = new Map();
  const picture = (/** @type {number} */ frame) => {
    if (!posters.has(frame)) posters.set(frame, `poster${posters.size + 1}.png`);
    return posters.get(frame) ?? '';
  };
  const duration = (/** @type {number} */ n_frames) => String(Math.round((1000 * n_frames * film.denominator) / film.numerator));
  for (const slide of plan.slides) {
    texts.push(slide.title || title, slide.note, slide.film, picture(slide.first_frame), slide.loop ?? '', picture(slide.last_frame),
      duration(slide.last_frame - slide.first_frame + 1), duration(slide.loop ? n_loop_frames(slide, film) : 0));
  }
  const parts = await presentation_parts(texts);
  for (let k = 0; k < parts.length; k += 2) await zip.add(parts[k] ?? '', utf8(parts[k + 1] ?? ''));
  for (const [frame, name] of posters) await zip.add(`ppt/media/${name}`, await slide_still(run, film, frame, maker));
  await make_slide_films(run, film, plan, codec, maker, async (name, bytes) => {
    if (name.endsWith('.mp4')) await zip.add(`ppt/media/${name}`, bytes);
  });
  await zip.finish();
}

presentations.write = write_presentation;
