// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/corner_normals.hh"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/geometry/first_form.hh"
#include "surfmesh/quality/corners_beyond.hh"

namespace surfmesh {
namespace {

/// If the domain is this many times shorter along one parameter than along the other, by the
/// derivatives at a point, the shorter derivative is the rounding of a pole's 0. That is below
/// 1e-14; a millionth of the way into a face that is a thousandth of its patch, it is above 1e-9.
constexpr double kVanishing = 1e-10;

/// Shares of the way from a corner without a tangent plane to the middle of its face at which a
/// normal is sought: near enough to be the limit, far enough for a normal with nine digits; then
/// where the surface may be less even.
constexpr double kShareOfLimit = 1e-6;
constexpr double kShareBeyond = 1e-3;
constexpr double kShareOfMiddle = 1;

/// Share of the reach of a singular point within which a vertex is at it.
constexpr double kAtPoint = 1e-3;

/// Cosine of the angle above which a normal and the mean at a singular point are not those of one
/// tangent plane: the vertex is a sharp corner, a tip.
constexpr double kOnePlane = 0.9;

/// Normals of one vertex that differ by less are the same but for rounding, of surfaces that meet
/// smoothly or of faces at a pole: they are made equal, since renderers see an edge where the
/// normals of a vertex differ at all.
constexpr double kSameNormal = 1e-6;

/// The unit normal p_u × p_v; zero where there is no tangent plane.
Vec3 normal_or_zero(const Surface& surface, Uv uv) {
  Jet jet;
  try {
    jet = surface.evaluate(uv, Order::First);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::Geometry) throw;
    return Vec3::Zero();  // derivatives are infinite there
  }
  const Domain domain = surface.domain();
  const double along_u = (domain.u1 - domain.u0) * jet.du.stableNorm();
  const double along_v = (domain.v1 - domain.v0) * jet.dv.stableNorm();
  if (!(std::min(along_u, along_v) > kVanishing * std::max(along_u, along_v))) return Vec3::Zero();
  // Of unit length first: the product of small derivatives would underflow.
  const Vec3 normal = jet.du.stableNormalized().cross(jet.dv.stableNormalized());
  return normal.norm() > kSmallestSine ? Vec3(normal.normalized()) : Vec3::Zero();
}

/// The singular point at a place, null if there is none.
const SingularPoint* singular_point_at(const std::vector<SingularPoint>& points, Uv uv) {
  const auto found = std::find_if(points.begin(), points.end(), [uv](const SingularPoint& point) {
    const Uv step = uv - point.at;
    return std::max(std::abs(step.u), std::abs(step.v)) < kAtPoint * point.reach;
  });
  return found == points.end() ? nullptr : &*found;
}

/// The limit of the normal along a line to a singular point, where derivatives are not those of the
/// surface, by a straight line through the normals at its reach and twice as far.
Vec3 limit_along(const Surface& surface, const SingularPoint& point, Uv direction) {
  const double reach = point.reach / std::hypot(direction.u, direction.v);
  return 2 * normal_or_zero(surface, point.at + reach * direction) -
         normal_or_zero(surface, point.at + 2 * reach * direction);
}

/// The sum of the limits along the diagonals of the cells at a singular point.
Vec3 sum_of_limits(const Surface& surface, const SingularPoint& point) {
  const Domain domain = surface.domain();
  if (domain.shape == Domain::Shape::Triangle) {
    return limit_along(surface, point, domain.at(1.0 / 3, 1.0 / 3) - point.at);
  }
  Vec3 sum = Vec3::Zero();
  for (const Uv diagonal : {Uv{1, 1}, Uv{-1, 1}, Uv{-1, -1}, Uv{1, -1}}) {
    const Uv beside = point.at + point.reach * diagonal;
    if (domain.clamp(beside) == beside) sum += limit_along(surface, point, diagonal);
  }
  return sum;
}

/// The singular points of each patch, for all threads.
std::vector<std::vector<SingularPoint>> singular_points_of(const Model& model) {
  std::vector<std::vector<SingularPoint>> points;
  for (const Patch& patch : model.patches) points.push_back(patch.surface->singular_points());
  return points;
}

/// A face as its patch sees it.
struct FaceInParameters {
  Uv middle;
  bool is_turned = false;  ///< it goes around clockwise in (u,v), so p_u × p_v is its other side
};

/// Writes the normals of the corners of one vertex after the other.
class NormalWriter {
 public:
  NormalWriter(PolyMesh& mesh, const Model& model,
               const std::vector<std::vector<SingularPoint>>& singular_points)
      : mesh_(mesh),
        model_(model),
        singular_points_(singular_points),
        patch_of_(require(mesh, keys::face_patch)),
        contour_of_(find(mesh, keys::edge_contour)),
        uv_of_(require(mesh, keys::corner_uv)),
        beyond_(mesh),
        normal_of_(require(mesh, keys::corner_normal)) {}

