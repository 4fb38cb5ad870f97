// SPDX-License-Identifier: BSD-3-Clause
// Triangles in clusters that lie together in space, so that what is outside of the picture, or on
// the far side of a closed surface, need not be drawn.

/** Triangles of a cluster: fewer cost more draws than they save. */
const CLUSTER = 512;

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

/** The triangles in the order of a curve that fills the cube from -1 to 1. */
export function sortedBySpace(count, middleOf) {
  const bits = 1024;
  const keys = new Float64Array(count);
  for (let t = 0; t < count; ++t) {
    const [x, y, z] = middleOf(t).map((c) => Math.min(bits - 1, Math.max(0, (c + 1) * (bits / 2))));
    keys[t] = morton(x || 0, y || 0, z || 0) * count + t;
  }
  keys.sort();
  return Uint32Array.from(keys, (key) => key % count);
}

/** A cone around the normals of a cluster, and a sphere around its points. */
function boundsOf(first, end, positions, normals) {
  const sum = [0, 0, 0];
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 3 * first; i < 3 * end; ++i) {
    for (let k = 0; k < 3; ++k) {
      low[k] = Math.min(low[k], positions[3 * i + k]);
      high[k] = Math.max(high[k], positions[3 * i + k]);
      sum[k] += normals[4 * i + k];
    }
  }
  const size = Math.hypot(...sum) || 1;
  const axis = sum.map((x) => x / size);
  let cosine = 1;
  for (let i = 3 * first; i < 3 * end; i += 3) {
    const n = [0, 1, 2].map((k) => normals[4 * i + k]);
    const length = Math.hypot(...n);
    if (length > 0) cosine = Math.min(cosine, (n[0] * axis[0] + n[1] * axis[1] + n[2] * axis[2]) / length);
  }
  const centre = low.map((x, k) => (x + high[k]) / 2);
  const radius = Math.hypot(...low.map((x, k) => high[k] - x)) / 2;
  return { first, end, axis, cosine, centre, radius };
}

export function makeClusters(count, positions, normals) {
  const clusters = [];
  for (let first = 0; first < count; first += CLUSTER) {
    clusters.push(boundsOf(first, Math.min(count, first + CLUSTER), positions, normals));
  }
  return clusters;
}

/** True if no point of the cluster can be seen from the eye, on its outer side. */
function isTurnedAway({ axis, cosine, centre, radius }, eye) {
  if (cosine <= 0) return false;
  const step = [eye[0] - centre[0], eye[1] - centre[1], eye[2] - centre[2]];
  const distance = Math.hypot(...step);
  if (distance <= radius) return false;
  // The eye sees no outer side if its direction is more than 90° from all normals: those within
  // the cone, seen from anywhere in the sphere.
  const along = (step[0] * axis[0] + step[1] * axis[1] + step[2] * axis[2]) / distance;
  const spread = Math.acos(Math.min(1, cosine)) + Math.asin(radius / distance);
  return Math.acos(Math.max(-1, Math.min(1, along))) > Math.PI / 2 + spread;
}

/**
 * The ranges of triangles to draw, as [first, end]. `eye` is null where both sides may be seen;
 * `isInside(centre, radius)` tells whether a sphere is in the picture.
 */
export function visibleRanges(clusters, eye, isInside) {
  const ranges = [];
  for (const cluster of clusters) {
    if (eye && isTurnedAway(cluster, eye)) continue;
    if (!isInside(cluster.centre, cluster.radius)) continue;
    const last = ranges[ranges.length - 1];
    if (last && last[1] === cluster.first) last[1] = cluster.end;
    else ranges.push([cluster.first, cluster.end]);
  }
  return ranges;
}
