// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/load_model.hh"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <new>
#include <numeric>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "surfmesh/cage/creases.hh"
#include "surfmesh/cage/interpolating_cage.hh"
#include "surfmesh/cage/mend_cage.hh"
#include "surfmesh/cage/weld_cage.hh"
#include "surfmesh/core/at_location.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/length.hh"
#include "surfmesh/core/out_of_memory.hh"
#include "surfmesh/core/run_context.hh"
#include "surfmesh/formats/mesh_endings.hh"
#include "surfmesh/formats/mesh_format.hh"
#include "surfmesh/formats/read_cage.hh"
#include "surfmesh/io/input_file.hh"
#include "surfmesh/io/json.hh"
#include "surfmesh/io/nearest_word.hh"
#include "surfmesh/model/append_model.hh"
#include "surfmesh/model/divide_contours.hh"
#include "surfmesh/model/join_sides.hh"
#include "surfmesh/model_file/read_model.hh"
#include "surfmesh/pipeline/load_cad.hh"
#include "surfmesh/pipeline/option_table.hh"
#include "surfmesh/pipeline/set_option.hh"

namespace surfmesh {
namespace {

/// Call `body`, and put the location in a file in front of its errors. What is wrong with an option
/// is so in the file.
template <class Body>
void at_file(const std::string& location, Body body) {
  try {
    at_location(location, body);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::InvalidOption) throw;
    throw Error(ErrorCode::InvalidInput, error.what());
  }
}

/// Note in the model the options of models that it was asked for as a whole.
void note_options(const PipelineOptions& options, Model& model) {
  for (const Option& option : option_table()) {
    const std::string value = option.value_text(options);
    if (option.group != OptionGroup::Cages || value == option.value_text({})) continue;
    const MadeWith made{std::string(option.name()), value};
    const auto known = std::find(model.made_with.begin(), model.made_with.end(), made);
    if (known == model.made_with.end()) model.made_with.push_back(made);
  }
}

/// What is asked for from outside replaces the options of a file.
void set_given(const LoadOptions& given, PipelineOptions& options) {
  const CageOptions& cages = given.cages;
  if (cages.patches != PatchKind::Auto) options.patches = cages.patches;
  if (cages.weld) options.weld = cages.weld;
  if (cages.orient) options.orient = cages.orient;
  if (cages.crease_angle) options.crease_angle = cages.crease_angle;
  if (cages.surface != SurfaceKind::Auto) options.surface = cages.surface;
  if (cages.fit) options.fit = cages.fit;
  if (given.joining) options.joining = given.joining;
  if (given.cad.sew) options.sew = given.cad.sew;
}

/// The model of a cage that a file holds.
Model model_of(const Cage& cage, const std::filesystem::path& path, const CageOptions& options) {
  Model model;
  at_file(path.string(), [&] { model = model_from_cage(cage, options); });
  for (Notice& notice : model.notices) locate(path.string(), notice);
  for (Patch& patch : model.patches) patch.origin = path.string();
  model.notices.insert(model.notices.begin(), cage.notices.begin(), cage.notices.end());
  return model;
}

[[noreturn]] void fail_joining(const std::string& name) {
  throw Error(ErrorCode::InvalidInput,
              fmt::format("{}: only patches of formulas have sides to join; {} makes vertices of a "
                          "cage one",
                          name, ranges::kWeld.name));
}

[[noreturn]] void fail_sew(const std::string& name) {
  throw Error(ErrorCode::InvalidInput,
              fmt::format("{}: only CAD files have edges to {}", name, ranges::kSew.name));
}

ModelInput load_cage(const std::filesystem::path& path, const LoadOptions& options,
                     const RunContext& context) {
  if (options.joining) fail_joining(path.string());
  if (options.cad.sew) fail_sew(path.string());
  const CageOptions& cages = options.cages;
  const Cage cage = read_cage(path);
  context.throw_if_cancelled();
  ModelInput input;
  input.model = model_of(cage, path, cages);
  set_given(options, input.options);
  return input;
}

/// True for a number in quotes, which only a share of the diagonal may have.
bool is_quoted_number(const Json& value) {
  if (!value.is_string()) return false;
  const std::string text = value.get<std::string>();
  return text.find_first_of("0123456789+-.") == 0 && text.find('%') == text.npos;
}

/// The text of a JSON value for set_option: what stands in quotes are words and shares of the
/// diagonal.
std::string text_for(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

/// Set one entry of a file's `sizing` or `options`; null leaves the default.
void set_file_option(PipelineOptions& options, const FileOption& entry) {
  const Option& option = find_option(entry.name);
  if ((option.group == OptionGroup::Sizes) != entry.is_in_sizing) {
    throw Error(ErrorCode::InvalidOption,
                fmt::format("it belongs in {}", entry.is_in_sizing ? "options" : "sizing"));
  }
  const auto value = Json::parse(entry.value);
  if (is_quoted_number(value)) {
    throw Error(ErrorCode::InvalidOption,
                fmt::format("{} = {}: a number stands without quotes", entry.name, value.dump()));
  }
  if (!value.is_null()) set_option(options, entry.name, text_for(value));
}

/// Where both bounds are of one kind, a file that gives both is told of its fault before the model
/// is there. A bound that it leaves out may still come from the command line.
void check_bounds(const Sizing& sizing) {
  const Length hmin = sizing.least_size();
  if (hmin.is_relative != sizing.hmax.is_relative) return;
  if (hmin.value <= sizing.hmax.value) return;
  throw Error(ErrorCode::InvalidOption, fmt::format("hmin = {} must not be above hmax = {}",
                                                    to_text(hmin), to_text(sizing.hmax)));
}

/// Where the options belong in a file.
KeyPlaces places_of_options() {
  KeyPlaces places;
  for (const Option& option : option_table()) {
    places.emplace(option.name(), option.group == OptionGroup::Sizes ? "sizing" : "options");
  }
  return places;
}

PipelineOptions file_options(const ModelFile& file, const std::string& name) {
  PipelineOptions options;
  std::vector<std::string> bounds;  // where they stand
  for (const FileOption& entry : file.options) {
    at_file(fmt::format("{}: {}", name, entry.origin), [&] { set_file_option(options, entry); });
    if (entry.name == ranges::kHmin.name || entry.name == ranges::kHmax.name) {
      bounds.push_back(entry.origin);
    }
  }
  if (bounds.size() == 2) {
    at_file(fmt::format("{}: {}", name, bounds.back()), [&] { check_bounds(options.sizing); });
  }
  return options;
}

/// What is asked for from outside comes first, then what a cage names itself, then what the file
/// has in its options.
CageOptions options_of(const CageInput& input, const CageOptions& given,
                       const PipelineOptions& of_file) {
  CageOptions options = given;
  if (options.scheme == Scheme::Auto) options.scheme = input.scheme;
  if (options.patches == PatchKind::Auto) options.patches = input.patches;
  if (options.patches == PatchKind::Auto) options.patches = of_file.patches;
  if (!options.weld) options.weld = input.weld;
  if (!options.weld) options.weld = of_file.weld;
  if (!options.orient) options.orient = input.orient;
  if (!options.orient) options.orient = of_file.orient;
  if (!options.crease_angle) options.crease_angle = input.crease_angle;
  if (!options.crease_angle) options.crease_angle = of_file.crease_angle;
  if (options.surface == SurfaceKind::Auto) options.surface = input.surface;
  if (options.surface == SurfaceKind::Auto) options.surface = of_file.surface;
  if (!options.fit) options.fit = input.fit;
  if (!options.fit) options.fit = of_file.fit;
  return options;
}

/// True for an option of cages that leaves all as it is.
bool is_default(const FileOption& entry) {
  PipelineOptions options;
  set_file_option(options, entry);
  return get_option(options, entry.name) == get_option({}, entry.name);
}

/// Refuse options of cages, which would have no effect.
void check_without_cages(const ModelFile& file, const std::string& name, const CageOptions& given) {
  const auto fail = [](const std::string& location, const char* what) {
    throw Error(ErrorCode::InvalidInput, fmt::format("{}: only cages have {}", location, what));
  };
  const std::map<std::string_view, const char*> options = {
      {ranges::kPatches.name, "faces, blocks or regions as patches"},
      {ranges::kWeld.name, "vertices to weld"},
      {ranges::kOrient.name, "faces to orient"},
      {ranges::kCreaseAngle.name, "creases by angle"},
      {ranges::kSurface.name, "a surface to choose"},
      {ranges::kFit.name, "points to fit a surface to"}};
  if (given.scheme != Scheme::Auto) fail(name, "a subdivision scheme");
  if (given.patches != PatchKind::Auto) fail(name, options.at(ranges::kPatches.name));
  if (given.weld && given.weld->value != 0) fail(name, options.at(ranges::kWeld.name));
  if (given.orient.value_or(false)) fail(name, options.at(ranges::kOrient.name));
  if (given.crease_angle.value_or(0) > 0) fail(name, options.at(ranges::kCreaseAngle.name));
  if (given.surface != SurfaceKind::Auto) fail(name, options.at(ranges::kSurface.name));
  if (given.fit && given.fit->value != 0) fail(name, options.at(ranges::kFit.name));
  for (const FileOption& entry : file.options) {
    const auto option = options.find(entry.name);
    if (option == options.end() || is_default(entry)) continue;
    fail(name + ": " + entry.origin, option->second);
  }
}

ModelInput load_cad(const std::filesystem::path& path, const LoadOptions& options,
                    const RunContext& context) {
  if (options.joining) fail_joining(path.string());
  check_without_cages({}, path.string(), options.cages);
  ModelInput input;
  input.model = detail::read_cad_file(path, options, options.cad);
  context.throw_if_cancelled();
  set_given(options, input.options);
  note_options(input.options, input.model);
  return input;
}

/// The cage with its vertices welded, which keep their numbers.
Cage welded(const Cage& cage, const std::optional<Length>& tolerance) {
  Cage result = cage;
  if (!tolerance || tolerance->value == 0) return result;
  check_option(ranges::kWeld, tolerance);
  weld(result, coincident_vertices(result, tolerance->in_units(diagonal(cage))));
  return result;
}

/// The whole cage has no border to make a crease of.
[[noreturn]] void fail_whole_cage(const Cage& cage, const std::string& name) {
  std::vector<std::string_view> groups;
  for (const Cage::FaceGroup& group : cage.groups) groups.push_back(group.name);
  throw Error(
      ErrorCode::InvalidInput,
      fmt::format("{} is the whole cage; a crease is the border of a group in its file, "
                  "which has {}",
                  name, groups.empty() ? "none" : fmt::format("{}", fmt::join(groups, ", "))));
}

/// Add a crease at the border of a group. Where vertices are welded, its edges are there only then.
void add_group_crease(const CageInput& input, const CreaseInput& crease,
                      const std::optional<Length>& tolerance, Cage& cage) {
  const auto is_meant = [&](const Cage::FaceGroup& group) { return group.name == crease.group; };
  const bool is_group = std::any_of(cage.groups.begin(), cage.groups.end(), is_meant);
  if (!is_group && crease.group == input.name) fail_whole_cage(cage, input.name);
  Cage joined = welded(cage, tolerance);
  add_crease_around(crease.group, crease.sharpness, joined);
  cage.creases = std::move(joined.creases);
}

/// Add the creases that a model file gives a cage.
void add_creases(const CageInput& input, const std::string& name,
                 const std::optional<Length>& tolerance, Cage& cage) {
  for (const CreaseInput& crease : input.creases) {
    at_file(fmt::format("{}: {}", name, crease.origin), [&] {
      if (crease.group.empty()) {
        add_crease(crease.vertices, crease.sharpness, cage);
      } else {
        add_group_crease(input, crease, tolerance, cage);
      }
    });
  }
}

/// Read the cages of a model file and add them to the model.
///
/// Returns  the groups that are whole cages
std::set<std::size_t> append_cages(const ModelFile& file, const std::string& name,
                                   const CageOptions& given, const RunContext& context,
                                   ModelInput& result) {
  Model& model = result.model;
  std::set<std::size_t> whole_cages;
  for (const CageInput& input : file.cages) {
    const CageOptions options = options_of(input, given, result.options);
    const std::string location = fmt::format("{}: {}/file", name, input.origin);
    Cage cage;
    at_file(location, [&] { cage = read_cage(input.file); });
    context.throw_if_cancelled();
    add_creases(input, name, options.weld, cage);
    Model part;
    at_file(location, [&] { part = model_of(cage, input.file, options); });
    Group& whole = part.groups.emplace_back();
    whole.name = input.name;
    for (std::size_t p = 0; p < part.patches.size(); ++p)
      whole.patches.push_back(static_cast<int>(p));
    append(model, std::move(part), input.name + ":");
    whole_cages.insert(model.groups.size() - 1);
  }
  return whole_cages;
}

/// Add the models of the CAD files of a model file.
/// Returns  the groups that are whole files
std::set<std::size_t> append_cad_files(const ModelFile& file, const std::string& name,
                                       const LoadOptions& given, const RunContext& context,
                                       ModelInput& result) {
  std::set<std::size_t> whole_files;
  for (const CadFileInput& input : file.cad) {
    if (input.name.empty() && !result.model.patches.empty()) {
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("{}: {}: a CAD file beside patches or cages needs a name", name,
                              input.origin));
    }
    CadOptions options = given.cad;
    if (!options.sew) options.sew = input.sew;
    if (!options.sew) options.sew = result.options.sew;
    Model part;
    at_file(fmt::format("{}: {}/file", name, input.origin),
            [&] { part = detail::read_cad_file(input.file, given, options); });
    context.throw_if_cancelled();
    detail::add_whole_group(input.name, part);
    append(result.model, std::move(part), input.name.empty() ? "" : input.name + ":");
    if (!input.name.empty()) whole_files.insert(result.model.groups.size() - 1);
  }
  return whole_files;
}

/// What a name may mean: the patches of groups of cages' files, of a cage, and the patch.
struct NamedPatches {
  std::set<int> of_groups;
  std::set<int> of_cage;
  std::set<int> patch;

