// SPDX-License-Identifier: BSD-3-Clause
// Values of faces and vertices, and the colours of their scales. Maps and scales come from the
// program (tools/pictures/colours.hh).

/** A field without values, for meshes without patches. */
export const PLAIN = { name: "plain", text: "one colour", category: false, of: "none" };

const PLAIN_COLOUR = [186, 200, 214];

function bytes(hex) {
  const value = parseInt(hex.slice(1), 16);
  return [(value >> 16) & 255, (value >> 8) & 255, value & 255];
}

export class Fields {
  constructor({ facts, arrays }) {
    this.maps = Object.fromEntries(
      Object.entries(facts.maps).map(([name, colours]) => [name, colours.map(bytes)]),
    );
    this.categories = facts.categories.map(bytes);
    this.noValue = bytes(facts.no_value);
    this.list = [PLAIN, ...facts.fields.map((field) => this.withValues(field, facts, arrays))];
  }

  /** A field with its values, and the range of its colours, which the user may change. */
  withValues(field, facts, arrays) {
    if (field.category) return { ...field, values: categoriesOf(field.name, facts, arrays.patch) };
    const scale = { ...field.scale };
    return { ...field, values: arrays[`field_${field.name}`], scale, whole: { ...scale } };
  }

  find(name) {
    return this.list.find((field) => field.name === name);
  }

  categoryColour(index) {
    return index >= 0 ? this.categories[index % this.categories.length] : this.noValue;
  }

  /** The colour of a value of a field. */
  colour(field, value) {
    if (field.of === "none") return PLAIN_COLOUR;
    if (field.category) return this.categoryColour(value);
    return this.mapColour(field.scale.map, shareOf(field.scale, value));
  }

  mapColour(map, share) {
    if (Number.isNaN(share)) return this.noValue;
    const colours = this.maps[map];
    const place = share * (colours.length - 1);
    const i = Math.min(Math.floor(place), colours.length - 2);
    const t = place - i;
    return [0, 1, 2].map((k) => Math.round((1 - t) * colours[i][k] + t * colours[i + 1][k]));
  }

  /** A table of 256 colours of a map, and a last one for no value, as red, green, blue. */
  table(field) {
    const table = new Uint8Array(257 * 3);
    for (let i = 0; i < 256; ++i) table.set(this.mapColour(field.scale.map, i / 255), 3 * i);
    table.set(this.noValue, 3 * 256);
    return table;
  }
}

/** Patches of faces, or the first groups of their patches; -1 for none. */
function categoriesOf(name, facts, patch) {
  const patches = new Int32Array(patch.buffer);
  if (name === "patch") return patches;
  const groupOf = new Int32Array(facts.patches.length).fill(-1);
  for (let g = facts.groups.length; g-- > 0;) {
    for (const p of facts.groups[g].patches) groupOf[p] = g;
  }
  return patches.map((p) => (p >= 0 ? groupOf[p] : -1));
}

/** The share of a value in a scale, from 0 to 1; NaN for none. */
export function shareOf({ from, to, log }, value) {
  const place = (x) => (log ? Math.log(x) : x);
  if (Number.isNaN(value)) return NaN;
  if (!(to > from)) return 0.5;
  const share = (place(value) - place(from)) / (place(to) - place(from));
  return Number.isNaN(share) ? NaN : Math.min(1, Math.max(0, share));
}

/** The value at a share of a scale. */
export function valueAt({ from, to, log }, share) {
  return log ? from * Math.pow(to / from, share) : from + share * (to - from);
}

/** A number for people: four digits. */
export function text(value) {
  if (value === null || value === undefined || Number.isNaN(value)) return "–";
  if (!Number.isFinite(value)) return String(value);
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e6)) return value.toExponential(3);
  return String(Number(value.toPrecision(4)));
}
