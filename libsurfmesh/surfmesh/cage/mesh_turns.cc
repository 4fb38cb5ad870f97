// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/mesh_turns.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "surfmesh/cage/cage_sides.hh"
#include "surfmesh/cage/creases.hh"
#include "surfmesh/cage/sharp_features.hh"

namespace surfmesh {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

/// A vertex that stands out by this angle, seen from its neighbours, is noise or a feature.
constexpr double kNoisyAngle = 10;
/// Edges of more than this are features in a noisy mesh, too.
constexpr double kSurelySharp = 60;
/// Vertices need so many neighbours that are no features to compare with.
constexpr int kFewNeighbours = 3;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double median_of(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double mean_length(const Cage& cage) {
  double sum = 0;
  std::size_t count = 0;
  for (const std::vector<int>& face : cage.faces) {
    for (std::size_t k = 0; k < face.size(); ++k) {
      const auto from = static_cast<std::size_t>(face[k]);
      const auto to = static_cast<std::size_t>(face[(k + 1) % face.size()]);
      sum += (cage.points[to] - cage.points[from]).norm();
      ++count;
    }
  }
  return count > 0 ? sum / static_cast<double>(count) : 0;
}

/// Measures how far vertices stand out of a mesh.
class VertexHeights {
 public:
  explicit VertexHeights(const Cage& cage)
      : cage_(cage),
        is_feature_(cage.points.size(), 0),
        sides_(sorted_sides(cage.faces)),
        normals_(cage.points.size(), Vec3::Zero()),
        sums_(cage.points.size()) {
    mark_features();
    add_normals();
    for_each_edge(sides_, [this](std::span<const CageSide> edge) {
      add(edge[0].low, edge[0].high);
      add(edge[0].high, edge[0].low);
    });
    for (std::size_t v = 0; v < sums_.size(); ++v) heights_.push_back(height(v));
  }

  /// How far inner vertices are from the height of those around, shares of their edges' lengths.
  std::vector<double> differences() const {
    std::vector<Sum> around(heights_.size());
    for_each_edge(sides_, [&](std::span<const CageSide> edge) {
      const auto a = static_cast<std::size_t>(edge[0].low);
      const auto b = static_cast<std::size_t>(edge[0].high);
      if (!std::isfinite(heights_[a]) || !std::isfinite(heights_[b])) return;
      around[a].length += heights_[b];
      around[b].length += heights_[a];
      ++around[a].count;
      ++around[b].count;
    });
    std::vector<double> result;
    for (std::size_t v = 0; v < heights_.size(); ++v) {
      if (around[v].count < kFewNeighbours) continue;
      const double length = sums_[v].length / sums_[v].count;
      result.push_back(std::abs(heights_[v] - around[v].length / around[v].count) / length);
    }
    return result;
  }

 private:
  /// What is added up over the edges of a vertex.
  struct Sum {
    Vec3 step = Vec3::Zero();
    double length = 0;
    int count = 0;
  };

  void mark(int vertex) { is_feature_[static_cast<std::size_t>(vertex)] = 1; }

  void mark_features() {
    for_each_edge(sides_, [this](std::span<const CageSide> edge) {
      if (edge.size() == 2) return;
      mark(edge[0].low);
      mark(edge[0].high);
    });
    for (const auto& [low, high] : edges_above(kSurelySharp, cage_)) {
      mark(low);
      mark(high);
    }
  }

  void add_normals() {
    const auto point = [this](int v) -> const Vec3& {
      return cage_.points[static_cast<std::size_t>(v)];
    };
    for (const std::vector<int>& face : cage_.faces) {
      Vec3 area = Vec3::Zero();
      for (std::size_t k = 2; k < face.size(); ++k) {
        area += (point(face[k - 1]) - point(face[0])).cross(point(face[k]) - point(face[0]));
      }
      for (const int v : face) normals_[static_cast<std::size_t>(v)] += area;
    }
  }

  void add(int from, int to) {
    Sum& sum = sums_[static_cast<std::size_t>(from)];
    const Vec3 step =
        cage_.points[static_cast<std::size_t>(to)] - cage_.points[static_cast<std::size_t>(from)];
    sum.step += step;
    sum.length += step.norm();
    ++sum.count;
  }

  /// That of the neighbours' mean above a vertex; not a number for features.
  double height(std::size_t v) const {
    if (is_feature_[v] || sums_[v].count == 0 || sums_[v].length == 0) return kNone;
    return sums_[v].step.dot(normals_[v].normalized()) / sums_[v].count;
  }

  const Cage& cage_;
  std::vector<char> is_feature_;  ///< by vertex
  std::vector<CageSide> sides_;
  std::vector<Vec3> normals_;
  std::vector<Sum> sums_;
  std::vector<double> heights_;
};

}  // namespace

MeshTurns measure_turns(const Cage& cage) {
  MeshTurns turns;
  std::vector<double> angles;
  for (const EdgeTurn& edge : edge_turns(cage)) {
    if (edge.angle * kDegrees < kFeatureAngle) angles.push_back(edge.angle * kDegrees);
  }
  turns.median = median_of(std::move(angles));
  turns.length = mean_length(cage);
  const std::vector<double> differences = VertexHeights(cage).differences();
  if (differences.empty()) return turns;
  const double least = std::tan(kNoisyAngle / kDegrees) / 2;
  const auto noisy =
      std::count_if(differences.begin(), differences.end(), [=](double d) { return d > least; });
  turns.noisy_share = static_cast<double>(noisy) / static_cast<double>(differences.size());
  turns.roughness = median_of(differences);
  return turns;
}

}  // namespace surfmesh
