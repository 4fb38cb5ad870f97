// SPDX-License-Identifier: BSD-3-Clause
// Draws the triangles of a mesh in one go. Three vertices a triangle: each has its colour, the
// normal of its triangle and, in the alpha of the colour, which sides are drawn and whether it is
// hidden. Sides are drawn in the fragment shader, by the distance from them in pixels: separate
// lines for them would cost as much as the triangles again.
import { BufferAttribute, BufferGeometry, DoubleSide, GLSL3, Mesh, RawShaderMaterial } from "three";

import { makeClusters, sortedBySpace, thinned, visibleRanges } from "./clusters.js";

/** In the alpha of a colour, beside the three bits of the sides. */
const HIDDEN = 8;

/** Meshes of fewer triangles are drawn whole: it takes no longer. */
const WORTH_CLUSTERS = 50000;

const MARKED = [255, 122, 26];

const vertexShader = `
precision highp float;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform bool isFlat;
in vec3 position;
in vec3 normal;
in vec4 tint;
out vec3 colour;
#ifdef SIDES
out vec3 weights;
#endif

void main() {
  int bits = int(tint.a * 255.0 + 0.5);
  if (bits >= ${HIDDEN}) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  vec4 place = modelViewMatrix * vec4(position, 1.0);
  gl_Position = projectionMatrix * place;
  vec3 n = normalize(mat3(modelViewMatrix) * normal);
  bool isBack = dot(n, place.xyz) > 0.0;
  if (isBack) n = -n;
  // A light at the eye, and one above it to the left.
  float light = 0.55 + 0.22 * max(n.z, 0.0) + 0.28 * max(dot(n, vec3(-0.45, 0.62, 0.64)), 0.0);
  if (isFlat) light = 1.0;
  colour = tint.rgb * (isBack && !isFlat ? vec3(0.78, 0.8, 0.86) : vec3(1.0)) * light;
#ifdef SIDES
  int corner = gl_VertexID % 3;
  weights = vec3(corner == 0, corner == 1, corner == 2);
  // A side that is not drawn is one triangle away.
  weights += vec3((bits & 1) == 0, (bits & 2) == 0, (bits & 4) == 0);
#endif
}`;

const fragmentShader = `
precision highp float;
uniform float lineWidth;
in vec3 colour;
#ifdef SIDES
in vec3 weights;
#endif
out vec4 result;

void main() {
  result = vec4(colour, 1.0);
#ifdef SIDES
  vec3 step = fwidth(weights);
  vec3 pixels = weights / step;
  float nearest = min(min(pixels.x, pixels.y), pixels.z);
  float line = 1.0 - smoothstep(0.5 * lineWidth - 0.5, 0.5 * lineWidth + 0.5, nearest);
  // Sides of triangles of a few pixels would leave nothing of their colours.
  float height = 1.0 / max(max(step.x, step.y), step.z);
  result.rgb *= 1.0 - 0.62 * line * smoothstep(1.5 * lineWidth, 7.0 * lineWidth, height);
#endif
}`;

function material(hasSides, isFlat) {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader,
    fragmentShader,
    defines: hasSides ? { SIDES: 1 } : {},
    uniforms: { lineWidth: { value: 1 }, isFlat: { value: isFlat } },
    side: DoubleSide,
    polygonOffset: true, // lines lie in front
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });
}

/** Of which colour a face, or its corners, are. */
export function paint(fields, field) {
  const { values } = field;
  if (field.of === "none") return () => fields.colour(field, 0);
  if (field.category) return (face) => fields.categoryColour(values[face]);
  const table = fields.table(field);
  const { from, to, log } = field.scale;
  const low = log ? Math.log(from) : from;
  const width = (log ? Math.log(to) : to) - low;
  return (face, vertex) => {
    const value = values[field.of === "faces" ? face : vertex];
    const share = width > 0 ? ((log ? Math.log(value) : value) - low) / width : 0.5;
    const i = Number.isNaN(share) ? 256 : Math.round(255 * Math.min(1, Math.max(0, share)));
    return table.subarray(3 * i, 3 * i + 3);
  };
}

