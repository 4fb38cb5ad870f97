// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/properties.hh"

namespace surfmesh {

/// A wavy grid of n × n cells, cell (i,j) a quad where i + j is a multiple of `quad_every`, else
/// two triangles. Its coordinates need all digits.
inline PolyMesh wavy_grid(int n, int quad_every) {
  PolyMesh mesh;
  std::vector<VertexHandle> v;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const double x = i / 3.0, y = j / 7.0;
      v.push_back(mesh.add_vertex({x, y, 1e-9 * std::sin(x) * std::exp(y)}));
    }
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const auto at = [&](int a, int b) {
        return v[static_cast<std::size_t>((j + b) * (n + 1) + i + a)];
      };
      if (quad_every > 0 && (i + j) % quad_every == 0) {
        mesh.add_face(std::vector{at(0, 0), at(1, 0), at(1, 1), at(0, 1)});
      } else {
        mesh.add_face(std::vector{at(0, 0), at(1, 0), at(1, 1)});
        mesh.add_face(std::vector{at(0, 0), at(1, 1), at(0, 1)});
      }
    }
  }
  return mesh;
}

/// Attach all properties of a result, with values that need all digits and some that are unset.
inline void attach_result_properties(PolyMesh& mesh) {
  const auto patch = attach(mesh, keys::face_patch, -1);
  const auto contour = attach(mesh, keys::edge_contour, -1);
  const auto uv = attach(mesh, keys::corner_uv);
  const auto metric = attach(mesh, keys::corner_metric);
  for (const FaceHandle fh : mesh.faces()) mesh.property(patch, fh) = 2 - fh.idx() % 3;
  for (const EdgeHandle eh : mesh.edges()) {
    if (mesh.is_boundary(eh))
      mesh.property(contour, eh) = std::numeric_limits<int>::max() - eh.idx();
  }
  for (const HalfedgeHandle heh : mesh.halfedges()) {
    if (mesh.is_boundary(heh)) continue;
    const double x = heh.idx() + 1;
    mesh.property(uv, heh) = {std::sqrt(x), -1 / x};
    mesh.property(metric, heh) = {std::exp(x), std::log(x), 1e300 / x};
  }
}

}  // namespace surfmesh
