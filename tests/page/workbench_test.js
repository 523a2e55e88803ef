// The workbench in Chromium. Usage: node workbench_test.js MAKE_WORKBENCH SCENES [NAME…]; POINSOT_WORKBENCH names one that
// exists already.
'use strict';
const assert = require('node:assert/strict');
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');
const {opened_file, ready, run_checks, saved_by, until, violations, wait, write_page} = require('./browsers.js');

const [make, scenes, ...only] = process.argv.slice(2);
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'poinsot-workbench-'));
process.on('exit', () => fs.rmSync(folder, {recursive: true, force: true}));

function made_workbench() {
  const existing = process.env['POINSOT_WORKBENCH'];
  if (existing) return existing;
  const file = path.join(folder, 'poinsot.html');
  write_page(make, [file, path.join(scenes, 'scene.schema.json'), path.join(__dirname, 'lecture.toml'),
    path.join(scenes, 'generic.toml'), path.join(scenes, 'heavy_top_wavy.toml')]);
  return file;
}

const workbench = made_workbench();
const checks = [];
const check = (name, run) => checks.push([name, run]);

async function opened(browser) {
  const opening = await opened_file(browser, workbench, {size: {width: 1100, height: 640}});
  await ready(opening.tab);
  return opening;
}

/** Replaces the text of the scene, as typing does. */
const write = (tab, text) => tab.evaluate((text) => {
  const field = document.getElementById('text');
  field.value = text;
  field.dispatchEvent(new Event('input'));
}, text);

/** What "Data (CSV)" saves, by rows. @returns {Promise<string[]>} */
const rows_of_csv = async (tab) => (await saved_by(tab, 'export-csv')).trim().split('\n');

check('shows the scene of the text beside it', async (browser) => {
  const {tab, faults} = await opened(browser);
  const text = await tab.$eval('#text', (field) => field.value);
  await write(tab, text.replace(/omega_rad_s = .*/, 'omega_rad_s = [0.4, 1.5, 0.7]'));
  await until(tab, 'window.poinsot.at(0).omega_body[0] === 0.4');
  assert.ok((await tab.$eval('#findings', (f) => f.textContent)).length > 10, 'the regime is said');
  assert.deepEqual(faults, []);
  await tab.close();
});

check('shows a refusal at its line, and keeps the picture', async (browser) => {
  const {tab, faults} = await opened(browser);
  const text = await tab.$eval('#text', (field) => field.value);
  await write(tab, text.replace('moments_kg_m2', 'moment_kg_m2'));
  await until(tab, 'document.querySelector("#findings button")');
  assert.match(await tab.$eval('#findings', (f) => f.textContent), /did you mean "moments_kg_m2"/);
  const line = text.split('\n').findIndex((row) => row.startsWith('moments_kg_m2')) + 1;
  assert.equal(await tab.$eval('#gutter b', (b) => Number(b.textContent)), line);
  await tab.click('#findings button');
  assert.equal(await tab.$eval('#text', (f) => f.value.slice(0, f.selectionStart).split('\n').length), line);
  await write(tab, text);
  await until(tab, '!document.querySelector("#findings button")');
  assert.deepEqual(faults, []);
  await tab.close();
});

check('refuses hostile scenes and lives on', async (browser) => {
  const {tab, faults} = await opened(browser);
  const text = await tab.$eval('#text', (field) => field.value);
  for (const hostile of ['', '\u0000', `a = ${'['.repeat(100000)}`, '[body]\nmesh = "../../etc/passwd"\n[start]\nomega_rad_s = [1, 2, 3]\n',
    `title = "${'x'.repeat(100000)}"`, '[body]\nmoments_kg_m2 = [1e308, 1e308, 1e308]\n[start]\nomega_rad_s = [1e308, 1, 1]\n']) {
    await write(tab, hostile);
    await until(tab, 'document.querySelector("#findings button")');
    await wait(300);
    await write(tab, text);
    await until(tab, '!document.querySelector("#findings button")');
  }
  assert.deepEqual(faults, []);
  await tab.close();
});

