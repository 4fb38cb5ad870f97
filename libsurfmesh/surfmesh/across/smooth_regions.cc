// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/across/smooth_regions.hh"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <span>
#include <utility>

#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/quad_topology.hh"
#include "surfmesh/core/range_sums.hh"
#include "surfmesh/core/shared_sets.hh"
#include "surfmesh/quality/face_corners.hh"

namespace surfmesh {
namespace {

/// Rings of faces around a contour, or an edge between pieces, that may change.
constexpr int kRings = 3;

/// Cosine of the angle between two faces from which their edge stays: the surface is rounded there
/// within less than an element, as at a semi-sharp crease, and elements that do not follow the edge
/// would cut it off.
constexpr double kSharpEdge = 0.5;

/// Faces of a piece, about: enough that few lie at its border.
constexpr std::size_t kMostFaces = 8192;

/// How far from a side that is a pole, as a share of it, a corner counts as on it: the rounding of
/// parameters.
constexpr double kAtPole = 1e-9;

Vec3 normal_of(const PolyMesh& mesh, FaceHandle fh) {
  return detail::double_area_of(mesh, detail::corners_of(mesh, fh)).stableNormalized();
}

/// True if two faces make a sharp angle, or one ends there.
bool is_sharp(const PolyMesh& mesh, EdgeHandle eh) {
  if (mesh.is_boundary(eh)) return true;
  const FaceHandle a = mesh.face_handle(mesh.halfedge_handle(eh, 0));
  const FaceHandle b = mesh.face_handle(mesh.halfedge_handle(eh, 1));
  return normal_of(mesh, a).dot(normal_of(mesh, b)) < kSharpEdge;
}

/// What ranges find, one after the other.
template <class Handle>
struct Found {
  std::vector<Handle> handles;

  Found& operator+=(const Found& other) {
    handles.insert(handles.end(), other.handles.begin(), other.handles.end());
    return *this;
  }
};

/// Call `visit(handle, found)` for all elements of a kind, shared; it adds to `found` what it
/// finds.
/// Returns  all that were found, in the order of the elements
template <class Element, class Handle, class Visit>
std::vector<Handle> find_among(std::size_t count, Visit visit) {
  return sum_of_ranges(count,
                       [&](std::size_t first, std::size_t end) {
                         Found<Handle> own;
                         for (std::size_t i = first; i < end; ++i) {
                           visit(Element(static_cast<int>(i)), own.handles);
                         }
                         return own;
                       })
      .handles;
}

/// Call `visit` with all elements of a kind, shared.
template <class Element, class Visit>
void for_each_shared(std::size_t count, Visit visit) {
  share_ranges(count, [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) visit(Element(static_cast<int>(i)));
  });
}

/// Mark an element, which other threads may do at the same time.
/// Returns  true for the first one to do so
bool mark(std::vector<char>& is_marked, std::size_t i) {
  const std::atomic_ref<char> flag(is_marked[i]);
  return flag.load(std::memory_order_relaxed) == 0 &&
         flag.exchange(1, std::memory_order_relaxed) == 0;
}

/// Choose the faces around vertices, then around theirs, ring by ring. Which thread finds a vertex
/// first is a matter of chance, and so is the order of a front, but not what is in it.
void choose_rings(const PolyMesh& mesh, std::vector<VertexHandle> front,
                  std::vector<char>& is_chosen) {
  std::vector<char> is_near(mesh.n_vertices(), 0);
  for (const VertexHandle vh : front) is_near[index(vh)] = 1;
  for (int ring = 0; ring < kRings; ++ring) {
    front = find_among<std::size_t, VertexHandle>(
        front.size(), [&](std::size_t i, std::vector<VertexHandle>& next) {
          for (const HalfedgeHandle heh : mesh.voh_range(front[i])) {
            const FaceHandle fh = mesh.face_handle(heh);
            if (!fh.is_valid() || !mark(is_chosen, index(fh))) continue;
            for_each_vertex_of(mesh, fh, [&](int vertex) {
              if (mark(is_near, static_cast<std::size_t>(vertex))) next.emplace_back(vertex);
            });
          }
        });
  }
}

std::vector<VertexHandle> all_of(const VertexRange& range) {
  std::vector<VertexHandle> vertices;
  for (int v = range.first; v < range.end; ++v) vertices.emplace_back(v);
  return vertices;
}

/// The sides of patches that are poles.
class PoleSides {
 public:
  explicit PoleSides(const Model& model) : sides_(model.patches.size()) {
    for (const Contour& contour : model.contours) {
      if (!contour.is_degenerate) continue;
      for (const ContourUse& use : contour.uses) {
        sides_[static_cast<std::size_t>(use.patch)].push_back(
            {use.curve->evaluate(0), use.curve->evaluate(1)});
      }
    }
  }

