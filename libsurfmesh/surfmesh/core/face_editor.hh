// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <vector>

#include "surfmesh/core/topology.hh"

namespace surfmesh {

/// Faces to be made in a mesh, each as its vertices counter-clockwise. Memory is kept when it is
/// cleared.
class FaceCycles {
 public:
  void clear() {
    vertices_.clear();
    ends_.clear();
  }

  void add(std::span<const VertexHandle> cycle) {
    vertices_.insert(vertices_.end(), cycle.begin(), cycle.end());
    ends_.push_back(vertices_.size());
  }

  void add(std::initializer_list<VertexHandle> cycle) {
    add(std::span<const VertexHandle>(cycle.begin(), cycle.size()));
  }

  std::size_t size() const { return ends_.size(); }

  std::span<const VertexHandle> operator[](std::size_t face) const {
    const std::size_t begin = face == 0 ? 0 : ends_[face - 1];
    return std::span(vertices_).subspan(begin, ends_[face] - begin);
  }

  /// The vertices of all faces, one face after the other.
  std::span<const VertexHandle> vertices() const { return vertices_; }

 private:
  std::vector<VertexHandle> vertices_;
  std::vector<std::size_t> ends_;
};

/// Changes a mesh of polygons in place: a few faces are replaced by others between the same sides.
/// All operations on quads are such replacements. The last one can be undone.
///
/// Until compact(), elements that are not in use lie among the others: edges of no face, faces and
/// vertices without a halfedge. The numbers of the others do not change before that.
class FaceEditor {
 public:
  /// All elements of the mesh are in use.
  explicit FaceEditor(PolyMesh& mesh)
      : mesh_(mesh),
        vertices_{mesh.n_vertices(), {}},
        edges_{mesh.n_edges(), {}},
        faces_{mesh.n_faces(), {}} {}

  FaceEditor(const FaceEditor&) = delete;
  FaceEditor& operator=(const FaceEditor&) = delete;

  /// A vertex that no face has yet. Its properties are unspecified.
  VertexHandle add_vertex();

  /// Let the number of a vertex that no face has be given to another one.
  /// Pre      the vertex is isolated, and was not freed before
  void free_vertex(VertexHandle vh) { vertices_.free.push_back(vh); }

  /// Replace faces by others.
  ///
  /// Sides between an old face and another one, or the open boundary, stay with their properties.
  /// Vertices that only old faces had are isolated afterwards, but not free.
  ///
  /// `made` receives the new faces in order.
  /// Cost     O(sides²), for a handful of faces; no allocation once memory is there
  /// Pre      the sides of the new faces match the sides that stay and each other, two by two;
  ///          `old` lists no face twice
  void replace(std::span<const FaceHandle> old, const FaceCycles& fresh,
               std::vector<FaceHandle>& made);

  /// Undo the last replacement: connectivity and all numbers of edges and faces are as before.
  /// Pre      no other call has been made since but add_vertex() and free_vertex()
  void undo_replacement();

  bool is_used(FaceHandle fh) const { return mesh_.halfedge_handle(fh).is_valid(); }
  bool is_used(VertexHandle vh) const { return mesh_.halfedge_handle(vh).is_valid(); }

  /// All vertices and faces in use have numbers below these.
  std::size_t vertex_bound() const { return vertices_.count; }
  std::size_t face_bound() const { return faces_.count; }

  /// Give the numbers of elements not in use to the last ones, and cut off the rest. Calls
  /// `moved(from, to)` with the handles of each vertex, edge and face that gets another number.
  template <class Moved>
  void compact(Moved moved);

 private:
  /// How many elements of a kind there are, and which of them are not in use.
  template <class Handle>
  struct Supply {
    std::size_t count = 0;
    std::vector<Handle> free;

    Handle next() {
      if (free.empty()) return Handle(static_cast<int>(count++));
      const Handle handle = free.back();
      free.pop_back();
      return handle;
    }
  };

  /// Elements of a kind that the last replacement has freed and taken, in order.
  template <class Handle>
  struct Traffic {
    std::size_t count_before = 0;
    std::size_t freed = 0;
    std::vector<Handle> taken;

    void begin(const Supply<Handle>& supply) {
      count_before = supply.count;
      freed = 0;
      taken.clear();
    }
    void free(Supply<Handle>& supply, Handle handle) {
      supply.free.push_back(handle);
      ++freed;
    }
    Handle take(Supply<Handle>& supply) {
      taken.push_back(supply.next());
      return taken.back();
    }
    void undo(Supply<Handle>& supply);
  };

  /// A halfedge of an old face.
  struct OldSide {
    HalfedgeHandle heh, next;
    VertexHandle from, to;
    FaceHandle face;
  };

  void make_room(std::size_t vertices, std::size_t edges, std::size_t faces);
  void remember(std::span<const FaceHandle> old);
  void take_apart(std::span<const FaceHandle> old);
  void take_side(HalfedgeHandle heh);
  HalfedgeHandle side_between(VertexHandle from, VertexHandle to);
  void make(FaceHandle fh, std::span<const VertexHandle> cycle);

  template <class Handle, class Moved>
  void compact(Supply<Handle>& supply, Moved& moved);

  PolyMesh& mesh_;
  Supply<VertexHandle> vertices_;
  Supply<EdgeHandle> edges_;
  Supply<FaceHandle> faces_;
  std::vector<HalfedgeHandle> open_;   ///< halfedges without a face within the region
  std::vector<HalfedgeHandle> sides_;  ///< of the face that is made
  // Of the last replacement:
  std::vector<OldSide> old_sides_;
  std::vector<HalfedgeHandle> old_outgoing_;  ///< of the origin of each old side
  std::vector<FaceHandle> old_faces_;
  std::vector<VertexHandle> attached_;  ///< vertices that got an outgoing halfedge
  Traffic<EdgeHandle> edge_traffic_;
  Traffic<FaceHandle> face_traffic_;
};

template <class Handle, class Moved>
void FaceEditor::compact(Supply<Handle>& supply, Moved& moved) {
  // The largest first: then the last element is never one that is not in use.
  std::sort(supply.free.rbegin(), supply.free.rend());
  for (const Handle hole : supply.free) {
    const Handle last(static_cast<int>(--supply.count));
    if (last == hole) continue;
    detail::renumber_element(mesh_, last, hole);
    moved(last, hole);
  }
  supply.free.clear();
}

template <class Moved>
void FaceEditor::compact(Moved moved) {
  compact(vertices_, moved);
  compact(edges_, moved);
  compact(faces_, moved);
  mesh_.resize(vertices_.count, edges_.count, faces_.count);
}

}  // namespace surfmesh
