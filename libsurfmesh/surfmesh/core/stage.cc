// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/stage.hh"

namespace surfmesh {

std::string_view name(Stage stage) {
  switch (stage) {
    case Stage::Read:
      return "read";
    case Stage::Control:
      return "control";
    case Stage::Boundary:
      return "boundary";
    case Stage::Triangulate:
      return "triangulate";
    case Stage::Refine:
      return "refine";
    case Stage::Improve:
      return "improve";
    case Stage::Quad:
      return "quad";
    case Stage::Assemble:
      return "assemble";
    case Stage::Across:
      return "across";
    case Stage::Write:
      return "write";
  }
  return "unknown";
}

}  // namespace surfmesh
