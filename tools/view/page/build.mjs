// SPDX-License-Identifier: BSD-3-Clause
// Put our modules and three.js into one script, dist/viewer.js. The licence of three.js stays in
// it.
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

import { build } from "esbuild";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));

const licence = readFileSync(here("node_modules/three/LICENSE"), "utf8").trim();
const banner = `/*! surfmesh's viewer, BSD-3-Clause. With three.js:\n${licence}\n*/`;

await build({
  entryPoints: [here("src/main.js")],
  outfile: here("dist/viewer.js"),
  bundle: true,
  minify: true,
  format: "iife",
  target: ["chrome103", "firefox113", "safari16.4"], // the first with DecompressionStream
  charset: "utf8",
  legalComments: "none", // the banner has the licence in full
  banner: { js: banner },
  loader: { ".css": "text", ".html": "text" },
  logLevel: "warning",
});
