// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "surfmesh/core/validate.hh"

namespace surfmesh::testing {

/// EXPECT_TRUE(is_valid(mesh)) tells the faults.
template <class Mesh>
::testing::AssertionResult is_valid(const Mesh& mesh) {
  const std::vector<std::string> faults = find_faults(mesh);
  if (faults.empty()) return ::testing::AssertionSuccess();
  auto result = ::testing::AssertionFailure() << faults.size() << " faults:";
  for (const std::string& fault : faults) result << "\n  " << fault;
  return result;
}

/// Expect no broken invariant of the half-edge structure.
template <class Mesh>
void expect_valid(const Mesh& mesh) {
  EXPECT_TRUE(is_valid(mesh));
}

}  // namespace surfmesh::testing
