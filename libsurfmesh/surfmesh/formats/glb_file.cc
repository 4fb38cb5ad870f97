// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/glb_file.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/formats/mesh_elements.hh"
#include "surfmesh/formats/smooth_normals.hh"
#include "surfmesh/formats/split_face.hh"
#include "surfmesh/io/file_writer.hh"
#include "surfmesh/io/json_node.hh"

namespace surfmesh {
namespace {

constexpr std::uint32_t kMagic = 0x46546C67, kJson = 0x4E4F534A, kBinary = 0x004E4942;
constexpr int kFloat = 5126, kUnsigned = 5125;
constexpr int kArrayBuffer = 34962, kIndexBuffer = 34963;

using Float2 = std::array<float, 2>;
using Float3 = std::array<float, 3>;

/// What a vertex of the file has.
struct Attributes {
  Float3 normal = {};
  Float2 uv = {};

  friend bool operator==(const Attributes&, const Attributes&) = default;
};

/// The faces of a patch, as a range of all triangles.
struct Primitive {
  int patch = -1;
  std::size_t first = 0;  ///< triangle
  std::size_t end = 0;
};

/// The vertices of the file, one for each place with its normal and parameters, and the triangles,
/// patch by patch.
class GlbMesh {
 public:
  GlbMesh(const PolyMesh& mesh, const OutputOptions& options) : mesh_(mesh) {
    is_texture_ = options.texture && find(mesh, keys::corner_texture).is_valid();
    has_uv_ = is_texture_ || (options.uv && find(mesh, keys::corner_uv).is_valid());
    number_corners();
    collect_triangles();
  }

  const std::vector<Float3>& positions() const { return positions_; }
  const std::vector<Attributes>& attributes() const { return attributes_; }
  bool has_uv() const { return has_uv_; }
  const std::vector<std::uint32_t>& indices() const { return indices_; }
  const std::vector<Primitive>& primitives() const { return primitives_; }

 private:
  void number_corners() {
    const auto normal_of = find(mesh_, keys::corner_normal);
    const auto uv_of = find(mesh_, is_texture_ ? keys::corner_texture : keys::corner_uv);
    const std::vector<Vec3> estimates =
        normal_of.is_valid() ? std::vector<Vec3>() : smooth_normals(mesh_);
    number_of_.resize(mesh_.n_halfedges());
    positions_.reserve(mesh_.n_vertices());
    attributes_.reserve(mesh_.n_vertices());
    for (const VertexHandle vh : mesh_.vertices()) {
      const std::size_t before = attributes_.size();
      for (const HalfedgeHandle heh : mesh_.vih_range(vh)) {
        if (mesh_.is_boundary(heh)) continue;
        Attributes attributes;
        const Normal given = normal_of.is_valid() ? mesh_.property(normal_of, heh)
                                                  : to_normal(estimates[index(heh)]);
        attributes.normal = {single(given.x), single(given.y), single(given.z)};
        if (has_uv_) {
          Uv uv = mesh_.property(uv_of, heh);
          // The format has values at all vertices or at none.
          if (is_texture_ && std::isnan(uv.u)) uv = {0, 0};
          attributes.uv = {single(uv.u), single(uv.v)};
        }
        check(heh, attributes);
        number_of_[index(heh)] = number_among(before, vh, attributes);
      }
    }
  }

