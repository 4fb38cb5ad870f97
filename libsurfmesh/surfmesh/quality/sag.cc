// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/sag.hh"

#include <algorithm>
#include <array>

#include "surfmesh/core/parallel.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/quality/face_corners.hh"
#include "surfmesh/quality/triangle_distance.hh"
#include "surfmesh/quality/triangle_sag.hh"

namespace surfmesh {
namespace {

/// The greatest distance so far, and where it is.
struct Greatest {
  double sag = 0;
  Vec3 at = Vec3::Zero();

  /// The first of equal ones stays.
  void take(double distance, const Vec3& point) {
    if (distance > sag) *this = {distance, point};
  }
};

/// Measures the faces of a mesh.
class SagMeter {
 public:
  SagMeter(const PolyMesh& mesh, const Model& model, const SurfaceSearch& search)
      : mesh_(mesh),
        model_(model),
        search_(search),
        patch_of_(require(mesh, keys::face_patch)),
        uv_of_(require(mesh, keys::corner_uv)) {}

  Sag run() {
    Sag result;
    result.of_faces.assign(mesh_.n_faces(), 0);
    std::vector<Greatest> of_faces(mesh_.n_faces());
    share_ranges(mesh_.n_faces(), [&](std::size_t first, std::size_t end) {
      for (std::size_t f = first; f < end; ++f) {
        of_faces[f] = measure(FaceHandle(static_cast<int>(f)));
        result.of_faces[f] = of_faces[f].sag;
      }
    });
    Greatest greatest;
    for (const Greatest& of_face : of_faces) greatest.take(of_face.sag, of_face.at);
    result.max = greatest.sag;
    result.max_at = greatest.at;
    return result;
  }

 private:
  struct Triangle {
    FaceHandle face;
    const Surface& surface;
    std::array<Vec3, 3> points;
    std::array<Uv, 3> uvs;
  };

  /// The sag of a face, and the sample at which it is.
  Greatest measure(FaceHandle fh) const {
    const int patch = mesh_.property(patch_of_, fh);
    const Surface& surface = model_.surface(patch);
    const std::vector<HalfedgeHandle> corners = detail::corners_of(mesh_, fh);
    Greatest greatest;
    for (std::size_t k = 2; k < corners.size(); ++k) {
      const std::array<HalfedgeHandle, 3> own = {corners[0], corners[k - 1], corners[k]};
      Triangle triangle{fh, surface, {}, {}};
      for (std::size_t i = 0; i < 3; ++i) {
        triangle.points[i] = detail::point_of(mesh_, own[i]);
        triangle.uvs[i] = mesh_.property(uv_of_, own[i]);
      }
      const Greatest own_greatest = greatest_sample(triangle);
      greatest.take(own_greatest.sag, own_greatest.at);
    }
    return greatest;
  }

  Greatest greatest_sample(const Triangle& triangle) const {
    detail::SagSample greatest;
    const auto distance = [&](const detail::Weights& w) {
      return distance_at(triangle, w, greatest.distance);
    };
    for (const detail::Weights& w : detail::sag_samples()) {
      const double there = distance(w);
      if (there > greatest.distance) greatest = {w, there};
    }
    const detail::SagSample found = detail::search_sag(greatest, distance);
    Greatest result;
    result.take(found.distance, point_at(triangle, found.weights));
    return result;
  }

  static Vec3 point_at(const Triangle& t, const detail::Weights& w) {
    return w[0] * t.points[0] + w[1] * t.points[1] + w[2] * t.points[2];
  }

  /// The distance at a sample, if it is above `known`; else any value up to that.
  double distance_at(const Triangle& t, const detail::Weights& w, double known) const {
    const Vec3 point = point_at(t, w);
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
    const std::vector<HalfedgeHandle> corners = detail::corners_of(mesh_, fh);
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 2; k < corners.size(); ++k) {
      nearest = std::min(nearest,
                         detail::triangle_distance(point, {detail::point_of(mesh_, corners[0]),
                                                           detail::point_of(mesh_, corners[k - 1]),
                                                           detail::point_of(mesh_, corners[k])})
                             .distance);
    }
    return nearest;
  }

  /// The distance of a point of the triangle from the surface.
  double from_surface(const Triangle& t, const Vec3& point, Uv uv, double known) const {
    const NearPoint near = find_near_point(t.surface, point, uv);
    if (!near.is_on_border || near.distance <= known) return near.distance;
    return std::min(near.distance, search_.nearest(point).distance);
  }

  const PolyMesh& mesh_;
  const Model& model_;
  const SurfaceSearch& search_;
  decltype(keys::face_patch)::Handle patch_of_;
  decltype(keys::corner_uv)::Handle uv_of_;
};

}  // namespace

Sag measure_sag(const PolyMesh& mesh, const Model& model, const SurfaceSearch& search) {
  return SagMeter(mesh, model, search).run();
}

}  // namespace surfmesh
