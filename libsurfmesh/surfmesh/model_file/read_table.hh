// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "surfmesh/geometry/domain.hh"
#include "surfmesh/sizes/sizing.hh"

namespace surfmesh {

/// Read a table of sizes (CSV).
///
/// The first line names the columns: u,v,size or u,v,ls,lt,angle (in degrees) or u,v,m11,m12,m22
/// (entries of M in (u,v)). Lengths are in model units. Empty lines, lines that begin with #, and a
/// byte order mark are ignored.
/// Throws   Io if the file cannot be read; InvalidInput as parse_table
std::vector<TableNode> read_table(const std::filesystem::path& path, const Domain& domain);

/// Read a table from text; `name` is for messages.
///
/// Throws   InvalidInput with "name:line: reason" for other columns, a row with too many or too few
///          values, a value that is not a number, a point outside the domain, a length that is not
///          above 0, a metric that is not positive definite, and for either if it is so large or
///          small that sizes could not be computed; also for a table without rows
std::vector<TableNode> parse_table(std::string_view text, const std::string& name,
                                   const Domain& domain);

}  // namespace surfmesh
