// The film of a page: playing, stops, loops, steps; its words. No browser is needed.
import {execFileSync} from 'node:child_process';
import test from 'node:test';
import assert from 'node:assert/strict';
import fs from 'node:fs';
import {component_of, slider_span, toml_of} from '../../../src/doors/web/page/controls.js';
import {Film} from '../../../src/doors/web/page/film.js';
import {film_qualities} from '../../../src/doors/web/page/film_encoder.js';
import {empty_state, fragment_of, state_of} from '../../../src/doors/web/page/link.js';
import {Words, all_words, element_words, key_words, languages, motion_said} from '../../../src/doors/web/page/words.js';

const stop = (at_s, loop_s = 0) => ({at_s, title: '', loop_s, note: ''});
const film_with = (changes = {}) => new Film({length_s: 10, frames_per_s: 30, loops: false, stops: [], chapters: [], ...changes});
const near = (a, b) => assert.ok(Math.abs(a - b) < 1e-9, `${a} is not ${b}`);

test('plays to the end and stays there', () => {
  const film = film_with();
  film.play();
  for (let i = 0; i < 200; ++i) film.advance(0.1);
  near(film.at_s, 10);
  assert.equal(film.playing, false);
});

test('plays at any speed and backwards', () => {
  const film = film_with();
  film.seek(6);
  film.speed = -2.5;
  film.play();
  film.advance(1);
  near(film.at_s, 3.5);
  film.advance(2);
  near(film.at_s, 0);
  assert.equal(film.playing, false);
});

test('repeats a loop without a jump, in both directions', () => {
  const film = film_with({loops: true});
  film.seek(9.5);
  film.play();
  film.advance(1);
  near(film.at_s, 0.5);
  film.speed = -1;
  film.advance(1);
  near(film.at_s, 9.5);
  assert.equal(film.playing, true);
});

test('repeats if the scene that is read is a loop, and then as the viewer wants', () => {
  const film = film_with();
  film.change({...film.plan, loops: true});
  assert.equal(film.repeat, true);
  film.repeat = false;
  film.change({...film.plan, length_s: 20});
  assert.equal(film.repeat, false);
  film.change({...film.plan, loops: false});
  film.change({...film.plan, loops: true});
  assert.equal(film.repeat, true);
});

test('waits at a stop, and goes on from it', () => {
  const film = film_with({stops: [stop(3), stop(8)]});
  film.play();
  film.advance(5);
  near(film.at_s, 3);
  assert.equal(film.playing, false);
  assert.equal(film.waiting, 0);
  film.next();
  assert.equal(film.playing, true);
  film.advance(1);
  near(film.at_s, 4);
});

test('a step over several stops waits at the first', () => {
  const film = film_with({stops: [stop(1), stop(2)]});
  film.play();
  film.advance(9);
  near(film.at_s, 1);
});

test('repeats a loop until it may go on, and then reaches its seam first', () => {
  const film = film_with({stops: [stop(4, 2)]});
  film.seek(3);
  film.play();
  film.advance(1.5); // 0.5 s past the seam: half a second into the loop
  near(film.at_s, 2.5);
  for (let i = 0; i < 7; ++i) film.advance(0.5);
  near(film.at_s, 2);
  film.next();
  assert.equal(film.leaving, true);
  film.advance(1.75);
  near(film.at_s, 3.75);
  film.advance(0.5);
  near(film.at_s, 4.25);
  assert.equal(film.waiting, -1);
  assert.equal(film.playing, true);
});

test('asked twice, leaves a loop at once', () => {
  const film = film_with({stops: [stop(4, 2)]});
  film.seek(3.9);
  film.play();
  film.advance(0.2);
  film.next();
  film.next();
  near(film.at_s, 4);
  assert.equal(film.waiting, -1);
});

test('turned backwards and forwards, keeps the loop', () => {
  const film = film_with({stops: [stop(4, 2)]});
  film.seek(3.9);
  film.play();
  film.advance(0.2);
  film.toggle();
  film.speed = -1;
  film.advance(0.1);
  film.speed = 1;
  for (let i = 0; i < 40; ++i) film.advance(0.1);
  assert.ok(film.is_looping && film.at_s < 4);
});

test('waits at stops just after the seam of a repeated film', () => {
  for (const at_s of [0, 0.02]) {
    const film = film_with({loops: true, stops: [stop(at_s)]});
    film.seek(9.99);
    film.play();
    film.advance(0.1);
    near(film.at_s, at_s);
    assert.equal(film.playing, false);
    film.next();
    film.advance(1);
    near(film.at_s, at_s + 1);
  }
});

