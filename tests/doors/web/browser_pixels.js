// node browser_pixels.js BROWSER POINSOT MODULE FONTS PROGRAM_JS SCENES_FOLDER OUT_FOLDER SIZE [SCENE…]: draws scenes
// with the page's module in a browser (firefox, which needs a display, or chromium) and compares the pixels with a portable frame of
// the film. Fails where more differs than `limits` allow.
'use strict';
const {execFileSync, spawn} = require('node:child_process');
const test = require('node:test');
const assert = require('node:assert/strict');
const fs = require('node:fs');
const http = require('node:http');
const os = require('node:os');
const path = require('node:path');
const zlib = require('node:zlib');
const {files_of} = require('./scene_files.js');

const [browser, poinsot, module_file, fonts_file, program_file, folder, out, size, ...only] = process.argv.slice(2);
const [width, height] = size.split('x').map(Number);
const all = fs.readdirSync(folder).filter((name) => name.endsWith('.toml')).map((name) => name.slice(0, -5));
const scenes = only.length > 0 ? only : all;
fs.mkdirSync(out, {recursive: true});

/** Pixels of a PNG with 8 bits of RGB or RGBA, as RGBA. */
function pixels_of_png(file) {
  const bytes = fs.readFileSync(file);
  const data = [];
  let channels = 3;
  let side = [0, 0];
  for (let at = 8; at < bytes.length;) {
    const n = bytes.readUInt32BE(at);
    const kind = bytes.toString('latin1', at + 4, at + 8);
    const body = bytes.subarray(at + 8, at + 8 + n);
    if (kind === 'IHDR') {
      side = [body.readUInt32BE(0), body.readUInt32BE(4)];
      channels = body[9] === 6 ? 4 : 3;
    }
    if (kind === 'IDAT') data.push(body);
    at += n + 12;
  }
  const raw = zlib.inflateSync(Buffer.concat(data));
  const row = side[0] * channels;
  const rows = Buffer.alloc(row * side[1]);
  for (let y = 0; y < side[1]; ++y) {
    const filter = raw[y * (row + 1)];
    for (let x = 0; x < row; ++x) {
      const left = x >= channels ? rows[y * row + x - channels] : 0;
      const up = y > 0 ? rows[(y - 1) * row + x] : 0;
      const corner = x >= channels && y > 0 ? rows[(y - 1) * row + x - channels] : 0;
      const p = left + up - corner;
      const [a, b, c] = [Math.abs(p - left), Math.abs(p - up), Math.abs(p - corner)];
      const guess = [0, left, up, (left + up) >> 1, a <= b && a <= c ? left : b <= c ? up : corner][filter];
      rows[y * row + x] = raw[y * (row + 1) + 1 + x] + guess;
    }
  }
  const rgba = Buffer.alloc(4 * side[0] * side[1], 255);
  for (let k = 0; k < side[0] * side[1]; ++k) rows.copy(rgba, 4 * k, channels * k, channels * k + channels);
  return rgba;
}

function crc(bytes) {
  let sum = -1;
  for (const byte of bytes) {
    sum ^= byte;
    for (let k = 0; k < 8; ++k) sum = (sum >>> 1) ^ (sum & 1 ? 0xedb88320 : 0);
  }
  return ~sum >>> 0;
}

function write_png(file, rgba) {
  const rows = Buffer.alloc((4 * width + 1) * height);
  for (let y = 0; y < height; ++y) Buffer.from(rgba.buffer, rgba.byteOffset + 4 * width * y, 4 * width).copy(rows, (4 * width + 1) * y + 1);
  const chunk = (kind, body) => {
    const whole = Buffer.concat([Buffer.from(kind, 'latin1'), body]);
    const ends = Buffer.alloc(8);
    ends.writeUInt32BE(body.length, 0);
    ends.writeUInt32BE(crc(whole), 4);
    return Buffer.concat([ends.subarray(0, 4), whole, ends.subarray(4)]);
  };
  const head = Buffer.alloc(13);
  head.writeUInt32BE(width, 0);
  head.writeUInt32BE(height, 4);
  head[8] = 8;
  head[9] = 6;
  fs.writeFileSync(file, Buffer.concat([Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]), chunk('IHDR', head),
                                        chunk('IDAT', zlib.deflateSync(rows, {level: 1})), chunk('IEND', Buffer.alloc(0))]));
}

