// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "surfmesh/geometry/curve.hh"
#include "surfmesh/geometry/domain.hh"
#include "surfmesh/io/json_node.hh"
#include "surfmesh/model_file/model_values.hh"
#include "surfmesh/nurbs/nurbs_curve.hh"
#include "surfmesh/nurbs/split_at_creases.hh"

/// NURBS of a model file. All functions throw InvalidInput with the place of the number, row or
/// list for what does not fit.
namespace surfmesh {

/// Read the value of `nurbs` in a surface.
NurbsNet read_nurbs_net(const JsonNode& node, const Constants& constants);

/// Read the value of `nurbs` in an entry of `on` of a contour, over a range of its knots; all of
/// them if there is none.
std::shared_ptr<const NurbsCurve> read_nurbs_curve(const JsonNode& node,
                                                   const std::optional<CurveRange>& range,
                                                   const Constants& constants);

/// The name of a piece of a patch that is divided at its creases: "body[0,1]".
std::string piece_name(const std::string& patch, const NurbsPiece& piece);

}  // namespace surfmesh