test('a stop at the end of the film waits there', () => {
  const film = film_with({stops: [stop(10)]});
  film.play();
  film.advance(20);
  assert.equal(film.waiting, 0);
  near(film.at_s, 10);
});

test('backwards, stops do not hold', () => {
  const film = film_with({stops: [stop(3)]});
  film.seek(5);
  film.speed = -1;
  film.play();
  film.advance(4);
  near(film.at_s, 1);
});

test('without stops, the key of the next one plays from the beginning to the end', () => {
  const film = film_with();
  film.at_s = 6; // its still, where nobody has moved it yet
  film.next();
  assert.equal(film.playing, true);
  near(film.at_s, 0);
  for (let i = 0; i < 120; ++i) film.advance(0.1);
  assert.equal(film.is_over, true);
  film.next();
  assert.equal(film.is_over, true, 'the page opens what follows');
  film.seek(4);
  film.next();
  film.advance(1);
  near(film.at_s, 5);
  film.next();
  assert.equal(film.is_over, true, 'pressed while it plays, it goes to the end');
  const chapters = film_with({loops: true, chapters: [{at_s: 0, title: ''}, {at_s: 4, title: ''}]});
  chapters.next();
  chapters.advance(1);
  chapters.next();
  near(chapters.at_s, 4);
  assert.equal(chapters.playing, true);
  chapters.next();
  assert.equal(chapters.is_over, true, 'also where it would repeat');
});

test('steps through stops, chapters or the ends', () => {
  const film = film_with({stops: [stop(3), stop(8, 2)]});
  film.seek(5);
  film.previous();
  near(film.at_s, 3);
  film.seek(5);
  film.next();
  near(film.at_s, 8);
  assert.equal(film.playing, true); // it loops
  const chapters = film_with({chapters: [{at_s: 0, title: ''}, {at_s: 4, title: ''}]});
  chapters.seek(1);
  chapters.next();
  near(chapters.at_s, 4);
  chapters.next();
  near(chapters.at_s, 10);
  chapters.to_chapter(2);
  near(chapters.at_s, 4);
  chapters.to_chapter(9); // there is none
  near(chapters.at_s, 4);
  chapters.to_chapter(0);
  near(chapters.at_s, 0);
});

test('steps by frames stay on frames', () => {
  const film = film_with({frames_per_s: 24});
  film.seek(1.01);
  film.step(1);
  near(film.at_s, 25 / 24);
  for (let i = 0; i < 24; ++i) film.step(1);
  near(film.at_s, 49 / 24);
  film.step(-1);
  near(film.at_s, 2);
  film.seek(0);
  film.step(-1);
  near(film.at_s, 0);
});

test('the space bar plays, pauses and goes on', () => {
  const film = film_with({stops: [stop(4, 1)]});
  film.toggle();
  assert.equal(film.playing, true);
  film.toggle();
  assert.equal(film.playing, false);
  film.toggle();
  film.advance(4.5);
  assert.equal(film.is_looping, true);
  film.toggle();
  assert.equal(film.leaving, true);
});

test('a motion under a torque says when the body turns over', () => {
  const words = new Words('en');
  const said = (flips) => motion_said({flips, polhode_axis: null}, words);
  assert.equal(said({one_s: 1.27027, interval_s: null, times_s: [1.27027, 5.58201]}), 'The body turns over at 1.27; 5.58 s.');
  assert.equal(said({one_s: 2, interval_s: null, times_s: [2]}), 'The body turns over once, at 2 s.');
  assert.equal(said({one_s: 1, interval_s: null, times_s: [1, 2, 3, 4, 5]}), 'The body turns over at 1; 2; 3; 4; … s.');
  assert.equal(said({one_s: 1, interval_s: 3.5}), 'The body turns over every 3.5 s.');
});

// `node film_test.mjs PROGRAM`
const listed = (what) => execFileSync(process.argv[2], ['list', what], {encoding: 'utf8'}).trim().split('\n').map((line) => line.split(/\s+/)[0]);

test('every element and overlay of the program has its words', () => {
  assert.deepEqual(Object.keys(element_words).sort(), [...listed('elements'), ...listed('overlays')].sort());
});

