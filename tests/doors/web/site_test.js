// The site, opened from its folder and from a server, in Chromium or Firefox: a picture of the gallery opens its scene in the
// workbench, and nothing is asked for elsewhere. Usage: node site_test.js MAKE_SITE SOURCE MAKE_WORKBENCH SCENES [NAME…]
'use strict';
const assert = require('node:assert/strict');
const {spawnSync} = require('node:child_process');
const fs = require('node:fs');
const http = require('node:http');
const os = require('node:os');
const path = require('node:path');
const {browser_checks, faults_of, ready, scene_text, until, violations, write_page} = require('./browsers.js');

const [make_site, source, make_workbench, scenes, ...only] = process.argv.slice(2);
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'poinsot-site-'));
process.on('exit', () => fs.rmSync(folder, {recursive: true, force: true}));
const site = path.join(folder, 'site');
const workbench = process.env['POINSOT_WORKBENCH'] ?? path.join(folder, 'poinsot.html');
if (!process.env['POINSOT_WORKBENCH']) write_page(make_workbench, [workbench, path.join(scenes, 'scene.schema.json'),
  ...['generic', 'tennis_racket', 'heavy_top_looping'].map((name) => path.join(scenes, `${name}.toml`))]);
const made = spawnSync('/usr/bin/python3', [make_site, source, workbench, site], {encoding: 'utf8'});
assert.equal(made.status, 0, made.stderr);

const types = {'.js': 'text/javascript', '.webmanifest': 'application/manifest+json', '.html': 'text/html', '.css': 'text/css', '.png': 'image/png', '.svg': 'image/svg+xml', '.gif': 'image/gif'};

/** @returns {Promise<http.Server>} */
const serve = () => new Promise((resolve) => {
  const server = http.createServer((request, answer) => {
    const named = path.join(site, decodeURIComponent(new URL(request.url ?? '/', 'http://site').pathname));
    const file = named.endsWith('/') ? `${named}index.html` : named;
    if (!fs.existsSync(file)) {
      answer.writeHead(404).end();
      return;
    }
    answer.writeHead(200, {'content-type': types[path.extname(file)] ?? 'text/plain'}).end(fs.readFileSync(file));
  });
  server.listen(0, '127.0.0.1', () => resolve(server));
});

/** The live construction of the first page runs. */
async function figure_runs(tab) {
  const frame = await (await tab.$('iframe')).contentFrame();
  await frame.waitForFunction('window.poinsot && document.body.classList.contains("drawn")', {timeout: 60000});
  assert.ok(Math.hypot(...(await frame.evaluate(() => window.poinsot.at(1).omega_body))) > 0);
}

/** From the first page over the gallery to a scene in the workbench. */
async function walk(browser, start) {
  const tab = await browser.newPage();
  const faults = faults_of(tab);
  const answers = [];
  tab.on('response', (response) => response.status() < 400 || answers.push(`${response.status()} ${response.url()}`));
  await tab.setViewport({width: 1100, height: 700});
  await tab.goto(`${start}index.html`);
  await figure_runs(tab);
  await Promise.all([tab.waitForNavigation(), tab.click('nav a[href="docs/gallery.html"]')]);
  assert.ok(await tab.$$eval('img', (all) => all.length) > 40);
  await Promise.all([tab.waitForNavigation(), tab.click('a[href="../poinsot.html#scene=heavy_top_looping"]')]);
  await ready(tab);
  assert.match(await scene_text(tab), /^\[body\]/m);
  assert.match(await scene_text(tab), /theta_rad/);
  const omega3 = Number(/omega3_rad_s = ([\d.]+)/.exec(await scene_text(tab))[1]);
  await until(tab, `window.poinsot.at(0).omega_body[2] === ${omega3}`);
  assert.deepEqual(answers, []);
  const own = `request: ${start}`;
  assert.deepEqual(faults.filter((fault) => !fault.startsWith(own) && !fault.endsWith('/favicon.ico')), []);
  await tab.close();
}

const check = browser_checks(only);

check('opens from its folder', (browser) => walk(browser, `file://${site}/`));

check('opens from a server', async (browser) => {
  const server = await serve();
  await walk(browser, `http://127.0.0.1:${/** @type {import('node:net').AddressInfo} */ (server.address()).port}/`);
  server.closeAllConnections();
  server.close();
});

check('begins with the figure and three ways on, on a desk and on a phone', async (browser) => {
  for (const [width, height] of [[1280, 800], [390, 844], [320, 568]]) {
    const tab = await browser.newPage();
    await tab.setViewport({width, height});
    await tab.goto(`file://${site}/index.html`);
    await figure_runs(tab);
    const seen = await tab.evaluate(() => ({
      figure: document.querySelector('iframe').getBoundingClientRect().toJSON(), wide: document.documentElement.scrollWidth,
      cards: new Set([...document.querySelectorAll('.cards li')].map((card) => Math.round(card.getBoundingClientRect().left))).size,
      lowest: Math.max(...[...document.querySelectorAll('.buttons a')].map((button) => button.getBoundingClientRect().bottom)),
      buttons: [...document.querySelectorAll('.buttons a')].map((button) => button.getAttribute('href')),
    }));
    assert.ok(seen.figure.width > 0.5 * Math.min(width, 1088) && seen.figure.height >= 0.4 * height && seen.figure.top < 0.5 * height, JSON.stringify(seen));
    assert.ok(height < 800 || seen.lowest <= height, `the last button ends at ${seen.lowest} of ${height}`);
    assert.ok(seen.wide <= width, `${seen.wide} of ${width}`);
    assert.ok(width > 700 ? seen.cards > 2 : seen.cards === 1, `${seen.cards} cards a row`);
    assert.deepEqual(seen.buttons, ['poinsot.html', 'poinsot.html#measure', 'poinsot.html#scene=lecture']);
    assert.deepEqual(await violations(tab), []);
    await Promise.all([tab.waitForNavigation(), tab.click('.buttons a[href$="#measure"]')]);
    await ready(tab);
    assert.ok(await tab.$eval('#measure', (part) => part.checkVisibility()));
    await tab.close();
  }
});

check('works without a network after the first visit', async (browser) => {
  const server = await serve();
  const start = `http://127.0.0.1:${/** @type {import('node:net').AddressInfo} */ (server.address()).port}/`;
  const tab = await browser.newPage();
  const faults = [];
  tab.on('pageerror', (error) => faults.push(error.message));
  await tab.goto(`${start}index.html`);
  await tab.evaluate(() => navigator.serviceWorker.ready.then(() => navigator.serviceWorker.controller ?? new Promise((resolve) => {
    navigator.serviceWorker.addEventListener('controllerchange', resolve);
  })).then(() => {}));
  // A phone can put it on its home screen.
  const manifest = await tab.evaluate(async () => (await fetch(document.querySelector('link[rel=manifest]').href)).json());
  assert.equal(manifest.start_url, 'poinsot.html');
  assert.equal(manifest.display, 'standalone');
  server.closeAllConnections();
  await new Promise((resolve) => server.close(resolve));
  await tab.reload();
  await figure_runs(tab);
  await Promise.all([tab.waitForNavigation(), tab.click('.buttons a')]);
  await ready(tab);
  assert.match(await scene_text(tab), /moments_kg_m2/);
  assert.deepEqual(faults, []);
  await tab.close();
});
