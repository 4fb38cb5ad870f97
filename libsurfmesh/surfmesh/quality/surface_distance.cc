// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/surface_distance.hh"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "surfmesh/core/counted.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/quality/corners_beyond.hh"
#include "surfmesh/quality/face_corners.hh"
#include "surfmesh/quality/facing.hh"
#include "surfmesh/quality/project_mesh.hh"

namespace surfmesh {
namespace {

using detail::corners_of;
using detail::point_of;

/// Corners farther from the surface than this share of the diagonal are no matter of rounding.
constexpr double kOffSurface = 1e-6;

/// Ask before a face.
void ask_at(FaceHandle fh, const RunContext& context) {
  if (index(fh) % kSearchesBetweenCancellation == 0) context.throw_if_cancelled();
}

/// Cosine of the angle between the normals of face and surface from which a projected face counts
/// as turned. Beside sharp edges, and where a surface passes through itself, corners may be
/// projected to the wrong side, whose normal is about perpendicular.
constexpr double kClearlyTurned = 0.5;

/// The share of a patch by which more of it has to lie on one side of the surface than on the
/// other, for projected faces to tell which side the mesh follows. Where a surface is folded onto
/// itself, nearest points are of either sheet.
constexpr double kClearSide = 0.5;

Vec3 sum_of(const std::vector<Vec3>& vectors) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& vector : vectors) sum += vector;
  return sum;
}

/// True if two of the normals are more than 90° apart.
bool are_opposed(const std::vector<Vec3>& normals) {
  for (std::size_t i = 0; i < normals.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (normals[i].dot(normals[j]) < 0) return true;
    }
  }
  return false;
}

/// Measures the faces of a mesh one after the other.
class DistanceMeter {
 public:
  DistanceMeter(const PolyMesh& mesh, const Model& model, const SurfaceSearch& search,
                bool is_projected)
      : mesh_(mesh),
        model_(model),
        search_(search),
        is_projected_(is_projected),
        patch_of_(require(mesh, keys::face_patch)),
        uv_of_(require(mesh, keys::corner_uv)),
        beyond_(mesh),
        facing_(mesh.n_faces(), 0),
        is_off_(mesh.n_faces(), 0),
        is_coarse_(mesh.n_faces(), 0),
        side_of_(model.patches.size(), 0),
        area_of_(model.patches.size(), 0),
        on_surface_(surface_tolerance(mesh, model)),
        off_surface_(
            std::max({kOffSurface * model.diagonal, model.joining, greatest_tolerance(model)})) {}

  SurfaceDistance run(const RunContext& context) {
    for (const FaceHandle fh : mesh_.faces()) {
      ask_at(fh, context);
      measure(fh);
    }
    if (samples_ > 0) result_.mean = sum_ / static_cast<double>(samples_);
    find_turned(context);
    for (MeshFault* fault : {&turned_, &off_}) {
      if (fault->count > 0) result_.faults.push_back(std::move(*fault));
    }
    return std::move(result_);
  }

 private:
  struct Corner {
    Vec3 point;
    Uv uv;
  };

