// What a throw did, from its fit and rows, beside bodies that the test throws by Euler's equations. Needs no browser.
import test from 'node:test';
import assert from 'node:assert/strict';
import {throw_story} from '../../../src/doors/web/page/throw_story.js';

const moments = [1, 0.8, 0.35];

/**
 * Rows at 60 Hz of a body whose L decays at `rate`, by the classical Runge-Kutta method, about axes that the instrument numbers cyclically; with
 * the instants at which ω about the middle axis changes its sign.
 */
function thrown(omega, length_s, rate = 0, from_s = 10) {
  const slope = ([x, y, z]) => [((moments[1] - moments[2]) / moments[0]) * y * z - rate * x, ((moments[2] - moments[0]) / moments[1]) * z * x - rate * y,
    ((moments[0] - moments[1]) / moments[2]) * x * y - rate * z];
  const added = (a, h, b) => a.map((x, i) => x + h * b[i]);
  const rows = [];
  const flips = [];
  const n = 100;
  const h = 1 / 60 / n;
  for (let k = 0; k <= length_s * 60 * n + 1e-6; ++k) {
    if (k % n === 0) rows.push(from_s + k * h, omega[1] + 0.01 * Math.sin(917 * k), omega[2] + 0.01 * Math.sin(531 * k), omega[0]);
    const a = slope(omega);
    const b = slope(added(omega, h / 2, a));
    const c = slope(added(omega, h / 2, b));
    const d = slope(added(omega, h, c));
    const next = omega.map((w, i) => w + (h / 6) * (a[i] + 2 * b[i] + 2 * c[i] + d[i]));
    if (next[1] * omega[1] < 0) flips.push(k * h);
    omega = next;
  }
  return {rows, flips, story: throw_story({moments, axes: [[0, 1, 0], [0, 0, 1], [1, 0, 0]]}, rows, from_s, from_s + length_s)};
}

test('counts the flips of a body about its middle axis', () => {
  for (const [omega, length_s] of [[[1, 11, 3], 0.8], [[0.3, 12, 0.2], 2.5], [[0.5, 9, 0.5], 4], [[0.3, 12, 0.2], 0.2]]) {
    const {flips, story} = thrown(omega, length_s);
    assert.equal(story.axis, 1);
    assert.equal(story.n_flips, flips.length);
    if (flips.length > 0) assert.ok(Math.abs(story.first_flip_s - flips[0]) < 0.01, `${story.first_flip_s}, not ${flips[0]}`);
    assert.ok(Math.abs(story.length_s - length_s) < 0.02);
  }
  // Its middle axis comes within 35° of L, and ω only within 58° of that axis.
  const wide = thrown([1, 6, 10], 3);
  assert.equal(wide.story.n_flips, wide.flips.length);
  assert.ok(thrown([0.5, 9, 0.5], 4).flips.length > 1, 'one of them turns over more than once');
});

test('says of a wobble about the first or third axis that it is none', () => {
  // Their ω about the middle axis changes its sign, too.
  for (const [omega, axis] of [[[10, 1, 1], 0], [[1, 1, 10], 2]]) {
    const {flips, story} = thrown(omega, 3);
    assert.ok(flips.length > 1);
    assert.equal(story.n_flips, null);
    assert.equal(story.axis, axis);
  }
});

test('says what the air took of L, and how many turns there were', () => {
  for (const rate of [0, 0.05, 0.4]) {
    const {story} = thrown([1, 11, 3], 0.8, rate);
    assert.ok(Math.abs(story.lost - (1 - Math.exp(-0.8 * rate))) < 0.003, `${story.lost} at ${rate}`);
  }
  const {story} = thrown([0, 0, 4 * Math.PI], 2);
  assert.ok(Math.abs(story.n_turns - 4) < 0.01, `${story.n_turns}`);
});

test('lives on with rows and fits that say nothing', () => {
  const axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
  for (const rows of [[], [0, 1, 2, 3], [0, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0]])
    for (const equal of [moments, [1, 1, 1], [1, 1, 0.2], [1, 0.2, 0.2]]) assert.equal(throw_story({moments: equal, axes}, rows, 0, 2).n_flips, null);
});
