// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace surfmesh {

/// True if warnings and errors go to a terminal.
bool is_terminal();

/// True if a stream of this number is a terminal whose letters are UTF-8, by the locale of the
/// environment: block characters can be seen there.
bool shows_unicode(int stream);

/// True if the terminal cannot take a line back: TERM is dumb, or not set.
bool is_dumb_terminal();

/// Columns of the terminal that a stream of this number goes to, at this moment; 80 where it does
/// not tell.
std::size_t terminal_width(int stream);

}  // namespace surfmesh
