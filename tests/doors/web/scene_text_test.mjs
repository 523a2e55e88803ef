// Values that the workbench writes into a scene's text are those that --set gives it, and nothing else of the text changes.
// Usage: node scene_text_test.mjs POINSOT SCENES. No browser is needed.
import {spawnSync} from 'node:child_process';
import test from 'node:test';
import assert from 'node:assert/strict';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import {as_toml, difference_of, edit_of, edited, removal_of, value_in} from '../../../src/doors/web/page/scene_text.js';

const [program, scenes] = process.argv.slice(2);

const with_values = (text, values) => Object.entries(values).reduce((now, [key, value]) => edited(now, edit_of(now, key, value)), text);

test('an edited text is the scene that --set makes', () => {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'poinsot-scene-text-'));
  // Beside copies of the files that scenes name.
  fs.cpSync(scenes, folder, {recursive: true});
  let n_scenes = 0;
  for (const name of fs.readdirSync(scenes).filter((file) => file.endsWith('.toml'))) {
    const text = fs.readFileSync(path.join(scenes, name), 'utf8');
    const values = {title: '"An edited one # no comment"', language: '"fr"', 'film.fps': '24'};
    if (value_in(text, 'start.omega_rad_s')) values['start.omega_rad_s'] = '[0.31, 1.27, 0.43]';
    const said = (options) => {
      const {status, stdout, stderr} = spawnSync(program, ['check', path.join(folder, name), '--json', ...options], {encoding: 'utf8'});
      return status === 0 ? stdout : `${status}: ${stderr.split(': ').pop()}`;
    };
    const by_set = said(Object.entries(values).flatMap(([key, value]) => ['--set', `${key}=${value}`]));
    fs.writeFileSync(path.join(folder, name), with_values(text, values));
    assert.equal(said([]), by_set, name);
    ++n_scenes;
  }
  fs.rmSync(folder, {recursive: true});
  assert.ok(n_scenes > 40);
});

test('a value is changed in its place, and the rest of the text stays', () => {
  let n_values = 0;
  for (const name of fs.readdirSync(scenes).filter((file) => file.endsWith('.toml'))) {
    const text = fs.readFileSync(path.join(scenes, name), 'utf8');
    for (const key of ['title', 'start.omega_rad_s', 'start.omega_rad_s[1]', 'body.moments_kg_m2', 'film.speed', 'stops[1].at_s', 'captions[0].text', 'body.masses[1].at_m[2]']) {
      const before = value_in(text, key);
      if (before === null) continue;
      const changed = with_values(text, {[key]: '123456'});
      assert.equal(value_in(changed, key), '123456', `${name}: ${key}`);
      assert.equal(with_values(changed, {[key]: before}), text, `${name}: ${key}`);
      ++n_values;
    }
    // A key that is added to a table can be taken away.
    const table = ['start', 'film'].find((name) => new RegExp(`^\\[${name}\\]`, 'm').test(text));
    const added = table ? with_values(text, {[`${table}.zzz`]: '[1, 2]'}) : text;
    if (!table) continue;
    assert.equal(value_in(added, `${table}.zzz`), '[1, 2]', name);
    assert.equal(edited(added, removal_of(added, `${table}.zzz`)), text, name);
  }
  assert.ok(n_values > 80, `${n_values}`);
});

test('finds values whatever TOML writes around them', () => {
  const text = '# a = 1\na.b = "]#\\""  # c\n[ start ] # [film]\nomega_rad_s = [ 1.0, # one, ]\n  2, 3 ]\nname = """x\n[y]\n"""" # z\n' +
    "[[body.masses]]\nat_m = [1,2,3]\n[[body.masses]]\nat_m = [4, 5, 6]\n[body.masses.more]\nstyle = {a = 1, 'b' = {c = 'd, }'}}";
  for (const [key, value] of [['a.b', '"]#\\""'], ['start.omega_rad_s[2]', '3'], ['start.name', '"""x\n[y]\n""""'], ['body.masses[0].at_m[1]', '2'],
    ['body.masses[1].at_m[0]', '4'], ['body.masses[1].more.style.b.c', "'d, }'"], ['film', null], ['start.c', null]]) assert.equal(value_in(text, key), value, key);
  for (const [key, line] of [['start.e', 8], ['body.masses[0].q', 10], ['a.q', 2], ['new.key', 16], ['body.masses[1].more.style.b.e', 13]]) {
    const rows = with_values(text, {[key]: 'V'}).split('\n');
    assert.ok(rows[line]?.includes('V'), `${key}: ${rows.findIndex((row) => row.includes('V'))}`);
  }
  // Of a text that is no TOML, nothing is changed.
  for (const broken of ['a = ', '[b', 'a = [1', 'x = "y', '= 3']) assert.equal(edit_of(broken, 'c', '1'), null, broken);
  assert.deepEqual(['1.5', '[1]', 'true', 'box', '"box"', '-inf', '{a = 1}'].map(as_toml), ['1.5', '[1]', 'true', '"box"', '"box"', '-inf', '{a = 1}']);
  for (const [one, other] of [['abc', 'abXc'], ['aaa', 'aa'], ['', 'x'], ['same', 'same']]) assert.equal(edited(one, difference_of(one, other)), other);
});
