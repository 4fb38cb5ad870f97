// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/limit_stencils.hh"

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/ptexIndices.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/sdc/crease.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "surfmesh/cage/refined_faces.hh"
#include "surfmesh/cage/subdivision.hh"

namespace surfmesh {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

/// A vertex as OpenSubdiv's interpolation reads it.
struct VertexOfCage {
  int index = -1;
};

/// A combination of vertices, which OpenSubdiv's interpolation fills. A vertex may come repeatedly.
class WeightRow {
 public:
  WeightRow() = default;
  explicit WeightRow(int vertex) { AddWithWeight(VertexOfCage{vertex}, 1); }

  void Clear() { entries_.clear(); }

  void AddWithWeight(VertexOfCage vertex, double weight) {
    if (weight != 0) entries_.emplace_back(vertex.index, weight);
  }

  /// Sums have a few dozen entries, but are made of sums many times over, so equal ones are merged.
  void AddWithWeight(const WeightRow& other, double weight) {
    if (weight == 0) return;
    for (const auto& [vertex, own] : other.entries_) entries_.emplace_back(vertex, weight * own);
    merge();
  }

  const std::vector<std::pair<int, double>>& entries() const { return entries_; }

 private:
  void merge() {
    std::sort(entries_.begin(), entries_.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    std::size_t last = 0;
    for (std::size_t i = 1; i < entries_.size(); ++i) {
      if (entries_[i].first == entries_[last].first) {
        entries_[last].second += entries_[i].second;
      } else {
        entries_[++last] = entries_[i];
      }
    }
    if (!entries_.empty()) entries_.resize(last + 1);
  }

  std::vector<std::pair<int, double>> entries_;
};

using Rows = std::vector<WeightRow>;

/// The vertices of a level, as an array of values that are their own numbers.
struct VerticesOfLevel {
  VertexOfCage operator[](int index) const { return {index}; }
};

Stencils matrix_of(const Rows& rows, int columns) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (const auto& [vertex, weight] : rows[r].entries()) {
      entries.emplace_back(static_cast<int>(r), vertex, weight);
    }
  }
  Stencils result(static_cast<int>(rows.size()), columns);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

/// The limit positions of the last level of a refiner from its own points, by OpenSubdiv's masks.
/// They take semi-sharp tags for what they become, and know faces of the scheme's size only.
Rows rows_by_masks(const Far::TopologyRefiner& refiner) {
  Rows rows(static_cast<std::size_t>(refiner.GetLevel(refiner.GetMaxLevel()).GetNumVertices()));
  VerticesOfLevel vertices;
  Far::PrimvarRefinerReal<double>(refiner).Limit(vertices, rows);
  return rows;
}

bool is_regular(const Far::TopologyRefiner& refiner) {
  const Far::TopologyLevel level = refiner.GetLevel(0);
  const int size = Sdc::SchemeTypeTraits::GetRegularFaceSize(refiner.GetSchemeType());
  for (int f = 0; f < level.GetNumFaces(); ++f) {
    if (level.GetFaceVertices(f).size() != size) return false;
  }
  return true;
}

/// After a step of subdivision all faces have the scheme's size.
Rows rows_of_refined(const Far::TopologyRefiner& base) {
  const std::unique_ptr<Far::TopologyRefiner> refiner(
      Far::TopologyRefinerFactory<Far::TopologyDescriptor>::Create(base));
  Far::TopologyRefiner::UniformOptions options(1);
  options.fullTopologyInLastLevel = true;
  refiner->RefineUniform(options);
  Rows fine(static_cast<std::size_t>(refiner->GetLevel(1).GetNumVertices()));
  VerticesOfLevel vertices;
  Far::PrimvarRefinerReal<double>(*refiner).Interpolate(1, vertices, fine);
  const Rows of_fine = rows_by_masks(*refiner);
  const Far::TopologyLevel level = refiner->GetLevel(0);
  Rows rows(static_cast<std::size_t>(level.GetNumVertices()));
  for (int v = 0; v < level.GetNumVertices(); ++v) {
    const auto child = static_cast<std::size_t>(level.GetVertexChildVertex(v));
    for (const auto& [vertex, weight] : of_fine[child].entries()) {
      rows[static_cast<std::size_t>(v)].AddWithWeight(fine[static_cast<std::size_t>(vertex)],
                                                      weight);
    }
  }
  return rows;
}

/// Steps of refinement after which masks are near enough where they are never exact; as in
/// make_limit_surfaces.
constexpr int kManySteps = 8;

/// Semi-sharp edges are refined along their whole length, so faces are refined together only as
/// long as these shares of an edge are no more in all: some 100 MB of weights.
constexpr int kMostRefinedEdges = 1 << 15;

/// The tags at a vertex.
struct VertexTags {
  double semi_sharpness = 0;  ///< greatest one of the semi-sharp tags
  int sharp_edges = 0;        ///< that stay sharp: creases, borders and cuts
  bool is_sharp = false;      ///< the vertex is a corner that stays one
};

VertexTags tags_at(const Far::TopologyLevel& level, int vertex) {
  VertexTags tags;
  const auto add = [&](float sharpness) {
    if (!Sdc::Crease::IsSemiSharp(sharpness)) return;
    tags.semi_sharpness = std::max(tags.semi_sharpness, static_cast<double>(sharpness));
  };
  add(level.GetVertexSharpness(vertex));
  tags.is_sharp = Sdc::Crease::IsInfinite(level.GetVertexSharpness(vertex));
  for (const int edge : level.GetVertexEdges(vertex)) {
    add(level.GetEdgeSharpness(edge));
    const bool is_cut = level.GetEdgeFaces(edge).size() != 2;
    if (is_cut || Sdc::Crease::IsInfinite(level.GetEdgeSharpness(edge))) ++tags.sharp_edges;
  }
  return tags;
}

/// The steps of subdivision after which the masks are those of the limit; 0 for most vertices.
///
/// Tags of sharpness s are gone after s steps. What is left then counts: OpenSubdiv 3.5 takes the
/// end of a crease for a smooth vertex, which it is not beside the crease, and inner vertices of
/// two faces for corners.
int steps_to_mask(const Far::TopologyLevel& level, int vertex) {
  const VertexTags tags = tags_at(level, vertex);
  const int steps = static_cast<int>(std::ceil(tags.semi_sharpness));
  const bool has_two_faces =
      level.GetVertexFaces(vertex).size() == 2 && level.GetVertexEdges(vertex).size() == 2;
  const bool ends_smooth = has_two_faces && tags.sharp_edges == 0 && !tags.is_sharp;
  const bool ends_as_dart = tags.sharp_edges == 1 && !tags.is_sharp;
  return ends_as_dart || ends_smooth ? std::max(steps, kManySteps) : steps;
}

/// A corner of a face, by Ptex's numbers as well, and the vertex there.
struct FaceCorner {
  int vertex = -1;
  int steps = 0;  ///< of subdivision that its limit needs
  int face = -1;
  int ptex_face = -1;
  Uv uv;
};

FaceCorner corner_at(const Far::TopologyRefiner& refiner, const Far::PtexIndices& ptex, int vertex,
                     int face) {
  const Far::ConstIndexArray vertices = refiner.GetLevel(0).GetFaceVertices(face);
  const int corner = vertices.FindIndex(vertex);
  const int size = Sdc::SchemeTypeTraits::GetRegularFaceSize(refiner.GetSchemeType());
  FaceCorner result{vertex, 0, face, ptex.GetFaceId(face), {0, 0}};
  if (vertices.size() != size) {
    // Each corner of another polygon has a face of Ptex of its own, which begins there.
    result.ptex_face += corner;
    return result;
  }
  Domain domain;
  if (size == 3) domain.shape = Domain::Shape::Triangle;
  result.uv = domain.corner(corner);
  return result;
}

bool is_at_border(const Far::TopologyLevel& level, int vertex) {
  const Far::ConstIndexArray edges = level.GetVertexEdges(vertex);
  return std::any_of(edges.begin(), edges.end(),
                     [&](int edge) { return level.GetEdgeFaces(edge).size() == 1; });
}

bool is_open(const Far::TopologyRefiner& refiner) {
  return refiner.GetSchemeOptions().GetVtxBoundaryInterpolation() ==
         Sdc::Options::VTX_BOUNDARY_NONE;
}

/// True if a face has a limit surface: it is no hole, nor at the border under BoundaryRule::None.
bool has_surface(const Far::TopologyRefiner& refiner, int face) {
  const Far::TopologyLevel level = refiner.GetLevel(0);
  if (level.IsFaceHole(face)) return false;
  if (!is_open(refiner)) return true;
  const Far::ConstIndexArray vertices = level.GetFaceVertices(face);
  return std::none_of(vertices.begin(), vertices.end(),
                      [&](int vertex) { return is_at_border(level, vertex); });
}

/// The corners of faces at vertices of which the masks are not the limit, by their steps. A vertex
/// without a face that has a surface keeps its mask.
std::vector<FaceCorner> corners_to_refine(const Far::TopologyRefiner& refiner) {
  const Far::TopologyLevel level = refiner.GetLevel(0);
  const Far::PtexIndices ptex(refiner);
  std::vector<FaceCorner> corners;
  for (int v = 0; v < level.GetNumVertices(); ++v) {
    const int steps = steps_to_mask(level, v);
    if (steps == 0) continue;
    const Far::ConstIndexArray faces = level.GetVertexFaces(v);
    const auto face =
        std::find_if(faces.begin(), faces.end(), [&](int f) { return has_surface(refiner, f); });
    if (face == faces.end()) continue;
    corners.push_back(corner_at(refiner, ptex, v, *face));
    corners.back().steps = steps;
  }
  std::stable_sort(corners.begin(), corners.end(),
                   [](const FaceCorner& a, const FaceCorner& b) { return a.steps < b.steps; });
  return corners;
}

/// Replace the rows of vertices at some corners, which need the same steps.
void replace_rows(const Far::TopologyRefiner& refiner, std::span<const FaceCorner> corners,
                  Rows& rows) {
  std::vector<int> faces;
  for (const FaceCorner& corner : corners) faces.push_back(corner.face);
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  Rows points;
  for (int v = 0; v < refiner.GetLevel(0).GetNumVertices(); ++v) points.emplace_back(v);
  const detail::RefinedFaces<WeightRow> refined(refiner, std::move(points), faces,
                                                corners.front().steps);
  for (const FaceCorner& corner : corners) {
    if (!refined.has(corner.ptex_face, corner.uv)) continue;
    rows[static_cast<std::size_t>(corner.vertex)] =
        refined.evaluate(corner.ptex_face, corner.uv, Order::Position)[0];
  }
}

/// Replace the rows of vertices of which the masks are not the limit.
void replace_by_refinement(const Far::TopologyRefiner& refiner, Rows& rows) {
  const std::vector<FaceCorner> corners = corners_to_refine(refiner);
  for (std::size_t first = 0; first < corners.size();) {
    const int steps = corners[first].steps;
    const auto most = static_cast<std::size_t>(std::max(1, kMostRefinedEdges >> steps));
    std::size_t end = first;
    while (end < corners.size() && end - first < most && corners[end].steps == steps) ++end;
    replace_rows(refiner, std::span(corners).subspan(first, end - first), rows);
    first = end;
  }
}

}  // namespace

