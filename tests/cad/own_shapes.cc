// SPDX-License-Identifier: BSD-3-Clause
#include "cad/own_shapes.hh"

#include <BRepBndLib.hxx>
#include <BRepGProp.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <ostream>
#include <stdexcept>

#include "cad/shape_parts.hh"
#include "surfmesh_cad/cad_shape.hh"
#include "surfmesh_cad/quiet_messages.hh"

namespace surfmesh::testing {
namespace {

void write_step(const TopoDS_Shape& shape, const std::filesystem::path& path,
                const std::string& unit) {
  STEPControl_Controller::Init();
  Interface_Static::SetCVal("write.step.unit", unit.c_str());
  STEPControl_Writer writer;
  writer.Transfer(shape, STEPControl_AsIs);
  writer.Write(path.c_str());
  Interface_Static::SetCVal("write.step.unit", "MM");
}

/// As programs of old do: faces that nothing joins.
void write_iges(const TopoDS_Shape& shape, const std::filesystem::path& path) {
  IGESControl_Controller::Init();
  constexpr int kFaces = 0;
  IGESControl_Writer writer("MM", kFaces);
  writer.AddShape(shape);
  writer.ComputeModel();
  writer.Write(path.c_str());
}

void set_name(const TDF_Label& label, const char* name) { TDataStd_Name::Set(label, name); }

}  // namespace

void PrintTo(const OwnShape& shape, std::ostream* out) { *out << shape.name; }

const std::vector<OwnShape>& own_shapes() {
  static const std::vector<OwnShape> shapes = [] {
    std::vector<OwnShape> all;
    add_simple_shapes(all);
    add_swept_shapes(all);
    add_cut_shapes(all);
    add_spline_shapes(all);
    add_odd_shapes(all);
    return all;
  }();
  return shapes;
}

const OwnShape& own_shape(const std::string& name) {
  for (const OwnShape& shape : own_shapes()) {
    if (shape.name == name) return shape;
  }
  throw std::invalid_argument("there is no shape " + name);
}

std::filesystem::path write_shape(const OwnShape& shape, const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / (shape.name + shape.ending);
  write_cad(shape.make(), path, shape.unit);
  return path;
}

void write_cad(const TopoDS_Shape& shape, const std::filesystem::path& path,
               const std::string& unit) {
  const QuietMessages quiet;
  if (path.extension() == ".brep") {
    BRepTools::Write(shape, path.c_str());
  } else if (path.extension() == ".iges" || path.extension() == ".igs") {
    write_iges(shape, path);
  } else {
    write_step(shape, path, unit);
  }
}

void write_assembly(const std::filesystem::path& path) {
  const QuietMessages quiet;
  Handle(TDocStd_Document) document = new TDocStd_Document("XmlXCAF");
  const auto shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  const auto colours = XCAFDoc_DocumentTool::ColorTool(document->Main());
  const TopoDS_Shape plate_shape = box(10, 10, 1);
  const TDF_Label plate = shapes->AddShape(plate_shape, false);
  set_name(plate, "plate");
  colours->SetColor(plate, Quantity_Color(0, 0, 1, Quantity_TOC_sRGB), XCAFDoc_ColorSurf);
  const TDF_Label top = shapes->AddSubShape(plate, face_towards(plate_shape, {0, 0, 1}));
  set_name(top, "top");
  colours->SetColor(top, Quantity_Color(0, 1, 0, Quantity_TOC_sRGB), XCAFDoc_ColorSurf);
  const TDF_Label bolt = shapes->AddShape(cylinder(1, 3), false);
  set_name(bolt, "bolt");
  colours->SetColor(bolt, Quantity_Color(1, 0, 0, Quantity_TOC_sRGB), XCAFDoc_ColorSurf);
  const TDF_Label assembly = shapes->NewShape();
  set_name(assembly, "machine");
  shapes->AddComponent(assembly, plate, TopLoc_Location());
  shapes->AddComponent(assembly, bolt, translation(3, 5, 1));
  shapes->AddComponent(assembly, bolt, translation(7, 5, 1));
  shapes->UpdateAssemblies();
  STEPCAFControl_Writer writer;
  Interface_Static::SetIVal("write.stepcaf.subshapes.name", 1);
  writer.SetNameMode(true);
  writer.SetColorMode(true);
  writer.Transfer(document, STEPControl_AsIs);
  writer.Write(path.c_str());
}

void write_brep(const OwnShape& own, const std::filesystem::path& path, int version) {
  constexpr double kCoarse = 0.5;
  const TopoDS_Shape shape = own.make();
  const BRepMesh_IncrementalMesh triangles(shape, kCoarse);
  BRepTools::Write(shape, path.c_str(), true, false, static_cast<TopTools_FormatVersion>(version));
}

void write_wires(const std::filesystem::path& path) { write_cad(circle(2, 0), path); }

void write_empty(const std::filesystem::path& path) { write_cad(together({}), path); }

ShapeFacts facts_of(const OwnShape& own) {
  const TopoDS_Shape shape = own.make();
  ShapeFacts facts;
  constexpr double kPrecision = 1e-6;
  GProp_GProps volume, area;
  BRepGProp::VolumeProperties(shape, volume, kPrecision);
  BRepGProp::SurfaceProperties(shape, area, kPrecision);
  facts.volume = volume.Mass();
  facts.area = area.Mass();
  Bnd_Box box;
  BRepBndLib::AddOptimal(shape, box, false, false);
  double x0, y0, z0, x1, y1, z1;
  box.Get(x0, y0, z0, x1, y1, z1);
  facts.box = {Eigen::Vector3d(x0, y0, z0), Eigen::Vector3d(x1, y1, z1)};
  facts.faces = count_of(shape, TopAbs_FACE);
  return facts;
}

}  // namespace surfmesh::testing
