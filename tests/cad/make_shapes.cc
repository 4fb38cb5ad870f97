// SPDX-License-Identifier: BSD-3-Clause
// Writes the shapes of the CAD tests to a folder, for benchmarks and for trying the program.
#include <cstdio>
#include <exception>
#include <filesystem>

#include "cad/own_shapes.hh"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: surfmesh_make_cad_shapes FOLDER\n");
    return 2;
  }
  try {
    std::filesystem::create_directories(argv[1]);
    for (const auto& shape : surfmesh::testing::own_shapes()) {
      std::printf("%s\n", surfmesh::testing::write_shape(shape, argv[1]).c_str());
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "surfmesh_make_cad_shapes: %s\n", error.what());
    return 1;
  }
  return 0;
}
