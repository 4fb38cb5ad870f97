// SPDX-License-Identifier: BSD-3-Clause
// What is known of the element that is marked.
import { make, pairs, section, whole } from "./elements.js";
import { text } from "./fields.js";
import { goToPatch } from "./parts_panel.js";

/** The two sizes that a metric asks for are given by the field "size", with the stretch. */
function sizesText(size, stretch) {
  if (!(size > 0) || !(stretch >= 1)) return null;
  // The size is the geometric mean of the two.
  return `${text(size * Math.sqrt(stretch))} and ${text(size / Math.sqrt(stretch))} across`;
}

const distance = (a, b) => Math.hypot(...a.map((x, k) => x - b[k]));

/** Metric length of the step between two nodes, in the mean of the metrics at both ends. */
function metricLength(surface, a, b) {
  const step = [0, 1].map((k) => surface.uv[2 * b + k] - surface.uv[2 * a + k]);
  const length = (node) => {
    const [m11, m12, m22] = surface.metric.subarray(3 * node, 3 * node + 3);
    return Math.sqrt(m11 * step[0] ** 2 + 2 * m12 * step[0] * step[1] + m22 * step[1] ** 2);
  };
  const l0 = length(a),
    l1 = length(b);
  // As edge_length of metric/tensor.hh: exact where sizes change geometrically.
  return Math.abs(l0 - l1) < 1e-3 * (l0 + l1) ? (l0 + l1) / 2 : (l0 - l1) / Math.log(l0 / l1);
}

function cornerTable(state, face) {
  const { surface, facts } = state;
  const nodes = [...surface.nodesOf(face)];
  const origin = facts.patches[surface.patchOf(face)]?.origin ?? [0, 0];
  const head = ["vertex", ...(surface.uv ? ["u", "v"] : ["x", "y", "z"])];
  const rows = nodes.map((node) => {
    const vertex = surface.vertexOf(node);
    const numbers = surface.uv
      ? origin.map((o, k) => o + surface.uv[2 * node + k])
      : state.modelPoint(surface.point(vertex));
    return [whole(vertex), ...numbers.map(text)];
  });
  return table("Corners", head, rows);
}

function metricTable({ surface }, face) {
  if (!surface.metric) return [];
  const rows = [...surface.nodesOf(face)].map((node) => [
    whole(surface.vertexOf(node)),
    ...Array.from(surface.metric.subarray(3 * node, 3 * node + 3), text),
  ]);
  return table("Metric", ["vertex", "m11", "m12", "m22"], rows);
}

function sideTable(state, face) {
  const { surface, facts } = state;
  const nodes = [...surface.nodesOf(face)];
  const rows = nodes.map((node, i) => {
    const next = nodes[(i + 1) % nodes.length];
    const [a, b] = [node, next].map((n) => surface.vertexOf(n));
    const row = [
      `${whole(a)} – ${whole(b)}`,
      text(facts.radius * distance(surface.point(a), surface.point(b))),
    ];
    if (surface.metric) row.push(text(metricLength(surface, node, next)));
    return row;
  });
  return table("Sides", ["vertices", "length", ...(surface.metric ? ["metric length"] : [])], rows);
}

function table(title, head, rows) {
  const line = (tag, cells) => make("tr", {}, ...cells.map((cell) => make(tag, {}, cell)));
  return [
    make("h3", {}, title),
    make("table", {}, line("th", head), ...rows.map((row) => line("td", row))),
  ];
}

function valuesOf(state, face) {
  const value = (name) => {
    const field = state.fields.find(name);
    return field && field.of === "faces" ? field.values[face] : NaN;
  };
  const rows = state.fields.list
    .filter((field) => field.of === "faces" && !field.category)
    .map((field) => [field.name, text(field.values[face])]);
  return [...rows, ["asked for", sizesText(value("size"), value("stretch"))]];
}

function showElement(state, views, body) {
  const { surface, marked } = state;
  const patch = surface.patchOf(marked);
  const kind = ["Triangle", "Quad"][surface.nodesOf(marked).length - 3] ?? "Polygon";
  const link =
    patch >= 0
      ? make(
          "button",
          { class: "link", onclick: () => goToPatch(state, views, patch) },
          state.patchName(patch),
        )
      : null;
  const middle = state.modelPoint(surface.middleOf(marked)).map(text).join(", ");
  body.replaceChildren(
    pairs([
      [kind, make("b", { id: "marked-face" }, whole(marked))],
      ["patch", link],
      ["groups", state.groupsOf(patch).join(", ") || null],
      ["middle", middle],
      ...valuesOf(state, marked),
    ]),
    ...cornerTable(state, marked),
    ...metricTable(state, marked),
    ...sideTable(state, marked),
    make(
      "div",
      { class: "row" },
      make("button", { onclick: () => views.space.goToFace(marked) }, "go to"),
      make("button", { onclick: () => state.mark(-1) }, "unmark"),
    ),
  );
}

export function addElementPanel(state, views) {
  const { body } = section("element", "Element");
  const find = make("input", {
    type: "text",
    inputmode: "numeric",
    "aria-label": "number of an element",
    placeholder: "number",
    onchange: () => {
      const face = Number(find.value);
      if (!Number.isInteger(face) || face < 0 || face >= state.surface.faceCount) return;
      state.mark(face);
      views.space.goToFace(face);
    },
  });
  const details = make("div");
  body.append(details, make("div", { class: "row" }, "Find", find));
  const show = () => {
    if (state.marked >= 0) showElement(state, views, details);
    else
      details.replaceChildren(
        make("p", { class: "soft" }, "Click on an element to see its values."),
      );
  };
  state.on("marked", () => {
    show();
    // The plane follows to the patch of the element.
    if (state.marked >= 0) state.choosePlane(state.surface.patchOf(state.marked));
  });
  show();
}
