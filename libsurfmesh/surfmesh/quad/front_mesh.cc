// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quad/front_mesh.hh"

#include <algorithm>
#include <cmath>

#include "surfmesh/geometry/predicates.hh"
#include "surfmesh/metric/triangle.hh"

namespace surfmesh {
namespace {

/// A move that would invert a face is halved so often.
constexpr int kHalvings = 3;

/// A swap has to raise the lower quality of both triangles by this.
constexpr double kLeastGain = 0.01;

/// A corner of a lower scaled Jacobian is as good as straight.
constexpr double kStraight = 0.1;

/// Swaps that recover an edge, and triangles within a quad: far more than near vertices need.
constexpr std::size_t kMostSwaps = 40, kMostWithin = 40;

}  // namespace

// --- geometry ---

double FrontMesh::least_jacobian(const QuadCycle& cycle) const {
  double least = 1;
  for (std::size_t k = 0; k < 4; ++k) {
    const Metric& m = metric(cycle[k]);
    const Uv at = uv(cycle[k]);
    const Uv e1 = uv(cycle[(k + 1) % 4]) - at, e2 = uv(cycle[(k + 3) % 4]) - at;
    const double product = squared_length(m, e1) * squared_length(m, e2);
    least = std::min(least,
                     product > 0 ? surfmesh::density(m) * cross(e1, e2) / std::sqrt(product) : -1);
  }
  return least;
}

/// True if the face of a halfedge is strictly convex at the halfedge's tip.
bool FrontMesh::is_convex_at(HalfedgeHandle heh) const {
  return orient2d(uv(mesh_.from_vertex_handle(heh)), uv(mesh_.to_vertex_handle(heh)),
                  uv(mesh_.to_vertex_handle(mesh_.next_halfedge_handle(heh)))) > 0;
}

bool FrontMesh::is_valid(FaceHandle fh) const {
  for (const HalfedgeHandle heh : mesh_.fh_range(fh)) {
    if (!is_convex_at(heh)) return false;
  }
  return true;
}

int FrontMesh::count_invalid(VertexHandle vh) const {
  int count = 0;
  for (const FaceHandle fh : mesh_.vf_range(vh)) count += is_valid(fh) ? 0 : 1;
  return count;
}

bool FrontMesh::collect(VertexHandle vh, std::vector<CornerTerms>& star) const {
  if (!PatchGeometry::collect(vh, star)) return false;
  // Each face has three corners in the star, in the order of the faces around the vertex.
  constexpr std::size_t kCornersOfFace = 3;
  const HalfedgeHandle start = mesh_.halfedge_handle(vh);
  HalfedgeHandle heh = start;
  std::size_t read = 0, kept = 0;
  do {
    const bool is_quad = !is_triangle(mesh_.face_handle(heh));
    for (std::size_t k = 0; k < kCornersOfFace; ++k, ++read) {
      if (is_quad) star[kept++] = star[read];
    }
    heh = mesh_.opposite_halfedge_handle(mesh_.prev_halfedge_handle(heh));
  } while (heh != start);
  star.resize(kept);
  return kept > 0;
}

bool FrontMesh::move(VertexHandle vh, ChartStep step) {
  const Place before{uv(vh), metric(vh)};
  const int invalid = count_invalid(vh);
  if (!PatchGeometry::move(vh, step)) return false;
  if (count_invalid(vh) <= invalid) return true;
  set(vh, before);
  return false;
}

bool FrontMesh::move_towards(VertexHandle vh, Uv target) {
  if (!is_free(vh)) return false;
  const Uv before = uv(vh);
  double share = 1;
  for (int halving = 0; halving <= kHalvings; ++halving, share *= 0.5) {
    const Uv place = lerp(before, target, share);
    mesh_.property(uv_, vh) = place;
    if (count_invalid(vh) > 0) continue;
    set(vh, {place, metric_at(place)});
    return true;
  }
  mesh_.property(uv_, vh) = before;
  return false;
}

// --- fronts ---

bool FrontMesh::is_triangle(FaceHandle fh) const {
  if (!fh.is_valid() || !editor_.is_used(fh)) return false;
  const HalfedgeHandle heh = mesh_.halfedge_handle(fh);
  return mesh_.next_halfedge_handle(mesh_.next_halfedge_handle(mesh_.next_halfedge_handle(heh))) ==
         heh;
}

bool FrontMesh::is_front(HalfedgeHandle heh) const {
  const FaceHandle fh = mesh_.face_handle(heh);
  if (!is_triangle(fh)) return false;
  // A halfedge that is not in use may name a face that has been made anew.
  const HalfedgeHandle first = mesh_.halfedge_handle(fh);
  const HalfedgeHandle second = mesh_.next_halfedge_handle(first);
  if (heh != first && heh != second && heh != mesh_.next_halfedge_handle(second)) return false;
  return !is_triangle(mesh_.face_handle(mesh_.opposite_halfedge_handle(heh)));
}

HalfedgeHandle FrontMesh::next_front(HalfedgeHandle heh) const {
  heh = mesh_.next_halfedge_handle(heh);
  while (!is_front(heh)) heh = mesh_.next_halfedge_handle(mesh_.opposite_halfedge_handle(heh));
  return heh;
}

HalfedgeHandle FrontMesh::previous_front(HalfedgeHandle heh) const {
  heh = mesh_.prev_halfedge_handle(heh);
  while (!is_front(heh)) heh = mesh_.prev_halfedge_handle(mesh_.opposite_halfedge_handle(heh));
  return heh;
}

bool FrontMesh::is_untouched(VertexHandle vh) const {
  if (!is_free(vh)) return false;
  for (const FaceHandle fh : mesh_.vf_range(vh)) {
    if (!is_triangle(fh)) return false;
  }
  return true;
}

HalfedgeHandle FrontMesh::find_halfedge(VertexHandle from, VertexHandle to) const {
  for (const HalfedgeHandle heh : mesh_.voh_range(from)) {
    if (mesh_.to_vertex_handle(heh) == to) return heh;
  }
  return HalfedgeHandle();
}

// --- changes of triangles ---

bool FrontMesh::can_flip(EdgeHandle eh) const {
  const HalfedgeHandle a = mesh_.halfedge_handle(eh, 0), b = mesh_.halfedge_handle(eh, 1);
  if (!is_triangle(mesh_.face_handle(a)) || !is_triangle(mesh_.face_handle(b))) return false;
  const Uv from = uv(mesh_.from_vertex_handle(a)), to = uv(mesh_.to_vertex_handle(a));
  const Uv left = uv(mesh_.to_vertex_handle(mesh_.next_halfedge_handle(a)));
  const Uv right = uv(mesh_.to_vertex_handle(mesh_.next_halfedge_handle(b)));
  return orient2d(right, to, left) > 0 && orient2d(left, from, right) > 0;
}

/// The side opposite to a vertex, of one of its triangles, that is crossed on the way to a point;
/// invalid if a vertex lies on the way or no triangle.
HalfedgeHandle FrontMesh::crossed_from(VertexHandle from, Uv to) const {
  for (const HalfedgeHandle heh : mesh_.voh_range(from)) {
    if (!is_triangle(mesh_.face_handle(heh))) continue;
    const HalfedgeHandle side = mesh_.next_halfedge_handle(heh);
    if (orient2d(uv(from), uv(mesh_.from_vertex_handle(side)), to) > 0 &&
        orient2d(uv(from), to, uv(mesh_.to_vertex_handle(side))) > 0) {
      return side;
    }
  }
  return HalfedgeHandle();
}

/// Collect the edges between two vertices. False if one of them is a front, or a vertex lies there.
bool FrontMesh::collect_crossed(VertexHandle from, VertexHandle to) {
  crossed_.clear();
  const Uv p = uv(from), q = uv(to);
  HalfedgeHandle heh = crossed_from(from, q);
  if (!heh.is_valid()) return false;
  while (crossed_.size() < kMostSwaps) {
    const HalfedgeHandle beyond = mesh_.opposite_halfedge_handle(heh);
    if (!is_triangle(mesh_.face_handle(beyond))) return false;
    crossed_.push_back(mesh_.edge_handle(heh));
    const HalfedgeHandle after = mesh_.next_halfedge_handle(beyond);
    const VertexHandle apex = mesh_.to_vertex_handle(after);
    if (apex == to) return true;
    const int side = orient2d(p, q, uv(apex));
    if (side == 0) return false;
    heh = side > 0 ? after : mesh_.next_halfedge_handle(after);
  }
  return false;
}

bool FrontMesh::connect(VertexHandle from, VertexHandle to) {
  if (find_halfedge(from, to).is_valid()) return true;
  if (!collect_crossed(from, to)) return false;
  const Uv p = uv(from), q = uv(to);
  for (std::size_t i = 0; i < crossed_.size(); ++i) {
    if (i >= kMostSwaps) return false;
    const EdgeHandle eh = crossed_[i];
    if (!can_flip(eh)) {
      crossed_.push_back(eh);
      continue;
    }
    flip(eh);
    const HalfedgeHandle heh = mesh_.halfedge_handle(eh, 0);
    const VertexHandle a = mesh_.from_vertex_handle(heh), b = mesh_.to_vertex_handle(heh);
    if (a == from || b == from || a == to || b == to) continue;
    if (orient2d(p, q, uv(a)) != orient2d(p, q, uv(b))) crossed_.push_back(eh);
  }
  return find_halfedge(from, to).is_valid();
}

VertexHandle FrontMesh::split(HalfedgeHandle heh, double share) {
  const HalfedgeHandle beyond = mesh_.opposite_halfedge_handle(heh);
  const VertexHandle a = mesh_.from_vertex_handle(heh), b = mesh_.to_vertex_handle(heh);
  const VertexHandle left = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(heh));
  const VertexHandle right = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(beyond));
  const VertexHandle middle = editor_.add_vertex();
  const Uv place = lerp(uv(a), uv(b), share);
  set(middle, {place, metric_at(place)});
  fresh_.clear();
  fresh_.add({a, middle, left});
  fresh_.add({middle, b, left});
  fresh_.add({b, middle, right});
  fresh_.add({middle, a, right});
  editor_.replace({{mesh_.face_handle(heh), mesh_.face_handle(beyond)}}, fresh_, made_);
  return middle;
}

