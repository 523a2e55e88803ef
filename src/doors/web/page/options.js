// The options of a page, in a drawer beside the picture: values, elements, view, colours, files, films, keys.

import {input, part} from './bar.js';
import {Controls} from './controls.js';
import {list_keys} from './keys.js';
import {FilmSection} from './make_film.js';
import {motion_said} from './words.js';
/** @import {Page} from './page.js' */
/** @import {Loaded} from './program.js' */

export class Options {
  /** @param {Page} page */
  constructor(page) {
    this.page = page;
    this.controls = new Controls(part('controls'), () => page.words, (key, value) => page.set_soon(key, value));
    this.films = new FilmSection(page);
    /** What the program says about the motion and the scene. */
    this.regime = '';
    /** The elements that have a box, and the language of their names. */
    this.element_names = '';
    this.#wire();
  }

  get is_open() {
    return !part('options').hidden;
  }

  /** @param {boolean} opens */
  open(opens) {
    part('options').hidden = !opens;
    document.body.classList.toggle('with-options', opens);
    part('show-options').setAttribute('aria-expanded', String(opens));
    this.page.fit();
  }

  toggle() {
    this.open(!this.is_open);
  }

  /** Shows what a scene offers, after it was loaded. @param {Loaded} loaded */
  show(loaded) {
    const {page} = this;
    this.controls.show(loaded.controls);
    this.films.show();
    this.show_elements();
    // The program's own sentence is English.
    const motion = (page.words.code !== 'en' && motion_said(loaded, page.words)) || loaded.motion;
    const text = [motion, ...loaded.notes].filter(Boolean).join('\n');
    if (text !== this.regime) {
      const strong = document.createElement('strong');
      strong.textContent = motion;
      part('regime').replaceChildren(strong, ...loaded.notes.map((note) => `\n${note}`));
    }
    this.regime = text;
    part('section-change').hidden = loaded.controls.length === 0 && !text;
    // The workbench writes values into its text, where they can be undone.
    part('original').hidden = loaded.controls.length === 0 || page.store !== null;
    this.#head('change', loaded.controls.length > 0 ? 'change' : 'motion');
    part('hint').textContent = [page.drags('omega') && page.words.of('drag_omega'), page.drags('plane') && page.words.of('drag_plane')]
      .filter(Boolean).join(' ');
  }

  /** Names a section. @param {string} section @param {string} word */
  #head(section, word) {
    const heading = part(`section-${section}`).querySelector('h2');
    if (heading) heading.textContent = this.page.words.of(word);
  }

  /** Puts the words of the language into the drawer. */
  name() {
    const {words} = this.page;
    for (const section of ['change', 'show', 'view', 'save', 'keys']) this.#head(section, section);
    for (const [id, word] of [['original', 'original'], ['scene-view', 'scene_view'], ['save-png', 'save_png'], ['save-svg', 'save_svg'],
      ['copy-link', 'copy_link']]) part(/** @type {string} */ (id)).textContent = words.of(/** @type {string} */ (word));
    for (const [id, word] of [['png-width', 'width'], ['png-height', 'height']]) {
      const label = input(/** @type {string} */ (id)).closest('label')?.querySelector('span');
      if (label) label.textContent = words.of(/** @type {string} */ (word));
    }
    part('options').setAttribute('aria-label', words.of('options'));
    input('link').setAttribute('aria-label', words.of('link'));
    list_keys(part('keys'), words);
    this.#name_themes();
  }

  #name_themes() {
    part('theme').setAttribute('aria-label', this.page.words.of('look'));
    part('theme').replaceChildren(...['', 'light', 'dark'].map((theme) => {
      const label = document.createElement('label');
      const radio = document.createElement('input');
      const text = document.createElement('span');
      radio.type = 'radio';
      radio.name = 'theme';
      radio.value = theme;
      radio.checked = theme === this.page.figure.choices.theme;
      radio.addEventListener('change', () => this.set_theme(theme));
      text.textContent = this.page.words.of(theme || 'of_scene');
      label.append(radio, text);
      return label;
    }));
  }

  /** @param {string} theme */
  set_theme(theme) {
    this.page.address.follows_system = false;
    this.page.reload({theme});
    this.#name_themes();
  }

  toggle_theme() {
    this.set_theme(this.page.figure.loaded && document.documentElement.classList.contains('dark') ? 'light' : 'dark');
  }

  show_elements() {
    const {page} = this;
    const {loaded, choices} = page.figure;
    if (!loaded) return;
    const rows = [{name: '', summary: '', offered: true}, ...loaded.elements].filter((row) => row.offered !== false);
    const boxes = () => [...part('elements').querySelectorAll('input')];
    const names = [page.words.code, ...rows.map((row) => row.name)].join();
    if (names !== this.element_names) {
      this.element_names = names;
      part('elements').replaceChildren(...rows.map(({name, summary}) => {
        const label = document.createElement('label');
        const box = document.createElement('input');
        box.type = 'checkbox';
        box.name = name;
        box.addEventListener('change', () => page.reload(name === '' ? {names: box.checked ? null : false} : {shown: this.#shown_with(name, box.checked)}));
        label.title = summary;
        label.append(box, name === '' ? page.words.of('names') : page.words.element(name));
        return label;
      }));
    }
    for (const box of boxes())
      box.checked = box.name === '' ? choices.names !== false : loaded.elements.some((e) => e.name === box.name && e.shown);
  }

  /** The elements that are shown after one is shown or hidden. @param {string} name @param {boolean} shown */
  #shown_with(name, shown) {
    return (this.page.figure.loaded?.elements ?? []).filter((e) => (e.name === name ? shown : e.shown)).map((e) => e.name);
  }

  async copy_link() {
    const {address, words} = this.page;
    const fault = await this.page.store?.link_fault();
    if (fault) {
      this.page.show_message(new Error(fault));
      return;
    }
    const link = address.link();
    const field = input('link');
    field.value = link;
    try {
      await navigator.clipboard.writeText(link);
      part('copy-link').textContent = words.of('copied');
      window.setTimeout(() => { part('copy-link').textContent = this.page.words.of('copy_link'); }, 1600);
    } catch {
      // Where the clipboard is closed, the viewer copies by hand.
      this.open(true);
      field.hidden = false;
      field.select();
    }
  }

  #save_png() {
    const {page} = this;
    const [width, height] = [input('png-width'), input('png-height')].map((field) => Math.min(16384, Math.max(16, Math.round(field.valueAsNumber) || 1080)));
    page.figure.png(width ?? 1920, height ?? 1080).then((blob) => page.save(blob, '.png'), (error) => page.show_message(error));
  }

  #save_svg() {
    const {page} = this;
    try {
      page.save(new Blob([page.svg()], {type: 'image/svg+xml'}), '.svg');
    } catch (error) {
      page.show_message(error);
    }
  }

  #wire() {
    part('show-options').addEventListener('click', () => this.toggle());
    part('close').addEventListener('click', () => {
      this.open(false);
      part('show-options').focus();
    });
    part('original').addEventListener('click', () => {
      this.page.grips.forget();
      this.page.reload({values: new Map()});
    });
    part('scene-view').addEventListener('click', () => this.page.views.reset());
    part('save-png').addEventListener('click', () => this.#save_png());
    part('save-svg').addEventListener('click', () => this.#save_svg());
    part('copy-link').addEventListener('click', () => void this.copy_link());
  }
}
