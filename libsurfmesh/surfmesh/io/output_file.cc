// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/io/output_file.hh"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBufferSize = std::size_t{1} << 18;

/// Files of this name that other processes are writing, or left behind, are stepped over.
constexpr int kTemporaryNames = 10000;

[[noreturn]] void fail_for(const fs::path& path, std::string_view reason) {
  throw Error(ErrorCode::Io, fmt::format("cannot write {}: {}", path.string(), reason));
}

/// Make a file of a name that nobody else has; false if there is one of this name.
bool create_exclusively(const fs::path& path) {
  std::FILE* file = std::fopen(path.string().c_str(), "wbx");
  if (file != nullptr) std::fclose(file);
  return file != nullptr;
}

}  // namespace

OutputFile::OutputFile(fs::path path)
    : path_(std::move(path)),
      target_(path_),
      // Not initialised: small files do not touch all of it.
      buffer_(std::make_unique_for_overwrite<char[]>(kBufferSize)) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path_, ignored);
  if (fs::is_directory(status) || !path_.has_filename()) fail_for(path_, "it is a folder");
  if (fs::exists(status)) target_ = fs::canonical(path_, ignored);
  if (target_.empty()) target_ = path_;
  file_.rdbuf()->pubsetbuf(buffer_.get(), static_cast<std::streamsize>(kBufferSize));
  errno = 0;
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    file_.open(path_, std::ios::binary);
    if (!file_) fail();
    return;
  }
  if (fs::exists(status) && (status.permissions() & fs::perms(0222)) == fs::perms::none) {
    fail_for(path_, "it is write-protected");
  }
  open_temporary();
  if (fs::exists(status)) fs::permissions(temporary_, status.permissions(), ignored);
}

OutputFile::~OutputFile() {
  if (temporary_.empty()) return;
  file_.close();
  std::error_code ignored;
  fs::remove(temporary_, ignored);
}

void OutputFile::open_temporary() {
  for (int i = 0; i < kTemporaryNames; ++i) {
    fs::path name = target_;
    name.replace_filename(fmt::format(".surfmesh-{}.tmp", i));
    if (!create_exclusively(name)) {
      if (errno == EEXIST) continue;
      fail();
    }
    temporary_ = std::move(name);
    file_.open(temporary_, std::ios::binary);
    if (!file_) fail();
    return;
  }
  fail_for(path_, "its folder is full of temporary files named .surfmesh-*.tmp");
}

void OutputFile::fail() {
  const std::string reason = errno != 0 ? std::strerror(errno) : "the stream is broken";
  if (!temporary_.empty()) {
    std::error_code ignored;
    file_.close();
    fs::remove(temporary_, ignored);
    temporary_.clear();
  }
  fail_for(path_, reason);
}

void OutputFile::write(std::string_view text) {
  errno = 0;
  file_.write(text.data(), static_cast<std::streamsize>(text.size()));
  if (!file_) fail();
}

void OutputFile::commit() {
  if (file_) errno = 0;
  file_.close();
  if (!file_) fail();
  if (temporary_.empty()) return;
  std::error_code error;
  fs::rename(temporary_, target_, error);
  if (error) {
    errno = error.value();
    fail();
  }
  temporary_.clear();
}

void write_file(const fs::path& path, std::string_view text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace surfmesh
