// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/part_names.hh"

#include <fmt/format.h>
#include <BRep_Builder.hxx>
#include <Quantity_Color.hxx>
#include <TCollection_AsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <algorithm>
#include <array>
#include <cctype>
#include <map>

namespace surfmesh {
namespace {

/// Names that programs write for want of one.
constexpr std::array<std::string_view, 8> kNoNames = {"NONE", "''",    "SOLID",    "SHELL",
                                                      "FACE", "SHEET", "COMPOUND", "ASSEMBLY"};

/// OpenCASCADE's own writer calls products so, with numbers behind it.
constexpr std::string_view kWriterName = "Open CASCADE STEP translator";

/// A name without control characters and white space around it; empty if it tells nothing.
std::string tidy(std::string name) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < ' '; };
  std::replace_if(name.begin(), name.end(), is_control, ' ');
  const std::size_t begin = name.find_first_not_of(' ');
  if (begin == std::string::npos) return {};
  name = name.substr(begin, name.find_last_not_of(' ') - begin + 1);
  if (name.starts_with(kWriterName)) return {};
  return std::find(kNoNames.begin(), kNoNames.end(), name) == kNoNames.end() ? name : "";
}

std::string name_of(const TDF_Label& label) {
  Handle(TDataStd_Name) name;
  if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return {};
  // Without a replacement, letters that ASCII has not become UTF-8.
  return tidy(TCollection_AsciiString(name->Get(), '\0').ToCString());
}

/// Walks through the tree of an assembly.
class Assembly {
 public:
  explicit Assembly(const Handle(TDocStd_Document) & document)
      : shapes_(XCAFDoc_DocumentTool::ShapeTool(document->Main())),
        colours_(XCAFDoc_DocumentTool::ColorTool(document->Main())) {
    BRep_Builder().MakeCompound(all_);
  }

  CadShape read() {
    TDF_LabelSequence roots;
    shapes_->GetFreeShapes(roots);
    for (const TDF_Label& root : roots) walk(root, TopLoc_Location(), "");
    cad_.shape = all_;
    return std::move(cad_);
  }

 private:
  /// The colour of a label; "" for none.
  std::string colour_of(const TDF_Label& label) const {
    for (const auto kind : {XCAFDoc_ColorSurf, XCAFDoc_ColorGen}) {
      Quantity_Color colour;
      if (!colours_->GetColor(label, kind, colour)) continue;
      std::string text = Quantity_Color::ColorToHex(colour).ToCString();
      std::transform(text.begin(), text.end(), text.begin(),
                     [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
      return text;
    }
    return {};
  }

  /// `colour` is that of what is around, which counts: it is of this copy of the part.
  void walk(const TDF_Label& label, const TopLoc_Location& location, const std::string& colour) {
    TDF_Label part = label;
    TopLoc_Location here = location;
    if (XCAFDoc_ShapeTool::IsReference(label)) {
      XCAFDoc_ShapeTool::GetReferredShape(label, part);
      here = location * XCAFDoc_ShapeTool::GetLocation(label);
    }
    const std::string own = colour_of(label);
    const std::string outer = colour.empty() ? own : colour;
    if (!XCAFDoc_ShapeTool::IsAssembly(part)) return add_leaf(part, here, outer);
    TDF_LabelSequence components;
    XCAFDoc_ShapeTool::GetComponents(part, components);
    const std::string around = outer.empty() ? colour_of(part) : outer;
    for (const TDF_Label& component : components) walk(component, here, around);
  }

  void add_leaf(const TDF_Label& part, const TopLoc_Location& location, const std::string& colour) {
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(part).Moved(location);
    if (shape.IsNull()) return;  // a product without a shape
    BRep_Builder().Add(all_, shape);
    FaceFacts facts;
    facts.part = static_cast<int>(cad_.parts.size());
    facts.colour = colour.empty() ? colour_of(part) : colour;
    cad_.parts.push_back(name_of(part));
    for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
      if (!cad_.facts.IsBound(face.Current())) cad_.facts.Bind(face.Current(), facts);
    }
    add_inner(part, location);
  }

  /// Names and colours of bodies and faces within a part: larger shapes first.
  void add_inner(const TDF_Label& part, const TopLoc_Location& location) {
    TDF_LabelSequence inner;
    XCAFDoc_ShapeTool::GetSubShapes(part, inner);
    std::multimap<int, TDF_Label> by_kind;
    for (const TDF_Label& label : inner) {
      const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(label);
      if (!shape.IsNull()) by_kind.emplace(shape.ShapeType(), label);
    }
    for (const auto& [kind, label] : by_kind) add_facts(label, location);
  }

  void add_facts(const TDF_Label& label, const TopLoc_Location& location) {
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(label).Moved(location);
    if (shape.ShapeType() > TopAbs_FACE) return;
    const std::string name = name_of(label), colour = colour_of(label);
    for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
      FaceFacts* facts = cad_.facts.ChangeSeek(face.Current());
      if (facts == nullptr) continue;
      if (!colour.empty()) facts->colour = colour;
      if (!name.empty()) (shape.ShapeType() == TopAbs_FACE ? facts->name : facts->body) = name;
    }
  }

