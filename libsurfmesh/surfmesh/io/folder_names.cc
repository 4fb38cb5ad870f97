// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/io/folder_names.hh"

#include <dirent.h>
#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <string_view>

#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

struct CloseFolder {
  void operator()(DIR* folder) const { closedir(folder); }
};

[[noreturn]] void fail_to_list(const std::filesystem::path& folder) {
  const char* reason = std::strerror(errno);
  throw Error(ErrorCode::Io, fmt::format("cannot read {}: {}", folder.string(), reason));
}

}  // namespace

std::vector<std::string> folder_names(const std::filesystem::path& folder) {
  const std::unique_ptr<DIR, CloseFolder> open(opendir(folder.c_str()));
  if (!open) fail_to_list(folder);
  std::vector<std::string> names;
  while (true) {
    errno = 0;  // the end is told apart from an error by it alone
    const dirent* entry = readdir(open.get());
    if (entry == nullptr && errno != 0) fail_to_list(folder);
    if (entry == nullptr) return names;
    const std::string_view name = entry->d_name;
    if (name != "." && name != "..") names.emplace_back(name);
  }
}

}  // namespace surfmesh
