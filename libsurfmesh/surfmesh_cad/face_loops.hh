// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <memory>
#include <optional>
#include <vector>

#include "surfmesh/core/notice.hh"
#include "surfmesh/geometry/domain.hh"
#include "surfmesh_cad/parameter_curve.hh"

namespace surfmesh {

/// An edge as a loop of a face passes it.
struct FaceEdge {
  TopoDS_Edge edge;        ///< null for a side without an edge: a pole that the file leaves out
  TopoDS_Vertex vertex;    ///< where a side without an edge lies
  ParameterCurve curve;    ///< along the edge, whichever way the loop runs
  bool is_forward = true;  ///< whether the loop runs along the edge
};

using FaceLoop = std::vector<FaceEdge>;

/// The boundary of a face in the parameters of its surface.
struct FaceBoundary {
  std::vector<FaceLoop> loops;  ///< the outer one first; the face is on the left of each
  Domain domain;                ///< around the loops
  int dropped_edges = 0;        ///< edges inside the face that bound nothing
};

/// The loops of a face, as they are if the face is taken forward.
///
/// The curves of a loop are shifted by whole periods until each goes on where the one before ends,
/// and holes by whole periods into the outer loop. Ends that meet get the same parameters: their
/// mean. In files they differ by up to 1e-3 of the face.
///
/// Throws   Geometry if there are none, or one does not close
FaceBoundary face_boundary(const TopoDS_Face& face);

}  // namespace surfmesh
