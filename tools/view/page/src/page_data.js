// SPDX-License-Identifier: BSD-3-Clause
// Reads what the program has put into the page: facts as JSON, numbers as compressed planes of
// bytes in base64 (see tools/view/page_arrays.hh).

/** The form of the page that this script knows; page_facts.hh has the same number. */
const FORMAT = 1;

/** Read the page. Throws where the script does not belong to it. */
export async function readPage() {
  const facts = JSON.parse(document.getElementById("facts").textContent);
  if (facts.format !== FORMAT) {
    throw new Error(`this page has the form ${facts.format}, its script knows ${FORMAT}`);
  }
  const element = document.getElementById("arrays");
  const bytes = fromBase64(element.textContent);
  element.remove(); // the text is as large as all arrays together
  const names = Object.keys(facts.arrays);
  const values = await Promise.all(names.map((name) => readArray(facts.arrays[name], bytes)));
  return { facts, arrays: Object.fromEntries(names.map((name, i) => [name, values[i]])) };
}

function fromBase64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const characters = atob(text);
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = characters.charCodeAt(i);
  return bytes;
}

async function inflate(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Put four planes of bytes together to numbers. */
async function readArray({ type, count, steps, at, sizes }, bytes) {
  let begin = at;
  const planes = await Promise.all(
    sizes.map((size) => {
      const part = bytes.subarray(begin, begin + Math.abs(size));
      begin += Math.abs(size);
      return size > 0 ? inflate(part) : part; // negative: as it is
    }),
  );
  const words = new Uint32Array(count);
  const [a, b, c, d] = planes;
  for (let i = 0; i < count; ++i) words[i] = a[i] | (b[i] << 8) | (c[i] << 16) | (d[i] << 24);
  if (steps) addUp(words);
  return type === "f32" ? new Float32Array(words.buffer) : words;
}

/** Numbers from their differences, in zigzag. */
function addUp(words) {
  let number = 0;
  for (let i = 0; i < words.length; ++i) {
    number = (number + ((words[i] >>> 1) ^ -(words[i] & 1))) >>> 0;
    words[i] = number;
  }
}
