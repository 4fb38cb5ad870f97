// SPDX-License-Identifier: BSD-3-Clause
// What the fuzz targets found once, and what they start from, without libFuzzer.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>
#include <string>
#include <vector>

#include "fuzz/targets.hh"

namespace surfmesh::fuzz {

void PrintTo(const Target& target, std::ostream* out) { *out << target.name; }

namespace {

const std::filesystem::path kFindings =
    std::filesystem::path(SURFMESH_SOURCE_DIR) / "tests" / "fuzz" / "findings";

Bytes bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

std::vector<Seed> findings_of(const Target& target) {
  std::vector<Seed> findings;
  const std::filesystem::path folder = kFindings / target.name;
  if (!std::filesystem::is_directory(folder)) return findings;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::ifstream file(entry.path(), std::ios::binary);
    findings.push_back({entry.path().filename(),
                        {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()}});
  }
  return findings;
}

class FuzzTarget : public ::testing::TestWithParam<Target> {};

TEST_P(FuzzTarget, TakesItsSeeds) {
  const std::vector<Seed> seeds = seeds_of(GetParam().name);
  EXPECT_GT(seeds.size(), 5u);
  std::size_t taken = 0;
  for (const Seed& seed : seeds) {
    EXPECT_NO_THROW(taken += GetParam().run(bytes_of(seed.bytes)) ? 1 : 0) << seed.name;
  }
  // What is refused shows little of what comes after reading. Models by chance often are.
  EXPECT_GE(10 * taken, (GetParam().name == "pipeline" ? 5 : 8) * seeds.size());
}

TEST_P(FuzzTarget, TakesWhatItFoundOnce) {
  for (const Seed& finding : findings_of(GetParam())) {
    EXPECT_NO_THROW(GetParam().run(bytes_of(finding.bytes))) << finding.name;
  }
}

TEST_P(FuzzTarget, TakesNothing) { EXPECT_NO_THROW(GetParam().run({})); }

INSTANTIATE_TEST_SUITE_P(All, FuzzTarget, ::testing::ValuesIn(targets()),
                         [](const auto& target) { return std::string(target.param.name); });

/// A folder of another name would never be run again.
TEST(FuzzFindings, AreThoseOfTargets) {
  for (const auto& entry : std::filesystem::directory_iterator(kFindings)) {
    const std::string name = entry.path().filename();
    bool is_known = name == "cad";  // which is not built everywhere
    for (const Target& target : targets()) is_known = is_known || target.name == name;
    EXPECT_TRUE(is_known) << name;
  }
}

}  // namespace
}  // namespace surfmesh::fuzz
