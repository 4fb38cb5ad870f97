// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/gather_regions.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <set>
#include <tuple>
#include <utility>

#include "surfmesh/cage/face_angles.hh"
#include "surfmesh/cage/face_shapes.hh"
#include "surfmesh/cage/region_charts.hh"

namespace surfmesh {
namespace {

constexpr int kNoRegion = -1;

/// The angles within which regions stay, radians; see gather_regions.hh.
constexpr double kMostTurn = kMostTurnOfRegion / detail::kDegrees;
constexpr double kMostTurnOfRest = kMostTurnOfMargin / detail::kDegrees;

/// Faces of a region, about. Twice that is too many.
constexpr std::size_t kFacesOfRegion = 2000;

/// Regions of fewer faces become parts of others where they may.
constexpr std::size_t kFewFaces = 24;

/// How much farther apart faces count that turn away from the plane of the region by 90°.
constexpr double kTurnCost = 3;

/// Times that seeds move to the middles of their regions.
constexpr int kMoves = 3;

/// Times that faces without a region become seeds after that.
constexpr int kMostRounds = 30;

/// Divides the faces among seeds.
class RegionGatherer {
 public:
  RegionGatherer(const FaceNeighbours& neighbours, const std::vector<FaceShape>& shapes)
      : neighbours_(neighbours), shapes_(shapes), region_of_(shapes.size(), kNoRegion) {}

  /// The region of each face, from 0; -1 for faces by themselves.
  std::vector<int> run() {
    place_first_seeds();
    for (int move = 0; move < kMoves; ++move) {
      flood();
      drop_small();
      add_seeds(kFewFaces);
      flood();
      merge();
      move_seeds();
    }
    flood();
    for (int round = 0; round < kMostRounds && add_seeds(1); ++round) flood();
    merge();
    move_seeds();
    absorb_small();
    return std::move(region_of_);
  }

  std::size_t seed_count() const { return seeds_.size(); }

  /// The normals of the planes, by region.
  const Vec3& axis(int region) const { return seeds_[index(region)].axis; }

 private:
  struct Seed {
    int face = kNoRegion;
    Vec3 axis;
  };

  /// What a region is made of.
  struct Sum {
    std::vector<int> faces = {};
    Vec3 normal = Vec3::Zero();  ///< times the area

    void add(int face, const FaceShape& shape) {
      faces.push_back(face);
      normal += shape.area * shape.normal;
    }
    void add(const Sum& other) {
      faces.insert(faces.end(), other.faces.begin(), other.faces.end());
      normal += other.normal;
    }
    Vec3 axis() const { return normal.normalized(); }
  };

  /// A face that a region may take, at a cost.
  using Offer = std::tuple<double, int, int>;  // cost, face, region
  using Offers = std::priority_queue<Offer, std::vector<Offer>, std::greater<>>;

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  const FaceShape& shape(int face) const { return shapes_[index(face)]; }
  int& region(int face) { return region_of_[index(face)]; }
  int region(int face) const { return region_of_[index(face)]; }

  bool may_be_in_region(int face) const {
    return neighbours_.is_used(face) && shape(face).turn <= kMostTurn;
  }

  bool fits(int face, const Vec3& axis, double most_turn) const {
    return turn_from(shape(face), axis) <= most_turn;
  }

  /// True if a face lies beside one of a region in an edge where they are no neighbours: both sides
  /// of a crease.
  bool is_beside_itself(int face, int of_region) const {
    const auto& level = neighbours_.level();
    for (int side = 0; side < neighbours_.corner_count(); ++side) {
      if (neighbours_.across({face, side}).face >= 0) continue;
      for (const int other : level.GetEdgeFaces(neighbours_.edge({face, side}))) {
        if (other != face && region(other) != kNoRegion && region(other) == of_region) return true;
      }
    }
    return false;
  }

