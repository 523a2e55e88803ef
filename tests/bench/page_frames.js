// How long a page takes for a frame at 1920 x 1080: the program's own time, the time until the picture is there, and frames a
// second while the film plays. Prints a row for each scene.
// Usage: node page_frames.js FOLDER [CHROMIUM-OPTION…], where FOLDER holds the pages. POINSOT_CHROMIUM names another Chromium.
'use strict';
const fs = require('node:fs');
const path = require('node:path');
const puppeteer = require(require.resolve('puppeteer-core', {paths: [path.join(__dirname, '../doors/web'), process.cwd()]}));

const [folder, ...options] = process.argv.slice(2);

const median = (values) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)];

/** Runs in the page: milliseconds of frames at instants throughout the film. */
async function measure() {
  const {figure} = the_page;
  const gl = figure.canvas.getContext('webgl2');
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  const {first_time_s, last_time_s} = figure.loaded;
  const own = [], whole = [];
  const pixel = new Uint8Array(4);
  const n = 61;
  for (let k = 0; k < n + 5; ++k) {
    const began = performance.now();
    figure.program.draw(first_time_s + ((last_time_s - first_time_s) * (k % n)) / n);
    const drawn = performance.now();
    // Waits for the drawing.
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    if (k < 5) continue;
    own.push(drawn - began);
    whole.push(performance.now() - began);
  }
  figure.film.repeat = true;
  poinsot.seek(first_time_s);
  poinsot.play();
  let n_frames = 0;
  const from = performance.now();
  while (performance.now() - from < 2000) {
    await new Promise(requestAnimationFrame);
    ++n_frames;
  }
  const frames_per_s = (1000 * n_frames) / (performance.now() - from);
  return {own, whole, frames_per_s, width: figure.canvas.width, height: figure.canvas.height, renderer: gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER)};
}

async function main() {
  const browser = await puppeteer.launch({executablePath: process.env['POINSOT_CHROMIUM'] ?? '/usr/bin/chromium', headless: true,
    args: ['--no-sandbox', '--allow-file-access-from-files', '--ignore-gpu-blocklist', ...options]});
  let is_first = true;
  for (const name of fs.readdirSync(folder).filter((file) => file.endsWith('.html')).sort()) {
    const tab = await browser.newPage();
    await tab.setViewport({width: 1920, height: 1080});
    const began = Date.now();
    await tab.goto(`file://${path.resolve(folder, name)}`, {timeout: 120000});
    await tab.evaluate(() => window.poinsot.ready);
    const start_ms = Date.now() - began;
    const {own, whole, frames_per_s, width, height, renderer} = await tab.evaluate(measure);
    if (is_first) console.log(`${await browser.version()}, ${renderer}, pictures of ${width} x ${height}\nscene, own ms (median, largest), whole ms (median), frames/s, ms to the first picture`);
    is_first = false;
    console.log(`${name.slice(0, -5)}, ${median(own).toFixed(2)}, ${own[own.length - 1].toFixed(2)}, ${median(whole).toFixed(1)}, ${frames_per_s.toFixed(0)}, ${start_ms}`);
    await tab.close();
  }
  await browser.close();
}

main();
