// Where the film is: playing, waiting at stops, and stepping. No drawing, no clock of its own.

/**
 * @typedef {{at_s: number, title: string, loop_s: number|null, note: string, planned_s: number|null}} Stop
 * @typedef {{at_s: number, title: string}} Chapter
 * @typedef {{length_s: number, frames_per_s: number, loops: boolean, stops: Stop[], chapters: Chapter[]}} FilmPlan
 */

export class Film {
  /** @param {FilmPlan} plan */
  constructor(plan) {
    this.plan = plan;
    this.at_s = 0;
    /** Seconds of film in a second of the viewer; negative: backwards. */
    this.speed = 1;
    this.playing = false;
    this.repeat = plan.loops;
    /** The stop at which the film stands or loops; -1: none. */
    this.waiting = -1;
    /** Whether the viewer wants to go on when the loop has reached its seam. */
    this.leaving = false;
    /** Whether nobody has moved the film yet. */
    this.untouched = true;
  }

  /** Takes another film and stays where it is. @param {FilmPlan} plan */
  change(plan) {
    if (plan.loops !== this.plan.loops) this.repeat = plan.loops;
    this.plan = plan;
    if (this.waiting >= plan.stops.length) {
      this.waiting = -1;
      this.leaving = false;
    }
    this.at_s = this.#within(this.at_s);
  }

