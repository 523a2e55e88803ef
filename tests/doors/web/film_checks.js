// What the tests of films made in a page share: films made by the controls of a page, their frames, and what ffprobe and poinsot say.
'use strict';
const assert = require('node:assert/strict');
const {spawnSync} = require('node:child_process');
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');

const program = process.argv[2];
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'poinsot-make-film-'));
process.on('exit', () => fs.rmSync(folder, {recursive: true, force: true}));
const size = {width: 640, height: 360};

function run(command, args, options = {}) {
  const outcome = spawnSync(command, args, {maxBuffer: 1 << 30, ...options});
  assert.equal(outcome.status, 0, `${command} ${args.join(' ')}: ${outcome.stderr}`);
  return outcome.stdout;
}
const poinsot = (...args) => run(program, args, {encoding: 'utf8'});

/** The pictures of a scene's film as the program draws them: R, G and B of each frame. @param {string} name of the files */
function native_frames_of(scene, name, {width, height} = size, options = []) {
  poinsot('render', scene, '-o', path.join(folder, `${name}_####.png`), '--size', `${width}x${height}`, '--quiet', ...options);
  const first = fs.readdirSync(folder).filter((file) => file.startsWith(`${name}_`)).sort()[0].match(/_(\d+)\.png$/)[1];
  return rgb_of(['-framerate', '30', '-start_number', String(Number(first)), '-i', path.join(folder, `${name}_%04d.png`)], {width, height});
}

/** The frames of a film as FFmpeg decodes them. */
function rgb_of(input, {width, height} = size) {
  const bytes = run('ffmpeg', ['-v', 'error', ...input, '-vf', 'scale=in_color_matrix=bt709:flags=accurate_rnd+full_chroma_int', '-f', 'rawvideo', '-pix_fmt', 'rgb24', '-']);
  const n = 3 * width * height;
  assert.equal(bytes.length % n, 0);
  return Array.from({length: bytes.length / n}, (_, k) => bytes.subarray(k * n, (k + 1) * n));
}

/** The peak signal-to-noise ratio of two pictures, dB. */
function psnr(a, b) {
  let sum = 0;
  for (let i = 0; i < a.length; ++i) sum += (a[i] - b[i]) ** 2;
  return 10 * Math.log10((255 * 255 * a.length) / sum);
}

/** Each picture is the native film's of the same number, and of no other. @param {Uint8Array[]} native the pictures of that film */
function assert_same_frames(frames, native, first = 0) {
  let least = Infinity;
  let n_told_apart = 0;
  frames.forEach((frame, k) => {
    const here = psnr(frame, native[first + k]);
    least = Math.min(least, here);
    for (const other of [first + k - 1, first + k + 1]) {
      // Where nearly nothing moves, what the encoder loses is more than what moves.
      if (!native[other] || psnr(native[first + k], native[other]) > 40) continue;
      ++n_told_apart;
      assert.ok(psnr(frame, native[other]) < here, `frame ${k} is rather the native film's frame ${other}`);
    }
  });
  assert.ok(least >= 38, `PSNR ${least} dB`);
  console.log(`      ${frames.length} frames, PSNR ≥ ${least.toFixed(1)} dB; ${n_told_apart} neighbours are other pictures`);
}

/** Makes a film in a tab by the controls of the page; the bytes, or null. */
async function made(tab, values) {
  const base64 = await tab.evaluate(async (chosen) => {
    for (const [id, value] of Object.entries(chosen)) {
      const field = document.getElementById(`film-${id}`);
      field.value = String(value);
      if (field.value !== String(value)) throw new Error(`${id} offers no ${value}`);
      field.dispatchEvent(new Event('change'));
    }
    // As where a browser has no dialog for files.
    window.showSaveFilePicker = undefined;
    the_page.save = () => {};
    const blob = await the_page.options.films.make(the_page.options.films.settings());
    if (!blob) return null;
    const bytes = new Uint8Array(await blob.arrayBuffer());
    let text = '';
    for (let i = 0; i < bytes.length; i += 32768) text += String.fromCharCode(...bytes.subarray(i, i + 32768));
    return btoa(text);
  }, {...size, ...values});
  return base64 === null ? null : Buffer.from(base64, 'base64');
}
const said = (tab) => tab.$eval('#film-message', (field) => field.textContent);