bool FrontMesh::absorb(VertexHandle vh, VertexHandle into) {
  faces_.clear();
  fresh_.clear();
  for (const HalfedgeHandle heh : mesh_.voh_range(vh)) {
    faces_.push_back(mesh_.face_handle(heh));
    const VertexHandle a = mesh_.to_vertex_handle(heh);
    const VertexHandle b = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(heh));
    if (a == into || b == into) continue;
    if (orient2d(uv(into), uv(a), uv(b)) <= 0) return false;
    fresh_.add({into, a, b});
  }
  editor_.replace(faces_, fresh_, made_);
  editor_.free_vertex(vh);
  return true;
}

double FrontMesh::quality(VertexHandle a, VertexHandle b, VertexHandle c) const {
  return triangle_quality({uv(a), metric(a)}, {uv(b), metric(b)}, {uv(c), metric(c)});
}

bool FrontMesh::is_worth_swapping(EdgeHandle eh) const {
  if (!can_flip(eh)) return false;
  const HalfedgeHandle heh = mesh_.halfedge_handle(eh, 0);
  const HalfedgeHandle beyond = mesh_.halfedge_handle(eh, 1);
  const VertexHandle a = mesh_.from_vertex_handle(heh), b = mesh_.to_vertex_handle(heh);
  const VertexHandle left = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(heh));
  const VertexHandle right = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(beyond));
  const double before = std::min(quality(a, b, left), quality(b, a, right));
  return std::min(quality(a, right, left), quality(b, left, right)) > before + kLeastGain;
}

