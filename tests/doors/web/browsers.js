// Browsers for the tests of the page: opens a page, and collects what goes wrong in it. POINSOT_BROWSER=firefox takes
// Firefox in place of Chromium; it needs a display, as xvfb-run gives one.
'use strict';
const assert = require('node:assert/strict');
const {spawnSync} = require('node:child_process');
const fs = require('node:fs');
const test = require('node:test');
const puppeteer = require('puppeteer-core');

const axe = fs.readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8');

const wait = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

const is_firefox = process.env['POINSOT_BROWSER'] === 'firefox';

async function launched() {
  const files = is_firefox ? ['/usr/bin/firefox-esr', '/usr/bin/firefox'] : ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'];
  const file = files.find((name) => fs.existsSync(name));
  if (!file) throw new Error(`there is no ${is_firefox ? 'Firefox' : 'Chromium'}`);
  // Firefox has WebGL only with a display, and by Mesa's software renderer only if it is told so.
  if (is_firefox)
    return puppeteer.launch({browser: 'firefox', executablePath: file, headless: false, extraPrefsFirefox: {'webgl.force-enabled': true}});
  // The sound server's library would leave a folder behind.
  return puppeteer.launch({executablePath: file, headless: true,
    args: ['--no-sandbox', '--disable-audio-output', '--enable-unsafe-swiftshader', '--allow-file-access-from-files']});
}

/** Runs a program that writes a page or the workbench. @param {string} program @param {string[]} options */
function write_page(program, options) {
  const outcome = spawnSync(program, options, {encoding: 'utf8'});
  assert.equal(outcome.status, 0, outcome.stderr);
}

/** Writes the page of a scene. @param {string} program @param {string} scene @param {string} file @param {string[]} [options] */
function page_of(program, scene, file, options = []) {
  write_page(program, ['render', scene, '-o', file, '--quiet', ...options]);
  return file;
}

/** Collects the errors of a tab, its messages and its requests. @returns {string[]} */
function faults_of(tab) {
  const faults = [];
  // Chromium says itself when its software renderer waits.
  tab.on('console', (message) => message.text().includes('GL Driver Message') || faults.push(`console: ${message.text()}`));
  tab.on('pageerror', (error) => faults.push(`error: ${error.message}`));
  tab.on('request', (request) => {
    if (!/^(file|data|blob|about):/.test(request.url())) faults.push(`request: ${request.url()}`);
  });
  return faults;
}

/** Opens a file; `faults` are those of its tab. */
async function opened_file(browser, file, {fragment = '', size = {width: 640, height: 400}, before = null} = {}) {
  const tab = await browser.newPage();
  const faults = faults_of(tab);
  // Counts the frames asked for, as a measure of work.
  await tab.evaluateOnNewDocument(() => {
    window.n_frames = 0;
    const ask = window.requestAnimationFrame.bind(window);
    window.requestAnimationFrame = (action) => {
      ++window.n_frames;
      return ask(action);
    };
  });
  if (before) await tab.evaluateOnNewDocument(before);
  await tab.setViewport(size);
  await tab.goto(`file://${file}${fragment}`, {timeout: 120000});
  return {tab, faults};
}

/** What breaks the rules of axe. @returns {Promise<string[]>} */
async function violations(tab) {
  await tab.evaluate(axe);
  return tab.evaluate(() => window.axe.run(document, {runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice']})
    .then((r) => r.violations.map((v) => `${v.id}: ${v.nodes.map((n) => n.target).join(' ')}`)));
}

const ready = (tab) => tab.evaluate(() => window.poinsot.ready);

/** Waits until code of the tab is true. */
const until = (tab, code, ms = 60000) => tab.waitForFunction(code, {timeout: ms});

/** Waits until the picture fits the window and no frame is asked for. */
const settled = (tab) => until(tab, `(() => {
  const {figure} = the_page;
  const {width, height} = figure.size();
  return figure.frame === 0 && !figure.is_resized && figure.canvas.width === width && figure.canvas.height === height;
})()`, 60000);

/** Presses a key, and lets the page draw. */
async function press(tab, key) {
  await tab.keyboard.press(key);
  await wait(60);
}

/** The text that a button saves. @returns {Promise<string>} */
const saved_by = (tab, button) => tab.evaluate((button) => new Promise((resolve) => {
  const url = URL.createObjectURL;
  URL.createObjectURL = (blob) => {
    void blob.text().then(resolve);
    return url(blob);
  };
  HTMLAnchorElement.prototype.click = () => {};
  document.getElementById(button).click();
}), button);

/** Drops files into the page, of texts or bytes. */
const drop = (tab, files) => tab.evaluate((files) => {
  const transfer = new DataTransfer();
  for (const [name, base64] of files) transfer.items.add(new File([bytes_of_base64(base64)], name));
  document.dispatchEvent(new DragEvent('drop', {dataTransfer: transfer, cancelable: true}));
}, files.map(([name, content]) => [name, Buffer.from(content).toString('base64')]));

/** The text in the workbench. @returns {Promise<string>} */
const scene_text = (tab) => tab.evaluate(() => the_workbench.editor.text);

/** Replaces the text in the workbench, as typing does. */
const write_scene = (tab, text) => tab.evaluate((text) => {
  const {view, field} = the_workbench.editor;
  if (view) view.dispatch({changes: {from: 0, to: view.state.doc.length, insert: text}});
  else {
    field.value = text;
    field.dispatchEvent(new Event('input'));
  }
}, text);

/**
 * Registers tests of Node's runner that get a browser: `check(name, action)`. All of a file share one browser, which ends with the last of them.
 * @param {string[]} only parts of names; tests whose names have none of them are left out
 */
function browser_checks(only = []) {
  /** @type {Promise<any>|null} */
  let browser = null;
  let n_left = 0;
  /** @type {string[]} */
  const names = [];
  // After the file has registered all of its tests.
  setImmediate(() => {
    for (const word of only) if (!names.some((name) => name.includes(word))) test(`has a test named "${word}"`, () => assert.fail('none has this word in its name'));
  });
  return (/** @type {string} */ name, /** @type {(browser: any) => Promise<void>|void} */ action) => {
    names.push(name);
    if (only.length > 0 && !only.some((word) => name.includes(word))) return;
    ++n_left;
    test(name, async () => {
      try {
        await action(await (browser ??= launched()));
      } finally {
        if (--n_left === 0) await browser?.then((open) => open.close(), () => {});
      }
    });
  };
}

module.exports = {browser_checks, drop, faults_of, is_firefox, launched, opened_file, page_of, press, ready, saved_by, scene_text, settled, until, violations, wait, write_page, write_scene};
