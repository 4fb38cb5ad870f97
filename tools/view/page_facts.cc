// SPDX-License-Identifier: BSD-3-Clause
#include "view/page_facts.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "pictures/colours.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/version.hh"
#include "surfmesh/metric/tensor.hh"
#include "surfmesh/pipeline/notice_json.hh"
#include "surfmesh/quality/mesh_field.hh"
#include "surfmesh/quality/statistics.hh"

namespace surfmesh {
namespace {

constexpr std::array kMaps = {std::pair(ColourMap::Amounts, "amounts"),
                              std::pair(ColourMap::Goodness, "goodness"),
                              std::pair(ColourMap::Deviations, "deviations")};

/// More patches than this share colours, which nobody could tell apart anyway.
constexpr std::size_t kMostCategories = 997;

/// How many patches a mesh has, with those that only have a name.
std::size_t patch_count(const PolyMesh& mesh, const MeshNames& names) {
  std::size_t count = names.patches.size();
  const auto patch_of = find(mesh, keys::face_patch);
  if (!patch_of.is_valid()) return count;
  for (const FaceHandle fh : mesh.faces()) {
    const int patch = mesh.property(patch_of, fh);
    if (patch >= 0) count = std::max(count, static_cast<std::size_t>(patch) + 1);
  }
  return count;
}

Json patches_json(std::size_t count, const MeshNames& names, const PageOrigins& origins) {
  Json json = Json::array();
  for (std::size_t p = 0; p < count; ++p) {
    const Uv origin = p < origins.of_patches.size() ? origins.of_patches[p] : Uv{0, 0};
    const bool has_origin = std::isfinite(origin.u);
    json.push_back({{"name", p < names.patches.size() ? names.patches[p] : std::string()},
                    {"origin", {has_origin ? origin.u : 0.0, has_origin ? origin.v : 0.0}}});
  }
  return json;
}

Json groups_json(const MeshNames& names) {
  Json json = Json::array();
  for (const Group& group : names.groups) {
    json.push_back({{"name", group.name}, {"patches", group.patches}});
  }
  return json;
}

Json maps_json() {
  Json json = Json::object();
  for (const auto& [map, name] : kMaps) {
    Json colours = Json::array();
    for (const Rgb& colour : stops(map)) colours.push_back(hex(colour));
    json[name] = std::move(colours);
  }
  return json;
}

Json categories_json(std::size_t count) {
  Json json = Json::array();
  for (std::size_t i = 0; i < std::clamp<std::size_t>(count, 1, kMostCategories); ++i) {
    json.push_back(hex(category_colour(i)));
  }
  return json;
}

Json scale_json(const ColourScale& scale) {
  const auto* map = std::find_if(kMaps.begin(), kMaps.end(),
                                 [&](const auto& named) { return named.first == scale.map; });
  return {{"map", map->second}, {"from", scale.from}, {"to", scale.to}, {"log", scale.is_log}};
}

bool is_closed(const PolyMesh& mesh) {
  const auto edges = mesh.edges();
  return std::none_of(edges.begin(), edges.end(),
                      [&](EdgeHandle eh) { return mesh.is_boundary(eh); });
}

bool has_mostly_quads(const PolyMesh& mesh) {
  std::size_t quads = 0;
  for (const FaceHandle fh : mesh.faces()) quads += mesh.valence(fh) == 4 ? 1U : 0U;
  return 2 * quads > mesh.n_faces();
}

/// The fields that the mesh has, whose values go into the arrays. Those of patches are there
/// already.
Json fields_json(const PageContents& contents, PageArrays& arrays) {
  const bool is_of_quads = has_mostly_quads(contents.mesh);
  Json json = Json::array();
  for (const FieldDescription& field : mesh_fields()) {
    if (!has_field(contents.mesh, contents.names, field.field)) continue;
    Json entry = {{"name", field.name},
                  {"text", field.text},
                  {"category", field.is_category},
                  {"of", field.of == FieldOf::Faces ? "faces" : "vertices"}};
    if (!field.is_category) {
      const auto values = measure_field(contents.mesh, contents.names, field.field);
      entry["scale"] = scale_json(scale_of(field.field, values, is_of_quads));
      arrays.add_shown(fmt::format("field_{}", field.name),
                       std::vector<float>(values.begin(), values.end()));
    }
    json.push_back(std::move(entry));
  }
  return json;
}

/// Null without a metric.
Json edges_json(const PolyMesh& mesh) {
  if (!has_parameters(mesh) || !has_metric(mesh)) return nullptr;
  const EdgeStatistics edges = measure_edges(mesh);
  Json histogram = Json::array();
  for (const HistogramBin& bin : edges.histogram) {
    histogram.push_back({{"from", bin.from}, {"to", bin.to}, {"count", bin.count}});
  }
  return {{"count", edges.count},
          {"mean", edges.mean},
          {"deviation", edges.stddev},
          {"min", edges.min},
          {"max", edges.max},
          {"unit_share", edges.unit_fraction},
          {"histogram", std::move(histogram)}};
}

/// The control meshes of all patches, one after the other.
class ControlArrays {
 public:
  /// Returns where the mesh of the patch is in the arrays.
  Json add(const ControlSpace& space, Uv origin) {
    const PolyMesh& mesh = space.mesh();
    const Json json = {{"nodes", mesh.n_vertices()}, {"faces", mesh.n_faces()}};
    const auto uv_of = require(mesh, keys::vertex_uv);
    const auto size_of = require(mesh, keys::vertex_size);
    for (const VertexHandle vh : mesh.vertices()) {
      const Uv uv = mesh.property(uv_of, vh) - origin;
      const Metric m = metric_from_size(space.form(vh.idx()), mesh.property(size_of, vh));
      for (const double x : {uv.u, uv.v}) uv_.push_back(static_cast<float>(x));
      for (const double x : {m.m11, m.m12, m.m22}) metric_.push_back(static_cast<float>(x));
    }
    const auto class_of = find(mesh, keys::face_class);
    for (const FaceHandle fh : mesh.faces()) {
      const int face_class = class_of.is_valid() ? mesh.property(class_of, fh) : -1;
      class_.push_back(static_cast<std::uint32_t>(face_class));
      sizes_.push_back(mesh.valence(fh));
      for (const VertexHandle vh : mesh.fv_range(fh)) {
        corners_.push_back(static_cast<std::uint32_t>(vh.idx()));
      }
    }
    return json;
  }

