// SPDX-License-Identifier: BSD-3-Clause
// Makes the picture of libsurfmesh/VIEW.md: a page of a cage that was meshed.
//
//   node tests/view/screenshot.mjs build/release/tools/surfmesh libsurfmesh/pictures/view.png
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

import { Browser, whatIsMissing } from "./browser.mjs";

const SOURCES = fileURLToPath(new URL("../..", import.meta.url));
const MODEL = ["models/knob.obj", "--mesh", "--curvature", "0.5"];

const [program, picture] = process.argv.slice(2);
const missing = whatIsMissing(SOURCES);
if (!program || !picture || missing) {
  console.error(missing || "usage: node tests/view/screenshot.mjs SURFMESH PICTURE.png");
  process.exit(2);
}
const folder = mkdtempSync(join(tmpdir(), "surfmesh_picture."));
const browser = await Browser.start(SOURCES);
try {
  const path = join(folder, "page.html");
  execFileSync(resolve(program), ["view", ...MODEL, "-o", path], { cwd: SOURCES });
  const page = await browser.open(path, { width: 1120, height: 620 });
  await page.selectOption("#field", "size");
  await page.locator("#groups > summary").click();
  await page.waitForTimeout(3000); // until the picture is drawn at its best
  await page.screenshot({ path: picture });
} finally {
  await browser.close();
  rmSync(folder, { recursive: true });
}
