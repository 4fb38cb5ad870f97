// SPDX-License-Identifier: BSD-3-Clause
// Opens pages of `surfmesh view` in a browser and uses them: looks at pixels, clicks, presses keys.
//
//   node tests/view/pages_test.mjs build/release/tools/surfmesh
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

import { Browser, whatIsMissing } from "./browser.mjs";
import { readPng } from "./read_png.mjs";

const SOURCES = fileURLToPath(new URL("../..", import.meta.url));
const SKIPPED = 77; // as CMake's SKIP_RETURN_CODE has it

/** A name that would end the script and begin bold text, if names were markup. */
const EVIL = "</script><b>";

/** Two quads side by side and a triangle above them, each a patch. */
const PLATE = `v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 1 2 0
g left\nf 1 2 5 4\ng ${EVIL}\nf 2 3 6 5\ng top\nf 4 5 7\n`;

class Pages {
  constructor(program, folder, browser) {
    Object.assign(this, { program, folder, browser });
  }

  /** Make a page of an input and open it. */
  async open(input, options = [], size = {}) {
    const path = join(this.folder, "page.html");
    const { status, stderr } = spawnSync(this.program, [
      "view",
      input,
      "-o",
      path,
      "--quiet",
      ...options,
    ]);
    // 3: done, but something was not reached, of which a notice tells.
    assert.ok(status === 0 || status === 3, stderr.toString());
    return this.browser.open(path, size);
  }

  file(name, text) {
    const path = join(this.folder, name);
    writeFileSync(path, text);
    return path;
  }

  model(name) {
    return join(SOURCES, "models", name);
  }

  /** The picture of a page as it stands still: a function that gives the colour at x, y. */
  async picture(page) {
    await page.evaluate(async () => {
      const { views } = await window.surfmeshViewer;
      for (const view of [views.space, views.plane]) view?.picture.invalidate();
      for (let i = 0; i < 3; ++i) await new Promise(requestAnimationFrame);
    });
    return readPng(await page.screenshot());
  }
}

/** Where in the window a point of the mesh is; `share` goes from its middle to its first corner. */
const placeOf = (page, face, share = 0) =>
  page.evaluate(
    async ([f, s]) => {
      const { state, views } = await window.surfmeshViewer;
      const middle = state.surface.middleOf(f);
      const corner = state.surface.pointsOf(f)[0];
      const [x, y] = views.space.project(middle.map((c, k) => c + s * (corner[k] - c)));
      const box = views.space.picture.canvas.getBoundingClientRect();
      return [box.x + x, box.y + y];
    },
    [face, share],
  );

const inPage = (page, act) =>
  page.evaluate(`(async () => { const { state, views } = await window.surfmeshViewer; ${act} })()`);

/** The colour that the list of patches shows for a patch. */
const swatchOf = async (page, patch) => {
  const text = await page
    .locator("#patches li")
    .nth(patch)
    .locator(".swatch")
    .evaluate((e) => getComputedStyle(e).backgroundColor);
  return text.match(/\d+/g).map(Number);
};

/** True for colours that differ by the light only. */
function isShadeOf(colour, full) {
  const light = colour.reduce((sum, c) => sum + c, 0) / full.reduce((sum, c) => sum + c, 0);
  return light > 0.4 && light < 1.2 && colour.every((c, k) => Math.abs(c - light * full[k]) < 14);
}

const differ = (a, b) => a.some((c, k) => Math.abs(c - b[k]) > 24);
const BACKGROUND = [247, 249, 251];

function checkFaults(page) {
  assert.deepEqual(page.faults, []);
}