  double step_cost(int from, int to, const Vec3& axis) const {
    const double turn = 1 - shape(to).normal.dot(axis);
    return (shape(to).centre - shape(from).centre).norm() * (1 + kTurnCost * turn);
  }

  /// Take faces from the offers, each for the region to which it is nearest, until `limit` are
  /// taken.
  void take(Offers& offers, std::size_t limit = std::numeric_limits<std::size_t>::max()) {
    for (std::size_t taken = 0; !offers.empty() && taken < limit;) {
      const auto [cost, face, of_region] = offers.top();
      offers.pop();
      if (region(face) != kNoRegion || is_beside_itself(face, of_region)) continue;
      region(face) = of_region;
      ++taken;
      for (int side = 0; side < neighbours_.corner_count(); ++side) {
        const int next = neighbours_.across({face, side}).face;
        const Vec3& axis = seeds_[index(of_region)].axis;
        if (next < 0 || region(next) != kNoRegion || !fits(next, axis, kMostTurn)) continue;
        offers.emplace(cost + step_cost(face, next, axis), next, of_region);
      }
    }
  }

  /// One region after the other, each from the first face that is left.
  void place_first_seeds() {
    for (int face = 0; face < neighbours_.face_count(); ++face) {
      if (region(face) != kNoRegion || !may_be_in_region(face)) continue;
      grow_from(face);
    }
    move_seeds();
  }

  void grow_from(int face) {
    seeds_.push_back({face, shape(face).normal});
    Offers offers;
    offers.emplace(0.0, face, static_cast<int>(seeds_.size()) - 1);
    take(offers, kFacesOfRegion);
  }

  void flood() {
    std::fill(region_of_.begin(), region_of_.end(), kNoRegion);
    Offers offers;
    for (std::size_t r = 0; r < seeds_.size(); ++r) {
      offers.emplace(0.0, seeds_[r].face, static_cast<int>(r));
    }
    take(offers);
  }

  std::vector<std::vector<int>> faces_by_region() const {
    std::vector<std::vector<int>> faces(seeds_.size());
    for (int f = 0; f < neighbours_.face_count(); ++f) {
      if (region(f) != kNoRegion) faces[index(region(f))].push_back(f);
    }
    return faces;
  }

  /// Seeds become the faces nearest to the middles of their regions, and their planes those of the
  /// mean normals, where all faces lie over these.
  void move_seeds() {
    const std::vector<std::vector<int>> faces = faces_by_region();
    for (std::size_t r = 0; r < seeds_.size(); ++r) {
      if (faces[r].empty()) continue;
      Vec3 centre = Vec3::Zero(), normal = Vec3::Zero();
      double area = 0;
      for (const int f : faces[r]) {
        centre += shape(f).area * shape(f).centre;
        normal += shape(f).area * shape(f).normal;
        area += shape(f).area;
      }
      centre /= area;
      normal.normalize();
      const bool all_fit = std::all_of(faces[r].begin(), faces[r].end(),
                                       [&](int f) { return fits(f, normal, kMostTurn); });
      if (!all_fit) normal = seeds_[r].axis;
      Seed seed;
      double least = std::numeric_limits<double>::infinity();
      for (const int f : faces[r]) {
        const double distance = (shape(f).centre - centre).squaredNorm();
        if (distance >= least || !fits(f, normal, kMostTurn)) continue;
        least = distance;
        seed = {f, normal};
      }
      if (seed.face != kNoRegion) seeds_[r] = seed;
    }
  }

