// SPDX-License-Identifier: BSD-3-Clause
// A canvas that is drawn when something has changed. Where the browser draws by the processor, the
// picture has more pixels when it stands still, and fewer while it moves if frames are slow.
import { WebGLRenderer } from "three";

/** How long nothing must move before a picture is drawn at its best, in milliseconds. */
const STILL = 180;

/** Frames that take longer, in milliseconds, are slow. */
const SLOW = 60;

/** Pixels to a pixel of the page, along each side, while a picture moves whose frames are slow. */
const COARSE = 0.7;

/** A picture that is drawn faster may have four times the pixels when it stands still. */
const FAST = 45;

function isDrawnByProcessor(gl) {
  const names = gl.getExtension("WEBGL_debug_renderer_info");
  const renderer = String(gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  return /swiftshader|llvmpipe|software|basic render/i.test(renderer);
}

function drawsByProcessor() {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (!gl) throw new Error("this browser has no WebGL 2");
  const result = isDrawnByProcessor(gl);
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return result;
}

let byProcessor = null;

export class Picture {
  /** `draw(renderer, isMoving)` draws a frame, and returns true if it leaves nothing out. */
  constructor(container, draw) {
    byProcessor ??= drawsByProcessor();
    this.container = container;
    this.draw = draw;
    this.renderer = new WebGLRenderer({
      antialias: !byProcessor,
      alpha: false,
      powerPreference: "high-performance",
    });
    this.renderer.setClearColor(0xf7f9fb);
    this.canvas = this.renderer.domElement;
    container.append(this.canvas);
    this.ratio = 0;
    this.isWanted = false;
    this.cost = 0; // of a whole frame at one pixel to a pixel, in milliseconds
    this.frames = 0;
    new ResizeObserver(() => this.invalidate()).observe(container);
    this.canvas.addEventListener("webglcontextrestored", () => this.invalidate());
  }

  get width() {
    return this.container.clientWidth;
  }

  get height() {
    return this.container.clientHeight;
  }

  /** Ask for a frame; `isMoving` if others will follow. */
  invalidate(isMoving = false) {
    clearTimeout(this.timer);
    this.isMoving = isMoving;
    if (this.isWanted) return;
    this.isWanted = true;
    requestAnimationFrame(() => this.frame());
  }

  /** True if a whole frame takes long. The first one does not count: shaders are compiled. */
  get isSlow() {
    return this.frames > 1 && this.cost > SLOW;
  }

  bestRatio() {
    if (!byProcessor) return Math.min(2, window.devicePixelRatio);
    if (this.isMoving) return this.isSlow ? COARSE : 1;
    return this.frames > 1 && this.cost < FAST ? 2 : 1;
  }

  frame() {
    this.isWanted = false;
    if (this.width === 0 || this.height === 0) return;
    const start = performance.now();
    this.fit();
    const isWhole = this.draw(this.renderer, this.isMoving);
    if (byProcessor) this.measure(start, isWhole);
    ++this.frames;
    // Counted from the end of the frame, and longer after a slow one: else whole frames would be
    // drawn while the mesh turns, which makes it slower still.
    const wait = Math.max(STILL, 2 * (performance.now() - start));
    if (this.isMoving) this.timer = setTimeout(() => this.invalidate(), wait);
  }

  /** Wait for the frame: it shows what frames cost, and keeps others from piling up behind it. */
  measure(start, isWhole) {
    const gl = this.renderer.getContext();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    if (isWhole && this.ratio === 1) this.cost = performance.now() - start;
    if (this.frames < 2) this.invalidate(true);
  }

  fit() {
    const ratio = this.bestRatio();
    const { width, height } = this;
    if (ratio === this.ratio && width === this.fitted?.[0] && height === this.fitted?.[1]) return;
    this.ratio = ratio;
    this.fitted = [width, height];
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height);
  }
}
