// SPDX-License-Identifier: BSD-3-Clause
#include "view/page.hh"

#include <fmt/format.h>
#include <zlib.h>

#include <initializer_list>
#include <string_view>

#include "surfmesh/io/clean_text.hh"
#include "surfmesh/io/json.hh"

#include "view/page_arrays.hh"
#include "view/page_facts.hh"
#include "view/page_mesh.hh"

namespace surfmesh {
namespace {

/// Text as content of an HTML element.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : clean_text(text)) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

/// JSON text that holds no "<", so that no name in it can end its element.
std::string escaped_json(const Json& json) {
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string result;
  result.reserve(text.size());
  for (const char c : text) {
    if (c == '<') {
      result += "\\u003c";
    } else {
      result += c;
    }
  }
  return result;
}

/// A word by which the page's own script is told from any other. It depends on the contents, for
/// the same page has the same bytes, and is a second guard only: names are escaped.
std::string nonce_of(std::string_view arrays, std::string_view facts) {
  const auto sum = [](auto checksum, std::string_view text) {
    return checksum(checksum(0, nullptr, 0), reinterpret_cast<const Bytef*>(text.data()),
                    static_cast<uInt>(text.size()));
  };
  return fmt::format("{:08x}{:08x}{:08x}", sum(crc32, arrays), sum(crc32, facts),
                     sum(adler32, facts));
}

/// Without any source, the browser loads nothing, wherever from, and runs no other script.
std::string head(const std::string& title, const std::string& nonce) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src "
      "'nonce-{}'; style-src 'nonce-{}'; img-src data:; base-uri 'none'; form-action 'none'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<link rel=\"icon\" href=\"data:,\">\n<title>{}</title>\n</head>\n<body>\n"
      "<noscript>This page shows a mesh by JavaScript, which is switched off.</noscript>\n",
      nonce, nonce, escaped(title));
}

}  // namespace

std::size_t write_page(const PageContents& contents, const std::string& script, OutputFile& file) {
  const PageOrigins origins = page_origins(contents.mesh);
  PageArrays arrays;
  add_mesh(contents.mesh, origins, arrays);
  Json facts = page_facts(contents, origins, arrays);
  arrays.compress();
  facts["arrays"] = arrays.directory();
  const std::string facts_text = escaped_json(facts);
  const std::string arrays_text = arrays.base64();
  const std::string nonce = nonce_of(arrays_text, facts_text);
  const std::string start = head(contents.title, nonce);
  const std::string own_script = fmt::format("</script>\n<script nonce=\"{}\">\n", nonce);
  const std::initializer_list<std::string_view> parts = {
      start,       "<script type=\"application/json\" id=\"facts\">",
      facts_text,  "</script>\n<script type=\"text/plain\" id=\"arrays\">",
      arrays_text, own_script,
      script,      "\n</script>\n</body>\n</html>\n"};
  std::size_t bytes = 0;
  for (const std::string_view part : parts) {
    file.write(part);
    bytes += part.size();
  }
  return bytes;
}

}  // namespace surfmesh