const TESTS = {
  async "shows each patch in its colour"(pages) {
    const page = await pages.open(pages.file("plate.obj", PLATE));
    const at = await pages.picture(page);
    for (const face of [0, 1, 2]) {
      const place = await placeOf(page, face, 0.3);
      const colour = at(...place);
      assert.ok(isShadeOf(colour, await swatchOf(page, face)), `face ${face} is ${colour}`);
    }
    assert.deepEqual(at(20, 120), BACKGROUND);
    assert.equal(await page.title(), "plate.obj");
    checkFaults(page);
    return page;
  },

  async "shows names as they are, whatever they are"(pages, page) {
    assert.equal(await page.locator("#patches li .name").nth(1).textContent(), EVIL);
    assert.equal(await page.locator("b").count(), 0);
    assert.equal(
      await page.locator("#counts").textContent(),
      "1 triangle · 2 quads · 7 vertices · 3 patches",
    );
  },

  async "draws quads with their own edges"(pages, page) {
    const at = await pages.picture(page);
    const inside = at(...(await placeOf(page, 0, 0)));
    assert.ok(isShadeOf(inside, await swatchOf(page, 0)), "there is no diagonal");
    const sides = await inPage(page, "return state.surface.triangleSides.join()");
    assert.equal(sides.split(",").filter((bits) => bits === "7").length, 1);
  },

  async "changes colours with the field and its range"(pages, page) {
    const place = await placeOf(page, 0, 0.3);
    const before = (await pages.picture(page))(...place);
    await page.selectOption("#field", "shape");
    const good = (await pages.picture(page))(...place);
    assert.ok(differ(before, good));
    assert.ok(isShadeOf(good, [0x1a, 0x98, 0x50]), `a square is best: ${good}`);
    assert.equal(await page.locator("#scale .ticks span").last().textContent(), "1");
    await page.getByLabel("greatest value").fill("4");
    await page.getByLabel("greatest value").press("Enter");
    assert.ok(differ((await pages.picture(page))(...place), good));
    await page.selectOption("#field", "patch");
  },

  async "marks the element that is clicked"(pages, page) {
    await page.mouse.click(...(await placeOf(page, 1)));
    assert.equal(await page.locator("#marked-face").textContent(), "1");
    assert.equal(await page.locator("#element button.link").first().textContent(), EVIL);
    assert.match(await page.locator("#element .body").textContent(), /Quad1patch.*shape1/);
    await page.keyboard.press("Escape");
    assert.equal(await page.locator("#marked-face").count(), 0);
    await page.mouse.click(20 + 10, 120);
    assert.equal(await page.locator("#marked-face").count(), 0);
  },

  async "switches patches off and on"(pages, page) {
    const place = await placeOf(page, 2, 0.3);
    await page.locator("#patches li input").nth(2).click();
    assert.ok(!differ((await pages.picture(page))(...place), BACKGROUND));
    await page.mouse.click(...place);
    assert.equal(await page.locator("#marked-face").count(), 0, "what is hidden cannot be marked");
    await page.locator("#patches button", { hasText: "none" }).click();
    assert.ok(!differ((await pages.picture(page))(...(await placeOf(page, 0, 0.3))), BACKGROUND));
    await page.locator("#patches button", { hasText: "all" }).click();
    assert.ok(differ((await pages.picture(page))(...place), BACKGROUND));
  },

  async "obeys keys"(pages, page) {
    const camera = () => inPage(page, "return views.space.camera.position.toArray()");
    const before = await camera();
    await page.keyboard.press("ArrowLeft");
    await page.keyboard.press("ArrowUp");
    const turned = await camera();
    assert.ok(Math.abs(Math.hypot(...turned) - Math.hypot(...before)) < 1e-6);
    assert.ok(
      differ(
        turned.map((x) => 255 * x),
        before.map((x) => 255 * x),
      ),
    );
    await page.keyboard.press("+");
    assert.ok(Math.hypot(...(await camera())) < 0.9 * Math.hypot(...before));
    await page.keyboard.press("r");
    assert.ok(Math.hypot(...(await camera()).map((x, k) => x - before[k])) < 1e-6);
    await page.keyboard.press("n");
    assert.equal(await page.locator("#marked-face").textContent(), "2", "the triangle is worst");
    await page.keyboard.press("?");
    assert.ok(await page.locator("#shortcuts").isVisible());
    await page.keyboard.press("Escape");
    checkFaults(page);
    await page.close();
  },

  async "shows a model with its plane, control mesh and ellipses"(pages) {
    const page = await pages.open(pages.model("wave.json"));
    await page.locator("#plane-button").click();
    assert.match(await page.locator("#plane-tools .legend").textContent(), /linear \d/);
    const box = await page.locator("#plane canvas").boundingBox();
    const middle = [box.x + box.width / 2, box.y + box.height / 2];
    const picture = async () => {
      const at = await pages.picture(page);
      return Array.from({ length: 120 }, (_, i) => at(middle[0] - 60 + i, middle[1]));
    };
    const before = await picture();
    assert.ok(
      before.every((colour) => differ(colour, BACKGROUND)),
      "the patch fills the middle",
    );
    await page.selectOption("#ellipses", "control");
    assert.ok(
      (await picture()).some((colour, i) => differ(colour, before[i])),
      "ellipses are seen",
    );
    await page.mouse.click(...middle);
    assert.match(await page.locator("#element .body").textContent(), /m11/);
    assert.match(await page.locator("#element .body").textContent(), /metric length/);
    return page;
  },

  async "shows histograms and the report"(pages, page) {
    await page.locator("#histograms svg").first().scrollIntoViewIfNeeded();
    assert.equal(await page.locator("#histograms svg").count(), 3);
    await page.locator("#figures > summary").click();
    // The section is filled when the browser tells that it is open, which is after the click.
    await page.locator("#figures .body > *").first().waitFor();
    assert.match(await page.locator("#figures .body").textContent(), /control space.*nodes/);
    checkFaults(page);
    await page.close();
  },

  async "fits a small window"(pages) {
    const page = await pages.open(pages.model("knob.obj"), ["--mesh"], { width: 420, height: 640 });
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(width <= 420, `nothing sticks out: ${width}`);
    await page.selectOption("#field", "sag");
    await page.locator("#groups li").first().scrollIntoViewIfNeeded();
    assert.equal(await page.locator("#groups li .name").first().textContent(), "flange");
    checkFaults(page);
    await page.close();
  },

  async "goes where a notice points"(pages) {
    const page = await pages.open(pages.file("jump.json", JUMP));
    const link = page.locator("#notices .notice button").first();
    const before = await inPage(page, "return views.space.controls.target.toArray()");
    await link.click();
    const after = await inPage(page, "return views.space.controls.target.toArray()");
    assert.notDeepEqual(after, before);
    const [x] = await page.evaluate(
      async ([p]) => (await window.surfmeshViewer).state.modelPoint(p),
      [after],
    );
    assert.ok(Math.abs(x - 0.77) < 0.01, `the jump is at u = 0.77, this is ${x}`);
    checkFaults(page);
    await page.close();
  },
};