  static Normal to_normal(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
  static float single(double x) { return static_cast<float>(x); }

  void check(HalfedgeHandle heh, const Attributes& attributes) const {
    const auto [x, y, z] = attributes.normal;
    const bool has_normal = std::isfinite(x) && std::isfinite(y) && std::isfinite(z);
    if (has_normal && std::isfinite(attributes.uv[0]) && std::isfinite(attributes.uv[1])) return;
    throw Error(ErrorCode::Geometry,
                fmt::format("a corner of face {} at vertex {} has no finite {}",
                            mesh_.face_handle(heh).idx(), mesh_.to_vertex_handle(heh).idx(),
                            has_normal ? keys::corner_uv.name : keys::corner_normal.name));
  }

  /// The number of a vertex of the file; those of this vertex of the mesh come after `before`.
  std::uint32_t number_among(std::size_t before, VertexHandle vh, const Attributes& attributes) {
    const auto found = std::find(attributes_.begin() + static_cast<std::ptrdiff_t>(before),
                                 attributes_.end(), attributes);
    const auto number = static_cast<std::uint32_t>(found - attributes_.begin());
    if (found != attributes_.end()) return number;
    const OpenMesh::Vec3d& point = mesh_.point(vh);
    positions_.push_back({single(point[0]), single(point[1]), single(point[2])});
    attributes_.push_back(attributes);
    return number;
  }

  void collect_triangles() {
    const auto patch_of = find(mesh_, keys::face_patch);
    const auto patch = [&](int face) {
      return patch_of.is_valid() ? std::max(-1, mesh_.property(patch_of, FaceHandle(face))) : -1;
    };
    std::vector<int> faces(mesh_.n_faces());
    std::iota(faces.begin(), faces.end(), 0);
    const auto less = [&](int a, int b) { return patch(a) < patch(b); };
    if (!std::is_sorted(faces.begin(), faces.end(), less)) {
      std::stable_sort(faces.begin(), faces.end(), less);
    }
    indices_.reserve(3 * faces.size());
    for (const int face : faces) {
      if (primitives_.empty() || primitives_.back().patch != patch(face)) {
        primitives_.push_back({patch(face), indices_.size() / 3, 0});
      }
      add(FaceHandle(face));
      primitives_.back().end = indices_.size() / 3;
    }
  }

  void add(FaceHandle fh) {
    vertices_.clear();
    numbers_.clear();
    for_each_corner(mesh_, fh, [&](HalfedgeHandle heh) {
      vertices_.push_back(mesh_.to_vertex_handle(heh).idx());
      numbers_.push_back(number_of_[index(heh)]);
    });
    if (vertices_.size() == 3) {
      indices_.insert(indices_.end(), numbers_.begin(), numbers_.end());
      return;
    }
    triangles_.clear();
    split_face(mesh_, vertices_, triangles_);
    for (const auto& triangle : triangles_) {
      for (const int vertex : triangle) {
        const auto place = std::find(vertices_.begin(), vertices_.end(), vertex);
        indices_.push_back(numbers_[static_cast<std::size_t>(place - vertices_.begin())]);
      }
    }
  }

  const PolyMesh& mesh_;
  bool is_texture_ = false;  ///< the (u,v) are texture coordinates
  bool has_uv_ = false;
  std::vector<Float3> positions_;
  std::vector<Attributes> attributes_;
  std::vector<std::uint32_t> number_of_;  ///< of the vertex in the file, by halfedge
  std::vector<std::uint32_t> indices_;
  std::vector<Primitive> primitives_;
  std::vector<int> vertices_;  ///< of the face that is being added
  std::vector<std::uint32_t> numbers_;
  std::vector<std::array<int, 3>> triangles_;
};

/// A colour that differs from those of the numbers before: hues go round by the golden ratio.
Json colour(std::size_t number) {
  constexpr double kGoldenRatio = 0.6180339887498949;
  constexpr double kSaturation = 0.5, kValue = 0.8;
  const double hue = 6 * std::fmod(kGoldenRatio * static_cast<double>(number), 1.0);
  Json rgba = Json::array();
  for (const double turn : {5.0, 3.0, 1.0}) {
    const double k = std::fmod(turn + hue, 6.0);
    rgba.push_back(kValue * (1 - kSaturation * std::clamp(std::min(k, 4 - k), 0.0, 1.0)));
  }
  rgba.push_back(1.0);
  return rgba;
}

/// The text that tells what the numbers are.
class Description {
 public:
  Description(const GlbMesh& mesh, const MeshNames& names, const std::string& name)
      : mesh_(mesh), names_(names) {
    json_["asset"] = {{"version", "2.0"}, {"generator", "surfmesh"}};
    json_["scene"] = 0;
    json_["scenes"] = {{{"nodes", {0}}}};
    // A quarter turn about x.
    const double half = std::sqrt(0.5);
    json_["nodes"] = {{{"name", name}, {"mesh", 0}, {"rotation", {-half, 0.0, 0.0, half}}}};
    json_["meshes"] = {{{"name", name}, {"primitives", Json::array()}}};
    add_arrays();
    add_primitives();
    json_["buffers"] = {{{"byteLength", bytes_}}};
  }

  std::string text() const { return json_.dump(-1, ' ', false, Json::error_handler_t::replace); }
  std::size_t bytes() const { return bytes_; }

 private:
  /// A part of the binary chunk, of `count` entries.
  void add_view(std::size_t count, std::size_t bytes_each, int target) {
    json_["bufferViews"].push_back({{"buffer", 0},
                                    {"byteOffset", bytes_},
                                    {"byteLength", count * bytes_each},
                                    {"target", target}});
    bytes_ += count * bytes_each;
  }

  void add_accessor(std::size_t view, const char* type, std::size_t count) {
    json_["accessors"].push_back(
        {{"bufferView", view}, {"componentType", kFloat}, {"count", count}, {"type", type}});
  }

  void add_arrays() {
    const std::size_t count = mesh_.positions().size();
    add_view(count, sizeof(Float3), kArrayBuffer);
    add_accessor(0, "VEC3", count);
    add_bounds(json_["accessors"].back());
    add_view(count, sizeof(Float3), kArrayBuffer);
    add_accessor(1, "VEC3", count);
    attributes_ = {{"POSITION", 0}, {"NORMAL", 1}};
    if (mesh_.has_uv()) {
      add_view(count, sizeof(Float2), kArrayBuffer);
      add_accessor(2, "VEC2", count);
      attributes_["TEXCOORD_0"] = 2;
    }
    add_view(mesh_.indices().size(), sizeof(std::uint32_t), kIndexBuffer);
  }

  void add_bounds(Json& accessor) const {
    Float3 least = mesh_.positions().empty() ? Float3{} : mesh_.positions().front();
    Float3 greatest = least;
    for (const Float3& position : mesh_.positions()) {
      for (std::size_t k = 0; k < position.size(); ++k) {
        least[k] = std::min(least[k], position[k]);
        greatest[k] = std::max(greatest[k], position[k]);
      }
    }
    accessor["min"] = least;
    accessor["max"] = greatest;
  }

