// The address of a page holds its state: instant, speed, views, values and look.

import {fragment_of, state_of} from './link.js';
/** @import {Choices} from './figure.js' */
/** @import {Page} from './page.js' */

export class Address {
  /** @param {Page} page */
  constructor(page) {
    this.page = page;
    /** Whether the colours follow the system and were not chosen. */
    this.follows_system = false;
  }

  /** The state without "#". */
  fragment() {
    const {figure, views} = this.page;
    const {film} = figure;
    const {values, shown, names, theme} = figure.choices;
    const has_moved = !film.untouched || views.list().length > 0 || values.size > 0;
    const look = this.follows_system ? '' : theme || (this.#system_is_dark ? 'scene' : '');
    const scene = this.page.store?.link() ?? {scene: this.page.place > 0 ? this.page.data.name : '', text: ''};
    return fragment_of({...scene, at_s: has_moved ? film.at_s : null, speed: film.speed, views: views.list(), values, shown, names, theme: look});
  }

  /** The address of this instant, view and values. */
  link() {
    return `${location.href.replace(/#.*$/, '')}#${this.fragment()}`;
  }

  /** Puts the state into the address. */
  keep() {
    try {
      history.replaceState(null, '', `#${this.fragment()}`);
    } catch {
      // A sandboxed page has no address of its own.
    }
  }

  /** Takes instant, speed and views from the address. @returns {Choices} the choices that it holds */
  read() {
    const {figure, views} = this.page;
    const state = state_of(location.hash);
    this.page.take_scene(state.scene);
    const {data} = this.page;
    const {film} = figure;
    // A drag sets both.
    const controls = [...data.controls, ...(data.controls.includes('start.omega_rad_s') ? ['start.attitude'] : [])];
    if (state.at_s === null) film.untouched = true;
    else film.seek(state.at_s);
    film.speed = state.speed;
    this.follows_system = state.theme === '' && this.#system_is_dark;
    views.set(state.views);
    figure.set_views(state.views);
    return {
      values: new Map([...state.values].filter(([key]) => controls.includes(key))),
      shown: state.shown,
      names: state.names,
      theme: this.follows_system ? 'dark' : ['light', 'dark'].includes(state.theme) ? state.theme : '',
    };
  }

  /** Whether the system's dark colours are those of this page: a frame has the colours of the page around it, and a scene its own, if it sets any. */
  get #system_is_dark() {
    const {data, embedded} = this.page;
    const sets_colours = /^\s*(theme\s*=|\[style\]|style\.)/m.test(data.text) || data.overrides.some((text) => /^(theme|style\.)/.test(text));
    return !embedded && !sets_colours && !document.body.classList.contains('workbench') && matchMedia('(prefers-color-scheme: dark)').matches;
  }
}
