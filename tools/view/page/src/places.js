// SPDX-License-Identifier: BSD-3-Clause
// Lists of places to go to: the worst elements, and what the program had to tell.
import { make, section, whole } from "./elements.js";
import { text } from "./fields.js";
import { goToPatch } from "./parts_panel.js";

/** Elements that are listed. */
const LISTED = 25;

/** By what elements may be worst: the field that is shown, else the first that the mesh has. */
const JUDGES = ["quality", "shape", "length", "stretch", "sag"];

/** How bad a value is; the worst is the greatest. */
function badness(field) {
  switch (field.scale.map) {
    case "goodness":
      return (value) => -value;
    case "deviations":
      return (value) =>
        Math.abs(
          field.scale.log ? Math.log(value) : value - (field.whole.from + field.whole.to) / 2,
        );
    default:
      return (value) => value;
  }
}

/** The faces of the worst values of a field, worst first. */
function worstFaces(field) {
  const bad = badness(field);
  const worst = [];
  for (let face = 0; face < field.values.length; ++face) {
    const b = bad(field.values[face]);
    if (Number.isNaN(b) || (worst.length === LISTED && b <= worst[LISTED - 1].b)) continue;
    const at = worst.findIndex((other) => other.b < b);
    worst.splice(at < 0 ? worst.length : at, 0, { face, b });
    worst.length = Math.min(worst.length, LISTED);
  }
  return worst.map(({ face }) => face);
}

export function addWorst(state, space) {
  const { body, count } = section("worst", "Worst elements");
  const list = make("ul", { class: "list" });
  body.append(list);
  let field = null;
  let faces = [];
  const goTo = (face) => {
    state.mark(face);
    space.goToFace(face);
  };
  const show = () => {
    list.replaceChildren(
      ...faces.map((face) => {
        const button = make(
          "button",
          { class: "link", onclick: () => goTo(face) },
          `element ${whole(face)}`,
        );
        const patch = state.surface.patchOf(face);
        return make(
          "li",
          { class: face === state.marked ? "chosen" : "" },
          button,
          patch >= 0 ? make("span", { class: "name" }, state.patchName(patch)) : null,
          make("span", { class: "number" }, text(field.values[face])),
        );
      }),
    );
  };
  const judge = () => {
    const chosen = JUDGES.includes(state.field.name)
      ? state.field
      : JUDGES.map((name) => state.fields.find(name)).find(Boolean);
    if (chosen === field) return;
    field = chosen;
    faces = worstFaces(field);
    count.textContent = `by ${field.name}`;
    show();
  };
  state.on("colours", judge);
  state.on("marked", show);
  /** Go on in the list, or back; around at its ends. */
  state.step = (by) => {
    if (faces.length === 0) return;
    const now = faces.indexOf(state.marked);
    const next = now < 0 ? (by > 0 ? 0 : -1) : now + by;
    goTo(faces[(next + faces.length) % faces.length]);
  };
  judge();
}

/** Go to the place of a notice, if it has one. */
function placeOf(notice, state, space) {
  if (notice.point) {
    return () => space.goTo(state.pagePoint(notice.point), 0.08);
  }
  if (notice.contour !== null && state.contourOfLine?.includes(notice.contour)) {
    return () => goToContour(state, space, notice.contour);
  }
  const isPatch = notice.patch >= 0 && notice.patch < state.facts.patches.length;
  return isPatch ? () => goToPatch(state, { space }, notice.patch) : null;
}

/** Mark a contour, and go to the middle of it. */
function goToContour(state, space, contour) {
  const { lines, contourOfLine, surface } = state;
  const segments = [...contourOfLine.keys()].filter((i) => contourOfLine[i] === contour);
  if (state.chosenContour !== contour) state.chooseContour(contour);
  space.goTo(surface.point(lines[2 * segments[segments.length >> 1]]), 0.3);
}

export function addNotices(state, space) {
  const { notices } = state.facts;
  const { body, count } = section("notices", "Notices", notices.length > 0);
  count.textContent = whole(notices.length);
  if (notices.length === 0) body.append(make("p", { class: "soft" }, "There are none."));
  for (const notice of notices) {
    const jump = placeOf(notice, state, space);
    const times = notice.count > 1 ? ` (${whole(notice.count)} times)` : "";
    body.append(
      make(
        "div",
        { class: `notice ${notice.severity}` },
        make(
          "span",
          { class: "kind" },
          notice.severity === "shortfall" ? "not reached: " : "warning: ",
        ),
        `${notice.text}${times} `,
        jump ? make("button", { class: "link", onclick: jump }, "go there") : null,
      ),
    );
  }
}
