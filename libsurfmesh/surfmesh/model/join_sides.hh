// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "surfmesh/core/length.hh"
#include "surfmesh/geometry/curve.hh"
#include "surfmesh/model/model.hh"

namespace surfmesh {

/// A named surface that becomes a patch: its whole domain rectangle, or the part inside its loops.
struct PatchInput {
  std::string name = {};
  std::shared_ptr<const Surface> surface = {};
  /// Names of contours and sides end to end, with `-` before one that is traversed backwards. The
  /// domain lies on the left of the outer loop and of the holes. Empty for the whole domain.
  std::vector<std::vector<std::string>> loops = {};
  std::string origin = {};  ///< where it is defined (a JSON pointer), for messages; may be empty
};

/// A named curve that loops can list.
struct ContourInput {
  /// The contour on one patch.
  struct On {
    std::string patch = {};
    std::shared_ptr<const Curve> curve = nullptr;  ///< over t in [0,1]; null: found by projection
  };

  std::string name = {};
  /// Null if the first curve of `on` defines the contour.
  std::shared_ptr<const SpaceCurve> xyz = nullptr;
  std::vector<On> on = {};
  CurveRange range = {};    ///< for messages
  std::string origin = {};  ///< where it is defined (a JSON pointer), for messages; may be empty
  /// As Contour::breaks, of the curve that defines the contour.
  std::vector<double> breaks = {};
};

/// Sides that are meant to coincide do so up to the rounding of formulas: it is far above that, and
/// far below any element.
inline constexpr double kJoiningShare = 1e-9;  ///< of the diagonal

/// Which places of sides are one place.
struct JoinOptions {
  /// Sides nearer than this are joined; above 0, at most 1 % of the diagonal. Where coordinates are
  /// rounded to more, it is that.
  Length joining = Length::share(kJoiningShare);
};

namespace ranges {

inline constexpr LengthRange kJoining = {"joining"};

}  // namespace ranges

/// Make a model of patches: find which of their sides coincide in space, and trim them by loops.
///
/// The sides of a patch are `<patch>:v0`, `:u1`, `:v1`, `:u0`, each in the direction of the growing
/// parameter. Sides, and parts of sides, that coincide up to `joining` become one contour. They may
/// be parametrised at any speed, run in either direction, belong to one patch (a seam) or to any
/// number of patches. A side that is a single point in space becomes one vertex and a degenerate
/// contour of its own. A contour has the direction of its first use, in the order of the patches
/// and, within a patch, of the sides as listed above. Its name is that of the first whole side
/// among its uses, otherwise that of its first use with the number of the part: `left:u1#0`.
///
/// Between two vertices, sides are joined whole or not at all:
/// 1. Ends of sides no farther apart than `joining` are one vertex.
/// 2. A vertex no farther than `joining` from a side divides it, unless it is another place than an
///    end of that side, or than a vertex before, and within about four `joining` of it along the
///    side. So no part is that short but a side that is so as a whole.
/// 3. Parts with the same vertices are one contour if no sample of either is farther than `joining`
///    from the other; two of one patch that are as short as the lengths below only if they are
///    whole sides.
///
/// What is nearly so is not joined, but told. Model::notices has a shortfall for sides that run
/// along each other within 1e-4 of the diagonal or ten `joining`, and for ends of sides that leave
/// a part between them that is shorter than that and than 1 % of each of its sides. It gives a
/// `joining` that joins them, if trials on the patches around find one.
///
/// A patch with loops has the sides and contours that its loops name. A contour is shared by all
/// patches whose loops name it; so is a side of another patch. If its (u,v) on a patch is not
/// given, it is found by projection. Contours are not compared with sides or other contours: to
/// join patches along one, use one name. A patch that has a contour twice (a seam) lists it twice
/// in `on`, in the order of its loops. A contour with kinks inside becomes one between each two of
/// them: `hole#0`, `hole#1`, ... Contours that are one point in space (at a pole) are degenerate.
/// The largest loop is the outer one. Some faults are corrected, with a warning: a loop that runs
/// the wrong way round is reversed; a contour that no loop names is left out.
///
/// Formula surfaces are searched for jumps, each of which adds a notice, and for points where they
/// run to infinity (check_breaks). Other surfaces are not.
///
/// The end of a contour within `joining` of a vertex is that vertex. Ends that follow
/// each other in a loop are joined up to 1e-6, which is also how far a contour may be from a patch.
///
/// Error    coincidence is tested at 33 points of each side, unevenly spaced; ends are merged
///          transitively. Far from the origin, the tolerance is at least a few roundings of the
///          coordinates
/// Cost     O(n log n) for n sides of bounded length, about 1,000 evaluations per patch, 1,300
///          where speeds differ, some ten thousands more for each of the first 20 near misses
/// Throws   InvalidOption; InvalidInput for no patches, a name used twice, a missing surface, a
///          domain that is not a rectangle, a loop that names an unknown contour or the same use
///          twice; Geometry for a patch that is a point or a line or runs to infinity, a contour
///          that jumps, is off its patch or differs between patches, a loop that does not close,
///          leaves the domain, crosses itself or another, or is where no hole can be. All name the
///          patch or the contour, and gaps and (u,v) if there are any
Model model_from_patches(const std::vector<PatchInput>& patches,
                         const std::vector<ContourInput>& contours = {},
                         const JoinOptions& options = {});

/// The contour uses that make up a side, in the direction of its growing parameter.
///
/// The side is given by its name, as in `wing:u0`. If the curve of an entry runs against the
/// growing parameter, curve(0) is its far end.
///
/// Cost     O(contour uses of the model)
/// Throws   InvalidInput if there is no such patch or side
std::vector<LoopEntry> side_uses(const Model& model, std::string_view side_name);

}  // namespace surfmesh
