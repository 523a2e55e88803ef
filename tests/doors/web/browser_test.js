// The page in Chromium: every control, links, sizes, lost contexts, sandboxes, and what scripts can do.
// Usage: node browser_test.js POINSOT [NAME…]; POINSOT_PAGE names a page that exists already.
'use strict';
const assert = require('node:assert/strict');
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');
const {browser_checks, faults_of, is_firefox, opened_file, page_of, press, ready, settled, until, violations, wait} = require('./browsers.js');

const [program, ...only] = process.argv.slice(2);
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'poinsot-page-'));
process.on('exit', () => fs.rmSync(folder, {recursive: true, force: true}));

const check = browser_checks(only);

const lecture = path.join(__dirname, 'lecture.toml');
const page_file = process.env['POINSOT_PAGE'] ?? page_of(program, lecture, path.join(folder, 'lecture.html'));

/** Writes a scene, and the files that it names, into the test's folder. @param {string} name @param {string} text @param {Record<string, string>} [files] */
function scene_file(name, text, files = {}) {
  for (const [file, content] of Object.entries({...files, [`${name}.toml`]: text})) fs.writeFileSync(path.join(folder, file), content);
  return path.join(folder, `${name}.toml`);
}

/** The picture of the canvas, drawn anew, as a number that tells pictures apart. */
const picture = (tab) => tab.evaluate(() => {
  const {figure} = the_page;
  figure.program.draw(figure.time_s, figure.film.at_s);
  return [...figure.canvas.toDataURL()].reduce((sum, letter) => (Math.imul(sum, 31) + letter.charCodeAt(0)) >>> 0, 0);
});

/** Takes the graphics context away. */
const lose_context = (tab) => tab.evaluate(() => {
  window.lose = document.querySelector('canvas').getContext('webgl2').getExtension('WEBGL_lose_context');
  window.lose.loseContext();
});

const opened = (browser, options = {}) => opened_file(browser, page_file, options);
const film_s = (tab) => tab.$eval('#scrub', (scrub) => scrub.valueAsNumber);

check('starts by itself, draws, and then rests', async (browser) => {
  const {tab, faults} = await opened(browser);
  await ready(tab);
  await until(tab, 'document.body.classList.contains("drawn")');
  await settled(tab);
  const before = await tab.evaluate(() => window.n_frames);
  await wait(700);
  assert.equal(await tab.evaluate(() => window.n_frames), before, 'frames were drawn while nothing moved');
  assert.ok((await tab.$eval('#state', (state) => state.textContent)).length > 10, 'screen readers hear the state');
  assert.deepEqual(faults, []);
  await tab.close();
});

check('opens as its still, and plays from the beginning', async (browser) => {
  const free = '[body]\nmoments_kg_m2 = [3, 2, 1.5]\n[start]\nomega_rad_s = [1, 0.5, 0.2]\n';
  const film = free + '[film]\nstart_s = 1\nduration_s = 9\nstill_s = 6\n';
  const stop = film + '[[stops]]\nat_s = 3\ntitle = "Wait"\n';
  for (const [name, text, at_s] of [['opened', film, 5], ['stopped', stop, 0]]) {
    const {tab, faults} = await opened_file(browser, page_of(program, scene_file(name, text), path.join(folder, `${name}.html`)));
    await ready(tab);
    assert.equal(await film_s(tab), at_s);
    await tab.evaluate('poinsot.play()');
    await until(tab, 'poinsot.film_s > 0.05');
    assert.ok((await film_s(tab)) < at_s || at_s === 0);
    assert.deepEqual(faults, []);
    await tab.close();
  }
});

