// SPDX-License-Identifier: BSD-3-Clause
// Opens pages of `surfmesh view` in headless Chromium, drawn by the processor, and notes every
// error and every request that leaves the page.
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";

/** Where Debian and others have it; the variable is for another place. */
const CHROMIUM = [
  process.env.CHROMIUM,
  "/usr/bin/chromium",
  "/usr/bin/chromium-browser",
  "/usr/bin/google-chrome",
];

/** What is missing for a test in a browser, in words; empty if nothing is. */
export function whatIsMissing(sources) {
  if (!CHROMIUM.some((path) => path && existsSync(path))) {
    return "Chromium is not installed: tools/setup.sh --readers --viewer";
  }
  const parts = ["dist/viewer.js", "node_modules/playwright-core"];
  const missing = parts.find((part) => !existsSync(`${sources}/tools/view/page/${part}`));
  return missing ? `tools/view/page/${missing} is not there: tools/setup.sh --viewer` : "";
}

export class Browser {
  static async start(sources) {
    const require = createRequire(`${sources}/tools/view/page/package.json`);
    const { chromium } = require("playwright-core");
    const browser = await chromium.launch({
      executablePath: CHROMIUM.find((path) => path && existsSync(path)),
      // Root has no sandbox; the others give a picture that does not depend on the machine.
      args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
    });
    return new Browser(browser);
  }

  constructor(browser) {
    this.browser = browser;
  }

  /** Open a page and wait for its first picture. */
  async open(path, { width = 1280, height = 800 } = {}) {
    const page = await this.browser.newPage({ viewport: { width, height } });
    page.faults = [];
    page.on("pageerror", (error) => page.faults.push(`error: ${error.message}`));
    page.on("console", (message) => {
      // Chromium complains of reading pixels, by which the page measures its frames.
      if (message.type() !== "log" && !message.text().includes("ReadPixels")) {
        page.faults.push(`${message.type()}: ${message.text()}`);
      }
    });
    const url = pathToFileURL(path).href;
    page.on("request", (request) => {
      if (request.url() !== url && !request.url().startsWith("data:")) {
        page.faults.push(`request: ${request.url()}`);
      }
    });
    const start = performance.now();
    await page.goto(url, { timeout: 120000, waitUntil: "commit" });
    await page.waitForFunction(() => window.surfmeshViewer, null, { timeout: 120000 });
    await page.evaluate(async () => {
      const { views } = await window.surfmeshViewer;
      while (views.space.picture.frames === 0) await new Promise(requestAnimationFrame);
    });
    page.secondsToFirstPicture = (performance.now() - start) / 1000;
    return page;
  }

  /**
   * Processor time of all parts of the browser so far, in milliseconds (Linux). Unlike the clock,
   * it does not count what else the machine does.
   */
  processorTime() {
    const MILLISECONDS_A_TICK = 10; // of /proc/*/stat, on all Linux systems
    const processes = readdirSync("/proc")
      .filter((name) => /^\d+$/.test(name))
      .map(statOf)
      .filter(Boolean);
    const own = new Set([process.pid]);
    for (let before = 0; before !== own.size;) {
      before = own.size;
      for (const { pid, parent } of processes) if (own.has(parent)) own.add(pid);
    }
    own.delete(process.pid);
    const ticks = processes.filter(({ pid }) => own.has(pid)).reduce((sum, p) => sum + p.ticks, 0);
    return MILLISECONDS_A_TICK * ticks;
  }

  close() {
    return this.browser.close();
  }
}

/** A process by its number; null where it has just ended. */
function statOf(pid) {
  try {
    const words = readFileSync(`/proc/${pid}/stat`, "utf8").split(") ").pop().split(" ");
    return {
      pid: Number(pid),
      parent: Number(words[1]),
      ticks: Number(words[11]) + Number(words[12]),
    };
  } catch {
    return null;
  }
}
