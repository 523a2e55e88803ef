// The file of a film: Mediabunny writes packets and captions; chapters, hashes and the record are written here.

import {block, unpacked} from './loader.js';
import {joined_bytes} from './png_frames.js';
/** @import {FilmCodec, FilmShape} from './film_encoder.js' */

/**
 * @typedef {{data: Uint8Array<ArrayBuffer>, type: EncodedVideoChunkType, about: EncodedVideoChunkMetadata|undefined, alpha?: Uint8Array<ArrayBuffer>}} FilmPacket
 * @typedef {{title: string, first_frame: number, end_frame: number}} FilmChapter
 * @typedef {{language: string, chapters: FilmChapter[], captions: string}} FilmTexts
 *   A language of ISO 639-2; captions as WebVTT, or ''.
 * @typedef {{packets: string, file: string}} FilmHashes
 *   Of the packets, and of the file around the record; see src/outputs/encoding/film_packets.h and film_file_hash.h.
 * @typedef {{kind: 'mp4'|'webm', codec: FilmCodec, shape: FilmShape, texts: FilmTexts, record: (hashes: FilmHashes) => string}} FilmContents
 * @typedef {{write: (chunk: any) => Promise<void>, close: () => Promise<void>, abort: () => Promise<void>}} FileSink
 */

/** The writer of films, which the page unpacks when it is first needed. @type {any} */
let film_writer = null;

/** Whether the page carries it. */
export function has_film_writer() {
  return block('film-writer') !== '';
}

/** Its script is one of those that the page's policy allows. */
export async function load_film_writer() {
  if (film_writer) return;
  const script = document.createElement('script');
  script.textContent = new TextDecoder().decode(await unpacked('film-writer'));
  document.head.append(script);
  script.remove();
  film_writer = /** @type {any} */ (globalThis).film_writer;
  if (!film_writer) throw new Error('this page may not run its film writer');
}

export const utf8 = (/** @type {string} */ text) => new TextEncoder().encode(text);

/** @param {Uint8Array<ArrayBuffer>} bytes */
export async function sha256_of(bytes) {
  const digest = new Uint8Array(await crypto.subtle.digest('SHA-256', bytes));
  return Array.from(digest, (byte) => byte.toString(16).padStart(2, '0')).join('');
}

/** A number of so many bytes, the highest first. @param {number} value @param {number} n_bytes */
function number_bytes(value, n_bytes) {
  const bytes = new Uint8Array(n_bytes);
  for (let k = n_bytes; k-- > 0; value = Math.floor(value / 256)) bytes[k] = value % 256;
  return bytes;
}

/** The hash of a film's packets, as src/outputs/encoding/film_packets.h has it. */
class PacketHash {
  constructor() {
    /** @type {Uint8Array[]} */
    this.parts = [];
    this.n_packets = 0;
    this.list = '';
  }

  /** @param {Uint8Array} packet @param {Uint8Array} [alpha] */
  async add(packet, alpha) {
    this.parts.push(number_bytes(packet.length, 8), packet);
    // FFmpeg puts the number of the addition before it.
    if (alpha) this.parts.push(number_bytes(alpha.length + 8, 8), number_bytes(1, 8), alpha);
    if (++this.n_packets % 120 === 0) await this.#end();
  }

  async finish() {
    if (this.parts.length > 0) await this.#end();
    return sha256_of(utf8(this.list));
  }

  async #end() {
    const parts = this.parts;
    this.parts = [];
    this.list += `${await sha256_of(joined_bytes(parts))}\n`;
  }
}

/** Where bytes stand in others; -1 if they do not. @param {Uint8Array} bytes @param {Uint8Array} sought */
function place_of(bytes, sought) {
  const first = /** @type {number} */ (sought[0]);
  for (let at = bytes.indexOf(first); at >= 0; at = bytes.indexOf(first, at + 1))
    if (sought.every((byte, k) => bytes[at + k] === byte)) return at;
  return -1;
}

// Chapters take the place of a tag that Mediabunny writes as the last one, so that nothing else moves.

/** Written at once: small, so that a full disk is noticed early. */
const chunk_bytes = 1 << 20;

/** The box counts them in a byte. */
export const most_mp4_chapters = 255;

