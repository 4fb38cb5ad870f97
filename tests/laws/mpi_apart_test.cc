// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <regex>
#include <string>

#include "laws/sources.hh"

namespace surfmesh {
namespace {

/// MPI and METIS may not be installed; ours that use them lie in surfmesh_mpi and surfmesh_metis.
bool includes_them(const std::string& line) {
  static const std::regex pattern(
      R"re(^\s*#\s*include\s*["<](surfmesh_mpi/|surfmesh_metis/|mpi\.h|metis\.h))re");
  return std::regex_search(line, pattern);
}

TEST(MpiApart, NothingOfTheLibraryIncludesIt) {
  for (const auto& file : testing::library_sources()) {
    for (std::size_t i = 0; i < file.code.size(); ++i) {
      EXPECT_FALSE(includes_them(file.code[i])) << place(file, i);
    }
  }
}

TEST(MpiApart, SeesAnInclude) {
  EXPECT_TRUE(includes_them("#include <mpi.h>"));
  EXPECT_TRUE(includes_them("#include \"surfmesh_metis/deal_by_metis.hh\""));
  EXPECT_FALSE(includes_them("#include \"surfmesh/exchange/exchange.hh\""));
}

}  // namespace
}  // namespace surfmesh
