// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "laws/sources.hh"

namespace surfmesh {
namespace {

TEST(PropertyLiterals, StandInTheTableOfKeysOnly) {
  std::size_t in_table = 0;
  for (const auto& file : testing::library_sources()) {
    for (std::size_t i = 0; i < file.code.size(); ++i) {
      if (file.code[i].find("\"surf:") == std::string::npos) continue;
      if (file.path == "core/properties.hh") {
        ++in_table;
      } else {
        ADD_FAILURE() << "a property is named outside of its table\n" << place(file, i);
      }
    }
  }
  EXPECT_GT(in_table, 0u);
}

TEST(PropertyLiterals, HaveNoneOfTheNamesThatOpenMeshKeepsForItself) {
  for (const auto& file : testing::library_sources()) {
    for (std::size_t i = 0; i < file.code.size(); ++i) {
      for (const char* reserved : {"\"v:", "\"e:", "\"f:", "\"h:"}) {
        EXPECT_EQ(file.code[i].find(reserved), std::string::npos) << place(file, i);
      }
    }
  }
}

}  // namespace
}  // namespace surfmesh
