// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <XSControl_WorkSession.hxx>

#include "surfmesh/core/notice.hh"

namespace surfmesh {

/// What OpenCASCADE could not make of the entities of a file: "#12 ADVANCED_FACE: the reason".
/// Notices of the kind IgnoredInput, shortfalls.
Notices failed_entities(const XSControl_WorkSession& session);

}  // namespace surfmesh
