// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string_view>

namespace surfmesh::paper {

/// A model file of models/paper, as it was when the program was built.
struct ExampleFile {
  std::string_view name;
  std::string_view text;
};

std::span<const ExampleFile> example_files();

}  // namespace surfmesh::paper
