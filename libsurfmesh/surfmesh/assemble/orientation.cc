// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/orientation.hh"

#include <algorithm>
#include <cstddef>

#include "surfmesh/model/joined_uses.hh"

namespace surfmesh {
namespace {

constexpr char kUnknown = 2;

/// Where a patch is joined to another one.
struct Joint {
  int neighbour = -1;
  bool is_alike =
      true;  ///< both are oriented alike as they are: each has the contour on its other side
};

Joint joint_of(const Contour& contour, const UsePair& pair, std::size_t side) {
  const ContourUse& own = contour.uses[static_cast<std::size_t>(pair[side])];
  const ContourUse& other = contour.uses[static_cast<std::size_t>(pair[1 - side])];
  return {other.patch, own.is_forward != other.is_forward};
}

/// By patch.
std::vector<std::vector<Joint>> joints_of(const Model& model,
                                          const std::vector<std::vector<UsePair>>& joined) {
  std::vector<std::vector<Joint>> joints(model.patches.size());
  for (std::size_t c = 0; c < model.contours.size(); ++c) {
    const Contour& contour = model.contours[c];
    for (const UsePair& pair : joined[c]) {
      for (const std::size_t side : {0u, 1u}) {
        const int patch = contour.uses[static_cast<std::size_t>(pair[side])].patch;
        joints[static_cast<std::size_t>(patch)].push_back(joint_of(contour, pair, side));
      }
    }
  }
  return joints;
}

/// Orient what is joined to a patch like it.
/// Returns  the patches of this component
std::vector<int> spread(const std::vector<std::vector<Joint>>& joints, int first,
                        std::vector<char>& is_turned) {
  // Nearest first: what cannot be oriented is cut where the two ways around it meet, not along the
  // path of a search that goes on and on in one direction.
  std::vector<int> reached = {first};
  is_turned[static_cast<std::size_t>(first)] = 0;
  for (std::size_t next = 0; next < reached.size(); ++next) {
    const auto patch = static_cast<std::size_t>(reached[next]);
    const char here = is_turned[patch];
    for (const Joint& joint : joints[patch]) {
      char& there = is_turned[static_cast<std::size_t>(joint.neighbour)];
      if (there != kUnknown) continue;
      there = joint.is_alike ? here : static_cast<char>(1 - here);
      reached.push_back(joint.neighbour);
    }
  }
  return reached;
}

/// True if patches are marked as reversed, and most marks are against the orientation.
bool is_against_marks(const Model& model, const std::vector<int>& component,
                      const std::vector<char>& is_turned) {
  std::size_t marks = 0, against = 0;
  for (const int patch : component) {
    const bool is_reversed = model.patch(patch).is_reversed;
    marks += is_reversed ? 1 : 0;
    against += is_reversed != (is_turned[static_cast<std::size_t>(patch)] != 0) ? 1 : 0;
  }
  return marks > 0 && 2 * against > component.size();
}

}  // namespace

PatchOrientation orient_patches(const Model& model) {
  const std::vector<std::vector<UsePair>> joined = joined_uses(model);
  const std::vector<std::vector<Joint>> joints = joints_of(model, joined);
  PatchOrientation result;
  result.is_turned.assign(model.patches.size(), kUnknown);
  for (std::size_t first = 0; first < model.patches.size(); ++first) {
    if (result.is_turned[first] != kUnknown) continue;
    const std::vector<int> component = spread(joints, static_cast<int>(first), result.is_turned);
    if (!is_against_marks(model, component, result.is_turned)) continue;
    for (const int patch : component) {
      char& is_turned = result.is_turned[static_cast<std::size_t>(patch)];
      is_turned = static_cast<char>(1 - is_turned);
    }
  }
  const auto is_torn = [&](const Contour& contour, const UsePair& pair) {
    const auto turned = [&](int use) {
      return result
          .is_turned[static_cast<std::size_t>(contour.uses[static_cast<std::size_t>(use)].patch)];
    };
    return (turned(pair[0]) == turned(pair[1])) != joint_of(contour, pair, 0).is_alike;
  };
  for (std::size_t c = 0; c < model.contours.size(); ++c) {
    const bool is_cut = std::any_of(joined[c].begin(), joined[c].end(), [&](const UsePair& pair) {
      return is_torn(model.contours[c], pair);
    });
    if (is_cut) result.cut_contours.push_back(static_cast<int>(c));
  }
  return result;
}

}  // namespace surfmesh
