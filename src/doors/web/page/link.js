// The state of a page in the fragment of its address: instant, views, values, look.

/** @import {View} from './program.js' */

/**
 * @typedef {{scene: string, text: string, at_s: number|null, speed: number, views: View[], values: Map<string, string>,
 *   shown: string[]|null, names: boolean|null, theme: string}} PageState
 *   `scene`: its name, where a page has several; '': the first. `text`: that of a scene of one's own, packed; see link_text.js.
 */

/** @returns {PageState} */
export function empty_state() {
  return {scene: '', text: '', at_s: null, speed: 1, views: [], values: new Map(), shown: null, names: null, theme: ''};
}

/** @type {(keyof Omit<View, 'panel'>)[]} */
export const view_keys = ['azimuth_deg', 'elevation_deg', 'roll_deg', 'distance', 'zoom', 'shift_x', 'shift_y'];

/** Few digits, for a short link. @param {number} x */
function short_number(x) {
  return String(Number(x.toPrecision(6)));
}

/** @param {PageState} state @returns {string} without "#" */
export function fragment_of(state) {
  const fields = new URLSearchParams();
  if (state.scene) fields.append('scene', state.scene);
  if (state.text) fields.append('text', state.text);
  if (state.at_s !== null) fields.append('at', String(Number(state.at_s.toPrecision(12))));
  if (state.speed !== 1) fields.append('speed', short_number(state.speed));
  for (const view of state.views) {
    const values = view_keys.map((key) => (view[key] === undefined ? '' : short_number(view[key] ?? 0)));
    fields.append('view', [view.panel, ...values].join(',').replace(/,+$/, ''));
  }
  for (const [key, value] of state.values) fields.append('set', `${key}=${value}`);
  if (state.shown) fields.append('show', state.shown.join(','));
  if (state.names !== null) fields.append('names', String(state.names));
  if (state.theme) fields.append('theme', state.theme);
  return fields.toString();
}

const longest_fragment = 20000; // characters; a page writes some hundred

/** Whether a fragment is longer than any that a page writes. @param {string} fragment */
export function is_too_long(fragment) {
  return fragment.length > longest_fragment;
}

/** Reads a fragment; leaves out what it does not understand. @param {string} fragment */
export function state_of(fragment) {
  const state = empty_state();
  if (is_too_long(fragment)) return state;
  const fields = new URLSearchParams(fragment.replace(/^#/, ''));
  /** @param {string|null} text */
  const number_of = (text) => (text !== null && text.trim() !== '' && Number.isFinite(Number(text)) ? Number(text) : null);
  state.scene = fields.get('scene') ?? '';
  state.text = fields.get('text') ?? '';
  state.at_s = number_of(fields.get('at'));
  state.speed = number_of(fields.get('speed')) || 1;
  for (const text of fields.getAll('view')) {
    const [panel, ...values] = text.split(',');
    const index = number_of(panel ?? '');
    if (index === null || !Number.isInteger(index) || index < 0) continue;
    /** @type {View} */
    const view = {panel: index};
    view_keys.forEach((key, i) => {
      const value = number_of(values[i] ?? '');
      if (value !== null) view[key] = value;
    });
    state.views.push(view);
  }
  for (const text of fields.getAll('set')) {
    const equals = text.indexOf('=');
    if (equals > 0) state.values.set(text.slice(0, equals), text.slice(equals + 1));
  }
  const shown = fields.get('show');
  if (shown !== null) state.shown = shown.split(',').filter((name) => name !== '');
  const names = fields.get('names');
  if (names === 'true' || names === 'false') state.names = names === 'true';
  const theme = fields.get('theme') ?? '';
  if (/^[a-z-]*$/.test(theme)) state.theme = theme;
  return state;
}
