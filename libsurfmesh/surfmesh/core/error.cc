// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/error.hh"

namespace surfmesh {

const char* name(ErrorCode code) {
  switch (code) {
    case ErrorCode::InvalidInput:
      return "invalid input";
    case ErrorCode::InvalidOption:
      return "invalid option";
    case ErrorCode::MissingProperty:
      return "missing property";
    case ErrorCode::Io:
      return "io";
    case ErrorCode::Geometry:
      return "geometry";
    case ErrorCode::Limit:
      return "limit";
    case ErrorCode::Cancelled:
      return "cancelled";
  }
  return "unknown";
}

}  // namespace surfmesh
