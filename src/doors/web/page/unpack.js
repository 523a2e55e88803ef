// Packed blocks of the page: LZMA, written as text in base 94.

/** Bytes from text: eleven characters of ' ' to '~' without '<' are nine bytes. @param {string} text @returns {Uint8Array<ArrayBuffer>} */
export function bytes_of_base94(text) {
  const n_low = 2 ** 40;
  const bytes = new Uint8Array((9 * text.length) / 11);
  for (let i = 0, at = 0; at < bytes.length; at += 9) {
    let high = 0;
    let low = 0;
    for (const end = i + 11; i < end; ++i) {
      const code = text.charCodeAt(i);
      low = 94 * low + code - (code > 60 ? 33 : 32);
      const carry = Math.floor(low / n_low);
      high = 94 * high + carry;
      low -= carry * n_low;
    }
    for (let k = 0; k < 4; ++k) bytes[at + k] = high >>> (24 - 8 * k);
    bytes[at + 4] = low / 2 ** 32;
    for (let k = 0; k < 4; ++k) bytes[at + 5 + k] = low >>> (24 - 8 * k);
  }
  return bytes;
}

/**
 * Unpacks a file of `xz --format=lzma` (Igor Pavlov, "LZMA specification", the LZMA SDK). Browsers unpack
 * gzip themselves, but with gzip a page is 27 % larger.
 * @param {Uint8Array} packed @returns {Uint8Array<ArrayBuffer>}
 */
export function unpacked_lzma(packed) {
  const lc = packed[0] % 9;
  const lp = Math.floor(packed[0] / 9) % 5;
  const pb = Math.floor(packed[0] / 45);
  let out = new Uint8Array(4 * packed.length);
  let size = 0;
  // The range decoder.
  let at = 14;
  let code = 0;
  let range = -1;
  const normalise = () => {
    if (range >>> 24 === 0) {
      range <<= 8;
      code = (code << 8) | packed[at++];
    }
  };
  /** @param {Uint16Array} chances @param {number} k */
  const bit = (chances, k) => {
    const chance = chances[k];
    const bound = Math.imul(range >>> 11, chance);
    let value = 0;
    if (code >>> 0 < bound >>> 0) {
      range = bound;
      chances[k] = chance + ((2048 - chance) >> 5);
    } else {
      range = (range - bound) | 0;
      code = (code - bound) | 0;
      chances[k] = chance - (chance >> 5);
      value = 1;
    }
    normalise();
    return value;
  };
  /** A number whose highest bit comes first. @param {Uint16Array} chances @param {number} from @param {number} n_bits */
  const tree = (chances, from, n_bits) => {
    let m = 1;
    for (let k = 0; k < n_bits; ++k) m = 2 * m + bit(chances, from + m);
    return m - (1 << n_bits);
  };
  /** A number whose lowest bit comes first. @param {Uint16Array} chances @param {number} from @param {number} n_bits */
  const reverse_tree = (chances, from, n_bits) => {
    let m = 1;
    let value = 0;
    for (let k = 0; k < n_bits; ++k) {
      const b = bit(chances, from + m);
      m = 2 * m + b;
      value |= b << k;
    }
    return value;
  };
  /** @param {number} n */
  const chances_of = (n) => new Uint16Array(n).fill(1024);
  const literals = chances_of(0x300 << (lc + lp));
  const [is_match, is_rep, is_rep_0, is_rep_1, is_rep_2, is_long] = [192, 12, 12, 12, 12, 192].map(chances_of);
  const slots = chances_of(4 * 64);
  const specials = chances_of(128);
  const aligns = chances_of(16);
  const lengths = () => ({choices: chances_of(2), low: chances_of(16 * 8), mid: chances_of(16 * 8), high: chances_of(256)});
  const match_lengths = lengths();
  const rep_lengths = lengths();
  /** @param {ReturnType<typeof lengths>} of @param {number} position */
  const length_of = (of, position) => {
    if (bit(of.choices, 0) === 0) return 2 + tree(of.low, 8 * position, 3);
    if (bit(of.choices, 1) === 0) return 10 + tree(of.mid, 8 * position, 3);
    return 18 + tree(of.high, 0, 8);
  };
  for (let k = 0; k < 4; ++k) code = (code << 8) | packed[at++];

  let state = 0;
  let [rep_0, rep_1, rep_2, rep_3] = [0, 0, 0, 0];
  for (;;) {
    if (size + 300 > out.length) {
      const larger = new Uint8Array(2 * out.length + 300);
      larger.set(out);
      out = larger;
    }
    const position = size & ((1 << pb) - 1);
    if (bit(is_match, 16 * state + position) === 0) {
      const before = size > 0 ? out[size - 1] : 0;
      const from = 0x300 * (((size & ((1 << lp) - 1)) << lc) + (before >> (8 - lc)));
      let symbol = 1;
      if (state >= 7) {
        let matched = out[size - rep_0 - 1];
        while (symbol < 0x100) {
          const guess = (matched >> 7) & 1;
          matched <<= 1;
          const b = bit(literals, from + ((1 + guess) << 8) + symbol);
          symbol = 2 * symbol + b;
          if (guess !== b) break;
        }
      }
      while (symbol < 0x100) symbol = 2 * symbol + bit(literals, from + symbol);
      out[size++] = symbol;
      state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
      continue;
    }
    let length = 0;
    if (bit(is_rep, state) === 1) {
      if (bit(is_rep_0, state) === 0) {
        if (bit(is_long, 16 * state + position) === 0) {
          state = state < 7 ? 9 : 11;
          out[size] = out[size - rep_0 - 1];
          ++size;
          continue;
        }
      } else {
        let distance = rep_1;
        if (bit(is_rep_1, state) === 1) {
          distance = rep_2;
          if (bit(is_rep_2, state) === 1) {
            distance = rep_3;
            rep_3 = rep_2;
          }
          rep_2 = rep_1;
        }
        rep_1 = rep_0;
        rep_0 = distance;
      }
      length = length_of(rep_lengths, position);
      state = state < 7 ? 8 : 11;
    } else {
      [rep_1, rep_2, rep_3] = [rep_0, rep_1, rep_2];
      length = length_of(match_lengths, position);
      state = state < 7 ? 7 : 10;
      const slot = tree(slots, 64 * Math.min(length - 2, 3), 6);
      rep_0 = slot;
      if (slot >= 4) {
        const n_bits = (slot >> 1) - 1;
        rep_0 = (2 | (slot & 1)) << n_bits;
        if (slot < 14) {
          rep_0 += reverse_tree(specials, rep_0 - slot, n_bits);
        } else {
          let high = 0;
          for (let k = 0; k < n_bits - 4; ++k) {
            range >>>= 1;
            const b = code >>> 0 >= range >>> 0 ? 1 : 0;
            if (b === 1) code = (code - range) | 0;
            normalise();
            high = 2 * high + b;
          }
          rep_0 += (high << 4) + reverse_tree(aligns, 0, 4);
          if ((rep_0 | 0) === -1) return out.subarray(0, size);
        }
      }
    }
    for (let from = size - rep_0 - 1; length > 0; --length) out[size++] = out[from++];
  }
}
