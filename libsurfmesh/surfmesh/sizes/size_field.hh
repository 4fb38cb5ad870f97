// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "surfmesh/core/values.hh"
#include "surfmesh/geometry/surface.hh"
#include "surfmesh/sizes/curvature_length.hh"
#include "surfmesh/sizes/patch_sources.hh"
#include "surfmesh/sizes/size_bounds.hh"
#include "surfmesh/sizes/sizing.hh"

namespace surfmesh {

class NodeInterpolation;

/// What the sources of one patch ask for, exactly and at every point: the field that the control
/// space of the patch approximates.
class SizeField {
 public:
  struct Sample {
    Vec3 point;
    FirstFormFactor form;
    SizeTensor size;
  };

  /// The surface must outlive the field. `sources` are those of this patch only; tables are thinned
  /// to `precision` where they name none of their own.
  ///
  /// Sources of `at` alone are interpolated between each other, as nodes of a table are, where
  /// another source with a place meets them.
  /// Throws   InvalidInput for a bad source
  SizeField(const Surface& surface, const ResolvedSizing& sizing, const PatchSources& sources,
            double precision = 0.1);

  /// Position, first form and wanted sizes at a point of the bounding rectangle of the domain;
  /// beyond the diagonal of a triangular domain those of its mirror point.
  ///
  /// Curvature gives a size along each principal direction (CurvatureLength), clamped, then the
  /// larger limited to stretch times the smaller; then the minimum with the other sources is
  /// taken, in the order everywhere, inside, fields, tables, sizes around places; at last all are
  /// clamped. Around a short ring of faces sizes leave room for four elements, below hmin, too.
  /// Around an extraordinary vertex, where curvature grows without bound, the size is isotropic:
  /// that length h which the greatest curvature on the ring at the distance h/2 asks for, so that
  /// it does not depend on how near to the vertex one looks. Beside a narrowly rounded side the
  /// curvature is taken where the rounding ends.
  ///
  /// Cost     one surface evaluation with second derivatives, and what the sources cost
  /// Throws   InvalidInput where a field is not positive (definite) and finite, naming (u,v)
  Sample at(Uv uv) const;

  const Surface& surface() const { return surface_; }

  const SizeBounds& bounds() const { return bounds_; }

  /// Points of the domain at the places of `at`, `along` and `inside`, and one in each cell of a
  /// surface of several: what is asked for there may be too small to be seen from far apart.
  const std::vector<Uv>& required_points() const { return required_points_; }

  /// True if some source has a size at every point.
  bool has_area_source() const;

  /// True if some source may give sizes below hmax; if not, the field is hmax everywhere.
  bool has_source() const;

 private:
  /// Isotropic sizes around one extraordinary vertex.
  struct Disc {
    Vec3 centre;
    double radius;  ///< the size holds within it and fades out over as much again
    double size;
  };

  /// A size inside a polygon.
  struct Area {
    std::vector<Uv> polygon;
    SizeTensor size;
  };

  void add_all_sources(const PatchSources& sources, double grade, double precision);
  void add_tree(std::shared_ptr<const SourceTree> tree);
  void add_required_points(const PatchSources& sources);
  void add_cells();
  void add_discs();
  Uv in_cells(Uv uv) const;
  const std::vector<Disc>& discs_at(Uv uv) const;
  Jet second_order(Uv uv) const;
  void add_curvature(Uv uv, const Jet& jet, Sample& sample) const;
  void add_sources(Uv uv, const Jet& jet, Sample& sample) const;
  void add_rings(Uv uv, Sample& sample) const;
  SizeTensor size_of_field(const FieldSource& field, Uv uv, const Sample& sample) const;
  SizeTensor size_from_curvature(const Jet& jet) const;
  Disc make_disc(const SingularPoint& singular) const;
  Disc ring_around(Uv at, double distance) const;
  Disc quarter_ring(const Disc& so_far, Uv at, Uv towards, double distance) const;
  void blend_with_discs(Uv uv, Sample& sample) const;

  const Surface& surface_;
  std::shared_ptr<const Surface> differences_;  ///< of the surface; none for exact curvature
  Domain domain_;
  SizeBounds bounds_;
  CurvatureLength length_;
  double stretch_;
  std::optional<SizeTensor> everywhere_;
  std::vector<Area> areas_;
  std::vector<FieldSource> fields_;
  std::vector<std::shared_ptr<const NodeInterpolation>> tables_;
  std::vector<std::shared_ptr<const SourceTree>> trees_;
  std::vector<Ring> rings_;
  std::vector<Uv> required_points_;
  bool has_wishes_ = false;               ///< for more than the curvature
  std::vector<std::vector<Disc>> discs_;  ///< by cell of the surface, rows along u
};

}  // namespace surfmesh
