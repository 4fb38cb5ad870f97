// SPDX-License-Identifier: BSD-3-Clause
// A canvas that is drawn when something has changed. Where the browser draws by the processor, the
// picture is coarser while it moves, and sharp when it stands still.
import { WebGLRenderer } from "three";

/** How long nothing must move before a picture is drawn at its best, in milliseconds. */
const STILL = 180;

/** A frame that takes longer, in milliseconds, is drawn coarser while it moves. */
const SLOW = 90;

/** A picture that is drawn faster may have four times the pixels when it stands still. */
const FAST = 45;

/** Pixels to a pixel of the page, along each side, where frames are slow. */
const COARSE = 0.6;

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
  /** `draw(renderer, isMoving)` draws one frame. */
  constructor(container, draw) {
    byProcessor ??= drawsByProcessor();
    this.container = container;
    this.draw = draw;
    this.renderer = new WebGLRenderer({ antialias: !byProcessor, powerPreference: "high-performance" });
    this.renderer.setClearColor(0xffffff, 0);
    this.canvas = this.renderer.domElement;
    container.append(this.canvas);
    this.ratio = 0;
    this.isWanted = false;
    this.cost = 0; // of a frame at one pixel to a pixel, in milliseconds
    this.lastFrame = 0;
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
    if (isMoving) this.timer = setTimeout(() => this.invalidate(), STILL);
    this.isMoving = isMoving;
    if (this.isWanted) return;
    this.isWanted = true;
    requestAnimationFrame(() => this.frame());
  }

  bestRatio() {
    if (!byProcessor) return Math.min(2, window.devicePixelRatio);
    if (this.frames < 2) return 1; // the first one takes longer: shaders are compiled
    if (this.isMoving) return this.cost > SLOW ? COARSE : 1;
    return this.cost < FAST ? 2 : 1;
  }

  frame() {
    this.isWanted = false;
    if (this.width === 0 || this.height === 0) return;
    const start = performance.now();
    this.fit();
    this.draw(this.renderer, this.isMoving);
    if (byProcessor) this.measure(start);
  }

  /** Wait for the frame: it shows what frames cost, and keeps others from piling up behind it. */
  measure(start) {
    const gl = this.renderer.getContext();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    this.lastFrame = performance.now() - start;
    if (this.ratio === 1) this.cost = this.lastFrame;
    // Much less is to be seen now, and a frame will be fast at full resolution, too.
    if (this.ratio < 1 && this.lastFrame < SLOW / 4) this.cost = 0;
    if (++this.frames < 3) this.invalidate(true);
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
