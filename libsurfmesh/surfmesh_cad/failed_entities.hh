// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <XSControl_WorkSession.hxx>

#include "surfmesh/core/notice.hh"

namespace surfmesh {

/// What OpenCASCADE could not make of the entities of a file: "#12 ADVANCED_FACE: the reason".
/// Notices of the kind IgnoredInput, shortfalls.
Notices failed_entities(const XSControl_WorkSession& session);

/// Check that the entities of a file that was read are what they have to be: OpenCASCADE does not
/// when it makes shapes of them, and falls over what is missing.
///
/// Returns  whether all are; false if only such are not that say how a shape is shown
/// Throws   InvalidInput for a shape, naming the entity
bool check_entities(XSControl_WorkSession& session);

}  // namespace surfmesh
