// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/reach_sag.hh"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "surfmesh/core/parallel.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/geometry/first_form.hh"
#include "surfmesh/metric/size_tensor.hh"
#include "surfmesh/quality/sag.hh"
#include "surfmesh/sizes/size_bounds.hh"
#include "surfmesh/sizes/tables_from_mesh.hh"

namespace surfmesh::detail {
namespace {

/// Meshes whose sizes are scaled everywhere, and then those whose sizes get smaller in places.
constexpr int kBalancedMeshes = 1;
constexpr int kMostCorrectedMeshes = 7;

/// Corrections see a little less than the measure: they aim below the sag.
constexpr double kCorrectedShare = 0.97;

/// Share of the sag at which the scaling of sizes aims, and bounds of one scaling.
constexpr double kAim = 0.9;
constexpr double kMostShrinking = 0.5;
constexpr double kMostGrowth = 2;

/// Sizes at a triangle that is still too far shrink at least so much.
constexpr double kLeastShrinking = 0.93;

/// Radius, in the smaller size, within which they hold: that of the triangle.
constexpr double kReach = 0.6;

class SagLoop {
 public:
  SagLoop(const Model& model, const Sources& sources, const ResolvedSizing& sizing,
          const MeshOnce& mesh_once)
      : model_(model),
        sources_(sources),
        bounds_(sizing.bounds),
        asked_(sizing.sag),
        mesh_once_(mesh_once),
        search_(model) {}

  MeshResult run() {
    for (int i = 0; i < kBalancedMeshes; ++i) {
      mesh(0);
      balance();
    }
    for (int i = 0; i < kMostCorrectedMeshes; ++i) {
      mesh(kCorrectedShare * asked_);
      if (sag_.max <= asked_ || !shrink_locally()) break;
    }
    tell_if_not_reached();
    return std::move(best_);
  }

  const PerStage<double>& seconds() const { return seconds_; }

 private:
  /// Mesh the model, measure the mesh, and keep it if it is the best.
  void mesh(double corrected_sag) {
    now_ = mesh_once_(sources_, corrected_sag);
    seconds_ += now_.report.seconds;
    const StageClock clock(seconds_[Stage::Control]);
    sag_ = measure_sag(now_.mesh, model_, search_);
    now_.report.sag = {asked_, sag_.max};
    if (!is_better()) return;
    best_ = now_;
    const auto worst = std::max_element(sag_.of_faces.begin(), sag_.of_faces.end());
    worst_face_ = FaceHandle(static_cast<int>(worst - sag_.of_faces.begin()));
  }

  void tell_if_not_reached() {
    const double reached = *best_.report.sag.reached;
    if (reached <= asked_) return;
    Notice notice = shortfall(
        NoticeKind::SagNotReached,
        fmt::format("mesh and surface are up to {:.6g} from each other, more than sag = {:.6g} (in "
                    "model units) allows; try a smaller hmin where that is in the way",
                    reached, asked_));
    notice.patch = best_.mesh.property(require(best_.mesh, keys::face_patch), worst_face_);
    notice.point = to_eigen(best_.mesh.calc_face_centroid(worst_face_));
    best_.report.notices.push_back(std::move(notice));
  }

  bool is_better() const {
    if (!best_.report.sag.reached) return true;
    const double best = *best_.report.sag.reached;
    if (sag_.max > asked_) return sag_.max < best;
    return best > asked_ || now_.mesh.n_faces() < best_.mesh.n_faces();
  }

  double sag_of(FaceHandle fh) const { return sag_.of_faces[index(fh)]; }

  /// Sag goes by the square of sizes.
  double scale(double sag) const {
    return std::clamp(std::sqrt(kAim * asked_ / sag), kMostShrinking, kMostGrowth);
  }

  /// The geometric mean over the faces around.
  double scale_at(VertexHandle vh) const {
    double sum = 0;
    int count = 0;
    for (const FaceHandle fh : now_.mesh.vf_range(vh)) {
      sum += std::log(scale(sag_of(fh)));
      ++count;
    }
    return std::exp(sum / count);
  }

  /// Make the vertices of the mesh the nodes of the next control spaces, with scaled sizes.
  void balance() {
    PolyMesh& mesh = now_.mesh;
    const auto metric_of = require(mesh, keys::corner_metric);
    for (const VertexHandle vh : mesh.vertices()) {
      const double squared = std::pow(scale_at(vh), -2);
      for (const HalfedgeHandle corner : mesh.vih_range(vh)) {
        Metric& m = mesh.property(metric_of, corner);
        m = {squared * m.m11, squared * m.m12, squared * m.m22};
      }
    }
    sources_.sag = tables_from_mesh(mesh);
  }

  /// Ask for smaller sizes at the faces that are too far. Returns false if sizes are at hmin at all
  /// of them.
  bool shrink_locally() {
    bool is_any = false;
    for (const FaceHandle fh : now_.mesh.faces()) {
      if (sag_of(fh) > asked_ && shrink_at(fh)) is_any = true;
    }
    return is_any;
  }

  bool shrink_at(FaceHandle fh) {
    const Middle middle = middle_of(fh);
    const double factor = std::min(kLeastShrinking, scale(sag_of(fh)));
    const double along = bounds_.clamp(factor * middle.sizes.l_s);
    const double across = bounds_.clamp(factor * middle.sizes.l_t);
    if (along >= middle.sizes.l_s && across >= middle.sizes.l_t) return false;
    AtSource source{
        middle.patch, middle.uv, {Length::units(along), Length::units(across), middle.sizes.angle}};
    source.radius = Length::units(kReach * middle.sizes.l_t);
    sources_.at.push_back(source);
    return true;
  }

  /// The barycentre of a face in its parameters, and the sizes there.
  struct Middle {
    int patch;
    Uv uv{0, 0};
    PrincipalSizes sizes{};
  };

  Middle middle_of(FaceHandle fh) const {
    const PolyMesh& mesh = now_.mesh;
    const auto uv_of = require(mesh, keys::corner_uv);
    const auto metric_of = require(mesh, keys::corner_metric);
    Middle middle{mesh.property(require(mesh, keys::face_patch), fh)};
    Metric metric{0, 0, 0};
    const double share = 1.0 / mesh.valence(fh);
    for (const HalfedgeHandle corner : mesh.fh_range(fh)) {
      const Metric& m = mesh.property(metric_of, corner);
      middle.uv = middle.uv + share * mesh.property(uv_of, corner);
      metric = {metric.m11 + share * m.m11, metric.m12 + share * m.m12, metric.m22 + share * m.m22};
    }
    const Surface& surface = model_.surface(middle.patch);
    const Jet jet = surface.evaluate(middle.uv, Order::First);
    middle.sizes = principal_sizes(size_from_metric(first_form_factor(jet.du, jet.dv), metric));
    return middle;
  }

  const Model& model_;
  Sources sources_;
  SizeBounds bounds_;
  double asked_;
  const MeshOnce& mesh_once_;
  SurfaceSearch search_;
  MeshResult now_;
  Sag sag_;  ///< of the mesh now
  MeshResult best_;
  FaceHandle worst_face_;  ///< of the best mesh
  PerStage<double> seconds_;
};

}  // namespace

MeshResult reach_sag(const Model& model, const Sources& sources, const ResolvedSizing& sizing,
                     const MeshOnce& mesh_once) {
  const auto start = std::chrono::steady_clock::now();
  SagLoop loop(model, sources, sizing, mesh_once);
  MeshResult result = loop.run();
  result.report.seconds = loop.seconds();
  result.report.wall_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace surfmesh::detail
