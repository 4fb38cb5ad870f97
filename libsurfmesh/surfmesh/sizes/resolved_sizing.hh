// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/model/model.hh"
#include "surfmesh/sizes/size_bounds.hh"
#include "surfmesh/sizes/sizing.hh"

namespace surfmesh {

/// A checked sizing in model units. It is made once per model, and everything that makes sizes uses
/// it.
///
/// Made by resolve() only, hence without defaults.
struct ResolvedSizing {
  SizeBounds bounds;
  double curvature;  ///< factor of the radius of curvature; 0 is off
  double sag;        ///< greatest distance between mesh and surface, model units; 0 is off
  double stretch;    ///< greatest ratio of the two sizes from curvature
  double grade;      ///< sizes grow by at most ln(grade) per unit of length; 0 is off
  bool contour_curvature;
  double proximity;  ///< elements wanted across a gap; 0 is off
  bool features;
  CurvatureFrom curvature_from;
  bool isotropic = false;
  /// By patch, where shares refer to the parts of the model; else empty. They lie in `bounds`.
  std::vector<SizeBounds> part_bounds = {};

  /// True if sizes follow from curvature at all.
  bool follows_curvature() const { return curvature > 0 || sag > 0; }
};

/// Check a sizing and turn its shares of the model's diagonal into lengths.
///
/// Throws   InvalidOption naming the option, its value and its range
ResolvedSizing resolve(const Sizing& sizing, double diagonal);

/// The least sag that the mesh of a model can have: twice the greatest tolerance, for where
/// surfaces that meet are apart, the mesh is off one of them.
double least_sag(const Model& model);

/// The same for a model, with no sag below that, and where shares refer to its parts
/// (SharesOf::Part): the bounds are then those of all parts together.
///
/// Cost     with SharesOf::Part that of part_diagonals, else nothing
/// Throws   as above
ResolvedSizing resolve(const Sizing& sizing, const Model& model);

}  // namespace surfmesh
