// What a thrown body did, from its fit and its rows: the numbers of the sentence that comes before all others.

/**
 * `n_flips`: how often it turned over, the first time `first_flip_s` after the beginning of the flight; null: it turned about its first or third
 * axis, `axis` 0 or 2, and could not. `lost`: the part of |L| that the air took.
 * @typedef {{axis: number, n_flips: number|null, first_flip_s: number|null, length_s: number, n_turns: number, lost: number}} ThrowStory
 */

/** Within this angle of L the middle axis must come, as in src/motion/construction/flips.h. */
const flip_angle_rad = Math.PI / 4;

/** @param {number[]} a @param {number[]} b */
const dot = (a, b) => a.reduce((sum, x, k) => sum + x * (b[k] ?? 0), 0);

/** How far from the middle axis L is where it comes nearest to it, and which axis the polhode encloses. @param {number[]} moments from the largest @param {number[]} omega along their axes */
function nearest_to_middle(moments, omega) {
  const [a, b, c] = /** @type {[number, number, number]} */ (moments);
  const twice_T = dot(moments, omega.map((w) => w * w));
  const L_squared = dot(moments.map((i) => i * i), omega.map((w) => w * w));
  // At the nearest point the third component, or the first, is zero: energy and momentum give the other two.
  const axis = L_squared < b * twice_T ? 2 : 0;
  const other = axis === 2 ? c : a;
  const along_middle = (L_squared - other * twice_T) / (b * (b - other));
  const along_other = (L_squared - b * twice_T) / (other * (other - b));
  return {axis, angle_rad: Math.atan2(other * Math.sqrt(Math.max(0, along_other)), b * Math.sqrt(Math.max(0, along_middle)))};
}

/**
 * @param {{moments: number[], axes: number[][]}} fit as `poinsot fit --json` prints it, with the axes as columns
 * @param {ArrayLike<number>} rows of the table, four numbers each: the time in s and ω in rad/s @param {number} begin_s of the flight @param {number} end_s
 * @returns {ThrowStory}
 */
export function throw_story(fit, rows, begin_s, end_s) {
  /** @type {{time_s: number, omega: number[]}[]} */
  const states = [];
  for (let k = 0; k + 3 < rows.length; k += 4) {
    const time_s = rows[k] ?? 0;
    const given = [rows[k + 1] ?? 0, rows[k + 2] ?? 0, rows[k + 3] ?? 0];
    if (time_s >= begin_s - 1e-9 && time_s <= end_s + 1e-9) states.push({time_s, omega: [0, 1, 2].map((k) => dot(fit.axes.map((row) => row[k] ?? 0), given))});
  }
  const first = states[0];
  const last = states[states.length - 1];
  if (!first || !last || states.length < 3) return {axis: 0, n_flips: null, first_flip_s: null, length_s: end_s - begin_s, n_turns: 0, lost: 0};
  let angle = 0;
  states.forEach(({time_s, omega}, k) => {
    const before = states[k - 1];
    if (before) angle += 0.5 * (time_s - before.time_s) * (Math.hypot(...omega) + Math.hypot(...before.omega));
  });
  // The straight line through ln |L| by least squares: noise of single rows counts little.
  const points = states.map(({time_s, omega}) => [time_s - first.time_s, 0.5 * Math.log(Math.max(1e-300, dot(fit.moments.map((i) => i * i), omega.map((w) => w * w))))]);
  const mean = [0, 1].map((k) => points.reduce((sum, point) => sum + (point[k] ?? 0), 0) / points.length);
  const spread = points.reduce((sum, [t = 0]) => sum + (t - (mean[0] ?? 0)) ** 2, 0);
  const slope = points.reduce((sum, [t = 0, l = 0]) => sum + (t - (mean[0] ?? 0)) * (l - (mean[1] ?? 0)), 0) / spread;
  const story = {length_s: last.time_s - first.time_s, n_turns: angle / (2 * Math.PI), lost: Math.max(0, 1 - Math.exp(slope * (last.time_s - first.time_s)))};
  // Noise about zero is no change of sign.
  const size = Math.max(...states.map(({omega}) => Math.abs(omega[1] ?? 0)));
  const clear = states.filter(({omega}) => Math.abs(omega[1] ?? 0) > 0.1 * size);
  const {axis, angle_rad} = nearest_to_middle(fit.moments, first.omega);
  if (!(size > 0 && angle_rad < flip_angle_rad)) return {...story, axis, n_flips: null, first_flip_s: null};
  /** @type {number[]} */
  const flips = [];
  clear.forEach((state, k) => {
    const before = clear[k - 1];
    const [from, to] = [before?.omega[1] ?? 0, state.omega[1] ?? 0];
    if (before && from * to < 0) flips.push(before.time_s + ((state.time_s - before.time_s) * from) / (from - to) - first.time_s);
  });
  return {...story, axis: 1, n_flips: flips.length, first_flip_s: flips[0] ?? null};
}