export class MeshDrawing {
  /**
   * `positions` has x, y, z of the nodes of triangles, three a triangle; `triangles` are their
   * numbers in the surface. A flat drawing has no light.
   */
  constructor(surface, triangles, positionOf, isFlat = false) {
    this.surface = surface;
    this.triangles = triangles;
    this.materials = [material(false, isFlat), material(true, isFlat)];
    this.fill(positionOf);
    this.mesh = new Mesh(this.geometry, this.materials[1]);
    this.mesh.frustumCulled = false;
    if (!isFlat && triangles.length >= WORTH_CLUSTERS) this.divide();
  }

  fill(positionOf) {
    const count = this.triangles.length;
    this.positions = new Float32Array(9 * count);
    this.normals = new Int8Array(12 * count);
    this.tints = new Uint8Array(12 * count);
    for (let i = 0; i < count; ++i) {
      for (let k = 0; k < 3; ++k) positionOf(this.triangles[i], k, this.positions, 9 * i + 3 * k);
      this.setNormal(i);
    }
    this.geometry = new BufferGeometry();
    this.geometry.setAttribute("position", new BufferAttribute(this.positions, 3));
    this.geometry.setAttribute("normal", new BufferAttribute(this.normals, 4, true));
    this.tint = new BufferAttribute(this.tints, 4, true);
    this.geometry.setAttribute("tint", this.tint);
  }

  setNormal(i) {
    const p = this.positions;
    const a = 9 * i;
    const ux = p[a + 3] - p[a],
      uy = p[a + 4] - p[a + 1],
      uz = p[a + 5] - p[a + 2];
    const vx = p[a + 6] - p[a],
      vy = p[a + 7] - p[a + 1],
      vz = p[a + 8] - p[a + 2];
    const x = uy * vz - uz * vy,
      y = uz * vx - ux * vz,
      z = ux * vy - uy * vx;
    const scale = 127 / (Math.sqrt(x * x + y * y + z * z) || 1);
    for (let k = 0; k < 3; ++k) {
      const at = 12 * i + 4 * k;
      this.normals[at] = Math.round(scale * x);
      this.normals[at + 1] = Math.round(scale * y);
      this.normals[at + 2] = Math.round(scale * z);
    }
  }

  divide() {
    this.clusters = makeClusters(this.triangles.length, this.positions);
    this.mesh.material = [this.materials[1]];
    this.mesh.geometry.addGroup(0, Infinity, 0);
  }

  showSides(isShown, lineWidth) {
    const chosen = this.materials[isShown ? 1 : 0];
    chosen.uniforms.lineWidth.value = lineWidth;
    this.mesh.material = this.clusters ? [chosen] : chosen;
  }

  /** Draw only what is in the picture, see visibleRanges. Returns the number of triangles. */
  chooseRanges(isInside) {
    if (!this.clusters) return this.triangles.length;
    this.geometry.clearGroups();
    let count = 0;
    for (const [first, end] of visibleRanges(this.clusters, isInside)) {
      this.geometry.addGroup(3 * first, 3 * (end - first), 0);
      count += end - first;
    }
    return count;
  }

  /** Give each corner its colour. `isHidden` is asked for patches, `marked` is a face or -1. */
  colour(colourOf, isHidden, marked) {
    const { surface, tints, triangles } = this;
    const { triangleFace, triangleNodes, triangleSides } = surface;
    for (let i = 0; i < triangles.length; ++i) {
      const t = triangles[i];
      const face = triangleFace[t];
      const bits = isHidden(surface.patchOf(face)) ? HIDDEN : triangleSides[t];
      for (let k = 0; k < 3; ++k) {
        const vertex = surface.vertexOf(triangleNodes[3 * t + k]);
        const [r, g, b] = face === marked ? MARKED : colourOf(face, vertex);
        const at = 12 * i + 4 * k;
        tints[at] = r;
        tints[at + 1] = g;
        tints[at + 2] = b;
        tints[at + 3] = bits;
      }
    }
    this.tint.needsUpdate = true;
  }

