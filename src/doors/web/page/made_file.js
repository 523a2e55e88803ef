// The scene in a file that poinsot made: a picture, film or figure by its record, a page by its data. The record is that of
// src/outputs/production/records/record.h.

/**
 * @typedef {{text: string, name: string, overrides: string[], files: Record<string, string>, time_s: number|null}} MadeScene
 *   `name`: of the scene; `overrides`: "key=value"; `files`: as base64; `time_s`: the instant of a still.
 */

/** Whether a file of such a name may hold a scene. @param {string} name */
export function may_hold_scene(name) {
  return /\.(png|mp4|m4v|mov|webm|gif|pdf|svg|html?)$/i.test(name);
}

/** The text in the metadata of a file; '': there is none of poinsot. @param {Uint8Array} bytes */
export function record_in(bytes) {
  // One letter a byte; the first 128, and those from 0xa0 on, are themselves.
  const letters = new TextDecoder('latin1').decode(bytes);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const utf8 = (/** @type {number} */ from, /** @type {number} */ to) => new TextDecoder().decode(bytes.subarray(from, to));
  const after = (/** @type {string} */ opening) => {
    const at = letters.lastIndexOf(opening);
    return at < 0 ? -1 : at + opening.length;
  };
  if (letters.slice(1, 4) === 'PNG') {
    const opening = 'iTXtpoinsot\0\0\0\0\0';
    const at = after(opening);
    return at < 0 ? '' : utf8(at, at - opening.length + 4 + view.getUint32(at - opening.length - 4));
  }
  if (letters.startsWith('GIF8')) {
    // Blocks of at most 255 bytes, each after its length; one of 0 ends the comment (GIF89a §24).
    /** @type {number[]} */
    const text = [];
    for (let at = after('!\u00fe\u00ffpoinsot ') - 9; at > 0 && bytes[at]; at += 1 + Number(bytes[at])) text.push(...bytes.subarray(at + 1, at + 1 + Number(bytes[at])));
    return new TextDecoder().decode(Uint8Array.from(text));
  }
  if (letters.startsWith('%PDF')) {
    /** @type {number[]} */
    const text = [];
    const from = after('/Creator (poinsot)\n/Poinsot (\u00ef\u00bb\u00bf');
    for (let at = from; at >= 0 && at < bytes.length && letters[at] !== ')'; ++at) {
      const is_escape = letters[at] === '\\';
      if (is_escape) ++at;
      text.push(is_escape && letters[at] === 'r' ? 13 : Number(bytes[at]));
    }
    return new TextDecoder().decode(Uint8Array.from(text));
  }
  if (letters.slice(4, 8) === 'ftyp') {
    // A box "data" of UTF-8 or without a kind (QuickTime File Format, "Metadata"): length, name, kind, language.
    for (let at = letters.indexOf('poinsot '); at >= 0; at = letters.indexOf('poinsot ', at + 1))
      if (letters.slice(at - 12, at - 8) === 'data') return utf8(at, at - 16 + view.getUint32(at - 16));
    return '';
  }
  if (bytes[0] === 0x1a && letters.slice(1, 2) === 'E') {
    // A TagString, 0x4487, with its length in as many bytes as the first one says (RFC 9559, §5.1.8; RFC 8794, §4).
    for (let at = letters.indexOf('poinsot '); at >= 0; at = letters.indexOf('poinsot ', at + 1)) {
      for (let n = 1; n <= 8; ++n) {
        const from = at - n;
        if (bytes[from - 2] !== 0x44 || bytes[from - 1] !== 0x87 || Math.clz32(Number(bytes[from])) - 23 !== n) continue;
        const length = bytes.subarray(from, at).reduce((sum, byte, k) => sum * 256 + (k === 0 ? byte & (0xff >> n) : byte), 0);
        return utf8(at, at + length);
      }
    }
    return '';
  }
  const svg = /<metadata id="poinsot">([^<]*)<\/metadata>/.exec(letters);
  if (!svg) return '';
  const from = svg.index + svg[0].indexOf('>') + 1;
  const unescaped = /** @type {Record<string, string>} */ ({lt: '<', gt: '>', quot: '"', apos: "'", amp: '&'});
  return utf8(from, from + (svg[1] ?? '').length).replace(/&(lt|gt|quot|apos|amp);/g, (_, name) => unescaped[name] ?? '');
}

/** The scene of a file; null: poinsot did not make it. @param {Uint8Array} bytes @returns {MadeScene|null} */
export function made_scene(bytes) {
  const start = new TextDecoder().decode(bytes.subarray(0, 200));
  if (/^\s*<!doctype html/i.test(start)) {
    const data = /<script\b[^>]*\bid="?scene-data"?[^>]*>([^<]*)<\/script>/.exec(new TextDecoder().decode(bytes))?.[1];
    try {
      const {text, name, overrides, files} = JSON.parse(data ?? '');
      return typeof text === 'string' ? {text, name: String(name), overrides, files, time_s: null} : null;
    } catch {
      return null;
    }
  }
  const record = record_in(bytes);
  const end = record.indexOf('\n\n');
  if (!/^poinsot \d/.test(record) || end < 0) return null;
  const field = (/** @type {string} */ key) => new RegExp(`^${key}: (.*)$`, 'm').exec(record.slice(0, end))?.[1] ?? '';
  const time_s = Number.parseFloat(field('time_s'));
  return {text: record.slice(end + 2), name: field('scene'), overrides: [], files: {}, time_s: Number.isFinite(time_s) ? time_s : null};
}
