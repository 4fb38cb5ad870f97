// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/piece_folder.hh"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdio.h>

#include <algorithm>
#include <new>
#include <string_view>
#include <system_error>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/out_of_memory.hh"
#include "surfmesh/exchange/agree_on_error.hh"
#include "surfmesh/formats/pvtu_file.hh"
#include "surfmesh/io/clean_text.hh"
#include "surfmesh/io/folder_names.hh"
#include "surfmesh/io/output_file.hh"

namespace surfmesh {
namespace {

namespace fs = std::filesystem;

/// Folders of this name that other processes are writing, or left behind, are stepped over.
constexpr int kTemporaryNames = 10000;

[[noreturn]] void fail_for(const fs::path& folder, std::string_view reason) {
  throw Error(ErrorCode::Io, fmt::format("cannot write {}: {}", folder.string(), reason));
}

/// A path without a slash at its end, with links followed as far as it exists.
fs::path whole_path(const fs::path& folder) {
  std::error_code ignored;
  fs::path path = fs::weakly_canonical(fs::absolute(folder, ignored), ignored);
  return path.has_filename() ? path : path.parent_path();
}

bool are_digits(std::string_view text) {
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// True for NAME.pvtu and NAME_0123.vtu.
bool is_of_output(std::string_view file, const std::string& name) {
  if (!file.starts_with(name)) return false;
  file.remove_prefix(name.size());
  if (file == ".pvtu") return true;
  return file.starts_with('_') && file.ends_with(".vtu") &&
         are_digits(file.substr(1, file.size() - std::string_view("_.vtu").size()));
}

/// Call `make(name)` with names beside `folder` until it made something that was not there before.
/// Returns  the name, or an empty path and the last error
template <class Make>
std::pair<fs::path, std::error_code> make_beside(const fs::path& folder, Make make) {
  std::error_code error;
  for (int i = 0; i < kTemporaryNames; ++i) {
    fs::path name = folder.parent_path() / fmt::format(".surfmesh-{}.tmp", i);
    if (fs::exists(fs::symlink_status(name, error))) continue;
    error.clear();
    if (make(name, error)) return {std::move(name), {}};
    if (error) break;
  }
  return {{}, error};
}

void rename(const fs::path& from, const fs::path& to, const fs::path& told) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) fail_for(told, error.message());
}

/// Let two names change places, so that each stands for something at any moment.
/// Returns  false where the file system cannot do that
bool exchange([[maybe_unused]] const fs::path& a, [[maybe_unused]] const fs::path& b) {
#ifdef RENAME_EXCHANGE
  return renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0;
#else
  return false;
#endif
}

/// Remove a folder, if there is one. Where memory runs out in that, it has it back, and may go on.
void remove_quietly(const fs::path& folder) noexcept {
  constexpr int kTries = 3;
  for (int i = 0; i < kTries && !folder.empty(); ++i) {
    try {
      std::error_code ignored;
      fs::remove_all(folder, ignored);
      return;
    } catch (const std::bad_alloc&) {
    }
  }
}

}  // namespace

PieceFolder::PieceFolder(fs::path folder, Exchange& exchange) try
    : given_(std::move(folder)),
      folder_(whole_path(given_)),
      name_(folder_.filename().string()),
      exchange_(exchange) {
} catch (const std::bad_alloc&) {
  fail_without_memory("before a folder of pieces is made");
}

PieceFolder::~PieceFolder() {
  remove_quietly(temporary_);
  remove_quietly(old_);
}

/// At least four digits, so that a folder lists them in their order.
std::string PieceFolder::piece_name(int piece) const {
  return fmt::format("{}_{:04}.vtu", name_, piece);
}

/// Nothing that a user may miss is replaced.
void PieceFolder::check_old() const {
  std::error_code error;
  if (clean_text(name_) != name_) {
    fail_for(given_, "its name is not UTF-8, as the .pvtu file in it has to be");
  }
  if (!fs::is_directory(folder_.parent_path(), error)) {
    fail_for(given_, fmt::format("there is no folder {}", folder_.parent_path().string()));
  }
  const fs::file_status status = fs::status(folder_, error);
  if (!fs::exists(status)) return;
  if (!fs::is_directory(status)) fail_for(given_, "it is no folder");
  for (const std::string& file : folder_names(folder_)) {
    if (is_of_output(file, name_)) continue;
    fail_for(given_, fmt::format("it is replaced as a whole, and has {} in it", file));
  }
}

