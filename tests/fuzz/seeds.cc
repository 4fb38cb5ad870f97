// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "formats/grid_texts.hh"
#include "formats/named_example.hh"
#include "fuzz/checks.hh"
#include "fuzz/targets.hh"
#include "surfmesh/formats/mesh_format.hh"
#include "surfmesh/formats/write_mesh.hh"

namespace surfmesh::fuzz {
namespace {

const std::filesystem::path kModels = std::filesystem::path(SURFMESH_SOURCE_DIR) / "models";

/// Larger files are slow to change.
constexpr std::size_t kMostBytes = 4000;

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path.string());
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// The choices that a target reads before the file.
std::string choices(std::initializer_list<std::size_t> values) {
  std::string bytes;
  for (const std::size_t value : values) bytes += static_cast<char>(value);
  return bytes;
}

/// The file of a mesh in a format; the mesh is small, with quads or not.
std::string written(std::string_view ending, int quad_every, const OutputOptions& options = {}) {
  const auto path = scratch_folder() / std::string("seed").append(ending);
  write_mesh(named_example(quad_every, 2), path, example_names(), options);
  return text_of(path);
}

std::vector<Seed> cage_seeds() {
  std::vector<Seed> seeds;
  std::size_t number = 0;
  for (const MeshFormat& format : mesh_formats()) {
    if (format.parse_cage == nullptr) continue;
    for (const auto& entry : std::filesystem::directory_iterator(kModels)) {
      if (entry.path().extension() != format.ending || entry.file_size() > kMostBytes) continue;
      seeds.push_back({entry.path().filename(),
                       choices({number, 0, 0, 0, 0, 0, 0, 0}) + text_of(entry.path())});
    }
    for (const int quad_every : {0, 1, 2}) {
      seeds.push_back(
          {std::string("grid").append(std::to_string(quad_every)).append(format.ending),
           choices({number, 0, 0, 2, 0, 0, 0, 0}) + written(format.ending, quad_every)});
    }
    ++number;
  }
  seeds.push_back({"tags.obj", choices({0, 0, 0, 0, 0, 0, 0, 0}) +
                                   "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 1\nv 2 1 1\n"
                                   "f 1 2 3 4\nf 2 5 6 3\nt crease 2/1/0 1 2 2.5\n"
                                   "t corner 1/1/0 0 10\nt hole 1/0/0 1\n"
                                   "t interpolateboundary 1/0/0 1\nt creasemethod 0/0/1 chaikin\n"
                                   "t smoothtriangles 0/0/1 smooth\n"});
  return seeds;
}

std::vector<Seed> model_seeds() {
  std::vector<Seed> seeds;
  for (const auto& entry : std::filesystem::directory_iterator(kModels)) {
    const std::string name = entry.path().filename();
    if (!name.ends_with(".json") || name == "surfmesh.schema.json") continue;
    if (entry.file_size() <= kMostBytes) seeds.push_back({name, text_of(entry.path())});
  }
  return seeds;
}

std::vector<Seed> formula_seeds() {
  constexpr std::array kTexts = {"u+5*v",
                                 "0.05*sin(35*u+3*v)+0*log(u+0.001)",
                                 "(u^2+v^2)*u",
                                 "-2^2^-u",
                                 "sqrt(u)*cbrt(v)-exp(-u)/ln(v)",
                                 "atan2(u,v)+hypot(u,c)*v",
                                 "mod(u,0.3)+step(0.5,v)",
                                 "if(u<v,floor(u),ceil(v))==1",
                                 "min(u,v)*max(u,c)**pi-sign(v)*abs(u)",
                                 "sinh(u)*cosh(v)/tanh(u)+asin(u)*acos(v)*atan(u)",
                                 "(log10(u)+tan(e*v)!=2)>=1",
                                 "u*v\nf0^2+u\nf1*f0-v",
                                 "5*c*(0.2969*u-sign(u)*(0.126*u^2+0.3516*u^4))"};
  std::vector<Seed> seeds;
  for (const char* text : kTexts) {
    seeds.push_back({std::string("formula").append(std::to_string(seeds.size())), text});
  }
  return seeds;
}

std::string replaced(std::string text, std::string_view old, std::string_view with) {
  const std::size_t at = text.find(old);
  if (at == std::string::npos) throw std::runtime_error("a seed is not as it was");
  return text.replace(at, old.size(), with);
}

/// Sizes at all vertices, instead of at some.
std::string with_all_sizes(const char* msh) {
  return replaced(msh, "3\n10 0.5\n20 0.25\n50 1e-3\n",
                  "8\n10 0.5\n20 0.25\n30 0.1\n40 0.2\n50 1e-3\n60 0.3\n70 0.4\n80 0.6\n");
}

std::vector<Seed> table_seeds() {
  return {
      {"sizes.csv", choices({0, 0}) + text_of(kModels / "sizes.csv")},
      {"directed.csv",
       choices({0, 0}) + "# sizes\nu,v,ls,lt,angle\n0,0,0.1,0.2,30\n1,1,0.3,0.1,-45\n"},
      {"metric.csv", choices({0, 0}) + "u,v,m11,m12,m22\n0,0.5,100,10,50\n1,0.5,20,0,20\n"},
      {"text22.msh", choices({1, 0}) + with_all_sizes(kMsh22)},
      {"text41.msh", choices({1, 255}) + with_all_sizes(kMsh41)},
      {"text.vtu", choices({2, 0}) + replaced(kVtu, "NaN", "0.125")},
      {"metric.vtu", choices({2, 0}) + written(".vtu", 0)},
      {"text.mesh", choices({3, 0}) + kMedit},
      {"text.sol", choices({4, 0}) + kSol},
      {"space.sol", choices({4, 0}) + "MeshVersionFormatted 2\nDimension 3\nSolAtVertices\n5\n1 1\n"
                                      "0.1\n0.2\n0.3\n0.4\n0.5\nEnd\n"}};
}

std::vector<Seed> result_seeds() {
  std::vector<Seed> seeds;
  std::size_t number = 0;
  const auto add = [&](std::string name, const std::string& text) {
    // Read in one format, written in another one.
    seeds.push_back({std::move(name), choices({number, seeds.size()}) + text});
  };
  for (const MeshFormat& format : mesh_formats()) {
    if (format.parse == nullptr) continue;
    for (const int quad_every : {0, 1, 2}) {
      add(std::string("grid").append(std::to_string(quad_every)).append(format.ending),
          written(format.ending, quad_every, {.normals = false, .uv = true}));
    }
    if (format.ending == ".msh") {
      add("text41.msh", written(".msh", 2, {.msh = MshVersion::Text41}));
      add("text22.msh", written(".msh", 2, {.msh = MshVersion::Text22}));
      add("binary22.msh", written(".msh", 2, {.msh = MshVersion::Binary22}));
      add("views22.msh", kMsh22);
      add("views41.msh", kMsh41);
    }
    if (format.ending == ".vtu") add("text.vtu", kVtu);
    if (format.ending == ".mesh") add("text.mesh", kMedit);
    if (format.ending == ".ply") {
      add("mixed.ply",
          "ply\nformat ascii 1.0\ncomment a\nelement vertex 4\nproperty float x\nproperty double "
          "y\n"
          "property uchar z\nproperty list uchar int a\nelement face 2\n"
          "property list uchar uint vertex_index\nproperty int patch\nend_header\n"
          "0 0 0 0\n1 0 0 1 7\n1 1 0 0\n0 1 0 0\n3 0 1 2 0\n3 0 2 3 1\n");
    }
    if (format.ending == ".stl") {
      add("text.stl",
          "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
          "endloop\nendfacet\nendsolid a\n");
    }
    ++number;
  }
  return seeds;
}

/// Models by chance, the same ones each time.
std::vector<Seed> pipeline_seeds() {
  constexpr int kCount = 52;
  std::vector<Seed> seeds;
  std::mt19937 random(14);
  for (int i = 0; i < kCount; ++i) {
    // The third byte is the kind of the model; each comes as often.
    std::string bytes = choices({random() % 256, random() % 256, static_cast<std::size_t>(i)});
    for (std::size_t k = 0; k < 120; ++k) bytes += static_cast<char>(random());
    seeds.push_back({std::string("model").append(std::to_string(i)), bytes});
  }
  seeds.push_back({"sheet", "\1"});
  return seeds;
}

}  // namespace

std::vector<Seed> seeds_of(std::string_view target) {
  if (target == "cage") return cage_seeds();
  if (target == "model") return model_seeds();
  if (target == "formula") return formula_seeds();
  if (target == "table") return table_seeds();
  if (target == "result") return result_seeds();
  if (target == "pipeline") return pipeline_seeds();
#ifdef SURFMESH_HAS_CAD
  if (target == "cad") return cad_seeds();
#endif
  throw std::runtime_error("there is no target " + std::string(target));
}

std::vector<Seed> seed_files() {
  std::vector<Seed> seeds;
  for (const char* name :
       {"cube.obj", "torus.obj", "vault.obj", "knob.obj", "icosahedron.off", "sizes.csv"}) {
    seeds.push_back({name, text_of(kModels / name)});
  }
  seeds.push_back({"front.vtu", kVtu});
  return seeds;
}

std::vector<Target> targets() {
  return {{"cage", try_cage},        {"model", try_model},   {"formula", try_formula},
          {"table", try_table},      {"result", try_result},
#ifdef SURFMESH_HAS_CAD
          {"cad", try_cad},
#endif
          {"pipeline", try_pipeline}};
}

}  // namespace surfmesh::fuzz
