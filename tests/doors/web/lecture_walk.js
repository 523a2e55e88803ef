// Gives the whole lecture as a lecturer does: by Page Down alone, from stop to stop and from scene to scene.
// Checks that each stop is reached, that its loop has no jump and that nothing fails, and puts a picture of each stop, with five instants of
// each loop, on sheets. Usage: node lecture_walk.js POINSOT SCENES OUT.
'use strict';
const assert = require('node:assert/strict');
const fs = require('node:fs');
const path = require('node:path');
const {browser_checks, opened_file, page_of, press, ready, until} = require('./browsers.js');

const [program, scenes, out] = process.argv.slice(2);
const pages = ['tensor', 'momentum_sphere', 'torque_axis', 'torque_symmetric', 'lecture', 'energy_sweep', 'sphere', 'symmetric_oblate', 'symmetric_prolate',
  'euler_angles', 'heavy_top_conserved', 'heavy_top_wavy', 'heavy_top_cusp', 'heavy_top_looping'];
const size = {width: 1280, height: 720};
fs.mkdirSync(out, {recursive: true});

/** The picture of a second of film, as the page draws it. */
const drawn_at = (tab, film_s) => tab.evaluate(async (film_s) => {
  const {figure} = the_page;
  const {width, height} = figure.canvas;
  const pixels = figure.program.pixels(figure.loaded ? poinsot.time_at(film_s) : 0, width, height, film_s);
  const canvas = new OffscreenCanvas(width, height);
  canvas.getContext('2d').putImageData(new ImageData(new Uint8ClampedArray(pixels), width, height), 0, 0);
  const bytes = new Uint8Array(await (await canvas.convertToBlob()).arrayBuffer());
  return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
}, film_s);

/** The share of pixels in which two seconds of film differ by more than 8 levels. */
const changed = (tab, one_s, other_s) => tab.evaluate((one_s, other_s) => {
  const {figure} = the_page;
  const {width, height} = figure.canvas;
  const [a, b] = [one_s, other_s].map((s) => new Uint8Array(figure.program.pixels(poinsot.time_at(s), width, height, s)));
  let n = 0;
  for (let k = 0; k < a.length; k += 4) n += Number([0, 1, 2].some((c) => Math.abs(a[k + c] - b[k + c]) > 8));
  return n / (a.length / 4);
}, one_s, other_s);

/** @param {any} browser @param {string} name @param {{title: string, png: string}[]} tiles */
async function write_sheet(browser, name, tiles, n_columns) {
  const tab = await browser.newPage();
  await tab.setViewport({width: n_columns * 488, height: 600});
  await tab.setContent(`<!doctype html><style>body{margin:0;display:grid;grid-template-columns:repeat(${n_columns},480px);gap:8px;background:#888;font:14px sans-serif}
    figure{margin:0}img{width:100%;display:block}</style>${tiles.map(({title, png}) => `<figure><img src="data:image/png;base64,${png}"><figcaption>${title}</figcaption></figure>`).join('')}`);
  await tab.screenshot({path: path.join(out, `${name}.png`), fullPage: true});
  await tab.close();
}

browser_checks()('gives the whole lecture, stop by stop and page by page', async (browser) => {
  const {tab, faults} = await opened_file(browser, page_of(program, path.join(scenes, 'tensor.toml'), path.join(out, 'lecture.html')), {size});
  const stops = [];
  const loops = [];
  for (const name of pages) {
    await ready(tab);
    await until(tab, `the_page.figure.data.name === ${JSON.stringify(name)}`);
    const plan = await tab.evaluate(() => the_page.figure.film.plan);
    for (const [k, stop] of plan.stops.entries()) {
      // Ten times as fast as before a class.
      await tab.evaluate(() => { the_page.figure.film.speed = 10; });
      await press(tab, 'PageDown');
      if (k > 0 && plan.stops[k - 1].loop_s) await press(tab, 'PageDown');
      await until(tab, `the_page.figure.film.waiting === ${k}`);
      assert.equal(await tab.evaluate(() => the_page.figure.film.is_looping), stop.loop_s !== null, stop.title);
      stops.push({title: `${k + 1}. ${stop.title}`, png: await drawn_at(tab, stop.at_s)});
      if (!stop.loop_s) continue;
      const jump = await changed(tab, stop.at_s - stop.loop_s, stop.at_s);
      // Letters may move by a pixel; an arrow that jumps changes more.
      assert.ok(jump < 2e-3, `stop ${k + 1}: ${jump} of the pixels change over the seam of its loop`);
      assert.ok((await changed(tab, stop.at_s - 0.5 * stop.loop_s, stop.at_s)) > 1e-4, `stop ${k + 1}: nothing moves in its loop`);
      for (const share of [0, 0.2, 0.4, 0.6, 0.8])
        loops.push({title: `${k + 1}, ${share} of its loop`, png: await drawn_at(tab, stop.at_s - (1 - share) * stop.loop_s)});
    }
    assert.ok(plan.stops.length > 0, `${name} has no stops`);
    // What follows the last stop plays to its end.
    await tab.evaluate(() => { the_page.figure.film.speed = 10; });
    if (!(await tab.evaluate(() => the_page.figure.film.is_over))) {
      await press(tab, 'PageDown');
      if (plan.stops.at(-1).loop_s) await press(tab, 'PageDown');
    }
    await until(tab, 'the_page.figure.film.is_over', 120000);
    if (name !== pages.at(-1)) await press(tab, 'PageDown');
  }
  assert.deepEqual(faults, []);
  await write_sheet(browser, 'stops', stops, 3);
  await write_sheet(browser, 'loops', loops, 5);
  console.log(`${stops.length} stops; look at ${path.join(out, 'stops.png')} and loops.png`);
});
