// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/result_places.hh"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>

#include "surfmesh/cage/face_weights.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/model/surface_walk.hh"
#include "surfmesh/quality/corners_beyond.hh"
#include "surfmesh/quality/face_corners.hh"
#include "surfmesh/quality/surface_search.hh"

namespace surfmesh {
namespace {

/// Share of the way from a corner to the middle of its face at which the cage is asked: far more
/// than rounding, far less than the way to the next face of the cage.
constexpr double kInside = 1.0 / (1 << 20);

bool contains(const Domain& domain, Uv uv) {
  return domain.clamp(uv) == uv && domain.fold(uv) == uv;
}

/// The nearest point in the domain; the (u,v) may be outside of it by more than rounding.
Uv brought_in(const Domain& domain, Uv uv) {
  uv = domain.clamp(uv);
  if (domain.shape == Domain::Shape::Rectangle) return uv;
  const double s = (uv.u - domain.u0) / (domain.u1 - domain.u0);
  const double t = (uv.v - domain.v0) / (domain.v1 - domain.v0);
  const double excess = std::max(s + t - 1, 0.0) / 2;
  return domain.clamp(domain.at(s - excess, t - excess));
}

/// A vertex this near to a surface is on it, as a share of the model's diagonal.
constexpr double kOnSurface = 1e-6;

/// The domain of a face or of a quarter of one.
Domain domain_of(const CagePlace& place) {
  Domain domain;
  if (place.part < 0 && place.corners == 3) domain.shape = Domain::Shape::Triangle;
  return domain;
}

/// Finds the places of vertices that no face around them knows: along a straight way from a corner
/// of such a face, and if that does not lead to them, on all patches.
class PlaceFinder {
 public:
  PlaceFinder(const PolyMesh& mesh, const Model& model)
      : mesh_(mesh), model_(model), walk_(model, smooth_contours(model, {})) {}

  /// Take the place at a point near the end of a step.
  bool try_way(const SurfacePlace& from, Uv step, const Vec3& point, SurfacePlace& place) const {
    const auto end = walk_.go(from, step);
    if (!end) return false;
    const NearPoint near = find_near_point(model_.surface(end->place.patch), point, end->place.uv);
    place = {end->place.patch, near.uv};
    return near.distance <= kOnSurface * model_.diagonal;
  }

  SurfacePlace search(VertexHandle vertex) {
    if (!search_) search_.emplace(model_);
    const Vec3 point = to_eigen(mesh_.point(vertex));
    const NearPoint near = search_->nearest_around(
        point, detail::CornersBeyond(mesh_).patches_around(vertex), kOnSurface * model_.diagonal);
    return {near.patch, near.uv};
  }