/** The box of an MP4 film's chapters, as FFmpeg and Nero write it. @param {FilmChapter[]} chapters @param {number} frame_s */
function mp4_chapters(chapters, frame_s) {
  const rows = chapters.slice(0, most_mp4_chapters).flatMap(({title, first_frame}) => {
    let name = utf8(title).subarray(0, 255);
    // Ends between characters.
    while (name.length > 0 && new TextDecoder().decode(name).endsWith('\ufffd')) name = name.subarray(0, -1);
    return [number_bytes(Math.round(1e7 * first_frame * frame_s), 8), Uint8Array.of(name.length), name];
  });
  const body = joined_bytes([utf8('chpl'), Uint8Array.of(1, 0, 0, 0, 0, 0, 0, 0, Math.min(chapters.length, most_mp4_chapters)), ...rows]);
  return joined_bytes([number_bytes(body.length + 4, 4), body]);
}

/**
 * Where the tags of an MP4 film begin and end, with chapters in the place of the last one. Source: ISO/IEC 14496-12 §4.2.
 * @param {Uint8Array<ArrayBuffer>} bytes boxes, "moov" among them @param {Uint8Array|null} chapters @returns {[number, number]}
 */
function mp4_tags(bytes, chapters) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const box_in = (/** @type {number} */ from, /** @type {number} */ to, /** @type {string} */ name) => {
    for (let at = from; at + 8 <= to; at += view.getUint32(at))
      if (String.fromCharCode(...bytes.subarray(at + 4, at + 8)) === name) return {at, end: at + view.getUint32(at)};
    throw new Error(`the film has no ${name}`);
  };
  const moov = box_in(0, bytes.length, 'moov');
  const udta = box_in(moov.at + 8, moov.end, 'udta');
  const meta = box_in(udta.at + 8, udta.end, 'meta');
  const ilst = box_in(meta.at + 8, meta.end, 'ilst');
  if (chapters) {
    for (const {at, end} of [meta, ilst]) view.setUint32(at, end - at - chapters.length);
    bytes.set(chapters, udta.end - chapters.length);
  }
  return [udta.at, udta.end];
}

/** An element of EBML; its size has four bytes. @param {number[]} id @param {Uint8Array[]} parts */
function ebml_element(id, ...parts) {
  const body = joined_bytes(parts);
  return joined_bytes([Uint8Array.from(id), number_bytes(body.length + 0x10000000, 4), body]);
}

/** The chapters of a WebM film. Source: RFC 9559 §5.1.7. @param {FilmChapter[]} chapters @param {number} frame_s */
function webm_chapters(chapters, frame_s) {
  const ns = (/** @type {number} */ frame) => number_bytes(Math.round(1e9 * frame * frame_s), 8);
  return ebml_element([0x10, 0x43, 0xa7, 0x70], ebml_element([0x45, 0xb9], ...chapters.map(({title, first_frame, end_frame}, k) =>
    ebml_element([0xb6], ebml_element([0x73, 0xc4], number_bytes(k + 1, 4)), ebml_element([0x91], ns(first_frame)),
      ebml_element([0x92], ns(end_frame)), ebml_element([0x80], ebml_element([0x85], utf8(title)), ebml_element([0x43, 0x7c], utf8('und')))))));
}

/**
 * The same as `mp4_tags` for a WebM film. Source: RFC 8794.
 * @param {Uint8Array<ArrayBuffer>} bytes from the segment or before it, up to the first cluster at least
 * @param {Uint8Array|null} chapters shorter than the last tag @returns {[number, number]}
 */
function webm_tags(bytes, chapters) {
  /** A number of variable length, and where it ends. @param {number} at @param {boolean} with_mark @returns {[number, number]} */
  const number_at = (at, with_mark) => {
    const first = bytes[at] ?? 0;
    const n = Math.clz32(first) - 23;
    let value = with_mark ? first : first & (0xff >> n);
    for (let k = 1; k < n; ++k) value = 256 * value + (bytes[at + k] ?? 0);
    return [value, at + n];
  };
  const element_at = (/** @type {number} */ at) => {
    const [id, size_at] = number_at(at, true);
    const [size, body] = number_at(size_at, false);
    return {at, id, size_at, body, end: body + size};
  };
  const child = (/** @type {number} */ from, /** @type {number} */ id) => {
    let element = element_at(from);
    while (element.id !== id) element = element_at(element.end);
    return element;
  };
  const tags = child(child(0, 0x18538067).body, 0x1254c367);
  const tag = child(tags.body, 0x7373);
  let last = element_at(tag.body);
  while (last.end < tag.end) last = element_at(last.end);
  if (chapters) {
    const gap = last.end - last.at - chapters.length;
    for (const {size_at, body, end} of [tags, tag]) {
      const n = body - size_at;
      bytes.set(number_bytes(end - body - (last.end - last.at) + 2 ** (7 * n), n), size_at);
    }
    // An empty element fills the rest.
    bytes.set(joined_bytes([chapters, Uint8Array.of(0xec, 0x80 + gap - 2), new Uint8Array(gap - 2)]), last.at);
  }
  return [tags.at, tags.end];
}

