// How fast a page makes films, and what takes the time: films of scenes/generic.toml in Chromium, with Mesa's or Chromium's software renderer.
// Processor time, as Linux counts it for the processes of the browser, does not depend on what else runs.
// Usage: node page_films.js POINSOT
'use strict';
const {execFileSync} = require('node:child_process');
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');
const {launched, opened_file, page_of, ready} = require('../doors/web/browsers.js');

const [program] = process.argv.slice(2);
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'poinsot-page-films-'));
process.on('exit', () => fs.rmSync(folder, {recursive: true, force: true}));
const options = ['--set', 'film.duration_s=4', '--set', 'film.still_s=1'];
const scene = path.join(__dirname, '../../scenes/generic.toml');
const ticks_a_second = Number(execFileSync('getconf', ['CLK_TCK']));

/** Seconds of processor time of the processes that a browser has started, by their kind. */
function cpu_of(root) {
  const rows = fs.readdirSync('/proc').filter((name) => /^\d+$/.test(name)).flatMap((pid) => {
    try {
      const stat = fs.readFileSync(`/proc/${pid}/stat`, 'utf8').split(') ')[1].split(' ');
      const kind = /--type=([a-z-]+)/.exec(fs.readFileSync(`/proc/${pid}/cmdline`, 'latin1'))?.[1] ?? 'browser';
      return [{pid: Number(pid), parent: Number(stat[1]), kind, s: (Number(stat[11]) + Number(stat[12])) / ticks_a_second}];
    } catch {
      return [];
    }
  });
  const ours = new Set([root]);
  for (let n = 0; n !== ours.size;) {
    n = ours.size;
    for (const {pid, parent} of rows) if (ours.has(parent)) ours.add(pid);
  }
  const sums = {};
  for (const {pid, kind, s} of rows) if (ours.has(pid)) sums[kind] = (sums[kind] ?? 0) + s;
  return sums;
}

async function measure() {
  const browser = await launched();
  const root = browser.process().pid;
  const {tab} = await opened_file(browser, page_of(program, scene, path.join(folder, 'page.html'), options));
  await ready(tab);
  await tab.evaluate('poinsot.pause()');
  for (const [width, height] of [[640, 360], [1920, 1080]]) {
    const natively = path.join(folder, `native_${width}.mp4`);
    const native_began = Date.now();
    execFileSync(program, ['render', scene, '-o', natively, '--size', `${width}x${height}`, '--jobs', '1', '--quiet', ...options]);
    const native_s = (Date.now() - native_began) / 1000;
    for (const kind of ['mp4', 'webm']) {
      const before = cpu_of(root);
      const {n_frames, all_s, draw_s, encode_s} = await tab.evaluate(async ({width, height, kind}) => {
        window.showSaveFilePicker = undefined;
        the_page.save = () => {};
        let [draw_s, encode_s, n_frames] = [0, 0, 0];
        const [draw, add] = [Program.prototype.filmFrame, FrameEncoder.prototype.add];
        Program.prototype.filmFrame = function (...given) {
          const began = performance.now();
          const bytes = draw.apply(this, given);
          draw_s += (performance.now() - began) / 1000;
          ++n_frames;
          return bytes;
        };
        FrameEncoder.prototype.add = async function (...given) {
          const began = performance.now();
          await add.apply(this, given);
          encode_s += (performance.now() - began) / 1000;
        };
        const began = performance.now();
        await the_page.options.films.make({...the_page.options.films.settings(), kind, width, height, span: {kind: 'whole', index: 0}});
        Object.assign(Program.prototype, {filmFrame: draw});
        Object.assign(FrameEncoder.prototype, {add});
        return {n_frames, draw_s, encode_s, all_s: (performance.now() - began) / 1000};
      }, {width, height, kind});
      const after = cpu_of(root);
      const ms = (s) => ((1000 * s) / n_frames).toFixed(0);
      console.log(`${width}x${height} ${kind}: ${(n_frames / all_s).toFixed(1)} frames a second (program: ${(n_frames / native_s).toFixed(1)}); ` +
        `a frame waits ${ms(draw_s)} ms for its drawing and ${ms(encode_s)} ms for the encoder; processor time ` +
        Object.keys(after).map((name) => `${name} ${ms(after[name] - (before[name] ?? 0))} ms`).join(', '));
    }
  }
  await browser.close();
}

void measure().then(() => process.exit(0));
