// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/io/spool_file.hh"

#include <fmt/format.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>
#include <string>

#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

/// Bytes that are copied at once.
constexpr std::uint64_t kBlock = std::uint64_t{1} << 20;

[[noreturn]] void fail_to_spool(const std::filesystem::path& folder) {
  const std::string reason = errno != 0 ? std::strerror(errno) : "it became shorter";
  throw Error(ErrorCode::Io, fmt::format("a temporary file in {}: {}", folder.string(), reason));
}

}  // namespace

SpoolFile::SpoolFile(const std::filesystem::path& folder) : folder_(folder) {
  std::string name = (folder / ".surfmesh-spool-XXXXXX").string();
  file_ = mkstemp(name.data());
  if (file_ < 0) fail_to_spool(folder_);
  unlink(name.c_str());
}

SpoolFile::~SpoolFile() { close(file_); }

void SpoolFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = pwrite(file_, bytes.data(), bytes.size(), static_cast<off_t>(size_));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail_to_spool(folder_);
    bytes.remove_prefix(static_cast<std::size_t>(written));
    size_ += static_cast<std::uint64_t>(written);
  }
}

void SpoolFile::copy(std::uint64_t first, std::uint64_t count, FileAtOffsets& to,
                     std::uint64_t offset) const {
  const auto block = std::make_unique_for_overwrite<char[]>(std::min(count, kBlock));
  while (count > 0) {
    errno = 0;
    const ssize_t read =
        pread(file_, block.get(), std::min(count, kBlock), static_cast<off_t>(first));
    if (read < 0 && errno == EINTR) continue;
    if (read <= 0) fail_to_spool(folder_);
    const auto size = static_cast<std::uint64_t>(read);
    to.write({block.get(), size}, offset);
    first += size;
    offset += size;
    count -= size;
  }
}

}  // namespace surfmesh
