// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/face_weights.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

using CornerWeights = std::vector<double>;

/// Bilinear weights of the corners (0,0), (1,0), (1,1), (0,1).
std::array<double, 4> bilinear(Uv uv) {
  return {(1 - uv.u) * (1 - uv.v), uv.u * (1 - uv.v), uv.u * uv.v, (1 - uv.u) * uv.v};
}

void share_quarter(const std::vector<int>& kept, int part, Uv uv, CornerWeights& weights) {
  const auto corner = std::lower_bound(kept.begin(), kept.end(), part);
  const std::size_t n = kept.size();
  const auto k = static_cast<std::size_t>(corner - kept.begin()) % n;
  const auto weight = [&](std::size_t i) -> double& {
    return weights[static_cast<std::size_t>(kept[i % n])];
  };
  const auto [at_corner, after, in_middle, before] = bilinear(uv);
  weight(k) += at_corner + (after + before) / 2;
  weight(k + 1) += after / 2;
  weight(k + n - 1) += before / 2;
  for (std::size_t i = 0; i < n; ++i) weight(i) += in_middle / static_cast<double>(n);
}

void share_whole(const std::vector<int>& kept, Uv uv, CornerWeights& weights) {
  if (kept.size() == 3) {
    weights[static_cast<std::size_t>(kept[0])] = 1 - uv.u - uv.v;
    weights[static_cast<std::size_t>(kept[1])] = uv.u;
    weights[static_cast<std::size_t>(kept[2])] = uv.v;
    return;
  }
  const std::array<double, 4> shares = bilinear(uv);
  for (std::size_t i = 0; i < 4; ++i) weights[static_cast<std::size_t>(kept[i])] = shares[i];
}

/// Throws   InvalidInput
void check_place(const Cage& cage, const CagePlace& place) {
  const auto fail = [&](const char* what) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("part {} of face {} at ({}, {}): {}", place.part, place.face,
                            place.uv.u, place.uv.v, what));
  };
  if (place.face < 0 || static_cast<std::size_t>(place.face) >= cage.faces.size()) {
    fail("the cage has no such face");
  }
  const auto size = static_cast<int>(cage.faces[static_cast<std::size_t>(place.face)].size());
  if (place.corners < 3 || place.corners > size || place.part >= size) {
    fail("the face has not so many corners");
  }
  if (place.part < 0 && place.corners > 4) fail("only quarters of a polygon have places");
}

}  // namespace

std::vector<int> kept_corners(const Cage& cage, int face, int count) {
  const std::vector<int>& vertices = cage.faces[static_cast<std::size_t>(face)];
  const std::size_t n = vertices.size();
  std::vector<int> kept(n);
  std::iota(kept.begin(), kept.end(), 0);
  const auto after = [&](int corner) {
    return vertices[(static_cast<std::size_t>(corner) + 1) % n];
  };
  const auto side = [&](int corner) {
    const int from = vertices[static_cast<std::size_t>(corner)], to = after(corner);
    if (from == to) return -1.0;
    return (cage.points[static_cast<std::size_t>(to)] - cage.points[static_cast<std::size_t>(from)])
        .norm();
  };
  while (static_cast<int>(kept.size()) > count) {
    kept.erase(std::min_element(kept.begin(), kept.end(),
                                [&](int a, int b) { return side(a) < side(b); }));
  }
  return kept;
}

std::vector<double> face_weights(const Cage& cage, const CagePlace& place) {
  check_place(cage, place);
  const std::vector<int> kept = kept_corners(cage, place.face, place.corners);
  CornerWeights weights(cage.faces[static_cast<std::size_t>(place.face)].size(), 0);
  if (place.part >= 0) {
    share_quarter(kept, place.part, place.uv, weights);
  } else {
    share_whole(kept, place.uv, weights);
  }
  return weights;
}

}  // namespace surfmesh
