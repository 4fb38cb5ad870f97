// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quad/quad_moves.hh"

#include <array>

#include "surfmesh/core/quad_topology.hh"

namespace surfmesh {
namespace {

/// An inner vertex has at least so many faces.
constexpr int kFewestFaces = 3;

int square(int x) { return x * x; }

/// How much excess² grows when a vertex gets `more` faces.
int growth(const QuadState& state, VertexHandle vh, int more) {
  const int excess = state.excess(vh);
  return square(excess + more) - square(excess);
}

bool can_lose_face(const QuadState& state, VertexHandle vh) {
  return state.count(vh) > (state.is_boundary(vh) ? 1 : kFewestFaces);
}

bool are_joined(const PolyMesh& mesh, VertexHandle a, VertexHandle b) {
  for (const VertexHandle vh : mesh.vv_range(a)) {
    if (vh == b) return true;
  }
  return false;
}

/// The next halfedge from the same origin, counter-clockwise.
HalfedgeHandle rotated(const PolyMesh& mesh, HalfedgeHandle heh) {
  return mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(heh));
}

/// Add faces around a vertex from a halfedge on, with another vertex in its place.
/// Returns  the halfedge after them
HalfedgeHandle take_over(const PolyMesh& mesh, HalfedgeHandle heh, int faces, VertexHandle vh,
                         Replacement& change) {
  for (int k = 0; k < faces; ++k) {
    std::array<VertexHandle, 4> cycle = quad_vertices(mesh, heh);
    cycle[0] = vh;
    change.old.push_back(mesh.face_handle(heh));
    change.fresh.add(cycle);
    heh = rotated(mesh, heh);
  }
  return heh;
}

/// True if the faces around a vertex, so many from a halfedge on, are all quads.
bool are_quads(const PolyMesh& mesh, HalfedgeHandle heh, int faces) {
  for (int k = 0; k < faces; ++k, heh = rotated(mesh, heh)) {
    if (!is_at_quad(mesh, heh)) return false;
  }
  return true;
}

/// A vertex of a change that does not exist yet, with the faces it will have.
int growth_of_new(int faces) { return square(faces - 4); }

VertexHandle add_vertex(QuadState& state, Replacement& change, std::vector<VertexHandle> between) {
  const VertexHandle vh = state.editor.add_vertex();
  change.added.push_back(vh);
  change.middles.push_back({vh, std::move(between)});
  return vh;
}

/// True if a vertex may take over the sides of another one, but for those to two neighbours of
/// both.
bool may_take_sides(const QuadState& state, VertexHandle from, VertexHandle to, VertexHandle left,
                    VertexHandle right) {
  for (const VertexHandle vh : state.mesh.vv_range(from)) {
    if (vh != left && vh != right && !state.geometry.may_join(vh, to)) return false;
  }
  return true;
}

/// Two vertices that merge may have no neighbour in common but the two corners between them.
bool have_common_neighbour(const PolyMesh& mesh, VertexHandle a, VertexHandle b, VertexHandle left,
                           VertexHandle right) {
  for (const VertexHandle vh : mesh.vv_range(a)) {
    if (vh != left && vh != right && are_joined(mesh, vh, b)) return true;
  }
  return are_joined(mesh, a, b);
}

}  // namespace

QuadState::QuadState(PolyMesh& quads, FaceEditor& quad_editor, QuadGeometry& places,
                     std::vector<int> wanted_counts)
    : mesh(quads), editor(quad_editor), geometry(places), wanted(std::move(wanted_counts)) {
  measures.resize(mesh.n_faces());
  counts.resize(mesh.n_vertices(), 0);
  for (std::size_t f = 0; f < editor.face_bound(); ++f) {
    const FaceHandle fh(static_cast<int>(f));
    if (!editor.is_used(fh)) continue;
    measures[f] = geometry.measure(fh);
    for (const VertexHandle vh : mesh.fv_range(fh)) ++counts[index(vh)];
  }
}

bool dissolve_doublet(const QuadState& state, VertexHandle vh, Replacement& change) {
  const PolyMesh& mesh = state.mesh;
  const HalfedgeHandle heh = mesh.halfedge_handle(vh);
  if (!are_quads(mesh, heh, 2)) return false;
  const HalfedgeHandle other = rotated(mesh, heh);
  const auto first = quad_vertices(mesh, heh), second = quad_vertices(mesh, other);
  if (first[2] == second[2]) return false;
  change.clear();
  change.old = {mesh.face_handle(heh), mesh.face_handle(other)};
  change.fresh.add({first[1], first[2], first[3], second[2]});
  change.removed = {vh};
  return true;
}

