// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/reach_sag.hh"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "surfmesh/core/parallel.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/geometry/first_form.hh"
#include "surfmesh/geometry/segment_distance.hh"
#include "surfmesh/metric/size_tensor.hh"
#include "surfmesh/pipeline/scaled_spaces.hh"
#include "surfmesh/quality/face_set_check.hh"
#include "surfmesh/quality/sag.hh"
#include "surfmesh/quality/triangle_sag.hh"

namespace surfmesh::detail {
namespace {

/// Meshes that are corrected. The last ones take little time, for most patches stay as they are.
constexpr int kMostCorrectedMeshes = 10;

/// Share of the sag at which the scaling of sizes aims, and bounds of one scaling. Sags scatter:
/// with 0.85 a tenth of the triangles is corrected, which takes nearly as many triangles and costs
/// shape.
constexpr double kAim = 0.7;

/// Quads scatter more, and only one of 40 may be corrected without cost to all.
constexpr double kAimOfQuads = 0.4;

constexpr double kMostShrinking = 0.5;
constexpr double kMostGrowth = 2;

/// Sizes at a triangle that is still too far shrink at least so much.
constexpr double kLeastShrinking = 0.93;

/// Triangles that are so many times too far have sizes that were not made for the sag.
constexpr double kFarBeyond = 4;

/// Sizes up to so many times hmin are held up by it.
constexpr double kAtLeastSize = 1.1;

/// A mesh is better than those before if its greatest sag is below this share of theirs, or if so
/// few triangles are too far. The latter does not count where hmin is in the way of the worst one.
constexpr double kNearer = 0.99;
constexpr double kFewer = 0.9;

/// So many meshes in a row that are no better end the run: the greatest sags scatter.
constexpr int kMostFailures = 5;
constexpr int kMostFailuresAtHmin = 2;

/// Stretch up to which triangles follow creases that are much narrower than they are: stretched
/// ones reach across them.
constexpr double kMostFollowedStretch = 2;

/// Segments of a contour beside such a triangle become so many times as many. With 1.4, car at
/// 0.02 % has more triangles of poorer shape.
constexpr double kMoreSegments = 1.2;

/// Points of contours are so near to each other that chords keep this share of the sag: the
/// greatest distance between them is at most 3 % greater.
constexpr double kContourTolerance = 1.0 / 32;

/// In all they become at most so many times as many: where that does not help, more would only make
/// the triangles beside flat.
constexpr double kMostSegments = 3;

class SagLoop {
 public:
  SagLoop(const SagTask& task, const MeshWith& mesh_with)
      : task_(task),
        mesh_with_(mesh_with),
        search_(task.model),
        contours_(sharp_contours(task.model, kContourTolerance * asked(), task.context)),
        more_segments_(task.model.contours.size(), 1) {}

  MeshResult run() {
    make_spaces();
    if (spaces_->can_scale()) {
      mesh(0);
      if (balance()) {
        correct();
      } else {
        measure();
      }
    } else {
      mesh(kCorrectedShare * asked());
      measure();
    }
    tell_if_not_reached();
    return std::move(best_);
  }

  const PerStage<double>& seconds() const { return seconds_; }

 private:
  double asked() const { return task_.sizing.sag; }

  void make_spaces() {
    const StageClock clock(seconds_[Stage::Control]);
    spaces_ = std::make_unique<ScaledSpaces>(task_.model, task_.sources, task_.sizing,
                                             task_.control, task_.context);
  }

  ControlSpaces scaled_spaces() {
    const StageClock clock(seconds_[Stage::Control]);
    return spaces_->make();
  }

  void mesh(double corrected_sag) {
    now_ = mesh_with_(scaled_spaces(), corrected_sag, more_segments_);
    seconds_ += now_.report.seconds;
    task_.context.throw_if_cancelled();
  }

  /// Mesh until the sag is reached or nothing more can be done.
  void correct() {
    Progress progress;
    for (int i = 1;; ++i) {
      const std::vector<double> before = std::move(sag_.of_faces);
      mesh(kCorrectedShare * asked());
      measure();
      if (sag_.max <= asked() || i == kMostCorrectedMeshes || sag_.of_faces == before) return;
      if (is_held_everywhere() || !goes_on(progress)) return;
      shrink_locally();
    }
  }

