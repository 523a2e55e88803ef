// Films made in a page, at length: films of whole scenes beside those of the program, and what can happen while one is made.
// Usage: node film_proof_test.js POINSOT [NAME…]
'use strict';
const assert = require('node:assert/strict');
const fs = require('node:fs');
const path = require('node:path');
const {browser_checks, is_firefox, opened_file, page_of, ready, until} = require('./browsers.js');
const {assert_film, assert_same_frames, film_file, folder, made, native_frames_of, poinsot, rgb_of, said, verified} = require('./film_checks.js');

const [program, ...only] = process.argv.slice(2);
const scenes = path.join(__dirname, '../../../scenes');
const scene_file = (name) => path.join(scenes, `${name}.toml`);

const check = browser_checks(only);

// Spans of 3 s and more: of lecture_construction a chapter in which captions change and the camera moves, of measured all.
for (const [name, options, span] of [['generic', ['--set', 'film.duration_s=4', '--set', 'film.still_s=1'], 'whole'],
  ['lecture_construction', [], 'chapter 2'], ['heavy_top_looping', ['--set', 'film.duration_s=4', '--set', 'film.still_s=1'], 'whole'], ['measured', [], 'whole']])
  check(`makes films of ${name}`, async (browser) => {
    const {tab, faults} = await opened_file(browser, page_of(program, scene_file(name), path.join(folder, `${name}.html`), options));
    await ready(tab);
    let native = null;
    for (const [kind, codec] of [['mp4', 'h264'], ['webm', 'vp9']]) {
      const began = Date.now();
      const file = await film_file(tab, `${name}.${kind}`, {kind, span});
      const seconds = (Date.now() - began) / 1000;
      const [first, last] = JSON.parse(poinsot('explain', file, '--json')).frames;
      console.log(`      ${name}.${kind}: frames ${first} to ${last}, ${((last - first + 1) / seconds).toFixed(1)} a second`);
      native ??= native_frames_of(scene_file(name), name, undefined, [...options, '--frames', `${first}-${last}`]);
      assert_film(file, codec, last - first + 1);
      assert_same_frames(rgb_of(['-i', file]), native);
      assert.match(verified(file)[1], /unchanged, record and pictures/);
    }
    assert.deepEqual(faults, []);
    await tab.close();
  });

/** A page of generic.toml that lasts for so long. */
const page_of_s = (duration_s) =>
  page_of(program, scene_file('generic'), path.join(folder, `for_${duration_s}.html`), ['--set', `film.duration_s=${duration_s}`, '--set', 'film.still_s=0']);

check('goes on in a hidden tab', async (browser) => {
  const {tab, faults} = await opened_file(browser, page_of_s(4), {before: () => {
    // A hidden tab draws no frames, and its timers ring once a second.
    window.hide = () => {
      Object.defineProperty(document, 'visibilityState', {get: () => 'hidden'});
      Object.defineProperty(document, 'hidden', {get: () => true});
      window.requestAnimationFrame = () => 0;
      const ring = window.setTimeout;
      window.setTimeout = (action, ms = 0) => ring(action, Math.max(1000, ms));
      document.dispatchEvent(new Event('visibilitychange'));
    };
  }});
  await ready(tab);
  const film = made(tab, {kind: 'mp4', width: 160, height: 90});
  await until(tab, 'document.getElementById("film-done").value > 0.1');
  await tab.evaluate('hide()');
  const other = await browser.newPage();
  await other.bringToFront();
  const began = Date.now();
  assert.ok(await film, await said(tab));
  // By the timers of a hidden tab, the other hundred frames would take more than a minute.
  assert.ok(Date.now() - began < 40000, `${Date.now() - began} ms`);
  assert.deepEqual(faults, []);
  await other.close();
  await tab.close();
});

check('needs no more memory for a longer film', async (browser) => {
  const {tab, faults} = await opened_file(browser, page_of_s(16));
  await ready(tab);
  const film = tab.evaluate(async () => {
    window.n_bytes = 0;
    window.showSaveFilePicker = async () => ({createWritable: async () => ({
      write: async ({data}) => { window.n_bytes += data.length; }, close: async () => {}, abort: async () => {},
    })});
    await the_page.options.films.make({...the_page.options.films.settings(), kind: 'webm', quality: 'reference', width: 96, height: 54, rate: 125});
    return document.getElementById('film-message').textContent;
  });
  const used = async (n_frames) => {
    await until(tab, `document.getElementById('film-done').value >= ${n_frames / 2000}`, 300000);
    const metrics = is_firefox ? null : await tab.metrics();
    return [metrics?.JSHeapUsedSize ?? 0, await tab.evaluate('the_page.options.films.run.program.exports.memory.buffer.byteLength')];
  };
  const before = [await used(400), await used(500), await used(600)];
  const after = [await used(1700), await used(1800), await used(1900)];
  assert.match(await film, /is saved/);
  const n_bytes = await tab.evaluate('n_bytes');
  // The least of three: between two collections of garbage the heap grows and falls.
  const least = (rows, k) => Math.min(...rows.map((row) => row[k])) / 1e6;
  console.log(`      ${(n_bytes / 1e6).toFixed(1)} MB written; heap ${least(before, 0).toFixed(1)} MB and ${least(after, 0).toFixed(1)} MB, module ${least(before, 1).toFixed(1)} MB and ${least(after, 1).toFixed(1)} MB`);
  assert.ok(least(after, 0) - least(before, 0) < 4, 'the heap grows');
  assert.equal(least(after, 1), least(before, 1));
  assert.deepEqual(faults, []);
  await tab.close();
});

check('saves nothing where the graphics are lost or the encoder fails in the middle', async (browser) => {
  const {tab} = await opened_file(browser, page_of_s(4));
  await ready(tab);
  for (const [harm, sentence] of [
    ["the_page.options.films.run.program.gl.getExtension('WEBGL_lose_context').loseContext()", /took the graphics memory away; nothing was saved/],
    ["VideoEncoder.prototype.encode = () => { throw new DOMException('it is too hot', 'OperationError'); }", /failed; nothing was saved: it is too hot/]]) {
    const film = made(tab, {kind: 'mp4', width: 160, height: 90});
    await until(tab, 'document.getElementById("film-done").value > 0.2');
    await tab.evaluate(harm);
    assert.equal(await film, null);
    assert.match(await said(tab), sentence);
    // The figure goes on, and another film can be made.
    assert.ok(await tab.evaluate('!document.getElementById("film-make").hidden && the_page.figure.program !== null'));
  }
  await tab.close();
});