test('the fields of a film and a picture stay within the scene\'s keys, and offer each quality', () => {
  assert.deepEqual(Object.keys(film_qualities), listed('qualities'));
  const keys = JSON.parse(execFileSync(process.argv[2], ['list', 'schema'], {encoding: 'utf8'})).properties.film.properties;
  const page = fs.readFileSync(new URL('../../../src/doors/web/page/index.html', import.meta.url), 'utf8');
  const largest_film = Number(/at most (\d+) for a film/.exec(keys.size.description)[1]);
  const sizes = {...keys.size.anyOf[0].items, maximum: largest_film};
  for (const [id, {minimum, maximum}] of Object.entries({'film-width': sizes, 'film-height': sizes, 'png-width': sizes,
    'png-height': sizes, 'film-rate': keys.fps.anyOf[0]})) {
    const [, min, max] = new RegExp(`id="${id}" type="number" min="([\\d.]+)" max="([\\d.]+)"`).exec(page);
    assert.ok(minimum <= Number(min) && Number(min) < Number(max) && Number(max) <= maximum, id);
  }
});

test('the languages are those of the program', () => {
  const header = fs.readFileSync(new URL('../../../src/base/text/languages.h', import.meta.url), 'utf8');
  const codes = /language_codes\{(.*)\}/.exec(header)[1];
  assert.deepEqual(JSON.parse(`[${codes}]`), [...languages]);
});

// Of body, start, torque and method every key can be a slider or a field of the page.
test('every key of the motion has a label', () => {
  const schema = JSON.parse(execFileSync(process.argv[2], ['list', 'schema'], {encoding: 'utf8'}));
  const without = [];
  const visit = (properties, path) => {
    for (const [name, value] of Object.entries(properties)) {
      const inside = value.properties ?? value.items?.properties;
      if (inside !== undefined) visit(inside, `${path}${name}.`);
      else if (new Words('en').label(`${path}${name}`) === undefined) without.push(`${path}${name}`);
    }
  };
  for (const table of ['body', 'start', 'torque', 'motion', 'beside', 'construction']) visit(schema.properties[table].properties, `${table}.`);
  assert.deepEqual(without, []);
});

test('every word has six languages', () => {
  for (const [name, words] of [all_words, element_words, key_words].flatMap((table) => Object.entries(table))) {
    assert.equal(words.length, languages.length, name);
    for (const word of words) assert.ok(word.trim().length > 0, name);
  }
  assert.equal(new Words('de').of('play'), 'Abspielen');
  assert.equal(new Words('xx').of('play'), 'Play');
});

test('a link gives back the state', () => {
  const state = {...empty_state(), at_s: 3.25, speed: -0.5, theme: 'dark', names: false, shown: ['plane', 'omega'],
    views: [{panel: 2, azimuth_deg: -12.5, zoom: 2}], values: new Map([['start.omega_rad_s', '[1.0, 2.0, 0.5]']])};
  assert.equal(state_of(`#at=2&show=${'omega,'.repeat(4000)}`).at_s, null, 'a fragment that no page writes');
  const again = state_of('#' + fragment_of(state));
  assert.deepEqual(JSON.parse(JSON.stringify({...again, values: [...again.values]})),
    JSON.parse(JSON.stringify({...state, values: [...state.values]})));
});

test('a broken link is an empty one', () => {
  for (const text of ['', '#', '#at=x&view=a,b&view=-1,3&set=nothing&theme=<b>&speed=0', '#%E0%A4%A']) {
    const state = state_of(text);
    assert.equal(state.at_s, null);
    assert.equal(state.views.length, 0);
    assert.equal(state.values.size, 0);
    assert.equal(state.theme, '');
    assert.equal(state.speed, 1);
  }
});

test('sliders reach from bound to bound, or to three times the value', () => {
  const span = (min, max, value, size) => {
    const {least, most} = slider_span({min, max, size}, value);
    return [least, most];
  };
  assert.deepEqual(span(null, null, 0, 2), [-6, 6]);
  assert.deepEqual(span(null, null, 0), [-3, 3]);
  assert.deepEqual(span(null, null, -5), [-15, 15]);
  assert.deepEqual(span(0, null, 2), [0, 6]);
  assert.deepEqual(span(-90, 90, 0.01), [-90, 90]);
  assert.deepEqual(span(0, Math.PI, 0), [0, Math.PI]);
  assert.deepEqual(span(1e-12, 1e12, 1), [1e-12, 3 + 1e-12]);
  const omega = {key: 'start.omega_rad_s', label: '', unit: '', kind: 'vector', value: [0, -2, 0], min: null, max: null, step: null};
  for (const key of [omega.key, `${omega.key}[0]`]) assert.equal(component_of({...omega, key}, new Words('en')).size, 2);
});

test('values become TOML', () => {
  assert.equal(toml_of([1, 2.5, -3e-9]), '[1.0, 2.5, -3e-9]');
  assert.equal(toml_of(true), 'true');
});
