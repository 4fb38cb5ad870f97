// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "surfmesh/control/control_space.hh"
#include "surfmesh/core/run_context.hh"
#include "surfmesh/model/model.hh"

namespace surfmesh {

/// A piece of a patch with one size.
struct SizedPiece {
  double area;  ///< in space
  double l_s;   ///< lengths of the size, model units
  double l_t;
};

/// A piece of a boundary, with the size along it.
struct SizedChord {
  double length;
  double size;
};

/// The pieces of one patch and of its contours.
struct SizedPatch {
  std::vector<SizedPiece> pieces;
  std::vector<std::vector<SizedChord>> contours = {};
};

/// How many triangles the mesh of a model will have, from its sizes alone.
class TriangleEstimate {
 public:
  /// Sizes below `bounded_from` are those around tubes, to which hmin does not apply.
  explicit TriangleEstimate(std::vector<SizedPatch> patches, double bounded_from = 0)
      : patches_(std::move(patches)), bounded_from_(bounded_from) {}

  /// Triangles of unit edges that fill the metric area of a patch, and at least those that its
  /// boundary needs; summed over the patches.
  double triangles() const { return triangles_with(0); }

  /// The same by patch.
  std::vector<double> triangles_of_patches() const;

  /// The same if no size were below `hmin`, in model units, but those around tubes.
  double triangles_with(double hmin) const;

  /// The least hmin with which there are at most so many triangles, to within 1 %; nothing where no
  /// hmin has so few.
  std::optional<double> fitting_hmin(double triangles) const;

 private:
  double triangles_of(const SizedPatch& patch, double hmin) const;

  std::vector<SizedPatch> patches_;
  double bounded_from_;
};

/// Estimate from the control spaces of all patches, inside their loops; `hmin` is that of the
/// sizes.
///
/// Error    1 to 5 % too few for everyday models; more for those of a few triangles and for tubes
///          of four elements around (test TriangleEstimate.*)
/// Cost     50 ns a control node; in trimmed patches also some µs a chord of the loops
/// Throws   Cancelled
TriangleEstimate estimate_triangles(const Model& model,
                                    const std::vector<std::unique_ptr<ControlSpace>>& spaces,
                                    double hmin = 0, const RunContext& context = RunContext());

}  // namespace surfmesh
