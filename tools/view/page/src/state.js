// SPDX-License-Identifier: BSD-3-Clause
// What the page shows and what is chosen in it. Views and panels listen to its changes:
// "colours" (field, range, hidden patches), "contours", "marked", "sides", "plane".
import { Fields } from "./fields.js";
import { Surface } from "./surface.js";

/** The first of these fields that a mesh has is shown first. */
const FIRST_FIELDS = ["patch", "shape"];

export class State {
  constructor(page) {
    this.facts = page.facts;
    this.arrays = page.arrays;
    this.surface = new Surface(page);
    this.fields = new Fields(page);
    this.field = FIRST_FIELDS.map((name) => this.fields.find(name)).find(Boolean);
    this.hidden = new Set();
    this.marked = -1;
    this.showsSides = true;
    this.showsContours = true;
    this.chosenContour = -1;
    this.lines = page.arrays.lines;
    const contours = page.arrays.line_contour;
    this.contourOfLine = contours ? new Int32Array(contours.buffer) : null; // -1 for none
    this.controlMeshes = [];
    this.planePatch = Math.max(0, this.surface.patchOf(0));
    this.planeShows = { mesh: true, control: Boolean(this.facts.control), ellipses: "none" };
    this.listeners = new Map();
  }

  on(event, listener) {
    this.listeners.set(event, [...(this.listeners.get(event) ?? []), listener]);
  }

  tell(event) {
    for (const listener of this.listeners.get(event) ?? []) listener();
  }

  get hasPlane() {
    return this.surface.uv !== null && this.facts.patches.length > 0;
  }

  patchName(patch) {
    return this.facts.patches[patch]?.name || `patch ${patch}`;
  }

  contourName(contour) {
    return this.facts.contours[contour] || `contour ${contour}`;
  }

  /** The names of the groups that a patch is in. */
  groupsOf(patch) {
    return this.facts.groups.filter((g) => g.patches.includes(patch)).map((g) => g.name);
  }

  choose(name) {
    this.field = this.fields.find(name) ?? this.field;
    this.tell("colours");
  }

  setRange(from, to) {
    Object.assign(this.field.scale, { from, to });
    this.tell("colours");
  }

  isHidden(patch) {
    return this.hidden.has(patch);
  }

  show(patches, isShown) {
    for (const patch of patches) {
      if (isShown) this.hidden.delete(patch);
      else this.hidden.add(patch);
    }
    this.tell("colours");
  }

  mark(face) {
    this.marked = face;
    this.tell("marked");
  }

  toggleSides() {
    this.showsSides = !this.showsSides;
    this.tell("sides");
  }

  toggleContours() {
    this.showsContours = !this.showsContours;
    this.tell("contours");
  }

  chooseContour(contour) {
    this.chosenContour = this.chosenContour === contour ? -1 : contour;
    this.tell("contours");
  }

  choosePlane(patch) {
    if (patch < 0 || patch === this.planePatch) return;
    this.planePatch = patch;
    this.tell("plane");
  }

  showInPlane(what, value) {
    this.planeShows[what] = value;
    this.tell("plane");
  }

  /** The point of the model for one of the page, with the digits of double precision. */
  modelPoint(point) {
    return point.map((x, i) => this.facts.centre[i] + this.facts.radius * x);
  }

  /** The reverse. */
  pagePoint(point) {
    return point.map((x, i) => (x - this.facts.centre[i]) / this.facts.radius);
  }
}
