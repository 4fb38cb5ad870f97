// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/face_editor.hh"

#include <cassert>

namespace surfmesh {
namespace {

/// Elements of each kind for which room is made at once, at least.
constexpr std::size_t kGrowth = 256;

}  // namespace

/// std::vector's memory grows geometrically, so that this is O(1) amortised.
void FaceEditor::make_room(std::size_t vertices, std::size_t edges, std::size_t faces) {
  const std::size_t most_vertices = vertices_.count + vertices;
  const std::size_t most_edges = edges_.count + edges;
  const std::size_t most_faces = faces_.count + faces;
  if (most_vertices <= mesh_.n_vertices() && most_edges <= mesh_.n_edges() &&
      most_faces <= mesh_.n_faces()) {
    return;
  }
  mesh_.resize(std::max(mesh_.n_vertices(), most_vertices + kGrowth),
               std::max(mesh_.n_edges(), most_edges + kGrowth),
               std::max(mesh_.n_faces(), most_faces + kGrowth));
}

VertexHandle FaceEditor::add_vertex() {
  make_room(1, 0, 0);
  const VertexHandle vh = vertices_.next();
  mesh_.set_isolated(vh);
  return vh;
}

/// Free the edge of a side whose other side has been taken, too; keep it open otherwise.
void FaceEditor::take_side(HalfedgeHandle heh) {
  const HalfedgeHandle opposite = mesh_.opposite_halfedge_handle(heh);
  const auto found = std::find(open_.begin(), open_.end(), opposite);
  if (found == open_.end()) {
    open_.push_back(heh);
    return;
  }
  *found = open_.back();
  open_.pop_back();
  edge_traffic_.free(edges_, mesh_.edge_handle(heh));
}

/// Keep what undo_replacement() needs.
void FaceEditor::remember(std::span<const FaceHandle> old) {
  old_faces_.assign(old.begin(), old.end());
  old_sides_.clear();
  old_outgoing_.clear();
  attached_.clear();
  edge_traffic_.begin(edges_);
  face_traffic_.begin(faces_);
  for (const FaceHandle fh : old) {
    const HalfedgeHandle start = mesh_.halfedge_handle(fh);
    HalfedgeHandle heh = start;
    do {
      const HalfedgeHandle next = mesh_.next_halfedge_handle(heh);
      const VertexHandle from = mesh_.from_vertex_handle(heh);
      old_sides_.push_back({heh, next, from, mesh_.to_vertex_handle(heh), fh});
      old_outgoing_.push_back(mesh_.halfedge_handle(from));
      heh = next;
    } while (heh != start);
  }
}

/// Collect the open sides of the region, and isolate its vertices but those at the boundary of the
/// mesh.
void FaceEditor::take_apart(std::span<const FaceHandle> old) {
  open_.clear();
  for (std::size_t i = 0; i < old_sides_.size(); ++i) {
    take_side(old_sides_[i].heh);
    if (!mesh_.is_boundary(old_outgoing_[i])) mesh_.set_isolated(old_sides_[i].from);
  }
  for (const FaceHandle fh : old) {
    mesh_.set_halfedge_handle(fh, HalfedgeHandle());
    face_traffic_.free(faces_, fh);
  }
}

/// The open side from one vertex to the other, which is not open afterwards; a new edge if there is
/// none, whose other side is open then.
HalfedgeHandle FaceEditor::side_between(VertexHandle from, VertexHandle to) {
  for (HalfedgeHandle& heh : open_) {
    if (mesh_.to_vertex_handle(heh) != to || mesh_.from_vertex_handle(heh) != from) continue;
    const HalfedgeHandle found = heh;
    heh = open_.back();
    open_.pop_back();
    return found;
  }
  const HalfedgeHandle heh = mesh_.halfedge_handle(edge_traffic_.take(edges_), 0);
  const HalfedgeHandle opposite = mesh_.opposite_halfedge_handle(heh);
  mesh_.set_vertex_handle(heh, to);
  mesh_.set_vertex_handle(opposite, from);
  open_.push_back(opposite);
  return heh;
}

void FaceEditor::make(FaceHandle fh, std::span<const VertexHandle> cycle) {
  sides_.clear();
  for (std::size_t k = 0; k < cycle.size(); ++k) {
    sides_.push_back(side_between(cycle[k], cycle[k + 1 == cycle.size() ? 0 : k + 1]));
  }
  for (std::size_t k = 0; k < cycle.size(); ++k) {
    mesh_.set_next_halfedge_handle(sides_[k], sides_[k + 1 == cycle.size() ? 0 : k + 1]);
    mesh_.set_face_handle(sides_[k], fh);
    if (is_used(cycle[k])) continue;
    mesh_.set_halfedge_handle(cycle[k], sides_[k]);
    attached_.push_back(cycle[k]);
  }
  mesh_.set_halfedge_handle(fh, sides_.front());
}

void FaceEditor::replace(std::span<const FaceHandle> old, const FaceCycles& fresh,
                         std::vector<FaceHandle>& made) {
  make_room(0, fresh.vertices().size(), fresh.size());
  remember(old);
  take_apart(old);
  made.clear();
  for (std::size_t f = 0; f < fresh.size(); ++f) {
    made.push_back(face_traffic_.take(faces_));
    make(made.back(), fresh[f]);
  }
  assert(open_.empty());
}

/// Both lists grow and shrink at their ends, so that steps back leave them as they were.
template <class Handle>
void FaceEditor::Traffic<Handle>::undo(Supply<Handle>& supply) {
  for (; !taken.empty(); taken.pop_back()) {
    if (index(taken.back()) >= count_before) {
      --supply.count;
    } else {
      supply.free.push_back(taken.back());
    }
  }
  supply.free.resize(supply.free.size() - freed);
  freed = 0;
}

void FaceEditor::undo_replacement() {
  for (const FaceHandle fh : face_traffic_.taken) mesh_.set_halfedge_handle(fh, HalfedgeHandle());
  edge_traffic_.undo(edges_);
  face_traffic_.undo(faces_);
  // Backwards, so that the first side of a face is its halfedge again.
  for (auto side = old_sides_.rbegin(); side != old_sides_.rend(); ++side) {
    mesh_.set_vertex_handle(side->heh, side->to);
    mesh_.set_vertex_handle(mesh_.opposite_halfedge_handle(side->heh), side->from);
    mesh_.set_next_halfedge_handle(side->heh, side->next);
    mesh_.set_face_handle(side->heh, side->face);
    mesh_.set_halfedge_handle(side->face, side->heh);
  }
  for (const VertexHandle vh : attached_) mesh_.set_isolated(vh);
  for (std::size_t i = 0; i < old_sides_.size(); ++i) {
    mesh_.set_halfedge_handle(old_sides_[i].from, old_outgoing_[i]);
  }
}

}  // namespace surfmesh
