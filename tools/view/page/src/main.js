// SPDX-License-Identifier: BSD-3-Clause
// Starts the page: reads its data, makes the views and the panels.
import { byId, make, whole } from "./elements.js";
import { addElementPanel } from "./element_panel.js";
import { addFigures } from "./figures.js";
import { addHistograms } from "./histograms.js";
import layout from "./layout.html";
import { addContourLabels } from "./contour_labels.js";
import { addNotices, addWorst } from "./places.js";
import { addParts } from "./parts_panel.js";
import { readPage } from "./page_data.js";
import { addPlaneTools } from "./plane_tools.js";
import { addScale } from "./scale.js";
import { SpaceView } from "./space_view.js";
import { State } from "./state.js";
import style from "./style.css";
import { addShortcuts, addTools } from "./tools.js";
import { addTriad } from "./triad.js";

function layOut(facts) {
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(style);
  document.adoptedStyleSheets = [sheet];
  const template = document.createElement("template");
  template.innerHTML = layout; // our own text, without anything of the model
  document.body.append(template.content);
  byId("title").textContent = facts.title;
}

function tellCounts({ surface, facts }) {
  const kinds = [0, 0, 0];
  for (let f = 0; f < surface.faceCount; ++f) {
    ++kinds[Math.min(2, surface.first[f + 1] - surface.first[f] - 3)];
  }
  const counts = [
    [kinds[0], "triangle", "triangles"],
    [kinds[1], "quad", "quads"],
    [kinds[2], "polygon", "polygons"],
    [surface.vertexCount, "vertex", "vertices"],
    [facts.patches.length, "patch", "patches"],
  ];
  const parts = counts.filter(([n]) => n > 0);
  byId("counts").textContent = parts
    .map(([n, one, more]) => `${whole(n)} ${n === 1 ? one : more}`)
    .join(" · ");
}

async function start() {
  const page = await readPage();
  layOut(page.facts);
  const state = new State(page);
  tellCounts(state);
  const space = new SpaceView(byId("space-picture"), state);
  const views = { space, plane: null };
  addTools(state, views);
  addShortcuts(state, views);
  addScale(state);
  addTriad(space);
  addContourLabels(state, space);
  addParts(state, views);
  addElementPanel(state, views);
  addWorst(state, space);
  addNotices(state, space);
  addHistograms(state);
  addFigures(state);
  addPlaneTools(state, views);
  space.reset(); // now that all around the picture has its size
  return { state, views };
}

/** For tests and measurements: resolves when the page is there. */
window.surfmeshViewer = start();
window.surfmeshViewer.catch((error) => {
  document.body.append(
    make("p", { class: "fault" }, `This page cannot be shown: ${error.message}`),
  );
});
