// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/machine.hh"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>
#include <thread>

namespace surfmesh {
namespace {

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm parts = {};
  gmtime_r(&now, &parts);
  std::array<char, 16> text = {};
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%d", &parts)};
}

}  // namespace

Machine this_machine() {
  std::ifstream file("/proc/cpuinfo");
  const std::string cpuinfo{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const double load = load_now();
  return {processor_name(cpuinfo), std::thread::hardware_concurrency(), load, load, today()};
}

double load_now() {
  double load = 0;
  return getloadavg(&load, 1) == 1 ? load : 0;
}

std::string processor_name(std::string_view cpuinfo) {
  const std::size_t key = cpuinfo.find("model name");
  const std::size_t colon = key == cpuinfo.npos ? key : cpuinfo.find(':', key);
  if (colon == cpuinfo.npos) return "unknown processor";
  const std::size_t begin = cpuinfo.find_first_not_of(" \t", colon + 1);
  const std::size_t end = std::min(cpuinfo.find('\n', colon), cpuinfo.size());
  return begin < end ? std::string(cpuinfo.substr(begin, end - begin)) : "unknown processor";
}

}  // namespace surfmesh