const page = `<!doctype html><meta charset="utf-8"><canvas id="c" width="${width}" height="${height}"></canvas><script type="module">
import {Program} from '/program.js';
const bytes = async (name) => new Uint8Array(await (await fetch(name)).arrayBuffer());
const say = (of, body) => fetch('/' + of, {method: 'POST', body});
(async () => {
  try {
    let began = performance.now();
    const [module, fonts] = [await bytes('/module'), await bytes('/fonts')];
    const canvas = document.getElementById('c');
    let program = await Program.start(module, fonts, canvas);
    const gl = program.gl;
    const start_ms = performance.now() - began;
    for (const {name, files} of await (await fetch('/list')).json()) {
      try {
        const text = await (await fetch('/scene/' + name)).text();
        for (const file of files) program.addFile(file, await bytes('/file/' + encodeURIComponent(file)));
        began = performance.now();
        const loaded = program.load(text, name + '.toml', [], {width: ${width}, height: ${height}});
        const n_frames = Math.max(1, Math.round(loaded.film_length_s * loaded.frames_per_s));
        const film_s = loaded.loops ? loaded.film_length_s * (40 / n_frames) : 40 / loaded.frames_per_s;
        const time_s = program.timeAt(film_s);
        const load_ms = performance.now() - began;
        const one = new Uint8Array(4);
        const ms = [];
        for (let k = 0; k < 2; ++k) {
          began = performance.now();
          program.draw(time_s, film_s);
          gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, one);
          ms.push(performance.now() - began);
        }
        began = performance.now();
        for (let k = 0; k < 5; ++k) program.prepare(time_s);
        ms.push((performance.now() - began) / 5);
        const pixels = program.pixels(time_s, ${width}, ${height}, film_s);
        const error = gl.getError();
        await say('pixels/' + name + '/' + [start_ms, load_ms, ...ms].map((v) => v.toFixed(1)).join(',') + '/' + error + '/' + (program.has_integer_light ? 'int' : 'half'), pixels);
      } catch (error) {
        await say('failed/' + name, String(error.stack || error.message || error) + ' ' + JSON.stringify(error));
      }
    }
  } catch (error) {
    await say('failed/all', String(error.stack || error));
  }
  await say('done', '');
})();
</script>`;

/** The share of the pixels that may differ by more than one level. */
const limits = {with_mesh: 0.001};
/** Scenes in which more differs than may, and the share that was measured; they do not fail the test unless it grows. */
const known_faults = {
  generic: 1e-5, heavy_top_cusp: 1e-5, heavy_top_looping: 1e-5, loop_generic: 1e-5, momentum_sphere: 1e-5, tensor: 1e-5, torque_axis: 2e-5,
  euler_angles: 5e-5, heavy_top_conserved: 2e-5, heavy_top_sleeping: 5e-5, heavy_top_steady: 4e-5, heavy_top_wavy: 3e-5, symmetric_prolate: 3e-5,
  inertia_ellipsoid: 1e-4, rolling: 3e-5, sphere: 4e-5,  // where an arrow or a curve meets an outline
  feynman_plate: 2e-4, football: 1e-3, inertial_forces: 1e-3, measured: 2e-3,
  contact_matter: 6e-3,  // the figure is 0.02 % larger, so that its edges lie up to 0.05 px elsewhere
  point_masses: 4e-3,
  racket_thrown: 5e-3,  // strings thinner than a pixel
};

const frame = 40;

/** What came of each scene. @type {{name: string, fails: boolean, text: string}[]} */
const outcomes = [];
const list = scenes.map((name) => {
  const text = fs.readFileSync(path.join(folder, `${name}.toml`), 'utf8');
  execFileSync(poinsot, ['render', path.join(folder, `${name}.toml`), '-q', '--portable', '--size', size, '--frames', `${frame}-${frame}`,
                         '-o', path.join(out, `${name}.native_####.png`)]);
  return {name, files: files_of(text), has_mesh: /\[object\]|"body"/.test(text)};
});

