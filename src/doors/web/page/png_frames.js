// PNG files and ZIP archives, for a film as a sequence of pictures. No picture needs another one's memory.

const crc_table = Uint32Array.from({length: 256}, (_, n) => {
  let crc = n;
  for (let k = 0; k < 8; ++k) crc = crc & 1 ? (crc >>> 1) ^ 0xedb88320 : crc >>> 1;
  return crc;
});

/** CRC-32 of bytes (ISO 3309; PNG and ZIP). @param {Uint8Array} bytes */
export function crc32_of(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) crc = /** @type {number} */ (crc_table[(crc ^ byte) & 0xff]) ^ (crc >>> 8);
  return (crc ^ 0xffffffff) >>> 0;
}

/** Bytes one after the other. @param {Uint8Array[]} parts @returns {Uint8Array<ArrayBuffer>} */
export function joined_bytes(parts) {
  const all = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}

/** The bytes of a stream of zlib's format (RFC 1950). @param {Uint8Array<ArrayBuffer>} bytes */
async function deflated(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new CompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/**
 * A PNG file of straight R, G, B and alpha from the top row, with a text of its own. Source: PNG specification, third edition.
 * @param {Uint8Array} pixels @param {number} width @param {number} height @param {string} name of the text, in ASCII @param {string} text
 */
export async function png_file(pixels, width, height, name, text) {
  // Each row less the one above it: drawings repeat from row to row.
  const stride = 4 * width;
  const rows = new Uint8Array(height * (stride + 1));
  for (let y = 0; y < height; ++y) {
    const row = rows.subarray(y * (stride + 1), (y + 1) * (stride + 1));
    row.set(pixels.subarray(y * stride, (y + 1) * stride), 1);
    if (y === 0) continue;
    row[0] = 2;
    for (let x = 0; x < stride; ++x) row[x + 1] = /** @type {number} */ (pixels[y * stride + x]) - /** @type {number} */ (pixels[(y - 1) * stride + x]);
  }
  const encode = (/** @type {string} */ text) => new TextEncoder().encode(text);
  const number = (/** @type {number} */ value) => {
    const bytes = new Uint8Array(4);
    new DataView(bytes.buffer).setUint32(0, value);
    return bytes;
  };
  const chunk = (/** @type {string} */ kind, /** @type {Uint8Array[]} */ ...parts) => {
    const body = joined_bytes([encode(kind), ...parts]);
    return joined_bytes([number(body.length - 4), body, number(crc32_of(body))]);
  };
  return joined_bytes([
    Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10),
    chunk('IHDR', number(width), number(height), Uint8Array.of(8, 6, 0, 0, 0)),
    chunk('sRGB', Uint8Array.of(0)),
    // Uncompressed, without a language.
    chunk('iTXt', encode(`${name}\0\0\0\0\0${text}`)),
    chunk('IDAT', await deflated(rows)),
    chunk('IEND'),
  ]);
}

/** A ZIP archive that is written as it grows; its files are stored as they are. Source: PKWARE's APPNOTE 6.3.3, without ZIP64. */
export class ZipWriter {
  /** @param {(bytes: Uint8Array<ArrayBuffer>) => Promise<void>} write */
  constructor(write) {
    this.write = write;
    this.at = 0;
    /** @type {Uint8Array[]} */
    this.entries = [];
  }

  /** @param {string} name @param {Uint8Array} bytes */
  async add(name, bytes) {
    if (this.entries.length >= 65535 || this.at + bytes.length > 0xf0000000)
      throw new RangeError('the archive would be larger than 4 GB, or have more than 65,535 pictures; make a shorter or smaller film');
    const named = new TextEncoder().encode(name);
    const about = new Uint8Array(26);
    const view = new DataView(about.buffer);
    view.setUint16(0, 10, true); // version 1.0 reads it
    view.setUint16(2, 0x800, true); // the name is UTF-8
    view.setUint16(8, 0x21, true); // the first day that a date can name
    view.setUint32(10, crc32_of(bytes), true);
    view.setUint32(14, bytes.length, true);
    view.setUint32(18, bytes.length, true);
    view.setUint16(22, named.length, true);
    const place = new Uint8Array(14);
    new DataView(place.buffer).setUint32(10, this.at, true);
    // The central directory repeats the head of each file.
    this.entries.push(joined_bytes([Uint8Array.of(0x50, 0x4b, 1, 2, 20, 0), about, place, named]));
    const file = joined_bytes([Uint8Array.of(0x50, 0x4b, 3, 4), about, named, bytes]);
    this.at += file.length;
    await this.write(file);
  }

  async finish() {
    const directory = joined_bytes(this.entries);
    const end = new Uint8Array(22);
    const view = new DataView(end.buffer);
    view.setUint32(0, 0x06054b50, true);
    view.setUint16(8, this.entries.length, true);
    view.setUint16(10, this.entries.length, true);
    view.setUint32(12, directory.length, true);
    view.setUint32(16, this.at, true);
    await this.write(joined_bytes([directory, end]));
  }
}
