// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/triangulate_polygon.hh"

#include <Eigen/Geometry>
#include <cstddef>

namespace surfmesh {
namespace {

/// Twice the vector area.
Vec3 area_vector(const std::vector<Vec3>& corners) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 2; i < corners.size(); ++i) {
    sum += (corners[i - 1] - corners[0]).cross(corners[i] - corners[0]);
  }
  return sum;
}

/// The polygon that is left, as indices of its corners.
class Clipping {
 public:
  explicit Clipping(const std::vector<Vec3>& corners)
      : corners_(corners), normal_(area_vector(corners)) {
    for (std::size_t i = 0; i < corners.size(); ++i) rest_.push_back(static_cast<int>(i));
  }

  std::vector<std::array<int, 3>> run() {
    std::vector<std::array<int, 3>> triangles;
    while (rest_.size() > 3) {
      const std::size_t ear = best_ear();
      triangles.push_back({at(ear + rest_.size() - 1), at(ear), at(ear + 1)});
      rest_.erase(rest_.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    triangles.push_back({rest_[0], rest_[1], rest_[2]});
    return triangles;
  }

 private:
  int at(std::size_t i) const { return rest_[i % rest_.size()]; }
  const Vec3& point(int corner) const { return corners_[static_cast<std::size_t>(corner)]; }

  double turn(const Vec3& a, const Vec3& b, const Vec3& c) const {
    return (b - a).cross(c - a).dot(normal_);
  }

  bool is_ear(std::size_t i) const {
    const int before = at(i + rest_.size() - 1), tip = at(i), after = at(i + 1);
    const Vec3 &a = point(before), &b = point(tip), &c = point(after);
    if (!(turn(a, b, c) > 0)) return false;
    for (const int other : rest_) {
      if (other == before || other == tip || other == after) continue;
      const Vec3& p = point(other);
      if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
    }
    return true;
  }

  std::size_t best_ear() const {
    std::size_t best = 1;  // of a fan
    double shortest = -1;
    for (std::size_t i = 0; i < rest_.size(); ++i) {
      if (!is_ear(i)) continue;
      const double cut = (point(at(i + 1)) - point(at(i + rest_.size() - 1))).squaredNorm();
      if (shortest >= 0 && cut >= shortest) continue;
      shortest = cut;
      best = i;
    }
    return best;
  }

  const std::vector<Vec3>& corners_;
  Vec3 normal_;
  std::vector<int> rest_;
};

}  // namespace

std::vector<std::array<int, 3>> triangulate_polygon(const std::vector<Vec3>& corners) {
  if (corners.size() < 3) return {};
  return Clipping(corners).run();
}

}  // namespace surfmesh
