// SPDX-License-Identifier: BSD-3-Clause
#include "settings.hh"

#include <fmt/format.h>

#include <map>

#include "surfmesh/core/error.hh"
#include "surfmesh/pipeline/set_option.hh"

namespace surfmesh {
namespace {

std::pair<std::string, std::string> split_setting(const std::string& text) {
  const std::size_t mark = text.find('=');
  if (mark == std::string::npos || mark == 0) {
    throw CLI::ValidationError("--set", fmt::format("'{}' is not key=value", text));
  }
  return {text.substr(0, mark), text.substr(mark + 1)};
}

}  // namespace

std::string fault_of(const std::string& name, const std::string& value) {
  try {
    PipelineOptions scratch;
    set_option(scratch, name, value);
    return {};
  } catch (const Error& error) {
    return error.what();
  }
}

void add_scheme(CLI::App& command, Scheme& scheme) {
  const std::map<std::string, Scheme> schemes = {{"auto", Scheme::Auto},
                                                 {"catmark", Scheme::CatmullClark},
                                                 {"loop", Scheme::Loop},
                                                 {"bilinear", Scheme::Bilinear}};
  command.add_option("--scheme", scheme, "subdivision scheme of a cage")
      ->transform(CLI::Transformer(schemes).description(""))
      ->type_name("catmark|loop|bilinear|auto")
      ->default_str("auto");
}

void add_set(CLI::App& command, Settings& settings, const std::string& text) {
  command
      .add_option_function<std::vector<std::string>>(
          "--set",
          [&settings](const std::vector<std::string>& texts) {
            for (const std::string& word : texts) settings.push_back(split_setting(word));
          },
          text)
      ->type_name("key=value")
      ->expected(1)
      ->take_all()
      ->check([](const std::string& word) {
        const auto [name, value] = split_setting(word);
        return fault_of(name, value);
      });
}

}  // namespace surfmesh
