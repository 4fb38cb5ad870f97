// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/model/model.hh"

namespace surfmesh {

/// Make a point of each contour that is no longer than `least`, or than its own tolerance: it is
/// left out, and its ends become one vertex. Contours in a row become a point only as long as all
/// of them together are so short. A contour that is a loop of its own, and a pole, stays.
///
/// Model::notices tells how many, with the first place.
///
/// Units    `least` in model units
/// Cost     about ten evaluations for each part of a contour
void merge_short_contours(Model& model, double least);

/// Make a line of each patch between two contours that are as near to each other along their whole
/// length: it is left out, and the two become one contour. Indices of patches and contours change.
///
/// Model::notices tells how many, with the first one's name.
///
/// Units    `least` in model units
/// Cost     a projection for each sample of the sides of patches with two sides
void merge_slivers(Model& model, double least);

}  // namespace surfmesh
