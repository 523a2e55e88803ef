// Why a recorded throw says nothing about the body, for one who throws: from the rows of the gyroscope and from the accelerometer, which reads
// nearly nothing while the phone falls freely.

/** @import {OmegaRows} from './record.js' */

/** Free fall: so little, or less, m/s²; a spinning phone's sensor lies off its middle, and feels ω²r besides. */
const most_of_fall = 5;
const least_fall_s = 0.12;
/** What a throw needs. */
const least_flight_s = 0.45;
const least_rate_rad_s = 3;
/** Where gyroscopes of phones end, 2000 °/s, less a thousandth. */
const limit_rad_s = 34.87;
/** The length of the mean of the directions of ω; 1: it keeps one. */
const most_steady = 0.985;

/**
 * Begins and ends of free falls, s. @param {number[]} accelerations two numbers each: the time in s and the size in m/s², with gravity
 * @returns {number[]}
 */
export function falls_of(accelerations) {
  /** @type {number[]} */
  const falls = [];
  let begin_s = -1;
  let last_s = -1;
  const end = () => {
    if (begin_s >= 0 && last_s - begin_s >= least_fall_s) falls.push(begin_s, last_s);
    begin_s = -1;
  };
  for (let k = 0; k + 1 < accelerations.length; k += 2) {
    if ((accelerations[k + 1] ?? 0) > most_of_fall) end();
    else {
      last_s = accelerations[k] ?? 0;
      if (begin_s < 0) begin_s = last_s;
    }
  }
  end();
  return falls;
}

/**
 * The name of the sentence that says what to do better; '': none of them.
 * @param {OmegaRows} rows @param {number[]} accelerations as for `falls_of`; none: the phone did not give them
 * @returns {''|'never_free'|'too_short'|'too_slow'|'too_fast'|'one_axis'}
 */
export function why_poor(rows, accelerations) {
  let n_limited = 0;
  for (let k = 0; k + 3 < rows.length; k += 4) if (Math.max(...[1, 2, 3].map((i) => Math.abs(rows[k + i] ?? 0))) >= limit_rad_s) ++n_limited;
  if (n_limited >= 3) return 'too_fast';
  if (accelerations.length === 0) return '';
  const falls = falls_of(accelerations);
  if (falls.length === 0) return 'never_free';
  // The longest one.
  let [from_s, to_s] = [0, 0];
  for (let k = 0; k + 1 < falls.length; k += 2) {
    const [begin_s, end_s] = [falls[k] ?? 0, falls[k + 1] ?? 0];
    if (end_s - begin_s > to_s - from_s) [from_s, to_s] = [begin_s, end_s];
  }
  if (to_s - from_s < least_flight_s) return 'too_short';
  let n = 0;
  let rate = 0;
  const sum = [0, 0, 0];
  for (let k = 0; k + 3 < rows.length; k += 4) {
    if ((rows[k] ?? 0) < from_s || (rows[k] ?? 0) > to_s) continue;
    const omega = [rows[k + 1] ?? 0, rows[k + 2] ?? 0, rows[k + 3] ?? 0];
    const size = Math.hypot(...omega);
    ++n;
    rate += size;
    if (size > 0) omega.forEach((w, i) => { sum[i] = (sum[i] ?? 0) + w / size; });
  }
  if (n === 0) return '';
  if (rate / n < least_rate_rad_s) return 'too_slow';
  return Math.hypot(...sum) / n > most_steady ? 'one_axis' : '';
}
