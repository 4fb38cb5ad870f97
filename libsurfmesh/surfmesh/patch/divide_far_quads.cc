// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/patch/divide_far_quads.hh"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "surfmesh/core/face_editor.hh"
#include "surfmesh/patch/sag_meter.hh"
#include "surfmesh/quad/compact_patch.hh"
#include "surfmesh/quad/patch_geometry.hh"
#include "surfmesh/quad/quad_moves.hh"
#include "surfmesh/quad/smooth_quads.hh"

namespace surfmesh::detail {
namespace {

/// Each round divides what is still too far; few are after two.
constexpr int kMostRounds = 5;

/// If more than one quad in so many is too far, sizes are to become smaller instead.
constexpr std::size_t kQuadsPerFar = 40;

/// Scaled Jacobian below which a quad is not worth making.
constexpr double kLeastJacobian = 0.2;

/// Smoothings of the new vertices of a quad before it is measured.
constexpr int kFirstSmoothings = 8;

/// Sweeps of smoothing over all vertices after a round.
constexpr int kQuadSweeps = 4;

class Division {
 public:
  Division(PolyMesh& mesh, const Surface& surface, const MetricField& field, std::size_t fixed,
           double sag)
      : mesh_(mesh),
        surface_(surface),
        meter_(surface, sag),
        uv_(require(mesh, keys::vertex_uv)),
        editor_(mesh),
        geometry_(mesh, field, fixed),
        state_(mesh, editor_, geometry_, {}) {}

  QueryCounts run(const RunContext& context) {
    std::vector<FaceHandle> far = far_quads(context);
    if (far.size() > mesh_.n_faces() / kQuadsPerFar) return geometry_.queries();
    for (int round = 0; round < kMostRounds && divide(far); ++round, far = far_quads(context)) {
      smooth_quads(mesh_, geometry_, SmoothingAim::BetterShape, kQuadSweeps, context);
      smooth_quads(mesh_, geometry_, SmoothingAim::WorstCorners, kQuadSweeps, context);
    }
    compact_patch(mesh_, editor_);
    return geometry_.queries();
  }

 private:
  /// Divide quads that are too far and have no neighbour that has been divided just now.
  /// Returns  true if there were any
  bool divide(const std::vector<FaceHandle>& far) {
    std::vector<char> is_touched(mesh_.n_vertices(), 0);
    bool is_any = false;
    for (const FaceHandle fh : far) {
      if (has_any(fh, is_touched)) continue;
      for (const VertexHandle vh : mesh_.fv_range(fh)) is_touched[index(vh)] = 1;
      is_any = divide(fh) || is_any;
    }
    return is_any;
  }

  std::vector<FaceHandle> far_quads(const RunContext& context) {
    evaluate();
    std::vector<FaceHandle> far;
    for (std::size_t f = 0; f < editor_.face_bound(); ++f) {
      if (f % kSearchesBetweenCancellation == 0) context.throw_if_cancelled();
      const FaceHandle fh(static_cast<int>(f));
      if (editor_.is_used(fh) && !is_near(fh)) far.push_back(fh);
    }
    return far;
  }

  bool has_any(FaceHandle fh, const std::vector<char>& is_marked) const {
    for (const VertexHandle vh : mesh_.fv_range(fh)) {
      if (is_marked[index(vh)] != 0) return true;
    }
    return false;
  }

  /// Divide a quad, unless there is no room for well shaped ones.
  bool divide(FaceHandle fh) {
    if (!insert_pillow(state_, fh, change_)) return false;
    geometry_.begin_trial();
    for (const Replacement::Middle& middle : change_.middles) {
      geometry_.put_between(middle.vertex, middle.others);
    }
    editor_.replace(change_.old, change_.fresh, made_);
    QuadSmoother smoother(geometry_);
    for (int round = 0; round < kFirstSmoothings; ++round) {
      for (const VertexHandle vh : change_.added) smoother.smooth(vh, {.size = 0.1});
    }
    const bool is_good = std::all_of(made_.begin(), made_.end(), [this](FaceHandle made) {
      return geometry_.measure(made).least_jacobian >= kLeastJacobian;
    });
    if (is_good) {
      geometry_.keep_trial();
      return true;
    }
    editor_.undo_replacement();
    geometry_.undo_trial();
    for (const VertexHandle vh : change_.added) editor_.free_vertex(vh);
    return false;
  }

  /// Evaluate the surface where vertices have moved, and forget which quads there are near it.
  void evaluate() {
    corners_.resize(mesh_.n_vertices());
    std::vector<char> has_moved(mesh_.n_vertices(), 0);
    for (std::size_t v = 0; v < editor_.vertex_bound(); ++v) {
      const VertexHandle vh(static_cast<int>(v));
      if (!editor_.is_used(vh) || corners_[v].uv == mesh_.property(uv_, vh)) continue;
      has_moved[v] = 1;
      corners_[v].uv = mesh_.property(uv_, vh);
      corners_[v].point = surface_.evaluate(corners_[v].uv, Order::Position).point;
    }
    is_known_near_.resize(mesh_.n_faces(), 0);
    for (std::size_t f = 0; f < editor_.face_bound(); ++f) {
      const FaceHandle fh(static_cast<int>(f));
      if (editor_.is_used(fh) && has_any(fh, has_moved)) is_known_near_[f] = 0;
    }
  }

  /// True if a quad is near enough to the surface with either of its diagonals.
  bool is_near(FaceHandle fh) {
    char& is_known = is_known_near_[index(fh)];
    if (is_known != 0 || mesh_.valence(fh) != 4) return true;
    std::array<PatchCorner, 4> c;
    std::size_t k = 0;
    for (const VertexHandle vh : mesh_.fv_range(fh)) c[k++] = corners_[index(vh)];
    const bool is_near = meter_.holds(CornerTriangles{{c[0], c[1], c[2]}, {c[2], c[3], c[0]}}) &&
                         meter_.holds(CornerTriangles{{c[1], c[2], c[3]}, {c[3], c[0], c[1]}});
    is_known = is_near ? 1 : 0;
    return is_near;
  }

  PolyMesh& mesh_;
  const Surface& surface_;
  SagMeter meter_;
  decltype(keys::vertex_uv)::Handle uv_;
  FaceEditor editor_;
  PatchGeometry geometry_;
  QuadState state_;
  std::vector<PatchCorner> corners_;  ///< by vertex, where the surface was evaluated last
  std::vector<char> is_known_near_;   ///< by face
  Replacement change_;
  std::vector<FaceHandle> made_;
};

}  // namespace

QueryCounts divide_far_quads(PolyMesh& mesh, const Surface& surface, const MetricField& field,
                             std::size_t fixed, double sag, const RunContext& context) {
  return Division(mesh, surface, field, fixed, sag).run(context);
}

}  // namespace surfmesh::detail