  bool is_on_pole(int patch, Uv uv) const {
    const auto& sides = sides_[static_cast<std::size_t>(patch)];
    return std::any_of(sides.begin(), sides.end(), [uv](const std::pair<Uv, Uv>& side) {
      const Uv along = side.second - side.first, to = uv - side.first;
      const double squared = along.u * along.u + along.v * along.v;
      const double share = (to.u * along.u + to.v * along.v) / squared;
      return share >= -kAtPole && share <= 1 + kAtPole &&
             std::abs(cross(along, to)) <= kAtPole * squared;
    });
  }

  bool empty(int patch) const { return sides_[static_cast<std::size_t>(patch)].empty(); }
  bool empty() const {
    return std::all_of(sides_.begin(), sides_.end(), [](const auto& own) { return own.empty(); });
  }

 private:
  std::vector<std::vector<std::pair<Uv, Uv>>> sides_;  ///< by patch
};

void leave_out_poles(const PolyMesh& result, const Model& model, std::vector<char>& is_chosen) {
  const auto patch_of = require(result, keys::face_patch);
  const auto uv_of = require(result, keys::corner_uv);
  const PoleSides poles(model);
  if (poles.empty()) return;
  for_each_shared<FaceHandle>(result.n_faces(), [&](FaceHandle fh) {
    const int patch = result.property(patch_of, fh);
    if (is_chosen[index(fh)] == 0 || poles.empty(patch)) return;
    for_each_corner(result, fh, [&](HalfedgeHandle corner) {
      if (poles.is_on_pole(patch, result.property(uv_of, corner))) is_chosen[index(fh)] = 0;
    });
  });
}

void choose_patches(const PolyMesh& result, const Model& model,
                    const std::vector<char>& is_dissolved, std::vector<char>& is_chosen) {
  const auto patch_of = require(result, keys::face_patch);
  std::vector<char> is_open(model.patches.size(), 0);
  for (std::size_t c = 0; c < model.contours.size(); ++c) {
    if (is_dissolved[c] == 0) continue;
    for (const ContourUse& use : model.contours[c].uses) {
      is_open[static_cast<std::size_t>(use.patch)] = 1;
    }
  }
  for_each_shared<FaceHandle>(result.n_faces(), [&](FaceHandle fh) {
    is_chosen[index(fh)] = is_open[static_cast<std::size_t>(result.property(patch_of, fh))];
  });
}

/// Faces in parts that edges connect which are not held. The parts are in the order of their first
/// faces, and the faces of each in their own order.
///
/// `place_of` tells the place of a face among them, -1 for others.
template <class PlaceOf>
std::vector<FacePiece> connected_parts(const PolyMesh& mesh, const FacePiece& faces,
                                       const std::vector<char>& is_held, PlaceOf place_of) {
  SharedSets sets(faces.size());
  for_each_shared<int>(faces.size(), [&](int place) {
    const auto own = static_cast<std::size_t>(place);
    for_each_corner(mesh, faces[own], [&](HalfedgeHandle heh) {
      if (is_held[index(mesh.edge_handle(heh))] != 0) return;
      const FaceHandle beyond = mesh.face_handle(mesh.opposite_halfedge_handle(heh));
      const int other = beyond.is_valid() ? place_of(beyond) : -1;
      if (other > place) sets.unite(own, static_cast<std::size_t>(other));
    });
  });
  std::vector<FacePiece> parts;
  std::vector<std::size_t> part_of(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const std::size_t first = sets.find(i);
    if (first == i) {
      part_of[i] = parts.size();
      parts.emplace_back();
    }
    part_of[i] = part_of[first];
    parts[part_of[i]].push_back(faces[i]);
  }
  return parts;
}

/// The same for a few faces of a large mesh.
std::vector<FacePiece> connected_parts(const PolyMesh& mesh, const FacePiece& faces,
                                       const std::vector<char>& is_held) {
  return connected_parts(mesh, faces, is_held, [&faces](FaceHandle fh) {
    const auto found = std::lower_bound(faces.begin(), faces.end(), fh);
    return found == faces.end() || *found != fh ? -1 : static_cast<int>(found - faces.begin());
  });
}

/// The faces that are marked.
FacePiece marked_faces(const std::vector<char>& is_marked) {
  return find_among<FaceHandle, FaceHandle>(is_marked.size(), [&](FaceHandle fh, FacePiece& found) {
    if (is_marked[index(fh)] != 0) found.push_back(fh);
  });
}

/// A face and where it is.
struct PlacedFace {
  FaceHandle face;
  Vec3 middle;
};

using PlacedFaces = std::span<PlacedFace>;

/// Halve faces along the longest side of their box.
std::array<PlacedFaces, 2> halves(PlacedFaces faces) {
  Eigen::AlignedBox3d box;
  for (const PlacedFace& face : faces) box.extend(face.middle);
  Eigen::Index axis = 0;
  box.sizes().maxCoeff(&axis);
  const std::size_t half = faces.size() / 2;
  const auto middle = faces.begin() + static_cast<std::ptrdiff_t>(half);
  std::nth_element(
      faces.begin(), middle, faces.end(), [axis](const PlacedFace& a, const PlacedFace& b) {
        return a.middle[axis] != b.middle[axis] ? a.middle[axis] < b.middle[axis] : a.face < b.face;
      });
  return {faces.first(half), faces.subspan(half)};
}

/// Halve faces, and the halves, until they are few.
void halve(const PolyMesh& mesh, const FacePiece& part, std::vector<FacePiece>& pieces) {
  std::vector<PlacedFace> placed(part.size());
  for_each_shared<int>(part.size(), [&](int i) {
    const FaceHandle fh = part[static_cast<std::size_t>(i)];
    placed[static_cast<std::size_t>(i)] = {fh, to_eigen(mesh.calc_face_centroid(fh))};
  });
  std::vector<PlacedFaces> blocks = {placed};
  while (blocks.back().size() > kMostFaces) {  // none is larger
    std::vector<PlacedFaces> smaller(2 * blocks.size());
    share_indices(blocks.size(), [&](std::size_t b) {
      const auto [first, second] = halves(blocks[b]);
      smaller[2 * b] = first;
      smaller[2 * b + 1] = second;
    });
    blocks = std::move(smaller);
  }
  for (const PlacedFaces block : blocks) {
    FacePiece& piece = pieces.emplace_back();
    for (const PlacedFace& face : block) piece.push_back(face.face);
  }
}

void sort_each(std::vector<FacePiece>& pieces) {
  share_indices(pieces.size(),
                [&](std::size_t p) { std::sort(pieces[p].begin(), pieces[p].end()); });
}

}  // namespace

