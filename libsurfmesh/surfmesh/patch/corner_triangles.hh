// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "surfmesh/patch_mesh/triangulated_patch.hh"

/// The triangles of a patch as corners on its surface, those that are there and those that might
/// be.
namespace surfmesh::detail {

/// A vertex, or a place where one might be.
struct PatchCorner {
  Uv uv;
  Vec3 point;
  Vec3 normal;                ///< of any length
  Metric metric = {0, 0, 0};  ///< of a vertex, where shapes count in it; else 0
};

using CornerTriangle = std::array<PatchCorner, 3>;
using CornerTriangles = std::vector<CornerTriangle>;

/// 2√3 · double area / Σ squared sides, in space or in the metric, whichever is better: 1 for an
/// equilateral triangle, and for one that is stretched as was asked for; negative for one that is
/// turned against the normals of the surface. Corners that are no vertices take the metric of the
/// others.
double shape_of(const CornerTriangle& triangle);

/// The worst of them.
double shape_of(const CornerTriangles& triangles);

/// An inner edge and the apexes of its two triangles.
struct Diamond {
  PatchCorner origin, right, tip, left;

  CornerTriangles triangles() const { return {{origin, tip, left}, {tip, origin, right}}; }
  CornerTriangles swapped() const { return {{right, tip, left}, {left, origin, right}}; }
  CornerTriangles split_at(const PatchCorner& middle) const {
    return {
        {origin, middle, left}, {middle, tip, left}, {tip, middle, right}, {middle, origin, right}};
  }
};

PatchCorner corner_of(const TriangulatedPatch& patch, VertexHandle vh);

/// A corner where the patch has no vertex.
PatchCorner corner_at(const TriangulatedPatch& patch, Uv uv);

bool is_inner(const TriangulatedPatch& patch, EdgeHandle eh);

std::vector<EdgeHandle> inner_edges(const TriangulatedPatch& patch, FaceHandle fh);

Diamond diamond_of(const TriangulatedPatch& patch, EdgeHandle eh);

double squared_length(const TriangulatedPatch& patch, EdgeHandle eh);

/// The vertices around a vertex.
std::vector<VertexHandle> ring_of(const TriangulatedPatch& patch, VertexHandle vh);

/// The triangles around an inner vertex, were it at `centre`.
CornerTriangles star_of(const TriangulatedPatch& patch, VertexHandle vh, const PatchCorner& centre);

}  // namespace surfmesh::detail