/** One film. Packets are added in the order in which the file stores them. */
export class FilmFile {
  /** @param {FilmContents} contents @param {FileSink|null} sink null: the film stays in memory */
  constructor(contents, sink) {
    const {kind, codec, shape, texts} = contents;
    this.contents = contents;
    this.sink = sink;
    this.frame_s = shape.denominator / shape.numerator;
    this.hash = new PacketHash();
    /** What holds the tags, and where it stands in the file. @type {{bytes: Uint8Array<ArrayBuffer>, at: number}|null} */
    this.head = null;
    const keep_head = (/** @type {Uint8Array<ArrayBuffer>} */ bytes, /** @type {number} */ at) => { this.head = {bytes: bytes.slice(), at}; };
    const chunks = {write: (/** @type {any} */ chunk) => /** @type {FileSink} */ (sink).write(chunk)};
    this.target = sink ? new film_writer.StreamTarget(new WritableStream(chunks), {chunked: true, chunkSize: chunk_bytes}) : new film_writer.BufferTarget();
    const format = kind === 'webm' ? new film_writer.WebMOutputFormat({onSegmentHeader: keep_head})
      : new film_writer.Mp4OutputFormat({fastStart: sink ? false : 'in-memory', metadataFormat: 'mdta', onMoov: keep_head});
    this.output = new film_writer.Output({format, target: this.target});
    this.source = new film_writer.EncodedVideoPacketSource(codec.codec);
    this.output.addVideoTrack(this.source, {frameRate: 1 / this.frame_s, languageCode: texts.language});
    this.captions = texts.captions ? new film_writer.TextSubtitleSource('webvtt') : null;
    // Players show them on request: the picture has them already.
    if (this.captions) this.output.addSubtitleTrack(this.captions, {languageCode: texts.language, disposition: {default: false}});
    this.chapters = texts.chapters.length === 0 ? null : (kind === 'webm' ? webm_chapters : mp4_chapters)(texts.chapters, this.frame_s);
    const none = '0'.repeat(64);
    /** A record without the hashes. */
    this.blank = utf8(contents.record({packets: none, file: sink ? '' : none}));
    this.output.setMetadataTags({raw: {poinsot: new TextDecoder().decode(this.blank),
      // In MP4, the head of a tag takes 24 bytes.
      ...(this.chapters && {chapters: new Uint8Array(this.chapters.length - (kind === 'webm' ? 0 : 24))})}});
  }

  async start() {
    await this.output.start();
    if (!this.captions) return;
    await this.captions.add(this.contents.texts.captions);
    this.captions.close();
  }

  /** @param {number} index of the frame @param {FilmPacket} packet */
  async add(index, {data, type, about, alpha}) {
    await this.hash.add(data, alpha);
    const side = alpha ? {alpha} : {};
    await this.source.add(new film_writer.EncodedPacket(data, type, index * this.frame_s, this.frame_s, -1, data.length, side), about);
  }

  /** The whole film, if it is in memory. @returns {Promise<Uint8Array<ArrayBuffer>|null>} */
  async finish() {
    const {kind, record} = this.contents;
    await this.output.finalize();
    const head = this.sink ? this.head : {bytes: new Uint8Array(this.target.buffer), at: 0};
    if (!head) throw new Error('the film has no head');
    const {bytes} = head;
    const [from, to] = (kind === 'webm' ? webm_tags : mp4_tags)(bytes, this.chapters);
    const at = place_of(bytes, this.blank);
    const after = at + this.blank.length;
    const packets = await this.hash.finish();
    if (this.sink) {
      bytes.set(utf8(record({packets, file: ''})), at);
      await this.sink.write({type: 'write', position: head.at + from, data: bytes.slice(from, to)});
      return null;
    }
    const file = await sha256_of(joined_bytes([bytes.subarray(0, at), bytes.subarray(after)]));
    bytes.set(utf8(record({packets, file})), at);
    return bytes;
  }

  async cancel() {
    await this.output.cancel().catch(() => {});
  }
}