/** Makes a film and writes it into a file. */
async function film_file(tab, name, values) {
  const bytes = await made(tab, values);
  assert.ok(bytes, await said(tab));
  fs.writeFileSync(path.join(folder, name), bytes);
  return path.join(folder, name);
}

const probed = (file) => JSON.parse(run('ffprobe', ['-v', 'error', '-count_frames', '-show_streams', '-show_format', '-of', 'json', file]));

/** A decoder configuration record of H.264 is one by the letter of ISO/IEC 14496-15 §5.3.3.1.2. @param {Buffer} record */
function assert_avc_record(record) {
  const [version, profile, , , lengths, n_sps] = record;
  assert.equal(version, 1);
  assert.equal(lengths & 0xfc, 0xfc, 'reserved bits are 1');
  assert.equal(n_sps & 0xe0, 0xe0, 'reserved bits are 1');
  let at = 6;
  const sets = (n, type) => {
    assert.ok(n >= 1);
    for (let k = 0; k < n; ++k) {
      const size = record.readUInt16BE(at);
      const set = record.subarray(at + 2, at += 2 + size);
      assert.equal(set.length, size);
      assert.equal(set[0] & 0x9f, type, `a parameter set of type ${type}`);
      if (type === 7) assert.ok(set.subarray(1, 4).equals(record.subarray(1, 4)), `profile and level of the set ${set.toString('hex')} are those of the record`);
    }
  };
  sets(n_sps & 0x1f, 7);
  sets(record[at++], 8);
  if ([100, 110, 122, 144].includes(profile)) {
    assert.deepEqual([record[at], record[at + 1], record[at + 2]], [0xfd, 0xf8, 0xf8], '4:2:0, 8 bits');
    assert.equal(record[at + 3], 0);
    at += 4;
  }
  assert.equal(at, record.length);
}

/** The body of the first box of a kind. @param {string} file @param {string} kind */
function box_in(file, kind) {
  const bytes = fs.readFileSync(file);
  const at = bytes.indexOf(kind, 0, 'latin1');
  return bytes.subarray(at + 4, at - 4 + bytes.readUInt32BE(at - 4));
}

function assert_film(file, codec, n_frames, per_second = 30) {
  const {streams, format} = probed(file);
  const [video] = streams;
  assert.equal(video.codec_name, codec);
  if (codec === 'h264') {
    assert_avc_record(box_in(file, 'avcC'));
    assert.equal(spawnSync('ffmpeg', ['-v', 'warning', '-i', file, '-f', 'null', '-'], {encoding: 'utf8'}).stderr, '');
  }
  assert.equal(Number(video.nb_read_frames), n_frames);
  assert.equal(video.r_frame_rate, `${per_second}/1`);
  assert.equal(video.avg_frame_rate, `${per_second}/1`);
  assert.ok(Math.abs(Number(format.duration) - n_frames / per_second) < 0.002, format.duration);
  assert.deepEqual([video.width, video.height], [size.width, size.height]);
  assert.equal(video.color_range, 'tv');
  assert.equal(video.color_space, 'bt709');
  assert.equal(video.color_primaries, 'bt709');
  assert.equal(video.color_transfer, 'bt709');
}

/** What `explain --verify` says of a file, and its exit code. */
function verified(file) {
  const {status, stdout, stderr} = spawnSync(program, ['explain', file, '--verify'], {encoding: 'utf8'});
  return [status, stdout + stderr];
}

/** Changes the bits of one byte in the middle of a film. */
function spoiled(file, at) {
  const bytes = fs.readFileSync(file);
  bytes[at(bytes)] ^= 1;
  const copy = path.join(folder, `spoiled${path.extname(file)}`);
  fs.writeFileSync(copy, bytes);
  return copy;
}

module.exports = {assert_avc_record, assert_film, assert_same_frames, film_file, folder, made, native_frames_of, poinsot, probed, psnr, rgb_of, run, said, size, spoiled, verified};
