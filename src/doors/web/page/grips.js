// What can be dragged in the picture: the tips of ω and ρ, and the point where L meets the invariable plane.

import {toml_of} from './controls.js';
/** @import {Figure} from './figure.js' */
/** @import {Words} from './words.js' */

/**
 * In pixels of the canvas. `moved`: the point that a drag moves to the pointer.
 * @typedef {{panel: number, thing: string, x: number, y: number, moved_x: number, moved_y: number}} Grip
 */

/**
 * Values by their keys; null: the scene has its own.
 * @typedef {Map<string, string|null>} DraggedValues
 * @typedef {{drags: (thing: string) => boolean, set_soon: (key: string, value: string) => void, words: () => Words,
 *   values: (keys: string[]) => DraggedValues, take_back: (values: DraggedValues) => void, lasts: () => boolean}} GripEvents
 *   `lasts`: whether what was dragged stays at the next stop.
 */

/** What a drag sets. */
const dragged_keys = ['start.omega_rad_s', 'start.attitude', 'start.energy_J'];
const grip_reach_px = 12; // CSS pixels
const grip_step_px = 4; // of an arrow key

export class Grips {
  /** @param {Figure} figure @param {HTMLElement} holder lies over the canvas @param {GripEvents} events */
  constructor(figure, holder, events) {
    this.figure = figure;
    this.holder = holder;
    this.events = events;
    /** @type {Grip|null} */
    this.held = null;
    /** The values before the last drag. @type {DraggedValues|null} */
    this.before = null;
    /** The stop at which the first drag began, and the values before it. @type {{waiting: number, values: DraggedValues}|null} */
    this.first = null;
    /** Those of the picture that is seen; null: not asked for. @type {Grip[]|null} */
    this.seen = null;
    /** Whether the film goes on when the drag ends. */
    this.goes_on = false;
    /** From the pointer to the point that it moves, in pixels of the canvas. */
    this.offset = {x: 0, y: 0};
    /** Where the pointer was when the body beside the construction began to turn. */
    this.rests = {x: 0, y: 0};
    /** The second of film at which cameras are held since a drag; null: they are not. @type {number|null} */
    this.held_at_s = null;
    /** Those with a ring. @type {Grip[]} */
    this.shown = [];
    /** @type {HTMLElement[]} */
    this.rings = [];
  }