  const Surface& surface_of(FaceHandle fh) const {
    const int patch = mesh_.property(patch_of_, fh);
    if (patch < 0 || static_cast<std::size_t>(patch) >= model_.patches.size()) {
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("face {} lies on patch {}, but the model has {}, counted from 0; was "
                              "the mesh made of another model, or with other options of its cages "
                              "(patches, weld, scheme)?",
                              fh.idx(), patch, counted(model_.patches.size(), "patch", "patches")));
    }
    return model_.surface(patch);
  }

  std::string face_text(FaceHandle fh) const {
    const auto patch = static_cast<std::size_t>(mesh_.property(patch_of_, fh));
    return fmt::format("face {} of patch {}", fh.idx(), model_.patches[patch].name);
  }

  void measure(FaceHandle fh) {
    const Surface& surface = surface_of(fh);
    std::vector<Corner> corners;
    std::vector<Vec3> normals;
    for (const HalfedgeHandle heh : corners_of(mesh_, fh)) {
      corners.push_back({point_of(mesh_, heh), mesh_.property(uv_of_, heh)});
      if (beyond_(heh)) {
        measure_corner_beyond(heh);
      } else {
        normals.push_back(measure_corner(surface, corners.back(), fh));
      }
    }
    detail::visit_triangles(corners, [&](const std::array<Corner, 3>& triangle) {
      measure_samples(surface, triangle, fh);
    });
    const Vec3 area = detail::double_area_of(mesh_, corners_of(mesh_, fh));
    const double cosine = facing(area, sum_of(normals));
    facing_[index(fh)] = cosine;
    is_coarse_[index(fh)] = are_opposed(normals) || normals.size() < 2 ? 1 : 0;
    const auto patch = static_cast<std::size_t>(mesh_.property(patch_of_, fh));
    side_of_[patch] += cosine > 0 ? area.norm() : -area.norm();
    area_of_[patch] += area.norm();
  }

  /// Returns the normal p_u × p_v of the surface there; zero where it has none.
  Vec3 measure_corner(const Surface& surface, const Corner& corner, FaceHandle fh) {
    const Jet jet = surface.evaluate(corner.uv, Order::First);
    take_corner((jet.point - corner.point).norm(), corner.point, fh);
    return jet.du.cross(jet.dv);
  }

  /// The vertex lies on another patch, of which most have another corner.
  void measure_corner_beyond(HalfedgeHandle corner) {
    const VertexHandle vh = mesh_.to_vertex_handle(corner);
    if (beyond_.corner_on_patch(vh).is_valid()) return;
    const Vec3 point = point_of(mesh_, corner);
    const NearPoint near = search_.nearest_around(point, beyond_.patches_around(vh), on_surface_);
    take_corner(near.distance, point, mesh_.face_handle(corner));
  }

  void take_corner(double distance, const Vec3& point, FaceHandle fh) {
    ++corners_;
    if (distance > on_surface_) {
      ++corners_off_;
      is_off_[index(fh)] = 1;
    }
    if (distance > result_.max_corner) {
      result_.max_corner = distance;
      result_.max_corner_face = index(fh);
    }
    if (!is_projected_ && distance > off_surface_) {
      off_.add([&] {
        return fmt::format("{} at {}, by {:.3g}", face_text(fh), point_text(point), distance);
      });
    }
  }

  void measure_samples(const Surface& surface, const std::array<Corner, 3>& t, FaceHandle fh) {
    constexpr double third = 1.0 / 3.0;
    constexpr std::array<std::array<double, 3>, 4> weights = {
        {{third, third, third}, {0.5, 0.5, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}}};
    const bool is_beyond = beyond_.any_of(fh);
    for (const auto& w : weights) {
      const Vec3 point = w[0] * t[0].point + w[1] * t[1].point + w[2] * t[2].point;
      const Uv guess = w[0] * t[0].uv + w[1] * t[1].uv + w[2] * t[2].uv;
      NearPoint near = find_near_point(surface, point, guess);
      if ((near.is_on_border || is_beyond) && near.distance > on_surface_) {
        near.distance = std::min(near.distance, search_.nearest(point).distance);
      }
      // Between projected corners on both sides of a seam the guess is on the other side of a ring.
      if (is_projected_ && near.distance > result_.max) {
        near.distance = std::min(near.distance, search_.nearest(point).distance);
      }
      // What would be the greatest distance is worth a closer look.
      if (is_beyond && near.distance > result_.max) {
        near.distance = std::min(
            near.distance,
            search_.nearest_around(point, beyond_.patches_around(fh), result_.max).distance);
      }
      sum_ += near.distance;
      ++samples_;
      if (near.distance <= result_.max) continue;
      result_.max = near.distance;
      result_.max_face = index(fh);
      result_.max_at = point;
    }
  }

  void find_turned(const RunContext& context) {
    const double least_facing = is_projected_ ? -kClearlyTurned : 0;
    for (const FaceHandle fh : mesh_.faces()) {
      ask_at(fh, context);
      if (facing_its_side(fh) > least_facing) continue;
      if (is_projected_ && (!can_be_judged(fh) || goes_on_in_a_neighbour(fh))) {
        ++result_.unjudged;
        continue;
      }
      if (is_projected_ && faces_a_sheet(fh)) continue;
      turned_.add([&] {
        return fmt::format("{} at {}", face_text(fh),
                           point_text(detail::middle_of(mesh_, corners_of(mesh_, fh))));
      });
    }
  }

  /// Cosine of the angle between face and surface, as the mesh follows its patch.
  double facing_its_side(FaceHandle fh) const {
    const double side = side_of_[static_cast<std::size_t>(mesh_.property(patch_of_, fh))];
    return side < 0 ? -facing_[index(fh)] : facing_[index(fh)];
  }

  /// True if a face about parallel to this one lies beside it and is not turned: at a knife edge of
  /// the surface, nearest points of one of them are on the other side of the blade.
  bool goes_on_in_a_neighbour(FaceHandle fh) const {
    const auto normal = [&](FaceHandle face) {
      return detail::double_area_of(mesh_, corners_of(mesh_, face));
    };
    const auto neighbours = mesh_.ff_range(fh);
    return std::any_of(neighbours.begin(), neighbours.end(), [&](FaceHandle other) {
      return facing_its_side(other) > 0 && facing(normal(fh), normal(other)) > kClearlyTurned;
    });
  }

  /// False if the projection has not found a corner of a face, although most corners of the mesh
  /// lie on the surface, or if the normals at its corners do not tell its side, or its patch has
  /// none.
  bool can_be_judged(FaceHandle fh) const {
    const auto patch = static_cast<std::size_t>(mesh_.property(patch_of_, fh));
    const bool is_clear = std::abs(side_of_[patch]) >= kClearSide * area_of_[patch];
    return is_clear && !is_coarse_[index(fh)] &&
           (!is_off_[index(fh)] || 2 * corners_off_ > corners_);
  }

  /// True if a face is turned against one sheet of the surface, but not against another one in
  /// the same place: where the surface is folded onto itself, projection takes either.
  bool faces_a_sheet(FaceHandle fh) const {
    const std::vector<HalfedgeHandle> corners = corners_of(mesh_, fh);
    const Vec3 area = detail::double_area_of(mesh_, corners);
    const std::vector<NearPoint> feet = search_.feet(detail::middle_of(mesh_, corners));
    const double reach = 2 * feet.front().distance + on_surface_;
    return std::any_of(feet.begin(), feet.end(), [&](const NearPoint& foot) {
      const Jet jet = model_.surface(foot.patch).evaluate(foot.uv, Order::First);
      const double side = side_of_[static_cast<std::size_t>(foot.patch)] < 0 ? -1 : 1;
      return foot.distance <= reach && side * facing(area, jet.du.cross(jet.dv)) > 0;
    });
  }

  const PolyMesh& mesh_;
  const Model& model_;
  const SurfaceSearch& search_;
  bool is_projected_;
  decltype(keys::face_patch)::Handle patch_of_;
  decltype(keys::corner_uv)::Handle uv_of_;
  detail::CornersBeyond beyond_;
  std::vector<double> facing_;  ///< cosine of the angle between face and surface
  std::vector<char> is_off_;    ///< of faces, with a corner that is not on the surface
  /// Of faces, across which the surface turns by more than 90°, or with one corner on their patch.
  std::vector<char> is_coarse_;
  std::vector<double> side_of_;  ///< of each patch, area along minus area against the normal
  std::vector<double> area_of_;  ///< of each patch
  double on_surface_;            ///< distances below are rounding
  double off_surface_;           ///< farther than this, corners are a fault
  SurfaceDistance result_;
  double sum_ = 0;
  std::size_t samples_ = 0;
  std::size_t corners_ = 0;
  std::size_t corners_off_ = 0;
  MeshFault turned_{"turned_face", 0, {}};
  MeshFault off_{"corner_off_surface", 0, {}};
};

}  // namespace

SurfaceDistance measure_distance(const PolyMesh& mesh, const Model& model,
                                 const SurfaceSearch& search, bool is_projected,
                                 const RunContext& context) {
  return DistanceMeter(mesh, model, search, is_projected).run(context);
}

}  // namespace surfmesh
