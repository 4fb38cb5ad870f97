// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/sag.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "surfmesh/core/parallel.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/quality/contour_distance.hh"
#include "surfmesh/quality/corners_beyond.hh"
#include "surfmesh/quality/face_corners.hh"
#include "surfmesh/quality/triangle_distance.hh"
#include "surfmesh/quality/triangle_sag.hh"

namespace surfmesh {
namespace {

/// Faces that are measured together, before others that are then known to be below them are left
/// out. Not by the number of threads, for that must not change a result.
constexpr std::size_t kFacesAtOnce = 256;

/// The greatest distance so far, and where it is.
struct Greatest {
  double sag = 0;
  Vec3 at = Vec3::Zero();

  /// The first of equal ones stays.
  void take(double distance, const Vec3& point) {
    if (distance > sag) *this = {distance, point};
  }
};

/// The triangles that a face may be taken to consist of.
std::vector<detail::SurfaceTriangle> triangles_of(const PolyMesh& mesh, FaceHandle fh) {
  const auto uv_of = require(mesh, keys::corner_uv);
  std::vector<detail::SurfaceTriangle> triangles;
  detail::visit_possible_triangles(detail::corners_of(mesh, fh), [&](const auto& corners) {
    const auto [a, b, c] = corners;
    triangles.push_back(
        {detail::points_of(mesh, corners),
         {mesh.property(uv_of, a), mesh.property(uv_of, b), mesh.property(uv_of, c)}});
  });
  return triangles;
}

/// Measures the faces of a mesh.
class SagMeter {
 public:
  SagMeter(const PolyMesh& mesh, const Model& model, const SurfaceSearch& search,
           const RunContext& context, const SagDemands& demands)
      : mesh_(mesh),
        model_(model),
        search_(search),
        context_(context),
        demands_(demands),
        patch_of_(require(mesh, keys::face_patch)),
        beyond_(mesh),
        faces_(mesh.n_faces()),
        remembered_(mesh.n_faces()) {}

  Sag run() {
    estimate_faces();
    for (const FaceSag& face : faces_) greatest_ = std::max(greatest_, face.sag - face.error);
    measure_estimated();
    measure_unknown();
    if (demands_.memory) demands_.memory->keep(mesh_, faces_);
    Sag result;
    Greatest greatest;
    for (const FaceSag& face : faces_) {
      result.of_faces.push_back(face.sag);
      if (face.is_measured) greatest.take(face.sag, face.at);
    }
    result.max = greatest.sag;
    result.max_at = greatest.at;
    if (demands_.contours) add_contours(result);
    return result;
  }

 private:
  struct Triangle : detail::SurfaceTriangle {
    FaceHandle face;
    const Surface& surface;
    /// Those around a face on several of them, whose (u,v) do not tell where its surface is.
    std::span<const int> patches;
  };

  void estimate_faces() {
    for_each_face([this](FaceHandle fh) {
      remembered_[index(fh)] = demands_.memory ? demands_.memory->find(mesh_, fh) : nullptr;
    });
    for_each_face([this](FaceHandle fh) {
      faces_[index(fh)] = is_remembered(fh) ? *remembered_[index(fh)] : estimate(fh);
    });
  }

  template <class Visit>
  void for_each_face(Visit visit) const {
    share_ranges(mesh_.n_faces(), [&](std::size_t first, std::size_t end) {
      for (std::size_t f = first; f < end; ++f) {
        if (f % kSearchesBetweenCancellation == 0) context_.throw_if_cancelled();
        visit(FaceHandle(static_cast<int>(f)));
      }
    });
  }

  /// Raise the faces that are the nearest ones to points of contours, and farther from these.
  void add_contours(Sag& result) const {
    const double least = std::min(result.max, demands_.asked);
    for (const ContourDistance& far :
         far_contour_points(mesh_, *demands_.contours, least, context_)) {
      double& of_face = result.of_faces[index(far.face)];
      of_face = std::max(of_face, far.distance);
      if (far.distance <= result.max) continue;
      result.max = far.distance;
      result.max_at = far.point;
      result.max_contour = far.contour;
    }
  }

  /// True if a face and all around it are as they were.
  bool is_remembered(FaceHandle fh) const {
    for (const VertexHandle vh : mesh_.fv_range(fh)) {
      for (const FaceHandle near : mesh_.vf_range(vh)) {
        if (!remembered_[index(near)]) return false;
      }
    }
    return true;
  }

