// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "surfmesh/control/sizing.hh"
#include "surfmesh/core/values.hh"
#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

/// What the area sources of one patch ask for, exactly and at every point: the field that the
/// control space of the patch approximates.
class SizeField {
 public:
  struct Sample {
    Vec3 point;
    FirstFormFactor form;
    SizeTensor size;
  };

  /// The surface must outlive the field. `everywhere` holds the sources of this patch only.
  ///
  /// Throws   InvalidOption for sizing outside its legal range, InvalidInput for a bad source
  SizeField(const Surface& surface, const Sizing& sizing,
            const std::vector<EverywhereSource>& everywhere, double diagonal);

  /// Position, first form and wanted sizes at a point of the bounding rectangle of the domain;
  /// beyond the diagonal of a triangular domain those of its mirror point.
  ///
  /// Curvature gives the size factor × radius along each principal direction, clamped, then the
  /// larger limited to stretch times the smaller; then the minimum with the other sources is
  /// taken. Around an extraordinary vertex, where curvature grows without bound, the size is
  /// isotropic: h with h = factor / (greatest curvature on the ring at the distance h/2), so that it
  /// does not depend on how near to the vertex one looks. Beside a narrowly rounded side the
  /// curvature is taken where the rounding ends.
  ///
  /// Cost     one surface evaluation with second derivatives
  Sample at(Uv uv) const;

  const Surface& surface() const { return surface_; }

  /// Clamp the sizes of any source to hmin and hmax.
  SizeTensor clamp(const SizeTensor& size) const;

  /// The size tensor of a user's size.
  /// Throws   InvalidInput if a length is not positive and finite, or the angle not finite
  SizeTensor tensor(const Size& size) const;

  /// True if some area source gives sizes below hmax; if not, the field is hmax everywhere.
  bool has_source() const { return factor_ > 0 || everywhere_.has_value(); }

  double hmin() const { return hmin_; }
  double hmax() const { return hmax_; }

 private:
  /// Isotropic sizes around one extraordinary corner.
  struct Disc {
    Vec3 centre;
    double radius;  ///< the size holds within it and fades out over as much again
    double size;
  };

  Uv beside_roundings(Uv uv) const;
  Uv beside_pole(Uv uv) const;
  SizeTensor size_from_curvature(const Jet& jet) const;
  Disc make_disc(const SingularPoint& singular) const;
  double least_size_on_ring(Uv corner, double distance, double& radius) const;
  void blend_with_discs(Sample& sample) const;

  const Surface& surface_;
  Domain domain_;
  double diagonal_;
  double factor_;
  double hmin_;
  double hmax_;
  double stretch_;
  std::optional<SizeTensor> everywhere_;
  std::vector<RoundedSide> rounded_sides_;
  std::vector<Disc> discs_;
};

}  // namespace surfmesh
