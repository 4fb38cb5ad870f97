// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/read_shape.hh"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <Interface_Static.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <STEPControl_Reader.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <XSControl_WorkSession.hxx>
#include <fstream>
#include <string>

#include "surfmesh/core/error.hh"
#include "surfmesh_cad/cad_file.hh"
#include "surfmesh_cad/failed_entities.hh"
#include "surfmesh_cad/part_names.hh"
#include "surfmesh_cad/quiet_messages.hh"

namespace surfmesh {
namespace {

/// Sets an option of OpenCASCADE's readers, which is a variable of the whole program, for as long
/// as it exists.
class ReaderOption {
 public:
  ReaderOption(const char* name, int value) : name_(name), before_(Interface_Static::IVal(name)) {
    Interface_Static::SetIVal(name, value);
  }
  ~ReaderOption() { Interface_Static::SetIVal(name_, before_); }
  ReaderOption(const ReaderOption&) = delete;
  ReaderOption& operator=(const ReaderOption&) = delete;

 private:
  const char* name_;
  int before_;
};

[[noreturn]] void fail_status(IFSelect_ReturnStatus status) {
  if (status == IFSelect_RetVoid) throw Error(ErrorCode::InvalidInput, "there is nothing in it");
  throw Error(ErrorCode::InvalidInput, "OpenCASCADE cannot read it: it is damaged");
}

template <class Reader>
void read_entities(Reader& reader, const std::filesystem::path& path) {
  const IFSelect_ReturnStatus status = reader.ReadFile(path.c_str());
  if (status != IFSelect_RetDone) fail_status(status);
}

/// Make shapes of the entities that were read, and take names and colours along.
template <class Reader>
CadShape read_document(Reader& reader, XSControl_Reader& entities) {
  Handle(TDocStd_Document) document = new TDocStd_Document("XmlXCAF");
  if (!reader.Transfer(document)) {
    throw Error(ErrorCode::InvalidInput, "it has no shapes that OpenCASCADE can make");
  }
  CadShape cad = named_shape(document);
  append(failed_entities(*entities.WS()), cad.notices);
  return cad;
}

CadShape read_step(const std::filesystem::path& path) {
  STEPCAFControl_Reader reader;
  reader.SetNameMode(true);
  reader.SetColorMode(true);
  reader.SetLayerMode(false);
  reader.SetPropsMode(false);
  reader.SetGDTMode(false);
  reader.SetMatMode(false);
  read_entities(reader, path);
  if (!check_entities(*reader.ChangeReader().WS())) reader.SetColorMode(false);
  const ReaderOption with_names("read.stepcaf.subshapes.name", 1);
  return read_document(reader, reader.ChangeReader());
}

CadShape read_iges(const std::filesystem::path& path) {
  IGESCAFControl_Reader reader;
  reader.SetNameMode(true);
  reader.SetColorMode(true);
  reader.SetLayerMode(false);
  read_entities(reader, path);
  return read_document(reader, reader);
}

CadShape read_brep(const std::filesystem::path& path) {
  CadShape cad;
  std::ifstream file(path, std::ios::binary);
  BRepTools::Read(cad.shape, file, BRep_Builder());
  if (cad.shape.IsNull()) throw Error(ErrorCode::InvalidInput, "OpenCASCADE cannot read it");
  return cad;
}

}  // namespace

CadShape read_shape(const std::filesystem::path& path) {
  const QuietOutput quiet;
  switch (check_cad_file(path)) {
    case CadFormat::Step:
      return read_step(path);
    case CadFormat::Iges:
      return read_iges(path);
    default:
      return read_brep(path);
  }
}

}  // namespace surfmesh
