// Films made in a page, beside those of `poinsot render`: frames, times, colours, and the record in them.
// Usage: node make_film_test.js POINSOT MAKE_WORKBENCH [NAME…]
'use strict';
const assert = require('node:assert/strict');
const crypto = require('node:crypto');
const fs = require('node:fs');
const path = require('node:path');
const {browser_checks, is_firefox, opened_file, page_of, ready, scene_text, until, write_page, write_scene} = require('./browsers.js');
const {assert_avc_record, assert_film, assert_same_frames, film_file, folder, made, native_frames_of, poinsot, probed, psnr, rgb_of, run, said, size, spoiled, verified} =
  require('./film_checks.js');

const [program, make_workbench, ...only] = process.argv.slice(2);

const check = browser_checks(only);

const made_file = `file://${path.join(__dirname, '../../../src/doors/web/page/made_file.js')}`;
const small = {width: 160, height: 90};
const scene = path.join(folder, 'short.toml');
// generic.toml for two seconds, with a stop between, and a name that fades in.
const generic = fs.readFileSync(path.join(__dirname, '../../../scenes/generic.toml'), 'utf8');
fs.writeFileSync(scene, generic.replace(/duration_s = [\d.]+/, 'duration_s = 2.0').replace(/still_s = [\d.]+\n/, '') +
  '\n[[stops]]\nat_s = 1.0\ntitle = "Half"\n[[fades]]\nat_s = 0.5\nover_s = 0.5\nelements = ["herpolhode"]\n');
const page_file = page_of(program, scene, path.join(folder, 'short.html'));

/** A scene to which the length of the film is added. */
const plain = '[body]\nmoments_kg_m2 = [3, 2, 1.5]\n[start]\nomega_rad_s = [1, 0.5, 0.2]\n[film]\n';

let native_frames = null;
const native = () => (native_frames ??= native_frames_of(scene, 'native'));

async function opened(browser, options = {}) {
  const {tab, faults} = await opened_file(browser, page_file, options);
  await ready(tab);
  return {tab, faults};
}

/** What the file says of itself, and that it can be drawn again. */
function assert_record(file, frames) {
  const record = JSON.parse(poinsot('explain', file, '--json'));
  assert.match(record.maker, is_firefox ? /Firefox/ : /Chrome/);
  assert.match(record.renderer, /^WebGL/);
  assert.deepEqual(record.frames, frames);
  assert.deepEqual(record.size, [size.width, size.height]);
  assert.match(poinsot('explain', file), /moments_kg_m2/);
  // The workbench, too, reads its scene.
  const in_page = `import(${JSON.stringify(made_file)}).then(({made_scene}) => console.log(made_scene(new Uint8Array(require("fs").readFileSync(process.argv[1]))).text))`;
  assert.match(String(run(process.execPath, ['-e', in_page, file])), /moments_kg_m2 = .*[^]*\[\[stops\]\]/);
}

check('makes an MP4 film with the frames of the native one', async (browser) => {
  const {tab, faults} = await opened(browser);
  const file = await film_file(tab, 'page.mp4', {kind: 'mp4'});
  assert_film(file, 'h264', 60);
  assert_same_frames(rgb_of(['-i', file]), native());
  assert_record(file, [0, 59]);
  assert.deepEqual(faults, []);
  await tab.close();
  // The record draws the film again natively: the bytes of the native film of the same scene.
  const again = path.join(folder, 'again.mp4');
  poinsot('rerender', file, '-o', again, '--quiet');
  assert_same_frames(rgb_of(['-i', again]), native());
});

check('makes a WebM film', async (browser) => {
  const {tab, faults} = await opened(browser);
  const file = await film_file(tab, 'page.webm', {kind: 'webm'});
  assert_film(file, 'vp9', 60);
  assert_same_frames(rgb_of(['-i', file]), native());
  assert_record(file, [0, 59]);
  assert.deepEqual(faults, []);
  await tab.close();
});

/** Writes the first PNG file with the pixels of the second. */
const swap_pixels = `import struct, sys
def chunks(name):
    data, at = open(name, "rb").read(), 8
    while at < len(data):
        end = at + 12 + struct.unpack(">I", data[at:at + 4])[0]
        yield data[at + 4:at + 8], data[at:end]
        at = end
pixels = b"".join(chunk for kind, chunk in chunks(sys.argv[2]) if kind == b"IDAT")
open(sys.argv[3], "wb").write(open(sys.argv[1], "rb").read(8) + b"".join(pixels if kind == b"IDAT" else chunk for kind, chunk in chunks(sys.argv[1])))`;

