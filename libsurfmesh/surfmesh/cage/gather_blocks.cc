// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/gather_blocks.hh"

#include <opensubdiv/sdc/crease.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <queue>
#include <utility>

#include "surfmesh/core/parallel.hh"

namespace surfmesh {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

/// In faces; an upper bound may be far more than there are.
using Area = std::int64_t;

constexpr int kNone = -1;

/// Most faces around a vertex in the middle of a block's side. The two faces of the block there
/// fill an angle of 720° / n, which is straight in the block's parameters: with n = 64 the side is
/// a hairpin, and the elements beside it were slivers of quality 0.004, at corners of 0.02.
constexpr int kMostFacesAtSide = 8;

/// Least angle that the two faces at a vertex in the middle of a block's side fill in the cage, or
/// leave free. That of a side is straight in the block's parameters: where faces around a fan of a
/// hundred triangles fill 20° and 340° in turns, a tenth of the elements that crossed them
/// were turned.
constexpr double kLeastAngleAtSide = std::numbers::pi / 4;

/// A face with one of its corners at the lower left, as one number.
int turned(int face, int rotation) { return 4 * face + rotation % 4; }
int face_of(int turned_face) { return turned_face / 4; }
int rotation_of(int turned_face) { return turned_face % 4; }

/// The same face with its right side where its upper one was.
int rotated(int turned_face) { return turned(face_of(turned_face), rotation_of(turned_face) + 1); }

/// Tells which turned faces lie beside each other in a block.
class Neighbours {
 public:
  Neighbours(const Far::TopologyRefiner& refiner, const std::vector<int>& sets,
             const std::vector<Vec3>& points)
      : level_(refiner.GetLevel(0)),
        points_(points),
        is_chaikin_(refiner.GetSchemeOptions().GetCreasingMethod() == Sdc::Options::CREASE_CHAIKIN),
        sets_(sets),
        across_(4 * sets.size(), kNone),
        is_flat_(static_cast<std::size_t>(level_.GetNumVertices()), 0) {
    share_ranges(index(level_.GetNumFaces()), [&](std::size_t first, std::size_t end) {
      for (int f = static_cast<int>(first); f < static_cast<int>(end); ++f) {
        for (int side = 0; is_quad(f) && side < 4; ++side) link(f, side);
      }
    });
    share_ranges(is_flat_.size(), [&](std::size_t first, std::size_t end) {
      for (std::size_t v = first; v < end; ++v) is_flat_[v] = surrounds(static_cast<int>(v));
    });
  }

  int turned_face_count() const { return static_cast<int>(across_.size()); }

  bool is_usable(int face) const { return sets_[index(face)] != kNone; }

  int right(int turned_face) const {
    const int side = across(turned_face, 1);
    return side == kNone ? kNone : turned(face_of(side), rotation_of(side) + 1);
  }

  int up(int turned_face) const { return across(turned_face, 2); }

  int left(int turned_face) const {
    const int side = across(turned_face, 3);
    return side == kNone ? kNone : turned(face_of(side), rotation_of(side) + 3);
  }

