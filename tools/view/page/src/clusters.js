// SPDX-License-Identifier: BSD-3-Clause
// Large meshes: triangles in the order of space, so that what is outside of the picture need not be
// drawn, and a thinned mesh to draw while the picture moves.

/** Triangles of a cluster: fewer cost more draws than they save. */
const CLUSTER = 2048;

/** Interleave the low 10 bits of three numbers. */
function morton(x, y, z) {
  const spread = (n) => {
    n = (n | (n << 16)) & 0x030000ff;
    n = (n | (n << 8)) & 0x0300f00f;
    n = (n | (n << 4)) & 0x030c30c3;
    return (n | (n << 2)) & 0x09249249;
  };
  return spread(x) | (spread(y) << 1) | (spread(z) << 2);
}

/** The cell of a coordinate from -1 to 1, of so many. */
function cell(x, count) {
  const i = ((x + 1) * count) >> 1;
  return i < 0 ? 0 : i >= count ? count - 1 : i;
}

/** The triangles in the order of a curve that fills space, by their first corners. */
export function sortedBySpace({ points, triangleNodes, triangleCount }, vertexOf) {
  const BITS = 1024;
  const keys = new Float64Array(triangleCount);
  for (let t = 0; t < triangleCount; ++t) {
    const at = 3 * vertexOf(triangleNodes[3 * t]);
    const place = morton(
      cell(points[at], BITS),
      cell(points[at + 1], BITS),
      cell(points[at + 2], BITS),
    );
    keys[t] = place * triangleCount + t;
  }
  keys.sort();
  return Uint32Array.from(keys, (key) => key % triangleCount);
}

/** Spheres around clusters of triangles, from the positions of their corners. */
export function makeClusters(count, positions) {
  const clusters = [];
  for (let first = 0; first < count; first += CLUSTER) {
    const end = Math.min(count, first + CLUSTER);
    const low = [Infinity, Infinity, Infinity],
      high = [-Infinity, -Infinity, -Infinity];
    for (let i = 9 * first; i < 9 * end; i += 3) {
      for (let k = 0; k < 3; ++k) {
        low[k] = Math.min(low[k], positions[i + k]);
        high[k] = Math.max(high[k], positions[i + k]);
      }
    }
    const centre = low.map((x, k) => (x + high[k]) / 2);
    clusters.push({
      first,
      end,
      centre,
      radius: Math.hypot(...low.map((x, k) => high[k] - x)) / 2,
    });
  }
  return clusters;
}

/**
 * The ranges of triangles to draw, as [first, end]; `isInside(centre, radius)` tells whether a
 * sphere is in the picture.
 */
export function visibleRanges(clusters, isInside) {
  const ranges = [];
  for (const { first, end, centre, radius } of clusters) {
    if (!isInside(centre, radius)) continue;
    const last = ranges[ranges.length - 1];
    if (last && last[1] === first) last[1] = end;
    else ranges.push([first, end]);
  }
  return ranges;
}

/** The area of all triangles. */
function areaOf({ points, triangleNodes, triangleCount }, vertexOf) {
  let area = 0;
  for (let t = 0; t < triangleCount; ++t) {
    const [a, b, c] = [0, 1, 2].map((k) => 3 * vertexOf(triangleNodes[3 * t + k]));
    const ux = points[b] - points[a],
      uy = points[b + 1] - points[a + 1],
      uz = points[b + 2] - points[a + 2];
    const vx = points[c] - points[a],
      vy = points[c + 1] - points[a + 1],
      vz = points[c + 2] - points[a + 2];
    area += Math.hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx) / 2;
  }
  return area;
}

/**
 * Thin a mesh to about `wanted` triangles: all vertices in one cell of a grid become one, and
 * triangles with two corners in one cell vanish (Rossignac and Borrel 1993,
 * doi 10.1007/978-3-642-78114-8_29).
 *
 * Returns the triangles that stay, and the vertex that stands for each.
 */
export function thinned(surface, vertexOf, wanted) {
  const MOST_CELLS = 256; // along a side
  // Two triangles a cell, where the surface passes through.
  const size = Math.sqrt((2 * areaOf(surface, vertexOf)) / wanted);
  const count = Math.max(2, Math.min(MOST_CELLS, Math.floor(2 / size)));
  const { points, triangleNodes, triangleCount, vertexCount } = surface;
  const first = new Int32Array(count ** 3).fill(-1);
  const standsFor = new Uint32Array(vertexCount);
  for (let v = 0; v < vertexCount; ++v) {
    const [x, y, z] = [0, 1, 2].map((k) => cell(points[3 * v + k], count));
    const at = (x * count + y) * count + z;
    if (first[at] < 0) first[at] = v;
    standsFor[v] = first[at];
  }
  const kept = [];
  for (let t = 0; t < triangleCount; ++t) {
    const [a, b, c] = [0, 1, 2].map((k) => standsFor[vertexOf(triangleNodes[3 * t + k])]);
    if (a !== b && b !== c && c !== a) kept.push(t);
  }
  return { triangles: Uint32Array.from(kept), standsFor };
}