/** A model whose surface jumps inside its patch, of which a notice tells with the place. */
const JUMP = JSON.stringify({
  patches: [
    {
      name: "a",
      surface: { x: "u", y: "v", z: "if(u<0.77,0,0.2)" },
      domain: { u: [0, 1], v: [0, 1] },
    },
  ],
  sizing: { hmax: 0.3 },
});

const program = process.argv[2] && resolve(process.argv[2]);
const missing = whatIsMissing(SOURCES);
if (!program || missing) {
  console.log(missing ? `skipped: ${missing}` : "usage: node tests/view/pages_test.mjs SURFMESH");
  process.exit(missing ? SKIPPED : 2);
}
const folder = mkdtempSync(join(tmpdir(), "surfmesh_pages."));
const browser = await Browser.start(SOURCES);
let failed = 0;
try {
  const pages = new Pages(program, folder, browser);
  let page;
  for (const [name, test] of Object.entries(TESTS)) {
    try {
      page = (await test(pages, page)) ?? page;
      console.log(`ok      ${name}`);
    } catch (error) {
      ++failed;
      console.log(`FAILED  ${name}\n${error.stack}`);
    }
  }
} finally {
  await browser.close();
  rmSync(folder, { recursive: true });
}
process.exit(failed > 0 ? 1 : 0);
