// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "surfmesh/core/notice.hh"
#include "surfmesh/metric/metric_field.hh"
#include "surfmesh/model/model.hh"

namespace surfmesh::detail {

/// Tell of a cage whose faces are no larger than the elements asked for: most likely it is a mesh
/// that somebody wants to have coarser, but no element is larger than a patch.
///
/// Told if there are many contours between smoothly joined patches of cages, and half of them are
/// shorter than 1.4 of the elements asked for there.
/// Cost     three metric queries a contour
std::optional<Notice> notice_of_fine_cage(const Model& model,
                                          const std::vector<const MetricField*>& fields);

}  // namespace surfmesh::detail
