// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <filesystem>
#include <map>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "surfmesh/core/notice.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/geometry/parts.hh"
#include "surfmesh/model/finish_model.hh"
#include "surfmesh/pipeline/mesh_model.hh"
#include "surfmesh_cad/read_cad.hh"

namespace surfmesh::testing {

/// The greatest distance of a corner of a mesh from the surface of its patch.
inline double corner_distance(const Model& model, const PolyMesh& mesh) {
  const auto patch_of = require(mesh, keys::face_patch);
  const auto uv_of = require(mesh, keys::corner_uv);
  const auto beyond = find(mesh, keys::corner_beyond);
  double distance = 0;
  for (const auto face : mesh.faces()) {
    for (const auto corner : face.halfedges()) {
      if (beyond.is_valid() && mesh.property(beyond, corner) != 0) continue;
      const Surface& surface = model.surface(mesh.property(patch_of, face));
      const Jet jet = surface.evaluate(mesh.property(uv_of, corner), Order::Position);
      distance = std::max(distance, (jet.point - to_eigen(mesh.point(corner.to()))).norm());
    }
  }
  return distance;
}

/// The greatest distance of the curves of a contour, at more points than gap_of looks at.
inline double fine_gap(const Model& model, const Contour& contour) {
  constexpr int kIntervals = 64;
  double gap = gap_of(model, contour);
  for (const ContourUse& use : contour.uses) {
    if (!use.is_same_speed) continue;
    for (const double t : divided_parts(contour.breaks, kIntervals)) {
      gap = std::max(gap, (model.point(use, t) - model.point(contour.uses.front(), t)).norm());
    }
  }
  return gap;
}

/// What corners may be off by: the gaps of the file, but for those below 1e-9 of the diagonal.
inline double allowed_distance(const Model& model) {
  constexpr double kLeast = 1e-9;
  constexpr double kSlack = 1.1;
  double gap = 0;
  for (const Contour& contour : model.contours) gap = std::max(gap, fine_gap(model, contour));
  return std::max(kLeast * model.diagonal, kSlack * gap);
}

/// True if faces pass each edge as often in one direction as in the other. Copies of a vertex are
/// one again: a half-edge mesh has them where a shape touches itself.
inline bool is_closed(const PolyMesh& mesh) {
  const auto original = find(mesh, keys::vertex_original);
  const auto number = [&](const auto& vertex) {
    return original.is_valid() ? mesh.property(original, vertex) : vertex.idx();
  };
  std::map<std::pair<int, int>, int> passes;
  for (const auto face : mesh.faces()) {
    for (const auto side : face.halfedges()) {
      const int from = number(side.from()), to = number(side.to());
      passes[std::minmax(from, to)] += from < to ? 1 : -1;
    }
  }
  return std::all_of(passes.begin(), passes.end(),
                     [](const auto& pass) { return pass.second == 0; });
}

inline bool has(const Notices& notices, NoticeKind kind) {
  return std::any_of(notices.begin(), notices.end(),
                     [kind](const Notice& notice) { return notice.kind == kind; });
}

/// The text of all notices, for messages of tests.
inline std::string all_texts(const Notices& notices) {
  std::string texts;
  for (const Notice& notice : notices) texts += notice.text + '\n';
  return texts;
}

}  // namespace surfmesh::testing
