// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "fuzz/byte_reader.hh"
#include "fuzz/targets.hh"

namespace surfmesh::fuzz {

/// A model file, and the cages that it names.
struct SmallModel {
  std::string text;
  std::vector<Seed> cages;
};

/// Make a model of a few patches, some sources, sizes and options. All bytes 0 are a flat sheet.
SmallModel make_small_model(ByteReader& bytes);

}  // namespace surfmesh::fuzz
