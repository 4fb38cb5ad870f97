// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <string>

#include "fuzz/byte_reader.hh"
#include "fuzz/checks.hh"
#include "fuzz/targets.hh"
#include "surfmesh_cad/read_cad.hh"

namespace surfmesh::fuzz {

bool try_cad(Bytes input) {
  // OpenCASCADE's reader of IGES files ends the program at damaged ones; see DECISIONS.md.
  constexpr std::array kEndings = {".step", ".brep"};
  ByteReader bytes(input);
  const std::string name = std::string("part").append(bytes.one_of(kEndings));
  const auto path = write_scratch(name, bytes.rest());
  return accepts([&] { check_usable(read_cad(path)); });
}

}  // namespace surfmesh::fuzz
