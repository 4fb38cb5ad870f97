// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/io/file_at_offsets.hh"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

[[noreturn]] void fail_for(const std::filesystem::path& path) {
  throw Error(ErrorCode::Io,
              fmt::format("cannot write {}: {}", path.string(), std::strerror(errno)));
}

}  // namespace

FileAtOffsets::FileAtOffsets(const std::filesystem::path& path, const std::filesystem::path& told)
    : told_(told), file_(open(path.c_str(), O_WRONLY | O_CLOEXEC)) {
  if (file_ < 0) fail_for(told_);
}

FileAtOffsets::~FileAtOffsets() {
  if (file_ >= 0) ::close(file_);
}

void FileAtOffsets::write(std::string_view bytes, std::uint64_t offset) {
  while (!bytes.empty()) {
    const ssize_t written = pwrite(file_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail_for(told_);
    bytes.remove_prefix(static_cast<std::size_t>(written));
    offset += static_cast<std::uint64_t>(written);
  }
}

void FileAtOffsets::close() {
  if (::close(std::exchange(file_, -1)) != 0) fail_for(told_);
}

}  // namespace surfmesh