  /** @returns {Grip[]} */
  #list() {
    const {program, film, time_s} = this.figure;
    if (!program || !(this.events.drags('omega') || this.events.drags('plane'))) return [];
    this.seen ??= program.grips(time_s, film.at_s).filter((grip) => this.events.drags(grip.thing));
    return this.seen;
  }

  /** After a picture was drawn: puts a ring around each grip while the film stands. */
  show() {
    this.seen = null;
    const {waiting} = this.figure.film;
    // The next stop shows what its words say.
    if (this.first && !this.held && !this.events.lasts() && waiting >= 0 && waiting !== this.first.waiting) {
      this.before = this.first.values;
      this.take_back();
    }
    if (this.held_at_s !== null && this.figure.film.at_s !== this.held_at_s) this.let_go();
    const {ratio} = this.figure;
    // Rings do not overlap; the contact point comes first.
    const near = (/** @type {Grip} */ a, /** @type {Grip} */ b) => Math.hypot(a.x - b.x, a.y - b.y) < 2 * grip_reach_px * ratio;
    const order = this.figure.film.playing ? [] : [...this.#list()].sort((a, b) => Number(a.thing === 'plane') - Number(b.thing === 'plane'));
    /** @type {Grip[]} */
    const grips = [];
    for (const grip of order)
      if (!grips.some((other) => near(other, grip))) grips.push(grip);
    while (this.rings.length > grips.length) this.rings.pop()?.remove();
    grips.forEach((grip, i) => {
      const ring = (this.rings[i] ??= this.#made_ring(i));
      ring.style.left = `${grip.x / ratio}px`;
      ring.style.top = `${grip.y / ratio}px`;
      ring.setAttribute('aria-label', this.events.words().of(grip.thing === 'omega' ? 'drag_omega' : 'drag_plane'));
    });
    this.shown = grips;
  }

  /** A ring that the keyboard reaches; the pointer takes what is below it. @param {number} index */
  #made_ring(index) {
    const ring = document.createElement('button');
    ring.type = 'button';
    ring.className = 'grip';
    ring.addEventListener('keydown', (event) => {
      const steps = /** @type {Record<string, [number, number]>} */ ({ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]});
      const step = steps[event.key];
      const grip = this.shown[index];
      if (!step || !grip || event.shiftKey || event.altKey || event.ctrlKey || event.metaKey) return;
      event.preventDefault();
      event.stopPropagation();
      this.#take(grip, grip.x, grip.y);
      const px = grip_step_px * this.figure.ratio;
      this.drag(grip.x + step[0] * px, grip.y + step[1] * px);
      this.held = null;
    });
    this.holder.append(ring);
    return ring;
  }

  /** The grip at a place of the canvas. @param {number} x @param {number} y @param {number} panel @returns {Grip|null} */
  at(x, y, panel) {
    const off = (/** @type {Grip} */ grip) => Math.hypot(grip.x - x, grip.y - y);
    const near = this.#list().filter((grip) => grip.panel === panel && off(grip) <= grip_reach_px * this.figure.ratio);
    return near.sort((a, b) => off(a) - off(b))[0] ?? null;
  }

  /** Whether the pointer takes something. @param {number} x @param {number} y @param {number} panel */
  take(x, y, panel) {
    const grip = this.at(x, y, panel);
    if (grip) {
      this.#take(grip, x, y);
      this.#turn_beside(x, y);
    }
    return grip !== null;
  }

  /** @param {Grip} grip @param {number} x @param {number} y of the pointer */
  #take(grip, x, y) {
    const {program, film, time_s} = this.figure;
    this.held = grip;
    this.offset = {x: grip.moved_x - x, y: grip.moved_y - y};
    if (film.playing) this.before = null;
    this.before ??= this.events.values(dragged_keys);
    this.first ??= {waiting: film.waiting, values: this.before};
    this.goes_on = film.playing;
    film.pause();
    program?.hold(true, time_s, film.at_s);
    this.held_at_s = film.at_s;
    if (program?.startAt(time_s, grip, grip.moved_x, grip.moved_y, film.at_s)) return;
    // Where the motion is not free, only its start can be chosen.
    film.seek(this.figure.film_second_of(0));
    this.held_at_s = film.at_s;
    this.figure.invalidate();
  }

  /** Where the pointer rests, the body beside the construction begins to turn as it would from here. @param {number} x @param {number} y */
  #turn_beside(x, y) {
    const {figure} = this;
    if (!figure.loaded?.elements.some((element) => element.name === 'body-beside' && element.shown)) return;
    this.rests = {x, y};
    figure.beside_s = 0;
    figure.invalidate();
  }

  /** Frames the figure again after a drag. */
  let_go() {
    if (this.held_at_s === null) return;
    this.held_at_s = null;
    this.figure.program?.hold(false, this.figure.time_s, this.figure.film.at_s);
    this.figure.invalidate();
  }

  /** Moves what is held with the pointer. @param {number} pointer_x @param {number} pointer_y on the canvas */
  drag(pointer_x, pointer_y) {
    const {program, time_s, film} = this.figure;
    const {held} = this;
    if (!program || !held) return;
    if (this.figure.beside_s !== null && Math.hypot(pointer_x - this.rests.x, pointer_y - this.rests.y) > 3 * this.figure.ratio)
      this.#turn_beside(pointer_x, pointer_y);
    const [x, y] = [pointer_x + this.offset.x, pointer_y + this.offset.y];
    const start = program.startAt(time_s, held, x, y, film.at_s);
    const short = (/** @type {number} */ value) => Number(value.toPrecision(6));
    if (start) {
      this.events.set_soon('start.omega_rad_s', toml_of(start.omega));
      this.events.set_soon('start.attitude', toml_of(start.attitude));
    } else if (held.thing === 'omega') {
      const omega = program.omegaAt(time_s, held.panel, x, y, film.at_s);
      if (omega) this.events.set_soon('start.omega_rad_s', toml_of(omega.map(short)));
    } else {
      const energy = program.energyAt(time_s, held.panel, x, y, film.at_s);
      if (energy !== null) this.events.set_soon('start.energy_J', toml_of(short(energy)));
    }
  }

  drop() {
    this.held = null;
    this.figure.beside_s = null;
    this.figure.film.playing ||= this.goes_on;
    this.goes_on = false;
    this.figure.invalidate();
  }

  /** Undoes the drags since the film stood still; what else was changed stays. @returns {boolean} whether there was one */
  take_back() {
    const {before, first} = this;
    this.held = null;
    this.figure.beside_s = null;
    this.before = null;
    if (!before) return false;
    if (before === first?.values) this.first = null;
    this.let_go();
    this.events.take_back(before);
    return true;
  }

  /** Leaves what was dragged as it is. */
  forget() {
    this.before = null;
    this.first = null;
  }
}
