// SPDX-License-Identifier: BSD-3-Clause
// Measures pages of `surfmesh view` in headless Chromium, drawn by the processor: how long they
// take to write and to open, and how long a frame takes while the mesh turns.
//
//   node tests/view/frame_time.mjs build/release/tools/surfmesh [elements ...]
//
// Meshes of a closed torus (models/torus.obj) and of an open, wavy sheet (models/wave.json).
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, statSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

import { Browser, whatIsMissing } from "./browser.mjs";

const SOURCES = fileURLToPath(new URL("../..", import.meta.url));
const FRAMES = 41;

/** Models with the number of triangles that they have at one size, in % of the diagonal. */
const MODELS = [
  { name: "torus.obj", triangles: 181308, percent: 0.3 },
  { name: "wave.json", triangles: 0, percent: 0.3 },
];

function run(program, ...words) {
  const start = performance.now();
  const text = execFileSync(program, words, {
    encoding: "utf8",
    stdio: ["ignore", "pipe", "inherit"],
  });
  return { seconds: (performance.now() - start) / 1000, text };
}

const faces = (text) => Number(/, (\d+) faces/.exec(text)[1]);

/** Mesh a model with about so many triangles. */
function meshWith(program, folder, model, elements) {
  const path = join(folder, "mesh.om");
  const input = join(SOURCES, "models", model.name);
  const mesh = (percent) =>
    run(
      program,
      "mesh",
      input,
      "-o",
      path,
      "--set",
      "curvature=off",
      "--size",
      `${percent}%`,
      "--set",
      "max_elements=20000000",
      "--quiet",
    );
  if (model.triangles === 0) {
    mesh(model.percent);
    model.triangles = faces(run(program, "view", path, "-o", join(folder, "page.html")).text);
  }
  mesh(model.percent * Math.sqrt(model.triangles / elements));
  return path;
}

/** Times of frames while the mesh turns, in milliseconds: by the clock, and of the processor. */
async function turn(browser, page, hasEdges) {
  const before = browser.processorTime();
  const result = await page.evaluate(
    async ([hasSides, count]) => {
      const { state, views } = await window.surfmeshViewer;
      if (state.showsSides !== hasSides) state.toggleSides();
      const { space } = views;
      const intervals = [];
      let before = null;
      for (let i = 0; i < count; ++i) {
        space.turn(0.05, 0);
        await new Promise(requestAnimationFrame);
        const now = performance.now();
        if (before !== null) intervals.push(now - before);
        before = now;
      }
      const median = (list) => list.sort((a, b) => a - b)[list.length >> 1];
      return { interval: median(intervals.slice(5)), whole: space.picture.cost };
    },
    [hasEdges, FRAMES],
  );
  return { ...result, processor: (browser.processorTime() - before) / FRAMES };
}

async function measure(browser, program, folder, model, elements) {
  const mesh = meshWith(program, folder, model, elements);
  const path = join(folder, "page.html");
  const written = run(program, "view", mesh, "-o", path);
  const page = await browser.open(path);
  const withEdges = await turn(browser, page, true);
  const without = await turn(browser, page, false);
  await page.close();
  const show = ({ interval, processor, whole }) =>
    `${interval.toFixed(0)} (${processor.toFixed(0)}, ${whole.toFixed(0)})`;
  console.log(
    [
      model.name.padEnd(10),
      String(faces(written.text)).padStart(9),
      `${written.seconds.toFixed(2)} s`.padStart(8),
      `${(statSync(path).size / 1e6).toFixed(1)} MB`.padStart(9),
      `${page.secondsToFirstPicture.toFixed(2)} s`.padStart(8),
      show(withEdges).padStart(18),
      show(without).padStart(18),
    ].join("  "),
  );
}

const [program, ...numbers] = process.argv.slice(2);
const missing = whatIsMissing(SOURCES);
if (!program || missing) {
  console.error(missing || "usage: node tests/view/frame_time.mjs SURFMESH [ELEMENTS ...]");
  process.exit(2);
}
const folder = mkdtempSync(join(tmpdir(), "surfmesh_frames."));
const browser = await Browser.start(SOURCES);
try {
  console.log("Frames: median milliseconds between frames (processor time; a whole frame)\n");
  console.log(
    "model         elements   written       page     first    frame with edges     without edges",
  );
  for (const model of MODELS) {
    for (const elements of numbers.length > 0 ? numbers.map(Number) : [50000, 150000, 500000]) {
      await measure(browser, resolve(program), folder, model, elements);
    }
  }
} finally {
  await browser.close();
  rmSync(folder, { recursive: true });
}
