// The workbench in Chromium. Usage: node workbench_test.js MAKE_WORKBENCH SCENES [NAME…]; POINSOT_WORKBENCH names one that
// exists already.
'use strict';
const assert = require('node:assert/strict');
const {spawnSync} = require('node:child_process');
const fs = require('node:fs');
const http = require('node:http');
const os = require('node:os');
const path = require('node:path');
const jsqr = require('jsqr').default;
const {browser_checks, drop, is_firefox, opened_file, ready, saved_by, scene_text, until, violations, wait, write_page, write_scene} = require('./browsers.js');

const [make, scenes, ...only] = process.argv.slice(2);
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'poinsot-workbench-'));
process.on('exit', () => fs.rmSync(folder, {recursive: true, force: true}));

const starts = ['moments', 'shape', 'mesh', 'top', 'measured'].map((name) => path.join(__dirname, '../../../src/doors/web/page/starts', `${name}.toml`));

function made_workbench() {
  const existing = process.env['POINSOT_WORKBENCH'];
  if (existing) return existing;
  const file = path.join(folder, 'poinsot.html');
  write_page(make, [file, path.join(scenes, 'scene.schema.json'), path.join(__dirname, 'lecture.toml'),
    path.join(scenes, 'generic.toml'), path.join(scenes, 'heavy_top_wavy.toml'), '--new', ...starts]);
  return file;
}

const workbench = made_workbench();
const check = browser_checks(only);

async function opened(browser) {
  const opening = await opened_file(browser, workbench, {size: {width: 1100, height: 640}});
  await ready(opening.tab);
  return opening;
}

/** What "Save data (CSV)" saves, by rows. @returns {Promise<string[]>} */
const rows_of_csv = async (tab) => (await saved_by(tab, 'export-csv')).trim().split('\n');

const tetrahedron = 'v 0 0 0\nv 2 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n';
const with_mesh = '[body]\nmesh = "solid.obj"\ndensity_kg_m3 = 1000\n[start]\nomega_rad_s = [0.1, 2, 0.1]\n';

