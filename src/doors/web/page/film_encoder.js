// The encoder of a film: which of the browser's codecs, and how many bits. No page and no drawing.

import {message_of} from './figure.js';
import {joined_bytes} from './png_frames.js';
/** @import {FilmFile, FilmPacket} from './film_file.js' */

/**
 * @typedef {'mp4'|'webm'|'png'|'slides'|'pptx'} FilmKind
 * @typedef {{width: number, height: number, numerator: number, denominator: number}} FilmShape
 *   Pixels, and the frames a second as a fraction.
 * @typedef {{config: VideoEncoderConfig, codec: string, name: string}} FilmCodec
 *   `codec`: as Mediabunny calls it; `name`: as people do.
 */

/** A key frame at least this often, so that players can jump. */
const key_frame_every_s = 2;
/** Frames that the encoder may be behind. */
const most_waiting_frames = 4;

/** Frames from one key frame to the next. @param {FilmShape} shape */
export function key_frame_interval({numerator, denominator}) {
  return Math.max(1, Math.round((key_frame_every_s * numerator) / denominator));
}

/**
 * Bits for a frame of one pixel, by the names of `poinsot list qualities`. A larger frame takes more of them by the power 0.8 of its
 * pixels, as lines grow less than areas.
 */
export const film_qualities = /** @type {Record<string, number>} */ ({draft: 1.6, lecture: 4, print: 6, reference: 12});

/** @param {string} quality @param {FilmShape} shape @returns {number} bits a second */
export function bitrate_of(quality, {width, height, numerator, denominator}) {
  return Math.round(((film_qualities[quality] ?? 4) * (width * height) ** 0.8 * numerator) / denominator);
}

/** The level of H.264 as two hexadecimal digits. Source: Rec. ITU-T H.264, table A-1. @param {FilmShape} shape */
function avc_level(shape) {
  const blocks = Math.ceil(shape.width / 16) * Math.ceil(shape.height / 16);
  const blocks_a_second = (blocks * shape.numerator) / shape.denominator;
  /** @type {[string, number, number][]} */
  const levels = [['1e', 1620, 40500], ['1f', 3600, 108000], ['28', 8192, 245760], ['2a', 8704, 522240], ['32', 22080, 589824],
    ['33', 36864, 983040], ['34', 36864, 2073600], ['3c', 139264, 4177920]];
  return (levels.find(([, most, most_a_second]) => blocks <= most && blocks_a_second <= most_a_second) ?? ['3e'])[0];
}

/** The codecs of a kind of film, the best first. @param {FilmKind} kind @param {FilmShape} shape @returns {[string, string, string][]} */
function codecs_of(kind, shape) {
  /** @type {[string, string, string]} */
  const vp9 = ['vp09.00.51.08', 'vp9', 'VP9'];
  if (kind === 'webm') return [vp9];
  const level = avc_level(shape);
  // From the high profile to the baseline.
  const avc = ['6400', '4d00', '42e0'].map((profile) => /** @type {[string, string, string]} */ ([`avc1.${profile}${level}`, 'avc', 'H.264']));
  return [...avc, vp9, ['av01.0.13M.08', 'av1', 'AV1']];
}

/** @type {VideoColorSpaceInit} */
const film_colours = {primaries: 'bt709', transfer: 'bt709', matrix: 'bt709', fullRange: false};

/** @param {FilmShape} shape @param {number} index @param {Uint8Array} planes Y', Cb and Cr of BT.709, limited range, 4:2:0 */
function video_frame(shape, index, planes) {
  const {width, height, numerator, denominator} = shape;
  const us = (/** @type {number} */ k) => Math.round((1e6 * k * denominator) / numerator);
  return new VideoFrame(/** @type {BufferSource} */ (planes), {
    format: 'I420', codedWidth: width, codedHeight: height, timestamp: us(index), duration: us(index + 1) - us(index),
    colorSpace: film_colours,
  });
}

/**
 * The first codec that encodes a frame: a browser may say that it supports one and then refuse it. Null where none does.
 * @param {FilmKind} kind @param {FilmShape} shape @param {string} quality @returns {Promise<FilmCodec|null>}
 */
export async function working_codec(kind, shape, quality) {
  if (typeof VideoEncoder === 'undefined') return null;
  for (const [string, codec, name] of codecs_of(kind, shape)) {
    /** @type {VideoEncoderConfig} */
    const config = {
      codec: string, width: shape.width, height: shape.height, bitrate: bitrate_of(quality, shape), bitrateMode: 'variable',
      framerate: shape.numerator / shape.denominator, latencyMode: 'quality',
      ...(codec === 'avc' && {avc: {format: /** @type {const} */ ('avc')}}),
    };
    try {
      if (await encodes(config, shape)) return {config, codec, name};
    } catch {
      // The next one may work.
    }
  }
  return null;
}

/** @param {VideoEncoderConfig} config @param {FilmShape} shape */
async function encodes(config, shape) {
  if (!(await VideoEncoder.isConfigSupported(config)).supported) return false;
  let n_chunks = 0;
  const encoder = new VideoEncoder({output: () => { ++n_chunks; }, error: () => {}});
  try {
    encoder.configure(config);
    const frame = video_frame(shape, 0, new Uint8Array((shape.width * shape.height * 3) / 2).fill(128));
    encoder.encode(frame, {keyFrame: true});
    frame.close();
    await encoder.flush();
  } finally {
    if (encoder.state !== 'closed') encoder.close();
  }
  return n_chunks === 1;
}