void FrontMesh::swap_around(VertexHandle vh) {
  edges_.clear();
  for (const HalfedgeHandle heh : mesh_.voh_range(vh)) {
    if (!is_triangle(mesh_.face_handle(heh))) continue;
    edges_.push_back(mesh_.edge_handle(heh));
    edges_.push_back(mesh_.edge_handle(mesh_.next_halfedge_handle(heh)));
  }
  for (const EdgeHandle eh : edges_) {
    if (is_worth_swapping(eh)) flip(eh);
  }
}

// --- quads ---

/// Collect the triangles within the sides. False if there is a front among them.
bool FrontMesh::collect_within(HalfedgeHandle base, const std::array<HalfedgeHandle, 4>& sides) {
  faces_.assign(1, mesh_.face_handle(base));
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    for (const HalfedgeHandle heh : mesh_.fh_range(faces_[i])) {
      if (std::find(sides.begin(), sides.end(), heh) != sides.end()) continue;
      const FaceHandle beyond = mesh_.face_handle(mesh_.opposite_halfedge_handle(heh));
      if (!is_triangle(beyond) || faces_.size() > kMostWithin) return false;
      if (std::find(faces_.begin(), faces_.end(), beyond) == faces_.end()) {
        faces_.push_back(beyond);
      }
    }
  }
  return true;
}