check('makes PNG pictures of the frames that lead to a stop', async (browser) => {
  const {tab, faults} = await opened(browser);
  const file = await film_file(tab, 'page.zip', {kind: 'png', span: 'stop 0'});
  run('python3', ['-c', 'import sys, zipfile; z = zipfile.ZipFile(sys.argv[1]); assert z.testzip() is None; z.extractall(sys.argv[2])', file, folder]);
  const names = fs.readdirSync(folder).filter((name) => /^short_\d+\.png$/.test(name)).sort();
  assert.equal(names.length, 31);
  assert.equal(names[30], 'short_0030.png');
  assert_same_frames(rgb_of(['-i', path.join(folder, 'short_%04d.png')]), native());
  assert_record(path.join(folder, names[0]), [0, 30]);
  const last = path.join(folder, names[30]);
  assert.equal(JSON.parse(poinsot('explain', last, '--json')).frame, 30);
  assert.equal(verified(last)[0], 0, verified(last)[1]);
  // Its record beside the pixels of another frame is found out.
  const swapped = path.join(folder, 'swapped.png');
  run('python3', ['-c', swap_pixels, last, path.join(folder, names[0]), swapped]);
  assert.match(verified(swapped)[1], /pixels do not match/);
  assert.deepEqual(faults, []);
  await tab.close();
});

// Chapters that do not begin at the film's beginning, and captions that overlap.
const told = path.join(folder, 'told.toml');
fs.writeFileSync(told, generic.replace(/duration_s = [\d.]+/, 'duration_s = 1.4').replace(/still_s = [\d.]+\n/, '') +
  '\n[[chapters]]\nat_s = 0.0\ntitle = "Beginning"\n[[chapters]]\nat_s = 0.7\ntitle = "Ω é ' + 'long '.repeat(60) + '"\n' +
  '[[captions]]\nat_s = 0.2\nover_s = 0.6\ntext = "$L$ < stays"\n[[captions]]\nat_s = 0.5\nover_s = 0.6\ntext = "Top"\nplace = "top"\n');

const chapters_of = (file) => JSON.parse(run('ffprobe', ['-v', 'error', '-show_chapters', '-of', 'json', file])).chapters
  .map(({start_time, end_time, tags}) => [Number(start_time), Number(end_time), tags.title]);

/** The captions of a film's track as [begin_s, end_s, text]. FFmpeg 5 does not decode them: the boxes of ISO/IEC 14496-30, or texts. */
function captions_of(file) {
  const stream = path.extname(file) === '.mp4' ? '0:1' : '0:s';
  const bytes = run('ffmpeg', ['-v', 'error', '-i', file, '-map', stream, '-c', 'copy', '-f', 'data', '-']);
  const {packets} = JSON.parse(run('ffprobe', ['-v', 'error', '-show_packets', '-select_streams', '1', '-of', 'json', file]));
  const cues = new Map();
  let at = 0;
  for (const {pts_time, duration_time, size} of packets) {
    const sample = bytes.subarray(at, at += Number(size));
    const texts = [];
    if (stream === '0:s') texts.push(sample.toString());
    else for (let box = 0; (box = sample.indexOf('payl', box)) >= 0; box += 4) texts.push(sample.subarray(box + 4, box - 4 + sample.readUInt32BE(box - 4)).toString());
    for (const text of texts) {
      const [begin] = cues.get(text) ?? [Number(pts_time)];
      cues.set(text, [begin, Number(pts_time) + Number(duration_time)]);
    }
  }
  return [...cues].map(([text, [begin, end]]) => [begin, Number(end.toFixed(3)), text]);
}
/** Those of a file of subtitles. */
const cues_of = (file) => fs.readFileSync(file, 'utf8').split('\n\n').slice(2).map((cue) => {
  const [times, ...lines] = cue.trim().split('\n');
  const [begin, end] = times.match(/[\d:.]{12}/g).map((time) => Number(time.slice(6)));
  return [begin, end, lines.join('\n')];
});

for (const kind of ['mp4', 'webm'])
  check(`writes chapters, captions and hashes into ${kind}`, async (browser) => {
    const {tab, faults} = await opened_file(browser, page_of(program, told, path.join(folder, 'told.html')));
    await ready(tab);
    const file = await film_file(tab, `told_page.${kind}`, {kind, ...small});
    const span = await film_file(tab, `told_span.${kind}`, {kind, ...small, span: 'chapter 1'});
    assert.deepEqual(faults, []);
    await tab.close();
    const natively = path.join(folder, `told.${kind}`);
    poinsot('render', told, '-o', natively, '--size', '160x90', '--quiet');
    const chapters = chapters_of(file);
    assert.equal(chapters.length, 2);
    // The box of MP4 holds titles of 255 bytes.
    if (kind === 'mp4') assert.deepEqual(chapters.map(([start, , title]) => [start, title.length > 100]), chapters_of(natively).map(([start, , title]) => [start, title.length > 100]));
    else assert.deepEqual(chapters, chapters_of(natively));
    assert.equal(chapters_of(span).length, 1);
    assert.deepEqual(captions_of(file), cues_of(path.join(folder, kind === 'mp4' ? 'told.vtt' : 'told.webm.vtt')));
    const [status, words] = verified(file);
    assert.equal(status, 0, words);
    assert.match(words, /unchanged, record and pictures/);
    // A byte of the pictures, and one of what stands around them.
    const [no, why] = verified(spoiled(file, (bytes) => Math.floor(0.75 * bytes.length)));
    assert.equal(no, 1);
    assert.match(why, /pictures do not match/);
    assert.match(verified(spoiled(file, (bytes) => bytes.lastIndexOf('Beginning')))[1], /other data are not/);
  });

