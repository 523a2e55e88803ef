// The scene in each kind of file that the program makes, read as the workbench reads it. Usage: node made_file_test.mjs POINSOT. Needs no browser.
import test from 'node:test';
import assert from 'node:assert/strict';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import {spawnSync} from 'node:child_process';
import {made_scene, may_hold_scene} from '../../../src/doors/web/page/made_file.js';

const [poinsot] = process.argv.slice(2);
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'poinsot-made-'));
process.on('exit', () => fs.rmSync(folder, {recursive: true, force: true}));

/** @param {string[]} options */
function run(...options) {
  const outcome = spawnSync(poinsot, options, {encoding: 'utf8', cwd: folder});
  assert.equal(outcome.status, 0, outcome.stderr);
  return outcome.stdout;
}

// Letters that the containers escape, and more text than one block of a GIF holds.
const title = '(Kreisel) \\\\ & <b> コマ ¹ %25';
fs.writeFileSync(path.join(folder, 'mine.toml'), `title = "${title}"\n[film]\nduration_s = 0.2\nsize = "96x54"\n[body]\nmoments_kg_m2 = [3, 2, 1]\n[start]\nomega_rad_s = [0.1, 2, 0.3]\n`);

const kinds = [['png', 'still', ['--time', '0.1']], ['pdf', 'still', ['--time', '0.1']], ['svg', 'still', ['--time', '0.1']], ['gif', 'render', []],
  ['mp4', 'render', []], ['webm', 'render', []], ['mov', 'render', []], ['html', 'render', []]];
for (const [suffix, verb, more] of kinds)
  test(`reads the scene of a ${suffix}`, () => {
    const file = `made.${suffix}`;
    run(verb, 'mine.toml', '-o', file, '--quiet', '--set', 'start.omega_rad_s=[0.25, 1.5, 0.125]', ...more);
    assert.ok(may_hold_scene(file));
    const made = made_scene(new Uint8Array(fs.readFileSync(path.join(folder, file))));
    assert.ok(made, 'it has a scene');
    assert.equal(made.name, 'mine');
    assert.equal(made.time_s, verb === 'still' ? 0.1 : null);
    assert.match(made.text, /コマ ¹/);
    // The program finds the same motion in it, with the value that was set.
    fs.writeFileSync(path.join(folder, 'again.toml'), made.text);
    const set = made.overrides.flatMap((pair) => ['--set', pair]);
    const [head, row] = run('sample', 'again.toml', '--times', '0', ...set).split('\n');
    const omega = row?.split(',').slice(1, 4).map(Number);
    assert.deepEqual(omega, [0.25, 1.5, 0.125], head);
  });

test('finds no scene in what poinsot did not make', () => {
  for (const bytes of [Buffer.alloc(0), Buffer.from('poinsot 0.1.0\nscene: x\n\n[body]\n'), Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'), Buffer.from('GIF89a;'),
    Buffer.from('%PDF-1.5\n/Poinsot'), Buffer.from('<svg></svg>'), Buffer.from('<!doctype html><p>poinsot 0.1'), Buffer.from('\0\0\0\x10ftypisom', 'latin1'),
    Buffer.from('\0\0\0\x10ftypisompoinsot 0.1', 'latin1'), Buffer.from('\x1aE\xdf\xa3poinsot 0.1', 'latin1')])
    assert.equal(made_scene(new Uint8Array(bytes)), null, bytes.toString('latin1'));
});

test('ends at a cut anywhere', () => {
  const whole = new Uint8Array(fs.readFileSync(path.join(folder, 'made.png')));
  for (let n = 0; n < whole.length; n += 97)
    assert.doesNotThrow(() => made_scene(whole.slice(0, n)));
});
