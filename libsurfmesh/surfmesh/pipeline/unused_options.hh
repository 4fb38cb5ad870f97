// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/notice.hh"
#include "surfmesh/pipeline/options.hh"

namespace surfmesh::detail {

/// Warn of each option that was changed from its default and has no effect beside the others: sizes
/// beside one length everywhere, ways to quads without quads, and ways to triangles on quads.
Notices unused_options(const PipelineOptions& options);

}  // namespace surfmesh::detail