Stencils limit_stencils(const Far::TopologyRefiner& refiner) {
  const Far::TopologyLevel level = refiner.GetLevel(0);
  const bool is_linear = refiner.GetSchemeType() == Sdc::SCHEME_BILINEAR;
  Rows rows(static_cast<std::size_t>(level.GetNumVertices()));
  if (!is_linear) {
    rows = is_regular(refiner) ? rows_by_masks(refiner) : rows_of_refined(refiner);
    replace_by_refinement(refiner, rows);
  }
  for (int v = 0; v < level.GetNumVertices(); ++v) {
    const bool is_free =
        level.GetVertexFaces(v).size() == 0 || (is_open(refiner) && is_at_border(level, v));
    if (is_linear || is_free) rows[static_cast<std::size_t>(v)] = WeightRow(v);
  }
  return matrix_of(rows, level.GetNumVertices());
}

std::vector<Vec3> limit_points(const Cage& cage, Scheme scheme) {
  const CageTopology topology = make_topology(cage, scheme);
  const Stencils stencils = limit_stencils(*topology.refiner);
  std::vector<Vec3> points(cage.points.size(), Vec3::Zero());
  for (int v = 0; v < stencils.rows(); ++v) {
    for (Stencils::InnerIterator entry(stencils, v); entry; ++entry) {
      points[static_cast<std::size_t>(v)] +=
          entry.value() * cage.points[static_cast<std::size_t>(entry.col())];
    }
  }
  return points;
}

}  // namespace surfmesh
