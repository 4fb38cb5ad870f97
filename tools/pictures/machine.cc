// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/machine.hh"

#include <fmt/format.h>

#include <fstream>
#include <thread>

namespace surfmesh {

std::string machine_name() {
  std::ifstream file("/proc/cpuinfo");
  std::string processor = "an unknown processor";
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (!line.starts_with("model name") || colon == line.npos) continue;
    processor = line.substr(colon + 2);
    break;
  }
  return fmt::format("{}, {} cores", processor, std::thread::hardware_concurrency());
}

}  // namespace surfmesh
