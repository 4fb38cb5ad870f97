// SPDX-License-Identifier: BSD-3-Clause
// Names of contours at the middles of their lines.
import { byId, make } from "./elements.js";

/** More names at once hide each other: only that of the chosen contour is shown then. */
const MOST = 60;

/** A point in the middle of the segments of each contour. */
function middles(state) {
  const { lines, contourOfLine, surface } = state;
  const segments = new Map();
  if (!contourOfLine) return segments;
  contourOfLine.forEach((contour, i) => {
    if (contour < 0) return;
    if (!segments.has(contour)) segments.set(contour, []);
    segments.get(contour).push(i);
  });
  for (const [contour, list] of segments) {
    const i = list[list.length >> 1];
    const a = surface.point(lines[2 * i]),
      b = surface.point(lines[2 * i + 1]);
    segments.set(
      contour,
      a.map((x, k) => (x + b[k]) / 2),
    );
  }
  return segments;
}

export function addContourLabels(state, space) {
  const places = middles(state);
  const layer = byId("labels");
  const labels = new Map();
  const wanted = () => {
    const isNamed = (contour) => Boolean(state.facts.contours[contour]);
    const all = state.showsContourNames ? [...places.keys()].filter(isNamed).slice(0, MOST) : [];
    return new Set(state.chosenContour >= 0 ? [...all, state.chosenContour] : all);
  };
  const make_labels = () => {
    labels.clear();
    for (const contour of wanted()) {
      if (!places.has(contour)) continue;
      const isChosen = contour === state.chosenContour;
      const label = make("span", { class: isChosen ? "chosen" : "" }, state.contourName(contour));
      labels.set(contour, label);
    }
    layer.replaceChildren(...labels.values());
  };
  space.afterDraw.push(() => {
    for (const [contour, label] of labels) {
      const at = space.project(places.get(contour));
      label.hidden = at === null;
      if (at) label.style.transform = `translate(${at[0]}px, ${at[1]}px) translate(-50%, -50%)`;
    }
  });
  state.on("contours", make_labels);
}