  /// Merge regions that fit over one plane, those of the least angle first.
  void merge() {
    std::vector<Sum> sums(seeds_.size());
    for (int f = 0; f < neighbours_.face_count(); ++f) {
      if (region(f) != kNoRegion) sums[index(region(f))].add(f, shape(f));
    }
    std::vector<std::tuple<double, int, int>> pairs;
    for (const auto& [a, b] : neighbouring_regions()) {
      pairs.emplace_back(detail::angle_between(sums[index(a)].axis(), sums[index(b)].axis()), a, b);
    }
    std::sort(pairs.begin(), pairs.end());
    std::vector<int> host(seeds_.size());
    std::iota(host.begin(), host.end(), 0);
    const auto root = [&](int r) {
      while (host[index(r)] != r) r = host[index(r)];
      return r;
    };
    for (const auto& [angle, first, second] : pairs) {
      const int a = root(first), b = root(second);
      if (a == b || !may_merge(sums[index(a)], sums[index(b)])) continue;
      host[index(b)] = a;
      for (const int face : sums[index(b)].faces) region(face) = a;
      sums[index(a)].add(sums[index(b)]);
    }
  }

  bool may_merge(const Sum& a, const Sum& b) const {
    if (a.faces.size() + b.faces.size() > kFacesOfRegion) return false;
    const Vec3 axis = (a.normal + b.normal).normalized();
    const auto all_fit = [&](const std::vector<int>& faces, int other_region) {
      return std::all_of(faces.begin(), faces.end(), [&](int face) {
        return fits(face, axis, kMostTurn) && !is_beside_itself(face, other_region);
      });
    };
    return all_fit(a.faces, region(b.faces.front())) && all_fit(b.faces, kNoRegion);
  }

  /// Pairs of regions with an edge in common, the lower one first.
  std::set<std::pair<int, int>> neighbouring_regions() const {
    std::set<std::pair<int, int>> pairs;
    for (int f = 0; f < neighbours_.face_count(); ++f) {
      for (int side = 0; side < neighbours_.corner_count() && region(f) != kNoRegion; ++side) {
        const int next = neighbours_.across({f, side}).face;
        if (next >= 0 && region(next) > region(f)) pairs.emplace(region(f), region(next));
      }
    }
    return pairs;
  }

  /// Take back the seeds of small regions.
  void drop_small() {
    const std::vector<std::vector<int>> faces = faces_by_region();
    std::vector<Seed> kept;
    for (std::size_t r = 0; r < seeds_.size(); ++r) {
      const bool is_small = faces[r].size() < kFewFaces;
      if (!is_small) kept.push_back(seeds_[r]);
      for (const int face : faces[r]) {
        region(face) = is_small ? kNoRegion : static_cast<int>(kept.size()) - 1;
      }
    }
    seeds_ = std::move(kept);
  }

  /// Faces without a region, of each connected part of at least so many the first one, become
  /// seeds, and the last faces of regions that are too large.
  /// Returns  false if there was none to add
  bool add_seeds(std::size_t least) {
    const std::size_t before = seeds_.size();
    std::vector<char> is_seen(shapes_.size(), 0);
    for (int face = 0; face < neighbours_.face_count(); ++face) {
      if (is_seen[index(face)] || region(face) != kNoRegion || !may_be_in_region(face)) continue;
      if (mark_connected(face, is_seen) < least) continue;
      seeds_.push_back({face, shape(face).normal});
    }
    for (const std::vector<int>& faces : faces_by_region()) {
      if (faces.size() <= 2 * kFacesOfRegion) continue;
      const Seed& seed = seeds_[index(region(faces[0]))];
      const Vec3& centre = shape(seed.face).centre;
      const int farthest = *std::max_element(faces.begin(), faces.end(), [&](int a, int b) {
        return (shape(a).centre - centre).squaredNorm() < (shape(b).centre - centre).squaredNorm();
      });
      seeds_.push_back({farthest, shape(farthest).normal});
    }
    return seeds_.size() > before;
  }

  /// Mark the faces without a region that are connected with one.
  /// Returns  their number
  std::size_t mark_connected(int first, std::vector<char>& is_seen) const {
    std::vector<int> stack = {first};
    is_seen[index(first)] = 1;
    std::size_t count = 0;
    for (; !stack.empty(); ++count) {
      const int face = stack.back();
      stack.pop_back();
      for (int side = 0; side < neighbours_.corner_count(); ++side) {
        const int next = neighbours_.across({face, side}).face;
        if (next < 0 || is_seen[index(next)] || region(next) != kNoRegion ||
            !may_be_in_region(next)) {
          continue;
        }
        is_seen[index(next)] = 1;
        stack.push_back(next);
      }
    }
    return count;
  }