SmoothRegions choose_regions(const PolyMesh& result, const Model& model,
                             const std::vector<char>& is_dissolved,
                             const VertexRange& between_tiles) {
  const auto contour_of = require(result, keys::edge_contour);
  SmoothRegions regions;
  regions.is_held.assign(result.n_edges(), 0);
  regions.is_chosen.assign(result.n_faces(), 0);
  std::vector<VertexHandle> near = find_among<EdgeHandle, VertexHandle>(
      result.n_edges(), [&](EdgeHandle eh, std::vector<VertexHandle>& found) {
        const int contour = result.property(contour_of, eh);
        if (contour < 0) return;
        if (is_dissolved[static_cast<std::size_t>(contour)] == 0 || is_sharp(result, eh)) {
          regions.is_held[index(eh)] = 1;
          return;
        }
        const HalfedgeHandle heh = result.halfedge_handle(eh, 0);
        found.push_back(result.from_vertex_handle(heh));
        found.push_back(result.to_vertex_handle(heh));
      });
  if (has_quads(result)) {
    choose_patches(result, model, is_dissolved, regions.is_chosen);
    near = all_of(between_tiles);
  }
  choose_rings(result, std::move(near), regions.is_chosen);
  leave_out_poles(result, model, regions.is_chosen);
  return regions;
}