bool collapse_quad(const QuadState& state, HalfedgeHandle heh, int most, Replacement& change) {
  const PolyMesh& mesh = state.mesh;
  const HalfedgeHandle from_tip = mesh.next_halfedge_handle(heh);
  const auto [goes, left, stays, right] = quad_vertices(mesh, from_tip);
  const int faces = state.count(goes);
  const int irregularity = growth(state, left, -1) + growth(state, right, -1) +
                           growth(state, stays, faces - 2) - square(state.excess(goes));
  // Of two vertices that may move, either way is the same.
  if (irregularity > most || !state.geometry.is_free(goes) ||
      (state.geometry.is_free(stays) && stays < goes) || !are_quads(mesh, from_tip, faces) ||
      !can_lose_face(state, left) || !can_lose_face(state, right) ||
      have_common_neighbour(mesh, goes, stays, left, right) ||
      !may_take_sides(state, goes, stays, left, right)) {
    return false;
  }
  change.clear();
  change.old = {mesh.face_handle(from_tip)};
  take_over(mesh, rotated(mesh, from_tip), faces - 1, stays, change);
  change.removed = {goes};
  if (state.geometry.is_free(stays)) change.middles.push_back({stays, {stays, goes}});
  return true;
}

bool rotate_edge(const QuadState& state, HalfedgeHandle heh, Turn turn, int most,
                 Replacement& change) {
  const PolyMesh& mesh = state.mesh;
  const HalfedgeHandle opposite = mesh.opposite_halfedge_handle(heh);
  if (!is_at_quad(mesh, heh) || !is_at_quad(mesh, opposite)) return false;
  const auto [a, b, c, d] = quad_vertices(mesh, heh);
  const auto [b2, a2, e, f] = quad_vertices(mesh, opposite);
  const bool is_counter = turn == Turn::CounterClockwise;
  const VertexHandle near = is_counter ? c : d, far = is_counter ? e : f;
  const int irregularity =
      growth(state, a, -1) + growth(state, b, -1) + growth(state, near, 1) + growth(state, far, 1);
  if (irregularity > most || !can_lose_face(state, a) || !can_lose_face(state, b) || c == e ||
      c == f || d == e || d == f || are_joined(mesh, near, far) ||
      !state.geometry.may_join(near, far)) {
    return false;
  }
  change.clear();
  change.old = {mesh.face_handle(heh), mesh.face_handle(opposite)};
  if (is_counter) {
    change.fresh.add({c, d, a, e});
    change.fresh.add({e, f, b, c});
  } else {
    change.fresh.add({d, a, e, f});
    change.fresh.add({f, b, c, d});
  }
  return true;
}

bool open_vertex(QuadState& state, HalfedgeHandle heh, int faces, int most, Replacement& change) {
  const PolyMesh& mesh = state.mesh;
  const VertexHandle vh = mesh.from_vertex_handle(heh);
  if (!are_quads(mesh, heh, faces)) return false;
  HalfedgeHandle middle = heh, end = heh;
  for (int k = 0; k < faces; ++k) {
    end = rotated(mesh, end);
    if (k < faces / 2) middle = end;
  }
  const VertexHandle first = mesh.to_vertex_handle(heh), last = mesh.to_vertex_handle(end);
  const int irregularity = growth(state, vh, 1 - faces) + growth_of_new(faces + 1) +
                           growth(state, first, 1) + growth(state, last, 1);
  if (irregularity > most) return false;
  change.clear();
  const VertexHandle fresh = add_vertex(state, change, {vh, vh, mesh.to_vertex_handle(middle)});
  take_over(mesh, heh, faces, fresh, change);
  change.fresh.add({vh, first, fresh, last});
  return true;
}

bool insert_column(QuadState& state, HalfedgeHandle heh, int faces, Replacement& change) {
  const PolyMesh& mesh = state.mesh;
  const auto [v, x, o, y] = quad_vertices(mesh, heh);
  const int left = state.count(o) - 1 - faces;
  if (!state.geometry.is_free(o) || !are_quads(mesh, mesh.halfedge_handle(o), state.count(o))) {
    return false;
  }
  const HalfedgeHandle to_x = mesh.opposite_halfedge_handle(mesh.next_halfedge_handle(heh));
  change.clear();
  change.old = {mesh.face_handle(heh)};
  const HalfedgeHandle to_p = take_over(mesh, to_x, faces, o, change);
  const VertexHandle p = mesh.to_vertex_handle(to_p);
  if (are_joined(mesh, v, p) || !state.geometry.may_join(v, p)) return false;
  const VertexHandle fresh = add_vertex(state, change, {o, o, y});
  change.middles.push_back({o, {o, o, x}});
  take_over(mesh, to_p, left, fresh, change);
  change.fresh.add({v, x, o, p});
  change.fresh.add({v, p, fresh, y});
  return true;
}

bool insert_pillow(QuadState& state, FaceHandle fh, Replacement& change) {
  const PolyMesh& mesh = state.mesh;
  if (!is_at_quad(mesh, mesh.halfedge_handle(fh))) return false;
  const std::array<VertexHandle, 4> outer = quad_vertices(mesh, mesh.halfedge_handle(fh));
  change.clear();
  change.old = {fh};
  std::array<VertexHandle, 4> inner;
  for (std::size_t k = 0; k < 4; ++k) {
    inner[k] = add_vertex(state, change, {outer[k], outer[0], outer[1], outer[2], outer[3]});
  }
  change.fresh.add(inner);
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t next = (k + 1) % 4;
    change.fresh.add({outer[k], outer[next], inner[next], inner[k]});
  }
  return true;
}

}  // namespace surfmesh
