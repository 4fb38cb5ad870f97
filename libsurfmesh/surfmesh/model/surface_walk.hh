// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "surfmesh/model/model.hh"

namespace surfmesh {

/// A place on the surface of a model.
struct SurfacePlace {
  int patch = -1;
  Uv uv;

  friend bool operator==(const SurfacePlace&, const SurfacePlace&) = default;
};

/// A linear map of steps in (u,v).
struct StepMap {
  double uu = 1, uv = 0;  ///< the new u is uu u + uv v
  double vu = 0, vv = 1;

  Uv operator()(Uv step) const { return {uu * step.u + uv * step.v, vu * step.u + vv * step.v}; }

  /// First `before`, then this.
  StepMap after(const StepMap& before) const {
    return {uu * before.uu + uv * before.vu, uu * before.uv + uv * before.vv,
            vu * before.uu + vv * before.vu, vu * before.uv + vv * before.vv};
  }
};

/// Where a step over the surface leads, and how steps at its start are seen there.
struct WalkEnd {
  SurfacePlace place;
  StepMap turn;
};

/// Contours that merely divide a smooth surface: of two uses and no pole, where the tangent planes
/// agree, and along which the mesh is not cut. By contour, 1 for such.
std::vector<char> smooth_contours(const Model& model, const std::vector<int>& cut_contours);

/// Where walks begin.
enum class Walks {
  Everywhere,
  FromOpenPatches  ///< only in patches that can be left, or go() returns nothing
};

/// Goes over the surface of a model in straight lines, from patch to patch.
///
/// A line is straight in the parameters of a patch. Where it leaves the domain of the patch through
/// a contour that may be crossed, it goes on in the neighbour from the same point, in the same
/// direction of the tangent plane.
class SurfaceWalk {
 public:
  /// `may_cross` has an entry for each contour, and is 0 where one has not just two uses. The model
  /// must outlive this.
  ///
  /// Cost     a few evaluations a contour use that is straight in (u,v), up to a thousand for
  ///          others; none in patches that are not open, if walks begin in open ones only
  SurfaceWalk(const Model& model, std::vector<char> may_cross, Walks walks = Walks::Everywhere);

  /// Walk a step in the parameters of the patch of a place.
  ///
  /// Returns  nothing where a contour that may not be crossed is in the way, the surface has no
  ///          tangent plane at a crossing, or contours are crossed more than 16 times
  /// Cost     20 ns within a patch, two evaluations of first order a crossing
  std::optional<WalkEnd> go(const SurfacePlace& from, Uv step) const;

 private:
  /// A straight piece of the boundary of a patch, which lies on its left.
  struct Piece {
    Uv from, to;
    LoopEntry entry;
    double t_from = 0, t_to = 1;
  };

  /// The pieces of a patch in the cells of a grid over their bounding box.
  struct Border {
    bool is_closed = false;  ///< no contour may be crossed; it has no pieces then
    std::vector<Piece> pieces;
    Uv lower{0, 0}, upper{1, 1};
    std::size_t columns = 1, rows = 1;
    std::vector<std::size_t> first;  ///< by cell, into `in_cells`
    std::vector<std::size_t> in_cells;

    std::size_t column(double u) const;
    std::size_t row(double v) const;
    void sort_into_cells();
    template <class Visit>
    void for_each_cell(Uv a, Uv b, Visit visit) const;
  };

  /// A crossing of the boundary, at a share of a step.
  struct Crossing {
    const Piece* piece = nullptr;
    double share = 1;
    double along = 0;  ///< share of the piece
  };

  void add_use(const LoopEntry& entry, Border& border) const;
  void add_pieces(const Curve& curve, const Piece& whole, int halvings, Border& border) const;
  Crossing first_crossing(const Border& border, Uv from, Uv step) const;
  std::optional<WalkEnd> cross(const Crossing& crossing) const;

  const Model& model_;
  std::vector<char> may_cross_;
  std::vector<Border> borders_;  ///< by patch
};

}  // namespace surfmesh
