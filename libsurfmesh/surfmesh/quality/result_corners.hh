// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/properties.hh"

namespace surfmesh::detail {

/// The corner properties of a result mesh.
struct ResultCorners {
  /// Throws   MissingProperty
  explicit ResultCorners(const PolyMesh& result)
      : mesh(result),
        uv_handle(require(result, keys::corner_uv)),
        metric_handle(require(result, keys::corner_metric)) {}

  Uv uv(HalfedgeHandle heh) const { return mesh.property(uv_handle, heh); }
  const Metric& metric(HalfedgeHandle heh) const { return mesh.property(metric_handle, heh); }

  const PolyMesh& mesh;
  decltype(keys::corner_uv)::Handle uv_handle;
  decltype(keys::corner_metric)::Handle metric_handle;
};

}  // namespace surfmesh::detail