check('shows the scene of the text beside it', async (browser) => {
  const {tab, faults} = await opened(browser);
  const text = await scene_text(tab);
  await write_scene(tab, text.replace(/omega_rad_s = .*/, 'omega_rad_s = [0.4, 1.5, 0.7]'));
  await until(tab, 'window.poinsot.at(0).omega_body[0] === 0.4');
  // About axis 2 of three different moments it turns over, twice in a period of the polhode.
  assert.match(await tab.$eval('#motion-words', (p) => p.textContent), /^The body turns over every [\d.]+ s\./);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('shows a refusal at its line, and keeps the picture', async (browser) => {
  const {tab, faults} = await opened(browser);
  const text = await scene_text(tab);
  await write_scene(tab, text.replace('moments_kg_m2', 'moment_kg_m2'));
  await until(tab, 'document.querySelector("#findings button")');
  assert.match(await tab.$eval('#findings', (f) => f.textContent), /did you mean "moments_kg_m2"/);
  const line = text.split('\n').findIndex((row) => row.startsWith('moments_kg_m2')) + 1;
  assert.equal(await tab.$eval('.cm-lintRange-error', (mark) => mark.textContent), 'moment_kg_m2');
  assert.ok(await tab.$('.cm-lint-marker-error'), 'and the gutter has a mark');
  await tab.click('#findings button');
  const at = await tab.evaluate(() => the_workbench.editor.view.state.doc.lineAt(the_workbench.editor.view.state.selection.main.head).number);
  assert.equal(at, line);
  await write_scene(tab, text);
  await until(tab, '!document.querySelector("#findings button")');
  assert.deepEqual(faults, []);
  await tab.close();
});

check('refuses hostile scenes and lives on', async (browser) => {
  const {tab, faults} = await opened(browser);
  const text = await scene_text(tab);
  for (const hostile of ['', '\u0000', `a = ${'['.repeat(100000)}`, '[body]\nmesh = "../../etc/passwd"\n[start]\nomega_rad_s = [1, 2, 3]\n',
    `title = "${'x'.repeat(100000)}"`, '[body]\nmoments_kg_m2 = [1e308, 1e308, 1e308]\n[start]\nomega_rad_s = [1e308, 1, 1]\n']) {
    await write_scene(tab, hostile);
    await until(tab, 'document.querySelector("#findings button")');
    await wait(300);
    await write_scene(tab, text);
    await until(tab, '!document.querySelector("#findings button")');
  }
  assert.deepEqual(faults, []);
  await tab.close();
});

check('offers completions and explains keys', async (browser) => {
  const {tab, faults} = await opened(browser);
  const after = (await scene_text(tab)).indexOf('[start]') + 8;
  await tab.evaluate((anchor) => {
    the_workbench.editor.view.dispatch({selection: {anchor}});
    the_workbench.editor.view.focus();
  }, after);
  await tab.keyboard.type('ener');
  await until(tab, 'document.querySelector(".cm-tooltip-autocomplete li[aria-selected]")');
  assert.match(await tab.$eval('.cm-completionInfo', (info) => info.textContent), /kinetic energy/);
  const is_seen = await tab.$eval('.cm-completionInfo', (info) => {
    const {left, right, top, bottom} = info.getBoundingClientRect();
    return info.contains(document.elementFromPoint((left + right) / 2, (top + bottom) / 2));
  });
  assert.ok(is_seen, 'the meaning stands beside the offer');
  // An offer that appeared this instant is not taken: the viewer may have meant a new line.
  await wait(200);
  await tab.keyboard.press('Enter');
  assert.match(await scene_text(tab), /\[start\]\nenergy_J = /);
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
  assert.doesNotMatch(await scene_text(tab), /to hold/);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('reads files that are dropped', async (browser) => {
  const {tab, faults} = await opened(browser);
  const scene = with_mesh;
  await tab.evaluate(() => {
    const {figure} = the_page;
    const reload = figure.reload;
    figure.reload = (...given) => {
      window.said_before ??= document.getElementById('findings').textContent;
      reload.apply(figure, given);
    };
  });
  await drop(tab, [['solid.obj', tetrahedron], ['mine.toml', scene]]);
  await until(tab, `the_workbench.editor.text.includes("solid.obj")`);
  await until(tab, 'window.poinsot.at(0).omega_body[1] === 2');
  assert.equal(await tab.evaluate('window.said_before'), 'Reading solid.obj, mine.toml …', 'the work is announced');
  assert.equal(await tab.$('#findings button'), null);
  // The file is kept for other scenes.
  await tab.evaluate(() => document.querySelectorAll('#scenes button')[1].click());
  await until(tab, '!the_workbench.editor.text.includes("solid.obj")');
  await write_scene(tab, scene);
  await until(tab, 'window.poinsot.at(0).omega_body[1] === 2');
  assert.deepEqual(faults, []);
  await tab.close();
});

check('opens the scene of files that are dropped and that poinsot made', async (browser) => {
  const {tab, faults} = await opened(browser);
  const first = await scene_text(tab);
  const page = await saved_by(tab, 'export-page');
  await write_scene(tab, first.replace(/omega_rad_s = .*/, 'omega_rad_s = [0.4, 1.5, 0.7]'));
  await until(tab, 'window.poinsot.at(0).omega_body[0] === 0.4');
  await drop(tab, [['page.html', page]]);
  await until(tab, 'window.poinsot.at(0).omega_body[0] !== 0.4');
  assert.equal(await scene_text(tab), first);
  // A still by its record, at its instant; what was written before stays a draft.
  const body = `[body]\nmoments_kg_m2 = [3, 2, 1]\n[start]\nomega_rad_s = [0.375, 2, 0.3]\n`;
  const svg = `<svg xmlns="http://www.w3.org/2000/svg"><metadata id="poinsot">poinsot 0.1.0\nscene: theirs\ntime_s: 1.5\n\ntitle = "a &lt; b"\n${body}</metadata></svg>`;
  await drop(tab, [['figure.svg', svg]]);
  await until(tab, 'window.poinsot.at(0).omega_body[0] === 0.375');
  assert.equal(await scene_text(tab), `title = "a < b"\n${body}`);
  assert.equal(await tab.evaluate('window.poinsot.time_s'), 1.5);
  assert.equal(await tab.evaluate('the_page.figure.data.name'), 'theirs');
  await tab.click('#new-open');
  assert.ok((await tab.$eval('#drafts', (list) => list.textContent)).length > 0);
  await tab.evaluate('document.getElementById("new").close()');
  // What has no scene is said, and the scene stays.
  await drop(tab, [['other.mp4', 'no film']]);
  await until(tab, 'document.querySelector("#findings button")');
  assert.match(await tab.$eval('#findings', (f) => f.textContent), /other\.mp4 holds no scene/);
  assert.equal(await tab.evaluate('window.poinsot.at(0).omega_body[0]'), 0.375);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('writes the page of the text that the program accepted last', async (browser) => {
  const {tab} = await opened(browser);
  const text = await scene_text(tab);
  await write_scene(tab, text.replace('moments_kg_m2', 'moment_kg_m2'));
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
  await until(tab, 'the_workbench.editor.text.includes("theta_rad")');
  const of_top = await rows_of_csv(tab);
  assert.equal(of_top[0], `${columns},theta_rad,phi_rad,psi_rad`);
  assert.equal(of_top[1].split(',').length, 14);
  await tab.close();
});

// ── Drafts ──────────────────────────────────────────────────────────────────────────────────

/** Opens the workbench with a store of its own. */
async function opened_alone(browser, options = {}) {
  const context = await browser.createBrowserContext();
  const opening = await opened_file(context, workbench, {size: {width: 1100, height: 640}, ...options});
  await ready(opening.tab);
  return {...opening, context};
}

/** Opens the workbench again, as from its file. */
async function reload(tab) {
  await tab.evaluate(() => {
    the_page.address.keep = () => {};
    history.replaceState(null, '', location.pathname);
  });
  await tab.reload();
  await ready(tab);
}

const mine = 'title = "Crème brûlée, 2nd try"\n[body]\nmoments_kg_m2 = [3.0, 2.0, 1.0]\n[start]\nomega_rad_s = [0.3, 1.25, 0.2]\n';

check('keeps what is written over a reload', async (browser) => {
  const {tab, faults, context} = await opened_alone(browser);
  const first = await scene_text(tab);
  assert.equal(await tab.$eval('#offer', (offer) => offer.hidden), true, 'nothing is offered at first');
  await reload(tab);
  assert.equal(await tab.$eval('#offer', (offer) => offer.hidden), true, 'what was not changed is not kept');
  // The last change is kept, too, although the page is left at once.
  await write_scene(tab, mine);
  await reload(tab);
  assert.equal(await scene_text(tab), first);
  assert.match(await tab.$eval('#offer-text', (p) => p.textContent), /Crème brûlée, 2nd try” of \d?\d:\d\d/);
  await tab.click('#offer-take');
  assert.equal(await scene_text(tab), mine);
  await until(tab, 'window.poinsot.at(0).omega_body[1] === 1.25');
  assert.equal(await tab.$eval('#offer', (offer) => offer.hidden), true);
  // Changes can be undone as before.
  await tab.evaluate(() => the_workbench.editor.view.focus());
  await tab.keyboard.down('Control');
  await tab.keyboard.press('z');
  await tab.keyboard.up('Control');
  assert.equal(await scene_text(tab), first);
  assert.deepEqual(faults, []);
  await context.close();
});

check('keeps every scene that was begun, with its files', async (browser) => {
  const {tab, faults, context} = await opened_alone(browser);
  await drop(tab, [['mine.toml', with_mesh], ['solid.obj', tetrahedron]]);
  await until(tab, 'window.poinsot.at(0).omega_body[1] === 2');
  await write_scene(tab, with_mesh.replace('0.1, 2', '0.1, 3'));
  await tab.evaluate(() => document.querySelectorAll('#scenes button')[1].click());
  await write_scene(tab, mine);
  // Begun anew, the draft stays.
  await reload(tab);
  await tab.click('#offer-leave');
  await write_scene(tab, mine.replace('2nd', '3rd'));
  await reload(tab);
  await tab.click('#new-open');
  assert.deepEqual(await tab.$$eval('#drafts li button:first-child', (rows) => rows.map((row) => row.textContent.replace(/ [\d:]+( [AP]M)?$/, ''))),
    ['Crème brûlée, 3rd try', 'Crème brûlée, 2nd try', 'mine']);
  assert.deepEqual(await violations(tab), []);
  await tab.evaluate(() => document.querySelectorAll('#drafts li button:first-child')[2].click());
  await until(tab, 'window.poinsot.at(0).omega_body[1] === 3');
  assert.equal(await tab.$('#findings button'), null, 'the mesh is kept with the text');
  await tab.click('#new-open');
  await tab.evaluate(() => document.querySelectorAll('#drafts li button:last-child')[1].click());
  await reload(tab);
  await tab.click('#new-open');
  assert.equal(await tab.$$eval('#drafts li', (rows) => rows.length), 2, 'a draft can be removed');
  assert.deepEqual(faults, []);
  await context.close();
});

check('warns before a page is left whose text the browser does not keep', async (browser) => {
  const refuse = () => { Object.defineProperty(window, 'localStorage', {get() { throw new DOMException('refused', 'SecurityError'); }}); };
  for (const before of [refuse, () => { Storage.prototype.setItem = () => { throw new DOMException('full', 'QuotaExceededError'); }; }, null]) {
    const {tab, faults, context} = await opened_alone(browser, {before});
    const asked = () => tab.evaluate(() => {
      const event = new Event('beforeunload', {cancelable: true});
      window.dispatchEvent(event);
      return event.defaultPrevented;
    });
    assert.equal(await asked(), false, 'nothing is lost');
    await write_scene(tab, mine);
    await until(tab, 'window.poinsot.at(0).omega_body[1] === 1.25');
    assert.equal(await asked(), before !== null);
    await tab.click('#look');
    assert.deepEqual(faults, []);
    await context.close();
  }
});

check('gives no other draft up for one that the browser cannot keep', async (browser) => {
  const {tab, faults, context} = await opened_alone(browser);
  const kept = await tab.evaluate(async (mine) => {
    const source = {kind: 'new', name: 'a', text: ''};
    const keep = (name, text, files = {}) => {
      const drafts = new Drafts();
      return drafts.keep({name, source, kept: {text}, files});
    };
    const list = () => new Drafts().list().map(({name, kept, files, lacks}) => [name, kept.text.length, Object.keys(files), lacks]);
    for (let k = 0; k < 8; ++k) {
      keep(`n${k}`, `${mine}# ${k}`);
      await new Promise((resolve) => setTimeout(resolve, 3));
    }
    const eight = list();
    const pasted = [keep('pasted', 'x'.repeat(5500000)), list()];
    // Another program of this origin has filled the store.
    let n = 6e6;
    for (; n > 20; n = Math.floor(n / 2)) {
      try {
        localStorage.setItem(`other${n}`, 'x'.repeat(n));
      } catch {
        continue;
      }
    }
    const filled = [keep('filled', mine.repeat(1000)), list()];
    for (const key of Object.keys(localStorage)) if (key.startsWith('other')) localStorage.removeItem(key);
    return {eight, pasted, filled, at_last: [keep('ninth', mine), list()]};
  }, mine);
  assert.equal(kept.eight.length, 8);
  assert.deepEqual(kept.pasted, [{text: false, lacks: []}, kept.eight]);
  assert.deepEqual(kept.filled, [{text: false, lacks: []}, kept.eight]);
  // A ninth that is kept takes the place of the oldest.
  assert.deepEqual(kept.at_last[0], {text: true, lacks: []});
  assert.deepEqual(kept.at_last[1].map(([name]) => name), ['ninth', ...kept.eight.slice(0, 7).map(([name]) => name)]);
  assert.deepEqual(faults, []);
  await context.close();
});

check('keeps texts rather than files where the store is full', async (browser) => {
  const {tab, faults, context} = await opened_alone(browser);
  const {results, list} = await tab.evaluate((mine) => {
    const source = {kind: 'new', name: 'a', text: ''};
    const results = Array.from({length: 7}, (_, k) =>
      new Drafts().keep({name: `n${k}`, source, kept: {text: `${mine}# ${k}`}, files: {'a.obj': 'x'.repeat(1500000)}}));
    // Larger than a store; and a text alone where meshes leave no room for it.
    results.push(new Drafts().keep({name: 'large', source, kept: {text: mine}, files: {'b.obj': 'y'.repeat(9000000)}}));
    results.push(new Drafts().keep({name: 'text', source, kept: {text: mine.repeat(12000)}, files: {}}));
    return {results, list: new Drafts().list().map(({name, kept, files, lacks}) => [name, kept.text.includes('Crème'), Object.keys(files), lacks])};
  }, mine);
  assert.ok(results.every(({text}) => text), 'each text is kept');
  assert.deepEqual(list.map(([name, has_text]) => [name, has_text]), ['text', 'large', 'n6', 'n5', 'n4', 'n3', 'n2', 'n1'].map((name) => [name, true]));
  // Each draft has its file, or says that it lacks it.
  for (const [name, , files, lacks] of list) assert.deepEqual([...files, ...lacks], name === 'text' ? [] : [name === 'large' ? 'b.obj' : 'a.obj'], name);
  assert.ok(list.some(([, , files]) => files.length > 0), 'and not all lack it');
  assert.deepEqual(faults, []);
  await context.close();
});

check('says what the browser does not keep', async (browser) => {
  const {tab, faults, context} = await opened_alone(browser);
  const said = () => tab.$eval('#findings', (part) => part.querySelector('.unkept')?.textContent ?? '');
  const asked = () => tab.evaluate(() => {
    const event = new Event('beforeunload', {cancelable: true});
    window.dispatchEvent(event);
    return event.defaultPrevented;
  });
  // Room for a text, and not for its mesh.
  await tab.evaluate(() => {
    const set = Storage.prototype.setItem;
    window.most = 20000;
    Storage.prototype.setItem = function (key, value) {
      if (value.length > window.most) throw new DOMException('full', 'QuotaExceededError');
      set.call(this, key, value);
    };
  });
  await drop(tab, [['mine.toml', with_mesh], ['solid.obj', tetrahedron + '# long\n'.repeat(5000)]]);
  await until(tab, 'window.poinsot.at(0).omega_body[1] === 2');
  assert.equal(await said(), '', 'a file that was only opened is the viewer’s already');
  await write_scene(tab, with_mesh.replace('0.1, 2', '0.1, 3'));
  await until(tab, 'document.querySelector("#findings .unkept")');
  assert.match(await said(), /keeps the text, but has no room for solid\.obj\. Save the scene/);
  assert.equal(await asked(), true);
  await tab.click('#new-open');
  assert.match(await tab.$eval('#drafts', (list) => list.textContent), /without solid\.obj/);
  assert.deepEqual(await violations(tab), []);
  await tab.evaluate(() => document.querySelector('#new .dialog-close').click());
  // No room at all; and then for everything.
  await tab.evaluate(() => { window.most = 10; });
  await write_scene(tab, mine);
  await until(tab, 'document.querySelector("#findings .unkept")?.textContent.includes("cannot keep this text")');
  assert.equal(await asked(), true);
  await tab.evaluate(() => { window.most = Infinity; });
  await write_scene(tab, `${mine}\n`);
  await until(tab, '!document.querySelector("#findings .unkept")');
  assert.equal(await asked(), false);
  assert.deepEqual(faults, []);
  await context.close();
});

check('lets two pages go on with one draft without loss', async (browser) => {
  const {tab, context} = await opened_alone(browser);
  await write_scene(tab, mine);
  await until(tab, 'window.poinsot.at(0).omega_body[1] === 1.25');
  const other = (await opened_file(context, workbench)).tab;
  await ready(other);
  await other.evaluate(() => document.getElementById('offer-take').click());
  await write_scene(other, mine.replace('2nd', 'second page’s'));
  await until(other, 'the_workbench.drafts.list()[0].kept.text.includes("second page")');
  await tab.bringToFront();
  await write_scene(tab, mine.replace('2nd', 'first page’s'));
  await until(tab, 'the_workbench.drafts.list()[0].kept.text.includes("first page")');
  const texts = await tab.evaluate(() => the_workbench.drafts.list().map((draft) => draft.kept.text));
  assert.equal(texts.length, 2);
  assert.ok(texts[1].includes('second page'), 'what the other page wrote is kept');
  await context.close();
});

// ── The text is the scene ───────────────────────────────────────────────────────────────────

const commented = `# Two lines
# of comment
title = "Mine"   # its title

[body] # of three moments
moments_kg_m2 = [ 3.0,
                  2.0, 1.0 ]   # kg m²
[start]
omega_rad_s = [0.3, 1.25, 0.2] # rad/s
[film]
duration_s = 4
`;

/** Moves the tip of ω by a drag of the mouse. */
async function drag_omega(tab, dx, dy) {
  const place = await tab.evaluate(() => {
    const {figure} = the_page;
    figure.film.pause();
    figure.program.draw(figure.time_s, figure.film.at_s);
    const grip = figure.program.grips(figure.time_s, figure.film.at_s).find(({thing}) => thing === 'omega');
    const {left, top} = figure.canvas.getBoundingClientRect();
    return {x: left + grip.x / figure.ratio, y: top + grip.y / figure.ratio};
  });
  await tab.mouse.move(place.x, place.y);
  await tab.mouse.down();
  for (const part of [0.3, 0.6, 1]) {
    await tab.mouse.move(place.x + part * dx, place.y + part * dy);
    await wait(60);
  }
  await wait(700); // longer than what an editor takes for one step
  await tab.mouse.move(place.x + 1.2 * dx, place.y + dy);
  await wait(60);
  await tab.mouse.up();
  await wait(200);
}

/** Sets a slider of the options to a value, as a drag of it does. @param {number} k which of the sliders */
const slide = (tab, k, value) => tab.evaluate(([k, value]) => {
  const slider = document.querySelectorAll('#controls input[type=range]')[k];
  for (const part of [0.5, 1]) {
    slider.value = String(part * value);
    slider.dispatchEvent(new Event('input'));
  }
}, [k, value]);

async function undo(tab) {
  await tab.evaluate(() => the_workbench.editor.view.focus());
  await tab.keyboard.down('Control');
  await tab.keyboard.press('z');
  await tab.keyboard.up('Control');
}

/** The numbers of a key as the text has them. */
const in_text = async (text, key) => {
  const {value_in} = await import('../../../src/doors/web/page/scene_text.js');
  return value_in(text, key).match(/-?\d[\d.e+-]*/g).map(Number);
};

check('writes sliders and drags into the text, each one step of undo', async (browser) => {
  const {tab, faults, context} = await opened_alone(browser);
  await write_scene(tab, commented);
  await until(tab, 'window.poinsot.at(0).omega_body[1] === 1.25');
  await tab.evaluate(() => the_page.options.open(true));
  await slide(tab, 0, 0.75);
  await until(tab, 'window.poinsot.at(0).omega_body[0] === 0.75');
  assert.equal(await scene_text(tab), commented.replace('[0.3, 1.25, 0.2]', '[0.75, 1.25, 0.2]'));
  // Typed after that, a value holds.
  await write_scene(tab, commented.replace('1.25', '1.5'));
  await until(tab, 'window.poinsot.at(0).omega_body[1] === 1.5');
  assert.deepEqual(await tab.evaluate(() => window.poinsot.at(0).omega_body), [0.3, 1.5, 0.2]);
  assert.deepEqual(await tab.$$eval('#controls input[type=range]', (all) => all.slice(0, 3).map((slider) => Number(slider.value))), [0.3, 1.5, 0.2]);
  await tab.evaluate(() => the_page.options.open(false));
  // A drag of the mouse, with a rest in it.
  const before = await scene_text(tab);
  await wait(700);
  await drag_omega(tab, 25, 10);
  const dragged = await scene_text(tab);
  assert.notEqual(dragged, before);
  assert.deepEqual(await in_text(dragged, 'start.omega_rad_s'), await tab.evaluate(() => window.poinsot.at(0).omega_body));
  assert.equal(dragged.replace(/omega_rad_s = .*\]/, '').replace(/\nattitude = .*/, ''), before.replace(/omega_rad_s = .*\]/, ''), 'comments and layout stay');
  await undo(tab);
  assert.equal(await scene_text(tab), before);
  await until(tab, 'window.poinsot.at(0).omega_body[1] === 1.5');
  // Escape takes a drag back, too.
  await drag_omega(tab, 25, 10);
  assert.notEqual(await scene_text(tab), before);
  await tab.evaluate(() => document.activeElement.blur());
  await tab.keyboard.press('Escape');
  assert.equal(await scene_text(tab), before);
  // A value that is refused leaves the text as it is, and says why.
  await tab.evaluate(() => the_page.set_soon('start.omega_rad_s', '[0.0, 0.0, 1e400]'));
  await until(tab, '[...document.querySelectorAll("#controls .refusal")].some((p) => p.textContent)');
  assert.equal(await scene_text(tab), before);
  assert.equal(await tab.$eval('#original', (button) => button.hidden), true);
  assert.deepEqual(faults, []);
  await context.close();
});

check('holds each value once: text, figure, data, page, film and link agree', async (browser) => {
  const {tab, faults, context} = await opened_alone(browser);
  await write_scene(tab, commented);
  await until(tab, 'window.poinsot.at(0).omega_body[1] === 1.25');
  await tab.evaluate(() => the_page.options.open(true));
  let state = 7;
  const random = () => (state = (state * 48271) % 2147483647) / 2147483647;
  const steps = {
    slide: () => slide(tab, Math.floor(3 * random()), Math.round(100 * (0.2 + random())) / 100),
    field: () => tab.evaluate((value) => {
      const field = document.querySelectorAll('#controls input[type=number]')[3];
      field.value = String(value);
      field.dispatchEvent(new Event('change'));
    }, Math.round(10 * (2.5 + random())) / 10),
    type: async () => write_scene(tab, (await scene_text(tab)).replace(/omega_rad_s = .*\]/, `omega_rad_s = [0.4, ${(1 + random()).toFixed(2)}, ${random().toFixed(2)}]`)),
    script: () => tab.evaluate((value) => poinsot.set({'start.omega_rad_s': [value, 1.1, 0.3]}), Math.round(100 * random()) / 100),
    drag: async () => {
      await tab.evaluate(() => the_page.options.open(false));
      await drag_omega(tab, 30 * random() - 15, 20 * random() - 10);
      await tab.evaluate(() => the_page.options.open(true));
    },
    undo: () => undo(tab),
    theme: () => tab.evaluate((theme) => the_page.options.set_theme(theme), ['', 'light', 'dark'][Math.floor(3 * random())]),
    language: async () => write_scene(tab, `language = "${['de', 'en', 'ja'][Math.floor(3 * random())]}"\n${(await scene_text(tab)).replace(/^language.*\n/, '')}`),
  };
  const order = ['slide', 'type', 'drag', 'field', 'undo', 'script', 'theme', 'slide', 'language', 'drag', 'type', 'undo', 'undo', 'slide', 'script', 'language', 'field'];
  for (const [k, name] of order.entries()) {
    await steps[name]();
    await until(tab, 'the_workbench.timer === 0 && the_page.figure.frame === 0 && the_page.data.text === the_workbench.editor.text');
    const text = await scene_text(tab);
    const place = `step ${k}, ${name}`;
    const seen = await tab.evaluate(async () => {
      const settings = {...the_page.options.films.settings(), width: 32, height: 18};
      const scene = film_scene(the_page, settings);
      await the_workbench.page.store.link_fault();
      return {
        omega: poinsot.at(0).omega_body, rows: the_workbench.csv().split('\n')[1].split(',').slice(1, 4).map(Number), values: [...the_page.figure.choices.values],
        film: [scene.text, scene.overrides.filter((text) => !/^(film\.|theme)/.test(text))], link: await unpacked_text(the_workbench.page.store.link().text),
      };
    });
    assert.deepEqual(await in_text(text, 'start.omega_rad_s'), seen.omega, place);
    assert.deepEqual(seen.rows, seen.omega, place);
    assert.deepEqual(seen.values, [], place);
    assert.deepEqual(seen.film, [text, []], place);
    assert.equal(seen.link, text, place);
    if (k % 6 !== 5) continue;
    const page = JSON.parse(/<script id="scene-data"[^>]*>(.*?)<\/script>/.exec(await tab.evaluate(() => the_workbench.page_of_scene()))[1]);
    assert.deepEqual([page.text, page.overrides], [text, []], place);
  }
  assert.deepEqual(faults, []);
  await context.close();
});

check('has a link that is the scene', async (browser) => {
  const {tab, faults, context} = await opened_alone(browser);
  await write_scene(tab, commented);
  await until(tab, 'window.poinsot.at(0).omega_body[1] === 1.25');
  await tab.evaluate(() => {
    poinsot.seek_film(1.5);
    poinsot.view({azimuth_deg: 77});
  });
  await until(tab, 'location.hash.includes("text=") && location.hash.includes("at=1.5") && location.hash.includes("view=")');
  const link = await tab.evaluate(() => the_page.address.link());
  assert.ok(link.length < 700, `${link.length} characters`);
  // In another browser: the same text, instant, view and picture.
  const picture = (page) => page.evaluate(() => {
    const {figure} = the_page;
    return [...figure.image(figure.film.at_s, 160, 90).data].reduce((sum, byte) => (Math.imul(sum, 31) + byte) >>> 0, 0);
  });
  const other = await opened_alone(browser, {fragment: link.slice(link.indexOf('#'))});
  await until(other.tab, 'window.poinsot.at(0).omega_body[1] === 1.25');
  assert.equal(await scene_text(other.tab), commented);
  assert.deepEqual(await other.tab.evaluate(() => [poinsot.film_s, the_page.views.list()[0].azimuth_deg]), [1.5, 77]);
  assert.equal(await picture(other.tab), await picture(tab));
  await other.context.close();
  // An example is its name, also after the film has moved; a value of a link goes into the text.
  await tab.evaluate(() => document.querySelectorAll('#scenes button')[2].click());
  await until(tab, 'the_workbench.editor.text.includes("theta_rad")');
  await tab.evaluate(() => poinsot.seek_film(0.5));
  await until(tab, 'location.hash.includes("at=0.5")');
  assert.match(await tab.evaluate(() => location.hash), /^#scene=heavy_top_wavy&at=0\.5$/);
  const example = await opened_alone(browser, {fragment: `#scene=heavy_top_wavy&at=0.5&set=${encodeURIComponent('start.theta_rad=0.9')}`});
  await until(example.tab, 'the_workbench.editor.text.includes("theta_rad = 0.9")');
  assert.equal(await example.tab.evaluate(() => poinsot.film_s), 0.5);
  assert.deepEqual([...faults, ...other.faults, ...example.faults], []);
  await example.context.close();
  await context.close();
});

check('goes on after a reload with the scene of its link, its files and what can be undone', async (browser) => {
  const {tab, faults, context} = await opened_alone(browser);
  await drop(tab, [['mine.toml', with_mesh], ['solid.obj', tetrahedron]]);
  await until(tab, 'window.poinsot.at(0).omega_body[1] === 2');
  await write_scene(tab, with_mesh.replace('0.1, 2', '0.1, 3'));
  await until(tab, 'the_workbench.drafts.has_written && location.hash.includes("text=")');
  await tab.reload();
  await ready(tab);
  await until(tab, 'window.poinsot.at(0).omega_body[1] === 3');
  assert.equal(await tab.$eval('#offer', (offer) => offer.hidden), true);
  assert.equal(await tab.$('#findings button'), null);
  await undo(tab);
  await until(tab, 'window.poinsot.at(0).omega_body[1] === 2');
  // Where the scene of a link is refused, the text stands beside the page's own figure, with the message at its line.
  const link = await tab.evaluate(() => location.hash);
  const other = await opened_alone(browser, {fragment: link});
  await until(other.tab, 'document.querySelector("#findings button")');
  assert.match(await other.tab.$eval('#findings button', (button) => button.textContent), /solid\.obj/);
  assert.match(await scene_text(other.tab), /solid\.obj/);
  assert.equal(await other.tab.evaluate(() => the_page.figure.loaded !== null), true);
  assert.deepEqual([...faults, ...other.faults], []);
  await other.context.close();
  await context.close();
});

check('answers a hostile link with one sentence', async (browser) => {
  const bomb = require('node:zlib').deflateRawSync(Buffer.alloc(5e6)).toString('base64url');
  const latin = require('node:zlib').deflateRawSync(Buffer.from([0x61, 0xff, 0xfe])).toString('base64url');
  for (const [fragment, said] of [['#text=AAAA', /no whole scene/], ['#text=%00<script>', /no whole scene/], [`#text=${bomb}`, /no whole scene/], [`#text=${latin}`, /no whole scene/],
    [`#text=${'A'.repeat(30000)}`, /no whole scene/], ['#scene=<b>x</b>', /no example “<b>x<\/b>”/]]) {
    const {tab, faults, context} = await opened_alone(browser, {fragment});
    await until(tab, '!document.getElementById("sentence").hidden');
    assert.match(await tab.$eval('#sentence', (p) => p.textContent), said);
    assert.equal(await tab.$('#sentence b'), null);
    assert.match(await scene_text(tab), /A page/, 'the first example is shown');
    assert.deepEqual(faults, []);
    await context.close();
  }
});

check('says what a link cannot hold', async (browser) => {
  const {tab, faults, context} = await opened_alone(browser);
  const copied = async () => {
    await tab.evaluate(() => the_page.options.copy_link());
    return tab.$eval('#sentence', (p) => (p.hidden ? '' : p.textContent));
  };
  await drop(tab, [['mine.toml', with_mesh], ['solid.obj', tetrahedron]]);
  await until(tab, 'window.poinsot.at(0).omega_body[1] === 2');
  assert.match(await copied(), /cannot hold solid\.obj; save the scene/);
  await write_scene(tab, `# ${Array.from({length: 9000}, (_, k) => ((k * 7919) % 65521).toString(36)).join('')}\n${mine}`);
  await until(tab, 'window.poinsot.at(0).omega_body[1] === 1.25');
  assert.match(await copied(), /too long for a link; save it/);
  // A starting point brings its own file.
  await tab.evaluate(() => document.querySelectorAll('#starts button')[2].click());
  await until(tab, 'the_page.data.text === the_workbench.editor.text && the_workbench.editor.text.includes("bracket.obj")');
  assert.equal(await tab.evaluate(() => the_workbench.page.store.link_fault()), '');
  assert.deepEqual(faults, []);
  await context.close();
});

// ── Names, new scenes, archives ─────────────────────────────────────────────────────────────

/** The name under which a button saves, and what. @returns {Promise<{name: string, bytes: Buffer}>} */
const download_by = async (tab, button) => {
  const {name, base64} = await tab.evaluate((button) => new Promise((resolve) => {
    const [url, click] = [URL.createObjectURL, HTMLAnchorElement.prototype.click];
    let saved;
    URL.createObjectURL = (blob) => {
      saved = blob;
      return url(blob);
    };
    HTMLAnchorElement.prototype.click = function () {
      [URL.createObjectURL, HTMLAnchorElement.prototype.click] = [url, click];
      void saved.arrayBuffer().then((bytes) => resolve({name: this.download, base64: base64_of_bytes(new Uint8Array(bytes))}));
    };
    document.getElementById(button).click();
  }), button);
  return {name, bytes: Buffer.from(base64, 'base64')};
};

check('shows the QR code of the link, which opens the scene', async (browser) => {
  const server = http.createServer((request, answer) => answer.writeHead(200, {'content-type': 'text/html'}).end(fs.readFileSync(workbench)));
  await new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve(null)));
  const tab = await browser.newPage();
  await tab.goto(`http://127.0.0.1:${/** @type {import('node:net').AddressInfo} */ (server.address()).port}/poinsot.html`);
  await ready(tab);
  await write_scene(tab, mine);
  await until(tab, 'window.poinsot.at(0).omega_body[1] === 1.25');
  await tab.click('#qr-open');
  await until(tab, 'document.getElementById("qr").open');
  assert.deepEqual(await violations(tab), []);
  // Another library reads it, from its pixels.
  const [pixels, size] = await tab.evaluate(async () => {
    const svg = document.getElementById('qr-code').cloneNode(true);
    const size = 4 * svg.viewBox.baseVal.width;
    svg.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
    svg.setAttribute('width', String(size));
    svg.setAttribute('height', String(size));
    const picture = new Image();
    picture.src = `data:image/svg+xml,${encodeURIComponent(svg.outerHTML)}`;
    await picture.decode();
    const canvas = new OffscreenCanvas(size, size);
    canvas.getContext('2d').drawImage(picture, 0, 0);
    return [[...canvas.getContext('2d').getImageData(0, 0, size, size).data], size];
  });
  const link = jsqr(Uint8ClampedArray.from(pixels), size, size)?.data;
  assert.equal(link, await tab.evaluate(() => the_page.address.link()));
  const other = await browser.newPage();
  await other.goto(link);
  await ready(other);
  assert.equal(await scene_text(other), mine);
  await other.close();
  // Too long for a code, not for a link; and a file says why it has none.
  await tab.evaluate(() => document.getElementById('qr').close());
  await write_scene(tab, `${mine}\n# ${Array.from({length: 1800}, (_, k) => (k * k * 7919 % 99991).toString(36)).join(' ')}\n`);
  await wait(600);
  await tab.click('#qr-open');
  await until(tab, 'document.getElementById("qr-text").textContent.includes("too long")');
  await tab.close();
  server.closeAllConnections();
  server.close();
  const local = await opened(browser);
  await local.tab.click('#qr-open');
  await until(local.tab, 'document.getElementById("qr-text").textContent.includes("cannot open a file")');
  assert.equal(await local.tab.$eval('#qr-code', (svg) => svg.checkVisibility()), false);
  assert.deepEqual(local.faults, []);
  await local.tab.close();
});

check('names what it saves after the file of the scene, or its title', async (browser) => {
  const {tab, faults} = await opened(browser);
  const saved_name = async (button) => (await download_by(tab, button)).name;
  assert.equal(await saved_name('file-save'), 'lecture.toml', 'an example has its name');
  await write_scene(tab, mine);
  assert.equal(await saved_name('file-save'), 'creme_brulee_2nd_try.toml');
  await until(tab, 'window.poinsot.at(0).omega_body[1] === 1.25');
  for (const [button, suffix] of [['export-page', 'html'], ['export-csv', 'csv'], ['save-png', 'png'], ['save-svg', 'svg']])
    assert.equal(await saved_name(button), `creme_brulee_2nd_try.${suffix}`);
  await write_scene(tab, mine.replace('moments', 'moment'));
  await until(tab, 'document.querySelector("#findings button")');
  assert.match(await tab.$eval('#findings', (f) => f.textContent), /^creme_brulee_2nd_try\.toml:3:1: /);
  await drop(tab, [['Exercise 4.toml', mine]]);
  await until(tab, 'the_page.figure.data.name === "Exercise 4"');
  assert.equal(await saved_name('file-save'), 'Exercise 4.toml', 'a file keeps its name, whatever its title');
  for (const [title, name] of [['"コマの運動"', 'コマの運動'], ["'$I_1$ and \"you\"'", 'and_you'], ['"../../etc"', 'etc'], ['"..."', 'scene']]) {
    await tab.evaluate((text) => the_workbench.open({kind: 'new', name: 'x', text}, {}), mine.replace(/".*"/, title));
    assert.equal(await saved_name('file-save'), `${name}.toml`);
  }
  assert.deepEqual(faults, []);
  await tab.close();
});

check('begins a scene from each of five starting points', async (browser) => {
  const {tab, faults} = await opened(browser);
  assert.equal(await tab.$$eval('#starts button', (all) => all.length), 5);
  for (let k = 0; k < 5; ++k) {
    await tab.click('#new-open');
    if (k === 0) assert.deepEqual(await violations(tab), []);
    await tab.evaluate((k) => document.querySelectorAll('#starts button')[k].click(), k);
    const text = await scene_text(tab);
    assert.equal(text, fs.readFileSync(starts[k], 'utf8'));
    await until(tab, `the_page.figure.data.text === the_workbench.editor.text`);
    assert.equal(await tab.$('#findings button'), null);
  }
  assert.deepEqual(faults, []);
  await tab.close();
});

check('finds examples by their words', async (browser) => {
  const {tab, faults} = await opened(browser);
  await tab.click('#gallery-open');
  const shown = () => tab.$$eval('#scenes button:not([hidden]) span', (all) => all.map((span) => span.textContent));
  const n_all = (await shown()).length;
  await tab.type('#gallery-search', 'TOP gravity');
  assert.equal((await shown()).length, 1);
  assert.equal(await tab.evaluate(() => the_page.figure.film.playing), false, 'keys of the figure are letters here');
  await tab.type('#gallery-search', ' nowhere');
  assert.deepEqual(await shown(), []);
  assert.equal(await tab.$eval('#gallery-none', (p) => p.hidden), false);
  await tab.evaluate(() => {
    document.getElementById('gallery-search').value = '';
    document.getElementById('gallery-search').dispatchEvent(new Event('input'));
  });
  assert.equal((await shown()).length, n_all);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('saves a scene with its files as one archive, and opens it', async (browser) => {
  const {tab, faults} = await opened(browser);
  const named = `# größer\n${with_mesh.replace('solid.obj', 'Körper/solid.obj')}`;
  await tab.evaluate(([text, obj]) => the_workbench.open({kind: 'file', name: 'Lösung', text}, {'Körper/solid.obj': btoa(obj)}), [named, tetrahedron]);
  await until(tab, 'window.poinsot.at(0).omega_body[1] === 2');
  const {name, bytes} = await download_by(tab, 'file-save');
  assert.equal(name, 'Lösung.zip');
  // Python reads what was written, and packs it again, deflated, in a folder of its own.
  const [ours, theirs] = ['ours.zip', 'theirs.zip'].map((file) => path.join(folder, file));
  fs.writeFileSync(ours, bytes);
  const program = `import json, sys, zipfile
ours = zipfile.ZipFile(sys.argv[1])
assert ours.testzip() is None
with zipfile.ZipFile(sys.argv[2], "w", zipfile.ZIP_DEFLATED) as theirs:
    theirs.mkdir("work") if hasattr(theirs, "mkdir") else None
    for name in ours.namelist():
        theirs.writestr("work/" + name, ours.read(name).replace(b"0.1, 2", b"0.1, 5"))
    theirs.writestr("__MACOSX/work/._x", b"x")
    theirs.comment = b"PK" * 40
print(json.dumps({name: ours.read(name).decode() for name in ours.namelist()}))`;
  const python = spawnSync('/usr/bin/python3', ['-c', program, ours, theirs], {encoding: 'utf8'});
  assert.deepEqual(JSON.parse(python.stdout || python.stderr), {'Lösung.toml': named, 'Körper/solid.obj': tetrahedron});
  await tab.evaluate(() => { the_workbench.files = {}; });
  await drop(tab, [['theirs.zip', fs.readFileSync(theirs)]]);
  await until(tab, 'window.poinsot.at(0).omega_body[1] === 5');
  assert.equal(await tab.$('#findings button'), null);
  assert.equal((await download_by(tab, 'file-save')).name, 'Lösung.zip');
  assert.deepEqual(faults, []);
  await tab.close();
});

check('unpacks of an archive what the scene names', async (browser) => {
  const {tab, faults} = await opened(browser);
  const archive = path.join(folder, 'large.zip');
  const python = spawnSync('/usr/bin/python3', ['-c', `import sys, zipfile
with zipfile.ZipFile(sys.argv[1], "w", zipfile.ZIP_DEFLATED) as z:
    z.writestr("mine.toml", ${JSON.stringify(with_mesh.replace('solid.obj', 'other.obj'))})
    z.writestr("other.obj", ${JSON.stringify(tetrahedron)})
    z.writestr("solid.obj", ${JSON.stringify(tetrahedron)} + "#" * 1000000)`, archive], {encoding: 'utf8'});
  assert.equal(python.status, 0, python.stderr);
  await tab.evaluate(() => {
    window.n_unpacked = 0;
    const Stream = window.DecompressionStream;
    window.DecompressionStream = function (format) {
      ++window.n_unpacked;
      return new Stream(format);
    };
  });
  await drop(tab, [['large.zip', fs.readFileSync(archive)]]);
  await until(tab, 'window.poinsot.at(0).omega_body[1] === 2');
  assert.equal(await tab.evaluate('window.n_unpacked'), 2, 'the text, and the mesh that it names');
  // Named later, it is there.
  await write_scene(tab, with_mesh.replace('0.1, 2', '0.1, 3'));
  await until(tab, 'window.poinsot.at(0).omega_body[1] === 3');
  assert.equal(await tab.evaluate('window.n_unpacked'), 3);
  assert.equal(await tab.$('#findings button'), null);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('begins a scene with a mesh that is dropped', async (browser) => {
  const {tab, faults} = await opened(browser);
  await drop(tab, [['my solid.obj', tetrahedron]]);
  await until(tab, 'document.querySelector("#findings .unnamed button")');
  assert.match(await tab.$eval('#findings .unnamed', (row) => row.textContent), /^my solid\.obj is at hand/);
  await tab.click('#findings .unnamed button');
  await until(tab, 'the_page.figure.data.text.includes(\'mesh = "my solid.obj"\')');
  assert.equal(await tab.$('#findings button'), null);
  assert.equal((await download_by(tab, 'file-save')).name, 'my_solid.zip');
  // Ctrl S saves the scene, not the page, also from the editor.
  const saved = tab.evaluate(() => new Promise((resolve) => {
    HTMLAnchorElement.prototype.click = function () { resolve(this.download); };
    the_workbench.editor.view.focus();
  }));
  await tab.keyboard.down('Control');
  await tab.keyboard.press('s');
  await tab.keyboard.up('Control');
  assert.equal(await saved, 'my_solid.zip');
  assert.deepEqual(faults, []);
  await tab.close();
});

check('refuses damaged and hostile archives', async (browser) => {
  const {tab, faults} = await opened(browser);
  const before = await scene_text(tab);
  const archive = path.join(folder, 'hostile.zip');
  const make_zip = (program) => {
    const python = spawnSync('/usr/bin/python3', ['-c', `import sys, zipfile\nz = zipfile.ZipFile(sys.argv[1], "w", zipfile.ZIP_DEFLATED)\n${program}\nz.close()`, archive], {encoding: 'utf8'});
    assert.equal(python.status, 0, python.stderr);
    return fs.readFileSync(archive);
  };
  const good = make_zip(`z.writestr("a.toml", ${JSON.stringify(mine)}); z.writestr("b.obj", "v 0 0 0\\n" * 500)`);
  const bomb = make_zip('[z.writestr(f"{k}.obj", bytes(100_000_000)) for k in range(3)]');
  const bzip2 = make_zip('z.writestr("a.toml", "x" * 99, zipfile.ZIP_BZIP2)');
  const changed = (place) => Buffer.from(good.map((byte, k) => (k === place ? byte ^ 0x55 : byte)));
  const body = good.indexOf('a.toml') + 12;
  // A directory that promises less than the file unpacks to.
  const lies = Buffer.from(good);
  lies.writeUInt32LE(5, good.indexOf('PK\x01\x02', 0, 'latin1') + 24);
  for (const [bytes, said] of [[Buffer.from(''), /damaged/], [Buffer.from('PK\x05\x06'), /damaged/], [good.subarray(0, good.length - 30), /damaged/],
    [good.subarray(40), /damaged/], [changed(body), /damaged/], [lies, /damaged/], [bomb, /more than 256 MB/], [bzip2, /a method that browsers do not have/]]) {
    await drop(tab, [['bad.zip', bytes]]);
    await until(tab, 'document.querySelector("#findings button")');
    const message = await tab.$eval('#findings', (f) => f.textContent);
    assert.match(message, said);
    assert.match(message, /^bad\.zip: .+; .+/);
    await tab.evaluate(() => document.getElementById('findings').replaceChildren());
  }
  assert.equal(await scene_text(tab), before, 'the scene stays');
  assert.deepEqual(faults, []);
  await tab.close();
});

// ── What it looks like ──────────────────────────────────────────────────────────────────────

// puppeteer cannot set the colours of the system in Firefox.
if (!is_firefox)
  check('is light or dark as the system, or as a button says, which is remembered', async (browser) => {
    const {tab, faults, context} = await opened_alone(browser);
    const is_dark = () => tab.$eval('#writing', (part) => {
      const [r, g, b] = getComputedStyle(part).backgroundColor.match(/[\d.]+/g).map(Number);
      return r + g + b < 3 * 100;
    });
    await tab.emulateMediaFeatures([{name: 'prefers-color-scheme', value: 'dark'}]);
    assert.equal(await is_dark(), true);
    assert.deepEqual(await violations(tab), []);
    await tab.click('#look');
    assert.equal(await is_dark(), false);
    await reload(tab);
    assert.equal(await is_dark(), false);
    await tab.emulateMediaFeatures([{name: 'prefers-color-scheme', value: 'light'}]);
    await tab.click('#look');
    assert.equal(await is_dark(), true);
    assert.deepEqual(faults, []);
    await context.close();
  });

check('speaks the language of the browser, whatever that of the scene', async (browser) => {
  for (const [language, film, names, options, turns] of [['en-GB', 'Make film', 'Names', 'Options', /turns over every/], ['de-DE', 'Film erstellen', 'Namen', 'Einstellungen', /schlägt alle [\d,]+ s um/]]) {
    const {tab, faults, context} = await opened_alone(browser, {before: `Object.defineProperty(Navigator.prototype, 'language', {value: '${language}'})`});
    const words = () => tab.evaluate(() => ['film-make', 'elements', 'regime'].map((id) => document.getElementById(id).textContent)
      .concat(document.getElementById('options').getAttribute('aria-label'), document.documentElement.lang));
    const at_first = await words();
    for (const scene of ['de', 'ja', 'en']) {
      await write_scene(tab, `language = "${scene}"\n${mine}`);
      await until(tab, `the_page.figure.loaded.language === "${scene}" && the_page.figure.frame === 0`);
      const [button, boxes, regime, drawer, lang] = await words();
      assert.equal(button, film);
      assert.ok(boxes.startsWith(names), boxes);
      assert.match(regime, turns);
      assert.equal(drawer, options);
      assert.equal(lang, language.slice(0, 2));
    }
    assert.equal(at_first[0], film);
    assert.deepEqual(faults, []);
    await context.close();
  }
});

check('leads to the film from the first row of buttons', async (browser) => {
  for (const size of [{width: 1100, height: 640}, {width: 390, height: 664}]) {
    const {tab, faults, context} = await opened_alone(browser, {size});
    await tab.click('#film-open');
    // Its form is in sight, at the focus, and nothing of the bar lies below the drawer.
    assert.equal(await tab.evaluate(() => document.activeElement.id), 'film-kind');
    const seen = (id) => tab.evaluate((id) => {
      const {left, right, top, bottom} = document.getElementById(id).getBoundingClientRect();
      return document.elementFromPoint((left + right) / 2, (top + bottom) / 2)?.closest(`#${id}`) !== null;
    }, id);
    for (const id of ['film-kind', 'film-make', 'close', 'full', 'speed']) assert.ok(await seen(id), `${id} at ${size.width} × ${size.height}`);
    assert.deepEqual(await violations(tab), []);
    assert.ok(await tab.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth), 'nothing sticks out');
    assert.deepEqual(faults, []);
    await context.close();
  }
});

check('shows figure and text as tabs on a phone', async (browser) => {
  const {tab, faults, context} = await opened_alone(browser, {size: {width: 390, height: 844}});
  /** What stands in the middle of the window. */
  const in_front = () => tab.evaluate(() => document.elementFromPoint(195, 440).closest('#figure, #writing').id);
  assert.equal(await in_front(), 'figure');
  const {width, height} = await tab.evaluate(() => the_page.figure.size());
  await tab.click('#tab-text');
  assert.equal(await in_front(), 'writing');
  assert.deepEqual(await tab.evaluate(() => [the_page.figure.size().width, the_page.figure.size().height]), [width, height], 'the figure keeps its size');
  await write_scene(tab, mine.replace('moments', 'moment'));
  await until(tab, 'document.querySelector("#findings button")');
  assert.deepEqual(await violations(tab), []);
  await tab.focus('#tab-text');
  await tab.keyboard.press('ArrowLeft');
  assert.equal(await in_front(), 'figure');
  assert.ok(await tab.$('#tab-text.has-refusal'), 'the tab of the text says that something was refused');
  assert.deepEqual(await violations(tab), []);
  assert.ok(await tab.evaluate(() => document.documentElement.scrollWidth <= 390 && document.documentElement.scrollHeight <= 844), 'nothing sticks out');
  // A window of 1440 × 900 at 400 %: the page scrolls, and the picture keeps a useful height.
  await tab.setViewport({width: 360, height: 225});
  await until(tab, 'document.getElementById("picture").clientHeight >= 120');
  assert.deepEqual(faults, []);
  await context.close();
});

check('wraps long lines, folds tables and searches', async (browser) => {
  const {tab, faults} = await opened(browser);
  const text = `# ${'word '.repeat(200)}\n${mine}`;
  await write_scene(tab, text);
  await until(tab, 'window.poinsot.at(0).omega_body[1] === 1.25');
  assert.ok(await tab.$eval('.cm-scroller', (s) => s.scrollWidth <= s.clientWidth), 'nothing lies beside the window');
  const lines = () => tab.$$eval('.cm-line', (all) => all.map((line) => line.textContent));
  const n = (await lines()).length;
  await tab.evaluate(() => [...document.querySelectorAll('.cm-foldGutter .cm-gutterElement span')].find((mark) => mark.title === 'Fold line').click());
  assert.equal((await lines()).length, n - 1);
  assert.ok((await lines()).some((line) => line.startsWith('[body]')) && !(await lines()).some((line) => line.startsWith('moments')));
  await tab.evaluate(() => the_workbench.editor.view.focus());
  await tab.keyboard.down('Control');
  await tab.keyboard.press('f');
  await tab.keyboard.up('Control');
  await tab.keyboard.type('omega');
  await tab.keyboard.press('Enter');
  await until(tab, 'document.querySelector(".cm-searchMatch-selected")?.textContent === "omega"');
  assert.deepEqual(await violations(tab), []);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('edits in a plain text area without CodeMirror', async (browser) => {
  const file = path.join(folder, 'plain.html');
  fs.writeFileSync(file, fs.readFileSync(workbench, 'utf8').replace(/<script id="text-editor"[^]*?<\/script>/, ''));
  const context = await browser.createBrowserContext();
  const {tab, faults} = await opened_file(context, file, {size: {width: 1100, height: 640}});
  await ready(tab);
  assert.equal(await tab.$eval('#text', (field) => field.tagName), 'TEXTAREA');
  await write_scene(tab, mine);
  await until(tab, 'window.poinsot.at(0).omega_body[1] === 1.25');
  await write_scene(tab, mine.replace('moments', 'moment'));
  await until(tab, 'document.querySelector("#findings button")');
  await tab.click('#findings button');
  assert.equal(await tab.$eval('#text', (f) => f.value.slice(0, f.selectionStart)), 'title = "Crème brûlée, 2nd try"\n[body]\n');
  assert.deepEqual(await violations(tab), []);
  await reload(tab);
  await tab.click('#offer-take');
  assert.equal(await scene_text(tab), mine.replace('moments', 'moment'));
  assert.deepEqual(faults, []);
  await context.close();
});

check('carries the licence of its editor', async (browser) => {
  const {tab} = await opened(browser);
  const script = await tab.evaluate(() => new TextDecoder().decode(unpacked('text-editor')));
  const {packages} = JSON.parse(fs.readFileSync(path.join(__dirname, '../../../src/doors/web/page/text_editor/package-lock.json'), 'utf8'));
  assert.ok(script.startsWith(`/* CodeMirror 6, @codemirror/view ${packages['node_modules/@codemirror/view'].version} */`));
  const words = (text) => text.replace(/[\s*]+/g, ' ').trim();
  const of_package = fs.readFileSync(path.join(__dirname, '../../../src/doors/web/page/text_editor/node_modules/@codemirror/view/LICENSE'), 'utf8');
  assert.ok(words(script).includes(words(of_package.slice(of_package.indexOf('Permission is')))), 'the licence');
  // The notice names every package that the bundle may take.
  for (const name of Object.keys(packages).filter((name) => name && !packages[name].dev && !packages[name].optional)) {
    const [scope] = name.replace('node_modules/', '').split('/');
    assert.ok(script.includes(scope), name);
  }
  await tab.close();
});

check('is accessible by the rules of axe', async (browser) => {
  const {tab} = await opened(browser);
  assert.deepEqual(await violations(tab), []);
  await tab.close();
});
