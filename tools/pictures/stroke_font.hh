// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

#include "pictures/canvas.hh"

namespace surfmesh {

/// Lines that write a text, from (0,0) on its base line to the right, for a height in pixels as
/// fonts have it (capital letters are 0.72 of it). ASCII; any other sign is a question mark.
std::vector<PicturePoints> text_lines(std::string_view text, double height);

/// How far such a text reaches, pixels.
double text_width(std::string_view text, double height);

}  // namespace surfmesh
