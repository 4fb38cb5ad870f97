// SPDX-License-Identifier: BSD-3-Clause
// The (u,v) plane of one patch: its mesh, its control mesh by classes, and ellipses of the metric.
import { OrthographicCamera, Scene, Vector3 } from "three";

import { controlMesh } from "./control.js";
import { Lines, closedLine, linear } from "./lines.js";
import { paint, planeDrawing } from "./mesh_drawing.js";
import { Picture } from "./picture.js";
import { onClick } from "./space_view.js";

/** More ellipses take too long to draw. */
const MOST_ELLIPSES = 500;

/** Of more points a part is tried. */
const MOST_TRIED = 20000;

/** Corners of the polygon that an ellipse is drawn as. */
const ELLIPSE_CORNERS = 28;

const ELLIPSE = 0x7a1fa2;

/** Axes of the plane are of one scale unless one range is this many times the other. */
const UNEVEN = 5;

export class PlaneView {
  constructor(container, state) {
    this.state = state;
    this.container = container;
    this.scene = new Scene();
    this.camera = new OrthographicCamera();
    this.camera.position.z = 1;
    this.centre = [0, 0];
    this.scale = 1; // half of the height of the picture
    this.control = new Lines({ width: 1.6, hasColours: true });
    this.ellipses = new Lines({ width: 1.2, colour: ELLIPSE });
    this.outline = new Lines({ width: 3, colour: 0xd9480f });
    [this.control, this.ellipses, this.outline].forEach((lines, i) => {
      lines.object.position.z = 0.1 * (i + 1);
      this.scene.add(lines.object);
    });
    this.picture = new Picture(container, (renderer) => this.draw(renderer));
    this.listen();
    this.listenToPointer();
    this.show();
  }

  listen() {
    const { state } = this;
    state.on("colours", () => this.colour());
    state.on("sides", () => this.picture.invalidate());
    state.on("plane", () => this.show());
    state.on("marked", () => {
      this.colour();
      this.markFace();
    });
  }

  /** Show the patch that is chosen. */
  show() {
    const { surface, planePatch } = this.state;
    if (this.drawing) {
      this.scene.remove(this.drawing.mesh);
      this.drawing.dispose();
    }
    this.setAxes(planePatch);
    this.drawing = planeDrawing(surface, planePatch, (u, v) => this.toPlane(u, v));
    this.scene.add(this.drawing.mesh);
    this.colour();
    this.setControl();
    this.setEllipses();
    this.markFace();
    this.fit();
  }

  /** The box of the patch, and how u and v become x and y from -1 to 1 at most. */
  setAxes(patch) {
    const { surface } = this.state;
    const low = [Infinity, Infinity],
      high = [-Infinity, -Infinity];
    for (let f = 0; f < surface.faceCount; ++f) {
      if (surface.patchOf(f) !== patch) continue;
      for (const node of surface.nodesOf(f)) {
        for (let k = 0; k < 2; ++k) {
          low[k] = Math.min(low[k], surface.uv[2 * node + k]);
          high[k] = Math.max(high[k], surface.uv[2 * node + k]);
        }
      }
    }
    const half = low.map((x, k) => (high[k] - x) / 2 || 1);
    this.middle = low.map((x, k) => (Number.isFinite(x) ? (x + high[k]) / 2 : 0));
    const isUneven = Math.max(half[0] / half[1], half[1] / half[0]) > UNEVEN;
    const common = Math.max(...half);
    this.unit = half.map((x) => (isUneven ? x : common));
    this.extent = half.map((x, k) => x / this.unit[k]);
  }

  toPlane(u, v) {
    return [(u - this.middle[0]) / this.unit[0], (v - this.middle[1]) / this.unit[1]];
  }

  /** The (u,v) of a point of the plane. */
  toParameters(x, y) {
    const origin = this.state.facts.patches[this.state.planePatch].origin;
    return [x, y].map((c, k) => c * this.unit[k] + this.middle[k] + origin[k]);
  }

  colour() {
    const { state } = this;
    this.drawing.colour(
      paint(state.fields, state.field),
      () => !state.planeShows.mesh,
      state.marked,
    );
    this.picture.invalidate();
  }

  setControl() {
    const { state } = this;
    const positions = [],
      colours = [];
    const control = controlMesh(state, state.planePatch);
    if (control && state.planeShows.control) {
      for (const [a, b, rgb] of control.sides()) {
        positions.push(...this.toPlane(...control.uv(a)), 0, ...this.toPlane(...control.uv(b)), 0);
        colours.push(...linear(rgb), ...linear(rgb));
      }
    }
    this.control.set(positions, colours);
  }

  /** Points with the metric there: of the mesh, or of the nodes of the control mesh. */
  metricPoints() {
    const { state } = this;
    const control = controlMesh(state, state.planePatch);
    if (state.planeShows.ellipses === "control" && control) return control.metricPoints();
    const { surface } = state;
    if (!surface.metric) return [];
    const nodes = new Set();
    for (let f = 0; f < surface.faceCount; ++f) {
      if (surface.patchOf(f) === state.planePatch) surface.nodesOf(f).forEach((n) => nodes.add(n));
    }
    return Array.from(nodes, (n) => ({
      uv: surface.uv.subarray(2 * n, 2 * n + 2),
      metric: surface.metric.subarray(3 * n, 3 * n + 3),
    }));
  }

  /** The ellipses of steps of metric length ½: as wide across as the elements asked for. */
  setEllipses() {
    const { ellipses } = this.state.planeShows;
    const corners =
      ellipses === "none" ? [] : apart(this.metricPoints()).map((p) => this.ellipse(p));
    this.ellipses.set(corners.filter((c) => c.flat().every(Number.isFinite)).flatMap(closedLine));
    this.picture.invalidate();
  }

