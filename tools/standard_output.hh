// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace surfmesh {

/// Occupy those of the standard streams that are closed, so that no file that is opened later takes
/// their place and gets what is printed. Printing to them still fails.
void keep_closed_streams_closed();

/// Print and tell nothing from now on, or something again. Of the ranks of a run one is enough to
/// speak.
void be_silent(bool is_on);

/// Print a text on the standard output, all of it.
/// Throws   Io with the reason: the disk is full, nobody reads
void print(std::string_view text);

/// Print on the standard error. Where that is not possible, there is nobody to tell.
void tell(std::string_view text);

/// Print what is not the work itself, of which a warning tells where it is lost.
/// Returns  the exit status of the command, which has `status` otherwise
int print_summary(std::string_view text, int status);

}  // namespace surfmesh
