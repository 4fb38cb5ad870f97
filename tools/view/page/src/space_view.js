// SPDX-License-Identifier: BSD-3-Clause
// The mesh in space. It fills the ball of radius 1 around the origin, whatever its size.
import {
  Frustum,
  Matrix4,
  PerspectiveCamera,
  Raycaster,
  Scene,
  Sphere,
  Vector2,
  Vector3,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

import { HairLines, Lines, closedLine, linear } from "./lines.js";
import { paint, thinDrawing, wholeDrawing } from "./mesh_drawing.js";
import { Picture } from "./picture.js";
import { cross, minus } from "./surface.js";

const CONTOUR = [22, 33, 62];
const CHOSEN_CONTOUR = [232, 62, 40];

/** From where a mesh is seen first. */
const FIRST_DIRECTION = new Vector3(1, -1.35, 0.8).normalize();
const UP = new Vector3(0, 0, 1);

/** Of the picture, in degrees: little perspective, as in drawings. */
const ANGLE = 24;

/** More triangles in a picture are thinned to so many while it moves, if whole ones are slow. */
const MOVING_TRIANGLES = 40000;

export class SpaceView {
  constructor(container, state) {
    this.state = state;
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(ANGLE);
    this.camera.up.copy(UP);
    this.drawing = wholeDrawing(state.surface);
    this.contours = new Lines({ width: 2, hasColours: true });
    this.movingContours = new HairLines();
    this.outline = new Lines({ width: 3, colour: 0xd9480f, isOnTop: true });
    this.scene.add(this.drawing.mesh, this.contours.object, this.movingContours.object);
    this.scene.add(this.outline.object);
    this.picture = new Picture(container, (renderer, isMoving) => this.draw(renderer, isMoving));
    this.controls = new OrbitControls(this.camera, this.picture.canvas);
    this.controls.zoomToCursor = true;
    this.controls.addEventListener("change", () => this.picture.invalidate(true));
    this.afterDraw = [];
    this.frustum = new Frustum();
    this.listen();
    this.look(FIRST_DIRECTION);
  }

  listen() {
    const { state } = this;
    state.on("colours", () => this.colour());
    state.on("contours", () => this.setContours());
    state.on("marked", () => {
      this.colour();
      this.markFace();
    });
    state.on("sides", () => this.picture.invalidate());
    this.colour();
    this.setContours();
    this.listenToClicks();
  }

  colour() {
    this.isThinColoured = false;
    this.colourDrawing(this.drawing);
    this.picture.invalidate();
  }

  colourDrawing(drawing) {
    const { fields, field, marked } = this.state;
    drawing.colour(paint(fields, field), (patch) => this.state.isHidden(patch), marked);
  }

  setContours() {
    const { lines, contourOfLine, surface, chosenContour, showsContours } = this.state;
    const positions = [],
      colours = [];
    for (let i = 0; i < lines.length / 2; ++i) {
      const isChosen = chosenContour >= 0 && contourOfLine?.[i] === chosenContour;
      if (!showsContours && !isChosen) continue;
      positions.push(...surface.point(lines[2 * i]), ...surface.point(lines[2 * i + 1]));
      const colour = linear(isChosen ? CHOSEN_CONTOUR : CONTOUR);
      colours.push(...colour, ...colour);
    }
    this.contours.set(positions, colours);
    this.movingContours.set(positions, colours);
    this.picture.invalidate();
  }

  markFace() {
    const { marked, surface } = this.state;
    this.outline.set(marked < 0 ? [] : closedLine(surface.pointsOf(marked)));
    this.picture.invalidate();
  }

  draw(renderer, isMoving) {
    this.placeCamera();
    const count = this.chooseRanges();
    const isThin = isMoving && this.picture.isSlow && count > MOVING_TRIANGLES;
    if (isThin) this.prepareThin();
    const { ratio } = this.picture;
    const shown = isThin ? this.thin : this.drawing;
    // Sides of thinned triangles are none of the mesh, and those would hardly be seen.
    shown.showSides(this.state.showsSides && !isThin, ratio > 1 ? 0.8 * ratio : 1);
    this.drawing.mesh.visible = !isThin;
    if (this.thin) this.thin.mesh.visible = isThin;
    this.contours.show(!isThin);
    this.movingContours.object.visible = isThin;
    renderer.render(this.scene, this.camera);
    for (const follow of this.afterDraw) follow();
    return !isThin;
  }

  /** The thinned mesh is made when it is first needed, and coloured likewise. */
  prepareThin() {
    if (!this.thin) {
      this.thin = thinDrawing(this.state.surface, MOVING_TRIANGLES);
      this.scene.add(this.thin.mesh);
    }
    if (!this.isThinColoured) this.colourDrawing(this.thin);
    this.isThinColoured = true;
  }

  /** Between the near and the far plane lies no more than the mesh, for depths are coarse. */
  placeCamera() {
    const { camera, picture } = this;
    const distance = camera.position.length();
    camera.near = Math.max(distance - 1.05, distance * 0.002, 1e-5);
    camera.far = distance + 1.05;
    camera.aspect = picture.width / picture.height;
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
  }

  /** Leave out what is not in the picture. Returns the number of triangles that are. */
  chooseRanges() {
    const { camera, frustum } = this;
    frustum.setFromProjectionMatrix(
      new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse),
    );
    const sphere = new Sphere();
    return this.drawing.chooseRanges((centre, radius) => {
      sphere.center.fromArray(centre);
      sphere.radius = radius;
      return frustum.intersectsSphere(sphere);
    });
  }

  /** How far the eye is from a ball of some radius that just fits. */
  fittingDistance(radius) {
    const half = (this.camera.fov * Math.PI) / 360;
    const aspect = Math.min(1, this.picture.width / Math.max(1, this.picture.height) || 1);
    return radius / Math.sin(Math.atan(Math.tan(half) * aspect));
  }

  /** The least distance from which all vertices are in the picture, a little more for a margin. */
  distanceForAll(direction) {
    const MARGIN = 1.06;
    const { points } = this.state.surface;
    const right = new Vector3().crossVectors(UP, direction).normalize();
    const up = new Vector3().crossVectors(direction, right);
    const half = Math.tan((this.camera.fov * Math.PI) / 360) / MARGIN;
    const aspect = this.picture.width / Math.max(1, this.picture.height) || 1;
    let distance = 0;
    for (let i = 0; i < points.length; i += 3) {
      const x = points[i],
        y = points[i + 1],
        z = points[i + 2];
      const across = Math.abs(right.x * x + right.y * y + right.z * z) / aspect;
      const along = Math.abs(up.x * x + up.y * y + up.z * z);
      const needed =
        direction.x * x + direction.y * y + direction.z * z + Math.max(across, along) / half;
      if (needed > distance) distance = needed;
    }
    return Math.max(distance, 1e-3);
  }

  /** Look at the whole mesh, from a direction. */
  look(direction) {
    this.controls.target.set(0, 0, 0);
    this.camera.position.copy(direction).multiplyScalar(this.distanceForAll(direction));
    this.controls.update();
    this.picture.invalidate();
  }

  reset() {
    this.look(FIRST_DIRECTION);
  }

  /** The whole mesh, from where it is seen now. */
  fit() {
    this.look(this.camera.position.clone().sub(this.controls.target).normalize());
  }

  lookAlong(axis) {
    // Not quite along z, where "up" would have no direction.
    this.look(
      new Vector3(axis === 0 ? 1 : 0, axis === 1 ? -1 : -1e-4, axis === 2 ? 1 : 0).normalize(),
    );
  }

  /** Turn by angles in radians. */
  turn(across, up) {
    this.controls.rotateLeft(across);
    this.controls.rotateUp(up);
    this.controls.update();
  }

  /** Move by pixels. */
  shift(across, up) {
    this.controls.pan(across, up);
    this.controls.update();
  }

  zoom(factor) {
    const step = this.camera.position.clone().sub(this.controls.target);
    this.camera.position.copy(this.controls.target).addScaledVector(step, 1 / factor);
    this.controls.update();
    this.picture.invalidate(true);
  }

  /** Go to a point, near enough to see something of the given radius. */
  goTo(point, radius, from = null) {
    const target = new Vector3(...point);
    const direction = from
      ? new Vector3(...from).normalize()
      : this.camera.position.clone().sub(this.controls.target).normalize();
    // Along z, "up" would have no direction.
    if (Math.abs(direction.z) > 0.999) direction.add(new Vector3(0.05, -0.05, 0)).normalize();
    this.controls.target.copy(target);
    this.camera.position.copy(target).addScaledVector(direction, this.fittingDistance(radius));
    this.controls.update();
    this.picture.invalidate();
  }

  /** Where a point is in the picture, in pixels; null behind the eye. */
  project(point) {
    const p = new Vector3(...point).project(this.camera);
    if (p.z > 1) return null;
    return [((p.x + 1) / 2) * this.picture.width, ((1 - p.y) / 2) * this.picture.height];
  }

  /** The face at a pixel of the picture, or -1. */
  faceAt(x, y) {
    const ray = new Raycaster();
    const { width, height } = this.picture;
    ray.setFromCamera(new Vector2((2 * x) / width - 1, 1 - (2 * y) / height), this.camera);
    return this.drawing.pick(ray.ray);
  }

  listenToClicks() {
    onClick(this.picture.canvas, (x, y) => this.state.mark(this.faceAt(x, y)));
    this.picture.canvas.addEventListener("dblclick", (event) => {
      const face = this.faceAt(event.offsetX, event.offsetY);
      if (face >= 0) this.goToFace(face);
    });
  }

  /** From where a face is seen well: from here, if it is now, else from in front of it. */
  directionTo(points) {
    const now = this.camera.position.clone().sub(this.controls.target).normalize();
    const normal = new Vector3(...cross(minus(points[1], points[0]), minus(points[2], points[0])));
    normal.normalize();
    const isSeen = normal.length() === 0 || normal.dot(now) > SEEN_WELL;
    return (isSeen ? now : normal.addScaledVector(now, 0.3)).toArray();
  }

  goToFace(face) {
    const { surface } = this.state;
    const points = surface.pointsOf(face);
    const middle = surface.middleOf(face);
    const size = Math.max(...points.map((p) => Math.hypot(...minus(p, middle))));
    this.goTo(middle, Math.min(1, 7 * size), this.directionTo(points));
  }
}

/** Cosine of the angle to its normal up to which a face is seen well. */
const SEEN_WELL = 0.6;

/** Call `act(x, y)` where the pointer goes down and up at one place. */
export function onClick(canvas, act) {
  let start = null;
  canvas.addEventListener("pointerdown", (event) => {
    start = event.isPrimary && event.button === 0 ? [event.offsetX, event.offsetY] : null;
  });
  canvas.addEventListener("pointerup", (event) => {
    if (start && Math.hypot(event.offsetX - start[0], event.offsetY - start[1]) < 4) {
      act(event.offsetX, event.offsetY);
    }
    start = null;
  });
}
