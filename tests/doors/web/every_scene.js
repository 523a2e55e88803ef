// Opens every scene as a page, on a desk and on a phone; checks that nothing overlaps or is cut off, and puts the pictures
// on sheets. Usage: node every_scene.js POINSOT SCENES OUT [SCENE…]; POINSOT is "-" where OUT holds the pages
// already.
'use strict';
const assert = require('node:assert/strict');
const fs = require('node:fs');
const path = require('node:path');
const {browser_checks, opened_file, page_of, ready, settled, wait} = require('./browsers.js');

const [program, folder, out, ...only] = process.argv.slice(2);
const all = fs.readdirSync(folder).filter((name) => name.endsWith('.toml')).map((name) => name.slice(0, -5));
const scenes = only.length > 0 ? only : all;
fs.mkdirSync(out, {recursive: true});

const screens = [
  {name: 'desk', size: {width: 1280, height: 720}, n_columns: 4, tile_px: 480, a_sheet: 8},
  {name: 'phone', size: {width: 390, height: 844, deviceScaleFactor: 2}, n_columns: 8, tile_px: 240, a_sheet: 12},
];

/** What is wrong with the layout; runs in the page. @returns {string[]} */
function faults_of_layout() {
  const wrong = [];
  const seen = (element) => element.offsetParent !== null && getComputedStyle(element).visibility === 'visible';
  const name_of = (element) => element.id || element.className || element.textContent.trim().slice(0, 20);
  const boxes = [...document.querySelectorAll('#bar > *')].filter(seen).map((element) => [name_of(element), element.getBoundingClientRect()]);
  boxes.forEach(([name, a], i) => {
    if (a.left < -0.5 || a.right > innerWidth + 0.5 || a.bottom > innerHeight + 0.5) wrong.push(`${name} leaves the window`);
    for (const [other, b] of boxes.slice(i + 1))
      if (a.left < b.right - 0.5 && b.left < a.right - 0.5 && a.top < b.bottom - 0.5 && b.top < a.bottom - 0.5) wrong.push(`${name} overlaps ${other}`);
  });
  const canvas = document.querySelector('canvas').getBoundingClientRect();
  const bar = document.getElementById('bar').getBoundingClientRect();
  if (canvas.bottom > bar.top + 0.5) wrong.push('the bar covers the picture');
  if (document.documentElement.scrollWidth > innerWidth) wrong.push('the page scrolls sideways');
  for (const element of document.querySelectorAll('#bar, #time, #options, #options label, #options legend, #options button'))
    if (seen(element) && element.scrollWidth > element.clientWidth + 1) wrong.push(`${name_of(element)} is cut off`);
  const options = document.getElementById('options').getBoundingClientRect();
  if (options.width > 0 && canvas.right > options.left + 0.5 && canvas.bottom > options.top + 0.5) wrong.push('the options cover the picture');
  return wrong;
}

/** Puts pictures in rows on sheets. */
async function write_sheets(browser, screen, pictures) {
  const {name, n_columns, tile_px, a_sheet} = screen;
  for (let first = 0; first < pictures.length; first += a_sheet) {
    const tiles = pictures.slice(first, first + a_sheet).flatMap(({scene, files}) =>
      files.map((file) => `<figure><img src="data:image/png;base64,${fs.readFileSync(file).toString('base64')}"><figcaption>${scene}: ${path.basename(file, '.png').split('.').pop()}</figcaption></figure>`));
    const tab = await browser.newPage();
    await tab.setViewport({width: n_columns * (tile_px + 8), height: 600});
    await tab.setContent(`<!doctype html><style>body{margin:0;display:grid;grid-template-columns:repeat(${n_columns},${tile_px}px);gap:8px;background:#888;font:14px sans-serif}
      figure{margin:0}img{width:100%;display:block}</style>${tiles.join('')}`);
    await tab.screenshot({path: path.join(out, `sheet_${name}_${1 + first / a_sheet}.png`), fullPage: true});
    await tab.close();
  }
}

const check = browser_checks();
const pictures = {desk: [], phone: []};
for (const scene of scenes) {
  check(scene, async (browser) => {
    const wrong = [];
    const file = path.join(out, `${scene}.html`);
    if (program !== '-') page_of(program, path.join(folder, `${scene}.toml`), file);
    const {tab, faults} = await opened_file(browser, file, {size: screens[0].size});
    await ready(tab);
    for (const {name, size} of screens) {
      await tab.setViewport(size);
      const files = [];
      const shot = async (what) => {
        const picture = path.join(out, `${scene}.${name}.${what}.png`);
        await tab.screenshot({path: picture});
        files.push(picture);
        wrong.push(...(await tab.evaluate(faults_of_layout)).map((fault) => `${name}, ${what}: ${fault}`));
      };
      await settled(tab);
      await tab.evaluate(() => document.body.classList.remove('drawn'));
      if (name === 'desk') await shot('poster');
      await tab.evaluate(() => document.body.classList.add('drawn'));
      await shot('live');
      if (name === 'phone') {
        await tab.click('#show-options');
        await settled(tab);
        await wait(300);
        await settled(tab);
        await shot('options');
        await tab.click('#close');
      }
      pictures[name].push({scene, files});
    }
    await tab.close();
    assert.deepEqual([...wrong, ...faults], []);
  });
}

check('the pictures are on sheets', async (browser) => {
  for (const screen of screens) await write_sheets(browser, screen, pictures[screen.name]);
});
