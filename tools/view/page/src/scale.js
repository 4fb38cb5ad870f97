// SPDX-License-Identifier: BSD-3-Clause
// The colour bar: what is shown, its numbers, and the range, which can be changed.
import { byId, css, make } from "./elements.js";
import { text, valueAt } from "./fields.js";

/** Parts of a linear bar between numbers; fewer where the numbers are long. */
const PARTS = 4;
const PARTS_OF_LONG = 2;
const LONG = 5; // characters

/** A bar of a logarithmic scale has numbers at 1, 2 and 5 times powers of ten, at most so many. */
const MOST_TICKS = 7;

/** Shares of a scale at which numbers stand; ends are always there. */
function ticks(scale) {
  if (!scale.log || !(scale.to > scale.from)) return evenTicks(scale);
  const low = Math.log10(scale.from),
    width = Math.log10(scale.to) - low;
  for (const digits of [[1, 2, 5], [1], [1, 3]]) {
    const values = [];
    for (let power = Math.floor(low); power <= low + width; ++power) {
      for (const digit of digits) values.push(digit * 10 ** power);
    }
    const inside = values.map((v) => [(Math.log10(v) - low) / width, v]);
    const shown = inside.filter(([share]) => share > 0.12 && share < 0.88);
    if (shown.length > MOST_TICKS || shown.length === 0) continue;
    return [[0, scale.from], ...shown, [1, scale.to]];
  }
  return evenTicks(scale);
}

function evenTicks(scale) {
  const ticksOf = (parts) =>
    Array.from({ length: parts + 1 }, (_, i) => [i / parts, valueAt(scale, i / parts)]);
  const all = ticksOf(PARTS);
  return all.every(([, value]) => text(value).length <= LONG) ? all : ticksOf(PARTS_OF_LONG);
}

function bar(fields, scale) {
  const colours = fields.maps[scale.map].map(css).join(", ");
  const element = make("div", { class: "bar" });
  element.style.background = `linear-gradient(to right, ${colours})`;
  return element;
}

function numbers(scale) {
  const row = make("div", { class: "ticks" });
  for (const [share, value] of ticks(scale)) {
    const mark = make("i");
    const label = make("span", {}, text(value));
    mark.style.left = label.style.left = `${100 * share}%`;
    // The first and the last number end with the bar.
    if (share === 0) label.style.transform = "none";
    if (share === 1) label.style.transform = "translateX(-100%)";
    row.append(mark, label);
  }
  return row;
}

function rangeRow(state) {
  const { field } = state;
  const input = (end, name) =>
    make("input", {
      type: "text",
      inputmode: "decimal",
      "aria-label": name,
      title: name,
      value: text(field.scale[end]),
      onchange: (event) => change(state, end, Number(event.target.value)),
    });
  const reset = make(
    "button",
    { onclick: () => state.setRange(field.whole.from, field.whole.to) },
    "reset",
  );
  return make(
    "div",
    { class: "range" },
    "from",
    input("from", "least value"),
    "to",
    input("to", "greatest value"),
    reset,
  );
}

function change(state, end, value) {
  const range = { ...state.field.scale, [end]: value };
  const isGood = Number.isFinite(value) && range.from < range.to && (!range.log || range.from > 0);
  state.setRange(
    isGood ? range.from : state.field.scale.from,
    isGood ? range.to : state.field.scale.to,
  );
}

export function addScale(state) {
  const card = byId("scale");
  const show = () => {
    const { field, fields } = state;
    card.hidden = field.category || field.of === "none";
    if (card.hidden) return;
    card.replaceChildren(
      make(
        "div",
        { class: "what" },
        make("b", {}, field.name),
        make("span", { class: "soft-text" }, field.text),
      ),
      make("div", { class: "numbers" }, bar(fields, field.scale), numbers(field.scale)),
      rangeRow(state),
    );
  };
  state.on("colours", show);
  show();
}