check('keeps transparency in WebM', async (browser) => {
  const clear = path.join(folder, 'clear.toml');
  fs.writeFileSync(clear, `theme = "transparent"\n${generic.replace(/duration_s = [\d.]+/, 'duration_s = 0.5').replace(/still_s = [\d.]+\n/, '')}`);
  const {tab, faults} = await opened_file(browser, page_of(program, clear, path.join(folder, 'clear.html')));
  await ready(tab);
  const file = await film_file(tab, 'clear.webm', {kind: 'webm', quality: 'print', width: 320, height: 180});
  assert.doesNotMatch(await said(tab), /white ground/);
  await film_file(tab, 'clear.mp4', {kind: 'mp4', width: 320, height: 180});
  assert.deepEqual(faults, []);
  await tab.close();
  assert.equal(verified(file)[0], 0);
  poinsot('render', clear, '-o', path.join(folder, 'clear_####.png'), '--size', '320x180', '--quiet');
  // Seen on a dark ground, where wrong edges would show.
  const on_dark = (input) => {
    const bytes = run('ffmpeg', ['-v', 'error', ...input, '-vf', 'scale=in_color_matrix=bt709:flags=accurate_rnd+full_chroma_int', '-f', 'rawvideo', '-pix_fmt', 'rgba', '-']);
    const n = 320 * 180;
    return Array.from({length: bytes.length / (4 * n)}, (_, frame) => {
      const seen = new Uint8Array(3 * n);
      for (let k = 0; k < 3 * n; ++k) {
        const at = 4 * (n * frame + Math.floor(k / 3));
        const alpha = bytes[at + 3] / 255;
        seen[k] = alpha * bytes[at + (k % 3)] + (1 - alpha) * 30;
      }
      return seen;
    });
  };
  const [ours, theirs] = [on_dark(['-c:v', 'libvpx-vp9', '-i', file]), on_dark(['-framerate', '30', '-i', path.join(folder, 'clear_%04d.png')])];
  assert.equal(ours.length, theirs.length);
  const least = Math.min(...ours.map((frame, k) => psnr(frame, theirs[k])));
  console.log(`      ${ours.length} frames, PSNR ≥ ${least.toFixed(1)} dB on a dark ground`);
  assert.ok(least > 38, `${least} dB`);
});

// Two stops, the second with a loop, a caption, and what follows.
const talk = path.join(folder, 'talk.toml');
fs.writeFileSync(talk, generic.replace(/duration_s = [\d.]+/, 'duration_s = 1.4').replace(/still_s = [\d.]+\n/, '').replace(/^caption.*$/m, '') +
  '\n[[stops]]\nat_s = 0.4\ntitle = "First & second"\nnote = "Wait."\n[[stops]]\nat_s = 1.0\nloop_s = 0.4\n[[captions]]\nat_s = 0.2\nover_s = 0.6\ntext = "$L$ stays"\n');
const unpacked_into = (file, name) => {
  const into = path.join(folder, name);
  run('python3', ['-c', 'import sys, zipfile; z = zipfile.ZipFile(sys.argv[1]); assert z.testzip() is None; z.extractall(sys.argv[2])', file, into]);
  return into;
};

