// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "support/folders.hh"

namespace surfmesh {

/// A model of ours, by its name.
inline std::string own_model(const std::string& name) {
  return (std::filesystem::path(SURFMESH_SOURCE_DIR) / "models" / name).string();
}

/// Runs the program in an empty folder of its own.
class Program : public ::testing::Test {
 protected:
  /// Run `surfmesh <arguments>`; `before` stands before the program on the command line. Returns
  /// the exit status.
  int run(const std::string& arguments, const std::string& before = "") {
    return shell(before + " '" SURFMESH_PROGRAM "' " + arguments);
  }

  /// Run a command line in the folder.
  int shell(const std::string& line) {
    const std::string command =
        "cd '" + folder_.path().string() + "' && " + line + " >stdout 2>stderr";
    const int status = std::system(command.c_str());
    out_ = read_text(folder_ / "stdout");
    err_ = read_text(folder_ / "stderr");
    std::filesystem::remove(folder_ / "stdout");
    std::filesystem::remove(folder_ / "stderr");
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

  bool says(const std::string& text) const { return (out_ + err_).find(text) != std::string::npos; }

  TestFolder folder_;
  std::string out_;
  std::string err_;
};

}  // namespace surfmesh