  std::set<int> all() const {
    std::set<int> result = of_groups;
    result.insert(of_cage.begin(), of_cage.end());
    result.insert(patch.begin(), patch.end());
    return result;
  }

  /// What it means, if that is more than one thing and they are not the same patches.
  std::vector<std::string_view> meanings() const {
    std::vector<std::string_view> words;
    std::set<std::set<int>> different;
    const auto add = [&](const std::set<int>& patches, std::string_view what) {
      if (!patches.empty() && different.insert(patches).second) words.push_back(what);
    };
    add(patch, "a patch");
    add(of_cage, "a cage");
    add(of_groups, "a group");
    if (words.size() < 2) words.clear();
    return words;
  }
};

NamedPatches named_patches(const Model& model, const std::set<std::size_t>& whole_cages,
                           const std::string& name) {
  NamedPatches found;
  for (std::size_t p = 0; p < model.patches.size(); ++p) {
    if (model.patches[p].name == name) found.patch.insert(static_cast<int>(p));
  }
  for (std::size_t g = 0; g < model.groups.size(); ++g) {
    const Group& group = model.groups[g];
    if (group.name != name) continue;
    std::set<int>& kind = whole_cages.contains(g) ? found.of_cage : found.of_groups;
    kind.insert(group.patches.begin(), group.patches.end());
  }
  return found;
}

/// The group or formula patch that was probably meant.
std::string suggestion(const ModelFile& file, const Model& model, const std::string& name) {
  std::vector<std::string_view> words;
  for (const Group& group : model.groups) words.push_back(group.name);
  for (const PatchInput& patch : file.patches) words.push_back(patch.name);
  const auto meant = nearest_word(name, words);
  return meant ? fmt::format(", did you mean {}?", *meant) : "";
}

/// Tell that a name means more than one thing, all of which are taken.
void tell_meanings(const SpaceSource& source, const NamedPatches& found, const std::string& name,
                   Model& model) {
  const auto meanings = found.meanings();
  if (meanings.empty()) return;
  model.notices.push_back(
      warning_at(fmt::format("{}: {}/group", name, source.origin), NoticeKind::AmbiguousName,
                 fmt::format("{} is the name of {}; the source applies to all of them",
                             source.group, fmt::join(meanings, " and of "))));
}

/// The patches where a source of the model applies, or of its group.
std::vector<int> patches_of(const SpaceSource& source, const ModelFile& file,
                            const std::string& name, const std::set<std::size_t>& whole_cages,
                            Model& model) {
  if (source.patch >= 0) return {source.patch};
  if (source.group.empty()) {
    std::vector<int> all(model.patches.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
  }
  const NamedPatches found = named_patches(model, whole_cages, source.group);
  tell_meanings(source, found, name, model);
  const std::set<int> patches = found.all();
  if (patches.empty()) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{}: {}/group: there is no group or patch {}{}", name, source.origin,
                            source.group, suggestion(file, model, source.group)));
  }
  return {patches.begin(), patches.end()};
}