  FaceSag estimate(FaceHandle fh) const {
    const Surface& surface = model_.surface(mesh_.property(patch_of_, fh));
    FaceSag face;
    if (beyond_.any_of(fh)) {
      face.error = std::numeric_limits<double>::infinity();
      return face;
    }
    double aside = 0;
    for (const detail::SurfaceTriangle& triangle : triangles_of(mesh_, fh)) {
      const detail::SagEstimate estimate = detail::estimate_plane_sag(surface, triangle);
      face.sag = std::max(face.sag, estimate.sag);
      face.error = std::max(face.error, estimate.error);
      aside = std::max(aside, estimate.aside);
    }
    // The edge there is at most so far from the surface.
    if (is_beside_sharp_bend(fh)) face.error += aside;
    return face;
  }

  /// True if the planes of a face and of one beside it do not tell how far their edge is from the
  /// surface.
  bool is_beside_sharp_bend(FaceHandle fh) const {
    const Vec3 normal = normal_of(fh);
    for (const FaceHandle other : mesh_.ff_range(fh)) {
      if (normal.dot(normal_of(other)) < detail::kSharpCosine) return true;
    }
    return false;
  }

  Vec3 normal_of(FaceHandle fh) const {
    const std::vector<HalfedgeHandle> corners = detail::corners_of(mesh_, fh);
    const Vec3 a = detail::point_of(mesh_, corners[0]);
    return (detail::point_of(mesh_, corners[1]) - a)
        .cross(detail::point_of(mesh_, corners[2]) - a)
        .stableNormalized();
  }

  /// The sag below which that of a face does not matter.
  double bar() const { return std::min(greatest_, demands_.asked); }

  /// Measure the faces that may be above the bar, which rises, the farthest first.
  void measure_estimated() {
    std::vector<std::size_t> order;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const FaceSag& face = faces_[f];
      if (!face.is_measured && std::isfinite(face.error) && face.most() > bar()) order.push_back(f);
    }
    std::stable_sort(order.begin(), order.end(), [this](std::size_t f, std::size_t g) {
      return faces_[f].most() > faces_[g].most();
    });
    for (std::size_t first = 0; first < order.size(); first += kFacesAtOnce) {
      const std::size_t end = std::min(first + kFacesAtOnce, order.size());
      if (faces_[order[first]].most() <= bar()) return;
      measure({order.begin() + static_cast<std::ptrdiff_t>(first),
               order.begin() + static_cast<std::ptrdiff_t>(end)});
    }
  }

  /// Measure the faces that estimates tell nothing of.
  void measure_unknown() {
    std::vector<std::size_t> chosen;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      if (!std::isfinite(faces_[f].error)) chosen.push_back(f);
    }
    measure(chosen);
  }

  void measure(const std::vector<std::size_t>& chosen) {
    share_ranges(chosen.size(), [&](std::size_t first, std::size_t end) {
      for (std::size_t i = first; i < end; ++i) {
        if (i % kSearchesBetweenCancellation == 0) context_.throw_if_cancelled();
        measure(FaceHandle(static_cast<int>(chosen[i])));
      }
    });
    for (const std::size_t f : chosen) greatest_ = std::max(greatest_, faces_[f].sag);
  }

  /// Measure a face, unless it is below what matters.
  void measure(FaceHandle fh) {
    const Surface& surface = model_.surface(mesh_.property(patch_of_, fh));
    std::vector<int> patches;
    if (beyond_.any_of(fh)) patches = beyond_.patches_around(fh);
    Greatest greatest;
    for (const detail::SurfaceTriangle& triangle : triangles_of(mesh_, fh)) {
      const Greatest own_greatest = greatest_sample({triangle, fh, surface, patches});
      greatest.take(own_greatest.sag, own_greatest.at);
    }
    FaceSag& face = faces_[index(fh)];
    if (greatest.sag > 0) {
      face = {greatest.sag, 0, true, greatest.at};
    } else {
      face.sag = std::min(face.sag, detail::kSearchedShare * bar());
      face.error = 0;
    }
  }