  /// The best of the meshes that were corrected, and how many in a row have been no better.
  struct Progress {
    double nearest = std::numeric_limits<double>::infinity();
    double fewest = std::numeric_limits<double>::infinity();  ///< triangles that are too far
    int failures = 0;
  };

  /// True if meshes become better, or may do so again.
  bool goes_on(Progress& progress) const {
    const bool is_held_now = is_held(now_.mesh, worst_face());
    const auto far = static_cast<double>(far_faces().size());
    const bool is_better =
        sag_.max < kNearer * progress.nearest || (!is_held_now && far < kFewer * progress.fewest);
    progress.failures = is_better ? 0 : progress.failures + 1;
    progress.nearest = std::min(progress.nearest, sag_.max);
    progress.fewest = std::min(progress.fewest, far);
    return progress.failures < (is_held_now ? kMostFailuresAtHmin : kMostFailures);
  }

  /// The faces of the mesh now that are too far.
  std::vector<FaceHandle> far_faces() const {
    std::vector<FaceHandle> faces;
    for (const FaceHandle fh : now_.mesh.faces()) {
      if (sag_.of_faces[index(fh)] > asked()) faces.push_back(fh);
    }
    return faces;
  }

  /// True if most triangles are too far and cannot become smaller, in no direction.
  bool is_held_everywhere() const {
    const std::vector<FaceHandle> far = far_faces();
    const auto held = std::count_if(far.begin(), far.end(), [this](FaceHandle fh) {
      return sizes_at(now_.mesh, fh).greatest <= held_size();
    });
    return 2 * static_cast<std::size_t>(held) > now_.mesh.n_faces();
  }

  /// True if hmin keeps the sizes at a face from becoming smaller.
  bool is_held(const PolyMesh& mesh, FaceHandle fh) const {
    return sizes_at(mesh, fh).least <= held_size();
  }

  double held_size() const { return kAtLeastSize * task_.sizing.bounds.hmin; }

  /// The face of the mesh now that is farthest from the surface.
  FaceHandle worst_face() const {
    const auto worst = std::max_element(sag_.of_faces.begin(), sag_.of_faces.end());
    return FaceHandle(static_cast<int>(worst - sag_.of_faces.begin()));
  }

  /// Measure the mesh, and keep it if it is the best.
  void measure() {
    const StageClock clock(seconds_[Stage::Assemble]);
    sag_ = measure_sag(now_.mesh, task_.model, search_, task_.context,
                       {asked(), &memory_, &contours_});
    now_.report.sag.asked = asked();
    now_.report.sag.reached = sag_.max;
    if (!is_better()) return;
    best_ = now_;
    best_.mesh.property(attach(best_.mesh, keys::face_sag)).data_vector() = sag_.of_faces;
    worst_face_ = worst_face();
    worst_at_ = sag_.max_at;
    worst_contour_ = sag_.max_contour;
  }

  void tell_if_not_reached() {
    const double reached = *best_.report.sag.reached;
    if (reached <= asked()) return;
    Notice notice = shortfall(
        NoticeKind::SagNotReached,
        fmt::format("mesh and surface are up to {:.6g} from each other, more than sag = {:.6g} (in "
                    "model units) allows",
                    reached, asked()));
    notice.patch = best_.mesh.property(require(best_.mesh, keys::face_patch), worst_face_);
    notice.contour = worst_contour_;
    notice.point = worst_at_;
    notice.text += fmt::format(", in patch {}{} at {}: {}", task_.model.patch(notice.patch).name,
                               at_contour(), point_text(*notice.point), cause(notice.patch));
    best_.report.notices.push_back(std::move(notice));
  }

  std::string at_contour() const {
    if (worst_contour_ < 0) return {};
    return fmt::format(" on contour {}", task_.model.contour(worst_contour_).name);
  }

