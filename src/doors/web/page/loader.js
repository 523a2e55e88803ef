// What the page carries: the scene, its files, the module and the fonts, each in a block of its own.

import {bytes_of_base94, unpacked_lzma} from './unpack.js';

/**
 * @typedef {{name: string, text: string, overrides: string[], files: Record<string, string>, controls: string[],
 *   language: string, width: number, height: number, poster_at_s: number, title: string, n_stops: number, planned_s: number, following: SceneData[]}} SceneData
 *   `following`: the scenes that the page shows after this one.
 */

/** @param {string} text @returns {Uint8Array<ArrayBuffer>} */
export function bytes_of_base64(text) {
  const binary = atob(text.trim());
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

/** The text of a block of data in the page. @param {string} id */
export function block(id) {
  return document.getElementById(id)?.textContent ?? '';
}

/** Unpacks a block of the program. @param {string} id */
export function unpacked(id) {
  return unpacked_lzma(bytes_of_base94(block(id)));
}

/** The texts of several scenes come by `add_texts`. @returns {SceneData} */
export function scene_data() {
  return JSON.parse(block('scene-data'));
}

/** Puts the texts of several scenes into their places. @param {SceneData[]} scenes */
export async function add_texts(scenes) {
  const script = document.getElementById('scene-texts');
  if (!script) return;
  const bytes = bytes_of_base94(script.textContent ?? '').slice(0, Number(script.dataset['bytes']));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  /** @type {string[]} */
  const texts = await new Response(stream).json();
  scenes.forEach((scene, k) => { scene.text = texts[k] ?? ''; });
}
