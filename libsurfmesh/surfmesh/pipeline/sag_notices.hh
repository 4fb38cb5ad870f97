// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/notice.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/sizes/sizing.hh"

namespace surfmesh::detail {

/// A shortfall where the sag is less than the gaps of the model allow, so that another one is kept.
Notices notices_of_raised_sag(const Model& model, const Sizing& sizing);

}  // namespace surfmesh::detail