  /** @param {number} at_s */
  #within(at_s) {
    return Math.min(Math.max(at_s, 0), this.plan.length_s);
  }

  /** The instants that a viewer steps through: stops, or else chapters. @returns {number[]} */
  #marks() {
    const {stops, chapters} = this.plan;
    return (stops.length > 0 ? stops : chapters).map((mark) => mark.at_s);
  }

  get is_looping() {
    return this.playing && this.waiting >= 0;
  }

  /** @param {number} at_s */
  seek(at_s) {
    this.untouched = false;
    this.at_s = this.#within(at_s);
    this.waiting = -1;
    this.leaving = false;
  }

  play() {
    if (this.untouched) this.at_s = 0;
    this.untouched = false;
    if (this.is_looping) {
      this.leaving = true;
      return;
    }
    const at_end = this.speed > 0 ? this.at_s >= this.plan.length_s : this.at_s <= 0;
    if (at_end) this.at_s = this.speed > 0 ? 0 : this.plan.length_s;
    this.waiting = -1;
    this.playing = true;
  }

  pause() {
    this.playing = false;
    this.leaving = false;
  }

  /** What the space bar does. */
  toggle() {
    if (this.is_looping && !this.leaving) this.leaving = true;
    else if (this.playing) this.pause();
    else this.play();
  }

  /** Goes on from a stop; between stops, to the next one. Without stops, plays; while it plays or stands between chapters, goes to the next one or the end. */
  next() {
    const {stops, length_s} = this.plan;
    if (this.is_looping) {
      // Once: go on at the seam. Twice: at once.
      if (this.leaving) {
        this.at_s = stops[this.waiting]?.at_s ?? this.at_s;
        this.waiting = -1;
        this.leaving = false;
      } else this.leaving = true;
      return;
    }
    const next = this.#marks().find((mark) => mark > this.at_s + this.#tick);
    const begins = this.untouched || (stops.length === 0 && this.at_s <= this.#tick);
    const has_no_marks = stops.length === 0 && next === undefined && this.plan.chapters.length === 0 && !this.is_over;
    if (this.waiting >= 0 || (!this.playing && (begins || has_no_marks))) {
      this.play();
      return;
    }
    if (next === undefined) this.pause();
    this.#stand_at(next ?? length_s);
  }

  /** Whether the film stands at its end. */
  get is_over() {
    return !this.playing && this.at_s >= this.plan.length_s;
  }

  previous() {
    const before = this.#marks().filter((mark) => mark < this.at_s - this.#tick);
    this.#stand_at(before[before.length - 1] ?? 0);
  }

  /** Goes to a stop. @param {number} number from 1 */
  to_stop(number) {
    const stop = this.plan.stops[number - 1];
    if (stop) this.#stand_at(stop.at_s);
  }

  /** Goes to a stop, where it loops if the stop has a loop. @param {number} at_s */
  #stand_at(at_s) {
    this.seek(at_s);
    const {stops} = this.plan;
    const stop = stops.findIndex((s) => s.at_s === at_s);
    const loops = stop >= 0 && (stops[stop]?.loop_s ?? 0) > 0;
    if (stop >= 0) this.waiting = stop;
    if (stops.length > 0) this.playing = loops;
  }

  /** Half a frame: instants closer than this are the same. */
  get #tick() {
    return 0.5 / this.plan.frames_per_s;
  }

  /** Steps by frames, on the film's own frames. @param {number} n */
  step(n) {
    this.pause();
    const fps = this.plan.frames_per_s;
    const here = this.at_s * fps;
    const whole = Math.round(here);
    const on_frame = Math.abs(here - whole) < 1e-6;
    const from = on_frame ? whole : n > 0 ? Math.floor(here) : Math.ceil(here);
    this.seek((from + n) / fps);
  }

  /** @param {number} number from 1; 0 is the beginning */
  to_chapter(number) {
    const {chapters} = this.plan;
    const marks = chapters.length > 0 ? chapters.map((c) => c.at_s) : this.#marks();
    const at_s = number === 0 ? 0 : marks[number - 1];
    if (at_s !== undefined) this.seek(at_s);
  }

  /** The chapter of this instant; null: none. @returns {Chapter|null} */
  chapter() {
    const begun = this.plan.chapters.filter((c) => c.at_s <= this.at_s + this.#tick);
    return begun[begun.length - 1] ?? null;
  }

  /** The stop at which the film stands or loops, or the next one; -1: none. */
  coming_stop() {
    if (this.waiting >= 0) return this.waiting;
    return this.plan.stops.findIndex((stop) => stop.at_s > this.at_s + this.#tick);
  }

  /** Lets time pass. @param {number} seconds of the viewer */
  advance(seconds) {
    if (!this.playing) return;
    let to_s = this.at_s + seconds * this.speed;
    const {stops, length_s} = this.plan;
    if (this.waiting >= 0) {
      const stop = /** @type {Stop} */ (stops[this.waiting]);
      const loop_s = stop.loop_s ?? 0;
      if (this.speed < 0) {
        this.waiting = -1;
        this.leaving = false;
      } else if (to_s < stop.at_s) {
        this.at_s = to_s;
        return;
      } else if (!this.leaving) {
        // The seam: the picture of the stop is followed by that of the loop's beginning.
        this.at_s = loop_s > 0 ? stop.at_s - loop_s + ((to_s - stop.at_s) % loop_s) : stop.at_s;
        return;
      } else {
        this.waiting = -1;
        this.leaving = false;
        this.at_s = stop.at_s;
      }
    }
    if (this.speed > 0 && this.#reaches_stop(this.at_s + 1e-9, to_s)) return;
    const past = to_s >= length_s || to_s < 0;
    if (past && this.repeat && length_s > 0) {
      if (this.speed > 0 && this.#reaches_stop(0, to_s - length_s)) return;
      to_s = ((to_s % length_s) + length_s) % length_s;
    } else if (past && (this.speed > 0 ? to_s >= length_s : to_s < 0)) this.playing = false;
    this.at_s = this.#within(to_s);
  }

  /** Waits at the first stop of a span, if it has one. @param {number} from_s @param {number} to_s */
  #reaches_stop(from_s, to_s) {
    const reached = this.plan.stops.findIndex((s) => s.at_s >= from_s && s.at_s <= to_s);
    const stop = this.plan.stops[reached];
    if (!stop) return false;
    this.waiting = reached;
    const loop_s = stop.loop_s ?? 0;
    this.at_s = loop_s > 0 ? stop.at_s - loop_s + ((to_s - stop.at_s) % loop_s) : stop.at_s;
    if (loop_s <= 0) this.playing = false;
    return true;
  }
}
