// Reads ZIP archives: stored and deflated files. Source: PKWARE's APPNOTE 6.3.3, without encryption and ZIP64.

import {message_of} from './figure.js';
import {crc32_of, joined_bytes} from './png_frames.js';

const most_unzipped_bytes = 256e6;
const most_zip_files = 5000;

/**
 * A file that is read when its bytes are needed.
 * @typedef {{name: string, read: () => Promise<Uint8Array<ArrayBuffer>>}} ReadableFile
 */

/** The bytes of a stream, at most so many. @param {ReadableStream<Uint8Array>} stream @param {number} most @returns {Promise<Uint8Array<ArrayBuffer>>} */
export async function bytes_of_stream(stream, most) {
  const parts = [];
  let n = 0;
  const reader = stream.getReader();
  for (;;) {
    const {done, value} = await reader.read();
    if (done) return joined_bytes(parts);
    n += value.length;
    if (n > most) {
      await reader.cancel();
      throw new RangeError('a file in it is larger than its directory says');
    }
    parts.push(value);
  }
}

/**
 * The files of an archive, by the names that it gives them. It throws a sentence without the archive's name, as reading one of them does.
 * @param {Uint8Array<ArrayBuffer>} bytes @returns {ReadableFile[]}
 */
export function files_of_zip(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const damaged = () => new RangeError('the archive is damaged, or is no ZIP archive; make it again');
  const need = (/** @type {boolean} */ holds) => {
    if (!holds) throw damaged();
  };
  // The end of the directory, before which a comment may stand.
  let end = bytes.length - 22;
  while (end >= Math.max(0, bytes.length - 22 - 65535) && view.getUint32(end, true) !== 0x06054b50) --end;
  need(end >= 0 && view.getUint32(end, true) === 0x06054b50);
  const n_files = view.getUint16(end + 10, true);
  let at = view.getUint32(end + 16, true);
  if (n_files > most_zip_files || at === 0xffffffff) throw new RangeError('the archive has too many files, or is larger than 4 GB; unpack it, and drop the files');
  /** @type {ReadableFile[]} */
  const files = [];
  let n_bytes = 0;
  for (let k = 0; k < n_files; ++k) {
    need(at + 46 <= end && view.getUint32(at, true) === 0x02014b50);
    const [flags, method] = [view.getUint16(at + 8, true), view.getUint16(at + 10, true)];
    const [crc, packed, size] = [view.getUint32(at + 16, true), view.getUint32(at + 20, true), view.getUint32(at + 24, true)];
    const [n_name, n_extra, n_comment] = [28, 30, 32].map((place) => view.getUint16(at + place, true));
    const head = view.getUint32(at + 42, true);
    const name = new TextDecoder().decode(bytes.subarray(at + 46, at + 46 + n_name)).replaceAll('\\', '/');
    at += 46 + n_name + n_extra + n_comment;
    // Folders, and what macOS adds.
    if (name.endsWith('/') || name.startsWith('__MACOSX/') || /(^|\/)\./.test(name)) continue;
    if (flags & 1) throw new RangeError(`${name} is encrypted; unpack the archive, and drop the files`);
    if (method !== 0 && method !== 8) throw new RangeError(`${name} is packed by a method that browsers do not have; unpack the archive, and drop the files`);
    n_bytes += size;
    if (n_bytes > most_unzipped_bytes) throw new RangeError('the files in it take more than 256 MB; unpack the archive, and drop those that the scene names');
    need(head + 30 <= bytes.length && view.getUint32(head, true) === 0x04034b50);
    const from = head + 30 + view.getUint16(head + 26, true) + view.getUint16(head + 28, true);
    need(from + packed <= bytes.length);
    const body = bytes.subarray(from, from + packed);
    files.push({name, read: async () => {
      const unpack = () => bytes_of_stream(new Blob([body]).stream().pipeThrough(new DecompressionStream('deflate-raw')), size);
      const file = method === 0 ? body : await unpack().catch(() => { throw damaged(); });
      need(file.length === size && crc32_of(file) === crc);
      return file;
    }});
  }
  // A folder in which all files lie is that of the archive.
  const folder = /^[^/]+\//.exec(files[0]?.name ?? '')?.[0] ?? '';
  const is_shared = folder !== '' && folder !== 'meta/' && files.every(({name}) => name.startsWith(folder));
  return is_shared ? files.map(({name, read}) => ({name: name.slice(folder.length), read})) : files;
}

/** What an action on an archive gives, or its refusal with the archive's name. @template T @param {string} name @param {() => T|Promise<T>} action */
export async function in_archive(name, action) {
  try {
    return await action();
  } catch (error) {
    throw new Error(`${name}: ${message_of(error)}`);
  }
}

/** The table of a recording in an archive: phyphox's of the gyroscope, or the only one. The program says of spreadsheets what to do. @param {ReadableFile[]} files */
export function table_among(files) {
  const tables = files.filter(({name}) => /\.(csv|tsv|txt|xlsx?|ods)$/i.test(name) && !name.startsWith('meta/'));
  return tables.find(({name}) => /gyro/i.test(name)) ?? tables[0];
}

/** @param {Uint8Array} bytes @returns {string} */
export function base64_of_bytes(bytes) {
  let text = '';
  for (let i = 0; i < bytes.length; i += 32768) text += String.fromCharCode(...bytes.subarray(i, i + 32768));
  return btoa(text);
}