void FrontMesh::collect_enclosed(const QuadCycle& cycle) {
  enclosed_.clear();
  for (const FaceHandle fh : faces_) {
    for (const VertexHandle vh : mesh_.fv_range(fh)) {
      if (std::find(cycle.begin(), cycle.end(), vh) == cycle.end() &&
          std::find(enclosed_.begin(), enclosed_.end(), vh) == enclosed_.end()) {
        enclosed_.push_back(vh);
      }
    }
  }
}

FaceHandle FrontMesh::make_quad(HalfedgeHandle base, const QuadCycle& cycle) {
  std::array<HalfedgeHandle, 4> sides;
  for (std::size_t k = 0; k < 4; ++k) {
    sides[k] = find_halfedge(cycle[k], cycle[(k + 1) % 4]);
    if (!sides[k].is_valid()) return FaceHandle();
  }
  if (!collect_within(base, sides)) return FaceHandle();
  collect_enclosed(cycle);
  fresh_.clear();
  fresh_.add(cycle);
  editor_.replace(faces_, fresh_, made_);
  return made_.front();
}

/// The corner opposite to the origin of a front halfedge, of the four of two triangles that only
/// fronts surround; invalid if there is no such gap.
VertexHandle FrontMesh::opposite_in_gap(HalfedgeHandle heh) const {
  const HalfedgeHandle second = next_front(heh), third = next_front(second);
  const HalfedgeHandle fourth = next_front(third);
  const bool is_gap = third != heh && fourth != heh && next_front(fourth) == heh;
  return is_gap ? mesh_.from_vertex_handle(third) : VertexHandle();
}

VertexHandle FrontMesh::opposite_in_gap_of_two(HalfedgeHandle heh) const {
  const VertexHandle opposite = opposite_in_gap(heh);
  if (!opposite.is_valid()) return opposite;
  const auto face = [this](HalfedgeHandle side) { return mesh_.face_handle(side); };
  const HalfedgeHandle second = next_front(heh), third = next_front(second);
  const HalfedgeHandle fourth = next_front(third);
  const bool is_of_two = (face(heh) == face(second) && face(third) == face(fourth)) ||
                         (face(second) == face(third) && face(fourth) == face(heh));
  return is_of_two ? opposite : VertexHandle();
}

