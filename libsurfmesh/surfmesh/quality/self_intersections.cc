// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/self_intersections.hh"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "surfmesh/core/notice.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/geometry/box_tree.hh"
#include "surfmesh/geometry/predicates.hh"
#include "surfmesh/quality/patch_text.hh"

namespace surfmesh {
namespace {

constexpr std::size_t kFacesBetweenCancellation = 256;

using Points = std::array<Vec3, 3>;
using Signs = std::array<int, 3>;

/// Where the corners of a triangle lie: above (1), in, or below (-1) the plane of another one.
Signs sides_of(const Points& plane, const Points& triangle) {
  Signs signs{};
  for (std::size_t i = 0; i < 3; ++i) {
    signs[i] = orient3d(plane[0], plane[1], plane[2], triangle[i]);
  }
  return signs;
}

bool is_in_plane(const Signs& signs) { return signs == Signs{0, 0, 0}; }

bool is_on_one_side(const Signs& signs) {
  return *std::min_element(signs.begin(), signs.end()) > 0 ||
         *std::max_element(signs.begin(), signs.end()) < 0;
}

bool has_side_in_plane(const Signs& signs) {
  return std::count(signs.begin(), signs.end(), 0) == 2;
}

/// True if a triangle has one corner in a plane, and the others on one side of it.
bool touches_in_a_point(const Signs& signs) {
  const int sum = signs[0] + signs[1] + signs[2];
  return std::count(signs.begin(), signs.end(), 0) == 1 && sum != 0;
}

/// A projection onto the plane across an axis keeps which points are on one line, and is exact.
Uv projected(const Vec3& p, Eigen::Index axis) { return {p[(axis + 1) % 3], p[(axis + 2) % 3]}; }

/// Two triangles as seen along an axis, each counter-clockwise unless it is seen from the edge.
class Projection {
 public:
  Projection(const Points& a, const Points& b, Eigen::Index axis)
      : a_(turned(a, axis)), b_(turned(b, axis)) {}

  /// True if a side of one triangle has the other one beyond it. What they have in common is then
  /// part of a side of both.
  bool is_separated() const { return separates(a_, b_) || separates(b_, a_); }

 private:
  using Corners = std::array<Uv, 3>;

  static Corners turned(const Points& triangle, Eigen::Index axis) {
    Corners corners{};
    for (std::size_t i = 0; i < 3; ++i) corners[i] = projected(triangle[i], axis);
    if (orient2d(corners[0], corners[1], corners[2]) < 0) std::swap(corners[1], corners[2]);
    return corners;
  }

  static bool separates(const Corners& a, const Corners& b) {
    if (orient2d(a[0], a[1], a[2]) == 0) return false;
    for (std::size_t i = 0; i < 3; ++i) {
      bool is_beyond = false, is_before = false;
      for (const Uv p : b) {
        const int side = orient2d(a[i], a[(i + 1) % 3], p);
        is_beyond |= side < 0;
        is_before |= side > 0;
      }
      if (is_beyond && !is_before) return true;
    }
    return false;
  }

  Corners a_;
  Corners b_;
};

Vec3 normal_of(const Points& t) { return (t[1] - t[0]).cross(t[2] - t[0]); }

/// The axis along which a triangle is seen best.
Eigen::Index axis_of(const Points& triangle) {
  Eigen::Index axis = 0;
  normal_of(triangle).cwiseAbs().maxCoeff(&axis);
  return axis;
}

/// True if a triangle has no area, exactly, or is not finite.
bool is_degenerate(const Points& t) {
  if (!t[0].allFinite() || !t[1].allFinite() || !t[2].allFinite()) return true;
  const Eigen::Index first = axis_of(t);
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Eigen::Index axis = (first + k) % 3;
    const auto at = [&](std::size_t i) { return projected(t[i], axis); };
    if (orient2d(at(0), at(1), at(2)) != 0) return false;
  }
  return true;
}

/// The triangle begun at the corner that is alone on its side of a plane; its sign goes with it.
std::pair<Points, int> with_lone_corner_first(const Points& t, const Signs& signs) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    if (signs[i] != 0 && signs[j] != signs[i] && signs[k] != signs[i]) {
      return {{t[i], t[j], t[k]}, signs[i]};
    }
  }
  return {t, 0};
}

/// True if the pieces that two triangles cut out of the line in which their planes meet overlap in
/// more than a point. Each triangle has a corner alone on its side.
/// Source   Guigue, Devillers, Fast and robust triangle-triangle overlap test using orientation
///          predicates (2003), section 3
bool pieces_overlap(const Points& a, const Signs& sides_a, const Points& b, const Signs& sides_b) {
  auto [p, side_p] = with_lone_corner_first(a, sides_a);
  auto [q, side_q] = with_lone_corner_first(b, sides_b);
  // Both lone corners come above the other plane: turning a triangle turns its plane over.
  if (side_p < 0) std::swap(q[1], q[2]);
  if (side_q < 0) std::swap(p[1], p[2]);
  return orient3d(p[0], p[1], q[0], q[1]) < 0 && orient3d(p[0], p[2], q[2], q[0]) < 0;
}

