// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "surfmesh/geometry/model.hh"

namespace surfmesh {

/// A named surface that becomes a patch with its whole domain rectangle.
struct PatchInput {
  std::string name;
  std::shared_ptr<const Surface> surface;
};

/// Make a model of whole patches: find which of their sides coincide in space.
///
/// The sides of a patch are `<patch>:v0`, `:u1`, `:v1`, `:u0`, each in the direction of the growing
/// parameter. Sides, and parts of sides, that coincide to 1e-9 of the model's diagonal become one
/// contour, at any speed of parameter, in either direction, also two sides of one patch (a seam)
/// and any number of patches. A side is divided where an end of another side lies on it. A side
/// that is a single point in space becomes one vertex, and a degenerate contour of its own.
/// A contour has the direction of its first use, in the order of patches and, in a patch, of the
/// sides as listed above; it is named after the first whole side among its uses, else after its
/// first use with the number of the part: `left:u1#0`.
/// Sides that come within 1e-4 of the diagonal but do not coincide are not joined; Model::warnings
/// tells their gap.
///
/// Error    coincidence is tested at 33 places of each side, unevenly spread; ends are merged
///          transitively. Far from the origin the tolerance is not below a few roundings of the
///          coordinates
/// Cost     O(n log n) for n sides of bounded length, about 1,000 evaluations a patch,
///          1,300 where speeds differ, some thousands more for a near miss
/// Throws   InvalidInput for no patches, a name used twice, a missing surface, a domain that is not
///          a rectangle; Geometry for a patch that is a point or a line. All name the patch
Model model_from_patches(const std::vector<PatchInput>& patches);

/// The contour uses that make up a side, in the direction of its growing parameter.
///
/// The side is given by its name, as in `wing:u0`; on entries whose curve runs against the growing
/// parameter, curve(0) is the far end.
///
/// Cost     O(contour uses of the model)
/// Throws   InvalidInput if there is no such patch or side
std::vector<LoopEntry> side_uses(const Model& model, std::string_view side_name);

}  // namespace surfmesh