/// Adds a source of the model to those of the patches where it applies.
class SpaceSourceAdder {
 public:
  SpaceSourceAdder(std::vector<int> patches, bool is_everywhere, std::string origin,
                   const Model& model, Sources& sources)
      : patches_(std::move(patches)),
        is_everywhere_(is_everywhere),
        origin_(std::move(origin)),
        model_(model),
        sources_(sources) {}

  void operator()(const Size& size) const {
    for (const int patch : patches_) sources_.everywhere.push_back({patch, size, origin_});
  }

  void operator()(FieldSource field) const {
    for (const int patch : patches_) {
      field.patch = patch;
      sources_.fields.push_back(field);
    }
  }

  void operator()(NearSource near) const {
    if (!is_everywhere_) near.patches = patches_;
    sources_.near.push_back(std::move(near));
  }

  void operator()(BoxSource box) const {
    if (!is_everywhere_) box.patches = patches_;
    sources_.boxes.push_back(std::move(box));
  }

  void operator()(const BackgroundInput& background) const {
    for (const int patch : patches_) {
      FieldSource field = background_field(background.sizes, patch, model_.patch(patch).surface);
      field.precision = background.precision;
      field.origin = origin_;
      sources_.fields.push_back(std::move(field));
    }
  }

 private:
  std::vector<int> patches_;
  bool is_everywhere_;
  std::string origin_;
  const Model& model_;
  Sources& sources_;
};

