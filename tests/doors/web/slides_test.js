// The deck of docs/examples/slides/reveal in a browser, forwards and backwards: the pixels of each stop.
// Usage: node slides_test.js POINSOT EXAMPLES [PICTURES]; PICTURES gets what the browser shows.
'use strict';
const assert = require('node:assert/strict');
const {spawnSync} = require('node:child_process');
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');
const {browser_checks, opened_file, until, wait} = require('./browsers.js');

const [program, examples, pictures] = process.argv.slice(2);
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'poinsot-slides-'));
process.on('exit', () => fs.rmSync(folder, {recursive: true, force: true}));

const reveal = path.dirname(path.dirname(require.resolve('reveal.js')));
fs.cpSync(path.join(examples, 'reveal'), folder, {recursive: true});
fs.cpSync(reveal, path.join(folder, 'reveal.js'), {recursive: true});
// Small and quick; the same stops and files as the guide's.
const outcome = spawnSync(program, ['render', path.join(examples, 'wobble.toml'), '--slides', path.join(folder, 'wobble'),
  '--size', '640x360', '--quiet'], {encoding: 'utf8'});
assert.equal(outcome.status, 0, outcome.stderr);

const still = (number) => fs.readFileSync(path.join(folder, `wobble/${number}.png`)).toString('base64');

/** The mean difference in levels between what a tab shows and a still. */
async function difference(tab, number, name) {
  const shown = await tab.screenshot({encoding: 'base64'});
  if (pictures) {
    fs.mkdirSync(pictures, {recursive: true});
    fs.writeFileSync(path.join(pictures, `${name}.png`), Buffer.from(shown, 'base64'));
  }
  return tab.evaluate(async (a, b) => {
    const pixels = async (base64) => {
      const image = new Image();
      image.src = `data:image/png;base64,${base64}`;
      await image.decode();
      const canvas = new OffscreenCanvas(640, 360);
      const context = canvas.getContext('2d');
      context.drawImage(image, 0, 0, 640, 360);
      return context.getImageData(0, 0, 640, 360).data;
    };
    const [one, two] = [await pixels(a), await pixels(b)];
    return one.reduce((sum, level, i) => sum + Math.abs(level - two[i]), 0) / one.length;
  }, shown, still(number));
}

/** Of one picture as PNG and as H.264 in a browser: measured at most 0.7. Of the loop half a turn later: 6.4. */
const same_levels = 1.5;
const other_levels = 4;

async function shows(tab, number, name) {
  const levels = await difference(tab, number, name);
  if (pictures) console.log(name, levels);
  assert.ok(levels < same_levels, `${name}: ${levels} levels from ${number}.png`);
}
async function shows_another(tab, number, name) {
  const levels = await difference(tab, number, name);
  if (pictures) console.log(name, levels);
  assert.ok(levels > other_levels, `${name}: only ${levels} levels from ${number}.png`);
}

const opened = async (browser) => {
  const {tab, faults} = await opened_file(browser, path.join(folder, 'index.html'), {size: {width: 640, height: 360}});
  await until(tab, 'window.Reveal && Reveal.isReady()');
  return {tab, faults};
};
/** Whether the film of the slide has ended, and its last frame is shown. */
const stopped = (tab) => until(tab, `(() => {
  const film = Reveal.getCurrentSlide().querySelector('video');
  return film.ended && film.classList.contains('shown');
})()`);
/** Halts the loop at a second of it. */
const seek_loop = (tab, at_s) => tab.evaluate((s) => new Promise((resolve) => {
  const loop = Reveal.getCurrentSlide().querySelectorAll('video')[1];
  loop.pause();
  loop.requestVideoFrameCallback(() => setTimeout(resolve, 200));
  loop.currentTime = s;
}), at_s);
const next = (tab) => tab.keyboard.press('ArrowRight');
const previous = (tab) => tab.keyboard.press('ArrowLeft');
const slide_number = (tab) => tab.evaluate(() => Reveal.getIndices().h);

const check = browser_checks();