const server = http.createServer((request, response) => {
  const [, kind, name, timing, error, light] = decodeURIComponent(request.url || '').split('/');
  const send = (type, body) => {
    response.setHeader('Content-Type', type);
    response.end(body);
  };
  if (request.method === 'GET') {
    if (kind === '') return send('text/html', page);
    if (kind === 'program.js') return send('text/javascript', fs.readFileSync(program_file));
    if (kind === 'module') return send('application/octet-stream', fs.readFileSync(module_file));
    if (kind === 'fonts') return send('application/octet-stream', fs.readFileSync(fonts_file));
    if (kind === 'list') return send('application/json', JSON.stringify(list));
    if (kind === 'file') return send('application/octet-stream', fs.readFileSync(path.join(folder, decodeURIComponent(request.url.slice('/file/'.length)))));
    if (kind === 'scene') return send('text/plain', fs.readFileSync(path.join(folder, `${name}.toml`)));
    response.statusCode = 404;
    return response.end();
  }
  const parts = [];
  request.on('data', (part) => parts.push(part));
  request.on('end', () => {
    response.end();
    const body = Buffer.concat(parts);
    if (kind === 'done') return end();
    if (kind === 'failed') return outcomes.push({name, fails: true, text: body.toString()});
    const native = pixels_of_png(path.join(out, `${name}.native_0040.png`));
    write_png(path.join(out, `${name}.page.png`), body);
    let n_differ = 0;
    let n_more = 0;
    let most = 0;
    for (let k = 0; k < native.length; k += 4) {
      let by = 0;
      for (let c = 0; c < 4; ++c) by = Math.max(by, Math.abs(native[k + c] - body[k + c]));
      n_differ += by > 0 ? 1 : 0;
      n_more += by > 1 ? 1 : 0;
      most = Math.max(most, by);
    }
    const share = (n) => `${(100 * n / (native.length / 4)).toFixed(3)} %`;
    const more = n_more / (native.length / 4);
    const is_over = more > (list.find((each) => each.name === name).has_mesh ? limits.with_mesh : 0);
    const fails = (is_over && more > (known_faults[name] ?? 0)) || error !== '0';
    outcomes.push({name, fails, text: `${is_over && !fails ? 'known: ' : ''}${share(n_differ)} differ, ${share(n_more)} by more than 1, most ${most}; start, load, first, next, module ms ${timing}; gl ${error} ${light}`});
  });
});

let child = null;
let profile = '';
/** @type {(value?: any) => void} */
let have_ended = () => {};
const ended = new Promise((resolve) => { have_ended = resolve; });
function end() {
  server.close();
  server.closeAllConnections();
  if (child) process.kill(-child.pid);
  if (profile) setTimeout(() => fs.rmSync(profile, {recursive: true, force: true}), 1000);
  have_ended();
}

server.listen(0, '127.0.0.1', () => {
  const url = `http://127.0.0.1:${server.address().port}/`;
  profile = fs.mkdtempSync(path.join(os.tmpdir(), 'page-pixels-'));
  const options = {detached: true, stdio: 'ignore'};
  if (browser === 'firefox') {
    fs.writeFileSync(path.join(profile, 'user.js'), 'user_pref("webgl.force-enabled", true);\nuser_pref("browser.shell.checkDefaultBrowser", false);\nuser_pref("datareporting.policy.dataSubmissionEnabled", false);\n');
    child = spawn('firefox-esr', ['--no-remote', '--profile', profile, url], options);
  } else {
    child = spawn('chromium', ['--headless', '--no-sandbox', '--enable-unsafe-swiftshader', `--user-data-dir=${profile}`, url], options);
  }
  setTimeout(() => {
    outcomes.push({name: 'the browser', fails: true, text: 'it took too long'});
    end();
  }, Number(process.env.POINSOT_BROWSER_LIMIT_MS || 1500000)).unref();
});

test('draws the scenes in a browser as the program does', async (t) => {
  await ended;
  for (const {name, fails, text} of outcomes)
    await t.test(name, (t) => {
      t.diagnostic(text);
      assert.ok(!fails, text);
    });
  assert.ok(outcomes.length >= scenes.length, `${outcomes.length} of ${scenes.length} scenes`);
});
