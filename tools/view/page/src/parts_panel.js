// SPDX-License-Identifier: BSD-3-Clause
// The field that is shown, and lists of patches, groups and contours to switch on and off.
import { make, section, swatch, whole } from "./elements.js";

/** Longer lists are shown in part: a filter finds the rest. */
const MOST_ROWS = 400;

function addFieldChoice(state) {
  const { body } = section("colours", "Colour");
  const choice = make("select", {
    id: "field",
    "aria-label": "Colour by",
    onchange: () => state.choose(choice.value),
  });
  for (const field of state.fields.list) {
    choice.append(
      make("option", { value: field.name }, field.name === "plain" ? field.text : field.name),
    );
  }
  choice.value = state.field.name;
  state.on("colours", () => (choice.value = state.field.name));
  body.append(choice);
}

/** A list with a filter; `rows` gives elements with the names by which they are found. */
function filteredList(rows) {
  const list = make("ul", { class: "list" });
  const rest = make("p", { class: "soft" });
  const show = (words) => {
    const found = rows.filter(({ name }) => name.toLowerCase().includes(words.toLowerCase()));
    list.replaceChildren(...found.slice(0, MOST_ROWS).map(({ element }) => element()));
    rest.hidden = found.length <= MOST_ROWS;
    rest.textContent = `and ${whole(found.length - MOST_ROWS)} more`;
  };
  const filter = make("input", {
    class: "filter",
    type: "search",
    placeholder: "filter by name",
    "aria-label": "filter by name",
    oninput: () => show(filter.value),
  });
  filter.hidden = rows.length < 12;
  show("");
  return { parts: [filter, list, rest], refresh: () => show(filter.value) };
}

function facesOfPatches({ surface, facts }) {
  const counts = new Uint32Array(facts.patches.length);
  for (let f = 0; f < surface.faceCount; ++f) {
    if (surface.patchOf(f) >= 0) ++counts[surface.patchOf(f)];
  }
  return counts;
}

/** A name with a box that switches patches on and off. */
function partRow(state, { name, patches, faces, colour, jump }) {
  const box = make("input", {
    type: "checkbox",
    checked: patches.some((p) => !state.isHidden(p)),
    onchange: () => state.show(patches, box.checked),
  });
  box.indeterminate = box.checked && patches.some((p) => state.isHidden(p));
  const only = make(
    "button",
    { class: "link", title: "show only this one", onclick: () => showOnly(state, patches) },
    "only",
  );
  const title = jump
    ? make("button", { class: "link name", title: `go to ${name}`, onclick: jump }, name)
    : make("span", { class: "name" }, name);
  const parts = [colour ? swatch(colour) : null, title];
  return make(
    "li",
    {},
    make("label", {}, box, ...parts.filter(Boolean)),
    make("span", { class: "number" }, whole(faces)),
    only,
  );
}

function showOnly(state, patches) {
  const chosen = new Set(patches);
  state.facts.patches.forEach((_, p) =>
    chosen.has(p) ? state.hidden.delete(p) : state.hidden.add(p),
  );
  state.tell("colours");
}

function switches(state, all) {
  return make(
    "div",
    { class: "row" },
    make("button", { onclick: () => state.show(all, true) }, "all"),
    make("button", { onclick: () => state.show(all, false) }, "none"),
  );
}

function addPatches(state, views) {
  const { facts } = state;
  if (facts.patches.length === 0) return;
  const faces = facesOfPatches(state);
  const { body, count } = section("patches", "Patches");
  count.textContent = whole(facts.patches.length);
  const rows = facts.patches.map((_, p) => ({
    name: state.patchName(p),
    element: () =>
      partRow(state, {
        name: state.patchName(p),
        patches: [p],
        faces: faces[p],
        colour: state.field.name === "patch" ? state.fields.categoryColour(p) : null,
        jump: () => goToPatch(state, views, p),
      }),
  }));
  const { parts, refresh } = filteredList(rows);
  body.append(
    switches(
      state,
      facts.patches.map((_, p) => p),
    ),
    ...parts,
  );
  state.on("colours", refresh);
}

/** Show a patch in space, and in the plane. */
export function goToPatch(state, views, patch) {
  const { surface } = state;
  const low = [Infinity, Infinity, Infinity],
    high = [-Infinity, -Infinity, -Infinity];
  for (let f = 0; f < surface.faceCount; ++f) {
    if (surface.patchOf(f) !== patch) continue;
    for (const p of surface.pointsOf(f)) {
      p.forEach((x, k) => {
        low[k] = Math.min(low[k], x);
        high[k] = Math.max(high[k], x);
      });
    }
  }
  if (!Number.isFinite(low[0])) return;
  const radius = Math.hypot(...low.map((x, k) => high[k] - x)) / 2;
  views.space.goTo(
    low.map((x, k) => (x + high[k]) / 2),
    Math.max(1e-4, radius),
  );
  state.choosePlane(patch);
}

function addGroups(state) {
  const { facts } = state;
  if (facts.groups.length === 0) return;
  const faces = facesOfPatches(state);
  const { body, count } = section("groups", "Groups", facts.groups.length < 12);
  count.textContent = whole(facts.groups.length);
  const rows = facts.groups.map((group, g) => ({
    name: group.name,
    element: () =>
      partRow(state, {
        name: group.name || `group ${g}`,
        patches: group.patches,
        faces: group.patches.reduce((sum, p) => sum + faces[p], 0),
        colour: state.field.name === "group" ? state.fields.categoryColour(g) : null,
      }),
  }));
  const { parts, refresh } = filteredList(rows);
  body.append(...parts);
  state.on("colours", refresh);
}

function addContours(state) {
  const numbers = [...new Set(state.contourOfLine ?? [])].filter((contour) => contour >= 0);
  if (numbers.length === 0) return;
  numbers.sort((a, b) => a - b);
  const { body, count } = section("contours", "Contours", false);
  count.textContent = whole(numbers.length);
  const names = make("input", {
    type: "checkbox",
    onchange: () => {
      state.showsContourNames = names.checked;
      state.tell("contours");
    },
  });
  const rows = numbers.map((contour) => ({
    name: state.contourName(contour),
    element: () => {
      const isChosen = contour === state.chosenContour;
      const button = make(
        "button",
        { class: "link name", onclick: () => state.chooseContour(contour) },
        state.contourName(contour),
      );
      return make("li", { class: isChosen ? "chosen" : "" }, button);
    },
  }));
  const { parts, refresh } = filteredList(rows);
  body.append(make("label", { class: "row" }, names, "names in the picture"), ...parts);
  state.on("contours", refresh);
}

export function addParts(state, views) {
  addFieldChoice(state);
  addPatches(state, views);
  addGroups(state);
  addContours(state);
}