  /// True if the upper right corner may lie inside a block.
  bool is_flat(int turned_face) const {
    const int corner = (rotation_of(turned_face) + 2) % 4;
    return is_flat_[index(level_.GetFaceVertices(face_of(turned_face))[corner])] != 0;
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  /// The neighbour at a side of a turned face, turned so that this side is its lower one.
  int across(int turned_face, int side) const {
    return across_[index(turned(face_of(turned_face), rotation_of(turned_face) + side))];
  }

  /// A quad with four different sides: a side that is a point would end inside of a block.
  bool is_quad(int face) const {
    if (!is_usable(face)) return false;
    const auto vertices = level_.GetFaceVertices(face);
    if (vertices.size() != 4) return false;
    for (int i = 0; i < 4; ++i) {
      if (vertices[i] == vertices[(i + 1) % 4]) return false;
    }
    return true;
  }

  bool is_wall(int edge) const {
    if (level_.GetEdgeFaces(edge).size() != 2 || level_.GetEdgeSharpness(edge) > 0) return true;
    const auto ends = level_.GetEdgeVertices(edge);
    if (has_narrow_faces(ends[0]) || has_narrow_faces(ends[1])) return true;
    if (makes_hairpin(edge, ends[0], ends[1]) || makes_hairpin(edge, ends[1], ends[0])) return true;
    return is_chaikin_ && (has_semi_sharp(ends[0]) || has_semi_sharp(ends[1]));
  }

  /// At a boundary the faces share half the angle only.
  bool has_narrow_faces(int vertex) const {
    const int faces = level_.GetVertexFaces(vertex).size();
    const bool is_boundary = level_.GetVertexEdges(vertex).size() != faces;
    return faces * (is_boundary ? 2 : 1) > kMostFacesAtSide;
  }

  /// True if the two faces of the edge from `vertex` to `other` fill next to nothing there, or
  /// nearly all.
  bool makes_hairpin(int edge, int vertex, int other) const {
    double angle = 0;
    for (const int face : level_.GetEdgeFaces(edge)) {
      const auto vertices = level_.GetFaceVertices(face);
      const int corner = vertices.FindIndex(vertex), count = vertices.size();
      const int next = vertices[(corner + 1) % count];
      const int side = next == other ? vertices[(corner + count - 1) % count] : next;
      angle += angle_at(vertex, other, side);
    }
    return angle < kLeastAngleAtSide || angle > 2 * std::numbers::pi - kLeastAngleAtSide;
  }

  double angle_at(int vertex, int a, int b) const {
    const Vec3 to_a = points_[index(a)] - points_[index(vertex)];
    const Vec3 to_b = points_[index(b)] - points_[index(vertex)];
    return std::atan2(to_a.cross(to_b).norm(), to_a.dot(to_b));
  }

  bool has_semi_sharp(int vertex) const {
    const auto edges = level_.GetVertexEdges(vertex);
    return std::any_of(edges.begin(), edges.end(), [this](int edge) {
      return Sdc::Crease::IsSemiSharp(level_.GetEdgeSharpness(edge));
    });
  }

  void link(int face, int side) {
    const int edge = level_.GetFaceEdges(face)[side];
    if (is_wall(edge)) return;
    const auto faces = level_.GetEdgeFaces(edge);
    const int other = faces[faces[0] == face ? 1 : 0];
    if (!is_quad(other) || sets_[index(other)] != sets_[index(face)]) return;
    const int other_side = level_.GetFaceEdges(other).FindIndex(edge);
    const auto mine = level_.GetFaceVertices(face), its = level_.GetFaceVertices(other);
    if (other != face && its[other_side] == mine[(side + 1) % 4]) {
      across_[index(turned(face, side))] = turned(other, other_side);
    }
  }

  /// True if four faces surround the vertex, each beside the next.
  bool surrounds(int vertex) const {
    const auto faces = level_.GetVertexFaces(vertex);
    if (faces.size() != 4 || level_.GetVertexEdges(vertex).size() != 4 ||
        level_.GetVertexSharpness(vertex) > 0) {
      return false;
    }
    return std::all_of(faces.begin(), faces.end(), [&](int face) {
      const int corner = level_.GetFaceVertices(face).FindIndex(vertex);
      return is_quad(face) && across_[index(turned(face, corner))] != kNone &&
             across_[index(turned(face, corner + 3))] != kNone;
    });
  }

  Far::TopologyLevel level_;
  const std::vector<Vec3>& points_;
  bool is_chaikin_;
  const std::vector<int>& sets_;
  std::vector<int> across_;  ///< by face and side: the other face and its side there
  std::vector<char> is_flat_;
};

/// For each turned face the number of turned faces to its right, itself included, as long as
/// `joins` holds between neighbours; in a circle the number of turned faces in it.
template <class Joins>
std::vector<int> run_lengths(const Neighbours& neighbours, Joins joins) {
  std::vector<int> lengths(static_cast<std::size_t>(neighbours.turned_face_count()), 0);
  const auto length = [&lengths](int turned_face) -> int& {
    return lengths[static_cast<std::size_t>(turned_face)];
  };
  const auto next = [&](int turned_face) {
    return joins(turned_face) ? neighbours.right(turned_face) : kNone;
  };
  for (int first = 0; first < neighbours.turned_face_count(); ++first) {
    if (length(first) > 0) continue;
    std::vector<int> run = {first};
    int end = next(first);
    for (; end != kNone && end != first && length(end) == 0; end = next(end)) run.push_back(end);
    const bool is_circle = end == first;
    int sum = is_circle ? static_cast<int>(run.size()) : end == kNone ? 0 : length(end);
    for (auto turned_face = run.rbegin(); turned_face != run.rend(); ++turned_face) {
      length(*turned_face) = is_circle ? sum : ++sum;
    }
  }
  return lengths;
}

/// Takes the largest rectangle again and again.
///
/// A queue holds for each turned face an upper bound of the rectangles whose lower left it is.
/// Bounds only fall as faces are taken; so a bound that is reached when it comes to the front is
/// the largest.
class BlockGatherer {
 public:
  explicit BlockGatherer(const Neighbours& neighbours)
      : neighbours_(neighbours),
        row_(run_lengths(neighbours, [](int) { return true; })),
        strip_(run_lengths(neighbours,
                           [&](int turned_face) { return neighbours.is_flat(turned_face); })),
        is_taken_(row_.size() / 4, 0),
        mark_(row_.size() / 4, 0) {}

  std::vector<Block> run() {
    for (int turned_face = 0; turned_face < neighbours_.turned_face_count(); ++turned_face) {
      if (neighbours_.is_usable(face_of(turned_face)))
        push(turned_face, Area{row(turned_face)} * row(rotated(turned_face)));
    }
    std::vector<Block> blocks;
    while (!queue_.empty()) {
      const auto [area, negative] = queue_.top();
      queue_.pop();
      const int turned_face = -negative;
      if (is_taken(turned_face)) continue;
      if (const Area bound = largest_area(turned_face); bound < area) {
        push(turned_face, bound);
        continue;
      }
      Block block = grow(turned_face);
      if (const Area grown = Area{block.columns} * block.rows; grown < area) {
        push(turned_face, grown);
        continue;
      }
      take(block);
      blocks.push_back(std::move(block));
    }
    return blocks;
  }