void add_space_sources(const ModelFile& file, const std::string& name,
                       const std::set<std::size_t>& whole_cages, ModelInput& input) {
  for (const SpaceSource& source : file.space_sources) {
    const std::string origin = fmt::format("{}: {}", name, source.origin);
    const SpaceSourceAdder add(patches_of(source, file, name, whole_cages, input.model),
                               source.group.empty(), origin, input.model, input.sources);
    at_file(origin, [&] { std::visit(add, source.wish); });
  }
}

/// True for a name like "wing:u0". Contours of a named file have a colon, too.
bool is_side(const Model& model, const std::string& name) {
  return name.find(':') != std::string::npos && find_contour(model, name) < 0;
}

/// The uses of a side or a contour and its parts, by name, on one patch.
std::vector<std::shared_ptr<const Curve>> curves_on(const Model& model, const std::string& name,
                                                    int patch) {
  std::vector<std::shared_ptr<const Curve>> curves;
  const auto add = [&](const Contour& contour) {
    for (const ContourUse& use : contour.uses) {
      if (use.patch == patch) curves.push_back(use.curve);
    }
  };
  if (is_side(model, name)) {
    for (const LoopEntry& entry : side_uses(model, name)) add(model.contour(entry));
    return curves;
  }
  for (const Contour& contour : model.contours) {
    if (is_part_of(contour.name, name)) add(contour);
  }
  return curves;
}