check('makes the slides that the program makes', async (browser) => {
  const {tab, faults} = await opened_file(browser, page_of(program, talk, path.join(folder, 'talk.html')));
  await ready(tab);
  const slides = unpacked_into(await film_file(tab, 'slides.zip', {kind: 'slides', ...small}), 'slides');
  assert.deepEqual(faults, []);
  await tab.close();
  const natively = path.join(folder, 'natively');
  poinsot('render', talk, '--slides', natively, '--size', '160x90', '--quiet');
  const pictures = native_frames_of(talk, 'talk', small);
  // All but the PDFs and the index, which leads to them.
  const names = fs.readdirSync(natively).filter((name) => !name.endsWith('.pdf') && name !== 'index.html');
  assert.deepEqual(fs.readdirSync(slides).sort(), names.sort());
  assert.ok(names.includes('02-loop.mp4') && names.includes('02.vtt'));
  const plan_in = (into) => JSON.parse(fs.readFileSync(path.join(into, 'slides.json'), 'utf8'));
  const plan = plan_in(slides);
  const native_plan = plan_in(natively);
  for (const slide of native_plan.slides) slide.pdf = null;
  // Each lists its own files; the page does not know where the scene's file is.
  for (const [into, listed] of [[slides, plan], [natively, native_plan]]) {
    const sha256 = (name) => crypto.createHash('sha256').update(fs.readFileSync(path.join(into, name))).digest('hex');
    assert.deepEqual(listed.files, fs.readdirSync(into).filter((name) => name !== 'slides.json').sort().map((name) => ({name, sha256: sha256(name)})));
    assert.equal(listed.scene_file, into === natively ? '../talk.toml' : null);
    for (const key of ['files', 'sha256', 'scene_file']) delete listed[key];
  }
  assert.deepEqual(plan, native_plan);
  const decoded = (name) => rgb_of(['-i', path.join(slides, name)], small);
  for (const {film, loop, captions, png, first_frame, last_frame, loop_s} of plan.slides) {
    for (const [name, first] of [[film, first_frame], [loop, last_frame + 1 - Math.round(30 * loop_s)]]) {
      if (!name) continue;
      const frames = decoded(name);
      assert.equal(frames.length, last_frame - first + 1);
      assert.equal(frames.length, Number(probed(path.join(natively, name)).streams[0].nb_read_frames));
      frames.forEach((frame, k) => assert.ok(psnr(frame, pictures[first + k]) > 32, `${name}, frame ${k}: ${psnr(frame, pictures[first + k])} dB`));
      assert.match(poinsot('explain', path.join(slides, name), '--verify'), /moments_kg_m2/);
    }
    if (captions) assert.equal(fs.readFileSync(path.join(slides, captions), 'utf8'), fs.readFileSync(path.join(natively, captions), 'utf8'));
    const still = path.join(slides, png);
    assert.ok(psnr(rgb_of(['-i', still], small)[0], pictures[last_frame]) > 38);
    assert.equal(verified(still)[0], 0, verified(still)[1]);
    assert.equal(JSON.parse(poinsot('explain', still, '--json')).frame, last_frame);
  }
  // The films meet in the same pixels.
  const [first, second, loop, third] = ['01.mp4', '02.mp4', '02-loop.mp4', '03.mp4'].map(decoded);
  assert.ok(first.at(-1).equals(second[0]));
  assert.ok(second.at(-1).equals(loop.at(-1)) && second.at(-1).equals(third[0]));
  // The program knows the page's slides as its own, and replaces no other file.
  fs.writeFileSync(path.join(slides, '99.mp4'), 'mine');
  assert.throws(() => poinsot('render', talk, '--slides', slides, '--size', '160x90', '--quiet'), /99\.mp4/);
  fs.unlinkSync(path.join(slides, '99.mp4'));
  poinsot('rerender', path.join(slides, '02.mp4'), '-o', path.join(folder, 'again_02.mp4'), '--quiet');
  assert.equal(rgb_of(['-i', path.join(folder, 'again_02.mp4')], small).length, second.length);
});

check('makes the presentation that the program makes', async (browser) => {
  const workbench = path.join(folder, 'workbench.html');
  write_page(make_workbench, [workbench, path.join(__dirname, '../../../scenes/scene.schema.json'), talk]);
  const {tab, faults} = await opened_file(browser, workbench);
  await ready(tab);
  const browsers = unpacked_into(await film_file(tab, 'page.pptx', {kind: 'pptx', ...small}), 'pptx');
  assert.deepEqual(faults, []);
  await tab.close();
  poinsot('render', talk, '-o', path.join(folder, 'native.pptx'), '--size', '160x90', '--quiet');
  const natively = unpacked_into(path.join(folder, 'native.pptx'), 'native_pptx');
  const names = (into) => fs.readdirSync(into, {recursive: true}).filter((name) => fs.statSync(path.join(into, name)).isFile()).sort();
  assert.deepEqual(names(browsers), names(natively));
  for (const name of names(natively)) {
    const [ours, theirs] = [browsers, natively].map((into) => path.join(into, name));
    if (name.endsWith('.png')) assert.ok(psnr(rgb_of(['-i', ours], small)[0], rgb_of(['-i', theirs], small)[0]) > 38, name);
    else if (name.endsWith('.mp4')) assert.equal(probed(ours).streams[0].nb_read_frames, probed(theirs).streams[0].nb_read_frames);
    else {
      const text_of = (file) => fs.readFileSync(file, 'utf8').replace('<dc:identifier>talk.toml ', '<dc:identifier> ');
      assert.equal(text_of(ours), text_of(theirs));
    }
  }
});

