// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/failed_entities.hh"

#include <fmt/format.h>

#include <string_view>

#include <Interface_Check.hxx>
#include <Interface_CheckIterator.hxx>
#include <Interface_InterfaceModel.hxx>
#include <StepGeom_Curve.hxx>
#include <StepGeom_Pcurve.hxx>
#include <StepRepr_DefinitionalRepresentation.hxx>
#include <TCollection_HAsciiString.hxx>
#include <Transfer_Binder.hxx>
#include <Transfer_TransientProcess.hxx>
#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

std::string label_of(const Handle(Interface_InterfaceModel) & model,
                     const Handle(Standard_Transient) & entity) {
  const Handle(TCollection_HAsciiString) label = model->StringLabel(entity);
  return fmt::format("{} {}", label.IsNull() ? "?" : label->ToCString(), model->TypeName(entity));
}

/// Entities that shapes are made of, by the names of OpenCASCADE's classes for them.
bool is_of_shape(const Handle(Standard_Transient) & entity) {
  const std::string_view type = entity->DynamicType()->Name();
  return type.starts_with("StepGeom_") || type.starts_with("StepShape_") ||
         type.starts_with("StepRepr_") || type.starts_with("StepBasic_");
}

/// Throws   InvalidInput for a curve on a surface without a curve: the reader does not look at it
void check_curve(const Handle(Interface_InterfaceModel) & model,
                 const Handle(Standard_Transient) & entity) {
  const auto on_surface = Handle(StepGeom_Pcurve)::DownCast(entity);
  if (on_surface.IsNull()) return;
  const Handle(StepRepr_DefinitionalRepresentation) curve = on_surface->ReferenceToCurve();
  if (!curve.IsNull() && curve->NbItems() > 0 &&
      !Handle(StepGeom_Curve)::DownCast(curve->ItemsValue(1)).IsNull()) {
    return;
  }
  throw Error(ErrorCode::InvalidInput, fmt::format("{}: it has no curve", label_of(model, entity)));
}

}  // namespace

Notices failed_entities(const XSControl_WorkSession& session) {
  Notices notices;
  if (session.MapReader().IsNull()) return notices;
  const auto& results = *session.MapReader();
  for (Standard_Integer i = 1; i <= results.NbMapped(); ++i) {
    const Handle(Transfer_Binder) binder = results.MapItem(i);
    if (binder.IsNull() || binder->Check()->NbFails() == 0) continue;
    Notice notice = shortfall(NoticeKind::IgnoredInput,
                              fmt::format("it could not be read: {}", binder->Check()->CFail(1)));
    locate(label_of(session.Model(), results.Mapped(i)), notice);
    append({notice}, notices);
  }
  return notices;
}

bool check_entities(XSControl_WorkSession& session) {
  bool is_sound = true;
  Interface_CheckIterator list = session.ModelCheckList();
  for (list.Start(); list.More(); list.Next()) {
    if (list.Value()->NbFails() == 0) continue;
    is_sound = false;
    const Standard_Integer number = list.Number();
    if (number <= 0 || number > session.Model()->NbEntities()) continue;
    const Handle(Standard_Transient) entity = session.Model()->Value(number);
    if (!is_of_shape(entity)) continue;
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{}: {}", label_of(session.Model(), entity), list.Value()->CFail(1)));
  }
  for (Standard_Integer i = 1; i <= session.Model()->NbEntities(); ++i) {
    check_curve(session.Model(), session.Model()->Value(i));
  }
  return is_sound;
}

}  // namespace surfmesh