 private:
  int row(int turned_face) const { return row_[static_cast<std::size_t>(turned_face)]; }
  int strip(int turned_face) const { return strip_[static_cast<std::size_t>(turned_face)]; }
  bool is_taken(int turned_face) const {
    return is_taken_[static_cast<std::size_t>(face_of(turned_face))] != 0;
  }

  /// Of equal areas the first turned face comes first.
  void push(int turned_face, Area area) { queue_.emplace(area, -turned_face); }

  /// The turned face above, if it is free.
  int free_above(int turned_face) const {
    const int above = neighbours_.up(turned_face);
    return above == kNone || is_taken(above) ? kNone : above;
  }

  /// Width of the row that starts at `above`, on one that starts below and has the width given.
  int width_above(int below, int above, int width) const {
    return std::min({width, strip(below), row(above)});
  }

  /// Area of the largest rectangle with a turned face at its lower left, or more where it would
  /// meet itself.
  Area largest_area(int first) const {
    int width = row(first);
    Area rows = 1, area = width;
    int below = first;
    for (int above = free_above(first); above != kNone && above != first;
         above = free_above(below)) {
      width = width_above(below, above, width);
      area = std::max(area, width * ++rows);
      below = above;
    }
    return area;
  }

  Block grow(int first) {
    ++growth_;
    std::vector<std::vector<int>> rows;
    Block best{0, 0, {}};
    int width = row(first);
    for (int start = first; start != kNone; start = free_above(start)) {
      if (!rows.empty()) width = width_above(rows.back().front(), start, width);
      rows.push_back(unmarked_row(start, width));
      width = static_cast<int>(rows.back().size());
      if (width == 0) break;
      const int count = static_cast<int>(rows.size());
      if (width * count > best.columns * best.rows) best = {width, count, {}};
    }
    for (int j = 0; j < best.rows; ++j) {
      for (int i = 0; i < best.columns; ++i) {
        const int turned_face = rows[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)];
        best.faces.push_back({face_of(turned_face), rotation_of(turned_face)});
      }
    }
    return best;
  }

  /// The turned faces of a row up to a face that the growing block already has.
  std::vector<int> unmarked_row(int start, int width) {
    std::vector<int> turned_faces;
    for (int turned_face = start; static_cast<int>(turned_faces.size()) < width;
         turned_face = neighbours_.right(turned_face)) {
      int& mark = mark_[static_cast<std::size_t>(face_of(turned_face))];
      if (mark == growth_) break;
      mark = growth_;
      turned_faces.push_back(turned_face);
    }
    return turned_faces;
  }

  void take(const Block& block) {
    for (const BlockFace& f : block.faces) is_taken_[static_cast<std::size_t>(f.face)] = 1;
    for (const BlockFace& f : block.faces) {
      for (int rotation = 0; rotation < 4; ++rotation) end_rows_at(turned(f.face, rotation));
    }
  }

  void end_rows_at(int taken) {
    int length = 1;
    for (int turned_face = neighbours_.left(taken);
         turned_face != kNone && !is_taken(turned_face) && row(turned_face) > length;
         turned_face = neighbours_.left(turned_face), ++length) {
      row_[static_cast<std::size_t>(turned_face)] = length;
      strip_[static_cast<std::size_t>(turned_face)] = std::min(strip(turned_face), length);
    }
  }

  const Neighbours& neighbours_;
  std::vector<int> row_;    ///< by turned face: free turned faces to the right, itself included
  std::vector<int> strip_;  ///< of them, those over which a second row fits
  std::vector<char> is_taken_;
  std::vector<int> mark_;  ///< by face: the growth that has last come to it
  int growth_ = 0;
  std::priority_queue<std::pair<Area, int>> queue_;
};

}  // namespace

int first_face(const Block& block) {
  return std::min_element(block.faces.begin(), block.faces.end(),
                          [](const BlockFace& a, const BlockFace& b) { return a.face < b.face; })
      ->face;
}

std::vector<Block> gather_blocks(const Far::TopologyRefiner& refiner, const std::vector<int>& sets,
                                 const std::vector<Vec3>& points) {
  const Neighbours neighbours(refiner, sets, points);
  std::vector<Block> blocks = BlockGatherer(neighbours).run();
  std::sort(blocks.begin(), blocks.end(),
            [](const Block& a, const Block& b) { return first_face(a) < first_face(b); });
  return blocks;
}

std::vector<Block> single_faces(const std::vector<int>& sets) {
  std::vector<Block> blocks;
  for (std::size_t f = 0; f < sets.size(); ++f) {
    if (sets[f] >= 0) blocks.push_back({1, 1, {{static_cast<int>(f), 0}}});
  }
  return blocks;
}

}  // namespace surfmesh
