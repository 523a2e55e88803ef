// Why a throw says nothing, from rows and accelerations of throws that the test makes. Needs no browser.
import test from 'node:test';
import assert from 'node:assert/strict';
import {falls_of, why_poor} from '../../../src/doors/web/page/poor_throw.js';
import {is_caught} from '../../../src/doors/web/page/record.js';

/** A recording at 60 Hz: held for a second, free for `flight_s` with ω by `omega`, caught, and held for four seconds. Gravity is felt but in flight. */
function recording(flight_s, omega) {
  const rows = [];
  const accelerations = [];
  for (let k = 0; k < 60 * (5 + flight_s); ++k) {
    const t = k / 60;
    const flies = t > 1 && t < 1 + flight_s;
    const caught = t >= 1 + flight_s && t < 1.1 + flight_s;
    rows.push(t, ...(flies ? omega(t - 1) : [0.1 * Math.sin(9 * t), 0.1 * Math.cos(7 * t), caught ? 5 : 0]));
    accelerations.push(t, flies ? 1.5 + Math.sin(50 * t) : caught ? 40 : 9.8 + 0.5 * Math.sin(20 * t));
  }
  return {rows, accelerations};
}

const tumbling = (t) => [8 * Math.cos(3 * t), 8 * Math.sin(3 * t), 3];

test('names what was wrong', () => {
  for (const [why, flight_s, omega] of [['too_short', 0.3, tumbling], ['too_slow', 0.7, (t) => [0.3, 1, 0.2 * t]], ['one_axis', 0.7, () => [0.2, 0.2, 12]],
    ['too_fast', 0.7, (t) => [34.9, 10 * Math.sin(t), 3]], ['', 0.7, tumbling]]) {
    const {rows, accelerations} = recording(flight_s, omega);
    assert.equal(why_poor(rows, accelerations), why);
  }
  const held = recording(0, tumbling);
  assert.equal(why_poor(held.rows, held.accelerations), 'never_free');
  // Without an accelerometer there is no flight to speak of.
  assert.equal(why_poor(held.rows, []), '');
  assert.equal(why_poor([], []), '');
});

test('feels a fall, and ends a recording after the catch', () => {
  const {rows, accelerations} = recording(0.7, () => [0.2, 0.2, 12]);
  const falls = falls_of(accelerations);
  assert.equal(falls.length, 2);
  assert.ok(Math.abs(falls[0] - 1) < 0.03 && Math.abs(falls[1] - 1.7) < 0.03, `${falls}`);
  const until = (last_s) => is_caught(rows.slice(0, 4 * Math.round(60 * last_s)), falls);
  assert.equal(until(1.75), false);
  assert.equal(until(2.6), true);
  assert.deepEqual(falls_of([]), []);
  // A jolt of two rows is no fall.
  assert.deepEqual(falls_of([0, 9.8, 0.016, 1, 0.033, 1, 0.05, 9.8]), []);
});
