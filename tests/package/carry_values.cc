// SPDX-License-Identifier: BSD-3-Clause
// Mesh the limit surface of an OpenMesh mesh, and give the result what the mesh had: temperatures
// at its vertices, and a coordinate of a texture with seams at its corners.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Utils/PropertyManager.hh>
#include <algorithm>
#include <cstdio>
#include <exception>

#include <surfmesh/surfmesh.hh>

int main() try {
  OpenMesh::TriMesh_ArrayKernelT<> source;  // a tetrahedron
  for (const auto& p : {OpenMesh::Vec3f(-1, -1, 1), {1, -1, -1}, {-1, 1, -1}, {1, 1, 1}}) {
    source.add_vertex(p);
  }
  const auto v = [](int i) { return OpenMesh::VertexHandle(i); };
  for (const auto& f : {OpenMesh::Vec3i(0, 1, 3), {0, 3, 2}, {0, 2, 1}, {1, 2, 3}}) {
    source.add_face(v(f[0]), v(f[1]), v(f[2]));
  }
  OpenMesh::VProp<double> temperature(source, "temperature");
  OpenMesh::HProp<float> texture(source, "texture");  // at the tips of halfedges
  for (const auto vertex : source.vertices()) temperature[vertex] = 20 + 10 * vertex.idx();
  for (const auto corner : source.halfedges()) texture[corner] = source.point(corner.to())[0];

  const auto model = surfmesh::model_from_cage(surfmesh::cage_from_mesh(source));
  surfmesh::PipelineOptions options;
  options.across.is_on = false;  // no triangle lies across an edge of the source: seams stay
  auto result = surfmesh::mesh_model(model, {}, options);
  surfmesh::PropertyCarrier carrier(source, model, result.mesh);
  carrier.vertices<double>("temperature");
  carrier.corners<float>("texture");

  OpenMesh::VProp<double> carried(result.mesh, "temperature");
  double greatest = 0;
  for (const auto vertex : result.mesh.vertices()) greatest = std::max(greatest, carried[vertex]);
  std::printf("%zu triangles, up to %.0f degrees\n", result.report.mesh.triangles, greatest);
} catch (const std::exception& error) {
  return std::fprintf(stderr, "error: %s\n", error.what()), 1;
}
