// SPDX-License-Identifier: BSD-3-Clause
// What the plane shows: the patch, its mesh, control mesh and ellipses, and (u,v) at the pointer.
import { controlMesh } from "./control.js";
import { byId, make, swatch, whole } from "./elements.js";
import { text } from "./fields.js";

function patchChoice(state) {
  const choice = make("select", {
    "aria-label": "patch",
    onchange: () => state.choosePlane(Number(choice.value)),
  });
  state.facts.patches.forEach((_, p) =>
    choice.append(make("option", { value: String(p) }, state.patchName(p))),
  );
  state.on("plane", () => (choice.value = String(state.planePatch)));
  choice.value = String(state.planePatch);
  return choice;
}

function box(state, what, name) {
  const input = make("input", {
    type: "checkbox",
    checked: state.planeShows[what],
    onchange: () => state.showInPlane(what, input.checked),
  });
  state.on("plane", () => (input.checked = state.planeShows[what]));
  return make("label", {}, input, name);
}

function ellipseChoice(state) {
  const choice = make("select", {
    id: "ellipses",
    "aria-label": "ellipses of the metric",
    title:
      "An ellipse is as wide as the elements asked for: its diameters have the metric length 1.",
    onchange: () => state.showInPlane("ellipses", choice.value),
  });
  state.on("plane", () => (choice.value = state.planeShows.ellipses));
  choice.append(make("option", { value: "none" }, "no ellipses"));
  if (state.surface.metric) choice.append(make("option", { value: "mesh" }, "metric at vertices"));
  if (state.facts.control)
    choice.append(make("option", { value: "control" }, "metric at control nodes"));
  return choice;
}

function addLegend(state, card) {
  const legend = make("div", { class: "legend" });
  const show = () => {
    const control = state.planeShows.control ? controlMesh(state, state.planePatch) : null;
    legend.replaceChildren(
      ...(control ? control.counts() : []).map(({ name, text: meaning, colour, count }) =>
        make(
          "span",
          { title: `sizes from ${meaning}` },
          swatch(colour),
          ` ${name} ${whole(count)}`,
        ),
      ),
    );
  };
  state.on("plane", show);
  show();
  card.append(legend);
}

function addPlace(state, views) {
  const place = byId("plane-place");
  byId("plane").addEventListener("pointermove", (event) => {
    if (!views.plane || event.target !== views.plane.picture.canvas) return;
    const [u, v] = views.plane.toParameters(...views.plane.pointAt(event.offsetX, event.offsetY));
    place.textContent = `u ${text(u)}, v ${text(v)}`;
  });
  byId("plane").addEventListener("pointerleave", () => (place.textContent = ""));
}

export function addPlaneTools(state, views) {
  if (!state.hasPlane) return;
  const card = byId("plane-tools");
  card.append(patchChoice(state), box(state, "mesh", "mesh"));
  if (state.facts.control) card.append(box(state, "control", "control mesh"));
  if (state.surface.metric || state.facts.control) card.append(ellipseChoice(state));
  card.append(
    make("button", { title: "the whole patch", onclick: () => views.plane?.fit() }, "Fit"),
  );
  addLegend(state, card);
  addPlace(state, views);
}
