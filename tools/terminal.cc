// SPDX-License-Identifier: BSD-3-Clause
#include "terminal.hh"

#include <langinfo.h>
#include <locale.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>

#include "mpi_launcher.hh"

namespace surfmesh {
namespace {

constexpr std::size_t kUsualWidth = 80;

/// Of the environment, which need not be the locale of the program.
bool is_utf8_locale() {
  const locale_t locale = newlocale(LC_CTYPE_MASK, "", nullptr);
  if (!locale) return false;
  const bool is_utf8 = std::string_view(nl_langinfo_l(CODESET, locale)) == "UTF-8";
  freelocale(locale);
  return is_utf8;
}

/// mpirun gives its processes a terminal of its own, wherever it writes what they print.
bool is_shown(int stream) { return isatty(stream) == 1 && processes_by_mpirun() < 2; }

}  // namespace

bool is_terminal() { return is_shown(STDERR_FILENO); }

bool shows_unicode(int stream) { return is_shown(stream) && is_utf8_locale(); }

bool is_dumb_terminal() {
  const char* name = std::getenv("TERM");
  return !name || std::string_view(name).empty() || std::string_view(name) == "dumb";
}

std::size_t terminal_width(int stream) {
  winsize size = {};
  const bool is_known = ioctl(stream, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return is_known ? size.ws_col : kUsualWidth;
}

}  // namespace surfmesh
