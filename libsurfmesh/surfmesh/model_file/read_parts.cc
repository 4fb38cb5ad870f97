// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model_file/read_parts.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "surfmesh/cage/mend_cage.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/formula/formula_curve.hh"
#include "surfmesh/io/nearest_word.hh"
#include "surfmesh/model/cad_input.hh"
#include "surfmesh/model_file/read_nurbs.hh"

namespace surfmesh {
namespace {

Scheme read_scheme(const JsonNode& node) {
  const std::string text = node.text();
  if (text == "auto") return Scheme::Auto;
  if (text == "catmark") return Scheme::CatmullClark;
  if (text == "loop") return Scheme::Loop;
  if (text == "bilinear") return Scheme::Bilinear;
  node.fail("must be auto, catmark, loop or bilinear");
}

PatchKind read_patch_kind(const JsonNode& node) {
  const std::string text = node.text();
  if (text == "auto") return PatchKind::Auto;
  if (text == "faces") return PatchKind::Faces;
  if (text == "blocks") return PatchKind::Blocks;
  if (text == "regions") return PatchKind::Regions;
  node.fail("must be faces, blocks, regions or auto");
}

SurfaceKind read_surface_kind(const JsonNode& node) {
  const std::string text = node.text();
  if (text == "auto") return SurfaceKind::Auto;
  if (text == "limit") return SurfaceKind::Limit;
  if (text == "interpolate") return SurfaceKind::Interpolate;
  node.fail("must be limit, interpolate or auto");
}

/// A length, true or "on" for the usual one; 0, false or "off" for none.
Length read_on_or_length(const JsonNode& node, const LengthRange& range) {
  const Json& json = node.json();
  if (json == 0 || json == "off") return Length();
  if (json == "on") return Length::share(range.on);
  if (!json.is_boolean()) return read_length(node);
  return node.boolean() ? Length::share(range.on) : Length();
}

/// A length; 0, false or "off" for none.
Length read_off_or_length(const JsonNode& node) {
  const Json& json = node.json();
  if (json == 0 || json == "off" || json == false) return Length();
  return read_length(node);
}

/// An angle of creases in degrees, 0 or false for none.
double read_angle(const JsonNode& node) {
  if (node.json().is_boolean() && !node.boolean()) return 0;
  const double angle = node.number();
  if (!(angle >= 0 && angle <= 180)) node.fail("must be an angle from 0 to 180 degrees");
  return angle;
}

int read_vertex(const JsonNode& node) {
  const double number = node.number();
  if (!(number >= 0 && number <= std::numeric_limits<int>::max() && number == std::floor(number))) {
    node.fail("must be the number of a vertex, from 0");
  }
  return static_cast<int>(number);
}

CreaseInput read_crease(const JsonNode& node) {
  node.expect_keys({"vertices", "group", "sharpness"});
  if (node.has("vertices") == node.has("group")) node.fail("a crease needs vertices or a group");
  CreaseInput crease;
  if (const auto group = node.find("group")) crease.group = read_name(*group);
  if (const auto vertices = node.find("vertices")) {
    for (const JsonNode& vertex : vertices->elements())
      crease.vertices.push_back(read_vertex(vertex));
    if (crease.vertices.size() < 2) vertices->fail("a crease needs two vertices");
  }
  if (const auto sharpness = node.find("sharpness")) {
    crease.sharpness = sharpness->number();
    if (!(crease.sharpness >= 0)) sharpness->fail("must not be negative");
  }
  crease.origin = node.pointer();
  return crease;
}

CageInput read_cage_input(const JsonNode& node, const std::filesystem::path& folder) {
  node.expect_keys({"name", "file", "scheme", "patches", "weld", "orient", "crease_angle",
                    "creases", "surface", "fit"});
  CageInput cage;
  cage.name = read_name(node.at("name"));
  const std::string file = node.at("file").text();
  if (file.empty()) node.at("file").fail("must not be empty");
  cage.file = folder / file;
  if (const auto scheme = node.find("scheme")) cage.scheme = read_scheme(*scheme);
  if (const auto patches = node.find("patches")) cage.patches = read_patch_kind(*patches);
  if (const auto weld = node.find("weld")) cage.weld = read_on_or_length(*weld, ranges::kWeld);
  if (const auto orient = node.find("orient")) cage.orient = orient->boolean();
  if (const auto angle = node.find("crease_angle")) cage.crease_angle = read_angle(*angle);
  if (const auto surface = node.find("surface")) cage.surface = read_surface_kind(*surface);
  // Null is for what the options tell, as it is in these.
  if (const auto fit = node.find("fit"); fit && !fit->json().is_null()) {
    cage.fit = read_off_or_length(*fit);
  }
  if (const auto creases = node.find("creases")) {
    for (const JsonNode& crease : creases->elements()) cage.creases.push_back(read_crease(crease));
  }
  cage.origin = node.pointer();
  return cage;
}

CadFileInput read_cad_file(const JsonNode& node, const std::filesystem::path& folder) {
  node.expect_keys({"name", "file", "sew"});
  CadFileInput cad;
  if (const auto name = node.find("name")) cad.name = read_name(*name);
  const std::string file = node.at("file").text();
  if (file.empty()) node.at("file").fail("must not be empty");
  cad.file = folder / file;
  if (!has_cad_ending(cad.file))
    node.at("file").fail("must end in .step, .stp, .iges, .igs or .brep");
  if (const auto sew = node.find("sew")) cad.sew = read_on_or_length(*sew, ranges::kSew);
  cad.origin = node.pointer();
  return cad;
}

/// A curve of knots on a patch. Where the contour has no range and no curve yet, it takes its own.
ContourInput::On read_nurbs_on(const JsonNode& node, const std::optional<CurveRange>& range,
                               const Constants& constants, ContourInput& contour) {
  node.expect_keys({"patch", "nurbs"});
  const auto curve = read_nurbs_curve(node.at("nurbs"), range, constants);
  const bool is_first = !contour.xyz && std::none_of(contour.on.begin(), contour.on.end(),
                                                     [](const auto& on) { return on.curve; });
  if (is_first) contour.breaks = curve->breaks();
  if (is_first && !range) contour.range = curve->range();
  return {node.at("patch").text(), curve};
}

ContourInput::On read_on(const JsonNode& node, const CurveRange& range,
                         const Constants& constants) {
  node.expect_keys({"patch", "u", "v", "where", "nurbs"});
  ContourInput::On on{node.at("patch").text(), nullptr};
  if (!node.has("u") && !node.has("v") && !node.has("where")) return on;
  FormulaNode formula(node, {"t"}, constants);
  const CurveFormulas formulas{formula.text("u"), formula.text("v"), formula.where()};
  on.curve =
      at_node(node, [&] { return std::make_shared<FormulaCurve>(formulas, range, constants); });
  return on;
}

std::shared_ptr<const SpaceCurve> read_xyz(const JsonNode& node, const CurveRange& range,
                                           const Constants& constants) {
  node.expect_keys({"x", "y", "z", "where"});
  FormulaNode formula(node, {"t"}, constants);
  const SpaceCurveFormulas formulas{formula.text("x"), formula.text("y"), formula.text("z"),
                                    formula.where()};
  return at_node(node,
                 [&] { return std::make_shared<FormulaSpaceCurve>(formulas, range, constants); });
}

ContourInput read_contour(const JsonNode& node, const Constants& constants) {
  node.expect_keys({"name", "range", "xyz", "on"});
  ContourInput contour;
  contour.name = read_name(node.at("name"));
  if (contour.name.find(':') != std::string::npos) {
    node.at("name").fail("the name of a contour has no colon, which sides have");
  }
  contour.origin = node.pointer();
  std::optional<CurveRange> given;
  if (const auto range = node.find("range")) {
    std::tie(contour.range.from, contour.range.to) = read_range(*range, constants);
    given = contour.range;
  }
  const CurveRange of_formulas = contour.range;
  if (const auto xyz = node.find("xyz")) contour.xyz = read_xyz(*xyz, of_formulas, constants);
  if (const auto on = node.find("on")) {
    for (const JsonNode& entry : on->elements()) {
      contour.on.push_back(entry.has("nurbs") ? read_nurbs_on(entry, given, constants, contour)
                                              : read_on(entry, of_formulas, constants));
    }
  }
  const bool has_curve = std::any_of(contour.on.begin(), contour.on.end(),
                                     [](const ContourInput::On& on) { return on.curve; });
  if (!contour.xyz && !has_curve) node.fail("a contour needs xyz, or u and v on a patch");
  return contour;
}

/// Names that are known, and the order in which they became so.
class Names {
 public:
  void add(std::string name) {
    if (known_.insert(name).second) words_.push_back(std::move(name));
  }

