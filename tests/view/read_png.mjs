// SPDX-License-Identifier: BSD-3-Clause
// Reads the pictures that browsers make: PNG of 8 bits, red, green, blue and perhaps alpha, without
// interlacing (ISO/IEC 15948).
import { inflateSync } from "node:zlib";

/** Returns a function that gives the colour at x, y. */
export function readPng(file) {
  const parts = [];
  let width, height, channels;
  for (let at = 8; at < file.length; at += 12 + file.readUInt32BE(at)) {
    const kind = file.toString("latin1", at + 4, at + 8);
    const content = file.subarray(at + 8, at + 8 + file.readUInt32BE(at));
    if (kind === "IHDR") {
      [width, height] = [content.readUInt32BE(0), content.readUInt32BE(4)];
      channels = content[9] === 6 ? 4 : 3;
    }
    if (kind === "IDAT") parts.push(content);
  }
  const bytes = unfiltered(inflateSync(Buffer.concat(parts)), width * channels, height, channels);
  return (x, y) => {
    const at = (Math.round(y) * width + Math.round(x)) * channels;
    return Array.from(bytes.subarray(at, at + 3));
  };
}

/** Undo the filter of each row: see section 9 of the standard. */
function unfiltered(filtered, row, height, step) {
  const bytes = new Uint8Array(row * height);
  for (let y = 0; y < height; ++y) {
    const filter = filtered[y * (row + 1)];
    for (let i = 0; i < row; ++i) {
      const at = y * row + i;
      const left = i >= step ? bytes[at - step] : 0;
      const up = y > 0 ? bytes[at - row] : 0;
      const corner = y > 0 && i >= step ? bytes[at - row - step] : 0;
      const guess = [0, left, up, (left + up) >> 1, paeth(left, up, corner)][filter];
      bytes[at] = filtered[y * (row + 1) + 1 + i] + guess;
    }
  }
  return bytes;
}

function paeth(left, up, corner) {
  const guess = left + up - corner;
  const [a, b, c] = [left, up, corner].map((x) => Math.abs(guess - x));
  return a <= b && a <= c ? left : b <= c ? up : corner;
}