bool FrontMesh::leaves_straight_gap(FaceHandle quad) const {
  for (const HalfedgeHandle side : mesh_.fh_range(quad)) {
    HalfedgeHandle heh = mesh_.opposite_halfedge_handle(side);
    if (!is_front(heh) || !opposite_in_gap(heh).is_valid()) continue;
    for (int k = 0; k < 4; ++k, heh = next_front(heh)) {
      const VertexHandle vh = mesh_.from_vertex_handle(heh);
      if (is_free(vh)) continue;
      const Uv e1 = uv(mesh_.to_vertex_handle(heh)) - uv(vh);
      const Uv e2 = uv(mesh_.from_vertex_handle(previous_front(heh))) - uv(vh);
      const double product = squared_length(metric(vh), e1) * squared_length(metric(vh), e2);
      if (surfmesh::density(metric(vh)) * cross(e1, e2) < kStraight * std::sqrt(product)) {
        return true;
      }
    }
  }
  return false;
}

VertexHandle FrontMesh::close_gap(HalfedgeHandle heh) {
  const VertexHandle into = opposite_in_gap_of_two(heh);
  if (!into.is_valid()) return into;
  const FaceHandle first = mesh_.face_handle(heh), second = mesh_.face_handle(next_front(heh));
  faces_ = {first, second != first ? second : mesh_.face_handle(previous_front(heh))};
  return merge(mesh_.from_vertex_handle(heh), into);
}

VertexHandle FrontMesh::sew(HalfedgeHandle heh) {
  const HalfedgeHandle between = mesh_.next_halfedge_handle(heh);
  const FaceHandle beyond = mesh_.face_handle(mesh_.opposite_halfedge_handle(between));
  if (!is_front(mesh_.prev_halfedge_handle(heh)) || !is_triangle(beyond)) return VertexHandle();
  faces_ = {mesh_.face_handle(heh), beyond};
  VertexHandle from = mesh_.from_vertex_handle(between), into = mesh_.to_vertex_handle(between);
  if (!is_free(from)) std::swap(from, into);
  return merge(from, into);
}

bool FrontMesh::has_corner(FaceHandle fh, VertexHandle vh) const {
  for (const VertexHandle corner : mesh_.fv_range(fh)) {
    if (corner == vh) return true;
  }
  return false;
}

/// Merge a vertex into another one of the two triangles listed, which vanish.
VertexHandle FrontMesh::merge(VertexHandle from, VertexHandle into) {
  if (!is_free(from)) return VertexHandle();
  for (const VertexHandle vh : mesh_.vv_range(from)) {
    if (vh == into) continue;
    // Their common neighbours are the other corners of the triangles.
    const bool is_corner = has_corner(faces_[0], vh) || has_corner(faces_[1], vh);
    if (!is_corner && find_halfedge(vh, into).is_valid()) return VertexHandle();
  }
  fresh_.clear();
  for (const HalfedgeHandle heh : mesh_.voh_range(from)) {
    const FaceHandle fh = mesh_.face_handle(heh);
    if (std::find(faces_.begin(), faces_.begin() + 2, fh) != faces_.begin() + 2) continue;
    if (has_corner(fh, into)) return VertexHandle();
    replace_corner(heh, into);
  }
  enclosed_.assign(1, from);
  editor_.replace(faces_, fresh_, made_);
  return into;
}

FaceHandle FrontMesh::drop_corner(HalfedgeHandle heh) {
  const VertexHandle corner = mesh_.from_vertex_handle(heh);
  if (!is_free(corner) || mesh_.valence(corner) != 3) return FaceHandle();
  const HalfedgeHandle middle = mesh_.opposite_halfedge_handle(mesh_.prev_halfedge_handle(heh));
  const HalfedgeHandle after = mesh_.opposite_halfedge_handle(mesh_.prev_halfedge_handle(middle));
  if (!is_triangle(mesh_.face_handle(middle)) || is_triangle(mesh_.face_handle(after))) {
    return FaceHandle();
  }
  const VertexHandle behind = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(after));
  QuadCycle cycle = {mesh_.to_vertex_handle(heh), mesh_.to_vertex_handle(middle),
                     mesh_.to_vertex_handle(after), behind};
  if (behind == cycle[1]) return FaceHandle();
  faces_ = {mesh_.face_handle(heh), mesh_.face_handle(middle), mesh_.face_handle(after)};
  enclosed_.assign(1, corner);
  dissolve(cycle, 0);
  dissolve(cycle, 2);
  fresh_.clear();
  fresh_.add(cycle);
  editor_.replace(faces_, fresh_, made_);
  return made_.front();
}