  /** Find the visible triangle that a ray meets first; returns its face, or -1. */
  pick({ origin, direction }) {
    const p = this.positions;
    const o = origin.toArray(),
      d = direction.toArray();
    let best = Infinity,
      found = -1;
    for (let i = 0; i < this.triangles.length; ++i) {
      if (this.tints[12 * i + 3] >= HIDDEN) continue;
      const t = distanceAlong(o, d, p, 9 * i);
      if (t >= 0 && t < best) {
        best = t;
        found = this.surface.triangleFace[this.triangles[i]];
      }
    }
    return found;
  }

  dispose() {
    this.geometry.dispose();
    for (const m of this.materials) m.dispose();
  }
}

/**
 * Along a ray to a triangle, -1 for none (Möller and Trumbore 1997,
 * doi 10.1080/10867651.1997.10487468).
 */
function distanceAlong(o, d, p, a) {
  const ux = p[a + 3] - p[a],
    uy = p[a + 4] - p[a + 1],
    uz = p[a + 5] - p[a + 2];
  const vx = p[a + 6] - p[a],
    vy = p[a + 7] - p[a + 1],
    vz = p[a + 8] - p[a + 2];
  const hx = d[1] * vz - d[2] * vy,
    hy = d[2] * vx - d[0] * vz,
    hz = d[0] * vy - d[1] * vx;
  const volume = ux * hx + uy * hy + uz * hz;
  if (volume === 0) return -1;
  const sx = o[0] - p[a],
    sy = o[1] - p[a + 1],
    sz = o[2] - p[a + 2];
  const u = (sx * hx + sy * hy + sz * hz) / volume;
  if (!(u >= 0 && u <= 1)) return -1;
  const qx = sy * uz - sz * uy,
    qy = sz * ux - sx * uz,
    qz = sx * uy - sy * ux;
  const v = (d[0] * qx + d[1] * qy + d[2] * qz) / volume;
  if (!(v >= 0 && u + v <= 1)) return -1;
  return (vx * qx + vy * qy + vz * qz) / volume;
}

/** Writes the point of a corner, or of the vertex that stands for it. */
function pointWriter({ points, triangleNodes }, vertexOf) {
  return (triangle, corner, positions, at) => {
    const vertex = 3 * vertexOf(triangleNodes[3 * triangle + corner]);
    positions[at] = points[vertex];
    positions[at + 1] = points[vertex + 1];
    positions[at + 2] = points[vertex + 2];
  };
}

/** All triangles of the surface; in the order of space where there are many. */
export function wholeDrawing(surface) {
  const vertexOf = (node) => surface.vertexOf(node);
  const count = surface.triangleCount;
  const triangles =
    count >= WORTH_CLUSTERS
      ? sortedBySpace(surface, vertexOf)
      : Uint32Array.from({ length: count }, (_, i) => i);
  return new MeshDrawing(surface, triangles, pointWriter(surface, vertexOf));
}

/** About so many triangles, for pictures that move. */
export function thinDrawing(surface, wanted) {
  const { triangles, standsFor } = thinned(surface, (node) => surface.vertexOf(node), wanted);
  return new MeshDrawing(
    surface,
    triangles,
    pointWriter(surface, (n) => standsFor[surface.vertexOf(n)]),
  );
}

/** The triangles of one patch over its parameters; `map` gives x, y of u, v. */
export function planeDrawing(surface, patch, map) {
  const triangles = [];
  for (let t = 0; t < surface.triangleCount; ++t) {
    if (surface.patchOf(surface.triangleFace[t]) === patch) triangles.push(t);
  }
  const positionOf = (triangle, corner, positions, at) => {
    const node = surface.triangleNodes[3 * triangle + corner];
    const [x, y] = map(surface.uv[2 * node], surface.uv[2 * node + 1]);
    positions[at] = x;
    positions[at + 1] = y;
  };
  return new MeshDrawing(surface, Uint32Array.from(triangles), positionOf, true);
}