  void add_primitives() {
    if (!mesh_.primitives().empty()) {
      check_number(mesh_.primitives().back().patch, "a face is of patch", ".glb");
    }
    groups_ = groups_by_patch(names_, patch_count());
    const std::size_t view = mesh_.has_uv() ? 3 : 2;
    Json& primitives = json_["meshes"][0]["primitives"];
    for (const Primitive& primitive : mesh_.primitives()) {
      primitives.push_back({{"attributes", attributes_},
                            {"indices", json_["accessors"].size()},
                            {"material", primitives.size()}});
      json_["accessors"].push_back({{"bufferView", view},
                                    {"byteOffset", 3 * sizeof(std::uint32_t) * primitive.first},
                                    {"componentType", kUnsigned},
                                    {"count", 3 * (primitive.end - primitive.first)},
                                    {"type", "SCALAR"}});
      json_["materials"].push_back(material(primitive.patch));
    }
  }

  std::size_t patch_count() const {
    return mesh_.primitives().empty()
               ? 0
               : static_cast<std::size_t>(mesh_.primitives().back().patch + 1);
  }

  Json material(int patch) const {
    const auto p = static_cast<std::size_t>(patch);
    std::string name = patch < 0 ? "no patch" : fmt::format("patch{}", patch);
    std::size_t number = patch < 0 ? 0 : p;
    Json extras = Json::object();
    if (patch >= 0) {
      if (p < names_.patches.size() && !names_.patches[p].empty()) name = names_.patches[p];
      extras = {{"patch", patch}, {"groups", Json::array()}};
      for (const int g : groups_[p]) {
        extras["groups"].push_back(names_.groups[static_cast<std::size_t>(g)].name);
      }
      if (!groups_[p].empty()) number = static_cast<std::size_t>(groups_[p].front());
    }
    return {
        {"name", name},
        {"pbrMetallicRoughness",
         {{"baseColorFactor", colour(number)}, {"metallicFactor", 0.0}, {"roughnessFactor", 0.7}}},
        {"doubleSided", true},
        {"extras", extras}};
  }

  const GlbMesh& mesh_;
  const MeshNames& names_;
  Json json_;
  Json attributes_;
  std::vector<std::vector<int>> groups_;
  std::size_t bytes_ = 0;
};

/// Chunks have a whole number of words.
std::size_t padding(std::size_t bytes) { return (4 - bytes % 4) % 4; }

void write_numbers(const GlbMesh& mesh, FileWriter& writer) {
  for (const Float3& position : mesh.positions()) {
    for (const float x : position) writer.bytes(x);
  }
  for (const Attributes& attributes : mesh.attributes()) {
    for (const float x : attributes.normal) writer.bytes(x);
  }
  if (mesh.has_uv()) {
    for (const Attributes& attributes : mesh.attributes()) {
      for (const float x : attributes.uv) writer.bytes(x);
    }
  }
  for (const std::uint32_t number : mesh.indices()) writer.bytes(number);
}

void write_glb(const PolyMesh& mesh, const MeshNames& names, const OutputOptions& options,
               OutputFile& file) {
  check_single_precision(mesh, ".glb");
  const GlbMesh glb(mesh, options);
  const Description description(glb, names, file.path().stem().string());
  const std::string json = description.text();
  const std::size_t json_size = json.size() + padding(json.size());
  constexpr std::size_t kHeads = 12 + 2 * 8;
  const std::size_t size = kHeads + json_size + description.bytes();
  if (size > std::numeric_limits<std::uint32_t>::max()) {
    throw Error(ErrorCode::InvalidInput, ".glb files have up to 4 GB, and this mesh needs more");
  }
  FileWriter writer(file);
  for (const std::uint32_t word : {kMagic, 2U, static_cast<std::uint32_t>(size),
                                   static_cast<std::uint32_t>(json_size), kJson}) {
    writer.bytes(word);
  }
  writer.text(json);
  writer.text(std::string(padding(json.size()), ' '));
  // The numbers are whole words already.
  writer.bytes(static_cast<std::uint32_t>(description.bytes()));
  writer.bytes(kBinary);
  write_numbers(glb, writer);
  writer.flush();
}

std::vector<std::string> lost_in_glb(const PolyMesh& mesh, const MeshNames&,
                                     const OutputOptions& options) {
  std::vector<std::string> lost;
  add_lost_digits(mesh, lost);
  add_split_faces(mesh, 3, lost);
  const bool has_texture = options.texture && find(mesh, keys::corner_texture).is_valid();
  const KeptProperties kept{
      .normals = true, .uv = options.uv && !has_texture, .texture = has_texture};
  for (std::string& entry : lost_properties(mesh, kept)) {
    lost.push_back(std::move(entry));
  }
  return lost;
}

}  // namespace

MeshFormat glb_format() {
  return {.ending = ".glb",
          .write = write_glb,
          .is_single_precision = true,
          .has_corner_values = true,
          .what_is_lost = lost_in_glb};
}

}  // namespace surfmesh
