// Unpacks with web/page/unpack.js what xz packs, and compares the bytes. Needs no browser.
import test from 'node:test';
import assert from 'node:assert/strict';
import fs from 'node:fs';
import {execFileSync} from 'node:child_process';
import {bytes_of_base94, unpacked_lzma} from '../../../src/doors/web/page/unpack.js';

// A fixed sequence (Numerical Recipes' quick generator).
let seed = 1;
const random = (n) => {
  seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
  return Math.floor((n * seed) / 4294967296);
};
const noise = Buffer.from(Array.from({length: 70000}, () => random(256)));
// Repeats at all distances and of all lengths, between noise.
const patchwork = Buffer.concat(Array.from({length: 3000}, () => {
  const from = random(noise.length);
  return noise.subarray(from, from + random(random(2) ? 400 : 12));
}));
const samples = {
  'no byte': Buffer.alloc(0), 'one byte': Buffer.from('a'), 'one byte many times': Buffer.alloc(300000, 7), noise, patchwork,
  'text': fs.readFileSync(new URL(import.meta.url)), 'numbers': Buffer.from(Float64Array.from({length: 9000}, (_, k) => Math.sin(k)).buffer),
};

for (const [name, bytes] of Object.entries(samples))
  for (const settings of ['preset=9e', 'preset=1,lc=0,lp=2,pb=0', 'preset=6,lc=4,lp=0,pb=4'])
    test(`unpacks ${name} of xz with ${settings}`, () => {
      const packed = execFileSync('xz', ['--format=lzma', `--lzma1=${settings}`, '-c'], {input: bytes});
      assert.equal(Buffer.compare(Buffer.from(unpacked_lzma(packed)), bytes), 0);
    });

// By whole numbers of any size.
const base94 = (bytes) => {
  let text = '';
  for (let i = 0; i < bytes.length; i += 9) {
    let word = 0n;
    for (let k = i; k < i + 9; ++k) word = 256n * word + BigInt(k < bytes.length ? bytes[k] : 0);
    for (let k = 10n; k >= 0n; --k) {
      const code = 32 + Number((word / 94n ** k) % 94n);
      text += String.fromCharCode(code < 60 ? code : code + 1);
    }
  }
  return text;
};

test('reads base 94 of every length and of extreme words', () => {
  for (let n = 0; n < 40; ++n)
    for (const bytes of [noise.subarray(0, n), Buffer.alloc(n, 255), Buffer.alloc(n)])
      // Zeros follow the last byte.
      assert.deepEqual([...bytes_of_base94(base94(bytes))], [...bytes, ...Array((9 - (n % 9)) % 9).fill(0)]);
  assert.equal(base94(Buffer.alloc(9, 255)).length, 11);
  assert.ok(!base94(noise).includes('<'));
});