/**
 * The decoder configuration record of an H.264 film (`avcC`) as players need it. Firefox 153 writes the first byte of each parameter set
 * twice, leaves the reserved bits 0, and leaves out the fields that the high profiles add (Mozilla bug 2031056). A sound record stays as
 * it is. Source: ISO/IEC 14496-15 §5.3.3.1.2.
 * @param {Uint8Array} record of film frames: 4:2:0, 8 bits @returns {Uint8Array<ArrayBuffer>}
 */
export function sound_avc_record(record) {
  const profile = record[1] ?? 0;
  let at = 5;
  /** @type {Uint8Array[]} */
  const parts = [record.subarray(0, 4), Uint8Array.of((record[4] ?? 0) | 0xfc)];
  let is_doubled = false;
  // Sequence parameter sets, whose second byte is the profile, and picture parameter sets.
  for (const [reserved, count] of [[0xe0, 0x1f], [0, 0xff]]) {
    const n_sets = (record[at++] ?? 0) & /** @type {number} */ (count);
    parts.push(Uint8Array.of(n_sets | /** @type {number} */ (reserved)));
    for (let k = 0; k < n_sets; ++k) {
      const size = ((record[at] ?? 0) << 8) | (record[at + 1] ?? 0);
      let set = record.subarray(at + 2, at + 2 + size);
      at += 2 + size;
      if (reserved) is_doubled = set[0] === set[1] && set[1] !== profile && set[2] === profile;
      if (is_doubled && set[0] === set[1]) set = set.subarray(1);
      parts.push(Uint8Array.of(set.length >> 8, set.length & 0xff), set);
    }
  }
  const has_more = [100, 110, 122, 144].includes(profile);
  const rest = record.subarray(at);
  parts.push(!has_more ? new Uint8Array(0) : rest.length >= 4 ? rest : Uint8Array.of(0xfd, 0xf8, 0xf8, 0));
  return joined_bytes(parts);
}

/** The record of a codec, if it has one. @param {VideoDecoderConfig} config @returns {VideoDecoderConfig} */
function with_sound_record(config) {
  if (!config.codec.startsWith('avc1') || !config.description) return config;
  const {description} = config;
  const bytes = ArrayBuffer.isView(description) ? new Uint8Array(description.buffer, description.byteOffset, description.byteLength) : new Uint8Array(description);
  return {...config, description: sound_avc_record(bytes)};
}

/** Joins the packets of pictures with those of their transparency, which come from another encoder. */
export class AlphaPairs {
  /** @param {FilmFile} file */
  constructor(file) {
    this.file = file;
    /** @type {[number, FilmPacket][]} */
    this.pictures = [];
    /** @type {Map<number, Uint8Array<ArrayBuffer>>} */
    this.alphas = new Map();
    this.joined = Promise.resolve();
  }

  /** @param {number} index @param {FilmPacket} packet */
  picture(index, packet) {
    this.pictures.push([index, packet]);
    return (this.joined = this.joined.then(() => this.#join()));
  }

  /** @param {number} index @param {FilmPacket} packet */
  alpha(index, {data}) {
    this.alphas.set(index, data);
    return (this.joined = this.joined.then(() => this.#join()));
  }

  async #join() {
    for (let next = this.pictures[0]; next; next = this.pictures[0]) {
      const [index, packet] = next;
      const alpha = this.alphas.get(index);
      if (!alpha) return;
      this.pictures.shift();
      this.alphas.delete(index);
      await this.file.add(index, {...packet, alpha});
    }
  }
}

/** Encodes frames one after the other. */
export class FrameEncoder {
  /**
   * @param {FilmShape} shape @param {FilmCodec} codec
   * @param {(index: number, packet: FilmPacket) => Promise<void>} take a packet, in the order in which a film stores them, and which frame it is
   */
  constructor(shape, codec, take) {
    this.shape = shape;
    this.n_frames = 0;
    this.n_packets = 0;
    /** @type {unknown} */
    this.fault = null;
    this.taken = Promise.resolve();
    /** @type {EncodedVideoChunkMetadata|undefined} */
    this.about = undefined;
    this.encoder = new VideoEncoder({
      error: (error) => { this.fault ??= error; },
      output: (chunk, about) => {
        const data = new Uint8Array(chunk.byteLength);
        chunk.copyTo(data);
        ++this.n_packets;
        // The frame, from its time in whole microseconds.
        const index = Math.round((chunk.timestamp * shape.numerator) / (1e6 * shape.denominator));
        // Encoders tell it once; each film needs it.
        if (about?.decoderConfig) this.about = {...about, decoderConfig: {...with_sound_record(about.decoderConfig), colorSpace: film_colours}};
        const packet = {data, type: chunk.type, about: this.about};
        this.taken = this.taken.then(() => take(index, packet)).catch((error) => { this.fault ??= error; });
      },
    });
    this.encoder.configure(codec.config);
  }

  #check() {
    if (this.fault) throw this.fault instanceof Error ? this.fault : new Error(message_of(this.fault));
  }

  /** @param {Uint8Array} planes @param {boolean} is_key */
  async add(planes, is_key) {
    const {encoder} = this;
    this.#check();
    const frame = video_frame(this.shape, this.n_frames++, planes);
    encoder.encode(frame, {keyFrame: is_key});
    frame.close();
    while (encoder.encodeQueueSize > most_waiting_frames && encoder.state === 'configured')
      await new Promise((resolve) => encoder.addEventListener('dequeue', resolve, {once: true}));
    await this.taken;
  }

  async finish() {
    this.#check();
    await this.encoder.flush();
    await this.taken;
    this.#check();
    if (this.n_packets !== this.n_frames) throw new Error(`the encoder has dropped ${this.n_frames - this.n_packets} frames`);
  }

  close() {
    if (this.encoder.state !== 'closed') this.encoder.close();
  }
}
