// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quad/pair_triangles.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "surfmesh/core/properties.hh"
#include "surfmesh/metric/triangle.hh"

namespace surfmesh {
namespace {

/// Least scaled Jacobian of a quad that is worth making at once.
constexpr double kLeastPaired = 0.3;

/// An edge between two triangles, and the quad that goes without it.
struct Pair {
  double least_jacobian;
  EdgeHandle edge;
};

class Pairing {
 public:
  Pairing(PolyMesh& mesh, FaceEditor& editor)
      : mesh_(mesh),
        editor_(editor),
        uv_(require(mesh, keys::vertex_uv)),
        metric_(require(mesh, keys::vertex_metric)) {}

  std::size_t run(const RunContext& context) {
    std::vector<Pair> pairs = candidates(context);
    std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
      return a.least_jacobian != b.least_jacobian ? a.least_jacobian > b.least_jacobian
                                                  : a.edge < b.edge;
    });
    std::size_t left = mesh_.n_faces();
    std::vector<char> is_paired(mesh_.n_faces(), 0);
    for (const Pair& pair : pairs) {
      const std::array<FaceHandle, 2> faces = faces_at(pair.edge);
      if (is_paired[index(faces[0])] || is_paired[index(faces[1])]) continue;
      is_paired[index(faces[0])] = is_paired[index(faces[1])] = 1;
      merge(pair.edge, faces);
      left -= 2;
    }
    return left;
  }

 private:
  std::vector<Pair> candidates(const RunContext& context) const {
    std::vector<Pair> pairs;
    pairs.reserve(mesh_.n_edges());
    for (const EdgeHandle eh : mesh_.edges()) {
      if (index(eh) % kStepsBetweenCancellation == 0) context.throw_if_cancelled();
      if (mesh_.is_boundary(eh)) continue;
      const double least = least_jacobian(cycle_without(eh));
      if (least >= kLeastPaired) pairs.push_back({least, eh});
    }
    return pairs;
  }

  std::array<FaceHandle, 2> faces_at(EdgeHandle eh) const {
    return {mesh_.face_handle(mesh_.halfedge_handle(eh, 0)),
            mesh_.face_handle(mesh_.halfedge_handle(eh, 1))};
  }

  /// The four vertices of the two triangles at an edge.
  std::array<VertexHandle, 4> cycle_without(EdgeHandle eh) const {
    const HalfedgeHandle a = mesh_.halfedge_handle(eh, 0), b = mesh_.halfedge_handle(eh, 1);
    return {mesh_.to_vertex_handle(a), mesh_.to_vertex_handle(mesh_.next_halfedge_handle(a)),
            mesh_.to_vertex_handle(b), mesh_.to_vertex_handle(mesh_.next_halfedge_handle(b))};
  }

  double least_jacobian(const std::array<VertexHandle, 4>& cycle) const {
    double least = 1;
    for (std::size_t k = 0; k < 4; ++k) {
      const Metric& m = mesh_.property(metric_, cycle[k]);
      const Uv at = mesh_.property(uv_, cycle[k]);
      const Uv e1 = mesh_.property(uv_, cycle[(k + 1) % 4]) - at;
      const Uv e2 = mesh_.property(uv_, cycle[(k + 3) % 4]) - at;
      const double product = squared_length(m, e1) * squared_length(m, e2);
      least = std::min(least, product > 0 ? density(m) * cross(e1, e2) / std::sqrt(product) : 0);
    }
    return least;
  }

  void merge(EdgeHandle eh, const std::array<FaceHandle, 2>& faces) {
    fresh_.clear();
    fresh_.add(cycle_without(eh));
    editor_.replace(faces, fresh_, made_);
  }

  PolyMesh& mesh_;
  FaceEditor& editor_;
  decltype(keys::vertex_uv)::Handle uv_;
  decltype(keys::vertex_metric)::Handle metric_;
  FaceCycles fresh_;
  std::vector<FaceHandle> made_;
};

}  // namespace

std::size_t pair_triangles(PolyMesh& mesh, FaceEditor& editor, const RunContext& context) {
  return Pairing(mesh, editor).run(context);
}

}  // namespace surfmesh
