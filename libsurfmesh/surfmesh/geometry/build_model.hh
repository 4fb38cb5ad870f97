// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "surfmesh/geometry/model.hh"

/// Models built by hand: patches, the contours between them, and loops with holes.
///
/// Patches that are whole rectangles need none of this: model_from_patches finds out what they
/// share. Holes may be added to its models by add_loop, and complete_model called again.
namespace surfmesh {

/// A curve in the parameters of a patch, and the name of the contour that it becomes.
struct NamedCurve {
  std::string name;
  std::shared_ptr<const Curve> curve;
};

/// Add a point where contours end.
/// Returns  its index in Model::vertices
/// Throws   InvalidInput if it is not finite
int add_vertex(Model& model, const Vec3& position);

/// Add a patch that has no loops yet.
/// Returns  its index in Model::patches
/// Throws   InvalidInput for a missing surface, or a name that another patch has
int add_patch(Model& model, std::string name, std::shared_ptr<const Surface> surface);

/// Add a contour that has no uses yet, from one vertex to another, or to the same for a closed one.
/// Returns  its index in Model::contours
/// Throws   InvalidInput for vertices that do not exist
int add_contour(Model& model, std::string name, int start, int end);

/// Tell how a patch sees a contour: as a curve in its parameters, t = 0 at the contour's start.
///
/// `is_forward` tells that the patch lies on the left of the curve. A contour has a use for each
/// patch that it bounds, two for a seam within one patch; their speeds may differ.
/// Returns  what stands for it in a loop
/// Throws   InvalidInput for a contour or patch that does not exist, or a missing curve
LoopEntry add_use(Model& model, int contour, int patch, std::shared_ptr<const Curve> curve,
                  bool is_forward = true);

/// Add a loop of contour uses, end to end with the patch on their left: first the outer loop of a
/// patch, then its holes.
/// Throws   InvalidInput for a patch that does not exist
void add_loop(Model& model, int patch, Loop loop);

/// Add a loop of contours that no other patch has: first the outer loop of a patch, then its holes.
///
/// The curves follow each other end to end, in either direction around the loop; one curve may
/// close by itself. A vertex is made at the start of each. Throws   InvalidInput for a patch that
/// does not exist, no curves, or a missing curve
void add_loop(Model& model, int patch, const std::vector<NamedCurve>& curves);

/// The sides of a polygon as curves, named <name>0, <name>1, ...
/// Throws   InvalidInput for less than three corners
std::vector<NamedCurve> polygon_curves(const std::string& name, const std::vector<Uv>& corners);

/// Fill in what follows from the rest, and check the model: call it last.
///
/// Sets the diagonal, finds which uses of a contour are at different speeds, and marks contours of
/// one use as boundaries.
///
/// Error    the diagonal is that of samples: 64 on each contour use, and those of 16 x 16 in each
///          domain that lie inside the loops. Uses are compared at 9 places
/// Cost     some hundred evaluations a patch, tens a contour use
/// Throws   what check(model) throws; Geometry for uses that are not the same points as their
///          contour's first, or do not end at its vertices, to 1e-6 of the diagonal, and for an
///          outer loop that runs clockwise or a hole that does not. All name the contour or patch
void complete_model(Model& model);

}  // namespace surfmesh
