// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "surfmesh/cage/cage_model.hh"
#include "surfmesh/model_file/read_model.hh"

/// Options that would have no effect on what a file holds are refused.
namespace surfmesh::detail {

/// Throws   InvalidInput: in this file nothing has sides to join
[[noreturn]] void fail_joining(const std::string& name);

/// Throws   InvalidInput: this file has no edges to sew
[[noreturn]] void fail_sew(const std::string& name);

/// Refuse options of cages, given beside the file or in it, where it has no cage.
///
/// Throws   InvalidInput
void check_without_cages(const ModelFile& file, const std::string& name, const CageOptions& given);

}  // namespace surfmesh::detail