/// Take a corner of a quad to be made away, too, if there would be only one quad more: the opposite
/// corner of that one stands in its place.
void FrontMesh::dissolve(QuadCycle& cycle, std::size_t corner) {
  const VertexHandle vh = cycle[corner];
  if (!is_free(vh)) return;
  FaceHandle other;
  for (const FaceHandle fh : mesh_.vf_range(vh)) {
    if (std::find(faces_.begin(), faces_.end(), fh) != faces_.end()) continue;
    if (other.is_valid() || is_triangle(fh)) return;
    other = fh;
  }
  if (!other.is_valid()) return;
  HalfedgeHandle heh = mesh_.halfedge_handle(other);
  while (mesh_.from_vertex_handle(heh) != vh) heh = mesh_.next_halfedge_handle(heh);
  const VertexHandle opposite = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(heh));
  if (std::find(cycle.begin(), cycle.end(), opposite) != cycle.end()) return;
  cycle[corner] = opposite;
  faces_.push_back(other);
  enclosed_.push_back(vh);
}

VertexPair FrontMesh::open_corner(HalfedgeHandle heh) {
  const VertexHandle corner = mesh_.from_vertex_handle(heh);
  const VertexHandle opposite = opposite_in_gap_of_two(heh);
  if (!opposite.is_valid() || is_free(corner) || !is_free(opposite)) return VertexPair();
  const VertexHandle left = mesh_.to_vertex_handle(heh);
  const VertexHandle right = mesh_.from_vertex_handle(previous_front(heh));
  // The quads at the opposite corner, and the spokes before them.
  std::vector<HalfedgeHandle> spokes;
  for (HalfedgeHandle spoke = find_halfedge(opposite, left); mesh_.to_vertex_handle(spoke) != right;
       spoke = mesh_.opposite_halfedge_handle(mesh_.prev_halfedge_handle(spoke))) {
    spokes.push_back(spoke);
  }
  if (spokes.size() < 2) return VertexPair();
  const std::size_t half = spokes.size() / 2;
  const VertexHandle tip = mesh_.to_vertex_handle(spokes[half]);
  if (!is_free(tip) || find_halfedge(corner, tip).is_valid()) return VertexPair();
  const FaceHandle first = mesh_.face_handle(heh), second = mesh_.face_handle(next_front(heh));
  faces_ = {first, second != first ? second : mesh_.face_handle(previous_front(heh))};
  added_ = editor_.add_vertex();
  const Uv place = lerp(uv(opposite), uv(left), 0.5);
  set(added_, {place, metric_at(place)});
  fresh_.clear();
  fresh_.add({corner, left, added_, tip});
  fresh_.add({corner, tip, opposite, right});
  for (std::size_t i = 0; i < half; ++i) replace_corner(spokes[i], added_);
  enclosed_.clear();
  editor_.replace(faces_, fresh_, made_);
  return VertexPair{added_, opposite};
}

/// Let another vertex stand in place of the origin of a halfedge in its face.
void FrontMesh::replace_corner(HalfedgeHandle heh, VertexHandle by) {
  const FaceHandle fh = mesh_.face_handle(heh);
  cycle_.assign(1, by);
  for (HalfedgeHandle side = mesh_.next_halfedge_handle(heh); side != heh;
       side = mesh_.next_halfedge_handle(side)) {
    cycle_.push_back(mesh_.from_vertex_handle(side));
  }
  fresh_.add(cycle_);
  faces_.push_back(fh);
}

void FrontMesh::undo() {
  editor_.undo_replacement();
  if (added_.is_valid()) editor_.free_vertex(added_);
  added_.invalidate();
}

void FrontMesh::keep() {
  for (const VertexHandle vh : enclosed_) editor_.free_vertex(vh);
  enclosed_.clear();
  added_.invalidate();
}

}  // namespace surfmesh
