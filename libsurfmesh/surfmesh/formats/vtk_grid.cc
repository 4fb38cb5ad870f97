// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/vtk_grid.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include "surfmesh/core/parallel.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/shared_vertices.hh"
#include "surfmesh/formats/mesh_format.hh"
#include "surfmesh/formats/obj_labels.hh"
#include "surfmesh/io/clean_text.hh"
#include "surfmesh/io/file_writer.hh"
#include "surfmesh/quality/mesh_field.hh"

namespace surfmesh {
namespace {

/// Values of vertices without those of copies.
template <class Value>
std::vector<Value> without_copies(const PolyMesh& mesh, std::vector<Value> values) {
  const SharedVertices vertices(mesh);
  if (vertices.count() == mesh.n_vertices()) return values;
  std::vector<Value> kept;
  kept.reserve(vertices.count());
  for (const VertexHandle vh : mesh.vertices()) {
    if (vertices.is_first(vh)) kept.push_back(values[index(vh)]);
  }
  return kept;
}

std::vector<int> whole_numbers(const std::vector<double>& values) {
  std::vector<int> result(values.size());
  share_ranges(values.size(), [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
      result[i] = std::isnan(values[i]) ? -1 : static_cast<int>(values[i]);
    }
  });
  return result;
}

void add_fields(const PolyMesh& mesh, const MeshNames& names, VtkGrid& grid) {
  for (const FieldDescription& field : mesh_fields()) {
    if (!has_field(mesh, names, field.field)) continue;
    std::vector<double> values = measure_field(mesh, names, field.field);
    const bool is_of_vertices = field.of == FieldOf::Vertices;
    if (is_of_vertices) values = without_copies(mesh, std::move(values));
    VtkValues made{std::string(field.name), 1, {}};
    if (field.is_category || is_of_vertices) {
      made.values = whole_numbers(values);
    } else {
      made.values = std::move(values);
    }
    (is_of_vertices ? grid.at_points : grid.at_cells).push_back(std::move(made));
  }
}

/// u and v of points and of cells.
struct Parameters {
  std::vector<double> u;
  std::vector<double> v;
};

/// The means of the corners of each cell.
Parameters mean_parameters(const MeshArrays& arrays) {
  Parameters result;
  const FaceList& faces = arrays.faces;
  result.u.resize(faces.size());
  result.v.resize(faces.size());
  share_ranges(faces.size(), [&](std::size_t first, std::size_t end) {
    for (std::size_t f = first; f < end; ++f) {
      Uv sum{0, 0};
      for (std::size_t c = faces.first_corner(f); c < faces.first_corner(f + 1); ++c) {
        sum = sum + arrays.uvs[c];
      }
      const Uv mean = 1 / static_cast<double>(faces[f].size()) * sum;
      result.u[f] = mean.u;
      result.v[f] = mean.v;
    }
  });
  return result;
}

/// Those of each point where all its corners agree, else NaN.
Parameters common_parameters(const MeshArrays& arrays) {
  std::vector<Uv> uvs(arrays.points.size());
  std::vector<char> is_seen(arrays.points.size(), 0);
  for (std::size_t c = 0; c < arrays.uvs.size(); ++c) {
    const auto v = static_cast<std::size_t>(arrays.faces.vertex(c));
    if (is_seen[v] == 0) {
      is_seen[v] = 1;
      uvs[v] = arrays.uvs[c];
    } else if (!(uvs[v] == arrays.uvs[c])) {
      uvs[v] = {};
    }
  }
  Parameters result;
  result.u.reserve(uvs.size());
  result.v.reserve(uvs.size());
  for (const Uv uv : uvs) {
    result.u.push_back(uv.u);
    result.v.push_back(uv.v);
  }
  return result;
}

void add(Parameters parameters, std::vector<VtkValues>& values) {
  values.push_back({"u", 1, std::move(parameters.u)});
  values.push_back({"v", 1, std::move(parameters.v)});
}

/// The least contour through each point.
std::vector<int> contours_of_points(const MeshArrays& arrays) {
  std::vector<int> contour_of(arrays.points.size(), -1);
  const auto lower = [&](int vertex, int contour) {
    int& least = contour_of[static_cast<std::size_t>(vertex)];
    if (least < 0 || contour < least) least = contour;
  };
  for (std::size_t f = 0; f < arrays.faces.size(); ++f) {
    const std::size_t first = arrays.faces.first_corner(f), count = arrays.faces[f].size();
    for (std::size_t i = 0; i < count; ++i) {
      const int contour = arrays.contours[first + i];
      if (contour < 0) continue;
      lower(arrays.faces.vertex(first + i), contour);
      lower(arrays.faces.vertex(first + (i + 1) % count), contour);
    }
  }
  return contour_of;
}

/// What is of each name: patches or contours that have it, or patches of groups.
using IndicesOf = std::map<std::string, std::vector<int>>;

IndicesOf indices_of(const std::vector<std::string>& names) {
  IndicesOf indices;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!names[i].empty()) indices[names[i]].push_back(static_cast<int>(i));
  }
  return indices;
}