  /// True if a patch is known to jump by more than rounding, beside which nothing else counts.
  bool has_jump(int patch) const {
    return std::ranges::any_of(task_.model.notices, [patch](const Notice& notice) {
      return notice.kind == NoticeKind::SurfaceJump && notice.severity == Severity::Shortfall &&
             notice.patch == patch;
    });
  }

  /// Why the worst face of the best mesh, which is in this patch, is too far, and what helps.
  std::string cause(int patch) const {
    if (has_jump(patch)) return "the surface jumps in this patch, which no element can follow";
    if (is_held(best_.mesh, worst_face_)) {
      const SizeBounds& bounds = task_.sizing.bounds;
      return fmt::format("{} = {:.6g} is in the way, a smaller one helps",
                         bounds.hmin == bounds.hmax ? "size" : "hmin", bounds.hmin);
    }
    if (!spaces_->can_scale()) {
      return "control = mesh does not scale sizes; control = cells does, without the options that "
             "belong to control = mesh";
    }
    if (task_.model.joining > asked() && is_at_shared_contour()) {
      return fmt::format("sides that are joined are up to joining = {:.6g} apart",
                         task_.model.joining);
    }
    if (worst_contour_ >= 0)
      return "the contour bends there within less than its segments can follow";
    if (task_.sizing.stretch > kMostFollowedStretch) {
      return fmt::format(
          "the surface bends there within less than elements of stretch = {:.6g} can follow; "
          "stretch = {:.6g} helps",
          task_.sizing.stretch, kMostFollowedStretch);
    }
    return "the surface bends there within less than elements can follow without being flat";
  }

  /// True if the worst place lies at a contour that several uses share, up to what the search for
  /// it tells.
  bool is_at_shared_contour() const {
    if (worst_contour_ >= 0) return is_shared(worst_contour_);
    const PolyMesh& mesh = best_.mesh;
    const auto contour_of = require(mesh, keys::edge_contour);
    for (const VertexHandle vh : mesh.fv_range(worst_face_)) {
      for (const EdgeHandle eh : mesh.ve_range(vh)) {
        const int contour = mesh.property(contour_of, eh);
        if (contour >= 0 && is_shared(contour) && is_worst_place_at(eh)) return true;
      }
    }
    return false;
  }

  bool is_shared(int contour) const { return task_.model.contour(contour).uses.size() > 1; }

  /// True if the worst place of the worst face lies at an edge.
  bool is_worst_place_at(EdgeHandle eh) const {
    const PolyMesh& mesh = best_.mesh;
    double longest = 0;
    for (const EdgeHandle side : mesh.fe_range(worst_face_)) {
      longest = std::max(longest, mesh.calc_edge_length(side));
    }
    const HalfedgeHandle heh = mesh.halfedge_handle(eh, 0);
    const double distance =
        segment_distance(worst_at_, to_eigen(mesh.point(mesh.from_vertex_handle(heh))),
                         to_eigen(mesh.point(mesh.to_vertex_handle(heh))));
    return distance <= std::max(task_.model.joining, kLastSearchStep * longest);
  }

  /// The least and the greatest size that was asked for at the corners of a face.
  SizeRange sizes_at(const PolyMesh& mesh, FaceHandle fh) const {
    const auto uv_of = require(mesh, keys::corner_uv);
    const auto metric_of = require(mesh, keys::corner_metric);
    const Surface& surface =
        task_.model.surface(mesh.property(require(mesh, keys::face_patch), fh));
    SizeRange sizes{task_.sizing.bounds.hmax, 0};
    for (const HalfedgeHandle corner : mesh.fh_range(fh)) {
      const Jet jet = surface.evaluate(mesh.property(uv_of, corner), Order::First);
      const FirstFormFactor form = first_form_factor(jet.du, jet.dv);
      if (!is_regular(form)) continue;
      const SizeRange there = size_range(size_from_metric(form, mesh.property(metric_of, corner)));
      sizes = {std::min(sizes.least, there.least), std::max(sizes.greatest, there.greatest)};
    }
    return sizes;
  }

  bool is_better() const {
    if (!best_.report.sag.reached) return true;
    const double best = *best_.report.sag.reached;
    if (sag_.max > asked()) return sag_.max < best;
    return best > asked() || now_.mesh.n_faces() < best_.mesh.n_faces();
  }

