// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/boundary/contour_memory.hh"
#include "surfmesh/boundary/segment_counts.hh"

namespace surfmesh {

/// Change the numbers of segments of as few contours as possible, each by one, so that the loops of
/// every patch have an even number of segments together: then quads alone can fill it.
///
/// A contour changes the parity of both its patches, or of one and the outside. The contours to
/// change are thus a T-join of the graph of patches. It is taken from a minimum spanning tree, made
/// cheaper around cycles, and a few percent dearer than the best. A change costs as much as the
/// number of segments gets farther, by ratio, from the length of the contour. Contours of three and
/// more patches get an even number first; those that one patch has on both sides do not matter.
///
/// Numbers do not fall below the least ones; without `may_shrink`, they only grow.
/// Cost     O(contours · log contours)
void make_patches_even(const Model& model, const LeastSegments& least, bool may_shrink,
                       ContourDivisions& divisions);

/// By patch: 1 if its loops have an odd number of segments together, poles not counted.
std::vector<char> odd_patches(const Model& model, const ContourDivisions& divisions);

}  // namespace surfmesh
