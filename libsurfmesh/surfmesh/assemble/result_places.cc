// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/result_places.hh"

#include <fmt/format.h>

#include <algorithm>

#include "surfmesh/cage/face_weights.hh"
#include "surfmesh/core/error.hh"

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

/// The domain of a face or of a quarter of one.
Domain domain_of(const CagePlace& place) {
  Domain domain;
  if (place.part < 0 && place.corners == 3) domain.shape = Domain::Shape::Triangle;
  return domain;
}

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
  if (!beyond_.is_valid()) return;
  walk_ = std::make_unique<SurfaceWalk>(model, smooth_contours(model, {}));
}

CageShares ResultPlaces::of_vertex(VertexHandle vertex) const {
  HalfedgeHandle corner;
  for (const HalfedgeHandle around : mesh_.vih_range(vertex)) {
    if (mesh_.is_boundary(around)) continue;
    corner = around;
    if (!is_beyond(corner)) break;
  }
  if (!corner.is_valid()) return {};
  const SurfacePlace place = start_at(corner).place;
  return shares_at(place.patch, place_at(place));
}

CageShares ResultPlaces::of_corner(HalfedgeHandle corner) const {
  const Start start = start_at(corner);
  const SurfacePlace beside = moved(start.place, kInside * start.inward);
  CagePlace place = place_at(beside);
  // Back by as much in the same face, for its parameters are linear in those of the patch.
  const CagePlace further = place_at(moved(start.place, 2 * kInside * start.inward));
  if (further.face == place.face && further.part == place.part) {
    place.uv = place.uv - (further.uv - place.uv);
  }
  return shares_at(beside.patch, place);
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

/// A corner of the same face that lies on its patch; invalid if there is none.
HalfedgeHandle ResultPlaces::corner_on_patch(HalfedgeHandle of_face) const {
  for (const HalfedgeHandle corner : mesh_.fh_range(mesh_.face_handle(of_face))) {
    if (!is_beyond(corner)) return corner;
  }
  return HalfedgeHandle();
}

/// The place of a vertex on a patch, by a corner that lies there; on any patch for -1.
std::optional<SurfacePlace> ResultPlaces::corner_on(VertexHandle vertex, int patch) const {
  for (const HalfedgeHandle corner : mesh_.vih_range(vertex)) {
    if (mesh_.is_boundary(corner) || is_beyond(corner)) continue;
    if (patch < 0 || patch_of(corner) == patch) {
      return SurfacePlace{patch_of(corner), mesh_.property(uv_of_, corner)};
    }
  }
  return std::nullopt;
}

/// A corner that lies beyond the patch of its face is sought from one that lies on it. There, other
/// faces mostly know its parameters, more exactly than those on the way.
ResultPlaces::Start ResultPlaces::start_at(HalfedgeHandle corner) const {
  const Uv uv = mesh_.property(uv_of_, corner);
  const Uv inward = middle_of(mesh_.face_handle(corner)) - uv;
  const SurfacePlace own{patch_of(corner), uv};
  if (!is_beyond(corner)) return {own, inward};
  const VertexHandle vertex = mesh_.to_vertex_handle(corner);
  std::optional<WalkEnd> end;
  if (const HalfedgeHandle anchor = corner_on_patch(corner); anchor.is_valid()) {
    const Uv from = mesh_.property(uv_of_, anchor);
    end = walk_->go({own.patch, from}, uv - from);
  }
  if (end) {
    const auto known = corner_on(vertex, end->place.patch);
    return {known ? *known : end->place, end->turn(inward)};
  }
  return {corner_on(vertex, -1).value_or(own), Uv{0, 0}};
}

SurfacePlace ResultPlaces::moved(const SurfacePlace& from, Uv step) const {
  const SurfacePlace to{from.patch, from.uv + step};
  if (contains(model_.surface(from.patch).domain(), to.uv)) return to;
  if (walk_) {
    if (const auto end = walk_->go(from, step)) return end->place;
  }
  return to;
}

CagePlace ResultPlaces::place_at(const SurfacePlace& place) const {
  const Surface& surface = model_.surface(place.patch);
  return cage_place(surface, brought_in(surface.domain(), place.uv));
}

CageShares ResultPlaces::shares_at(int patch, const CagePlace& place) const {
  const Cage* cage = model_.patch(patch).cage.get();
  if (cage == nullptr || place.face < 0) return {};
  CagePlace inside = place;
  inside.uv = brought_in(domain_of(place), place.uv);
  return {cage, place.face, face_weights(*cage, inside)};
}

}  // namespace surfmesh