void PieceFolder::make_temporary() {
  check_old();
  auto [path, error] = make_beside(folder_, [](const fs::path& name, std::error_code& reason) {
    return fs::create_directory(name, reason);
  });
  if (path.empty()) fail_for(given_, error.message());
  temporary_ = std::move(path);
}

void PieceFolder::begin(const PieceIndex& index) {
  index_ = index;
  agree_on_errors_of(exchange_, [&] {
    if (exchange_.rank() == 0) make_temporary();
  });
  temporary_ = text_of_rank_0(exchange_, temporary_.string());
  agree_on_errors_of(exchange_, [&] {
    std::error_code ignored;
    if (fs::is_directory(temporary_, ignored)) return;
    temporary_.clear();
    fail_for(given_, fmt::format("rank {} does not see the folder of rank 0", exchange_.rank()));
  });
}

/// Errors name the folder that was asked for.
template <class Write>
void PieceFolder::write_file(const std::string& name, Write write) const {
  try {
    OutputFile file(temporary_ / name);
    write(file);
    file.commit();
  } catch (const Error& error) {
    std::string text = error.what();
    const std::string hidden = temporary_.string();
    if (const auto at = text.find(hidden); at != std::string::npos) {
      text.replace(at, hidden.size(), given_.string());
    }
    throw Error(error.code(), text);
  }
}

void PieceFolder::write(int piece, const MeshPiece& mesh) {
  write_file(piece_name(piece),
             [&](OutputFile& file) { write_vtu_piece(mesh, index_.names, file); });
}

void PieceFolder::finish() {
  agree_on_errors_of(exchange_, [&] {
    if (exchange_.rank() != 0) return;
    std::vector<std::string> pieces;
    for (int i = 0; i < index_.pieces; ++i) pieces.push_back(piece_name(i));
    write_file(fmt::format("{}.pvtu", name_),
               [&](OutputFile& file) { write_pvtu(pieces, index_.names, file); });
  });
}

void PieceFolder::publish() {
  check_old();  // once more: since begin(), others may have put files there
  std::error_code ignored;
  if (const fs::file_status status = fs::status(folder_, ignored); fs::exists(status)) {
    fs::permissions(temporary_, status.permissions(), ignored);
    if (exchange(temporary_, folder_)) {
      old_ = std::exchange(temporary_, fs::path());
      return;
    }
    auto [path, error] =
        make_beside(folder_, [this](const fs::path& name, std::error_code& reason) {
          fs::rename(folder_, name, reason);
          return !reason;
        });
    if (path.empty()) fail_for(given_, error.message());
    old_ = std::move(path);
  }
  try {
    rename(temporary_, folder_, given_);
  } catch (const Error&) {
    if (!old_.empty()) rename(std::exchange(old_, fs::path()), folder_, given_);
    throw;
  }
}

void PieceFolder::take_back() {
  // What was published is then under the name of the old one, and removed with this.
  if (!old_.empty() && exchange(old_, folder_)) return;
  std::error_code ignored;
  if (!old_.empty() && !fs::exists(old_, ignored)) return;  // the new one is better than none
  fs::remove_all(folder_, ignored);
  if (!old_.empty()) rename(std::exchange(old_, fs::path()), folder_, given_);
}

void PieceFolder::commit(OutputFile* with) {
  agree_on_errors_of(exchange_, [&] {
    if (exchange_.rank() != 0) return;
    publish();
    try {
      if (with) with->commit();
    } catch (const Error&) {
      take_back();
      throw;
    }
    // Here, where signals wait: the old folder is not left behind.
    remove_quietly(std::exchange(old_, fs::path()));
  });
  // Its name is free for others.
  temporary_.clear();
}

}  // namespace surfmesh