  void move_to(PageArrays& arrays) {
    arrays.add("control_uv", std::move(uv_));
    arrays.add_shown("control_metric", std::move(metric_));
    arrays.add("control_class", std::move(class_));
    arrays.add("control_sizes", std::move(sizes_));
    arrays.add_steps("control_corners", std::move(corners_));
  }

 private:
  std::vector<float> uv_, metric_;
  std::vector<std::uint32_t> class_, sizes_, corners_;
};

Json control_json(const PageContents& contents, const PageOrigins& origins, PageArrays& arrays) {
  if (contents.control == nullptr) return nullptr;
  ControlArrays control;
  Json json = Json::array();
  for (std::size_t p = 0; p < contents.control->spaces.size(); ++p) {
    const Uv origin = p < origins.of_patches.size() ? origins.of_patches[p] : Uv{0, 0};
    json.push_back(control.add(*contents.control->spaces[p], origin));
  }
  control.move_to(arrays);
  return json;
}

/// With the numbers of patches, by which the page finds them, not with names.
Json notices_json(const Notices& notices) {
  Json json = detail::notices_json(notices, [](int) { return std::string(); });
  for (std::size_t i = 0; i < notices.size(); ++i) json[i]["patch"] = notices[i].patch;
  return json;
}

}  // namespace

Json page_facts(const PageContents& contents, const PageOrigins& origins, PageArrays& arrays) {
  const std::size_t patches = patch_count(contents.mesh, contents.names);
  const Vec3& centre = origins.centre;
  Json fields = fields_json(contents, arrays);
  Json control = control_json(contents, origins, arrays);
  return {{"format", kPageFormat},
          {"version", SURFMESH_VERSION},
          {"title", contents.title},
          {"model", contents.model},
          {"centre", {centre.x(), centre.y(), centre.z()}},
          {"radius", origins.radius},
          {"closed", is_closed(contents.mesh)},
          {"patches", patches_json(patches, contents.names, origins)},
          {"groups", groups_json(contents.names)},
          {"contours", contents.names.contours},
          {"fields", std::move(fields)},
          {"maps", maps_json()},
          {"categories", categories_json(std::max(patches, contents.names.groups.size()))},
          {"no_value", hex(kNoValueColour)},
          {"edges", edges_json(contents.mesh)},
          {"control", std::move(control)},
          {"notices", notices_json(contents.notices)},
          {"report",
           contents.report == nullptr ? Json(nullptr) : Json::parse(to_json(*contents.report))}};
}

}  // namespace surfmesh