  /// The greatest distance at a sample, after a search around it; none if that cannot be above the
  /// bar.
  Greatest greatest_sample(const Triangle& triangle) const {
    const double least = detail::kSearchedShare * bar();
    detail::SagSample greatest{{}, least};
    const auto distance = [&](const detail::Weights& w) {
      return distance_at(triangle, w, greatest.distance);
    };
    for (const detail::Weights& w : detail::sag_samples()) {
      const double there = distance(w);
      if (there > greatest.distance) greatest = {w, there};
    }
    Greatest result;
    if (greatest.distance <= least) return result;
    const detail::SagSample found = detail::search_sag(greatest, distance);
    result.take(found.distance, point_at(triangle, found.weights));
    return result;
  }

  static Vec3 point_at(const Triangle& t, const detail::Weights& w) {
    return w[0] * t.points[0] + w[1] * t.points[1] + w[2] * t.points[2];
  }

  /// The distance at a sample, if it is above `known`; else any value up to that.
  double distance_at(const Triangle& t, const detail::Weights& w, double known) const {
    const Vec3 point = point_at(t, w);
    // The nearest point is no farther from the mesh.
    if (!t.patches.empty()) {
      return std::max(known, search_.nearest_around(point, t.patches, known).distance);
    }
    const Uv uv = w[0] * t.uvs[0] + w[1] * t.uvs[1] + w[2] * t.uvs[2];
    const Vec3 on_surface = t.surface.evaluate(uv, Order::Position).point;
    // Both nearest points are at most as far as these two from each other.
    const double bound = (on_surface - point).norm();
    if (bound <= known) return known;
    double distance = std::max(known, from_mesh(t, on_surface, known));
    if (bound > distance) distance = std::max(distance, from_surface(t, point, uv, distance));
    return distance;
  }

  /// The distance of a point of the surface from the triangle or one of those around.
  double from_mesh(const Triangle& t, const Vec3& on_surface, double known) const {
    const auto own = detail::triangle_distance(on_surface, t.points);
    if (own.is_inside || own.distance <= known) return own.distance;
    double nearest = own.distance;
    for (const VertexHandle vh : mesh_.fv_range(t.face)) {
      for (const FaceHandle fh : mesh_.vf_range(vh)) {
        nearest = std::min(nearest, from_face(fh, on_surface));
      }
    }
    return nearest;
  }

  double from_face(FaceHandle fh, const Vec3& point) const {
    double nearest = std::numeric_limits<double>::infinity();
    detail::visit_triangles(detail::corners_of(mesh_, fh), [&](const auto& corners) {
      const std::array<Vec3, 3> points = detail::points_of(mesh_, corners);
      nearest = std::min(nearest, detail::triangle_distance(point, points).distance);
    });
    return nearest;
  }

  /// The distance of a point of the triangle from the surface.
  double from_surface(const Triangle& t, const Vec3& point, Uv uv, double known) const {
    const NearPoint near = find_near_point(t.surface, point, uv, {known, detail::kSagAccuracy});
    if (!near.is_on_border || near.distance <= known) return near.distance;
    return std::min(near.distance, search_.nearest(point).distance);
  }

  const PolyMesh& mesh_;
  const Model& model_;
  const SurfaceSearch& search_;
  const RunContext& context_;
  const SagDemands& demands_;
  double greatest_ = 0;  ///< that is known of
  decltype(keys::face_patch)::Handle patch_of_;
  detail::CornersBeyond beyond_;
  std::vector<FaceSag> faces_;
  std::vector<const FaceSag*> remembered_;  ///< of the mesh before, by face; null for others
};

}  // namespace

Sag measure_sag(const PolyMesh& mesh, const Model& model, const SurfaceSearch& search,
                const RunContext& context, const SagDemands& demands) {
  return SagMeter(mesh, model, search, context, demands).run();
}

std::vector<double> estimate_sag(const PolyMesh& mesh, const Model& model,
                                 const RunContext& context) {
  const auto patch_of = require(mesh, keys::face_patch);
  std::vector<double> sags(mesh.n_faces(), 0);
  share_ranges(mesh.n_faces(), [&](std::size_t first, std::size_t end) {
    for (std::size_t f = first; f < end; ++f) {
      if (f % kSearchesBetweenCancellation == 0) context.throw_if_cancelled();
      const FaceHandle fh(static_cast<int>(f));
      const Surface& surface = model.surface(mesh.property(patch_of, fh));
      for (const detail::SurfaceTriangle& triangle : triangles_of(mesh, fh)) {
        sags[f] = std::max(sags[f], detail::estimate_plane_sag(surface, triangle).sag);
      }
    }
  });
  return sags;
}

}  // namespace surfmesh
