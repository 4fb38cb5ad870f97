// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/mesh_turns.hh"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "surfmesh/cage/cage_sides.hh"
#include "surfmesh/cage/creases.hh"
#include "surfmesh/cage/face_angles.hh"
#include "surfmesh/cage/median.hh"
#include "surfmesh/cage/sharp_features.hh"

namespace surfmesh {
namespace {

using detail::kDegrees;

/// Edges of more than this are features in a noisy mesh, too, degrees.
constexpr double kSharpInNoise = 60;
/// Vertices need so many neighbours that are no features to compare with.
constexpr int kFewNeighbours = 3;

/// Shares of the lengths of edges from which on a vertex stands out.
constexpr double kSpikeHeight = 0.17;
/// Around a spike in a smooth surface heights change by a sixth of its own; around rims and tips
/// some are nearly as great.
constexpr double kSpikeFoot = 0.4;

constexpr double kNoTurn = std::numeric_limits<double>::quiet_NaN();

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
  VertexHeights(const Cage& cage, double sharp_angle)
      : cage_(cage),
        is_feature_(cage.points.size(), 0),
        sides_(sorted_sides(cage.faces)),
        normals_(cage.points.size(), Vec3::Zero()),
        sums_(cage.points.size()) {
    mark_features(sharp_angle);
    add_normals();
    for_each_edge(sides_, [this](std::span<const CageSide> edge) {
      add(edge[0].low, edge[0].high);
      add(edge[0].high, edge[0].low);
    });
    for (std::size_t v = 0; v < sums_.size(); ++v) heights_.push_back(height(v));
  }

  /// The height of a vertex and the mean height of its neighbours, shares of its edges' length.
  struct Pair {
    int vertex = -1;
    double own = 0;
    double around = 0;
    double low = 0;  ///< of its neighbours
    double high = 0;
    int count = 0;  ///< of its neighbours
  };

  /// Those of the vertices with enough neighbours to compare with.
  std::vector<Pair> pairs() const {
    std::vector<Pair> all(heights_.size());
    for_each_edge(sides_, [&](std::span<const CageSide> edge) {
      add_height(edge[0].low, edge[0].high, all);
      add_height(edge[0].high, edge[0].low, all);
    });
    std::erase_if(all, [](const Pair& pair) { return pair.count < kFewNeighbours; });
    for (Pair& pair : all) {
      const auto v = static_cast<std::size_t>(pair.vertex);
      const double length = sums_[v].length / sums_[v].count;
      pair.own = heights_[v] / length;
      pair.around /= pair.count * length;
      pair.low /= length;
      pair.high /= length;
    }
    return all;
  }

 private:
  /// What is added up over the edges of a vertex.
  struct Sum {
    Vec3 step = Vec3::Zero();
    double length = 0;
    int count = 0;
  };

  void add_height(int to, int from, std::vector<Pair>& pairs) const {
    const double height = heights_[static_cast<std::size_t>(from)];
    if (!std::isfinite(height) || !std::isfinite(heights_[static_cast<std::size_t>(to)])) return;
    Pair& pair = pairs[static_cast<std::size_t>(to)];
    pair.vertex = to;
    pair.around += height;
    pair.low = pair.count == 0 ? height : std::min(pair.low, height);
    pair.high = pair.count == 0 ? height : std::max(pair.high, height);
    ++pair.count;
  }

  void mark(int vertex) { is_feature_[static_cast<std::size_t>(vertex)] = 1; }

  void mark_features(double sharp_angle) {
    for (const auto& [low, high] : border_edges(cage_)) {
      mark(low);
      mark(high);
    }
    for (const auto& [low, high] : edges_above(sharp_angle, cage_)) {
      mark(low);
      mark(high);
    }
  }

  void add_normals() {
    for (const std::vector<int>& face : cage_.faces) {
      const Vec3 area = detail::area_vector(face, cage_.points);
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
    if (is_feature_[v] || sums_[v].count == 0 || sums_[v].length == 0) return kNoTurn;
    return sums_[v].step.dot(normals_[v].normalized()) / sums_[v].count;
  }

  const Cage& cage_;
  std::vector<char> is_feature_;  ///< by vertex
  std::vector<CageSide> sides_;
  std::vector<Vec3> normals_;
  std::vector<Sum> sums_;
  std::vector<double> heights_;
};

/// The median angle of the edges that are no features; of all if most would be.
double median_turn(const Cage& cage) {
  std::vector<double> all, smooth;
  for (const EdgeTurn& edge : edge_turns(cage)) {
    all.push_back(edge.angle * kDegrees);
    if (all.back() < kFeatureAngle) smooth.push_back(all.back());
  }
  return detail::median_of(2 * smooth.size() < all.size() ? std::move(all) : std::move(smooth));
}

/// The share of the edges that have two faces.
double paired_share(const Cage& cage) {
  std::size_t count = 0, pairs = 0;
  const std::vector<CageSide> sides = sorted_sides(cage.faces);
  for_each_edge(sides, [&](std::span<const CageSide> edge) {
    ++count;
    if (edge.size() == 2) ++pairs;
  });
  return count > 0 ? static_cast<double>(pairs) / static_cast<double>(count) : 0;
}

void measure_noise(const Cage& cage, MeshTurns& turns) {
  std::vector<double> differences;
  for (const auto& pair : VertexHeights(cage, kSharpInNoise).pairs()) {
    differences.push_back(std::abs(pair.own - pair.around));
  }
  if (differences.empty()) return;
  const double least = std::tan(kNoisyAngle / kDegrees) / 2;
  const auto noisy =
      std::count_if(differences.begin(), differences.end(), [=](double d) { return d > least; });
  turns.noisy_share = static_cast<double>(noisy) / static_cast<double>(differences.size());
  turns.roughness = detail::median_of(std::move(differences));
}

/// Spikes: a vertex that is moved by d, in a surface where all heights are h, has the height h - d,
/// and its n neighbours h + d / n. It may be as sharp as it likes.
void find_spikes(const Cage& cage, MeshTurns& turns) {
  for (const auto& pair : VertexHeights(cage, 180).pairs()) {
    const double move = (pair.around - pair.own) / (1 + 1.0 / pair.count);
    const double base = pair.own + move;
    const double foot = std::max(std::abs(pair.low - base), std::abs(pair.high - base));
    if (std::abs(move) <= kSpikeHeight || foot > kSpikeFoot * std::abs(move)) continue;
    ++turns.spikes;
    if (std::abs(move) <= turns.spike_height) continue;
    turns.spike_height = std::abs(move);
    turns.spike = pair.vertex;
  }
}

}  // namespace

MeshTurns measure_turns(const Cage& cage) {
  MeshTurns turns;
  turns.median = median_turn(cage);
  turns.paired_share = paired_share(cage);
  turns.length = mean_length(cage);
  measure_noise(cage, turns);
  find_spikes(cage, turns);
  return turns;
}

}  // namespace surfmesh
