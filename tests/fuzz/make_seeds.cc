// SPDX-License-Identifier: BSD-3-Clause
// make_seeds FOLDER: write the seeds of each target to a folder of its name.
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "fuzz/targets.hh"

int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "usage: %s FOLDER\n", arguments[0]);
    return 2;
  }
  for (const surfmesh::fuzz::Target& target : surfmesh::fuzz::targets()) {
    const auto folder = std::filesystem::path(arguments[1]) / target.name;
    std::filesystem::create_directories(folder);
    for (const surfmesh::fuzz::Seed& seed : surfmesh::fuzz::seeds_of(target.name)) {
      std::ofstream file(folder / seed.name, std::ios::binary);
      file << seed.bytes;
      if (!file.flush()) {
        std::fprintf(stderr, "cannot write %s\n", (folder / seed.name).c_str());
        return 1;
      }
    }
  }
  return 0;
}
