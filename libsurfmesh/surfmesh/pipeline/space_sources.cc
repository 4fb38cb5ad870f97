// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/space_sources.hh"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <numeric>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "surfmesh/core/error.hh"
#include "surfmesh/io/nearest_word.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/pipeline/at_file.hh"

namespace surfmesh::detail {
namespace {

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

NamedPatches named_patches(const Model& model, const std::set<std::size_t>& whole_files,
                           const std::string& name) {
  NamedPatches found;
  for (std::size_t p = 0; p < model.patches.size(); ++p) {
    if (model.patches[p].name == name) found.patch.insert(static_cast<int>(p));
  }
  for (std::size_t g = 0; g < model.groups.size(); ++g) {
    const Group& group = model.groups[g];
    if (group.name != name) continue;
    std::set<int>& kind = whole_files.contains(g) ? found.of_cage : found.of_groups;
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
                            const std::string& name, const std::set<std::size_t>& whole_files,
                            Model& model) {
  if (source.patch >= 0) return {source.patch};
  if (source.group.empty()) {
    std::vector<int> all(model.patches.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
  }
  const NamedPatches found = named_patches(model, whole_files, source.group);
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

}  // namespace

void add_space_sources(const ModelFile& file, const std::string& name,
                       const std::set<std::size_t>& whole_files, ModelInput& input) {
  for (const SpaceSource& source : file.space_sources) {
    const std::string origin = fmt::format("{}: {}", name, source.origin);
    const SpaceSourceAdder add(patches_of(source, file, name, whole_files, input.model),
                               source.group.empty(), origin, input.model, input.sources);
    at_file(origin, [&] { std::visit(add, source.wish); });
  }
}

}  // namespace surfmesh::detail