  void write(VertexHandle vh) {
    of_vertex_.clear();
    const bool has_singular = write_each(vh);
    for (const HalfedgeHandle corner : mesh_.vih_range(vh)) {
      if (!mesh_.is_boundary(corner) && beyond_(corner)) write_beyond(corner);
    }
    if (has_singular) write_sectors(vh);
  }

 private:
  /// Write the normal of each corner as its patch has it. Most corners of a vertex have one patch
  /// and (u,v): it is evaluated once for them. Returns true if one is at a singular point.
  bool write_each(VertexHandle vh) {
    bool has_singular = false;
    const Surface* surface = nullptr;
    Uv uv;
    Vec3 normal;
    for (const HalfedgeHandle corner : mesh_.vih_range(vh)) {
      if (mesh_.is_boundary(corner) || beyond_(corner)) continue;
      const Surface& own = surface_of(corner);
      if (surface != &own || !(uv == mesh_.property(uv_of_, corner))) {
        surface = &own;
        uv = mesh_.property(uv_of_, corner);
        normal = normal_or_zero(own, uv);
        has_singular |= singular_point_of(corner) != nullptr;
      }
      set(corner, one_of_vertex(outward(own, uv, normal, mesh_.face_handle(corner))));
    }
    return has_singular;
  }

  /// Give a corner that does not lie on its patch the normal of one beside it that does.
  void write_beyond(HalfedgeHandle corner) {
    collect_sector(first_of_sector(corner));
    const auto on_patch = std::find_if(sector_.begin(), sector_.end(),
                                       [this](HalfedgeHandle other) { return !beyond_(other); });
    if (on_patch == sector_.end()) return set(corner, normal_of(mesh_.face_handle(corner)));
    mesh_.property(normal_of_, corner) = mesh_.property(normal_of_, *on_patch);
  }

  /// The corner after the crease before a corner; that itself if there is none.
  HalfedgeHandle first_of_sector(HalfedgeHandle corner) const {
    HalfedgeHandle first = corner;
    while (!divides(first)) {
      first = mesh_.prev_halfedge_handle(mesh_.opposite_halfedge_handle(first));
      if (first == corner) break;
    }
    return first;
  }

  /// Give the corners between two creases, or all around a vertex without any, one normal if they
  /// have one tangent plane. That is the mean of the limits along lines that lie around the
  /// singular point as evenly as its faces: what is left of their errors cancels, for it is that of
  /// a function like r² or r² cos 2θ.
  void write_sectors(VertexHandle vh) {
    HalfedgeHandle any;
    bool is_divided = false;
    for (const HalfedgeHandle corner : mesh_.vih_range(vh)) {
      if (mesh_.is_boundary(corner)) continue;
      any = corner;
      if (!divides(corner)) continue;
      is_divided = true;
      write_sector(corner);
    }
    if (!is_divided) write_sector(any);
  }

  void write_sector(HalfedgeHandle first) {
    collect_sector(first);
    const Vec3 mean = mean_of_sector();
    const bool is_one_plane =
        std::all_of(sector_.begin(), sector_.end(), [&](HalfedgeHandle corner) {
          const Normal& n = mesh_.property(normal_of_, corner);
          return mean.dot(Vec3(n.x, n.y, n.z)) > kOnePlane;
        });
    if (!is_one_plane) return;
    for (const HalfedgeHandle corner : sector_) set(corner, mean);
  }

  /// The corners from one on to the next crease, or all around.
  void collect_sector(HalfedgeHandle first) {
    sector_.clear();
    HalfedgeHandle corner = first, side;
    do {
      sector_.push_back(corner);
      side = mesh_.next_halfedge_handle(corner);
      corner = mesh_.opposite_halfedge_handle(side);
    } while (!divides(side) && corner != first);
  }

  /// The mean of the limits in all patches of the sector; zero if one has no singular point there.
  Vec3 mean_of_sector() const {
    Vec3 sum = Vec3::Zero();
    HalfedgeHandle before;
    for (const HalfedgeHandle corner : sector_) {
      if (beyond_(corner)) continue;
      const SingularPoint* point = singular_point_of(corner);
      if (point == nullptr) return Vec3::Zero();
      if (!before.is_valid() || patch_of(before) != patch_of(corner) ||
          !(mesh_.property(uv_of_, before) == mesh_.property(uv_of_, corner))) {
        const Vec3 limits = sum_of_limits(surface_of(corner), *point);
        sum += in_parameters(mesh_.face_handle(corner)).is_turned ? Vec3(-limits) : limits;
      }
      before = corner;
    }
    return sum.normalized();
  }

