// SPDX-License-Identifier: BSD-3-Clause
#include "settings.hh"

#include <fmt/format.h>

#include <map>

#include "surfmesh/core/error.hh"
#include "surfmesh/pipeline/set_option.hh"

namespace surfmesh {
namespace {

/// Options of the pipeline that have a flag of their own, in the order of the help text.
struct NamedOption {
  const char* group;
  const char* name;
  const char* unit;
  const char* text;
};

constexpr const char* kSizes = "Sizes (lengths in model units, or with % of the model's diagonal)";
constexpr const char* kControl = "Control space (where the sizes are kept)";
constexpr const char* kMeshing = "Meshing";
constexpr const char* kCages = "Cages";

constexpr NamedOption kNamedOptions[] = {
    {kSizes, "curvature", "C", "size = C × radius of curvature; 0 is off, as it is beside --sag"},
    {kSizes, "sag", "E", "greatest distance between mesh and surface"},
    {kSizes, "hmin", "H", "lower bound of all sizes: a length, or a share of the diagonal (0.1%)"},
    {kSizes, "hmax", "H", "upper bound of all sizes"},
    {kSizes, "stretch", "R", "greatest ratio of the two sizes from curvature"},
    {kSizes, "grade", "G", "sizes grow by at most ln G per unit of length; 0 is off"},
    {kControl, "nodes", "auto|N",
     "control nodes: chosen to the precision, or N regular ones a patch"},
    {kControl, "precision", "P", "conformity of the control space with the sizes asked for"},
    {kControl, "control", "mesh|grid", "triangulated, or a regular grid"},
    {kControl, "interpolation", "linear|s|t|o|auto",
     "sizes linear in a triangle of nodes, or by distance from one, its triangle's, all "
     "circumcircles', or the cheapest that is as good"},
    {kControl, "epsilon", "E", "accuracy of the interpolation auto"},
    {kControl, "reuse", "F", "use a size again within this metric distance; 0 is off"},
    {kMeshing, "placement", "frontal|circumcentre", "where new nodes go"},
    {kMeshing, "threads", "all|N", "that work; all is one for each core. The mesh is the same"},
    {kMeshing, "max_elements", "N", "refuse to make more triangles"},
    {kCages, "patches", "auto|faces|blocks",
     "what is a patch of a cage: a face, or a block of faces (auto, where they are quads)"},
};

/// "max-elements" for "max_elements".
std::string flag_of(std::string name) {
  for (char& c : name) c = c == '_' ? '-' : c;
  return "--" + name;
}

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

void add_flags(CLI::App& command, Settings& settings, FlagSet flags) {
  const PipelineOptions defaults;
  for (const NamedOption& option : kNamedOptions) {
    if (option.group == kMeshing && flags == FlagSet::Control) continue;
    const std::string name = option.name;
    command
        .add_option_function<std::string>(
            flag_of(name),
            [&settings, name](const std::string& value) { settings.emplace_back(name, value); },
            option.text)
        ->group(option.group)
        ->type_name(option.unit)
        ->default_str(to_text(get_option(defaults, name)))
        ->check([name](const std::string& value) { return fault_of(name, value); });
  }
  command
      .add_flag_callback(
          "--inner-nodes", [&settings] { settings.emplace_back("inner_nodes", "true"); },
          "refine the control mesh for the shape of its triangles")
      ->group(kControl);
}

CageOptions cage_options(Scheme scheme, const Settings& settings) {
  PipelineOptions options;
  for (const auto& [name, value] : settings) set_option(options, name, value);
  return {.scheme = scheme, .patches = options.patches};
}

std::string names_for_set() {
  std::string names;
  for (const std::string_view name : option_names()) {
    if (!names.empty()) names += names.size() - names.rfind('\n') > 70 ? ",\n  " : ", ";
    names += name;
  }
  return fmt::format("Names for --set:\n  {}\n", names);
}

void add_scheme(CLI::App& command, Scheme& scheme) {
  const std::map<std::string, Scheme> schemes = {{"auto", Scheme::Auto},
                                                 {"catmark", Scheme::CatmullClark},
                                                 {"loop", Scheme::Loop},
                                                 {"bilinear", Scheme::Bilinear}};
  command.add_option("--scheme", scheme, "subdivision scheme of a cage")
      ->transform(CLI::Transformer(schemes).description(""))
      ->type_name("catmark|loop|bilinear|auto")
      ->default_str("auto")
      ->group(kCages);
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
