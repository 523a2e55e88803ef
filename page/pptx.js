// A presentation of a scene's slides, as `poinsot render -o SCENE.pptx` writes it. The module of the workbench holds its texts.

/** The texts of a presentation, by their names. @param {string[]} texts as src/page/fit_module.cpp reads them @returns {Promise<string[]>} */
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
  const texts = [title, plan.slides_of, plan.language, String(plan.size[0]), String(plan.size[1])];
  // Until a film plays, its slide shows the picture with which the slide before ended.
  /** @type {Map<number, string>} */
  const posters = new Map();
  const add = (/** @type {SlideRow} */ slide, /** @type {string} */ file, /** @type {number} */ poster, /** @type {number} */ n_frames, /** @type {string} */ loops) => {
    if (!posters.has(poster)) posters.set(poster, `poster${posters.size + 1}.png`);
    texts.push(slide.title || title, slide.note, file, posters.get(poster) ?? '', String(Math.round((1000 * n_frames * film.denominator) / film.numerator)), loops);
  };
  for (const slide of plan.slides) {
    add(slide, slide.film, slide.first_frame, slide.last_frame - slide.first_frame + 1, '');
    if (slide.loop) add(slide, slide.loop, slide.last_frame, n_loop_frames(slide, film), 'loops');
  }
  const parts = await presentation_parts(texts);
  for (let k = 0; k < parts.length; k += 2) await zip.add(parts[k] ?? '', utf8(parts[k + 1] ?? ''));
  for (const [frame, name] of posters) await zip.add(`ppt/media/${name}`, await slide_still(run, film, frame, maker));
  await make_slide_films(run, film, plan, codec, maker, async (name, bytes) => {
    if (name.endsWith('.mp4')) await zip.add(`ppt/media/${name}`, bytes);
  });
  await zip.finish();
}
