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

/// The exact sizes that the sources of one patch ask for, at every point. The control space of the
/// patch approximates this field.
class SizeField {
 public:
  /// All that is known of a point.
  struct Sample {
    Vec3 point;
    FirstFormFactor form;
    SizeTensor size;
  };

  /// The surface must outlive the field. `sources` are those of this patch only. Tables are thinned
  /// to `precision`, unless they have one of their own.
  ///
  /// If a patch has sources of `at` and others at points or along curves, but none with a size at
  /// every point, those of `at` are interpolated between each other, like nodes of a table.
  /// Throws   InvalidInput for an invalid source
  SizeField(const Surface& surface, const ResolvedSizing& sizing, const PatchSources& sources,
            double precision = 0.1);

  /// Position, first form and wanted sizes at a point of the bounding rectangle of the domain.
  /// Beyond the diagonal of a triangular domain, those of the mirror point.
  ///
  /// Curvature gives a size along each principal direction (CurvatureLength). Both are clamped, and
  /// the larger is limited to stretch times the smaller. Then the minimum with the other sources is
  /// computed, in the order everywhere, inside, fields, tables, sizes around points and lines, and
  /// the result is clamped. Around a short ring of faces, sizes leave room for four elements, even
  /// below hmin. At an extraordinary vertex curvature is unbounded, so the size around it is
  /// isotropic: the length h that the greatest curvature on the ring at distance h/2 asks for. It
  /// does not depend on the distance from the vertex. Beside a narrowly rounded side, the curvature
  /// is that where the rounding ends. Ripples around a vertex of many faces do not count (WideFan).
  ///
  /// Cost     one surface evaluation with second derivatives, plus the cost of the sources
  /// Throws   InvalidInput if a field is not positive (definite) and finite, naming (u,v)
  Sample at(Uv uv) const;

  /// The same sources without the sizes that the sag takes from curvature: what else is asked for.
  SizeField without_sag() const;

  const Surface& surface() const { return surface_; }

  const SizeBounds& bounds() const { return bounds_; }

  /// The fields among its sources.
  const std::vector<FieldSource>& fields() const { return fields_; }

  /// Points that sampling must include: those of `at`, rows of tables, points along `along` and the
  /// borders of `inside`, and one in each cell of a surface with several. Sizes there may hold in
  /// so small an area that widely spaced samples would miss them.
  const std::vector<Uv>& required_points() const { return required_points_; }

  /// True if some source has a size at every point.
  bool has_area_source() const;

  /// True if some source may give sizes below hmax; otherwise the field is hmax everywhere.
  bool has_source() const;

 private:
  /// Isotropic sizes around one extraordinary vertex.
  struct Disc {
    Vec3 centre;
    double radius;  ///< the size holds within it and fades out over the same distance again
    double size;
  };

  /// A size inside a polygon.
  struct Area {
    std::vector<Uv> polygon;
    SizeTensor size;
  };

  /// Lengths of p_u and p_v.
  struct Speeds {
    double u = 0;
    double v = 0;
  };

  Speeds greatest_speeds() const;
  FirstFormFactor form_of(const Jet& jet) const;
  void add_all_sources(const PatchSources& sources, double grade, double precision);
  void add_tree(std::shared_ptr<const SourceTree> tree);
  void add_required_points(const PatchSources& sources);
  void add_nearest_points(const PatchSources& sources);
  void add_cells();
  void add_discs();
  std::size_t cell_at(Uv uv) const;
  Jet second_order(Uv uv) const;
  PrincipalCurvatures curvatures(Uv uv, const Jet& jet) const;
  void add_curvature(Uv uv, const Jet& jet, Sample& sample) const;
  void add_sources(Uv uv, const Jet& jet, Sample& sample) const;
  void add_rings(Uv uv, Sample& sample) const;
  SizeTensor size_from_curvature(Uv uv, const Jet& jet) const;
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
  bool is_isotropic_;
  Speeds speeds_;  ///< of the surface, greatest
  std::optional<SizeTensor> everywhere_;
  std::vector<Area> areas_;
  std::vector<FieldSource> fields_;
  std::vector<std::shared_ptr<const NodeInterpolation>> tables_;
  std::vector<std::shared_ptr<const SourceTree>> trees_;
  std::vector<WideFan> fans_;
  std::vector<Ring> rings_;
  std::vector<Uv> required_points_;
  bool has_wishes_ = false;               ///< sources apart from the curvature
  std::vector<std::vector<Disc>> discs_;  ///< by cell of the surface, rows along u
};

}  // namespace surfmesh