 private:
  const PolyMesh& mesh_;
  const Model& model_;
  SurfaceWalk walk_;
  std::optional<SurfaceSearch> search_;
};

}  // namespace

ResultPlaces::ResultPlaces(const PolyMesh& result, const Model& model)
    : mesh_(result),
      model_(model),
      patch_of_(require(result, keys::face_patch)),
      uv_of_(require(result, keys::corner_uv)),
      beyond_(find(result, keys::corner_beyond)) {
  for (const FaceHandle face : mesh_.faces()) {
    const int patch = mesh_.property(patch_of_, face);
    if (patch >= 0 && static_cast<std::size_t>(patch) < model.patches.size()) continue;
    throw Error(
        ErrorCode::InvalidInput,
        fmt::format("face {} lies on patch {}, which the model does not have", face.idx(), patch));
  }
  if (beyond_.is_valid()) find_vertices_on_no_patch();
}

void ResultPlaces::find_vertices_on_no_patch() {
  std::optional<PlaceFinder> finder;
  for (const VertexHandle vertex : mesh_.vertices()) {
    if (is_on_patch(vertex)) continue;
    if (!finder) finder.emplace(mesh_, model_);
    const Vec3 point = to_eigen(mesh_.point(vertex));
    SurfacePlace place;
    bool is_found = false;
    for (const HalfedgeHandle corner : mesh_.vih_range(vertex)) {
      if (is_found || mesh_.is_boundary(corner)) continue;
      for (const HalfedgeHandle from : mesh_.fh_range(mesh_.face_handle(corner))) {
        if (is_found || is_beyond(from)) continue;
        const Uv uv = mesh_.property(uv_of_, from);
        const Uv step = mesh_.property(uv_of_, corner) - uv;
        is_found = finder->try_way({patch_of(corner), uv}, step, point, place);
      }
    }
    if (!is_found) place = finder->search(vertex);
    found_.emplace(vertex.idx(), PatchPoint{place.patch, place.uv});
  }
}

CageShares ResultPlaces::of_vertex(VertexHandle vertex) const {
  const std::vector<PatchPoint> places = places_of(vertex);
  if (places.empty()) return {};
  return shares_at(places[0].patch, place_at(places[0].patch, places[0].uv));
}

CageShares ResultPlaces::of_corner(HalfedgeHandle corner) const {
  const auto [at, inward] = start_at(corner);
  CagePlace place = place_at(at.patch, at.uv + kInside * inward);
  // Back by as much in the same face, for so near to it its parameters are linear in those
  // of the patch.
  const CagePlace further = place_at(at.patch, at.uv + 2 * kInside * inward);
  if (further.face == place.face && further.part == place.part) {
    place.uv = place.uv - (further.uv - place.uv);
  }
  return shares_at(at.patch, place);
}

int ResultPlaces::patch_of(HalfedgeHandle corner) const {
  return mesh_.property(patch_of_, mesh_.face_handle(corner));
}

Uv ResultPlaces::middle_of(FaceHandle face) const {
  Uv sum{0, 0};
  int count = 0;
  for (const HalfedgeHandle corner : mesh_.fh_range(face)) {
    sum = sum + mesh_.property(uv_of_, corner);
    ++count;
  }
  return 1.0 / count * sum;
}

bool ResultPlaces::is_beyond(HalfedgeHandle corner) const {
  return beyond_.is_valid() && mesh_.property(beyond_, corner) != 0;
}

/// True if a corner of the vertex lies on the patch of its face. A vertex without faces needs none.
bool ResultPlaces::is_on_patch(VertexHandle vertex) const {
  bool has_faces = false;
  for (const HalfedgeHandle corner : mesh_.vih_range(vertex)) {
    if (mesh_.is_boundary(corner)) continue;
    has_faces = true;
    if (!is_beyond(corner)) return true;
  }
  return !has_faces;
}

/// The places of a vertex on the patches of its faces that it lies on.
std::vector<ResultPlaces::PatchPoint> ResultPlaces::places_of(VertexHandle vertex) const {
  std::vector<PatchPoint> places;
  if (const auto found = found_.find(vertex.idx()); found != found_.end()) {
    places.push_back(found->second);
    return places;
  }
  for (const HalfedgeHandle corner : mesh_.vih_range(vertex)) {
    if (mesh_.is_boundary(corner) || is_beyond(corner)) continue;
    const PatchPoint place{patch_of(corner), mesh_.property(uv_of_, corner)};
    if (std::find(places.begin(), places.end(), place) == places.end()) places.push_back(place);
  }
  return places;
}

/// Where a face lies across a contour at its corner, its middle may be on another patch than its
/// own: on that into which the way there leads in space.
ResultPlaces::Start ResultPlaces::start_at(HalfedgeHandle corner) const {
  const FaceHandle face = mesh_.face_handle(corner);
  if (!is_beyond(corner)) {
    const Uv uv = mesh_.property(uv_of_, corner);
    const Start own{{patch_of(corner), uv}, middle_of(face) - uv};
    if (stays_inside(own)) return own;
  }
  const Vec3 middle = detail::middle_of(mesh_, detail::corners_of(mesh_, face));
  const std::vector<PatchPoint> places = places_of(mesh_.to_vertex_handle(corner));
  for (const PatchPoint& place : places) {
    const Start start{place, step_to(place, middle)};
    if (stays_inside(start)) return start;
  }
  return {places.front(), {0, 0}};
}

/// The step in the tangent plane that leads nearest to a point; none where there is no such plane.
Uv ResultPlaces::step_to(const PatchPoint& from, const Vec3& point) const {
  const Jet jet = model_.surface(from.patch).evaluate(from.uv, Order::First);
  const Vec3 way = point - jet.point;
  const double a = jet.du.squaredNorm(), b = jet.du.dot(jet.dv), c = jet.dv.squaredNorm();
  const double determinant = a * c - b * b;
  if (!(determinant > 0)) return {0, 0};
  const double s = jet.du.dot(way), t = jet.dv.dot(way);
  return {(c * s - b * t) / determinant, (a * t - b * s) / determinant};
}

bool ResultPlaces::stays_inside(const Start& start) const {
  return contains(model_.surface(start.place.patch).domain(),
                  start.place.uv + 2 * kInside * start.inward);
}

CagePlace ResultPlaces::place_at(int patch, Uv uv) const {
  const Surface& surface = model_.surface(patch);
  return cage_place(surface, brought_in(surface.domain(), uv));
}

CageShares ResultPlaces::shares_at(int patch, const CagePlace& place) const {
  const Cage* cage = model_.patch(patch).cage.get();
  if (cage == nullptr || place.face < 0) return {};
  CagePlace inside = place;
  inside.uv = brought_in(domain_of(place), place.uv);
  return {cage, place.face, face_weights(*cage, inside)};
}

}  // namespace surfmesh