check('shows the title as text', async (browser) => {
  const {tab, faults} = await opened(browser);
  await ready(tab);
  if (!process.env['POINSOT_PAGE']) assert.equal(await tab.title(), 'A page </script><b>to hold</b>');
  assert.equal(await tab.$('b'), null);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('plays, pauses, steps, and goes from stop to stop by keys', async (browser) => {
  const {tab, faults} = await opened(browser);
  await ready(tab);
  await press(tab, 'End');
  const length_s = await film_s(tab);
  assert.ok(length_s > 1);
  await press(tab, 'Home');
  assert.equal(await film_s(tab), 0);
  await press(tab, 'ArrowRight');
  const frame_s = await film_s(tab);
  assert.ok(frame_s > 0 && frame_s < 0.2);
  await press(tab, 'ArrowLeft');
  assert.equal(await film_s(tab), 0);
  await press(tab, ' ');
  await until(tab, 'document.getElementById("scrub").valueAsNumber > 0.2');
  await press(tab, ' ');
  await tab.evaluate(() => document.activeElement?.blur());
  await wait(150);
  const paused_s = await film_s(tab);
  await wait(300);
  assert.equal(await film_s(tab), paused_s);
  await press(tab, 'PageDown');
  const first_s = await film_s(tab);
  await press(tab, 'PageDown'); // goes on from the stop
  await until(tab, `document.getElementById("scrub").valueAsNumber > ${first_s + 0.1}`);
  await press(tab, 'PageDown'); // to the next, which loops
  await press(tab, 'PageUp');
  assert.ok(Math.abs((await film_s(tab)) - first_s) < 1e-9);
  await press(tab, '2'); // the second chapter
  assert.equal(await film_s(tab), 5);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('has a button for each of these', async (browser) => {
  const {tab, faults} = await opened(browser);
  await ready(tab);
  await tab.click('#play');
  await until(tab, 'document.getElementById("scrub").valueAsNumber > 0.2');
  await tab.click('#play');
  await tab.click('#next');
  const at_s = await film_s(tab);
  assert.ok(at_s > 0.2);
  await tab.click('#previous');
  assert.ok((await film_s(tab)) < at_s);
  await tab.click('#speed');
  await tab.evaluate(() => [...document.querySelectorAll('#speeds button')].find((b) => b.textContent.startsWith('4')).click());
  assert.match(await tab.$eval('#speed', (b) => b.textContent), /^4/);
  await press(tab, 'j');
  assert.match(await tab.$eval('#speed', (b) => b.textContent), /^−4/);
  const box = await (await tab.$('#scrub')).boundingBox();
  await tab.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  assert.ok(Math.abs((await film_s(tab)) / (await tab.$eval('#scrub', (s) => Number(s.max))) - 0.5) < 0.05);
  for (const id of ['previous', 'play', 'next', 'speed', 'say', 'show-options', 'full'])
    assert.ok(await tab.$eval(`#${id}`, (b) => b.getAttribute('aria-label').length > 0), id);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('turns, moves and zooms a panel, and goes back by one key', async (browser) => {
  const {tab, faults} = await opened(browser);
  await ready(tab);
  await until(tab, 'document.querySelector(".view")');
  const label = () => tab.$eval('.view', (view) => view.getAttribute('aria-label'));
  const scene = await label();
  await tab.mouse.move(200, 150);
  await tab.mouse.down();
  await tab.mouse.move(260, 180, {steps: 4});
  await tab.mouse.up();
  assert.notEqual(await label(), scene);
  await press(tab, 'c');
  assert.equal(await label(), scene);
  await tab.focus('.view');
  await tab.keyboard.down('Shift');
  await press(tab, 'ArrowLeft');
  await tab.keyboard.up('Shift');
  assert.notEqual(await label(), scene);
  await tab.mouse.wheel({deltaY: -240});
  await until(tab, 'location.hash.includes("view=")');
  await tab.evaluate(() => document.querySelector('.view').dispatchEvent(new MouseEvent('dblclick')));
  assert.equal(await label(), scene);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('changes values, says the regime, and shows refusals in place', async (browser) => {
  const {tab, faults} = await opened(browser, {size: {width: 1280, height: 720}});
  await ready(tab);
  await press(tab, 'o');
  await until(tab, 'document.querySelectorAll("#controls input").length > 0');
  const regime = await tab.$eval('#regime', (p) => p.textContent);
  assert.ok(regime.length > 10);
  await tab.evaluate(() => window.poinsot.set({'start.omega_rad_s': [1.9, 0.1, 0.1]}));
  assert.notEqual(await tab.$eval('#regime', (p) => p.textContent), regime);
  const refusal = await tab.evaluate(() => window.poinsot.set({'start.omega_rad_s': [0, 0, 0]}).then(() => '', (e) => e.message));
  assert.match(refusal, /omega_rad_s/);
  const omega = await tab.evaluate(() => window.poinsot.at(0).omega_body);
  assert.ok(omega.some((w) => w !== 0), 'a refused value changes nothing');
  // The first moment: one that no body has with the others, and then one that it has.
  const field = 'fieldset:nth-child(2) input[type=number]';
  const type = async (text) => {
    await tab.$eval(field, (input) => {
      input.focus();
      input.select();
    });
    await tab.keyboard.type(text);
  };
  await type('9');
  await tab.keyboard.press('Enter');
  await until(tab, 'document.querySelectorAll(".refusal")[1].textContent.includes("no distribution of mass has the moments 9, 2, 1")');
  await type('2.5');
  await tab.keyboard.press('Enter');
  await until(tab, '[...document.querySelectorAll(".refusal")].every((p) => p.textContent === "")');
  await tab.click('#original');
  assert.equal(await tab.$eval('#regime', (p) => p.textContent), regime);
  assert.deepEqual(faults, []);
  await tab.close();
});

/** Where something can be dragged, in CSS pixels; null: nowhere. Of ω, the contact point. */
const place_of = (tab, thing) => tab.evaluate((thing) => {
  const {figure} = the_page;
  const grip = figure.program.grips(figure.time_s, figure.film.at_s).find((found) => found.thing === thing && found.x === found.moved_x);
  return grip ? [grip.x / figure.ratio, grip.y / figure.ratio] : null;
}, thing);

check('drags the tip of ω along the ellipsoid, with the same energy', async (browser) => {
  const {tab, faults} = await opened(browser, {size: {width: 800, height: 560}});
  await ready(tab);
  await press(tab, 'Home');
  const tip = await place_of(tab, 'omega');
  assert.ok(tip, 'the tip of ω is in sight');
  const omega = () => tab.evaluate(() => window.poinsot.at(0).omega_body);
  const energy = ([x, y, z]) => 3 * x * x + 2 * y * y + z * z;
  const before = await omega();
  await tab.mouse.move(tip[0], tip[1]);
  await until(tab, 'document.querySelector(".view.omega")');
  await tab.mouse.down();
  await tab.mouse.move(tip[0] + 14, tip[1] - 10, {steps: 3});
  await until(tab, `window.poinsot.at(0).omega_body[0] !== ${before[0]}`);
  await settled(tab);
  await tab.mouse.up();
  const after = await omega();
  assert.notDeepEqual(after, before);
  // Six digits of each component are kept.
  assert.ok(Math.abs(energy(after) / energy(before) - 1) < 1e-4, `${energy(after)} is not ${energy(before)}`);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('drags at any instant: the film stays there, L keeps its direction, and Esc takes it back', async (browser) => {
  const scene = scene_file('touched', '[body]\nmoments_kg_m2 = [3, 2, 1]\n[start]\nomega_rad_s = [0.3, 1.6, 0.6]\n[film]\nlength_s = 20\n');
  const {tab, faults} = await opened_file(browser, page_of(program, scene, `${scene}.html`), {size: {width: 800, height: 560}, fragment: '#at=7.5'});
  await ready(tab);
  await settled(tab);
  const state = () => tab.evaluate(() => window.poinsot.at(the_page.figure.time_s));
  const values = async () => {
    const {omega_body: w, space_from_body: [q0, ...q]} = await state();
    const momentum = [3 * w[0], 2 * w[1], w[2]];
    const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    // v + 2 q0 (q × v) + 2 q × (q × v)
    const once = cross(q, momentum);
    const twice = cross(q, once);
    const space = momentum.map((x, k) => x + 2 * q0 * once[k] + 2 * twice[k]);
    const size = Math.hypot(...space);
    return {energy: w.reduce((sum, x, k) => sum + 0.5 * momentum[k] * x, 0), momentum: size, direction: space.map((x) => x / size), omega: w};
  };
  for (const thing of ['omega', 'plane']) {
    const before = await values();
    const grip = await place_of(tab, thing);
    assert.ok(grip, `${thing} is in sight`);
    const to = thing === 'omega' ? [grip[0] + 25, grip[1] - 12] : [grip[0], grip[1] + 10];
    await tab.mouse.move(grip[0], grip[1]);
    await tab.mouse.down();
    await tab.mouse.move(to[0], to[1], {steps: 5});
    await until(tab, 'the_page.coming.size === 0 && the_page.figure.choices.values.has("start.attitude")');
    await settled(tab);
    const after = await values();
    assert.ok(Math.abs((await film_s(tab)) - 7.5) < 1e-9, 'the film stays where it is');
    const kept = thing === 'omega' ? 'energy' : 'momentum';
    const changed = thing === 'omega' ? 'momentum' : 'energy';
    assert.ok(Math.abs(after[kept] / before[kept] - 1) < 1e-11, `${thing}: ${kept} is ${after[kept]}, not ${before[kept]}`);
    assert.ok(Math.abs(after[changed] / before[changed] - 1) > 1e-3, `${thing}: ${changed} stays`);
    assert.ok(Math.hypot(...after.direction.map((x, k) => x - before.direction[k])) < 1e-11, 'L keeps its direction');
    if (thing === 'omega') {
      const tip = await place_of(tab, 'omega');
      assert.ok(Math.hypot(tip[0] - to[0], tip[1] - to[1]) < 2, `the tip is at ${tip}, the pointer at ${to}`);
    }
    await tab.mouse.up();
    await press(tab, 'Escape');
    await until(tab, '!the_page.figure.choices.values.has("start.attitude")');
    await settled(tab);
    assert.deepEqual((await values()).omega, before.omega, 'Esc takes it back');
  }
  // The keyboard reaches the rings.
  const before = await state();
  await tab.evaluate(() => document.querySelector('.grip').focus());
  await press(tab, 'ArrowUp');
  await until(tab, 'the_page.coming.size === 0 && the_page.figure.choices.values.has("start.attitude")');
  assert.notDeepEqual((await state()).omega_body, before.omega_body);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('turns the body beside the construction while the contact point is held', async (browser) => {
  const scene = scene_file('beside', 'labels = false\noverlays = false\nshow = ["ellipsoid", "plane", "radius", "body-beside"]\n[body]\nmoments_kg_m2 = [4, 3, 1.5]\n'
    + '[start]\nomega_rad_s = [0, 2.04, 0.55]\n[camera]\nazimuth_deg = -40\nelevation_deg = 14\ndistance = 6\n[film]\nlength_s = 20\n');
  const {tab, faults} = await opened_file(browser, page_of(program, scene, `${scene}.html`), {size: {width: 1280, height: 720}, fragment: '#at=7.5'});
  await ready(tab);
  await settled(tab);
  const [x, y] = await place_of(tab, 'omega');
  await tab.mouse.move(x, y);
  await tab.mouse.down();
  await until(tab, 'the_page.figure.beside_s > 0.8');
  // The shares of the pixels, of the body at the left and of the construction, that differ between two instants.
  const shares = await tab.evaluate(() => {
    const {figure} = the_page;
    const {width, height} = figure.canvas;
    const {time_s, film, beside_s} = figure;
    const shot = (t, later_s) => {
      figure.program.draw(t, film.at_s, later_s);
      const context = new OffscreenCanvas(width, height).getContext('2d');
      context.drawImage(figure.canvas, 0, 0);
      return context.getImageData(0, 0, width, height).data;
    };
    const [now, held, later] = [shot(time_s, 0), shot(time_s, beside_s), shot(time_s + beside_s, 0)];
    const differ = (a, b, from, to) => {
      let n = 0;
      for (let k = 0; k < a.length; k += 4) {
        const column = (k / 4) % width / width;
        n += Number(column >= from && column < to && [0, 1, 2].some((c) => Math.abs(a[k + c] - b[k + c]) > 8));
      }
      return n / (width * height);
    };
    return {film_s: film.at_s, turned: differ(now, held, 0, 0.26), as_later: differ(held, later, 0, 0.26), stands: differ(now, held, 0.3, 1), moves: differ(now, later, 0.3, 1)};
  });
  assert.equal(shares.film_s, 7.5);
  assert.ok(shares.turned > 2e-3 && shares.moves > 2e-3 && shares.as_later < 2e-4 && shares.stands < 2e-4, JSON.stringify(shares));
  // It begins anew where the pointer rests, and stops when the pointer lets go.
  const before = await tab.evaluate(() => ({...the_page.grips.rests}));
  await tab.mouse.move(x + 20, y - 10);
  await until(tab, `the_page.coming.size === 0 && the_page.grips.rests.x - ${before.x} > 10`);
  await tab.mouse.up();
  await settled(tab);
  assert.equal(await tab.evaluate(() => the_page.figure.beside_s), null);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('lists every key that works, and no other', async (browser) => {
  const {tab, faults} = await opened(browser);
  await ready(tab);
  const letters = Array.from({length: 95}, (_, i) => String.fromCharCode(32 + i)).filter((letter) => letter === letter.toLowerCase());
  const names = ['ArrowLeft', 'ArrowUp', 'ArrowRight', 'ArrowDown', 'PageUp', 'PageDown', 'Home', 'End', 'Enter', 'Tab', 'Backspace', 'Delete', 'Insert', 'F2'];
  const works = await tab.evaluate((keys) => keys.flatMap((key) => ['', 'Shift ', 'Alt '].filter((modifier) => {
    // Other keys need Shift on some keyboards.
    if (modifier === 'Shift ' && !key.startsWith('Arrow')) return false;
    const event = new KeyboardEvent('keydown', {key, shiftKey: modifier === 'Shift ', altKey: modifier === 'Alt ', bubbles: true, cancelable: true});
    document.body.dispatchEvent(event);
    // A covered page takes any key.
    if (!document.getElementById('blank').hidden) document.body.dispatchEvent(new KeyboardEvent('keydown', {key: 'x', bubbles: true}));
    return event.defaultPrevented;
  }).map((modifier) => modifier + key)), [...letters, ...names]);
  const meant = {Space: ' ', 'Page ↑': 'PageUp', 'Page ↓': 'PageDown', '←': 'ArrowLeft', '↑': 'ArrowUp', '→': 'ArrowRight', '↓': 'ArrowDown', '−': '-'};
  const named = (cap) => meant[cap] ?? (cap.length === 1 ? cap.toLowerCase() : cap);
  const rows = await tab.$$eval('#keys dt', (terms) => terms.map((term) => [...term.querySelectorAll('kbd')].map((cap) => cap.textContent)));
  const listed = rows.flatMap((caps) => {
    if (caps[1] === '…') return Array.from({length: Number(caps[2]) - Number(caps[0]) + 1}, (_, i) => String(Number(caps[0]) + i));
    if (['Shift', 'Alt'].includes(caps[0])) return caps[1].split(' ').map((cap) => `${caps[0]} ${named(cap)}`);
    return caps.map(named);
  });
  assert.ok(listed.length > 40);
  // "=" is "+" without Shift.
  assert.deepEqual(works.filter((key) => key !== '=').sort(), listed.sort());
  assert.deepEqual(faults, []);
  await tab.close();
});

check('covers the screen by B and W, and any key comes back', async (browser) => {
  const {tab, faults} = await opened(browser);
  await ready(tab);
  for (const [key, colour] of [['b', 'rgb(0, 0, 0)'], ['.', 'rgb(0, 0, 0)'], ['w', 'rgb(255, 255, 255)'], [',', 'rgb(255, 255, 255)']]) {
    await press(tab, key);
    const seen = await tab.evaluate(() => {
      const top = document.elementFromPoint(innerWidth / 2, innerHeight - 5);
      return [top.id, getComputedStyle(top).backgroundColor];
    });
    assert.deepEqual(seen, ['blank', colour]);
    const at_s = await film_s(tab);
    await press(tab, 'PageDown');
    assert.equal(await tab.$eval('#blank', (cover) => cover.hidden), true);
    assert.equal(await film_s(tab), at_s, 'the key that comes back does nothing else');
  }
  assert.deepEqual(faults, []);
  await tab.close();
});

check('answers a press in a loop at once', async (browser) => {
  const {tab, faults} = await opened(browser);
  await ready(tab);
  await tab.evaluate(() => {
    the_page.figure.film.to_stop(2);
    the_page.changed();
  });
  await until(tab, 'the_page.figure.film.at_s > 5 && the_page.figure.film.at_s < 5.5');
  // In one go, for a loop of a second may be over before a slow browser answers.
  const [said, marked] = await tab.evaluate(() => {
    document.dispatchEvent(new KeyboardEvent('keydown', {key: 'PageDown', bubbles: true}));
    return [document.getElementById('time').textContent, document.querySelector('#stops i.leaving') !== null];
  });
  assert.match(said, /seam/);
  assert.ok(marked, 'the mark of the stop pulses');
  await until(tab, 'the_page.figure.film.at_s > 6.1');
  assert.doesNotMatch(await tab.$eval('#time', (time) => time.textContent), /seam/);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('drags the plane along L to another polhode, with the same L', async (browser) => {
  const scene = scene_file('plane', fs.readFileSync(lecture, 'utf8').replace(/omega_rad_s = .*/, '$&\nenergy_J = 3.0\nmomentum_kg_m2_s = 3.5')
    .replace('"start.omega_rad_s", ', '"start.energy_J", '));
  const {tab, faults} = await opened_file(browser, page_of(program, scene, `${scene}.html`), {size: {width: 800, height: 560}});
  await ready(tab);
  const foot = await place_of(tab, 'plane');
  assert.ok(foot, 'the foot of L is in sight');
  const moments = [3, 2, 1];
  const values = async () => {
    const omega = await tab.evaluate(() => window.poinsot.at(0).omega_body);
    return {energy: omega.reduce((sum, w, k) => sum + 0.5 * moments[k] * w * w, 0), momentum: Math.hypot(...omega.map((w, k) => moments[k] * w))};
  };
  assert.ok(Math.abs((await values()).energy - 3) < 1e-12);
  await tab.mouse.move(foot[0], foot[1]);
  await until(tab, 'document.querySelector(".view.omega")');
  await tab.mouse.down();
  await tab.mouse.move(foot[0], foot[1] + 12, {steps: 2});
  await until(tab, 'the_page.figure.choices.values.has("start.energy_J")');
  await settled(tab);
  await tab.mouse.up();
  const after = await values();
  assert.ok(after.energy > 3.05, `away from the centre the energy grows: ${after.energy}`);
  assert.ok(Math.abs(after.momentum - 3.5) < 1e-12);
  // Far beyond what this L allows: the bound, L²/(2 I₃), where the body turns about e₃.
  await tab.mouse.move(foot[0], foot[1] + 12);
  await tab.mouse.down();
  await tab.mouse.move(foot[0], 555, {steps: 2});
  await settled(tab);
  await tab.mouse.up();
  assert.ok((await values()).energy <= (3.5 * 3.5) / 2 + 1e-5);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('repeats the loop of a stop until its viewer goes on', async (browser) => {
  const {tab, faults} = await opened(browser);
  await ready(tab);
  await tab.evaluate(() => the_page.figure.film.seek(5.9));
  await press(tab, ' ');
  await until(tab, 'the_page.figure.film.is_looping');
  for (let i = 0; i < 8; ++i) {
    await wait(150);
    const at_s = await film_s(tab);
    assert.ok(at_s >= 5 - 1e-9 && at_s <= 6 + 1e-9, `${at_s} is outside of the loop`);
  }
  assert.equal(await tab.$eval('#stops', (stops) => [...stops.children].findIndex((mark) => mark.classList.contains('now'))), 1);
  await press(tab, 'PageDown');
  await until(tab, 'document.getElementById("scrub").valueAsNumber > 6.1');
  assert.deepEqual(faults, []);
  await tab.close();
});

check('shows and hides elements and names, and changes its colours', async (browser) => {
  const {tab, faults} = await opened(browser);
  await ready(tab);
  await press(tab, 'o');
  await until(tab, 'document.querySelectorAll("#elements input").length > 1');
  const shot = () => tab.evaluate(() => window.poinsot.png(160, 90).then((blob) => blob.size));
  const all = await shot();
  await tab.evaluate(() => [...document.querySelectorAll('#elements input')].find((box) => box.name !== '' && box.checked).click());
  assert.notEqual(await shot(), all);
  const ground = await tab.evaluate(() => getComputedStyle(document.body).backgroundColor);
  await press(tab, 't');
  assert.notEqual(await tab.evaluate(() => getComputedStyle(document.body).backgroundColor), ground);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('after a refused element, the others can still be shown and hidden', async (browser) => {
  const {tab, faults} = await opened(browser);
  await ready(tab);
  const click = (name) => tab.evaluate((name) => [...document.querySelectorAll('#elements input')].find((box) => box.name === name).click(), name);
  const is_checked = (name) => tab.evaluate((name) => [...document.querySelectorAll('#elements input')].find((box) => box.name === name).checked, name);
  await click('ghost'); // there is no second method
  assert.match(await tab.$eval('#sentence', (p) => (p.hidden ? '' : p.textContent)), /beside/);
  assert.equal(await is_checked('ghost'), false);
  await click('plane');
  assert.equal(await is_checked('plane'), false);
  assert.equal(await tab.$eval('#sentence', (p) => p.hidden), true);
  await until(tab, 'location.hash.includes("show=")');
  assert.doesNotMatch(await tab.evaluate(() => location.hash), /ghost/);
  // A link that holds it shows the scene itself, and says why.
  const other = await opened(browser, {fragment: '#show=ghost&names=false'});
  await ready(other.tab);
  assert.match(await other.tab.$eval('#sentence', (p) => (p.hidden ? '' : p.textContent)), /beside/);
  assert.deepEqual(await other.tab.evaluate(() => [the_page.figure.choices.shown, the_page.figure.choices.names]), [null, null]);
  assert.deepEqual([...faults, ...other.faults], []);
  await tab.close();
  await other.tab.close();
});

check('a drawing that crashes again ends, and a click starts it', async (browser) => {
  const {tab, faults} = await opened(browser);
  await ready(tab);
  await tab.evaluate(() => {
    const {figure} = the_page;
    figure.program.draw = () => { throw new ProgramError({kind: 'crash', message: 'unreachable'}); };
    figure.invalidate();
  });
  await until(tab, 'the_page.failure === "no-start"');
  assert.match(await tab.$eval('#sentence', (p) => (p.hidden ? '' : p.textContent)), /unreachable/);
  await tab.click('#stage');
  await until(tab, 'document.getElementById("sentence").hidden && document.body.classList.contains("drawn")');
  assert.deepEqual(faults, []);
  await tab.close();
});

check('a figure that is asked for a picture while it starts anew does so once', async (browser) => {
  const {tab, faults} = await opened(browser);
  await ready(tab);
  const n_starts = await tab.evaluate(async () => {
    const {figure} = the_page;
    const {program} = figure;
    const next_frame = () => new Promise((resolve) => { requestAnimationFrame(() => requestAnimationFrame(resolve)); });
    const restart = program.restart.bind(program);
    const draw = program.draw.bind(program);
    let n_starts = 0;
    let release;
    const held = new Promise((resolve) => { release = resolve; });
    program.restart = async () => {
      ++n_starts;
      await held;
      await restart();
      program.draw = draw;
    };
    program.draw = () => { throw new ProgramError({kind: 'crash', message: 'unreachable'}); };
    for (let i = 0; i < 3; ++i) {
      figure.invalidate();
      await next_frame();
    }
    release();
    return n_starts;
  });
  assert.equal(n_starts, 1);
  await until(tab, '!the_page.figure.is_reviving && the_page.figure.frame === 0 && !the_page.figure.is_revived');
  assert.deepEqual(faults, []);
  await tab.close();
});

check('a link opened in the loop of a stop goes to its instant', async (browser) => {
  const {tab, faults} = await opened(browser);
  await ready(tab);
  await tab.evaluate(() => {
    const {film} = the_page.figure;
    film.seek(5.9);
    film.play();
    film.advance(0.2);
    location.hash = '#at=8';
  });
  await until(tab, 'the_page.figure.film.at_s >= 8');
  assert.deepEqual(await tab.evaluate(() => [the_page.figure.film.waiting, the_page.figure.film.leaving]), [-1, false]);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('a link opens the same instant, view and values', async (browser) => {
  const {tab, faults} = await opened(browser);
  await ready(tab);
  await tab.evaluate(() => {
    window.poinsot.seek(1.5);
    window.poinsot.view({azimuth_deg: 10, elevation_deg: 30});
    return window.poinsot.set({'start.omega_rad_s': [0.4, 1.5, 0.7]});
  });
  await until(tab, '["at=1.5", "view=", "set="].every((part) => location.hash.includes(part))');
  const fragment = await tab.evaluate(() => location.hash);
  const label = await tab.$eval('.view', (view) => view.getAttribute('aria-label'));
  const other = await opened(browser, {fragment});
  await ready(other.tab);
  assert.equal(await other.tab.evaluate(() => window.poinsot.time_s), await tab.evaluate(() => window.poinsot.time_s));
  assert.equal(await other.tab.$eval('.view', (view) => view.getAttribute('aria-label')), label);
  assert.deepEqual(await other.tab.evaluate(() => window.poinsot.at(0).omega_body), [0.4, 1.5, 0.7]);
  await other.tab.reload();
  await ready(other.tab);
  assert.equal(await other.tab.evaluate(() => window.poinsot.time_s), 1.5);
  assert.deepEqual([...faults, ...other.faults], []);
  await tab.close();
  await other.tab.close();
});

check('a link sets no other keys', async (browser) => {
  for (const fragment of ['#set=title=evil&set=body.mesh=/etc/passwd', '#set=start.omega_rad_s=[1.2,0.8,2.4]%00title="evil"']) {
    const {tab, faults} = await opened(browser, {fragment});
    await ready(tab);
    assert.doesNotMatch(await tab.evaluate(() => the_page.figure.loaded.title), /evil/);
    assert.doesNotMatch(await tab.evaluate(() => document.body.textContent), /passwd/);
    assert.deepEqual(faults, []);
    await tab.close();
  }
});

check('fits windows, screens and zoom', async (browser) => {
  const {tab, faults} = await opened(browser);
  await ready(tab);
  for (const size of [{width: 1280, height: 720}, {width: 390, height: 844, deviceScaleFactor: 2}, {width: 480, height: 270, deviceScaleFactor: 4}, {width: 320, height: 180, deviceScaleFactor: 4}]) {
    await tab.setViewport(size);
    await settled(tab);
    const fits = await tab.evaluate(() => {
      const canvas = document.querySelector('canvas');
      const box = canvas.getBoundingClientRect();
      return {sharp: Math.abs(canvas.width - box.width * devicePixelRatio) <= 2, inside: document.documentElement.scrollWidth <= innerWidth,
        seen: box.width > 100 && box.height > 50 && box.bottom <= innerHeight + 1,
        hit: [...document.querySelectorAll('#bar > button')].filter((b) => b.offsetParent).every((b) => b.offsetWidth >= (innerWidth <= 440 && innerHeight < 400 ? 30 : 44) && b.getBoundingClientRect().right <= innerWidth),
        all: ['previous', 'play', 'next', 'speed', 'say', 'show-options'].every((id) => document.getElementById(id).offsetParent),
        line: innerHeight >= 400 || document.getElementById('bar').offsetHeight <= 56, rail: document.getElementById('rail').offsetWidth >= 30};
    });
    assert.deepEqual(fits, {sharp: true, inside: true, seen: true, hit: true, all: true, line: true, rail: true}, JSON.stringify(size));
  }
  assert.deepEqual(faults, []);
  await tab.close();
});

check('enlarges the letters of the picture with the page, and not on another screen', async (browser) => {
  const {tab, faults} = await opened(browser, {size: {width: 1280, height: 720}});
  await ready(tab);
  await settled(tab);
  const scale = () => tab.evaluate(() => the_page.figure.program.last.type_scale);
  const usual = await scale();
  // The browser's zoom by 200 %: half of the layout, the same pixels of the screen.
  await tab.setViewport({width: 640, height: 360, deviceScaleFactor: 2});
  await until(tab, `the_page.figure.program.last.type_scale > ${1.5 * usual}`);
  await tab.setViewport({width: 1280, height: 720});
  await until(tab, `Math.abs(the_page.figure.program.last.type_scale / ${usual} - 1) < 1e-9`);
  // A screen of finer pixels: the same layout.
  await tab.setViewport({width: 1284, height: 720, deviceScaleFactor: 2});
  await settled(tab);
  assert.ok(Math.abs((await scale()) / usual - 1) < 1e-9);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('keeps the strip of its bar in full screen', async (browser) => {
  const {tab, faults} = await opened(browser, {size: {width: 1280, height: 720}});
  await ready(tab);
  await tab.evaluate(() => document.documentElement.requestFullscreen().catch(() => {}));
  const boxes = await tab.evaluate(() => [document.getElementById('stage').getBoundingClientRect().bottom, document.getElementById('bar').getBoundingClientRect().top]);
  assert.ok(boxes[0] <= boxes[1] + 0.5, `the picture ends at ${boxes[0]}, the bar begins at ${boxes[1]}`);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('takes hold of the construction while it moves, and goes on from there', async (browser) => {
  const {tab, faults} = await opened(browser, {size: {width: 800, height: 560}});
  await ready(tab);
  await tab.evaluate(() => {
    the_page.figure.film.to_stop(2);
    the_page.changed();
  });
  // A film of slow motion, so that the grip does not run away from the pointer.
  await tab.evaluate(() => { the_page.figure.film.speed = 0.01; });
  const grip = await place_of(tab, 'omega');
  assert.ok(grip, 'the tip of ω is in sight');
  assert.ok(await tab.evaluate(() => the_page.figure.film.is_looping));
  await tab.mouse.move(grip[0], grip[1]);
  await tab.mouse.down();
  assert.equal(await tab.evaluate(() => the_page.figure.film.playing), false, 'it stands while it is held');
  await tab.mouse.move(grip[0] + 14, grip[1] - 8, {steps: 3});
  await until(tab, 'the_page.figure.choices.values.has("start.omega_rad_s")');
  await tab.mouse.up();
  assert.ok(await tab.evaluate(() => the_page.figure.film.is_looping), 'and goes on in its loop');
  await press(tab, 'Escape');
  await until(tab, '!the_page.figure.choices.values.has("start.omega_rad_s")');
  assert.deepEqual(faults, []);
  await tab.close();
});

check('leads to the page that follows at the end of the film', async (browser) => {
  const scene = (name, next) => scene_file(name, `title = "${name}"\n[body]\nmoments_kg_m2 = [3, 2, 1]\n[start]\nomega_rad_s = [0.3, 1.6, 0.6]\n[film]\nlength_s = 2\n${next}`);
  const [one, two] = [scene('one', '[page]\nnext = "two of it.html"\n'), scene('two', '')];
  page_of(program, two, path.join(path.dirname(one), 'two of it.html'));
  const {tab, faults} = await opened_file(browser, page_of(program, one, `${one}.html`));
  await ready(tab);
  assert.equal(await tab.$eval('#onward', (link) => link.hidden), true);
  await press(tab, 'End');
  await until(tab, '!document.getElementById("onward").hidden');
  assert.equal(await tab.$eval('#onward', (link) => link.textContent), 'Next: two of it');
  await Promise.all([tab.waitForNavigation(), press(tab, 'PageDown')]);
  assert.match(decodeURIComponent(tab.url()), /two of it\.html/);
  await ready(tab);
  assert.equal(await tab.evaluate(() => the_page.figure.loaded.title), 'two');
  await press(tab, 'End');
  assert.equal(await tab.$eval('#onward', (link) => link.hidden), true);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('gives the scenes that follow in one page, by one key, forwards and backwards', async (browser) => {
  const scene = (name, rest) => scene_file(name, `title = "${name}"\n[body]\nmoments_kg_m2 = [3, 2, 1]\n[start]\nomega_rad_s = [0.3, 1.6, 0.6]\n[film]\nlength_s = 2\n${rest}`);
  const first = scene('chain_one', 'still_s = 1\n[page]\nnext = "chain_two.html"\nplanned_s = 90\n[[stops]]\nat_s = 1\ntitle = "Only"\n[[stops]]\nat_s = 2\ntitle = "End of one"\n');
  scene('chain_two', 'still_s = 1.5\n[page]\nnext = "chain_three.html"\n');
  scene('chain_three', '[page]\nnext = "chain_one.html"\n[[stops]]\nat_s = 0.5\ntitle = "Third"\nnote = "Say it."\nplanned_s = 30\n');
  const {tab, faults} = await opened_file(browser, page_of(program, first, path.join(folder, 'chain_one.html')));
  await ready(tab);
  const title = () => tab.evaluate(() => the_page.figure.loaded.title);
  const note = (name) => tab.evaluate((name) => the_page.notes.page.querySelector(`.notes-${name}`).textContent, name);
  await press(tab, 'n');
  await tab.bringToFront();
  await tab.evaluate(() => { window.notes_page = the_page.notes.page; });
  // The key alone, to the end of the last scene.
  await press(tab, 'PageDown');
  await until(tab, 'the_page.figure.film.waiting === 0');
  assert.equal(await note('where'), '1 / 3 · Only');
  await press(tab, 'PageDown');
  await until(tab, 'the_page.figure.film.waiting === 1');
  assert.equal(await note('next'), 'Next: chain_two');
  await press(tab, 'PageDown');
  await until(tab, 'the_page.figure.loaded.title === "chain_two"');
  assert.equal(await film_s(tab), 1.5, 'it opens as its still');
  assert.equal(await note('where'), 'chain_two');
  assert.equal(await tab.title(), 'chain_two');
  await press(tab, 'PageDown');
  await until(tab, 'the_page.figure.film.playing && the_page.figure.film.at_s < 1');
  await until(tab, 'the_page.figure.film.is_over');
  await press(tab, 'PageDown');
  await until(tab, 'the_page.figure.loaded.title === "chain_three"');
  assert.equal(await note('where'), '3 / 3 · Third');
  assert.equal(await note('note'), 'Say it.');
  assert.match(await note('clock'), /Planned 2:00/, 'after the planned time of the scenes before it');
  await until(tab, '/Elapsed 0:0[1-9]/.test(the_page.notes.page.querySelector(".notes-clock").textContent)');
  // One window of notes, whose keys go on working.
  assert.ok(await tab.evaluate(() => the_page.notes.is_open && the_page.notes.page === window.notes_page));
  await tab.evaluate(() => the_page.notes.keys(new KeyboardEvent('keydown', {key: 'PageDown'})));
  await until(tab, 'the_page.figure.film.waiting === 0');
  // The link holds the scene.
  await until(tab, 'location.hash.includes("scene=chain_three&at=0.5")');
  await tab.reload();
  await ready(tab);
  assert.equal(await title(), 'chain_three');
  assert.equal(await film_s(tab), 0.5);
  // Backwards, to the end of the scene before.
  await press(tab, 'PageUp');
  assert.equal(await film_s(tab), 0);
  await press(tab, 'PageUp');
  assert.equal(await title(), 'chain_two');
  assert.equal(await film_s(tab), 2);
  await press(tab, 'PageUp');
  await tab.click('#previous');
  assert.equal(await title(), 'chain_one');
  assert.equal(await film_s(tab), 2);
  await tab.click('#next');
  assert.equal(await title(), 'chain_two');
  await tab.evaluate(() => { location.hash = '#at=0.5'; });
  await until(tab, 'the_page.figure.loaded.title === "chain_one" && the_page.figure.film.at_s === 0.5');
  assert.deepEqual(faults, []);
  await tab.close();
});

check('takes a drag back at the next stop', async (browser) => {
  const {tab, faults} = await opened(browser);
  await ready(tab);
  const omega = () => tab.evaluate(() => poinsot.at(0).omega_body);
  const drag = () => tab.evaluate(() => {
    const {grips, figure} = the_page;
    figure.program.draw(figure.time_s, figure.film.at_s);
    const grip = figure.program.grips(figure.time_s, figure.film.at_s).find(({thing}) => thing === 'omega');
    grips.take(grip.x, grip.y, grip.panel);
    grips.drag(grip.x + 15, grip.y + 10);
    figure.before_next();
    figure.before_next = null;
    grips.drop();
  });
  const first = await omega();
  await tab.evaluate(() => poinsot.set({'body.moments_kg_m2': [3, 2, 1.2]}));
  // At a stop that stands, and twice at one that loops.
  for (const [here, n_drags, there] of [[1, 1, 2], [2, 2, 1]]) {
    await tab.evaluate((stop) => poinsot.seek_stop(stop), here);
    await until(tab, `poinsot.stop === ${here} && the_page.figure.frame === 0 || the_page.figure.film.is_looping`);
    for (let k = 0; k < n_drags; ++k) await drag();
    assert.notDeepEqual(await omega(), first);
    await wait(300);
    assert.notDeepEqual(await omega(), first, 'it stays at its stop');
    await tab.evaluate((stop) => poinsot.seek_stop(stop), there);
    await until(tab, `poinsot.stop === ${there} && !the_page.figure.choices.values.has('start.omega_rad_s')`);
    assert.deepEqual(await omega(), first);
    assert.equal(await tab.evaluate(() => the_page.figure.choices.values.get('body.moments_kg_m2')), '[3.0, 2.0, 1.2]', 'what was not dragged stays');
  }
  assert.deepEqual(faults, []);
  await tab.close();
});

check('sets captions of 12 to 15 pixels on small screens', async (browser) => {
  const {tab, faults} = await opened(browser);
  for (const [width, height] of [[390, 764], [390, 325], [640, 320], [1024, 500]]) {
    const px = await tab.evaluate((w, h) => (26 / 1080) * h * type_scale_of(w, h), width, height);
    assert.ok(px >= 11.9 && px <= 15, `${px} pixels at ${width} x ${height}`);
  }
  assert.equal(await tab.evaluate(() => type_scale_of(1920, 1080)), 1);
  await tab.setViewport({width: 390, height: 844});
  await ready(tab);
  await settled(tab);
  assert.ok((await tab.evaluate(() => the_page.figure.program.last.type_scale)) < 1);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('goes on after a lost context', async (browser) => {
  const {tab, faults} = await opened(browser);
  await ready(tab);
  const before = await picture(tab);
  await lose_context(tab);
  await until(tab, '!document.getElementById("sentence").hidden');
  assert.equal(await tab.$eval('#poster', (img) => getComputedStyle(img).visibility), 'visible');
  await tab.evaluate(() => window.lose.restoreContext());
  await until(tab, 'document.getElementById("sentence").hidden && document.body.classList.contains("drawn")');
  assert.equal(await picture(tab), before);
  await press(tab, 'ArrowRight');
  assert.ok((await film_s(tab)) > 0);
  assert.deepEqual(faults.filter((fault) => !fault.includes('CONTEXT_LOST')), []);
  await tab.close();
});

check('starts again by a click where the browser does not give the context back', async (browser) => {
  const {tab, faults} = await opened(browser);
  await ready(tab);
  await press(tab, 'ArrowRight');
  const before = await picture(tab);
  const at_s = await film_s(tab);
  await lose_context(tab);
  await until(tab, '!document.getElementById("sentence").hidden');
  await tab.click('#stage');
  await until(tab, 'document.getElementById("sentence").hidden && document.body.classList.contains("drawn")');
  assert.equal(await film_s(tab), at_s);
  assert.equal(await picture(tab), before);
  assert.deepEqual(faults.filter((fault) => !fault.includes('CONTEXT_LOST')), []);
  await tab.close();
});

check('carries the files of its scene, also past a lost context', async (browser) => {
  const scene = scene_file('mesh', 'show = ["ellipsoid", "body", "momentum"]\n[body]\nmesh = "solid.obj"\ndensity_kg_m3 = 1000\n[start]\nomega_rad_s = [0.1, 2, 0.1]\n',
    {'solid.obj': 'v 0 0 0\nv 2 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n'});
  const {tab, faults} = await opened_file(browser, page_of(program, scene, `${scene}.html`));
  await ready(tab);
  assert.equal(await tab.evaluate(() => window.poinsot.at(0).omega_body[1]), 2);
  const before = await picture(tab);
  await lose_context(tab);
  await until(tab, '!document.getElementById("sentence").hidden');
  await tab.evaluate(() => window.lose.restoreContext());
  await until(tab, 'document.getElementById("sentence").hidden && document.body.classList.contains("drawn")');
  assert.equal(await picture(tab), before);
  // A file that the page does not carry is refused, and the figure goes on.
  assert.match(await tab.evaluate(() => window.poinsot.set({'body.mesh': '"/etc/passwd"'}).then(() => '', (e) => e.message)), /passwd/);
  assert.equal(await picture(tab), before);
  assert.deepEqual(faults.filter((fault) => !fault.includes('CONTEXT_LOST')), []);
  await tab.close();
});

check('without WebGL or wasm: the poster and a sentence', async (browser) => {
  const no_webgl = await opened(browser, {before: () => { HTMLCanvasElement.prototype.getContext = () => null; }});
  await until(no_webgl.tab, '!document.getElementById("sentence").hidden');
  assert.match(await no_webgl.tab.$eval('#sentence', (p) => p.textContent), /WebGL/);
  assert.equal(await no_webgl.tab.$eval('#bar', (bar) => bar.hidden), true);
  assert.equal(await no_webgl.tab.$eval('#poster', (img) => getComputedStyle(img).visibility), 'visible');
  await no_webgl.tab.close();
  const no_wasm = await opened(browser, {before: () => { delete window.WebAssembly; }});
  await until(no_wasm.tab, '!document.getElementById("sentence").hidden');
  assert.match(await no_wasm.tab.$eval('#sentence', (p) => p.textContent), /WebAssembly/);
  await no_wasm.tab.close();
});

check('runs in a sandboxed frame, and gives it unused keys', async (browser) => {
  const tab = await browser.newPage();
  const faults = faults_of(tab);
  await tab.setViewport({width: 700, height: 500});
  await tab.setContent('<!doctype html><iframe sandbox="allow-scripts" style="width:600px;height:400px"></iframe>');
  await tab.evaluate((html) => {
    window.keys = [];
    window.addEventListener('message', (event) => window.keys.push(event.data));
    document.querySelector('iframe').srcdoc = html;
  }, fs.readFileSync(page_file, 'utf8'));
  await wait(300);
  const frame = tab.frames().find((f) => f !== tab.mainFrame());
  await frame.waitForFunction('document.body?.classList.contains("drawn")', {timeout: 60000});
  await frame.focus('#play');
  await tab.keyboard.press('Escape');
  await tab.keyboard.press('g');
  await tab.waitForFunction('window.keys.length > 0', {timeout: 60000});
  assert.deepEqual(await tab.evaluate(() => window.keys.map((k) => [k.type, k.key])), [['poinsot-key', 'Escape'], ['poinsot-key', 'g']]);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('an embedded figure starts at the instant of its link, and rests where it left the window as it started', async (browser) => {
  const tab = await browser.newPage();
  const faults = faults_of(tab);
  await tab.setViewport({width: 500, height: 420});
  const file = path.join(folder, 'below.html');
  const frame = `<iframe src="file://${page_file}#at=2" style="display:block;width:320px;height:200px;border:0"></iframe>`;
  fs.writeFileSync(file, `<!doctype html><meta charset="utf-8"><div style="height:2000px"></div>${frame}`);
  await tab.goto(`file://${file}`, {timeout: 120000});
  const figure = tab.frames()[1];
  await figure.evaluate(() => {
    const start = Program.start;
    Program.start = async (...given) => {
      await new Promise((resolve) => { window.go_on = resolve; });
      return start(...given);
    };
  });
  await tab.evaluate(() => window.scrollTo(0, 1900));
  await figure.waitForFunction('window.go_on', {timeout: 60000});
  await tab.evaluate(() => window.scrollTo(0, 0));
  await wait(600);
  await figure.evaluate(() => window.go_on());
  await figure.waitForFunction('!document.getElementById("last").hidden && !the_page.figure.program', {timeout: 60000});
  assert.equal(await figure.evaluate(() => the_page.figure.film.at_s), 2);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('forty figures on one page start in sight and rest out of it', async (browser) => {
  const tab = await browser.newPage();
  const faults = faults_of(tab);
  await tab.setViewport({width: 500, height: 420});
  const file = path.join(folder, 'forty.html');
  const frame = `<iframe src="file://${page_file}" style="display:block;width:320px;height:200px;margin:6px;border:0"></iframe>`;
  fs.writeFileSync(file, `<!doctype html><meta charset="utf-8">${frame.repeat(40)}`);
  await tab.goto(`file://${file}`, {timeout: 120000});
  const running = async () => (await Promise.all(tab.frames().slice(1).map((f) =>
    f.evaluate(() => document.body.classList.contains('drawn')).catch(() => false)))).filter(Boolean).length;
  for (const wanted of [0, 20, 39]) {
    await tab.evaluate((y) => window.scrollTo(0, y * 206), wanted);
    const target = tab.frames()[1 + wanted];
    await target.waitForFunction('document.body?.classList.contains("drawn")', {timeout: 60000});
    for (let k = 0; k < 40 && (await running()) > 4; ++k) await wait(300);
    assert.ok((await running()) <= 4, 'figures out of sight rest');
  }
  assert.deepEqual(faults, []);
  await tab.close();
});

check('offers scripts what the guide lists', async (browser) => {
  const {tab, faults} = await opened(browser);
  const types = await tab.evaluate(async () => {
    const p = window.poinsot;
    await p.ready;
    return Object.fromEntries(['at', 'seek', 'play', 'pause', 'next', 'previous', 'set', 'view', 'png', 'svg', 'time_s', 'first_time_s', 'last_time_s']
      .map((name) => [name, typeof p[name]]));
  });
  for (const name of ['at', 'seek', 'play', 'pause', 'next', 'previous', 'set', 'view', 'png', 'svg']) assert.equal(types[name], 'function', name);
  for (const name of ['time_s', 'first_time_s', 'last_time_s']) assert.equal(types[name], 'number', name);
  const state = await tab.evaluate(() => window.poinsot.at(1e6));
  assert.equal(state.time_s, 1e6);
  assert.equal(state.omega_body.length, 3);
  assert.equal(state.space_from_body.length, 4);
  const norm = Math.hypot(...state.space_from_body);
  assert.ok(Math.abs(norm - 1) < 1e-14);
  const png = await tab.evaluate(async () => {
    const blob = await window.poinsot.png(321, 123);
    const bytes = new DataView(await blob.arrayBuffer());
    return [blob.type, bytes.getUint32(16), bytes.getUint32(20)];
  });
  assert.deepEqual(png, ['image/png', 321, 123]);
  const refused = await tab.evaluate(() => Promise.all([[-5, 5], [0, 90], [1.5, 90], [16385, 16], ['wide', 90]].map((size) =>
    window.poinsot.png(...size).then(() => 'a picture', (error) => error.message))));
  for (const message of refused) assert.match(message, /^a picture of .* pixels: give two whole numbers from 1 to 16384$/);
  await tab.evaluate(() => window.poinsot.play());
  await until(tab, 'window.poinsot.time_s > 0.1');
  await tab.evaluate(() => window.poinsot.pause());
  assert.deepEqual(faults, []);
  await tab.close();
});

check('counts seconds of the film and of the motion', async (browser) => {
  const slow = fs.readFileSync(lecture, 'utf8').replace('length_s = 10', 'length_s = 10\nstart_s = 3\nspeed = 0.5');
  const {tab, faults} = await opened_file(browser, page_of(program, scene_file('slow', slow), path.join(folder, 'slow.html')));
  await ready(tab);
  const after = (code) => tab.evaluate(`${code}; [poinsot.film_s, poinsot.time_s, poinsot.stop]`);
  assert.deepEqual(await after('poinsot.seek_film(4)'), [4, 5, 0]);
  assert.deepEqual(await after('poinsot.seek(5.5)'), [5, 5.5, 0]);
  assert.deepEqual(await after('poinsot.seek_film(1e6)'), [10, 8, 0]);
  assert.deepEqual(await after('poinsot.seek_stop(1)'), [2, 4, 1]);
  assert.deepEqual(await after('poinsot.seek_stop(2); poinsot.pause()'), [6, 6, 2]);
  // The last frame is a twentieth of a second of film before the end.
  assert.deepEqual(await tab.evaluate('[poinsot.time_at(4), poinsot.film_at(5), poinsot.film_length_s, poinsot.first_time_s, poinsot.last_time_s]'), [5, 4, 10, 3, 7.975]);
  assert.deepEqual((await tab.evaluate('poinsot.stops')).map((stop) => [stop.film_s, stop.time_s, stop.title, stop.loop_s]),
    [[2, 4, 'Which axis is unstable?', null], [6, 6, 'Look at the herpolhode', 1]]);
  const refusal = (code) => tab.evaluate(`(() => { try { ${code}; return ''; } catch (error) { return error.message; } })()`);
  assert.equal(await refusal('poinsot.seek_stop(3)'), 'poinsot.seek_stop(3): give a number from 1 to 2');
  assert.equal(await refusal('poinsot.seek_film()'), 'poinsot.seek_film(undefined): give a second of the film as a number');
  assert.equal(await refusal('poinsot.seek("2")'), 'poinsot.seek(2): give a second of the motion as a number');
  assert.deepEqual(faults, []);
  await tab.close();
});

check('prints the poster', async (browser) => {
  if (is_firefox) return; // puppeteer cannot make it print to the page
  const {tab, faults} = await opened(browser);
  await ready(tab);
  await tab.emulateMediaType('print');
  const seen = await tab.evaluate(() => ['#poster', '#bar', 'canvas', '#options'].map((s) => {
    const style = getComputedStyle(document.querySelector(s));
    return style.display !== 'none' && style.visibility === 'visible';
  }));
  assert.deepEqual(seen, [true, false, false, false]);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('the notes have a window of their own', async (browser) => {
  const {tab, faults} = await opened(browser);
  await ready(tab);
  await press(tab, 'PageDown');
  const opening = new Promise((resolve) => browser.once('targetcreated', resolve));
  await press(tab, 'n');
  const target = await opening;
  const notes = await target.page();
  await wait(300);
  assert.match(await tab.evaluate(() => location.href), /html/);
  if (notes) assert.match(await notes.evaluate(() => document.body.textContent), /:/);
  await press(tab, 'n');
  assert.deepEqual(faults, []);
  await tab.close();
});

check('the notes say what is planned, and show the next stop', async (browser) => {
  const {tab, faults} = await opened(browser);
  await ready(tab);
  await press(tab, 'n');
  const said = (name) => tab.evaluate((name) => the_page.notes.page.querySelector(`.notes-${name}`).textContent, name);
  await wait(1300);
  // The lecture has not begun.
  assert.match(await said('clock'), /Elapsed 0:00 · Planned 1:30 · film 0:00 \/ 0:10$/);
  assert.equal(await said('next'), 'Next: Which axis is unstable?');
  await tab.evaluate(() => poinsot.seek_stop(1));
  await until(tab, 'the_page.notes.page.querySelector(".notes-next").textContent === "Next: 2:30 · Look at the herpolhode"');
  assert.equal(await said('where'), '1 / 2 · Which axis is unstable?');
  await until(tab, '/Elapsed 0:0[1-9] · Planned 1:30/.test(the_page.notes.page.querySelector(".notes-clock").textContent)');
  // The small picture is that of the next stop, and not that of this one.
  const different = await tab.evaluate(async () => {
    const small = the_page.notes.page.querySelector('.notes-picture');
    const {width, height} = small;
    const shown = small.getContext('2d').getImageData(0, 0, width, height).data;
    const shares = [];
    for (const stop of [2, 1]) {
      poinsot.pause();
      poinsot.seek_stop(stop);
      poinsot.pause();
      const bitmap = await createImageBitmap(await poinsot.png(width, height));
      const context = new OffscreenCanvas(width, height).getContext('2d');
      context.drawImage(bitmap, 0, 0);
      const {data} = context.getImageData(0, 0, width, height);
      let n = 0;
      for (let k = 0; k < data.length; k += 4) n += Number([0, 1, 2].some((c) => Math.abs(data[k + c] - shown[k + c]) > 8));
      shares.push(n / (width * height));
    }
    return {width, height, shares};
  });
  assert.deepEqual([different.width, different.height], [480, 270]);
  assert.ok(different.shares[0] < 1e-3 && different.shares[1] > 1e-2, `${different.shares}`);
  await press(tab, 'n');
  assert.deepEqual(faults, []);
  await tab.close();
});

check('speaks the language of its scene', async (browser) => {
  const {tab, faults} = await opened_file(browser, page_of(program, lecture, path.join(folder, 'german.html'), ['--set', 'language=de']), {size: {width: 1280, height: 720}});
  await ready(tab);
  assert.equal(await tab.$eval('html', (root) => root.lang), 'de');
  await press(tab, 'o');
  assert.equal(await tab.$eval('#show-options', (b) => b.getAttribute('aria-label')), 'Einstellungen');
  assert.match(await tab.$eval('#controls legend', (l) => l.textContent), /^Winkelgeschwindigkeit ω.* \/ rad\/s$/);
  assert.match(await tab.$eval('#elements', (e) => e.textContent), /Hauptachsen/);
  assert.match(await tab.$eval('#time', (t) => t.textContent), /,/);
  await until(tab, 'document.getElementById("state").textContent.includes("Winkelgeschwindigkeit")');
  assert.deepEqual(faults, []);
  await tab.close();
});

check('begins with the colours of the system where the scene chooses none', async (browser) => {
  if (is_firefox) return; // puppeteer cannot set its colours
  const dark = async (file, fragment = '') => {
    const tab = await browser.newPage();
    await tab.emulateMediaFeatures([{name: 'prefers-color-scheme', value: 'dark'}]);
    await tab.goto(`file://${file}${fragment}`);
    await ready(tab);
    return tab;
  };
  const is_dark = (tab) => tab.$eval('html', (root) => root.classList.contains('dark'));
  const tab = await dark(page_file);
  assert.equal(await is_dark(tab), true);
  await press(tab, 'ArrowRight');
  await until(tab, 'location.hash.includes("at=")');
  assert.doesNotMatch(await tab.evaluate(() => location.hash), /theme/, 'a link does not carry what nobody chose');
  await press(tab, 't');
  await until(tab, 'location.hash.includes("theme=light")');
  assert.equal(await is_dark(tab), false);
  await tab.reload();
  await ready(tab);
  assert.equal(await is_dark(tab), false);
  await tab.close();
  const scene = scene_file('own', fs.readFileSync(lecture, 'utf8').replace('caption', 'theme = "light"\ncaption'));
  const own = await dark(page_of(program, scene, `${scene}.html`));
  assert.equal(await is_dark(own), false);
  await own.close();
});

check('shows the focus, and says each change once it is over', async (browser) => {
  const {tab, faults} = await opened(browser, {size: {width: 1280, height: 720}});
  await ready(tab);
  await press(tab, 'o');
  await wait(200);
  const seen = new Set();
  for (let k = 0; k < 100; ++k) {
    await tab.keyboard.press('Tab');
    const at = await tab.evaluate(() => {
      const element = document.activeElement;
      if (!element || element === document.body) return null;
      const name = element.getAttribute('aria-label') || element.textContent.trim() || element.labels?.[0]?.textContent.trim() || '';
      const ringed = element.matches('.segments input') ? element.nextElementSibling : element;
      return {name, id: element.id || element.className || element.name || element.type, ring: getComputedStyle(ringed).outlineStyle !== 'none' && parseFloat(getComputedStyle(ringed).outlineWidth) >= 2};
    });
    if (seen.has('copy-link') && (!at || at.id === 'view')) break; // once round
    if (!at) continue;
    assert.ok(at.name.length > 0, `${at.id} has a name`);
    assert.ok(at.ring, `the focus on ${at.id} is seen`);
    seen.add(at.id);
  }
  for (const id of ['view', 'play', 'scrub', 'speed', 'show-options', 'close', 'save-png', 'copy-link']) assert.ok(seen.has(id), `Tab reaches ${id}`);
  const said = await tab.$eval('#state', (state) => state.textContent);
  await tab.focus('#play');
  await press(tab, 'ArrowRight');
  await until(tab, `document.getElementById("state").textContent !== ${JSON.stringify(said)}`);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('is accessible by the rules of axe', async (browser) => {
  const {tab} = await opened(browser, {size: {width: 1280, height: 720}});
  await ready(tab);
  for (const theme of ['light', 'dark']) {
    await press(tab, 'o');
    await wait(300);
    assert.deepEqual(await violations(tab), [], theme);
    await press(tab, 'Escape');
    await press(tab, 't');
    await wait(500);
  }
  await tab.close();
});
