// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "surfmesh/core/error.hh"

namespace surfmesh {

/// The text of the Error that a call throws, with its code in front: "io: cannot read ...";
/// "no error" if it throws none.
template <class Call>
std::string error_of(Call call) {
  try {
    call();
  } catch (const Error& error) {
    return std::string(name(error.code())) + ": " + error.what();
  }
  return "no error";
}

}  // namespace surfmesh
