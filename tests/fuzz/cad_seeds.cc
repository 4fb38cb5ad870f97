// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <fstream>
#include <iterator>
#include <string>

#include "cad/own_shapes.hh"
#include "fuzz/checks.hh"
#include "fuzz/targets.hh"

namespace surfmesh::fuzz {

std::vector<Seed> cad_seeds() {
  std::vector<Seed> seeds;
  for (const char* name : {"box", "cylinder", "cone", "sphere", "torus", "hexagon"}) {
    constexpr std::array kEndings = {".step", ".brep"};  // as try_cad numbers them
    for (std::size_t i = 0; i < kEndings.size(); ++i) {
      testing::OwnShape shape = testing::own_shape(name);
      shape.ending = kEndings[i];
      const auto path = testing::write_shape(shape, scratch_folder());
      std::ifstream file(path, std::ios::binary);
      const std::string text{std::istreambuf_iterator<char>(file),
                             std::istreambuf_iterator<char>()};
      seeds.push_back({path.filename(), static_cast<char>(i) + text});
    }
  }
  return seeds;
}

}  // namespace surfmesh::fuzz
