// SPDX-License-Identifier: BSD-3-Clause
// Histograms of metric lengths and of quality; of angles for meshes without a metric.
import { css, make, section, whole } from "./elements.js";
import { dot, minus } from "./surface.js";
import { shareOf, text } from "./fields.js";

const WIDTH = 310;
const HEIGHT = 92;
const FOOT = 16;
const HEAD = 12;

function svg(tag, attributes, ...children) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

/** Bars of equal width; `bins` have from, to, count and a colour. */
function chart(bins, name) {
  const greatest = Math.max(1, ...bins.map((bin) => bin.count));
  const total = Math.max(
    1,
    bins.reduce((sum, bin) => sum + bin.count, 0),
  );
  const step = (WIDTH - 20) / bins.length;
  const height = (count) => ((HEIGHT - FOOT - HEAD) * count) / greatest;
  const drawing = svg("svg", {
    class: "histogram",
    viewBox: `0 0 ${WIDTH} ${HEIGHT}`,
    role: "img",
    "aria-label": name,
  });
  const every = Math.ceil(bins.length / 10);
  bins.forEach((bin, i) => {
    const h = height(bin.count);
    const title = `${text(bin.from)} to ${text(bin.to)}: ${whole(bin.count)}, ${((100 * bin.count) / total).toPrecision(3)} %`;
    drawing.append(
      svg(
        "rect",
        {
          x: 10 + i * step + 0.5,
          y: HEIGHT - FOOT - h,
          width: step - 1,
          height: bin.count > 0 ? Math.max(1, h) : 0,
          fill: css(bin.colour),
          stroke: "#00000022",
        },
        svg("title", {}, title),
      ),
    );
    if (bin.count === greatest) {
      drawing.append(
        svg(
          "text",
          { x: 10 + (i + 0.5) * step, y: HEAD - 3 },
          `${((100 * bin.count) / total).toPrecision(3)} %`,
        ),
      );
    }
    if (i % every === 0)
      drawing.append(svg("text", { x: 10 + i * step, y: HEIGHT - 4 }, text(bin.from)));
  });
  drawing.append(svg("text", { x: WIDTH - 10, y: HEIGHT - 4 }, text(bins[bins.length - 1].to)));
  drawing.append(
    svg("line", { class: "axis", x1: 8, y1: HEIGHT - FOOT, x2: WIDTH - 8, y2: HEIGHT - FOOT }),
  );
  return drawing;
}

/** Counts of values in bins of equal width. */
function count(values, from, to, parts) {
  const bins = Array.from({ length: parts }, (_, i) => ({
    from: from + ((to - from) * i) / parts,
    to: from + ((to - from) * (i + 1)) / parts,
    count: 0,
  }));
  for (const value of values) {
    if (Number.isNaN(value)) continue;
    const i = Math.floor(((value - from) / (to - from)) * parts);
    ++bins[Math.min(parts - 1, Math.max(0, i))].count;
  }
  return bins;
}

/** The angles at all corners, in degrees. */
function angles(surface) {
  const result = new Float32Array(surface.corners.length);
  let at = 0;
  for (let f = 0; f < surface.faceCount; ++f) {
    const points = surface.pointsOf(f);
    const size = points.length;
    for (let i = 0; i < size; ++i) {
      const a = minus(points[(i + 1) % size], points[i]);
      const b = minus(points[(i + size - 1) % size], points[i]);
      const cosine = dot(a, b) / Math.sqrt(dot(a, a) * dot(b, b));
      result[at++] = (Math.acos(Math.min(1, Math.max(-1, cosine))) * 180) / Math.PI;
    }
  }
  return result;
}

function addQuality(state, body, name, title) {
  const field = state.fields.find(name);
  if (!field) return;
  const bins = count(field.values, 0, 1, 20);
  for (const bin of bins) bin.colour = state.fields.mapColour("goodness", (bin.from + bin.to) / 2);
  body.append(make("h3", {}, title), chart(bins, title));
}

function addLengths(state, body) {
  const { edges } = state.facts;
  if (!edges || edges.count === 0) return;
  const scale = { from: 0.5, to: 2, log: true };
  const bins = edges.histogram.map((bin) => ({
    ...bin,
    colour: state.fields.mapColour(
      "deviations",
      shareOf(scale, Math.sqrt(Math.max(bin.from, 0.1) * bin.to)),
    ),
  }));
  const share = (100 * edges.unit_share).toFixed(1);
  body.append(
    make("h3", {}, "Metric length of edges"),
    chart(bins, "Metric length of edges"),
    make(
      "p",
      { class: "soft" },
      `mean ${text(edges.mean)}, deviation ${text(edges.deviation)}, from ${text(edges.min)} to ${text(edges.max)}; ${share} % in [1/√2, √2]`,
    ),
  );
}

function addAngles(state, body) {
  const bins = count(angles(state.surface), 0, 180, 18);
  for (const bin of bins) bin.colour = [120, 154, 190];
  body.append(make("h3", {}, "Angles in space, degrees"), chart(bins, "Angles in space"));
}

export function addHistograms(state) {
  const { body, element } = section("histograms", "Histograms");
  // Made when they are first seen: for large meshes they take as long as a picture.
  const fill = () => {
    if (!element.open || body.childElementCount > 0) return;
    addLengths(state, body);
    addQuality(state, body, "quality", "Quality in the metric");
    if (!state.facts.edges) addAngles(state, body);
    addQuality(state, body, "shape", "Quality in space");
  };
  element.addEventListener("toggle", fill);
  setTimeout(fill, 0);
}
