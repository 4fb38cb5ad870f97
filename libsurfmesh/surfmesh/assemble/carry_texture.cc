// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/carry_texture.hh"

#include <algorithm>
#include <cmath>

#include "surfmesh/assemble/result_places.hh"

namespace surfmesh {
namespace {

/// The mean of what the corners of a face have; unset if one of them that counts has nothing.
Uv texture_at(const CageShares& shares) {
  if (shares.cage == nullptr || shares.cage->texture.faces.empty()) return {};
  const Cage::Texture& texture = shares.cage->texture;
  const std::vector<int>& corners = texture.faces[static_cast<std::size_t>(shares.face)];
  if (corners.size() != shares.weights.size()) return {};
  Uv sum{0, 0};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (shares.weights[i] == 0) continue;
    if (corners[i] < 0) return {};
    sum = sum + shares.weights[i] * texture.points[static_cast<std::size_t>(corners[i])];
  }
  return sum;
}

/// True if a cage of the model has texture coordinates.
bool has_texture(const Model& model) {
  return std::any_of(model.patches.begin(), model.patches.end(), [](const Patch& patch) {
    return patch.cage != nullptr && !patch.cage->texture.faces.empty();
  });
}

}  // namespace

std::size_t carry_texture(const Model& model, PolyMesh& result) {
  if (!has_texture(model)) return 0;
  const ResultPlaces places(result, model);
  detach(result, keys::corner_texture);
  const auto texture_of = attach(result, keys::corner_texture);
  std::size_t count = 0;
  for (const FaceHandle face : result.faces()) {
    bool is_whole = true;
    for (const HalfedgeHandle corner : result.fh_range(face)) {
      const Uv texture = texture_at(places.of_corner(corner));
      is_whole &= std::isfinite(texture.u) && std::isfinite(texture.v);
      result.property(texture_of, corner) = texture;
    }
    if (is_whole) {
      ++count;
      continue;
    }
    for (const HalfedgeHandle corner : result.fh_range(face)) {
      result.property(texture_of, corner) = Uv();
    }
  }
  return count;
}

}  // namespace surfmesh
