// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

/// Only named here: a file cannot include OpenMesh after OpenCASCADE, whose macro Handle gets in
/// the way.
class TopoDS_Shape;

namespace surfmesh::testing {

/// What a mesh of a shape is like: closed; open, as a sheet is; or with edges at which three faces
/// and more meet.
enum class ShapeKind { Solid, Sheet, Glued };

/// A shape made with OpenCASCADE, and the format it is written in.
struct OwnShape {
  std::string name;
  std::string ending;  ///< ".step", ".iges" or ".brep"
  std::function<TopoDS_Shape()> make;
  ShapeKind kind = ShapeKind::Solid;
  std::string unit = "MM";  ///< in which a STEP file has its lengths; they are read in mm
};

void PrintTo(const OwnShape& shape, std::ostream* out);

/// Shapes of all kinds, each a case of its own.
const std::vector<OwnShape>& own_shapes();

/// The shape of a name.
const OwnShape& own_shape(const std::string& name);

/// Make a shape and write it to a folder. Returns its path.
std::filesystem::path write_shape(const OwnShape& shape, const std::filesystem::path& folder);

/// Write a shape; the format is told by the ending, lengths of STEP files are in `unit`.
void write_cad(const TopoDS_Shape& shape, const std::filesystem::path& path,
               const std::string& unit = "MM");

/// An assembly as STEP: two red bolts and a blue plate, whose top is a face called "top" in green.
void write_assembly(const std::filesystem::path& path);

/// Write a shape with its triangles as BREP, in one of the three versions of the format.
void write_brep(const OwnShape& shape, const std::filesystem::path& path, int version);

/// Files without faces: of a wire, and of nothing.
void write_wires(const std::filesystem::path& path);
void write_empty(const std::filesystem::path& path);

/// What OpenCASCADE measures of a shape.
struct ShapeFacts {
  double volume = 0;
  double area = 0;
  Eigen::AlignedBox3d box;
  int faces = 0;
};

ShapeFacts facts_of(const OwnShape& shape);

/// Shapes by how they are made.
void add_simple_shapes(std::vector<OwnShape>& shapes);
void add_swept_shapes(std::vector<OwnShape>& shapes);
void add_cut_shapes(std::vector<OwnShape>& shapes);
void add_spline_shapes(std::vector<OwnShape>& shapes);
void add_odd_shapes(std::vector<OwnShape>& shapes);

}  // namespace surfmesh::testing
