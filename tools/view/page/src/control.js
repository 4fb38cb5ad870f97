// SPDX-License-Identifier: BSD-3-Clause
// The control meshes of the patches, in which the program keeps the sizes that are asked for.

/** How faces interpolate, by their class (keys::face_class of core/properties.hh). */
export const CLASSES = [
  { value: 0, name: "V_s", text: "one vertex", colour: [27, 120, 55] },
  { value: 1, name: "V_t", text: "three vertices", colour: [33, 102, 172] },
  { value: 2, name: "V_o", text: "circumcircles", colour: [200, 70, 30] },
  { value: 4, name: "linear", text: "linear", colour: [70, 78, 92] },
  { value: -1, name: "cell", text: "cell of a grid", colour: [120, 120, 120] },
];

function classOf(value) {
  return CLASSES.find((c) => c.value === value) ?? CLASSES[CLASSES.length - 1];
}

/** The control mesh of a patch; null where the page has none. */
export function controlMesh(state, patch) {
  const parts = state.facts.control;
  if (!parts || !parts[patch]) return null;
  return (state.controlMeshes[patch] ??= new ControlMesh(state, patch));
}

class ControlMesh {
  constructor({ facts, arrays }, patch) {
    this.arrays = arrays;
    this.classes = new Int32Array(arrays.control_class.buffer);
    this.firstNode = 0;
    this.firstFace = 0;
    for (const part of facts.control.slice(0, patch)) {
      this.firstNode += part.nodes;
      this.firstFace += part.faces;
    }
    this.nodes = facts.control[patch].nodes;
    this.faces = facts.control[patch].faces;
    this.firstCorner = 0;
    for (let f = 0; f < this.firstFace; ++f) this.firstCorner += arrays.control_sizes[f];
  }

  uv(node) {
    const at = 2 * (this.firstNode + node);
    return this.arrays.control_uv.subarray(at, at + 2);
  }

  metricPoints() {
    return Array.from({ length: this.nodes }, (_, n) => ({
      uv: this.uv(n),
      metric: this.arrays.control_metric.subarray(
        3 * (this.firstNode + n),
        3 * (this.firstNode + n + 1),
      ),
    }));
  }

  /** The sides of all faces once, as [node, node, colour of the class]. */
  sides() {
    const seen = new Set();
    const sides = [];
    let corner = this.firstCorner;
    for (let f = this.firstFace; f < this.firstFace + this.faces; ++f) {
      const size = this.arrays.control_sizes[f];
      const nodes = this.arrays.control_corners.subarray(corner, corner + size);
      const { colour } = classOf(this.classes[f]);
      nodes.forEach((a, i) => {
        const b = nodes[(i + 1) % size];
        const key = Math.min(a, b) * this.nodes + Math.max(a, b);
        if (!seen.has(key)) sides.push([a, b, colour]);
        seen.add(key);
      });
      corner += size;
    }
    return sides;
  }

  /** The classes of its faces with their numbers. */
  counts() {
    const counts = new Map();
    for (let f = this.firstFace; f < this.firstFace + this.faces; ++f) {
      const entry = classOf(this.classes[f]);
      counts.set(entry, (counts.get(entry) ?? 0) + 1);
    }
    return [...counts].map(([entry, count]) => ({ ...entry, count }));
  }
}
