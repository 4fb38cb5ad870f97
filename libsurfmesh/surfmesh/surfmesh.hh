// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/language_standard.hh"  // first: it says if C++ is too old

/// What an application includes: read or build a model, mesh it, walk, copy and write the result.
///
/// Other public headers are for parts of this, or for stages by themselves.
#include "surfmesh/assemble/carry.hh"
#include "surfmesh/assemble/copy_result.hh"
#include "surfmesh/cage/cage_from_mesh.hh"
#include "surfmesh/cage/cage_model.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/version.hh"
#include "surfmesh/formats/read_cage.hh"
#include "surfmesh/formats/read_mesh.hh"
#include "surfmesh/formats/write_mesh.hh"
#include "surfmesh/geometry/callable_surface.hh"
#include "surfmesh/model/finish_model.hh"
#include "surfmesh/model/join_sides.hh"
#include "surfmesh/nurbs/nurbs_curve.hh"
#include "surfmesh/nurbs/split_at_creases.hh"
#include "surfmesh/pipeline/load_model.hh"
#include "surfmesh/pipeline/mesh_model.hh"
#include "surfmesh/pipeline/set_option.hh"
#include "surfmesh/sizes/tables_from_mesh.hh"

/// Meshes of smooth surfaces whose elements follow a metric. surfmesh/surfmesh.hh includes what an
/// application calls.
namespace surfmesh {}
