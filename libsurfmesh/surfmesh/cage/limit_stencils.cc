// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/limit_stencils.hh"

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/ptexIndices.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/sdc/crease.h>

#include <algorithm>
#include <cmath>
#include <memory>
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

/// The greatest sharpness of the semi-sharp tags at a vertex; 0 if it has none.
double semi_sharpness(const Far::TopologyLevel& level, int vertex) {
  double greatest = 0;
  const auto take = [&](float sharpness) {
    if (Sdc::Crease::IsSemiSharp(sharpness)) {
      greatest = std::max(greatest, static_cast<double>(sharpness));
    }
  };
  take(level.GetVertexSharpness(vertex));
  for (const int edge : level.GetVertexEdges(vertex)) take(level.GetEdgeSharpness(edge));
  return greatest;
}

/// The steps of subdivision after which the masks are those of the limit; 0 for most vertices.
///
/// Tags of sharpness s are gone after s steps. OpenSubdiv 3.5 takes the end of a crease for a
/// smooth vertex, which it is not beside the crease, and inner vertices of two faces for corners.
int steps_to_mask(const Far::TopologyLevel& level, int vertex) {
  const int steps = static_cast<int>(std::ceil(semi_sharpness(level, vertex)));
  const Sdc::Crease::Rule rule = level.GetVertexRule(vertex);
  const bool has_two_faces =
      level.GetVertexFaces(vertex).size() == 2 && level.GetVertexEdges(vertex).size() == 2;
  const bool is_smooth_pair = has_two_faces && rule == Sdc::Crease::RULE_SMOOTH;
  const bool is_dart = rule == Sdc::Crease::RULE_DART;
  return is_dart || is_smooth_pair ? std::max(steps, kManySteps) : steps;
}

/// A corner of a face in Ptex's numbers, and the vertex there.
struct FaceCorner {
  int vertex = -1;
  int face = -1;
  Uv uv;
};

FaceCorner corner_at(const Far::TopologyRefiner& refiner, const Far::PtexIndices& ptex, int vertex,
                     int face) {
  const Far::ConstIndexArray vertices = refiner.GetLevel(0).GetFaceVertices(face);
  const int corner = vertices.FindIndex(vertex);
  const int size = Sdc::SchemeTypeTraits::GetRegularFaceSize(refiner.GetSchemeType());
  const int first = ptex.GetFaceId(face);
  // Each corner of another polygon has a face of Ptex of its own, which begins there.
  if (vertices.size() != size) return {vertex, first + corner, {0, 0}};
  Domain domain;
  if (size == 3) domain.shape = Domain::Shape::Triangle;
  return {vertex, first, domain.corner(corner)};
}

/// Replace the rows of vertices of which the masks are not the limit.
void replace_by_refinement(const Far::TopologyRefiner& refiner, Rows& rows) {
  const Far::TopologyLevel level = refiner.GetLevel(0);
  const Far::PtexIndices ptex(refiner);
  std::vector<FaceCorner> corners;
  std::vector<int> faces;
  int greatest = 0;
  for (int v = 0; v < level.GetNumVertices(); ++v) {
    const int steps = steps_to_mask(level, v);
    if (steps == 0 || level.GetVertexFaces(v).size() == 0) continue;
    greatest = std::max(greatest, steps);
    faces.push_back(level.GetVertexFaces(v)[0]);
    corners.push_back(corner_at(refiner, ptex, v, faces.back()));
  }
  if (corners.empty()) return;
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  Rows points;
  for (int v = 0; v < level.GetNumVertices(); ++v) points.emplace_back(v);
  const detail::RefinedFaces<WeightRow> refined(refiner, std::move(points), faces, greatest);
  for (const FaceCorner& corner : corners) {
    rows[static_cast<std::size_t>(corner.vertex)] =
        refined.evaluate(corner.face, corner.uv, Order::Position)[0];
  }
}

bool is_at_border(const Far::TopologyLevel& level, int vertex) {
  const Far::ConstIndexArray edges = level.GetVertexEdges(vertex);
  return std::any_of(edges.begin(), edges.end(),
                     [&](int edge) { return level.GetEdgeFaces(edge).size() == 1; });
}

}  // namespace

Stencils limit_stencils(const Far::TopologyRefiner& refiner) {
  const Far::TopologyLevel level = refiner.GetLevel(0);
  const bool is_linear = refiner.GetSchemeType() == Sdc::SCHEME_BILINEAR;
  const bool is_open =
      refiner.GetSchemeOptions().GetVtxBoundaryInterpolation() == Sdc::Options::VTX_BOUNDARY_NONE;
  Rows rows(static_cast<std::size_t>(level.GetNumVertices()));
  if (!is_linear) {
    rows = is_regular(refiner) ? rows_by_masks(refiner) : rows_of_refined(refiner);
    replace_by_refinement(refiner, rows);
  }
  for (int v = 0; v < level.GetNumVertices(); ++v) {
    const bool is_free = level.GetVertexFaces(v).size() == 0 || (is_open && is_at_border(level, v));
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
