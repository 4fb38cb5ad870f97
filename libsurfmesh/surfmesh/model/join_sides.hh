// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "surfmesh/geometry/curve.hh"
#include "surfmesh/model/model.hh"

namespace surfmesh {

/// A named surface that becomes a patch: its whole domain rectangle, or what its loops enclose.
struct PatchInput {
  std::string name;
  std::shared_ptr<const Surface> surface;
  /// Names of contours and sides end to end, `-` before one that is run through against its
  /// direction; the domain lies on the left of the outer loop and of the holes. None for the whole
  /// domain.
  std::vector<std::vector<std::string>> loops = {};
  std::string origin = {};  ///< where it is written (a JSON pointer), for messages; may be empty
};

/// A named curve that loops may list.
struct ContourInput {
  /// The contour on one patch.
  struct On {
    std::string patch;
    std::shared_ptr<const Curve> curve = nullptr;  ///< over t in [0,1]; none if it is to be found
  };

  std::string name;
  /// None if the first curve of `on` gives the contour.
  std::shared_ptr<const SpaceCurve> xyz = nullptr;
  std::vector<On> on = {};
  CurveRange range = {};    ///< for messages
  std::string origin = {};  ///< where it is written (a JSON pointer), for messages; may be empty
};

/// Make a model of patches: find which of their sides coincide in space, and trim them by loops.
///
/// The sides of a patch are `<patch>:v0`, `:u1`, `:v1`, `:u0`, each in the direction of the growing
/// parameter. Sides, and parts of sides, that coincide to 1e-9 of the model's diagonal become one
/// contour, at any speed of parameter, in either direction, also two sides of one patch (a seam)
/// and any number of patches. A side is divided where an end of another side lies on it. A side
/// that is a single point in space becomes one vertex, and a degenerate contour of its own.
/// A contour has the direction of its first use, in the order of patches and, in a patch, of the
/// sides as listed above; it is named after the first whole side among its uses, else after its
/// first use with the number of the part: `left:u1#0`.
/// Sides that come within 1e-4 of the diagonal but do not coincide are not joined; Model::notices
/// tells their gap.
///
/// A patch with loops has the sides that these name, and contours. A contour is shared by all the
/// patches whose loops name it, also a side of another patch; where its (u,v) on a patch is not
/// given it is found by projection. It is not compared with sides or other contours: those that
/// are to be joined have to have one name. A patch that has a contour twice (a seam) lists it twice
/// in `on`, in the order of its loops. Contours that are one point in space (at a pole) are
/// degenerate. The largest loop is the outer one. What can be mended is, with a warning: a loop
/// that runs the wrong way round is turned; a contour that no loop names is left out.
///
/// Ends of contours within 1e-9 of the diagonal of a vertex are that vertex; those that follow each
/// other in a loop are joined up to 1e-6, which is also how far a contour may be from a patch.
///
/// Error    coincidence is tested at 33 places of each side, unevenly spread; ends are merged
///          transitively. Far from the origin the tolerance is not below a few roundings of the
///          coordinates
/// Cost     O(n log n) for n sides of bounded length, about 1,000 evaluations a patch,
///          1,300 where speeds differ, some thousands more for a near miss
/// Throws   InvalidInput for no patches, a name used twice, a missing surface, a domain that is not
///          a rectangle, a loop that names a contour that does not exist or twice the same use;
///          Geometry for a patch that is a point or a line, a contour that is off its patch or
///          differs between patches, a loop that does not close, leaves the domain, crosses itself
///          or another, or is not where a hole can be. All name the patch or the contour, and gaps
///          and (u,v) where there are any
Model model_from_patches(const std::vector<PatchInput>& patches,
                         const std::vector<ContourInput>& contours = {});

/// The contour uses that make up a side, in the direction of its growing parameter.
///
/// The side is given by its name, as in `wing:u0`; on entries whose curve runs against the growing
/// parameter, curve(0) is the far end.
///
/// Cost     O(contour uses of the model)
/// Throws   InvalidInput if there is no such patch or side
std::vector<LoopEntry> side_uses(const Model& model, std::string_view side_name);

}  // namespace surfmesh