// As a new user does who has the workbench alone: the guide's section "On a Mac, on Windows".
check('leads from New to a film of a changed scene', async (browser) => {
  const began_ms = Date.now();
  const workbench = process.env['POINSOT_WORKBENCH'] ?? path.join(folder, 'first.html');
  const starts = ['moments', 'shape', 'mesh', 'top', 'measured'].map((name) => path.join(__dirname, '../../../src/doors/web/page/starts', `${name}.toml`));
  if (!process.env['POINSOT_WORKBENCH'])
    write_page(make_workbench, [workbench, path.join(__dirname, '../../../scenes/scene.schema.json'), path.join(__dirname, '../../../scenes/generic.toml'), '--new', ...starts]);
  const {tab, faults} = await opened_file(browser, workbench, {size: {width: 1440, height: 900}});
  await ready(tab);
  await tab.click('#new-open');
  await tab.evaluate(() => document.querySelector('#starts button').click());
  await write_scene(tab, (await scene_text(tab)).replace('"My body"', '"A first film"').replace(/omega_rad_s = .*/, 'omega_rad_s = [0.1, 2.0, 0.1]')
    .replace(/duration_s = .*/, 'duration_s = 2.0'));
  await until(tab, 'window.poinsot.at(0).omega_body[1] === 2');
  await tab.click('#show-options');
  await tab.evaluate(() => {
    window.showSaveFilePicker = undefined;
    the_page.save = async (blob, suffix, name) => { window.first_film = {name: name + suffix, bytes: await blob.arrayBuffer()}; };
  });
  await tab.select('#film-kind', 'mp4');
  await tab.click('#film-make');
  await until(tab, 'window.first_film', 120000);
  const base64 = await tab.evaluate(() => base64_of_bytes(new Uint8Array(window.first_film.bytes)));
  fs.writeFileSync(path.join(folder, 'first.mp4'), Buffer.from(base64, 'base64'));
  assert.equal(await tab.evaluate(() => window.first_film.name), 'a_first_film.mp4');
  assert.match(poinsot('explain', path.join(folder, 'first.mp4')), /A first film/);
  assert.equal(Number(probed(path.join(folder, 'first.mp4')).streams[0].nb_read_frames), 60);
  assert.deepEqual(faults, []);
  console.log(`      from the page's opening to the film: ${Math.round((Date.now() - began_ms) / 1000)} s`);
  await tab.close();
});

check('makes by a script what the form makes', async (browser) => {
  const {tab, faults} = await opened(browser);
  const form = await made(tab, {kind: 'png', width: 96, height: 54, span: 'stop 0', rate: 10});
  const outcome = await tab.evaluate(async () => {
    const steps = [];
    const png = await poinsot.film({kind: 'png', width: 96, height: 54, fps: 10, last_s: 1, progress: (done, n_frames) => steps.push([done, n_frames])});
    const mp4 = await poinsot.film({width: 96, height: 54, first_s: 0.5, last_s: 0.7, quality: 'draft'});
    const refusals = [];
    const stopped = new AbortController();
    for (const options of [{kind: 'gif'}, {quality: 'best'}, {first_s: 2, last_s: 1}, {last_s: Infinity}, {rate: 30}, {width: 321}, {width: 20000, height: 20000}, {width: 0},
      {width: 96, height: 54, signal: AbortSignal.abort(new Error('before'))},
      {width: 96, height: 54, signal: stopped.signal, progress: (done) => done === 3 && stopped.abort(new Error('in the middle'))}])
      await poinsot.film(options).then(() => refusals.push('made'), (error) => refusals.push(error.message));
    const base64 = async (blob) => btoa(Array.from(new Uint8Array(await blob.arrayBuffer()), (byte) => String.fromCharCode(byte)).join(''));
    return {steps, refusals, png: [png.type, await base64(png)], mp4: [mp4.type, await base64(mp4)], said: document.getElementById('film-message').textContent};
  });
  assert.equal(outcome.png[0], 'application/zip');
  assert.ok(Buffer.from(outcome.png[1], 'base64').equals(form), 'the same bytes');
  assert.deepEqual(outcome.steps, Array.from({length: 11}, (_, k) => [k, 11]));
  const file = path.join(folder, 'script.mp4');
  fs.writeFileSync(file, Buffer.from(outcome.mp4[1], 'base64'));
  assert.equal(outcome.mp4[0], 'video/mp4');
  assert.equal(Number(probed(file).streams[0].nb_read_frames), 7);
  assert.deepEqual(JSON.parse(poinsot('explain', file, '--json')).frames, [15, 21]);
  [/"gif" is none of mp4/, /"best" is none of draft/, /no span of the film/, /no span of the film/, /no option rate/, /even width/, /needs more memory/, /film\.size/, /^before$/, /^in the middle$/]
    .forEach((said, k) => assert.match(outcome.refusals[k], said));
  assert.equal(outcome.said, 'The film is saved.', 'the form says what it made');
  assert.deepEqual(faults, []);
  await tab.close();
});

