// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/io/json.hh"

#include "view/page.hh"
#include "view/page_arrays.hh"
#include "view/page_mesh.hh"

namespace surfmesh {

/// The form of the facts and arrays; a script that knows another one refuses the page.
inline constexpr int kPageFormat = 1;

/// All that a page knows but for its arrays, of which the fields and control meshes are added.
///
/// Keys: format, version, title, model, centre, radius, closed, patches (name, origin), groups
/// (name, patches), contours (names), fields (name, text, category, of, scale), maps (colours by
/// name), categories (colours), no_value (colour), edges (metric lengths), control (by patch),
/// notices, report.
///
/// Fields have an array "field_<name>", control meshes "control_uv", "control_metric",
/// "control_corners" and "control_class", of all patches one after the other.
Json page_facts(const PageContents& contents, const PageOrigins& origins, PageArrays& arrays);

}  // namespace surfmesh