  Handle(XCAFDoc_ShapeTool) shapes_;
  Handle(XCAFDoc_ColorTool) colours_;
  TopoDS_Compound all_;
  CadShape cad_;
};

std::vector<std::string> numbered(const std::vector<std::string>& names) {
  std::map<std::string, int> counts, seen;
  for (const std::string& name : names) ++counts[name];
  std::vector<std::string> result;
  for (const std::string& name : names) {
    const bool is_alone = counts[name] == 1;
    result.push_back(is_alone ? name : fmt::format("{}.{}", name, ++seen[name]));
  }
  return result;
}

}  // namespace

CadShape named_shape(const Handle(TDocStd_Document) & document) {
  return Assembly(document).read();
}

PartNames::PartNames(const CadShape& cad)
    : shared_(cad.parts), next_(cad.parts.size() + 1, 0), has_several_(cad.parts.size() > 1) {
  for (std::string& name : shared_) {
    if (name.empty() && has_several_) name = "part";
  }
  unique_ = numbered(shared_);
}

std::string PartNames::part_of(const FaceFacts& facts) const {
  return facts.part < 0 ? std::string() : unique_[static_cast<std::size_t>(facts.part)];
}

std::string PartNames::next_patch(const FaceFacts& facts) {
  const int number = ++next_[static_cast<std::size_t>(facts.part + 1)];
  std::string name = facts.name.empty() ? fmt::format("face{}", number) : facts.name;
  if (has_several_ && facts.part >= 0) name = fmt::format("{}:{}", part_of(facts), name);
  std::string result = name;
  for (int copy = 2; !taken_.insert(result).second; ++copy)
    result = fmt::format("{}-{}", name, copy);
  return result;
}

void PartNames::add_to_groups(int patch, const FaceFacts& facts, std::vector<Group>& groups) const {
  if (const std::string part = part_of(facts); !part.empty()) {
    const std::string& shared = shared_[static_cast<std::size_t>(facts.part)];
    if (shared != part) add_to_group(shared, patch, groups);
    add_to_group(part, patch, groups);
  }
  if (!facts.body.empty() && facts.body != part_of(facts)) add_to_group(facts.body, patch, groups);
  if (!facts.colour.empty()) add_to_group(fmt::format("colour {}", facts.colour), patch, groups);
}

void add_to_group(const std::string& name, int patch, std::vector<Group>& groups) {
  auto found = std::find_if(groups.begin(), groups.end(),
                            [&name](const Group& group) { return group.name == name; });
  if (found == groups.end()) found = groups.insert(found, Group{name, {}});
  if (found->patches.empty() || found->patches.back() != patch) found->patches.push_back(patch);
}

}  // namespace surfmesh