  /// True if normals may differ on the two sides of an edge.
  bool divides(HalfedgeHandle side) const {
    const EdgeHandle eh = mesh_.edge_handle(side);
    if (mesh_.is_boundary(eh)) return true;
    const int contour = contour_of_.is_valid() ? mesh_.property(contour_of_, eh) : -1;
    return contour >= 0 && !model_.contour(contour).is_smooth;
  }

  int patch_of(HalfedgeHandle corner) const {
    return mesh_.property(patch_of_, mesh_.face_handle(corner));
  }

  const Surface& surface_of(HalfedgeHandle corner) const {
    return model_.surface(patch_of(corner));
  }

  const SingularPoint* singular_point_of(HalfedgeHandle corner) const {
    return singular_point_at(singular_points_[static_cast<std::size_t>(patch_of(corner))],
                             mesh_.property(uv_of_, corner));
  }

  void set(HalfedgeHandle corner, const Vec3& normal) {
    mesh_.property(normal_of_, corner) = {normal.x(), normal.y(), normal.z()};
  }

  /// A normal, or the one of another corner of the vertex that is the same.
  Vec3 one_of_vertex(const Vec3& normal) {
    for (const Vec3& other : of_vertex_) {
      if ((normal - other).norm() < kSameNormal) return other;
    }
    return of_vertex_.emplace_back(normal);
  }

  /// The normal of a corner, from that of the surface, which is zero if there is none.
  Vec3 outward(const Surface& surface, Uv uv, const Vec3& normal, FaceHandle fh) const {
    const FaceInParameters face = in_parameters(fh);
    Vec3 found = normal;
    for (const double share : {kShareOfLimit, kShareBeyond, kShareOfMiddle}) {
      if (!found.isZero(0)) break;
      found = normal_or_zero(surface, lerp(uv, face.middle, share));
    }
    if (found.isZero(0)) return normal_of(fh);
    return face.is_turned ? Vec3(-found) : found;
  }

  FaceInParameters in_parameters(FaceHandle fh) const {
    const Uv first = mesh_.property(uv_of_, mesh_.halfedge_handle(fh));
    Uv sum{0, 0}, before{0, 0};
    double double_area = 0, count = 0;
    for_each_corner(mesh_, fh, [&](HalfedgeHandle corner) {
      const Uv step = mesh_.property(uv_of_, corner) - first;
      double_area += cross(before, step);
      sum = sum + step;
      before = step;
      ++count;
    });
    return {first + 1 / count * sum, double_area < 0};
  }

  /// The normal of a face itself; one without area has none, and takes any.
  Vec3 normal_of(FaceHandle fh) const {
    const Vec3 first = to_eigen(mesh_.point(mesh_.to_vertex_handle(mesh_.halfedge_handle(fh))));
    Vec3 area = Vec3::Zero(), before = Vec3::Zero();
    for_each_vertex_of(mesh_, fh, [&](int vertex) {
      const Vec3 step = to_eigen(mesh_.point(VertexHandle(vertex))) - first;
      area += before.cross(step);
      before = step;
    });
    return area.isZero(0) ? Vec3(Vec3::UnitZ()) : Vec3(area.stableNormalized());
  }

  PolyMesh& mesh_;
  const Model& model_;
  const std::vector<std::vector<SingularPoint>>& singular_points_;
  decltype(keys::face_patch)::Handle patch_of_;
  decltype(keys::edge_contour)::Handle contour_of_;
  decltype(keys::corner_uv)::Handle uv_of_;
  detail::CornersBeyond beyond_;
  decltype(keys::corner_normal)::Handle normal_of_;
  std::vector<Vec3> of_vertex_;  ///< the different normals of the vertex at work
  std::vector<HalfedgeHandle> sector_;
};

void check_patches(const PolyMesh& mesh, const Model& model) {
  const auto patch_of = require(mesh, keys::face_patch);
  for (const FaceHandle fh : mesh.faces()) {
    const int patch = mesh.property(patch_of, fh);
    if (patch >= 0 && static_cast<std::size_t>(patch) < model.patches.size()) continue;
    throw Error(
        ErrorCode::InvalidInput,
        fmt::format("face {} is of patch {}, which the model does not have", fh.idx(), patch));
  }
}

}  // namespace

void attach_corner_normals(PolyMesh& mesh, const Model& model, const RunContext& context) {
  check_patches(mesh, model);
  require(mesh, keys::corner_uv);
  attach(mesh, keys::corner_normal);
  const auto singular_points = singular_points_of(model);
  share_ranges(mesh.n_vertices(), [&](std::size_t first, std::size_t end) {
    NormalWriter writer(mesh, model, singular_points);
    for (std::size_t v = first; v < end; ++v) {
      if (v % kStepsBetweenCancellation == 0) context.throw_if_cancelled();
      writer.write(VertexHandle(static_cast<int>(v)));
    }
  });
}

}  // namespace surfmesh