check('can be cancelled, stays usable, and saves nothing then', async (browser) => {
  const {tab, faults} = await opened(browser);
  const cancelled = made(tab, {kind: 'mp4'});
  await until(tab, 'document.getElementById("film-done").value > 0.1');
  await tab.evaluate('poinsot.seek(1.5)');
  await until(tab, 'Math.abs(document.getElementById("scrub").valueAsNumber - 1.5) < 0.01');
  assert.match(await tab.$eval('#film-hint', (hint) => hint.textContent), /\d+ \/ 60.*time left/);
  // There is one film at a time, from the first press on: the button has gone.
  assert.ok(await tab.$eval('#film-make', (button) => button.hidden));
  assert.equal(await tab.evaluate('the_page.options.films.make(the_page.options.films.settings())'), null);
  await tab.evaluate('document.getElementById("film-cancel").click()');
  assert.equal(await cancelled, null);
  assert.match(await said(tab), /nothing was saved/);
  assert.ok(await tab.$eval('#film-make', (button) => !button.hidden));
  // Two presses, one after the other, start one film.
  assert.equal(await tab.evaluate(async () => {
    let n_started = 0;
    const start = Program.start;
    Program.start = (...given) => {
      ++n_started;
      return start.apply(Program, given);
    };
    document.getElementById('film-make').click();
    document.getElementById('film-make').click();
    while (!the_page.options.films.run) await new Promise((resolve) => setTimeout(resolve, 20));
    document.getElementById('film-cancel').click();
    while (the_page.options.films.making) await new Promise((resolve) => setTimeout(resolve, 20));
    Program.start = start;
    return n_started;
  }), 1);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('writes the same film to a chosen file, with a hash of its packets', async (browser) => {
  const {tab, faults} = await opened_file(browser, page_of(program, told, path.join(folder, 'told.html')));
  await ready(tab);
  for (const kind of ['mp4', 'webm']) {
    const base64 = await tab.evaluate(async (kind) => {
      let bytes = new Uint8Array(0);
      window.showSaveFilePicker = async () => ({createWritable: async () => ({
        write: async ({position, data}) => {
          const all = new Uint8Array(Math.max(bytes.length, position + data.length));
          all.set(bytes);
          all.set(data, position);
          bytes = all;
        },
        close: async () => {}, abort: async () => {},
      })});
      await the_page.options.films.make({...the_page.options.films.settings(), kind, width: 160, height: 90});
      return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
    }, kind);
    const file = path.join(folder, `streamed.${kind}`);
    fs.writeFileSync(file, Buffer.from(base64, 'base64'));
    assert.equal(Number(probed(file).streams[0].nb_read_frames), 42);
    assert.equal(chapters_of(file).length, 2);
    assert.match(verified(file)[1], /coded pictures are unchanged, but whether .* straight to disk/);
    assert.match(verified(spoiled(file, (bytes) => Math.floor(0.6 * bytes.length)))[1], /pictures do not match/);
  }
  assert.deepEqual(faults, []);
  await tab.close();
});

check('writes to a chosen file, and leaves nothing of a film that fails', async (browser) => {
  const {tab, faults} = await opened(browser);
  const outcome = await tab.evaluate(async () => {
    const outcomes = [];
    // A film; a full disk; a film that is cancelled, in place of an own file and in a new one.
    for (const [most, cancels, n_before] of [[Infinity, false, 0], [20000, false, 0], [Infinity, true, 0], [Infinity, true, 999]]) {
      const file = {size: 0, closed: false, aborted: false, removed: false};
      window.showSaveFilePicker = async () => ({
        createWritable: async () => ({
          write: async (chunk) => {
            file.size = Math.max(file.size, chunk.position + chunk.data.length);
            if (file.size > most) throw new DOMException('no space', 'QuotaExceededError');
          },
          close: async () => { file.closed = true; },
          abort: async () => { file.aborted = true; },
        }),
        // What stands at the place before the film is there.
        getFile: async () => ({size: n_before}),
        remove: async () => { file.removed = true; },
      });
      const {films} = the_page.options;
      const making = films.make({...films.settings(), width: 320, height: 180});
      if (cancels) {
        while (!(document.getElementById('film-done').value > 0.1)) await new Promise((resolve) => setTimeout(resolve, 20));
        document.getElementById('film-cancel').click();
      }
      await making;
      outcomes.push({...file, said: document.getElementById('film-message').textContent});
    }
    return outcomes;
  });
  const [made, full, cancelled, replaced] = outcome;
  assert.ok(made.closed && !made.aborted && !made.removed && made.size > 20000, JSON.stringify(made));
  assert.match(made.said, /is saved/);
  assert.ok(full.aborted && !full.closed && full.removed, JSON.stringify(full));
  assert.match(full.said, /disk is full/);
  assert.ok(cancelled.aborted && cancelled.removed, JSON.stringify(cancelled));
  assert.ok(replaced.aborted && !replaced.removed, JSON.stringify(replaced));
  assert.match(replaced.said, /nothing was saved/);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('makes every span that it offers, of one frame at least', async (browser) => {
  const ended = path.join(folder, 'ended.toml');
  fs.writeFileSync(ended, `${plain}duration_s = 0.5\n[[stops]]\nat_s = 0.2\n[[stops]]\nat_s = 0.5\n[[chapters]]\nat_s = 0\ntitle = "a"\n[[chapters]]\nat_s = 0.49\ntitle = "b"\n`);
  const {tab, faults} = await opened_file(browser, page_of(program, ended, path.join(folder, 'ended.html')));
  await ready(tab);
  const spans = await tab.$$eval('#film-span option', (options) => options.map((option) => option.value));
  assert.deepEqual(spans, ['whole', 'chapter 0', 'chapter 1', 'stop 0', 'stop 1'], 'nothing follows the last stop');
  for (const [span, rate] of [['stop 1', 30], ['chapter 1', 4]]) {
    const bytes = await made(tab, {kind: 'png', width: 32, height: 18, rate, span});
    assert.ok(bytes && bytes.length > 1000, `${span} at ${rate}: ${await said(tab)}`);
  }
  // Also where two marks are one frame, and of spans that are not offered.
  const spans_of = (film, kind) => tab.evaluate((film, kind) => [0, 1, 2, 3].map((index) => frames_of_span(film, {kind, index})), film, kind);
  for (const kind of ['whole', 'chapter', 'stop'])
    for (const film of [{n_frames: 15, chapters: [0, 14], stops: [6, 14]}, {n_frames: 1, chapters: [0, 0], stops: [0, 0]}, {n_frames: 9, chapters: [], stops: []}])
      for (const [first, last] of await spans_of(film, kind)) assert.ok(first >= 0 && first <= last && last < film.n_frames, `${kind} ${first} ${last}`);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('says how many chapters an MP4 film leaves out', async (browser) => {
  const many = path.join(folder, 'many.toml');
  fs.writeFileSync(many, `${plain}duration_s = 10\n${Array.from({length: 290}, (_, k) => `[[chapters]]\nat_s = ${k / 30}\ntitle = "c${k}"\n`).join('')}`);
  const {tab, faults} = await opened_file(browser, page_of(program, many, path.join(folder, 'many.html')));
  await ready(tab);
  const file = await film_file(tab, 'many.mp4', {kind: 'mp4', width: 32, height: 18, quality: 'draft'});
  assert.equal(chapters_of(file).length, 255);
  assert.match(await said(tab), /is saved\. .*255 chapters; the last 35 are left out/);
  const webm = await film_file(tab, 'many.webm', {kind: 'webm', width: 32, height: 18, quality: 'draft'});
  assert.equal(chapters_of(webm).length, 290);
  assert.doesNotMatch(await said(tab), /left out/);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('mends the decoder configuration of Firefox’s H.264, and leaves a sound one alone', async () => {
  const {sound_avc_record} = await import('../../../src/doors/web/page/film_encoder.js');
  const sps = [0x67, 0x64, 0x00, 0x1e, 0xac, 0xd9, 0x40, 0xa0, 0x2f, 0xf9, 0x70, 0x11, 0, 0, 3, 0, 1, 0, 0, 3, 0, 0x3c, 0x0f, 0x16];
  const pps = [0x68, 0xeb, 0xe3, 0xcb];
  const sound = [1, 0x64, 0, 0x1e, 0xff, 0xe1, 0, sps.length, ...sps, 1, 0, pps.length, ...pps, 0xfd, 0xf8, 0xf8, 0];
  // As Firefox 153 begins it: 01 64 00 1e 03 01 00 19 67 67 64.
  const broken = [1, 0x64, 0, 0x1e, 3, 1, 0, 0x19, 0x67, ...sps, 1, 0, pps.length + 1, 0x68, ...pps];
  assert.equal(Buffer.from(broken.slice(0, 11)).toString('hex'), '0164001e0301001967' + '6764');
  assert.deepEqual([...sound_avc_record(Uint8Array.from(broken))], sound);
  assert.deepEqual([...sound_avc_record(Uint8Array.from(sound))], sound);
  assert_avc_record(Buffer.from(sound));
  assert.throws(() => assert_avc_record(Buffer.from(broken)));
  // The baseline profile has no further fields; its second parameter set may begin with equal bytes.
  const baseline = [1, 0x42, 0xc0, 0x1e, 0xff, 0xe1, 0, 5, 0x67, 0x42, 0xc0, 0x1e, 0xd9, 1, 0, 3, 0x68, 0x68, 0x20];
  assert.deepEqual([...sound_avc_record(Uint8Array.from(baseline))], baseline);
});

check('names a film after the scene that was filmed', async (browser) => {
  const workbench = path.join(folder, 'named.html');
  write_page(make_workbench, [workbench, path.join(__dirname, '../../../scenes/scene.schema.json'), scene]);
  const {tab, faults} = await opened_file(browser, workbench);
  await ready(tab);
  const saved = await tab.evaluate(async () => {
    const names = [];
    window.showSaveFilePicker = undefined;
    the_page.save = (blob, suffix, name) => names.push(name + suffix);
    const {films} = the_page.options;
    const making = films.make({...films.settings(), kind: 'mp4', width: 32, height: 18});
    the_workbench.open({kind: 'new', name: 'x', text: 'title = "Another"\n[body]\nmoments_kg_m2 = [3.0, 2.0, 1.0]\n[start]\nomega_rad_s = [0.3, 1.25, 0.2]\n'}, {});
    await making;
    return [...names, the_page.data.name];
  });
  assert.deepEqual(saved, ['short.mp4', 'another']);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('refuses a size for which a tab has no memory before it begins', async (browser) => {
  const {tab, faults} = await opened(browser);
  const n_started = await tab.evaluate(() => {
    const {start} = Program;
    window.n_started = 0;
    Program.start = (...given) => {
      ++window.n_started;
      return start.apply(Program, given);
    };
    return window.n_started;
  });
  for (const kind of ['mp4', 'webm', 'png']) {
    assert.equal(await made(tab, {kind, width: 16384, height: 16384}), null);
    assert.match(await said(tab), /^A frame of 16384 × 16384 pixels needs more memory .*; choose at most (35|67) million/);
  }
  assert.equal(n_started + await tab.evaluate('window.n_started'), 0);
  assert.deepEqual(faults, []);
  await tab.close();
});

check('says how large pictures will be, within a fifth', async (browser) => {
  const {tab, faults} = await opened(browser);
  for (const [width, height] of [[320, 180], [1440, 810]]) {
    await tab.evaluate(() => { document.getElementById('film-hint').textContent = ''; });
    const bytes = await made(tab, {kind: 'png', width, height, rate: 5});
    await until(tab, 'document.getElementById("film-hint").textContent.includes("≈")');
    const said_MB = Number((await tab.$eval('#film-hint', (hint) => hint.textContent)).match(/≈ ([\d.]+) MB/)[1]);
    console.log(`      ${width} × ${height}: ${said_MB} MB said, ${bytes.length / 1e6} MB made`);
    assert.ok(Math.abs(said_MB / (bytes.length / 1e6) - 1) < 0.2, `${said_MB} MB, not ${bytes.length / 1e6} MB`);
  }
  assert.deepEqual(faults, []);
  await tab.close();
});

check('says it in one sentence where the browser has no encoder or refuses', async (browser) => {
  for (const [before, kind] of [
    [() => { delete window.VideoEncoder; }, 'mp4'],
    // A frame of no origin has none.
    [() => { if (window.VideoEncoder) VideoEncoder.prototype.configure = () => { throw new DOMException('refused', 'NotSupportedError'); }; }, 'webm']]) {
    const {tab, faults} = await opened(browser, {before});
    assert.equal(await made(tab, {kind}), null);
    assert.match(await said(tab), /cannot encode such a film; choose/);
    assert.deepEqual(faults, []);
    await tab.close();
  }
});

check('takes VP9 in MP4 where there is no H.264, and says so', async (browser) => {
  const {tab} = await opened(browser, {before: () => {
    const configure = VideoEncoder.prototype.configure;
    VideoEncoder.prototype.configure = function (config) {
      if (config.codec.startsWith('avc1')) throw new DOMException('refused', 'NotSupportedError');
      return configure.call(this, config);
    };
  }});
  const file = await film_file(tab, 'vp9.mp4', {kind: 'mp4', quality: 'draft', span: 'stop 0'});
  assert.equal(probed(file).streams[0].codec_name, 'vp9');
  assert.match(await said(tab), /no H\.264.*VP9/);
  await tab.close();
});

check('makes a film at another rate, size and value', async (browser) => {
  const {tab} = await opened(browser);
  const bytes = await made(tab, {kind: 'mp4', rate: 12.5, width: 322, height: 180, span: 'stop 0'});
  fs.writeFileSync(path.join(folder, 'other.mp4'), bytes);
  const [video] = probed(path.join(folder, 'other.mp4')).streams;
  assert.equal(video.avg_frame_rate, '25/2');
  assert.deepEqual([video.width, video.height, Number(video.nb_read_frames)], [322, 180, 14]);
  assert.equal(await made(tab, {kind: 'mp4', width: 321}), null);
  assert.match(await said(tab), /even width/);
  await tab.close();
});

check('says whose work writes the film, and where its source is', async () => {
  const lock = JSON.parse(fs.readFileSync(path.join(__dirname, '../../../src/doors/web/page/film_writer/package-lock.json'), 'utf8'));
  const {version} = lock.packages['node_modules/mediabunny'];
  assert.match(fs.readFileSync(page_file, 'utf8'), new RegExp(`Mediabunny ${version}, .*Mozilla Public License 2\\.0.*source: https://\\S+/${version}`));
});

check('offers the qualities of the program, and the size of the scene whatever that of the window', async (browser) => {
  const {tab} = await opened(browser);
  await tab.setViewport({width: 700, height: 600});
  assert.deepEqual(await tab.$$eval('#film-width, #film-height', (inputs) => inputs.map((input) => input.value)), ['1920', '1080']);
  const names = await tab.$$eval('#film-quality option', (options) => options.map((option) => option.value));
  const listed = poinsot('list', 'qualities');
  for (const name of names) assert.match(listed, new RegExp(`^\\s*${name}\\b`, 'm'));
  assert.equal(names.length, 4);
  await tab.close();
});
