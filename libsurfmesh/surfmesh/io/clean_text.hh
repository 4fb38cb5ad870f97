// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace surfmesh {

/// Text as every reader of XML and HTML takes it: each byte that is not part of a character in
/// UTF-8 (RFC 3629), each control character below 0x20, and U+FFFE and U+FFFF, which XML does not
/// have, becomes U+FFFD, the replacement character. Names in files may hold any bytes.
std::string clean_text(std::string_view text);

}  // namespace surfmesh