check('plays forwards to each stop, and loops until the viewer goes on', async (browser) => {
  const {tab, faults} = await opened(browser);
  await stopped(tab);
  await wait(200);
  await shows(tab, '01', 'stop-1');
  await next(tab);
  await until(tab, 'Reveal.getCurrentSlide().querySelectorAll("video")[1].classList.contains("shown")');
  await until(tab, 'Reveal.getCurrentSlide().querySelectorAll("video")[1].currentTime > 0.2');
  assert.equal(await slide_number(tab), 1);
  // Half a turn about L.
  await seek_loop(tab, 1.0);
  await shows_another(tab, '02', 'in-the-loop');
  // Again over the seam: it shows the stop.
  await seek_loop(tab, 5.99);
  await shows(tab, '02', 'end-of-the-loop');
  await tab.evaluate(() => Reveal.getCurrentSlide().querySelectorAll('video')[1].play());
  await until(tab, 'Reveal.getCurrentSlide().querySelectorAll("video")[1].currentTime < 1');
  assert.equal(await slide_number(tab), 1);
  // The first press lets the loop run to its seam, which is the stop.
  await next(tab);
  assert.equal(await slide_number(tab), 1);
  await until(tab, 'Reveal.getIndices().h === 2');
  await stopped(tab);
  await wait(200);
  await shows(tab, '03', 'end');
  await next(tab);
  assert.equal(await slide_number(tab), 3);
  assert.deepEqual(faults, []);
});

check('goes on to the loop when the key is pressed before the film has ended', async (browser) => {
  const {tab} = await opened(browser);
  await next(tab);
  await until(tab, 'Reveal.getCurrentSlide().querySelector("video").classList.contains("shown")');
  assert.equal(await slide_number(tab), 1);
  await next(tab);
  const loops = 'Reveal.getCurrentSlide().querySelectorAll("video")[1]';
  await until(tab, `${loops}.classList.contains("shown") && ${loops}.currentTime > 0.1`, 8000);
  assert.equal(await slide_number(tab), 1);
  assert.equal(await tab.evaluate(() => Reveal.getCurrentSlide().querySelector('video').paused), true);
  // The next press ends the loop at its seam, as always.
  await next(tab);
  await until(tab, 'Reveal.getIndices().h === 2', 20000);
  await tab.close();
});

check('goes on at once when the key is pressed twice', async (browser) => {
  const {tab} = await opened(browser);
  await next(tab);
  await until(tab, 'Reveal.getCurrentSlide().querySelectorAll("video")[1].classList.contains("shown")');
  await next(tab);
  await next(tab);
  assert.equal(await slide_number(tab), 2);
});

check('shows each stop on the way back, without playing', async (browser) => {
  const {tab, faults} = await opened(browser);
  await tab.evaluate(() => Reveal.slide(3));
  for (const number of ['03', '02']) {
    await previous(tab);
    await wait(300);
    await shows(tab, number, `back-${number}`);
    assert.ok(await tab.evaluate(() => [...document.querySelectorAll('video')].every((video) => video.paused)));
  }
  // One press more returns to the loop, another one to the stop before.
  await previous(tab);
  await until(tab, '!Reveal.getCurrentSlide().querySelectorAll("video")[1].paused');
  await previous(tab);
  await wait(300);
  await shows(tab, '01', 'back-01');
  assert.deepEqual(faults, []);
});

check('prints each slide once, filled with its still', async (browser) => {
  const {tab} = await opened_file(browser, path.join(folder, 'index.html'), {fragment: '?print-pdf'});
  await until(tab, 'document.querySelectorAll(".pdf-page").length >= 4');
  const pages = await tab.evaluate(() => [...document.querySelectorAll('.pdf-page')].map((page) => {
    const still = page.querySelector('img');
    if (!still) return '';
    const [inner, outer] = [still.getBoundingClientRect(), page.getBoundingClientRect()];
    const is_visible = getComputedStyle(still).visibility === 'visible';
    const fills = is_visible && ['left', 'top', 'right', 'bottom'].every((side) => Math.abs(inner[side] - outer[side]) < 2);
    return `${still.getAttribute('src')} ${fills ? 'fills' : 'does not fill'} the page`;
  }));
  assert.deepEqual(pages, ['wobble/01.png fills the page', 'wobble/02.png fills the page', 'wobble/03.png fills the page', '']);
});
