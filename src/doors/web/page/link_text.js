// The text of a scene in a link: deflated (RFC 1951), in base64url (RFC 4648 §5).

import {bytes_of_base64} from './loader.js';
import {base64_of_bytes, bytes_of_stream} from './zip_reader.js';

/** Characters in a link; more is lost in mails and chats. */
const most_link_characters = 16000;
/** Of a text that a link unpacks to. */
const most_text_bytes = 1 << 20;

/** A text for a link; null: it is too long for one. @param {string} text @returns {Promise<string|null>} */
export async function packed_text(text) {
  const stream = new Blob([text]).stream().pipeThrough(new CompressionStream('deflate-raw'));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  const packed = base64_of_bytes(bytes).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
  return packed.length <= most_link_characters ? packed : null;
}

/** The text of a link; null: it is damaged. @param {string} packed @returns {Promise<string|null>} */
export async function unpacked_text(packed) {
  if (packed.length > most_link_characters || !/^[\w-]+$/.test(packed)) return null;
  try {
    const bytes = bytes_of_base64(packed.replaceAll('-', '+').replaceAll('_', '/'));
    const text = await bytes_of_stream(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw')), most_text_bytes);
    return new TextDecoder('utf-8', {fatal: true}).decode(text);
  } catch {
    return null;
  }
}
