// SPDX-License-Identifier: BSD-3-Clause
// The buttons above the views, and the keys.
import { byId, make } from "./elements.js";
import { PlaneView } from "./plane_view.js";

/** Angle of one key press, in radians, and its shift in pixels. */
const TURN = Math.PI / 24;
const SHIFT = 40;
const ZOOM = 1.2;

export function togglePlane(state, views) {
  if (!state.hasPlane) return;
  const plane = byId("plane");
  plane.hidden = !plane.hidden;
  if (!plane.hidden && !views.plane) views.plane = new PlaneView(byId("plane-picture"), state);
  byId("plane-button").setAttribute("aria-pressed", String(!plane.hidden));
  views.space.fit(); // there is more, or less, room for it
}

function toggleButton(name, title, isOn, act) {
  return make("button", { title, "aria-pressed": String(isOn()), onclick: act }, name);
}

export function addTools(state, views) {
  const { space } = views;
  const edges = toggleButton(
    "Edges",
    "edges of elements (E)",
    () => state.showsSides,
    () => state.toggleSides(),
  );
  const contours = toggleButton(
    "Contours",
    "contours (C)",
    () => state.showsContours,
    () => state.toggleContours(),
  );
  const plane = make(
    "button",
    {
      id: "plane-button",
      title: "the (u,v) plane of a patch (V)",
      "aria-pressed": "false",
      onclick: () => togglePlane(state, views),
    },
    "(u,v) plane",
  );
  plane.hidden = !state.hasPlane;
  state.on("sides", () => edges.setAttribute("aria-pressed", String(state.showsSides)));
  state.on("contours", () => contours.setAttribute("aria-pressed", String(state.showsContours)));
  byId("tools").append(
    edges,
    contours,
    plane,
    make(
      "button",
      { title: "the whole mesh, from this side (F)", onclick: () => space.fit() },
      "Fit",
    ),
    make("button", { title: "the first view again (R)", onclick: () => space.reset() }, "Reset"),
    make(
      "button",
      { title: "keys and mouse (?)", onclick: () => byId("shortcuts").showModal() },
      "Help",
    ),
  );
}

/** Keys with what they do and how the page tells it. */
function bindings(state, views) {
  const { space } = views;
  return [
    { keys: ["ArrowLeft"], act: () => space.turn(TURN, 0) },
    { keys: ["ArrowRight"], act: () => space.turn(-TURN, 0) },
    { keys: ["ArrowUp"], act: () => space.turn(0, TURN) },
    { keys: ["ArrowDown"], act: () => space.turn(0, -TURN) },
    { keys: ["Shift+ArrowLeft"], act: () => space.shift(-SHIFT, 0) },
    { keys: ["Shift+ArrowRight"], act: () => space.shift(SHIFT, 0) },
    { keys: ["Shift+ArrowUp"], act: () => space.shift(0, -SHIFT) },
    { keys: ["Shift+ArrowDown"], act: () => space.shift(0, SHIFT) },
    { keys: ["+", "="], act: () => space.zoom(ZOOM) },
    { keys: ["-", "_"], act: () => space.zoom(1 / ZOOM) },
    { keys: ["f"], act: () => space.fit() },
    { keys: ["r"], act: () => space.reset() },
    { keys: ["x"], act: () => space.lookAlong(0) },
    { keys: ["y"], act: () => space.lookAlong(1) },
    { keys: ["z"], act: () => space.lookAlong(2) },
    { keys: ["e"], act: () => state.toggleSides() },
    { keys: ["c"], act: () => state.toggleContours() },
    { keys: ["v"], act: () => togglePlane(state, views) },
    { keys: ["n"], act: () => state.step(1) },
    { keys: ["p"], act: () => state.step(-1) },
    {
      keys: ["a"],
      act: () =>
        state.show(
          state.facts.patches.map((_, p) => p),
          true,
        ),
    },
    { keys: ["Escape"], act: () => state.mark(-1) },
    { keys: ["?"], act: () => byId("shortcuts").showModal() },
  ];
}

const HELP = [
  [["drag"], "turn; one finger"],
  [["right drag", "Shift drag"], "move; two fingers"],
  [["wheel"], "zoom to the pointer; pinch"],
  [["click"], "mark an element"],
  [["double click"], "go to an element"],
  [["←", "→", "↑", "↓"], "turn"],
  [["Shift ← → ↑ ↓"], "move"],
  [["+", "−"], "zoom"],
  [["F", "R"], "fit; reset"],
  [["X", "Y", "Z"], "look along an axis"],
  [["E", "C"], "edges; contours"],
  [["V"], "the (u,v) plane"],
  [["N", "P"], "next and previous of the worst elements"],
  [["A"], "show all patches"],
  [["Esc"], "unmark the element"],
];

function fillHelp() {
  const rows = HELP.flatMap(([keys, what]) => [
    make("dt", {}, ...keys.flatMap((key, i) => [i > 0 ? " " : "", make("kbd", {}, key)])),
    make("dd", {}, what),
  ]);
  byId("shortcuts").append(
    make("h2", {}, "Mouse, touch and keys"),
    make("dl", { class: "pairs" }, ...rows),
    make(
      "div",
      { class: "row" },
      make("button", { onclick: () => byId("shortcuts").close() }, "Close"),
    ),
  );
}

export function addShortcuts(state, views) {
  fillHelp();
  const table = new Map(
    bindings(state, views).flatMap(({ keys, act }) => keys.map((key) => [key, act])),
  );
  window.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || byId("shortcuts").open) return;
    if (document.activeElement?.matches("input:not([type=checkbox]), select")) return;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const act = table.get(event.shiftKey && key.startsWith("Arrow") ? `Shift+${key}` : key);
    if (!act) return;
    event.preventDefault();
    act();
  });
}