  /// The logarithm of a scale for sizes: the sag goes by their square.
  double log_scale(double sag) const {
    const double aim = now_.report.mesh.quads > 0 ? kAimOfQuads : kAim;
    return std::log(std::clamp(std::sqrt(aim * asked() / sag), kMostShrinking, kMostGrowth));
  }

  /// Multiply sizes by what the sag of the triangles allows. Returns false if most triangles are
  /// far beyond the sag although sizes were made for it: then hmin is in the way everywhere.
  bool balance() {
    const StageClock clock(seconds_[Stage::Assemble]);
    const std::vector<double> sags = estimate_sag(now_.mesh, task_.model, task_.context);
    WantedByPatch wanted(task_.model.patches.size());
    for (const FaceHandle fh : now_.mesh.faces()) {
      wanted[patch_of(fh)].push_back({middle_of(fh), log_scale(sags[index(fh)])});
    }
    const auto is_far = [this](double sag) { return sag > kFarBeyond * asked(); };
    if (2 * std::count_if(sags.begin(), sags.end(), is_far) > std::ssize(sags)) return false;
    share_indices(wanted.size(), [&](std::size_t p) { spaces_->factors(p).multiply(wanted[p]); });
    return true;
  }

  /// Make sizes smaller around the faces that are too far, and segments beside them shorter: a
  /// contour has as few as it needs itself, and takes no notice of smaller sizes.
  void shrink_locally() {
    const auto contour_of = require(now_.mesh, keys::edge_contour);
    std::set<int> contours;
    WantedByPatch wanted(task_.model.patches.size());
    for (const FaceHandle fh : far_faces()) {
      for (const EdgeHandle eh : now_.mesh.fe_range(fh)) {
        const int contour = now_.mesh.property(contour_of, eh);
        if (contour >= 0) contours.insert(contour);
      }
      wanted[patch_of(fh)].push_back(
          {middle_of(fh),
           std::min(std::log(kLeastShrinking), log_scale(sag_.of_faces[index(fh)]))});
    }
    for (const int c : contours) {
      double& times = more_segments_[static_cast<std::size_t>(c)];
      times = std::min(kMostSegments, kMoreSegments * times);
    }
    for (std::size_t p = 0; p < wanted.size(); ++p)
      spaces_->factors(p).lower(wanted[p], task_.sizing.bounds.hmax);
  }

  std::size_t patch_of(FaceHandle fh) const {
    return static_cast<std::size_t>(now_.mesh.property(require(now_.mesh, keys::face_patch), fh));
  }

  /// The barycentre of a face in its parameters.
  Uv middle_of(FaceHandle fh) const {
    const auto uv_of = require(now_.mesh, keys::corner_uv);
    const double share = 1.0 / now_.mesh.valence(fh);
    Uv middle{0, 0};
    for (const HalfedgeHandle corner : now_.mesh.fh_range(fh)) {
      middle = middle + share * now_.mesh.property(uv_of, corner);
    }
    return middle;
  }

  using WantedByPatch = std::vector<std::vector<SizeFactors::Wanted>>;

  const SagTask& task_;
  const MeshWith& mesh_with_;
  SurfaceSearch search_;
  std::vector<SharpContour> contours_;
  SagMemory memory_;
  std::unique_ptr<ScaledSpaces> spaces_;
  std::vector<double> more_segments_;  ///< by contour
  MeshResult now_;
  Sag sag_;  ///< of the mesh now
  MeshResult best_;
  FaceHandle worst_face_;  ///< of the best mesh
  Vec3 worst_at_ = Vec3::Zero();
  int worst_contour_ = -1;  ///< that is farthest from the best mesh; -1 if a face is farther
  PerStage<double> seconds_;
};

}  // namespace

MeshResult reach_sag(const SagTask& task, const MeshWith& mesh_with) {
  const auto start = std::chrono::steady_clock::now();
  SagLoop loop(task, mesh_with);
  MeshResult result = loop.run();
  result.report.seconds = loop.seconds();
  result.report.wall_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace surfmesh::detail