IndicesOf indices_of(const std::vector<Group>& groups) {
  IndicesOf indices;
  for (const Group& group : groups) {
    if (group.patches.empty()) continue;
    std::vector<int>& patches = indices[group.name];
    patches.insert(patches.end(), group.patches.begin(), group.patches.end());
    std::sort(patches.begin(), patches.end());
  }
  return indices;
}

/// Names that differ as names that XML can hold, too: those that it can hold stay.
std::map<std::string, std::string> clean_words(const IndicesOf& indices) {
  std::map<std::string, std::string> words;
  DifferentNames different;
  for (const bool is_clean : {true, false}) {
    for (const auto& [name, ignored] : indices) {
      std::string word = clean_text(name);
      if ((word == name) == is_clean) words[name] = different.add(word);
    }
  }
  return words;
}

void add_indices(std::string_view kind, IndicesOf indices, std::vector<VtkValues>& whole) {
  const auto words = clean_words(indices);
  for (auto& [name, of_name] : indices) {
    whole.push_back({fmt::format("{}:{}", kind, words.at(name)), 1, std::move(of_name)});
  }
}

}  // namespace

std::vector<VtkValues> vtk_names(const MeshNames& names) {
  std::vector<VtkValues> whole;
  add_indices("patch", indices_of(names.patches), whole);
  add_indices("group", indices_of(names.groups), whole);
  add_indices("contour", indices_of(names.contours), whole);
  return whole;
}

std::vector<ChangedName> changed_in_vtk(const PolyMesh&, const MeshNames& names) {
  std::vector<ChangedName> changed;
  for (const IndicesOf& indices :
       {indices_of(names.patches), indices_of(names.groups), indices_of(names.contours)}) {
    for (const auto& [name, word] : clean_words(indices)) {
      if (name != word) changed.push_back({name, word});
    }
  }
  return changed;
}

VtkGrid vtk_grid(const PolyMesh& mesh, const MeshNames& names) {
  const bool has_corners =
      find(mesh, keys::corner_uv).is_valid() || find(mesh, keys::edge_contour).is_valid();
  MeshArrays arrays =
      mesh_arrays(mesh, {}, has_corners ? ArrayParts::FacesAndCorners : ArrayParts::Faces);
  VtkGrid grid;
  add_fields(mesh, names, grid);
  if (!arrays.uvs.empty()) {
    add(common_parameters(arrays), grid.at_points);
    add(mean_parameters(arrays), grid.at_cells);
  }
  if (!arrays.contours.empty()) {
    grid.at_points.push_back({"contour", 1, contours_of_points(arrays)});
  }
  grid.whole = vtk_names(names);
  grid.points = std::move(arrays.points);
  grid.cells = std::move(arrays.faces);
  return grid;
}

std::vector<std::string> lost_in_grid(const PolyMesh& mesh) {
  std::vector<std::string> lost;
  for (std::string& entry : lost_properties(mesh, {.uv = true, .contours = true, .sag = true})) {
    lost.push_back(std::move(entry));
  }
  if (find(mesh, keys::corner_uv).is_valid()) {
    lost.push_back("the parameters (u,v) of corners where those at a vertex differ");
  }
  if (find(mesh, keys::edge_contour).is_valid()) {
    lost.push_back("the contours of the edges, but for those of their ends");
  }
  return lost;
}

void check_points(const VtkGrid& grid) {
  for (std::size_t i = 0; i < grid.points.size(); ++i) {
    check_finite(to_openmesh(grid.points[i]), VertexHandle(static_cast<int>(i)));
  }
}

}  // namespace surfmesh
