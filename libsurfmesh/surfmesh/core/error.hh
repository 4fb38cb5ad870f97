// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// Kind of a failure: what the caller can do about it.
enum class ErrorCode {
  InvalidInput,     ///< a file, formula, cage or model that cannot be read or makes no sense
  InvalidOption,    ///< an option outside its legal range
  MissingProperty,  ///< a mesh lacks a property that an earlier stage writes
  Io,               ///< a file that cannot be opened, read or written
  Geometry,         ///< a surface or boundary that cannot be meshed
  Limit,            ///< a cap (elements, iterations) is exceeded
  Cancelled         ///< the observer ended the run
};

/// The name of a code, as used in reports: "invalid input", "io", ...
const char* name(ErrorCode code);

/// The one exception type of the library.
///
/// The text says where the fault is (file and line, JSON pointer, patch, (u,v)) and gives the
/// reason. It reads well after "error: ".
class Error : public std::runtime_error {
 public:
  Error(ErrorCode code, const std::string& text) : std::runtime_error(text), code_(code) {}

  ErrorCode code() const { return code_; }

 private:
  ErrorCode code_;
};

}  // namespace surfmesh
