// SPDX-License-Identifier: BSD-3-Clause
#include "standard_output.hh"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "exit_status.hh"
#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

bool is_output_silent = false;

}  // namespace

void keep_closed_streams_closed() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) != -1 || errno != EBADF) continue;
    // The lowest number that is free is this one; the wrong direction makes its use an error.
    const int null = open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    if (null != stream && null != -1) close(null);
  }
}

void be_silent(bool is_on) { is_output_silent = is_on; }

void print(std::string_view text) {
  if (is_output_silent) return;
  errno = 0;
  const bool is_written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (is_written && std::fflush(stdout) == 0) return;
  throw Error(ErrorCode::Io,
              fmt::format("cannot write to the standard output: {}", std::strerror(errno)));
}

void tell(std::string_view text) {
  if (is_output_silent) return;
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

int print_summary(std::string_view text, int status) {
  try {
    print(text);
    return status;
  } catch (const Error& error) {
    tell(fmt::format("surfmesh: warning: the summary is lost: {}\n", error.what()));
    return kFellShort;
  }
}

}  // namespace surfmesh