bool pass_through_in_space(const Points& a, const Points& b) {
  const Signs sides_a = sides_of(b, a);
  if (is_on_one_side(sides_a) || touches_in_a_point(sides_a)) return false;
  // In one plane, what no side separates overlaps.
  if (is_in_plane(sides_a)) return !Projection(a, b, axis_of(a)).is_separated();
  const Signs sides_b = sides_of(a, b);
  if (is_on_one_side(sides_b) || touches_in_a_point(sides_b)) return false;
  if (has_side_in_plane(sides_a) && has_side_in_plane(sides_b)) return false;
  return pieces_overlap(a, sides_a, b, sides_b);
}

/// Empty for a triangle without area, which so meets none.
BoxTree::Box box_of(const Points& triangle) {
  BoxTree::Box box;
  if (is_degenerate(triangle)) return box;
  for (const Vec3& p : triangle) box.extend(p);
  return box;
}

bool pass_through_with_area(const Points& a, const Points& b) {
  return !Projection(a, b, axis_of(a)).is_separated() && pass_through_in_space(a, b);
}

/// The triangles of the fans of all faces, with a tree of their boxes.
class TriangleSearch {
 public:
  explicit TriangleSearch(const MeshArrays& set) {
    for (std::size_t f = 0; f < set.faces.size(); ++f) add_fan(set, f);
    first_.push_back(triangles_.size());
    boxes_.reserve(triangles_.size());
    for (const Points& triangle : triangles_) boxes_.push_back(box_of(triangle));
    tree_ = std::make_unique<BoxTree>(boxes_);
  }

  std::size_t face_count() const { return first_.size() - 1; }

  /// The faces after this one that pass through it, ascending.
  std::vector<std::size_t> partners_of(std::size_t face) const {
    std::vector<std::size_t> partners;
    for (std::size_t t = first_[face]; t < first_[face + 1]; ++t) {
      tree_->visit(boxes_[t], [&](std::size_t other) {
        if (face_of_[other] > face && pass_through_with_area(triangles_[t], triangles_[other])) {
          partners.push_back(face_of_[other]);
        }
      });
    }
    std::sort(partners.begin(), partners.end());
    partners.erase(std::unique(partners.begin(), partners.end()), partners.end());
    return partners;
  }

  /// A point near which two faces meet: the middle of what their boxes have in common.
  Vec3 place_of(std::size_t face, std::size_t partner) const {
    return box_of_face(face).intersection(box_of_face(partner)).center();
  }

 private:
  void add_fan(const MeshArrays& set, std::size_t face) {
    first_.push_back(triangles_.size());
    const auto vertices = set.faces[face];
    const auto point = [&](std::size_t k) {
      return set.points[static_cast<std::size_t>(vertices[k])];
    };
    for (std::size_t k = 2; k < vertices.size(); ++k) {
      triangles_.push_back({point(0), point(k - 1), point(k)});
      face_of_.push_back(face);
    }
  }

  BoxTree::Box box_of_face(std::size_t face) const {
    BoxTree::Box box;
    for (std::size_t t = first_[face]; t < first_[face + 1]; ++t) box.extend(boxes_[t]);
    return box;
  }

  std::vector<std::size_t> first_;  ///< triangle of each face, and the end
  std::vector<Points> triangles_;
  std::vector<std::size_t> face_of_;
  std::vector<BoxTree::Box> boxes_;
  std::unique_ptr<BoxTree> tree_;
};

/// What was found among the faces of a range: how many pairs, and the first of them.
struct Found {
  std::size_t count = 0;
  std::vector<std::pair<std::size_t, std::size_t>> first;
};

/// By the first face of each range of share_ranges.
std::map<std::size_t, Found> find_by_ranges(const TriangleSearch& search,
                                            const RunContext& context) {
  std::map<std::size_t, Found> found;
  std::mutex mutex;
  share_ranges(search.face_count(), [&](std::size_t first, std::size_t end) {
    Found own;
    for (std::size_t f = first; f < end; ++f) {
      if (f % kFacesBetweenCancellation == 0) context.throw_if_cancelled();
      for (const std::size_t partner : search.partners_of(f)) {
        if (own.count++ < MeshFault::kMostPlaces) own.first.emplace_back(f, partner);
      }
    }
    const std::lock_guard lock(mutex);
    found[first] = std::move(own);
  });
  return found;
}

}  // namespace

bool pass_through(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b) {
  return !is_degenerate(a) && !is_degenerate(b) && pass_through_with_area(a, b);
}

MeshFault find_self_intersections(const MeshArrays& set, const RunContext& context) {
  const TriangleSearch search(set);
  MeshFault result{"self_intersection", 0, {}};
  for (const auto& [range, found] : find_by_ranges(search, context)) {
    for (const auto& [face, partner] : found.first) {
      result.add([&, face = face, partner = partner] {  // clang 14 captures no bindings
        return fmt::format("faces {}{} and {}{} near {}", face, detail::patch_text(set, face),
                           partner, detail::patch_text(set, partner),
                           point_text(search.place_of(face, partner)));
      });
    }
    result.count += found.count - found.first.size();
  }
  return result;
}

}  // namespace surfmesh
