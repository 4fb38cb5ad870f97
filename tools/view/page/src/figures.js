// SPDX-License-Identifier: BSD-3-Clause
// The figures of the mesh, and the report of the run that made it.
import { make, pairs, section, whole } from "./elements.js";
import { text } from "./fields.js";

/** Of a field of faces: least, mean, greatest. */
function extremes(field) {
  let least = Infinity,
    greatest = -Infinity,
    sum = 0,
    count = 0;
  for (const value of field.values) {
    if (Number.isNaN(value)) continue;
    least = Math.min(least, value);
    greatest = Math.max(greatest, value);
    sum += value;
    ++count;
  }
  return count > 0 ? `${text(least)} to ${text(greatest)}, mean ${text(sum / count)}` : null;
}

function meshFigures(state) {
  const { facts, fields, surface } = state;
  const rows = [
    ["mesh", facts.title],
    ["model", facts.model || null],
    ["elements", whole(surface.faceCount)],
    ["vertices", whole(surface.vertexCount)],
    ["surface", surface.isClosed ? "closed" : "with open edges"],
    ["diagonal", text(2 * facts.radius)],
  ];
  for (const field of fields.list) {
    if (field.of !== "none" && !field.category) rows.push([field.name, extremes(field)]);
  }
  return rows;
}

function reportFigures(report) {
  if (!report) return [];
  const { control, seconds, mesh, sag } = report;
  return [
    ["Euler characteristic", text(mesh?.euler)],
    [
      "control space",
      control
        ? `${control.kind}, ${whole(control.nodes)} nodes, ${whole(control.faces)} faces`
        : null,
    ],
    ["sag asked for", sag?.asked != null ? text(sag.asked) : null],
    ["sag reached", sag?.reached != null ? text(sag.reached) : null],
    ["processor time", seconds ? `${text(seconds.total)} s` : null],
    [
      "elements a second",
      report.triangles_per_second_in_all ? whole(report.triangles_per_second_in_all) : null,
    ],
  ];
}

/** JSON as a tree that can be unfolded; the insides are made when they are first seen. */
function tree(name, value) {
  if (value === null || typeof value !== "object") {
    return make("div", {}, make("b", {}, `${name}: `), value === null ? "–" : String(value));
  }
  const entries = Object.entries(value);
  if (entries.length === 0) return make("div", {}, make("b", {}, `${name}: `), "none");
  const element = make(
    "details",
    {},
    make("summary", {}, Array.isArray(value) ? `${name} (${entries.length})` : name),
  );
  element.addEventListener(
    "toggle",
    () => element.append(...entries.map(([key, inner]) => tree(inner?.name || key, inner))),
    { once: true },
  );
  return element;
}

export function addFigures(state) {
  const { report } = state.facts;
  const { body, element } = section("figures", "Figures", false);
  element.addEventListener(
    "toggle",
    () => {
      body.append(pairs([...meshFigures(state), ...reportFigures(report)]));
      if (report) body.append(make("div", { class: "tree" }, tree("Report of the run", report)));
      body.append(
        make(
          "p",
          { class: "soft" },
          `Made by surfmesh ${state.facts.version}; drawn with three.js.`,
        ),
      );
    },
    { once: true },
  );
}
