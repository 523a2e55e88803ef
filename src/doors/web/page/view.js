// Turning, moving and zooming the panels that have a view, by mouse, touch, pen and keys.

/** @import {Panel, View} from './program.js' */
/** @import {Words} from './words.js' */

/**
 * @typedef {{changed: () => void, picked: (x: number, y: number, panel: number) => boolean,
 *   hovered: (x: number, y: number, panel: number) => boolean,
 *   dragged: (x: number, y: number, panel: number) => void, dropped: () => void,
 *   touched: () => void, words: () => Words, zooms_by_wheel: () => boolean}} ViewEvents
 */

const degrees_a_height = 240; // of the panel: a drag over all of it turns by this much
const least_zoom = 0.2;
const most_zoom = 20;

export class Views {
  /** @param {HTMLElement} holder lies over the canvas @param {ViewEvents} events */
  constructor(holder, events) {
    this.holder = holder;
    this.events = events;
    /** @type {Map<number, View>} */
    this.views = new Map();
    /** @type {Panel[]} */
    this.panels = [];
    /** @type {HTMLElement[]} */
    this.frames = [];
    /** Pointers that are down, in CSS pixels. @type {Map<number, {x: number, y: number}>} */
    this.pointers = new Map();
    /** Whether the pointer moves what it picked. */
    this.drags = false;
    this.pans = false;
    /** Pixels of the canvas for a CSS pixel. */
    this.ratio = 1;
  }

  /** @returns {View[]} */
  list() {
    return [...this.views.values()];
  }

  /** @param {View[]} views */
  set(views) {
    this.views = new Map(views.map((view) => [view.panel, view]));
  }