  /// Small regions become parts of the neighbours with which they have most sides in common, where
  /// these may have them.
  void absorb_small() {
    std::vector<std::vector<int>> faces = faces_by_region();
    for (std::size_t r = 0; r < faces.size(); ++r) {
      if (faces[r].empty() || faces[r].size() >= kFewFaces) continue;
      const int host = host_of(faces[r], static_cast<int>(r));
      if (host == kNoRegion) continue;
      for (const int face : faces[r]) region(face) = host;
      faces[index(host)].insert(faces[index(host)].end(), faces[r].begin(), faces[r].end());
      faces[r].clear();
    }
  }

  int host_of(const std::vector<int>& faces, int own) const {
    std::vector<std::pair<int, int>> shared;  // region, sides
    for (const int face : faces) {
      for (int side = 0; side < neighbours_.corner_count(); ++side) {
        const int next = neighbours_.across({face, side}).face;
        if (next < 0 || region(next) == own || region(next) == kNoRegion) continue;
        const auto known = std::find_if(shared.begin(), shared.end(), [&](const auto& entry) {
          return entry.first == region(next);
        });
        if (known == shared.end()) {
          shared.emplace_back(region(next), 1);
        } else {
          ++known->second;
        }
      }
    }
    std::stable_sort(shared.begin(), shared.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    for (const auto& [host, sides] : shared) {
      const Vec3& axis = seeds_[index(host)].axis;
      const bool fit = std::all_of(faces.begin(), faces.end(), [&, host = host](int face) {
        return fits(face, axis, kMostTurnOfRest) && !is_beside_itself(face, host);
      });
      if (fit) return host;
    }
    return kNoRegion;
  }

  const FaceNeighbours& neighbours_;
  const std::vector<FaceShape>& shapes_;
  std::vector<int> region_of_;
  std::vector<Seed> seeds_;
};

}  // namespace

std::vector<FaceRegion> gather_regions(
    const FaceNeighbours& neighbours, const std::vector<std::shared_ptr<const Surface>>& surfaces) {
  const std::vector<FaceShape> shapes = shapes_of(surfaces);
  RegionGatherer gatherer(neighbours, shapes);
  const std::vector<int> region_of = gatherer.run();
  std::vector<std::vector<int>> faces(gatherer.seed_count());
  std::vector<FaceRegion> regions;
  const auto add_single = [&](int face) { regions.push_back({{face}}); };
  for (int face = 0; face < neighbours.face_count(); ++face) {
    const int region = region_of[static_cast<std::size_t>(face)];
    if (region >= 0) {
      faces[static_cast<std::size_t>(region)].push_back(face);
    } else if (neighbours.is_used(face)) {
      add_single(face);
    }
  }
  RegionChartMaker maker(neighbours, shapes, surfaces);
  for (std::size_t r = 0; r < faces.size(); ++r) {
    // Faces that cover each other are halved until they do not.
    std::vector<std::vector<int>> parts = {std::move(faces[r])};
    while (!parts.empty()) {
      std::vector<int> part = std::move(parts.back());
      parts.pop_back();
      if (part.empty()) continue;
      if (part.size() == 1) {
        add_single(part.front());
      } else if (auto region = maker.make(part, gatherer.axis(static_cast<int>(r)))) {
        regions.push_back(std::move(*region));
      } else {
        for (std::vector<int>& half : maker.halves(part)) parts.push_back(std::move(half));
      }
    }
  }
  std::sort(regions.begin(), regions.end(), [](const FaceRegion& a, const FaceRegion& b) {
    return a.faces.front() < b.faces.front();
  });
  return regions;
}

}  // namespace surfmesh
