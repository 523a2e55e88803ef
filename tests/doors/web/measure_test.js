// Measuring in the workbench. Usage: node measure_test.js MAKE_WORKBENCH POINSOT SCENES [NAME…]; POINSOT_WORKBENCH names a workbench
// that exists already. The numbers are compared with those of `poinsot fit` and with the bodies that the test throws.
'use strict';
const assert = require('node:assert/strict');
const {spawnSync} = require('node:child_process');
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');
const {browser_checks, drop, is_firefox, opened_file, ready, saved_by, scene_text, until, violations, wait, write_page} = require('./browsers.js');

const [make, poinsot, scenes, ...only] = process.argv.slice(2);
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'poinsot-measure-'));
process.on('exit', () => fs.rmSync(folder, {recursive: true, force: true}));
// The first throws of a real racket.
const recording = path.join(folder, 'throws.csv');
fs.writeFileSync(recording, fs.readFileSync(path.join(__dirname, '../../motion/measured/recording/round3_093502.csv'), 'utf8').split('\n').slice(0, 6500).join('\n'));

function made_workbench() {
  const existing = process.env['POINSOT_WORKBENCH'];
  if (existing) return existing;
  const file = path.join(folder, 'poinsot.html');
  write_page(make, [file, path.join(scenes, 'scene.schema.json'), path.join(scenes, 'generic.toml')]);
  return file;
}

const workbench = made_workbench();
const check = browser_checks(only);

async function opened(browser, {size = {width: 1280, height: 800}, before = null} = {}) {
  const opening = await opened_file(browser, workbench, {size, before});
  await ready(opening.tab);
  return opening;
}

/** What the page's module says of the table that was read last. */
const fitted = (tab, number) => tab.evaluate(async (number) => {
  const module = new FitModule();
  await module.instantiate(await WebAssembly.compile(unpacked('fit-module')), {});
  const {name, bytes} = the_workbench.measure.table;
  module.read(bytes, name);
  return module.flight(number, 'rows.csv').fit;
}, number);

/** What the program says. */
function native_fit(file, options = []) {
  const outcome = spawnSync(path.resolve(poinsot), ['fit', file, ...options], {encoding: 'utf8', cwd: path.dirname(file)});
  return {status: outcome.status, said: outcome.stdout, refusal: outcome.stderr.replace(/^\S* ?error: /, '').trim()};
}

/** Numbers agree to 1e-6 of the largest in their list, everything else exactly. */
function assert_same(ours, theirs, place = '') {
  if (typeof theirs === 'number') assert.ok(Math.abs(ours - theirs) <= 1e-6 * Math.abs(theirs), `${place}: ${ours}, not ${theirs}`);
  else if (Array.isArray(theirs) && theirs.every((x) => typeof x === 'number')) {
    assert.equal(ours.length, theirs.length, place);
    const size = Math.max(...theirs.map(Math.abs));
    theirs.forEach((x, i) => assert.ok(Math.abs(ours[i] - x) <= 1e-6 * size, `${place}: ${ours}, not ${theirs}`));
  } else if (theirs && typeof theirs === 'object') {
    assert.deepEqual(Object.keys(ours), Object.keys(theirs), place);
    for (const key of Object.keys(theirs)) assert_same(ours[key], theirs[key], `${place}.${key}`);
  } else assert.equal(ours, theirs, place);
}

// ── A body that the test throws ─────────────────────────────────────────────────────────────