  /** Places a focusable frame over each panel with a view. @param {Panel[]} panels @param {number} ratio pixels of the canvas for a CSS pixel */
  place(panels, ratio) {
    this.panels = panels;
    this.ratio = ratio;
    const wanted = panels.map((panel, index) => ({panel, index})).filter(({panel}) => panel.has_view);
    if (wanted.length !== this.frames.length) {
      for (const frame of this.frames) frame.remove();
      this.frames = wanted.map(({index}) => this.#made_frame(index));
    }
    wanted.forEach(({panel, index}, i) => {
      const frame = /** @type {HTMLElement} */ (this.frames[i]);
      frame.dataset['panel'] = String(index);
      frame.style.left = `${panel.x / ratio}px`;
      frame.style.top = `${panel.y / ratio}px`;
      frame.style.width = `${panel.width / ratio}px`;
      frame.style.height = `${panel.height / ratio}px`;
    });
    this.describe();
  }

  /** Tells screen readers where each view looks from. */
  describe() {
    for (const frame of this.frames) {
      const index = Number(frame.dataset['panel']);
      const panel = this.panels[index];
      if (!panel) continue;
      const {azimuth_deg, elevation_deg} = this.of(index);
      frame.setAttribute('aria-label', `${this.events.words().of('view')} ${index + 1}: ${panel.name || panel.kind}, ` +
        `${Math.round(azimuth_deg)}°, ${Math.round(elevation_deg)}°`);
    }
  }

  /** The view of a panel with all values. @param {number} panel */
  of(panel) {
    const own = this.views.get(panel);
    const place = this.panels[panel];
    return {
      azimuth_deg: own?.azimuth_deg ?? place?.azimuth_deg ?? 0,
      elevation_deg: own?.elevation_deg ?? place?.elevation_deg ?? 0,
      zoom: own?.zoom ?? 1,
      shift_x: own?.shift_x ?? 0,
      shift_y: own?.shift_y ?? 0,
    };
  }

  /** @param {number} panel @param {Partial<View>} values */
  change(panel, values) {
    /** @type {View} */
    const view = {...(this.views.get(panel) ?? {panel}), ...values};
    if (view.azimuth_deg !== undefined) view.azimuth_deg = ((((view.azimuth_deg + 180) % 360) + 360) % 360) - 180;
    if (view.elevation_deg !== undefined) view.elevation_deg = Math.min(90, Math.max(-90, view.elevation_deg));
    if (view.zoom !== undefined) view.zoom = Math.min(most_zoom, Math.max(least_zoom, view.zoom));
    this.views.set(panel, view);
    this.describe();
    this.events.changed();
  }

  /** Back to the scene's camera. @param {number} [panel] all panels if left out */
  reset(panel) {
    if (panel === undefined) this.views.clear();
    else this.views.delete(panel);
    this.describe();
    this.events.changed();
  }

  /** @param {number} panel @param {number} right_deg @param {number} up_deg */
  turn(panel, right_deg, up_deg) {
    const now = this.of(panel);
    this.change(panel, {azimuth_deg: now.azimuth_deg + right_deg, elevation_deg: now.elevation_deg + up_deg});
  }

  /** @param {number} panel @param {number} right @param {number} up in heights of the panel */
  pan(panel, right, up) {
    const now = this.of(panel);
    this.change(panel, {shift_x: now.shift_x + right, shift_y: now.shift_y + up});
  }

  /** @param {number} panel @param {number} factor */
  zoom(panel, factor) {
    this.change(panel, {zoom: this.of(panel).zoom * factor});
  }

  /** The panel that keys turn: the focused one, or the first with a view; -1: none. */
  active() {
    const focused = this.frames.find((frame) => frame === document.activeElement);
    const frame = focused ?? this.frames[0];
    return frame ? Number(frame.dataset['panel']) : -1;
  }

  /** @param {number} index */
  #made_frame(index) {
    const frame = document.createElement('div');
    frame.className = 'view';
    frame.tabIndex = 0;
    frame.setAttribute('role', 'group');
    frame.dataset['panel'] = String(index);
    const panel = () => Number(frame.dataset['panel']);
    frame.addEventListener('pointerdown', (event) => this.#down(frame, panel(), event));
    frame.addEventListener('pointermove', (event) => this.#move(frame, panel(), event));
    frame.addEventListener('pointerup', (event) => this.#up(event));
    frame.addEventListener('pointercancel', (event) => this.#up(event));
    frame.addEventListener('blur', () => frame.classList.remove('touched'));
    frame.addEventListener('dblclick', () => this.reset(panel()));
    frame.addEventListener('contextmenu', (event) => event.preventDefault());
    frame.addEventListener('wheel', (event) => this.#wheel(panel(), event), {passive: false});
    this.holder.append(frame);
    return frame;
  }

  /** Where the pointer is on the canvas, in its pixels. @param {PointerEvent} event */
  #on_canvas(event) {
    const box = this.holder.getBoundingClientRect();
    return {x: (event.clientX - box.left) * this.ratio, y: (event.clientY - box.top) * this.ratio};
  }

  /** @param {HTMLElement} frame @param {number} panel @param {PointerEvent} event */
  #down(frame, panel, event) {
    this.events.touched();
    frame.classList.add('touched');
    frame.focus({preventScroll: true});
    frame.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, {x: event.clientX, y: event.clientY});
    if (this.pointers.size === 1) {
      const {x, y} = this.#on_canvas(event);
      this.pans = event.button !== 0 || event.shiftKey || event.ctrlKey;
      this.drags = !this.pans && this.events.picked(x, y, panel);
    } else this.#end_drag();
    frame.classList.add('held');
  }

  /** @param {HTMLElement} frame @param {number} panel @param {PointerEvent} event */
  #move(frame, panel, event) {
    const before = this.pointers.get(event.pointerId);
    if (!before) {
      const {x, y} = this.#on_canvas(event);
      frame.classList.toggle('omega', this.events.hovered(x, y, panel));
      return;
    }
    const height = Math.max(1, frame.clientHeight);
    const dx = event.clientX - before.x;
    const dy = event.clientY - before.y;
    const others = [...this.pointers].filter(([id]) => id !== event.pointerId).map(([, at]) => at);
    this.pointers.set(event.pointerId, {x: event.clientX, y: event.clientY});
    const other = others[0];
    if (other) {
      // Two fingers: their distance zooms, their middle moves.
      const was = Math.hypot(before.x - other.x, before.y - other.y);
      const is = Math.hypot(event.clientX - other.x, event.clientY - other.y);
      if (was > 1 && is > 1) this.zoom(panel, is / was);
      this.pan(panel, dx / 2 / height, -dy / 2 / height);
    } else if (this.drags) {
      const {x, y} = this.#on_canvas(event);
      this.events.dragged(x, y, panel);
    } else if (this.pans) this.pan(panel, dx / height, -dy / height);
    else if (dx !== 0 || dy !== 0) this.turn(panel, (-dx / height) * degrees_a_height, (dy / height) * degrees_a_height);
  }

  /** @param {PointerEvent} event */
  #up(event) {
    this.pointers.delete(event.pointerId);
    if (this.pointers.size > 0) return;
    for (const frame of this.frames) frame.classList.remove('held');
    this.#end_drag();
  }

  #end_drag() {
    if (this.drags) this.events.dropped();
    this.drags = false;
  }

  /** @param {number} panel @param {WheelEvent} event */
  #wheel(panel, event) {
    if (!event.ctrlKey && !this.events.zooms_by_wheel()) return;
    event.preventDefault();
    this.events.touched();
    const lines = event.deltaMode === 0 ? 1 : 33;
    this.zoom(panel, Math.exp(-event.deltaY * lines * (event.ctrlKey ? 0.01 : 0.0015)));
  }
}
