// SPDX-License-Identifier: BSD-3-Clause
// The mesh: faces of any number of corners, and the triangles that they are drawn as.
import { ShapeUtils, Vector2 } from "three";

/** A triangle's sides, by the corner that they lie opposite to. */
const ALL_SIDES = 7;

export class Surface {
  constructor({ facts, arrays }) {
    this.points = arrays.points;
    this.corners = arrays.corners;
    this.vertexCount = this.points.length / 3;
    this.extra = arrays.extra;
    this.first = firstCorners(arrays.sizes, this.corners.length);
    this.faceCount = this.first.length - 1;
    this.patch = arrays.patch ? new Int32Array(arrays.patch.buffer) : null;
    this.uv = arrays.uv ?? null;
    this.metric = arrays.metric ?? null;
    this.isClosed = facts.closed;
    this.divide();
  }

  /** The vertex of a node: see page_mesh.hh. */
  vertexOf(node) {
    return node < this.vertexCount ? node : this.extra[node - this.vertexCount];
  }

  /** The nodes of the corners of a face. */
  nodesOf(face) {
    return this.corners.subarray(this.first[face], this.first[face + 1]);
  }

  patchOf(face) {
    return this.patch ? this.patch[face] : -1;
  }

  /** The point of a vertex, in shares of the radius of the mesh. */
  point(vertex) {
    return [this.points[3 * vertex], this.points[3 * vertex + 1], this.points[3 * vertex + 2]];
  }

  pointsOf(face) {
    return Array.from(this.nodesOf(face), (node) => this.point(this.vertexOf(node)));
  }

  middleOf(face) {
    const points = this.pointsOf(face);
    return [0, 1, 2].map((i) => points.reduce((sum, p) => sum + p[i], 0) / points.length);
  }

  /** Make triangles: their nodes, faces, and which of their sides are sides of the face. */
  divide() {
    let count = 0;
    for (let f = 0; f < this.faceCount; ++f) count += this.first[f + 1] - this.first[f] - 2;
    this.triangleNodes = new Uint32Array(3 * count);
    this.triangleFace = new Uint32Array(count);
    this.triangleSides = new Uint8Array(count);
    let t = 0;
    for (let f = 0; f < this.faceCount; ++f) {
      const begin = this.first[f];
      const size = this.first[f + 1] - begin;
      for (const [i, j, k] of this.trianglesOf(f, size)) {
        const nodes = [this.corners[begin + i], this.corners[begin + j], this.corners[begin + k]];
        this.triangleNodes.set(nodes, 3 * t);
        this.triangleFace[t] = f;
        this.triangleSides[t++] = size === 3 ? ALL_SIDES : sidesOf(i, j, k, size);
      }
    }
    // A polygon that crosses itself may get fewer.
    this.triangleCount = t;
  }

  trianglesOf(face, size) {
    if (size === 3) return TRIANGLE;
    if (size === 4) return isBetterOtherwise(this.pointsOf(face)) ? QUAD_FROM_1 : QUAD_FROM_0;
    return ShapeUtils.triangulateShape(flattened(this.pointsOf(face)), []);
  }
}

const TRIANGLE = [[0, 1, 2]];
const QUAD_FROM_0 = [
  [0, 1, 2],
  [0, 2, 3],
];
const QUAD_FROM_1 = [
  [1, 2, 3],
  [1, 3, 0],
];

function firstCorners(sizes, cornerCount) {
  const faces = sizes ? sizes.length : cornerCount / 3;
  const first = new Uint32Array(faces + 1);
  for (let f = 0; f < faces; ++f) first[f + 1] = first[f] + (sizes ? sizes[f] : 3);
  return first;
}

function sidesOf(i, j, k, size) {
  const isSide = (a, b) => (a + 1) % size === b || (b + 1) % size === a;
  return (isSide(j, k) ? 1 : 0) | (isSide(k, i) ? 2 : 0) | (isSide(i, j) ? 4 : 0);
}

export const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** True for a quad whose two triangles bend less along the diagonal from corner 1. */
function isBetterOtherwise([a, b, c, d]) {
  const bend = (p, q, r, s) => {
    const n = cross(minus(q, p), minus(r, p));
    const m = cross(minus(r, p), minus(s, p));
    return dot(n, m) / (Math.sqrt(dot(n, n) * dot(m, m)) || 1);
  };
  return bend(b, c, d, a) > bend(a, b, c, d);
}

/** The points of a polygon in the plane that fits it best. */
function flattened(points) {
  let normal = [0, 0, 0];
  for (let i = 0; i < points.length; ++i) {
    const n = cross(points[i], points[(i + 1) % points.length]);
    normal = normal.map((x, k) => x + n[k]);
  }
  const [x, y, z] = normal.map(Math.abs);
  // Looking along the greatest component, turned so that the corners go round counter-clockwise.
  const axis = x > y && x > z ? 0 : y > z ? 1 : 2;
  const sign = Math.sign(normal[axis]) || 1;
  return points.map((p) => new Vector2(sign * p[(axis + 1) % 3], p[(axis + 2) % 3]));
}
