// The site, opened from its folder and from a server, in Chromium or Firefox: a picture of the gallery opens its scene in the
// workbench, and nothing is asked for elsewhere. Usage: node site_test.js MAKE_SITE SOURCE MAKE_WORKBENCH SCENES
'use strict';
const assert = require('node:assert/strict');
const {spawnSync} = require('node:child_process');
const fs = require('node:fs');
const http = require('node:http');
const os = require('node:os');
const path = require('node:path');
const {browser_checks, faults_of, ready, scene_text, until, write_page} = require('./browsers.js');

const [make_site, source, make_workbench, scenes] = process.argv.slice(2);
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'poinsot-site-'));
process.on('exit', () => fs.rmSync(folder, {recursive: true, force: true}));
const site = path.join(folder, 'site');
const workbench = path.join(folder, 'poinsot.html');
write_page(make_workbench, [workbench, path.join(scenes, 'scene.schema.json'),
  ...['generic', 'tennis_racket', 'heavy_top_looping'].map((name) => path.join(scenes, `${name}.toml`))]);
const made = spawnSync('/usr/bin/python3', [make_site, source, workbench, site], {encoding: 'utf8'});
assert.equal(made.status, 0, made.stderr);

const types = {'.html': 'text/html', '.css': 'text/css', '.png': 'image/png', '.svg': 'image/svg+xml', '.gif': 'image/gif'};

/** @returns {Promise<http.Server>} */
const serve = () => new Promise((resolve) => {
  const server = http.createServer((request, answer) => {
    const file = path.join(site, decodeURIComponent(new URL(request.url ?? '/', 'http://site').pathname));
    if (!fs.existsSync(file)) {
      answer.writeHead(404).end();
      return;
    }
    answer.writeHead(200, {'content-type': types[path.extname(file)] ?? 'text/plain'}).end(fs.readFileSync(file));
  });
  server.listen(0, '127.0.0.1', () => resolve(server));
});

/** From the first page over the gallery to a scene in the workbench. */
async function walk(browser, start) {
  const tab = await browser.newPage();
  const faults = faults_of(tab);
  const answers = [];
  tab.on('response', (response) => response.status() < 400 || answers.push(`${response.status()} ${response.url()}`));
  await tab.setViewport({width: 1100, height: 700});
  await tab.goto(`${start}index.html`);
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

const check = browser_checks();

check('opens from its folder', (browser) => walk(browser, `file://${site}/`));

check('opens from a server', async (browser) => {
  const server = await serve();
  await walk(browser, `http://127.0.0.1:${/** @type {import('node:net').AddressInfo} */ (server.address()).port}/`);
  server.closeAllConnections();
  server.close();
});