SmoothRegions choose_along(const PolyMesh& result, const Model& model,
                           std::vector<VertexHandle> seam) {
  const auto contour_of = require(result, keys::edge_contour);
  SmoothRegions regions;
  regions.is_held.resize(result.n_edges());
  regions.is_chosen.assign(result.n_faces(), 0);
  for_each_shared<EdgeHandle>(result.n_edges(), [&](EdgeHandle eh) {
    regions.is_held[index(eh)] = result.property(contour_of, eh) >= 0;
  });
  choose_rings(result, std::move(seam), regions.is_chosen);
  leave_out_poles(result, model, regions.is_chosen);
  return regions;
}

std::vector<FacePiece> divide_in_pieces(const PolyMesh& result, const SmoothRegions& regions) {
  const FacePiece chosen = marked_faces(regions.is_chosen);
  std::vector<int> places(result.n_faces(), -1);
  for_each_shared<int>(chosen.size(),
                       [&](int i) { places[index(chosen[static_cast<std::size_t>(i)])] = i; });
  std::vector<FacePiece> pieces;
  FacePiece small;
  for (FacePiece& part : connected_parts(result, chosen, regions.is_held,
                                         [&](FaceHandle fh) { return places[index(fh)]; })) {
    if (part.size() > kMostFaces) {
      halve(result, part, pieces);
      continue;
    }
    small.insert(small.end(), part.begin(), part.end());
    if (small.size() < kMostFaces) continue;
    pieces.push_back(std::move(small));
    small.clear();
  }
  if (!small.empty()) pieces.push_back(std::move(small));
  sort_each(pieces);
  return pieces;
}

std::vector<FacePiece> parts_of(const PolyMesh& result, const FacePiece& piece,
                                const std::vector<char>& is_held) {
  return connected_parts(result, piece, is_held);
}

std::vector<FacePiece> connected_pieces(const PolyMesh& result, const SmoothRegions& regions) {
  return connected_parts(result, marked_faces(regions.is_chosen), regions.is_held);
}

std::vector<VertexHandle> seam_between(const PolyMesh& result, const std::vector<FacePiece>& pieces,
                                       const std::vector<char>& is_held) {
  std::vector<int> piece_of(result.n_faces(), -1);
  share_indices(pieces.size(), [&](std::size_t p) {
    for (const FaceHandle fh : pieces[p]) piece_of[index(fh)] = static_cast<int>(p);
  });
  std::vector<std::vector<VertexHandle>> of_pieces(pieces.size());
  share_indices(pieces.size(), [&](std::size_t p) {
    for (const FaceHandle fh : pieces[p]) {
      for_each_corner(result, fh, [&](HalfedgeHandle heh) {
        const FaceHandle beyond = result.face_handle(result.opposite_halfedge_handle(heh));
        if (is_held[index(result.edge_handle(heh))] != 0 || !beyond.is_valid()) return;
        // The piece before sees the edge, too.
        if (piece_of[index(beyond)] <= static_cast<int>(p)) return;
        of_pieces[p].push_back(result.from_vertex_handle(heh));
        of_pieces[p].push_back(result.to_vertex_handle(heh));
      });
    }
  });
  std::vector<VertexHandle> seam;
  for (const auto& own : of_pieces) seam.insert(seam.end(), own.begin(), own.end());
  std::sort(seam.begin(), seam.end());
  seam.erase(std::unique(seam.begin(), seam.end()), seam.end());
  return seam;
}

}  // namespace surfmesh