check('offers completions and explains keys', async (browser) => {
  const {tab, faults} = await opened(browser);
  await tab.evaluate(() => {
    const field = document.getElementById('text');
    const at = field.value.indexOf('[start]') + 8;
    field.focus();
    field.setSelectionRange(at, at);
  });
  await tab.keyboard.type('ener');
  await until(tab, '!document.getElementById("completions").hidden');
  await tab.keyboard.press('Enter');
  assert.match(await tab.$eval('#text', (f) => f.value), /\[start\]\nenergy_J = /);
  assert.match(await tab.$eval('#help', (p) => p.textContent), /start\.energy_J.*kinetic energy/);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('opens a scene of the gallery', async (browser) => {
  const {tab, faults} = await opened(browser);
  await tab.click('#gallery-open');
  await tab.evaluate(() => document.querySelectorAll('#scenes button')[1].click());
  await until(tab, '!document.getElementById("gallery").open');
  await until(tab, '!document.querySelector("#findings button")');
  assert.doesNotMatch(await tab.$eval('#text', (f) => f.value), /to hold/);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('reads files that are dropped', async (browser) => {
  const {tab, faults} = await opened(browser);
  const tetrahedron = 'v 0 0 0\nv 2 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n';
  const scene = '[body]\nmesh = "solid.obj"\ndensity_kg_m3 = 1000\n[start]\nomega_rad_s = [0.1, 2, 0.1]\n';
  await tab.evaluate((files) => {
    const {figure} = the_page;
    const reload = figure.reload;
    figure.reload = (...given) => {
      window.said_before ??= document.getElementById('findings').textContent;
      reload.apply(figure, given);
    };
    const transfer = new DataTransfer();
    for (const [name, text] of files) transfer.items.add(new File([text], name));
    document.dispatchEvent(new DragEvent('drop', {dataTransfer: transfer, cancelable: true}));
  }, [['solid.obj', tetrahedron], ['mine.toml', scene]]);
  await until(tab, `document.getElementById("text").value.includes("solid.obj")`);
  await until(tab, 'window.poinsot.at(0).omega_body[1] === 2');
  assert.equal(await tab.evaluate('window.said_before'), 'Reading solid.obj, mine.toml …', 'the work is announced');
  assert.equal(await tab.$('#findings button'), null);
  // The file is kept for other scenes.
  await tab.evaluate(() => document.querySelectorAll('#scenes button')[1].click());
  await until(tab, '!document.getElementById("text").value.includes("solid.obj")');
  await write(tab, scene);
  await until(tab, 'window.poinsot.at(0).omega_body[1] === 2');
  assert.deepEqual(faults, []);
  await tab.close();
});

check('writes the page of the text that the program accepted last', async (browser) => {
  const {tab} = await opened(browser);
  const text = await tab.$eval('#text', (field) => field.value);
  await write(tab, text.replace('moments_kg_m2', 'moment_kg_m2'));
  await until(tab, 'document.querySelector("#findings button")');
  const made = await saved_by(tab, 'export-page');
  const scene = JSON.parse(/<script id="scene-data"[^>]*>(.*?)<\/script>/.exec(made)[1]);
  assert.equal(scene.text, text);
  await tab.close();
});

check('writes a page of the scene that runs, and its data', async (browser) => {
  const {tab, faults} = await opened(browser);
  const text = await saved_by(tab, 'export-page');
  const file = path.join(folder, 'made.html');
  fs.writeFileSync(file, text);
  assert.ok(text.length < 1.25e6, `${text.length} bytes`);
  assert.doesNotMatch(text.replace(/<script[^]*?<\/script>/g, ''), /\{\{/);
  const made = await opened_file(browser, file);
  await ready(made.tab);
  assert.equal(await made.tab.$('#writing'), null);
  assert.deepEqual(await made.tab.evaluate(() => window.poinsot.at(1)), await tab.evaluate(() => window.poinsot.at(1)));
  assert.deepEqual([...faults, ...made.faults], []);
  await made.tab.close();
  const columns = 'time_s,omega_body_1,omega_body_2,omega_body_3,q_w,q_x,q_y,q_z,herpolhode_x,herpolhode_y,herpolhode_z';
  const rows = await rows_of_csv(tab);
  assert.equal(rows[0], columns);
  const state = await tab.evaluate(() => window.poinsot.at(0));
  assert.deepEqual(rows[1].split(',').map(Number), [0, ...state.omega_body, ...state.space_from_body, ...state.herpolhode]);
  // Of a top, its angles follow.
  await tab.evaluate(() => document.querySelectorAll('#scenes button')[2].click());
  await until(tab, 'document.getElementById("text").value.includes("theta_rad")');
  const of_top = await rows_of_csv(tab);
  assert.equal(of_top[0], `${columns},theta_rad,phi_rad,psi_rad`);
  assert.equal(of_top[1].split(',').length, 14);
  await tab.close();
});

check('is accessible by the rules of axe', async (browser) => {
  const {tab} = await opened(browser);
  assert.deepEqual(await violations(tab), []);
  await tab.close();
});

run_checks(checks, only);
