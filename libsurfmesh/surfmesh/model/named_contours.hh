// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "surfmesh/geometry/curve.hh"
#include "surfmesh/model/join_sides.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/model/point_cells.hh"

namespace surfmesh {

/// Distances of contours, in model units.
struct ContourLengths {
  double join = 0;   ///< points this near are one point
  double reach = 0;  ///< a contour is nearer than this to its patches and to the next one in a loop
};

/// The numbers of patches by their names.
using PatchNumbers = std::map<std::string, int, std::less<>>;

PatchNumbers patch_numbers(const std::vector<PatchInput>& patches);

/// The curve of a contour in space: its own, or that of the first curve on a patch.
///
/// Pre      the contour has a curve, and the patches that it names are there
std::shared_ptr<const SpaceCurve> curve_in_space(const ContourInput& contour,
                                                 const std::vector<PatchInput>& patches,
                                                 const PatchNumbers& patch_numbers);

/// Adds contours to a model, and finds their curves on the patches that use them.
class NamedContours {
 public:
  /// `patches` are the inputs of those of the model, `patch_numbers` their numbers.
  NamedContours(Model& model, const std::vector<PatchInput>& patches,
                const PatchNumbers& patch_numbers, const ContourLengths& lengths);

  /// The contour of the model that an input makes; made when it is first asked for.
  int contour_of(const ContourInput& input);

  /// A contour is nearer than this to its patches, model units.
  double reach() const { return lengths_.reach; }

  bool has(const ContourInput& input) const { return indices_.contains(&input); }

  /// The range of a contour's parameter as the input gives it.
  const CurveRange& range(int contour) const { return origin(contour).range; }

  /// Let a contour that sides make lie in space where this use of it does, if that is not set.
  void lie_along(const LoopEntry& entry);

  /// Add a use of a contour by a patch, whose curve is found by projection if none is given.
  ///
  /// `location` names both, for messages.
  /// Returns  the use
  /// Throws   Geometry if the curve is elsewhere than the contour, or cannot be found
  int add_use(int contour, int patch, std::shared_ptr<const Curve> curve,
              const std::string& location);

 private:
  /// What is known of a contour that is in the model.
  struct Origin {
    std::shared_ptr<const SpaceCurve> xyz;
    CurveRange range;
  };

  Origin& origin(int contour) { return origins_[static_cast<std::size_t>(contour)]; }
  const Origin& origin(int contour) const { return origins_[static_cast<std::size_t>(contour)]; }
  int vertex_at(const Vec3& point);
  std::shared_ptr<const Curve> project(int contour, int patch, const std::string& location) const;
  bool is_same_speed(int contour, const ContourUse& use) const;
  void check_same_point(int contour, const ContourUse& use, const std::string& location) const;

  Model& model_;
  const std::vector<PatchInput>& patches_;
  const PatchNumbers& patch_numbers_;
  ContourLengths lengths_;
  PointCells points_;                           ///< of the vertices of the model
  std::map<const ContourInput*, int> indices_;  ///< of contours that are in the model
  std::vector<Origin> origins_;                 ///< by contour of the model
};

}  // namespace surfmesh
