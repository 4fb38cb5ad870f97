// SPDX-License-Identifier: BSD-3-Clause
// Make the parts of models/surfmesh.schema.json anew that tell the options. Not installed.
#include <cstdio>
#include <exception>

#include "surfmesh/io/input_file.hh"
#include "surfmesh/io/output_file.hh"
#include "surfmesh/pipeline/option_schema.hh"

int main(int argc, char** argv) try {
  if (argc != 2) return std::fprintf(stderr, "usage: make_schema SCHEMA.json\n"), 2;
  surfmesh::write_file(argv[1], surfmesh::schema_with_options(surfmesh::read_file(argv[1])));
} catch (const std::exception& error) {
  std::fprintf(stderr, "make_schema: error: %s\n", error.what());
  return 1;
}