  /** With M = L Lᵀ, the steps are L⁻ᵀ times the circle of radius ½. */
  ellipse({ uv, metric: [m11, m12, m22] }) {
    const l11 = Math.sqrt(m11),
      l21 = m12 / l11,
      l22 = Math.sqrt(m22 - l21 * l21);
    return Array.from({ length: ELLIPSE_CORNERS }, (_, i) => {
      const angle = (2 * Math.PI * i) / ELLIPSE_CORNERS;
      const v = (0.5 * Math.sin(angle)) / l22;
      const u = (0.5 * Math.cos(angle) - l21 * v) / l11;
      return [...this.toPlane(uv[0] + u, uv[1] + v), 0];
    });
  }

  markFace() {
    const { marked, surface, planePatch } = this.state;
    const isHere = marked >= 0 && surface.patchOf(marked) === planePatch;
    const corners = isHere
      ? Array.from(surface.nodesOf(marked), (n) => [
          ...this.toPlane(surface.uv[2 * n], surface.uv[2 * n + 1]),
          0,
        ])
      : [];
    this.outline.set(closedLine(corners));
    this.picture.invalidate();
  }

  draw(renderer) {
    const { camera, picture, centre, scale } = this;
    const aspect = picture.width / picture.height;
    Object.assign(camera, {
      left: -scale * aspect,
      right: scale * aspect,
      top: scale,
      bottom: -scale,
    });
    camera.position.set(centre[0], centre[1], 1);
    camera.near = 0.01;
    camera.far = 2;
    camera.updateProjectionMatrix();
    this.drawing.showSides(this.state.showsSides, picture.ratio > 1 ? picture.ratio * 0.8 : 1);
    renderer.render(this.scene, camera);
    return true;
  }

  fit() {
    const aspect = this.picture.width / Math.max(1, this.picture.height) || 1;
    this.centre = [0, 0];
    this.scale = 1.12 * Math.max(this.extent[1], this.extent[0] / aspect);
    this.picture.invalidate();
  }

  /** The point of the plane at a pixel. */
  pointAt(x, y) {
    const { width, height } = this.picture;
    const aspect = width / height;
    return [
      this.centre[0] + ((2 * x) / width - 1) * this.scale * aspect,
      this.centre[1] + (1 - (2 * y) / height) * this.scale,
    ];
  }

  zoomAt(factor, x, y) {
    const before = this.pointAt(x, y);
    this.scale /= factor;
    const after = this.pointAt(x, y);
    this.centre = this.centre.map((c, k) => c + before[k] - after[k]);
    this.picture.invalidate(true);
  }

  shift(across, up) {
    const pixel = (2 * this.scale) / this.picture.height;
    this.centre = [this.centre[0] - across * pixel, this.centre[1] + up * pixel];
    this.picture.invalidate(true);
  }

  faceAt(x, y) {
    const [px, py] = this.pointAt(x, y);
    return this.drawing.pick({ origin: new Vector3(px, py, 1), direction: new Vector3(0, 0, -1) });
  }

  /** Drag to move, wheel or two fingers to zoom, click to mark. */
  listenToPointer() {
    const { canvas } = this.picture;
    const pointers = new Map();
    canvas.style.touchAction = "none";
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      pointers.set(event.pointerId, event);
    });
    for (const end of ["pointerup", "pointercancel"]) {
      canvas.addEventListener(end, (event) => pointers.delete(event.pointerId));
    }
    canvas.addEventListener("pointermove", (event) => {
      const before = pointers.get(event.pointerId);
      if (!before) return;
      if (pointers.size === 2) this.pinch(pointers, before, event);
      this.shift(
        (event.offsetX - before.offsetX) / pointers.size,
        (event.offsetY - before.offsetY) / pointers.size,
      );
      pointers.set(event.pointerId, event);
    });
    canvas.addEventListener(
      "wheel",
      (event) => {
        event.preventDefault();
        this.zoomAt(Math.exp(-event.deltaY * 0.0015), event.offsetX, event.offsetY);
      },
      { passive: false },
    );
    onClick(canvas, (x, y) => this.state.mark(this.faceAt(x, y)));
  }

  pinch(pointers, before, event) {
    const other = [...pointers.values()].find((p) => p.pointerId !== event.pointerId);
    const distance = (p) => Math.hypot(p.offsetX - other.offsetX, p.offsetY - other.offsetY);
    const x = (event.offsetX + other.offsetX) / 2,
      y = (event.offsetY + other.offsetY) / 2;
    if (distance(before) > 0) this.zoomAt(distance(event) / distance(before), x, y);
  }
}

/**
 * Points of which no two are nearer than the metric length 1, so that their ellipses stay apart.
 * They are tried in steps of a golden share of their number, which are spread evenly at any time.
 */
function apart(points) {
  const GOLDEN = 0.6180339887498949;
  const chosen = [];
  for (let i = 0; i < Math.min(points.length, MOST_TRIED) && chosen.length < MOST_ELLIPSES; ++i) {
    const point = points[Math.floor(((i * GOLDEN) % 1) * points.length)];
    if (!chosen.some((other) => isNear(other, point))) chosen.push(point);
  }
  return chosen;
}

function isNear({ uv: a, metric: [m11, m12, m22] }, { uv: b }) {
  const u = b[0] - a[0],
    v = b[1] - a[1];
  return m11 * u * u + 2 * m12 * u * v + m22 * v * v < 1;
}
