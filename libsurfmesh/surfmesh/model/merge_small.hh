// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/model/model.hh"

namespace surfmesh {

/// Make points of contours, and lines of patches, that are smaller than the tolerances.
///
/// 1. A contour no longer than `least`, or than its own tolerance, is left out; its
///    ends become one vertex. A contour that is a loop of its own stays.
/// 2. A patch between two contours that are so near to each other along their whole length is left
///    out; the two become one contour.
///
/// Model::notices tells how many, with the first place.
///
/// Cost     about ten evaluations for each part of a contour; those of a projection for each sample
///          of the sides of patches with two sides
/// Units    `least` in model units
void merge_small_parts(Model& model, double least);

}  // namespace surfmesh
