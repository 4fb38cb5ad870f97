// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// The JSON schema of model files, with the properties of `sizing` and `options` regenerated from
/// the option table. All else stays as it is.
/// Throws   InvalidInput if the text is not such a schema
std::string schema_with_options(std::string_view schema);

}  // namespace surfmesh