const moments = [1, 0.8, 0.35];
/** ω of a hand at rest, of the body from 1.5 s to 2.3 s, and of a hand again: Euler's equations, by the classical Runge-Kutta method. */
function thrown(rate_Hz, last_s) {
  const [begin_s, end_s] = [1.5, 2.3];
  const slope = ([x, y, z]) => [((moments[1] - moments[2]) / moments[0]) * y * z, ((moments[2] - moments[0]) / moments[1]) * z * x,
    ((moments[0] - moments[1]) / moments[2]) * x * y];
  const added = (a, h, b) => a.map((x, i) => x + h * b[i]);
  let omega = [1, 11, 3];
  let t = begin_s;
  const rows = [];
  for (let k = 0; k < last_s * rate_Hz; ++k) {
    const time_s = k / rate_Hz;
    if (time_s < begin_s || time_s > end_s) {
      const near = Math.max(0, 1 - Math.max(begin_s - time_s, time_s - end_s) / 0.25);
      rows.push([time_s, ...[2, -5, 6].map((w, i) => near * w * Math.cos(23 * time_s + i) + 0.01 * Math.sin(7 * time_s + i))]);
      continue;
    }
    while (t < time_s - 1e-9) {
      const h = Math.min(0.0005, time_s - t);
      const [a, b] = [slope(omega), slope(added(omega, h / 2, slope(omega)))];
      const c = slope(added(omega, h / 2, b));
      const d = slope(added(omega, h, c));
      omega = omega.map((w, i) => w + (h / 6) * (a[i] + 2 * b[i] + 2 * c[i] + d[i]));
      t += h;
    }
    // The instrument's axes: the principal ones, turned cyclically; and the noise of a gyroscope.
    const noise = [0, 1, 2].map((i) => 0.004 * Math.sin(917 * k * (i + 1) + i));
    rows.push([time_s, omega[1] + noise[0], omega[2] + noise[1], omega[0] + noise[2]]);
  }
  return rows;
}
const csv_of = (rows) => `t,wx,wy,wz\n${rows.map((row) => row.join(',')).join('\n')}\n`;

/** Moments and flight are those that were thrown. */
function assert_thrown(fit, flight) {
  fit.moments.forEach((moment, i) => assert.ok(Math.abs(moment - moments[i]) < 0.01, `moments ${fit.moments}`));
  assert.ok(Math.abs(fit.axes[2][0]) > 0.99 && Math.abs(fit.axes[0][1]) > 0.99 && Math.abs(fit.axes[1][2]) > 0.99, `axes ${fit.axes}`);
  if (!flight) return;
  assert.ok(Math.abs(flight.begin_s - 1.5) < 0.1 && Math.abs(flight.end_s - 2.3) < 0.1, `${flight.begin_s} to ${flight.end_s} s`);
}