  bool contains(std::string_view name) const { return known_.contains(name); }
  std::vector<std::string_view> words() const { return {words_.begin(), words_.end()}; }

 private:
  std::set<std::string, std::less<>> known_;
  std::vector<std::string> words_;
};

/// Fail unless a name is one of those that are known.
void expect_name(const JsonNode& node, std::string_view name, const Names& known,
                 std::string_view what) {
  if (known.contains(name)) return;
  const auto meant = nearest_word(name, known.words());
  node.fail(fmt::format("there is no {} {}{}", what, name,
                        meant ? fmt::format(", did you mean {}?", *meant) : ""));
}

/// Add the names of the elements of an array; fail for one that is there twice.
void add_names(const JsonNode& root, const char* key, const char* what,
               std::set<std::string>& names) {
  const auto list = root.find(key);
  if (!list) return;
  for (const JsonNode& node : list->elements()) {
    if (!node.has("name")) continue;  // a single CAD file
    const JsonNode name = node.at("name");
    if (names.insert(name.text()).second) continue;
    name.fail(fmt::format("there are two {} with the name {}", what, name.text()));
  }
}

void check_loops(const JsonNode& root, const Names& names) {
  const auto patches = root.find("patches");
  if (!patches) return;
  for (const JsonNode& patch : patches->elements()) {
    const auto loops = patch.find("loops");
    if (!loops) continue;
    for (const JsonNode& loop : loops->elements()) {
      for (const JsonNode& mention : loop.elements()) {
        const std::string text = mention.text();
        const std::string_view name = std::string_view(text).substr(text.starts_with('-') ? 1 : 0);
        expect_name(mention, name, names, "contour");
      }
    }
  }
}

void check_contours(const JsonNode& root, const Names& formula_patches) {
  const auto contours = root.find("contours");
  if (!contours) return;
  for (const JsonNode& contour : contours->elements()) {
    const auto on = contour.find("on");
    if (!on) continue;
    for (const JsonNode& entry : on->elements()) {
      const JsonNode patch = entry.at("patch");
      expect_name(patch, patch.text(), formula_patches, "patch with formulas");
    }
  }
}

}  // namespace

std::vector<CageInput> read_cages(const JsonNode& node, const std::filesystem::path& folder) {
  std::vector<CageInput> cages;
  for (const JsonNode& cage : node.elements()) cages.push_back(read_cage_input(cage, folder));
  return cages;
}

std::vector<CadFileInput> read_cad_files(const JsonNode& node,
                                         const std::filesystem::path& folder) {
  std::vector<CadFileInput> files;
  for (const JsonNode& file : node.elements()) files.push_back(read_cad_file(file, folder));
  if (files.size() < 2) return files;
  for (const JsonNode& file : node.elements()) {
    if (!file.has("name")) file.fail("several CAD files need names");
  }
  return files;
}

std::vector<ContourInput> read_contours(const JsonNode& node, const Constants& constants) {
  std::vector<ContourInput> contours;
  for (const JsonNode& contour : node.elements()) {
    contours.push_back(read_contour(contour, constants));
  }
  return contours;
}

std::vector<std::vector<std::string>> read_loops(const JsonNode& node) {
  std::vector<std::vector<std::string>> loops;
  for (const JsonNode& loop : node.elements()) {
    std::vector<std::string>& names = loops.emplace_back();
    for (const JsonNode& name : loop.elements()) names.push_back(name.text());
    if (names.empty()) loop.fail("a loop must not be empty");
  }
  return loops;
}

void check_names(const JsonNode& root, const ModelFile& model) {
  std::set<std::string> patches, contours;
  add_names(root, "patches", "patches", patches);
  add_names(root, "cages", "patches or cages", patches);
  add_names(root, "cad", "patches, cages or CAD files", patches);
  add_names(root, "contours", "contours", contours);
  Names formula_patches, names;
  for (const std::string& contour : contours) names.add(contour);
  for (const PatchInput& patch : model.patches) {
    formula_patches.add(patch.name);
    for (const char* side : {"u0", "u1", "v0", "v1"}) names.add(patch.name + ":" + side);
  }
  check_loops(root, names);
  check_contours(root, formula_patches);
}

}  // namespace surfmesh
