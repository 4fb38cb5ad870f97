// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/io/output_file.hh"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <new>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/out_of_memory.hh"

namespace surfmesh {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBufferSize = std::size_t{1} << 18;

/// Files of this name that other processes are writing, or left behind, are stepped over.
constexpr int kTemporaryNames = 10000;

[[noreturn]] void fail_for(const fs::path& path, std::string_view reason) {
  throw Error(ErrorCode::Io, fmt::format("cannot write {}: {}", path.string(), reason));
}

/// Make a file of a name that nobody else has. Returns 0, or the error: EEXIST if there is one.
int create_exclusively(const fs::path& path) {
  errno = 0;
  std::FILE* file = std::fopen(path.string().c_str(), "wbx");
  if (file == nullptr) return errno;
  std::fclose(file);
  return 0;
}

/// Give a file a second name, or copy it where the file system has no links to files. Returns 0, or
/// the error: EEXIST if there is a file of that name.
int duplicate(const fs::path& file, const fs::path& name) {
  std::error_code error;
  fs::create_hard_link(file, name, error);
  if (error && error != std::errc::file_exists) {
    fs::copy_file(file, name, error);
    std::error_code ignored;
    if (error && error != std::errc::file_exists) fs::remove(name, ignored);  // a part of it
  }
  return error.value();
}

/// Links to links end somewhere, unless they go round.
constexpr int kMostLinks = 40;

/// Where a path leads, which need not exist.
fs::path follow_links(fs::path path) {
  std::error_code error;
  for (int i = 0; i < kMostLinks && fs::is_symlink(fs::symlink_status(path, error)); ++i) {
    path = path.parent_path() / fs::read_symlink(path, error);
  }
  return path;
}

/// Call `make(name)` with names in the folder of `target` until it made a file, which was not there
/// before. Returns the name; `path` stands in messages.
template <class Make>
fs::path make_beside(const fs::path& target, const fs::path& path, Make make) {
  fs::path name = target;
  for (int i = 0; i < kTemporaryNames; ++i) {
    name.replace_filename(fmt::format(".surfmesh-{}.tmp", i));
    const int error = make(name);
    if (error == 0) return name;
    if (error != EEXIST) fail_for(path, std::strerror(error));
  }
  fail_for(path, "its folder is full of temporary files named .surfmesh-*.tmp");
}

}  // namespace

OutputFile::OutputFile(fs::path path) try
    : path_(std::move(path)),
      target_(path_),
      // Not initialised: small files do not touch all of it.
      buffer_(std::make_unique_for_overwrite<char[]>(kBufferSize)) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path_, ignored);
  if (fs::is_directory(status) || !path_.has_filename()) fail_for(path_, "it is a folder");
  if (fs::exists(status)) target_ = fs::canonical(path_, ignored);
  if (target_.empty() || !fs::exists(status)) target_ = follow_links(path_);
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
} catch (const std::bad_alloc&) {
  fail_without_memory("before a file is written");
}

OutputFile::~OutputFile() {
  drop_old();
  if (temporary_.empty()) return;
  std::error_code ignored;
  file_.close();
  fs::remove(temporary_, ignored);
}

void OutputFile::open_temporary() {
  temporary_ = make_beside(target_, path_, create_exclusively);
  file_.open(temporary_, std::ios::binary);
  if (!file_) fail();
}

void OutputFile::fail() {
  const int error = errno;
  if (!temporary_.empty()) {
    std::error_code ignored;
    file_.close();
    fs::remove(temporary_, ignored);
    temporary_.clear();
  }
  fail_for(path_, error != 0 ? std::strerror(error) : "the stream is broken");
}

void OutputFile::write(std::string_view text) {
  errno = 0;
  file_.write(text.data(), static_cast<std::streamsize>(text.size()));
  if (!file_) fail();
}

void OutputFile::finish() {
  if (file_) errno = 0;
  if (file_.is_open()) file_.close();
  if (!file_) fail();
}

/// Keep the old file under another name.
void OutputFile::keep_old() {
  std::error_code ignored;
  if (temporary_.empty() || !fs::exists(target_, ignored)) return;
  old_ = make_beside(target_, path_,
                     [this](const fs::path& name) { return duplicate(target_, name); });
}

void OutputFile::drop_old() {
  if (old_.empty()) return;
  std::error_code ignored;
  fs::remove(old_, ignored);
  old_.clear();
}

void OutputFile::publish() {
  if (temporary_.empty()) return;
  std::error_code error;
  fs::rename(temporary_, target_, error);
  if (error) {
    errno = error.value();
    fail();
  }
  temporary_.clear();
  is_published_ = true;
}

/// Undo publish(). Throws if the file system does not let us.
void OutputFile::take_back() {
  if (!is_published_) return;
  std::error_code error;
  if (old_.empty()) {
    fs::remove(target_, error);
    return;
  }
  const fs::path old = std::exchange(old_, fs::path());
  fs::rename(old, target_, error);
  if (!error) return;
  fail_for(path_,
           fmt::format("{}; what it was before is kept as {}", error.message(), old.string()));
}

void OutputFile::commit() {
  finish();
  publish();
}

void OutputFile::commit_all(std::span<OutputFile* const> files) {
  for (OutputFile* file : files) file->finish();
  // Nothing comes after the last one that could fail.
  for (std::size_t i = 0; i + 1 < files.size(); ++i) files[i]->keep_old();
  std::size_t published = 0;
  try {
    for (; published < files.size(); ++published) files[published]->publish();
  } catch (...) {
    while (published > 0) files[--published]->take_back();
    throw;
  }
  for (OutputFile* file : files) file->drop_old();
}

void write_file(const fs::path& path, std::string_view text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace surfmesh
