// The table of keys of a page. No browser is needed.
import test from 'node:test';
import assert from 'node:assert/strict';
import {action_of, caps_of, key_rows} from '../../../src/doors/web/page/keys.js';
import {all_words} from '../../../src/doors/web/page/words.js';

const pressed = (key, {shiftKey = false, altKey = false} = {}) => action_of({key, shiftKey, altKey});

test('every row has a word, and every key one meaning', () => {
  const seen = new Set();
  for (const row of key_rows) {
    assert.ok(Object.hasOwn(all_words, row.word), row.word);
    for (const key of Object.keys(row.keys)) {
      const name = `${row.modifier ?? ''} ${key}`;
      assert.ok(!seen.has(name), name);
      seen.add(name);
    }
    assert.ok(caps_of(row).every((cap) => cap.length > 0));
  }
});

test('capitals are letters, and "=" is "+"', () => {
  assert.equal(pressed('J'), pressed('j'));
  assert.equal(pressed('J', {shiftKey: true}), pressed('j'));
  assert.equal(pressed('='), pressed('+'));
  assert.notEqual(pressed('+'), undefined);
});

test('Shift and Alt change what arrows do, and Alt leaves all other keys to the browser', () => {
  const meanings = [{}, {shiftKey: true}, {altKey: true}].map((held) => pressed('ArrowLeft', held));
  assert.equal(new Set(meanings).size, 3);
  assert.equal(pressed('ArrowLeft', {shiftKey: true, altKey: true}), meanings[1]);
  for (const key of ['j', '1', ' ', 'PageDown']) assert.equal(pressed(key, {altKey: true}), undefined, key);
  for (const key of ['toString', 'x', 'Enter']) assert.equal(pressed(key), undefined, key);
});

test('arrows turn and move the view by their direction, and without a view they are not taken', () => {
  const calls = [];
  const page = (panel) => ({views: {active: () => panel, turn: (...at) => calls.push(['turn', ...at]), pan: (...at) => calls.push(['pan', ...at])}});
  assert.equal(pressed('ArrowUp', {shiftKey: true})(page(-1)), false);
  assert.deepEqual(calls, []);
  assert.equal(pressed('ArrowUp', {shiftKey: true})(page(2)), true);
  assert.equal(pressed('ArrowLeft', {altKey: true})(page(0)), true);
  assert.deepEqual(calls.map(([name, panel, right, up]) => [name, panel, Math.sign(right), Math.sign(up)]), [['turn', 2, 0, 1], ['pan', 0, -1, 0]]);
});
