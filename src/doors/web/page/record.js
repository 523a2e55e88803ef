// Records ω from the gyroscope of the phone that shows the workbench.

export const longest_record_s = 120;
/** So long the phone is quiet after the catch, or so long after the flight at most, before a recording ends. */
const quiet_s = 0.7;
const most_after_flight_s = 3;
const quiet_rad_s = 1;

/**
 * Rows of a recording, four numbers each: the time in s from the first row on, and ω in rad/s about the device's axes:
 * x to its right, y up, z out of its screen.
 * @typedef {number[]} OmegaRows
 */

/** A recording as a table that `poinsot fit` reads. @param {OmegaRows} rows @returns {string} */
export function table_of_rows(rows) {
  const lines = ['time_s,omega_x_rad_s,omega_y_rad_s,omega_z_rad_s'];
  for (let k = 0; k < rows.length; k += 4)
    lines.push([Number((rows[k] ?? 0).toFixed(6)), ...rows.slice(k + 1, k + 4).map((w) => Number(w.toPrecision(9)))].join(','));
  return `${lines.join('\n')}\n`;
}

/**
 * Whether the phone has flown and come to rest, or so much time has gone since.
 * @param {OmegaRows} rows @param {number[]} flights begin and end of each, s @returns {boolean}
 */
export function is_caught(rows, flights) {
  const n = rows.length;
  const last_s = rows[n - 4] ?? 0;
  const end_s = flights[1];
  if (end_s === undefined || end_s > last_s - quiet_s) return false;
  if (last_s > end_s + most_after_flight_s) return true;
  for (let k = n - 4; k >= 0 && (rows[k] ?? 0) > last_s - quiet_s; k -= 4)
    if (Math.hypot(rows[k + 1] ?? 0, rows[k + 2] ?? 0, rows[k + 3] ?? 0) > quiet_rad_s) return false;
  return true;
}

export class Recorder {
  /** Whether a page may ask for a gyroscope here. */
  static get is_possible() {
    return window.isSecureContext && ('DeviceMotionEvent' in window || 'Gyroscope' in window);
  }

  /** @param {() => void} changed called after each row */
  constructor(changed) {
    this.changed = changed;
    /** Rows by where they come from; the gyroscope's own have the better times. @type {{gyroscope: OmegaRows, motion: OmegaRows}} */
    this.taken = {gyroscope: [], motion: []};
    /** Milliseconds of the first row. @type {{gyroscope: number|null, motion: number|null}} */
    this.first_ms = {gyroscope: null, motion: null};
    /** Sizes of the acceleration with gravity, two numbers each: ms and m/s². @type {number[]} */
    this.felt = [];
    /** Whether the phone tells how it is accelerated, and nothing of its rotation. */
    this.lacks_gyroscope = false;
    /** @type {any} */
    this.gyroscope = null;
    // By the Device Orientation specification of today and in all browsers, alpha, beta and gamma of a rate are about
    // x, y and z, in degrees a second (w3c/deviceorientation #43).
    this.take_motion = (/** @type {DeviceMotionEvent} */ event) => {
      const {x, y, z} = event.accelerationIncludingGravity ?? {x: null, y: null, z: null};
      if (x !== null && y !== null && z !== null) this.felt.push(event.timeStamp, Math.hypot(x, y, z));
      const {alpha, beta, gamma} = event.rotationRate ?? {alpha: null, beta: null, gamma: null};
      this.lacks_gyroscope = this.rows.length === 0 && this.felt.length > 0;
      if (alpha === null || beta === null || gamma === null) return;
      this.lacks_gyroscope = false;
      this.#take('motion', event.timeStamp, [alpha, beta, gamma].map((rate) => (rate * Math.PI) / 180));
    };
  }

  /** @returns {OmegaRows} */
  get rows() {
    return this.taken.gyroscope.length > 0 ? this.taken.gyroscope : this.taken.motion;
  }

  /** Sizes of the acceleration by the clock of the rows, two numbers each: s and m/s². */
  get accelerations() {
    const first_ms = this.taken.gyroscope.length > 0 ? this.first_ms.gyroscope : this.first_ms.motion;
    return this.felt.map((value, k) => (k % 2 === 0 ? (value - (first_ms ?? 0)) / 1000 : value));
  }

  /** Call it from a press: iOS asks the viewer. @returns {Promise<boolean>} whether the viewer allows it */
  async start() {
    const event = /** @type {any} */ (window).DeviceMotionEvent;
    try {
      if (event?.requestPermission && (await event.requestPermission()) !== 'granted') return false;
    } catch {
      return false;
    }
    window.addEventListener('devicemotion', this.take_motion);
    const Sensor = /** @type {any} */ (window).Gyroscope;
    if (!Sensor) return true;
    try {
      this.gyroscope = new Sensor({frequency: 60});
      this.gyroscope.addEventListener('reading', () => {
        const {x, y, z, timestamp} = this.gyroscope;
        this.#take('gyroscope', timestamp, [x, y, z]);
      });
      // Without it, the events of motion are there.
      this.gyroscope.addEventListener('error', () => {});
      this.gyroscope.start();
    } catch {
      this.gyroscope = null;
    }
    return true;
  }

  stop() {
    window.removeEventListener('devicemotion', this.take_motion);
    this.gyroscope?.stop();
  }

  /** @param {'gyroscope'|'motion'} from @param {number} at_ms @param {number[]} omega rad/s */
  #take(from, at_ms, omega) {
    const rows = this.taken[from];
    const first_ms = (this.first_ms[from] ??= at_ms);
    const time_s = (at_ms - first_ms) / 1000;
    // Browsers round times, so that two readings may have the same.
    if (!omega.every(Number.isFinite) || (rows.length > 0 && time_s <= (rows[rows.length - 4] ?? 0) + 1e-6)) return;
    rows.push(time_s, ...omega);
    this.changed();
  }
}
