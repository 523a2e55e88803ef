// The keys of a page: one table, from which the page acts and lists its keys.

/** @import {Page} from './page.js' */
/** @import {Views} from './view.js' */
/** @import {Words} from './words.js' */

/**
 * Keys with one meaning. `modifier`: held with them. An action that returns false leaves its key to the page around this one.
 * @typedef {{word: string, modifier?: 'Shift'|'Alt', keys: Record<string, (page: Page) => boolean|void>}} KeyRow
 */

/** One action for each arrow, by its direction to the right and up; it needs a panel with a view. @param {(views: Views, panel: number, right: number, up: number) => void} act @returns {KeyRow['keys']} */
function arrows(act) {
  const by = (/** @type {number} */ right, /** @type {number} */ up) => (/** @type {Page} */ {views}) => {
    const panel = views.active();
    if (panel < 0) return false;
    act(views, panel, right, up);
    return true;
  };
  return {ArrowLeft: by(-1, 0), ArrowUp: by(0, 1), ArrowRight: by(1, 0), ArrowDown: by(0, -1)};
}

/** @param {number} factor @returns {(page: Page) => void} */
function zoom_by(factor) {
  return ({views}) => {
    if (views.active() >= 0) views.zoom(views.active(), factor);
  };
}

/** @type {KeyRow[]} */
export const key_rows = [
  {word: 'key_play', keys: {' ': ({figure}) => figure.film.toggle()}},
  {word: 'key_frame', keys: {ArrowLeft: ({figure}) => figure.film.step(-1), ArrowRight: ({figure}) => figure.film.step(1)}},
  {word: 'key_stop', keys: {
    PageUp: (page) => page.previous(), PageDown: (page) => page.next(), ArrowUp: (page) => page.previous(), ArrowDown: (page) => page.next()}},
  {word: 'key_ends', keys: {Home: ({figure}) => figure.film.seek(0), End: ({figure}) => figure.film.seek(figure.film.plan.length_s)}},
  {word: 'key_digits', keys: Object.fromEntries([0, 1, 2, 3, 4, 5, 6, 7, 8, 9].map((n) => [n, (/** @type {Page} */ {figure}) => figure.film.to_chapter(n)]))},
  {word: 'key_speed', keys: {'[': ({bar}) => bar.shift_speed(-1), ']': ({bar}) => bar.shift_speed(1)}},
  {word: 'backwards', keys: {j: ({bar, figure}) => bar.set_speed(-figure.film.speed)}},
  // Presenters' remotes and slide programs have the point and the comma.
  {word: 'key_blank', keys: {
    b: (page) => page.blank('black'), w: (page) => page.blank('white'), '.': (page) => page.blank('black'), ',': (page) => page.blank('white')}},
  {word: 'repeat', keys: {r: ({figure}) => { figure.film.repeat = !figure.film.repeat; }}},
  {word: 'key_turn', modifier: 'Shift', keys: arrows((views, panel, right, up) => views.turn(panel, 5 * right, 5 * up))},
  {word: 'key_pan', modifier: 'Alt', keys: arrows((views, panel, right, up) => views.pan(panel, 0.04 * right, 0.04 * up))},
  {word: 'key_zoom', keys: {'+': zoom_by(1.15), '-': zoom_by(1 / 1.15)}},
  {word: 'scene_view', keys: {c: ({views}) => views.reset()}},
  {word: 'full_screen', keys: {f: ({bar}) => bar.full_screen()}},
  {word: 'look', keys: {t: ({options}) => options.toggle_theme()}},
  {word: 'notes', keys: {n: ({notes}) => notes.toggle()}},
  {word: 'copy_link', keys: {l: ({options}) => void options.copy_link()}},
  {word: 'options', keys: {o: ({options}) => options.toggle()}},
];

/** The action of a key; undefined: it is none of the page. @param {{key: string, shiftKey: boolean, altKey: boolean}} event */
export function action_of({key, shiftKey, altKey}) {
  // "=" is "+" without Shift.
  const name = key === '=' ? '+' : key.length === 1 ? key.toLowerCase() : key;
  // Other keys need Shift on some keyboards.
  const modifier = shiftKey && name.startsWith('Arrow') ? 'Shift' : altKey ? 'Alt' : undefined;
  return key_rows.find((row) => row.modifier === modifier && Object.hasOwn(row.keys, name))?.keys[name];
}

const caps = /** @type {Record<string, string>} */ ({' ': 'Space', PageUp: 'Page ↑', PageDown: 'Page ↓', ArrowLeft: '←', ArrowUp: '↑', ArrowRight: '→', ArrowDown: '↓', '-': '−'});

/** What stands on the keys of a row: many keys as the first and the last, arrows with a modifier together. @param {KeyRow} row @returns {string[]} */
export function caps_of({modifier, keys}) {
  const all = Object.keys(keys).map((key) => caps[key] ?? (key.length === 1 ? key.toUpperCase() : key));
  if (modifier) return [modifier, all.join(' ')];
  return all.length > 4 ? [all[0] ?? '', '…', all[all.length - 1] ?? ''] : all;
}

/** Lists the keys of the page. @param {HTMLElement} list @param {Words} words */
export function list_keys(list, words) {
  list.replaceChildren(...key_rows.flatMap((row) => {
    const term = document.createElement('dt');
    for (const text of caps_of(row)) {
      const cap = document.createElement('kbd');
      cap.textContent = text;
      term.append(cap, ' ');
    }
    const meaning = document.createElement('dd');
    meaning.textContent = words.of(row.word);
    return [term, meaning];
  }));
}

/** Whether a key belongs to the field, button or slider that has the focus. @param {KeyboardEvent} event */
export function is_for_field(event) {
  const target = event.target instanceof HTMLElement ? event.target : null;
  if (!target) return false;
  return target.matches('input[type=number], input[type=text], textarea, select')
    || (target.matches('button, input[type=checkbox], input[type=radio]') && [' ', 'Enter'].includes(event.key))
    || (target.matches('input[type=range]:not(#scrub), input[type=radio]') && /^(Arrow|Home|End|Page)/.test(event.key));
}