/// The contours along which sizes are asked for stay in the mesh.
void name_contours(Model& model, const std::string& name) {
  if (is_side(model, name)) {
    for (const LoopEntry& entry : side_uses(model, name)) {
      model.contour(entry.contour).is_named = true;
    }
    return;
  }
  for (Contour& contour : model.contours) {
    if (is_part_of(contour.name, name)) contour.is_named = true;
  }
}

/// The patches in which a size along a contour may hold.
std::vector<int> patches_along(const AlongContour& along, const Model& model) {
  if (along.patch >= 0) return {along.patch};
  std::vector<int> all(model.patches.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

[[noreturn]] void fail_along(const AlongContour& along, const Model& model) {
  std::vector<std::string_view> names;
  for (const Contour& contour : model.contours) names.push_back(contour.name);
  const auto meant = nearest_word(along.contour, names);
  throw Error(ErrorCode::InvalidInput,
              fmt::format("{} is no contour or side of {}{}", along.contour,
                          along.patch >= 0 ? "this patch" : "the model",
                          meant ? fmt::format(", did you mean {}?", *meant) : ""));
}

void add_along_sources(const ModelFile& file, const std::string& name, ModelInput& input) {
  for (const AlongContour& along : file.along_contours) {
    at_file(fmt::format("{}: {}", name, along.origin), [&] {
      bool is_found = false;
      for (const int patch : patches_along(along, input.model)) {
        AlongSource source{patch, curves_on(input.model, along.contour, patch), along.wish,
                           fmt::format("{}: {}", name, along.origin)};
        if (source.curves.empty()) continue;
        is_found = true;
        input.sources.along.push_back(std::move(source));
      }
      if (!is_found) fail_along(along, input.model);
      name_contours(input.model, along.contour);
    });
  }
}

ModelInput load_model_file(const std::filesystem::path& path, const LoadOptions& given,
                           const RunContext& context) {
  const std::string name = path.string();
  const ModelFile file = read_model(path, places_of_options());
  ModelInput input;
  input.options = file_options(file, name);
  if (file.cages.empty()) check_without_cages(file, name, given.cages);
  set_given(given, input.options);
  if (file.patches.empty() && input.options.joining) fail_joining(name);
  if (file.cad.empty() && input.options.sew) fail_sew(name);
  if (!file.patches.empty()) {
    const JoinOptions join{input.options.joining.value_or(JoinOptions().joining)};
    at_file(name, [&] { input.model = model_from_patches(file.patches, file.contours, join); });
    for (Notice& notice : input.model.notices) locate(name, notice);
    for (Patch& patch : input.model.patches) patch.origin = name + ": " + patch.origin;
    for (const DividedPatch& divided : file.divided) {
      input.model.groups.push_back({divided.name, divided.pieces});
    }
  }
  auto whole_files = append_cages(file, name, given.cages, context, input);
  whole_files.merge(append_cad_files(file, name, given, context, input));
  note_options(input.options, input.model);
  input.sources = file.sources;
  for (const CageInput& cage : file.cages) input.files.push_back(cage.file);
  for (const CadFileInput& cad : file.cad) input.files.push_back(cad.file);
  input.files.insert(input.files.end(), file.tables.begin(), file.tables.end());
  add_space_sources(file, name, whole_files, input);
  add_along_sources(file, name, input);
  return input;
}

bool is_mesh(const std::filesystem::path& path) { return find_format(path) != nullptr; }

/// By the ending, see load_model.
ModelInput load(const std::filesystem::path& path, const LoadOptions& options,
                const RunContext& context) {
  if (has_cage_ending(path)) return load_cage(path, options, context);
  if (has_cad_ending(path)) return load_cad(path, options, context);
  if (lower_case_ending(path) != ".json") {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{}: {}the ending of a cage is {}, that of a CAD file .step, .stp, "
                            ".iges, .igs or .brep, that of a model file .json",
                            path.string(), is_mesh(path) ? "this is a mesh, no model; " : "",
                            cage_endings()));
  }
  return load_model_file(path, options, context);
}

}  // namespace

ModelInput load_model(const std::filesystem::path& path, const LoadOptions& options,
                      Observer* observer) try {
  const RunContext context(observer);
  ModelInput input = load(path, options, context);
  context.throw_if_cancelled();
  at_file(path.string(), [&] { check(input.model); });
  input.files.insert(input.files.begin(), path);
  return input;
} catch (const std::bad_alloc&) {
  fail_without_memory("while reading " + path.string());
}

}  // namespace surfmesh