check('fits a recording as poinsot fit does', async (browser) => {
  const {tab, faults} = await opened(browser);
  const text = csv_of(thrown(100, 5));
  const file = path.join(folder, 'made.csv');
  fs.writeFileSync(file, text);
  await drop(tab, [['made.csv', text]]);
  await until(tab, 'document.querySelectorAll("#measure-words li").length > 0 && !document.querySelector("#findings button")');
  const native = JSON.parse(native_fit(file, ['--json']).said);
  assert_same(await fitted(tab, native.flight), native);
  assert_thrown(native, native.flights[native.flight - 1]);
  // The scene is the one that -o writes.
  native_fit(file, ['-o', 'made_flight_1.toml']);
  const scene = await scene_text(tab);
  const numbers = (text) => text.match(/-?\d+\.?\d*(e-?\d+)?/g).map(Number);
  // Which says, besides, by what the program knows its table again.
  const written = fs.readFileSync(path.join(folder, 'made_flight_1.toml'), 'utf8').replace(/  # sha256 \w+$/m, '');
  assert.equal(scene.replace(/-?\d+\.?\d*(e-?\d+)?/g, 'N'), written.replace(/-?\d+\.?\d*(e-?\d+)?/g, 'N'));
  assert_same(numbers(scene), numbers(written));
  // And shows the motion that was measured, with its points.
  const state = await tab.evaluate(() => window.poinsot.at(2));
  const measured = thrown(100, 5).find(([t]) => Math.abs(t - 2) < 1e-9).slice(1);
  state.omega_body.forEach((w, i) => assert.ok(Math.abs(w - measured[i]) < 0.05, `${state.omega_body}, measured ${measured}`));
  assert.ok(await tab.evaluate(() => the_page.figure.loaded.elements.find((e) => e.name === 'measured').shown), 'points are shown');
  assert.deepEqual(faults, []);
  await tab.close();
});

check('fits the table in an archive of phyphox', async (browser) => {
  const {tab, faults} = await opened(browser);
  const text = csv_of(thrown(100, 5));
  const archive = path.join(folder, 'phyphox 2026-01-05 10-11-12.zip');
  const zip = (files) => {
    const python = spawnSync('/usr/bin/python3', ['-c', `import json, sys, zipfile
with zipfile.ZipFile(sys.argv[1], "w", zipfile.ZIP_DEFLATED) as archive:
    for name, text in json.load(sys.stdin).items():
        archive.writestr(name, text)`, archive], {encoding: 'utf8', input: JSON.stringify(files)});
    assert.equal(python.status, 0, python.stderr);
    return fs.readFileSync(archive);
  };
  const meta = {'meta/device.csv': 'property,value\nversion,1\n', 'meta/time.csv': 'event,time\nSTART,0\n'};
  await drop(tab, [[path.basename(archive), zip({...meta, 'Accelerometer.csv': 'a,b\n1,2\n', 'Gyroscope.csv': text})]]);
  await until(tab, 'document.querySelectorAll("#measure-words li").length > 0');
  const file = path.join(folder, 'Gyroscope.csv');
  fs.writeFileSync(file, text);
  const native = JSON.parse(native_fit(file, ['--json']).said);
  assert_same(await fitted(tab, native.flight), native);
  assert.match(await scene_text(tab), /"Gyroscope_flight_1\.csv"/);
  // By the button of Measure, too; and what has no table says so.
  const chosen = await tab.$('#measure-file');
  fs.writeFileSync(archive, zip(meta));
  await chosen.uploadFile(archive);
  await until(tab, 'document.querySelector("#measure-message.refused")');
  assert.match(await tab.$eval('#measure-message', (p) => p.textContent), /^phyphox.*: there is no table/);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('lists the throws of a real recording, and picks one', async (browser) => {
  const {tab, faults} = await opened(browser);
  await drop(tab, [['throws.csv', fs.readFileSync(recording)]]);
  await until(tab, 'document.querySelectorAll("#measure-flights input").length > 0', 120000);
  const native = JSON.parse(native_fit(recording, ['--json']).said);
  assert.equal(await tab.$$eval('#measure-flights input', (rows) => rows.length), native.flights.length);
  await until(tab, 'document.querySelectorAll("#measure-words li").length > 0');
  const picked = () => tab.$eval('#measure-flights input:checked', (button) => Number(button.value));
  assert.equal(await picked(), native.flight, 'the best one is picked');
  assert_same(await fitted(tab, native.flight), native);
  // By the keyboard, and by a press on the chart.
  await tab.focus('#measure-flights input:checked');
  const shows = (number) => until(tab, `the_workbench.editor.text.includes("throws_flight_${number}.csv")`);
  const n = native.flights.length;
  const next = (native.flight % n) + 1;
  const other = (next % n) + 1;
  assert.equal(new Set([native.flight, next, other]).size, 3);
  await tab.keyboard.press('ArrowDown');
  await shows(next);
  const place = await tab.evaluate((t) => {
    const {whole} = the_workbench.measure;
    const {left, right} = whole.box;
    const box = whole.canvas.getBoundingClientRect();
    return {x: box.left + left + ((t - whole.plot.from_s) / (whole.plot.to_s - whole.plot.from_s)) * (right - left), y: box.top + 40};
  }, (native.flights[other - 1].begin_s + native.flights[other - 1].end_s) / 2);
  await tab.mouse.click(place.x, place.y);
  await shows(other);
  assert.equal(await picked(), other);
  assert_same(await fitted(tab, other), JSON.parse(native_fit(recording, ['--json', '--flight', `${other}`]).said));
  const first_word = await tab.$eval('#measure-words li', (row) => row.textContent);
  assert.ok(native_fit(recording, ['--flight', `${other}`]).said.includes(`\n${first_word}\n`), first_word);
  assert.deepEqual(await violations(tab), []);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('says of a bad table what the program says', async (browser) => {
  const {tab, faults} = await opened(browser);
  const before = await scene_text(tab);
  const rows = (of) => csv_of(Array.from({length: 60}, (_, k) => of(k)));
  for (const text of ['', 'a,b\n1,2\n', 't,wx,wy,wz\n0,1,2,x\n', 't,wx,wy,wz\n1,1,2,3\n0,1,2,3\n', 't,wx,wy,wz\n0,1,2,nan\n', 'PK\u0003\u0004\u0014\u0000',
    rows((k) => [k / 50, 0, 0, 0]), rows((k) => [k / 50, 0, 3, 0]), rows((k) => [k / 50, 8 * Math.sin(k * k), 8 * Math.sin(3 * k * k), 5])]) {
    const file = path.join(folder, 'bad.csv');
    fs.writeFileSync(file, text);
    const {status, refusal} = native_fit(file);
    assert.equal(status, 2, text);
    await drop(tab, [['bad.csv', text]]);
    await until(tab, 'document.querySelector("#measure-message.refused")');
    const said = await tab.$eval('#measure-message', (p) => p.textContent);
    assert.ok(said.length > 10 && refusal.replaceAll(`${folder}/`, '').includes(said), `"${said}" is not "${refusal}"`);
    await tab.evaluate(() => document.getElementById('measure-message').classList.remove('refused'));
  }
  assert.equal(await scene_text(tab), before, 'the scene stays');
  assert.deepEqual(faults, []);
  await tab.close();
});

// ── Recording ───────────────────────────────────────────────────────────────────────────────

/** What the accelerometer feels in `thrown`, m/s²: nearly nothing in flight. */
const felt_in_throw = (rows) => rows.map(([t]) => (t > 1.5 && t < 2.3 ? 1.5 : 9.8));

/** Presses Record, and gives the page events of motion from then on, one row in 4 ms or more, so that a slow machine only takes longer.
 * The times of events are those of the rows. */
async function record(tab, rows, felt = [], has_gyroscope = true) {
  await tab.click('#measure-open');
  await tab.evaluate((rows, felt, has_gyroscope) => {
    const degree = Math.PI / 180;
    // Chromium grants the permission a moment after the press.
    let listens = false;
    const add = window.addEventListener;
    window.addEventListener = (...given) => {
      listens ||= given[0] === 'devicemotion';
      add.apply(window, given);
    };
    const timer = setInterval(() => {
      const row = listens && the_workbench.measure.recorder && rows.shift();
      if (row) {
        const [time_s, x, y, z] = row;
        const rate = (w) => (has_gyroscope ? w / degree : null);
        const size = felt.shift();
        const event = new DeviceMotionEvent('devicemotion', {interval: 16, rotationRate: {alpha: rate(x), beta: rate(y), gamma: rate(z)},
          ...(size === undefined ? {} : {accelerationIncludingGravity: {x: 0, y: 0.6 * size, z: 0.8 * size}})});
        Object.defineProperty(event, 'timeStamp', {value: 5000 + 1000 * time_s});
        window.dispatchEvent(event);
      }
      if (rows.length === 0) clearInterval(timer);
    }, 4);
  }, rows, felt, has_gyroscope);
  await tab.click('#record');
}

check('records a throw, and stops after the catch', async (browser) => {
  const {tab, faults} = await opened(browser, {size: {width: 390, height: 844}});
  await record(tab, thrown(60, 30));
  await until(tab, 'document.getElementById("measure-time").textContent > "1"');
  await until(tab, 'document.querySelectorAll("#measure-words li").length > 0', 20000);
  const last_s = await tab.evaluate(() => the_workbench.measure.table.read.rows.at(-4));
  assert.ok(last_s > 2.9 && last_s < 10, `it stopped at ${last_s} s`);
  const file = path.join(folder, 'recorded.csv');
  fs.writeFileSync(file, await saved_by(tab, 'record-save'));
  const native = JSON.parse(native_fit(file, ['--json']).said);
  assert_thrown(native, native.flights[native.flight - 1]);
  assert_same(await fitted(tab, native.flight), native);
  // To the microsecond and nine digits, the rows are those that were measured.
  const rows = fs.readFileSync(file, 'utf8').trim().split('\n').slice(1).map((line) => line.split(',').map(Number));
  const given = thrown(60, 30);
  rows.forEach((row, k) => row.forEach((x, i) => assert.ok(Math.abs(x - given[k][i]) < 1e-6, `row ${k}: ${row}, not ${given[k]}`)));
  assert.deepEqual(await violations(tab), []);
  assert.deepEqual(faults, []);
  await tab.close();
});

/** Where ω about the middle axis, the instrument's first, is zero in the flight: seconds after its beginning. */
function flip_of(rows) {
  const flight = rows.filter(([t]) => t >= 1.5 && t <= 2.3);
  const k = flight.findIndex((row, i) => i > 0 && row[1] * flight[i - 1][1] < 0);
  return flight[k][0] - 1.5;
}

check('says first what a throw did, and shows it in half of the height', async (browser) => {
  for (const [width, height] of [[390, 664], [320, 568], [664, 340]]) {
    const {tab, faults} = await opened(browser, {size: {width, height, isMobile: !is_firefox, hasTouch: !is_firefox}});
    await drop(tab, [['throw.csv', csv_of(thrown(60, 5))]]);
    await until(tab, 'the_workbench.editor.text.includes("throw_flight_1.csv") && the_page.figure.frame === 0');
    const sentence = await tab.$eval('#measure-sentence', (p) => p.textContent);
    const [, at] = /^The body turned over once, after (0\.\d\d) s, about its middle axis\.$/.exec(sentence) ?? [];
    assert.ok(Math.abs(Number(at) - flip_of(thrown(1000, 3))) < 0.04, `${sentence} ${flip_of(thrown(1000, 3))}`);
    // Each ratio is within its deviations of the body that was thrown, and says what it is.
    const said = await tab.$eval('#measure-ratios', (p) => p.textContent);
    const ratios = [...said.matchAll(/(0\.\d+)\u00a0±\u00a0(0\.\d+)/g)].map(([, value, sd]) => [Number(value), Number(sd)]);
    assert.equal(ratios.length, 2);
    ratios.forEach(([value, sd], k) => assert.ok(Math.abs(value - moments[k + 1]) < 5 * sd && sd < 0.01, said));
    assert.match(said, /moments of inertia/);
    const shown = await tab.evaluate(() => {
      const box = document.getElementById('stage').getBoundingClientRect();
      const sees = (/** @type {string} */ id) => document.getElementById(id).checkVisibility();
      const place = document.getElementById('measure').getBoundingClientRect();
      return {width: box.width, height: box.height, right: box.right, bottom: document.getElementById('bar').getBoundingClientRect().bottom, overlaps: place.bottom > box.top + 1 && place.right > box.left + 1,
        wide: document.documentElement.scrollWidth, sees: ['measure-charts', 'measure-words', 'tools', 'record', 'measure-more', 'measure-close'].filter(sees)};
    });
    assert.ok(shown.height >= height / 2, `the picture has ${shown.height} of ${height}`);
    assert.ok(Math.abs(shown.right - width) < 1 && (width > height || shown.width === width), `it has ${shown.width} of ${width}`);
    assert.ok(shown.bottom <= height + 1 && shown.wide <= width && !shown.overlaps, JSON.stringify(shown));
    assert.deepEqual(shown.sees, ['record', 'measure-more', 'measure-close'].filter((id) => shown.sees.includes(id)));
    assert.ok(shown.sees.includes('measure-more') && shown.sees.includes('measure-close'));
    assert.deepEqual(await violations(tab), []);
    // The numbers are one press away, none over another.
    await tab.click('#measure-more');
    const boxes = await tab.evaluate(() => ['measure-charts', 'measure-flights', 'measure-words'].map((id) => {
      const {top, bottom} = document.getElementById(id).getBoundingClientRect();
      return [top, bottom];
    }).sort((a, b) => a[0] - b[0]));
    boxes.forEach(([top, bottom], k) => assert.ok(bottom - top > 20 && (k === 0 || top >= boxes[k - 1][1] - 1), JSON.stringify(boxes)));
    await tab.click('#measure-more');
    // Closed, the tools are there again.
    await tab.click('#measure-close');
    assert.ok(await tab.evaluate(() => document.getElementById('tools').checkVisibility()));
    assert.deepEqual(faults, []);
    await tab.close();
  }
});

check('is felt and heard, and keeps the screen awake while it records', async (browser) => {
  const {tab, faults} = await opened(browser, {size: {width: 390, height: 664}, before: () => {
    window.done = [];
    navigator.vibrate = (pattern) => window.done.push(`vibrates ${JSON.stringify(pattern)}`) > 0;
    Object.defineProperty(navigator, 'wakeLock', {value: {request: async (kind) => {
      window.done.push(`awake: ${kind}`);
      return {release: async () => { window.done.push('asleep'); }};
    }}});
    const start = OscillatorNode.prototype.start;
    OscillatorNode.prototype.start = function (...when) {
      window.done.push(`tone ${this.frequency.value}`);
      start.apply(this, when);
    };
  }});
  await record(tab, thrown(60, 30));
  await until(tab, 'document.getElementById("measure-time").textContent > "1"');
  assert.deepEqual(await tab.evaluate(() => window.done), ['awake: screen', 'vibrates 150', 'tone 660']);
  // The button that ends it is large, and the tools are not in reach.
  const {height, width} = await tab.$eval('#record-stop', (button) => button.getBoundingClientRect().toJSON());
  assert.ok(height >= 60 && width > 300, `${width} × ${height}`);
  assert.equal(await tab.evaluate(() => document.getElementById('tools').checkVisibility()), false);
  await until(tab, '!document.getElementById("measure-said").hidden', 20000);
  assert.deepEqual(await tab.evaluate(() => window.done.slice(3)), ['vibrates [120,80,120]', 'tone 660', 'tone 990', 'asleep']);
  assert.match(await tab.$eval('#measure-sentence', (p) => p.textContent), /^Your phone turned over once/);
  assert.match(await scene_text(tab), /^title = "My throw, \d/);
  assert.match(await tab.$eval('#record', (button) => button.textContent), /again/);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('says to one who throws what was wrong, and ends by itself', async (browser) => {
  const {tab, faults} = await opened(browser, {size: {width: 390, height: 664}});
  // Flat as a disc: a turn about one axis alone.
  const flat = thrown(60, 30).map(([t, ...omega]) => (t > 1.5 && t < 2.3 ? [t, 0.01 * Math.sin(917 * t), 0.01 * Math.sin(531 * t), 12] : [t, ...omega.map((w) => 0.02 * w)]));
  await record(tab, flat, felt_in_throw(flat));
  await until(tab, 'document.querySelector("#measure-message.refused")', 30000);
  assert.match(await tab.$eval('#measure-message', (p) => p.textContent), /about one axis alone.*end over end/);
  assert.equal(await tab.evaluate(() => document.getElementById('motion-words').checkVisibility()), false, 'what the example does is no answer');
  const rows = (await saved_by(tab, 'record-save')).trim().split('\n').length - 1;
  assert.ok(rows < 60 * 8, `it ended after ${rows} rows`);
  assert.deepEqual(faults, []);
  await tab.close();
  const none = await opened(browser, {size: {width: 390, height: 664}});
  await record(none.tab, flat, felt_in_throw(flat), false);
  await until(none.tab, 'document.querySelector("#measure-message.refused")?.textContent.includes("has no gyroscope")', 20000);
  assert.deepEqual(none.faults, []);
  await none.tab.close();
});

check('stops a recording on request, and keeps it', async (browser) => {
  const {tab, faults} = await opened(browser);
  await record(tab, thrown(60, 1.2));
  await until(tab, 'parseFloat(document.getElementById("measure-time").textContent) > 0.9');
  await tab.click('#record-stop');
  await until(tab, 'document.querySelector("#measure-message.refused")');
  const file = path.join(folder, 'recording.csv');
  fs.writeFileSync(file, await saved_by(tab, 'record-save'));
  assert.equal(native_fit(file).refusal.replaceAll(`${folder}/`, ''), await tab.$eval('#measure-message', (p) => p.textContent));
  assert.deepEqual(faults, []);
  await tab.close();
});

check('ends a recording by its own button alone', async (browser) => {
  const {tab, faults} = await opened(browser);
  await record(tab, thrown(60, 1.2));
  await until(tab, 'parseFloat(document.getElementById("measure-time").textContent) > 0.5');
  assert.equal(await tab.$eval('#measure-close', (button) => button.offsetParent), null, 'its cross is away from the thumb');
  await tab.focus('#record-stop');
  await tab.keyboard.press('Escape');
  await tab.click('#measure-open');
  await drop(tab, [['other.csv', csv_of(thrown(100, 5))]]);
  await until(tab, 'document.getElementById("measure-message").textContent.includes("Stop ends it")');
  assert.equal(await tab.evaluate(() => {
    const event = new Event('beforeunload', {cancelable: true});
    window.dispatchEvent(event);
    return event.defaultPrevented;
  }), true, 'it asks before the page is left');
  await until(tab, 'parseFloat(document.getElementById("measure-time").textContent) > 1.1');
  assert.equal(await tab.$eval('#measure', (part) => part.hidden), false);
  await tab.click('#record-stop');
  await until(tab, 'document.querySelector("#measure-message.refused")');
  const rows = (await saved_by(tab, 'record-save')).trim().split('\n').length - 1;
  assert.equal(rows, 72, 'every row is there');
  await tab.click('#measure-close');
  assert.equal(await tab.$eval('#measure', (part) => part.hidden), true);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('says what recording needs', async (browser) => {
  // No gyroscope answers.
  const none = await opened(browser);
  await none.tab.click('#measure-open');
  await none.tab.click('#record');
  await until(none.tab, 'document.querySelector("#measure-message.refused")?.textContent.includes("https")', 10000);
  assert.equal(await none.tab.$eval('#record', (button) => button.hidden), false, 'it can be tried again');
  await none.tab.close();
  // The viewer refuses, as iOS asks.
  const refused = await opened(browser, {before: () => { DeviceMotionEvent.requestPermission = () => Promise.resolve('denied'); }});
  await refused.tab.click('#measure-open');
  await refused.tab.click('#record');
  await until(refused.tab, 'document.querySelector("#measure-message.refused")?.textContent.includes("may not read")');
  await refused.tab.close();
  // The page is not from https.
  const insecure = await opened(browser, {before: () => { Object.defineProperty(window, 'isSecureContext', {value: false}); }});
  await insecure.tab.click('#measure-open');
  assert.equal(await insecure.tab.$eval('#record', (button) => button.hidden), true);
  assert.match(await insecure.tab.$eval('#measure-message', (p) => p.textContent), /https/);
  assert.deepEqual([...none.faults, ...refused.faults, ...insecure.faults], []);
  await insecure.tab.close();
});

// The sensor that Chromium's tools feed; Firefox has none.
if (!is_firefox)
  check('reads the gyroscope, axis by axis', async (browser) => {
    const {tab} = await opened(browser);
    const tools = await tab.createCDPSession();
    await tools.send('Emulation.setSensorOverrideEnabled', {enabled: true, type: 'gyroscope', metadata: {available: true, minimumFrequency: 1, maximumFrequency: 60}});
    await tab.click('#measure-open');
    await tab.click('#record');
    let taken = [], last = 1;
    for (let k = 0; k < 400 && taken.length < 32; ++k) {
      last = 1 + 0.01 * k;
      await tools.send('Emulation.setSensorOverrideReadings', {type: 'gyroscope', reading: {xyz: {x: last, y: 2, z: 3}}});
      await wait(40);
      taken = await tab.evaluate(() => the_workbench.measure.recorder?.taken.gyroscope ?? []);
    }
    assert.ok(taken.length >= 32, 'the gyroscope is read');
    const row = taken.slice(-4);
    assert.ok(row[0] > 0.1 && row[1] >= 1 && row[1] < last + 0.01, `${row}`);
    // Chromium rounds readings.
    assert.ok(Math.abs(row[2] - 2) < 0.01 && Math.abs(row[3] - 3) < 0.01, `${row}`);
    await tab.close();
  });
