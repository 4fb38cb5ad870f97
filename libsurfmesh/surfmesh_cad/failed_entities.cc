// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/failed_entities.hh"

#include <fmt/format.h>
#include <Interface_Check.hxx>
#include <Interface_InterfaceModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <Transfer_Binder.hxx>
#include <Transfer_TransientProcess.hxx>

namespace surfmesh {
namespace {

std::string label_of(const Handle(Interface_InterfaceModel) & model,
                     const Handle(Standard_Transient) & entity) {
  const Handle(TCollection_HAsciiString) label = model->StringLabel(entity);
  return fmt::format("{} {}", label.IsNull() ? "?" : label->ToCString(), model->TypeName(entity));
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

}  // namespace surfmesh
