// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/read_cad.hh"

#include <fmt/format.h>
#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>
#include <Standard_Version.hxx>

#include <exception>
#include <mutex>
#include <new>
#include <utility>

#include "surfmesh/core/at_location.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh_cad/build_model.hh"
#include "surfmesh_cad/heal_shape.hh"
#include "surfmesh_cad/quiet_messages.hh"
#include "surfmesh_cad/read_shape.hh"

namespace surfmesh {
namespace {

constexpr const char* kOutOfMemory = "memory runs out";

/// The model of a shape. Where faces cannot be used, the shape is mended, and the better of both is
/// taken.
BuiltModel best_model(CadShape& cad) {
  BuiltModel built = build_model(cad);
  if (built.left_out.empty()) return built;
  CadShape mended = cad;
  if (!mend_faces(mended)) {
    cad.notices = std::move(mended.notices);
    return built;
  }
  BuiltModel again = build_model(mended);
  if (again.left_out.size() >= built.left_out.size()) return built;
  cad = std::move(mended);
  return again;
}

Model model_of(CadShape cad, const CadOptions& options) {
  drop_damaged_faces(cad);
  if (cad.shape.IsNull() || count_of(cad.shape, TopAbs_FACE) == 0) {
    throw Error(ErrorCode::InvalidInput, "it has no faces that can be used");
  }
  sew_faces(cad, options);
  merge_small_edges(cad);
  divide_at_corners(cad);
  BuiltModel built = best_model(cad);
  if (built.model.patches.empty()) {
    throw Error(ErrorCode::Geometry,
                built.left_out.empty() ? "no face is left of it" : built.left_out.front().text);
  }
  Notices notices = std::move(cad.notices);
  append(std::move(built.model.notices), notices);
  append(std::move(built.left_out), notices);
  built.model.notices = std::move(notices);
  return std::move(built.model);
}

/// Everything that OpenCASCADE throws becomes an Error.
Model read_model(const std::filesystem::path& path, const CadOptions& options) {
  try {
    return model_of(read_shape(path), options);
  } catch (const Error&) {
    throw;
  } catch (const Standard_OutOfMemory&) {
    throw Error(ErrorCode::Limit, kOutOfMemory);
  } catch (const Standard_Failure& failure) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("OpenCASCADE fails: {} {}", failure.DynamicType()->Name(),
                            failure.GetMessageString()));
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::Limit, kOutOfMemory);
  } catch (const std::exception& error) {
    throw Error(ErrorCode::InvalidInput, fmt::format("OpenCASCADE fails: {}", error.what()));
  }
}

}  // namespace

Model read_cad(const std::filesystem::path& path, const CadOptions& options) {
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  const QuietMessages quiet;
  Model model = at_location(path.string(), [&] { return read_model(path, options); });
  for (Notice& notice : model.notices) locate(path.string(), notice);
  return model;
}

std::string cad_version() { return OCC_VERSION_COMPLETE; }

}  // namespace surfmesh
