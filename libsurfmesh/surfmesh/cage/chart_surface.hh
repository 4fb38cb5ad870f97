// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "surfmesh/cage/cage_surface.hh"
#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

/// A plane with its axes in space: coordinates along the first two are (u,v), in model units.
struct ChartFrame {
  Vec3 origin = Vec3::Zero();
  Vec3 along_u = Vec3::UnitX();
  Vec3 along_v = Vec3::UnitY();
  Vec3 normal = Vec3::UnitZ();

  /// A frame whose normal is the unit vector given.
  static ChartFrame at(const Vec3& origin, const Vec3& normal);

  Uv project(const Vec3& point) const { return step(point - origin); }
  Uv step(const Vec3& in_space) const { return {along_u.dot(in_space), along_v.dot(in_space)}; }
};

/// A face of a chart: the limit surface over a face of a cage, and its neighbours in the chart.
struct ChartFace {
  /// Beyond one of its sides.
  struct Neighbour {
    int face = -1;  ///< in the chart, -1 for none
    int side = -1;  ///< of that face, which it passes in the opposite direction
  };

  std::shared_ptr<const Surface> surface;
  std::array<int, 4> vertices = {-1, -1, -1, -1};  ///< numbers that tell the corners apart
  std::array<Neighbour, 4> neighbours = {};
};

/// A part of a limit surface of many small faces, as the graph of a function over a plane.
///
/// Second derivatives are for sizes: they come from the normals at the vertices of the faces, and
/// are linear in between; the roundings of semi-sharp creases have no part in them. Those of the
/// limit surface itself ripple within faces, most around
/// extraordinary vertices, where they may have no bounds. Beyond its faces the chart goes on in
/// tangent planes, with the second derivatives at their border.
class Chart {
 public:
  /// Pre      each face, seen along the normal of the frame, turns counter-clockwise and covers no
  ///          part of another one
  /// Cost     an evaluation for each corner of a face, and O(n log n) for n faces
  /// Throws   InvalidInput if there are no faces
  Chart(const ChartFrame& frame, std::vector<ChartFace> faces);

  /// The surface above a point of the plane.
  ///
  /// Error    positions 1e-13 of a face, first derivatives 1e-6 (test ChartTest.IsThatOfItsFaces)
  /// Cost     three to four evaluations of a face, and more near its border; far beyond it, one,
  /// and
  ///          O(n) for n sides of the border
  /// Throws   Geometry if the point is not finite, or the surface has no tangent plane there
  Jet evaluate(Uv uv, Order order) const;

  /// The point above one of the plane, if a face is there.
  std::optional<Vec3> point_on_faces(Uv uv) const;

  /// The place on the cage of a point of the plane; beyond all faces the nearest one.
  CagePlace place(Uv uv) const;

  const ChartFrame& frame() const { return frame_; }

  /// The side of a square of the area that faces cover, on average.
  double face_size() const { return face_size_; }

 private:
  /// A point of a face in its own parameters.
  struct FacePoint {
    std::size_t face = 0;
    Uv at;
  };

  /// What a search has come to.
  struct Found {
    FacePoint place;
    Jet jet;         ///< of the face there, of first order
    Uv miss;         ///< the point asked for, as seen from there
    bool is_inside;  ///< false beyond all faces
  };

  /// A step of a search.
  struct Move {
    FacePoint to;
    bool is_turn = false;          ///< into another face at the same corner
    bool is_along_border = false;  ///< kept from leaving the last face
    bool is_within_face = false;
  };

  /// A side of a face beyond which there is none.
  struct BorderSide {
    std::size_t face = 0;
    int side = 0;
  };

  /// Where a search starts.
  struct Start {
    FacePoint place;
    bool is_far_beyond = false;  ///< all faces: no search is needed
  };

  /// The upper half of a symmetric matrix: how the slope of the surface over the plane changes.
  struct Bend {
    double uu = 0, uv = 0, vv = 0;
  };

  Start start(Uv uv) const;
  Start nearest_on_border(Uv uv) const;
  FacePoint place_in(std::size_t face, Uv uv) const;
  bool contains(std::size_t face, Uv uv) const;
  Found find(Uv uv) const;
  Found look(Uv uv, const FacePoint& place) const;
  Found search(Uv uv, const FacePoint& from) const;
  Move go(const FacePoint& place, Uv step) const;
  Jet in_plane(const Jet& jet) const;
  Jet tangent_at(const Found& found) const;
  Uv slope_of(const Vec3& normal) const;
  Bend bend_at(const FacePoint& place) const;
  void number_vertices();
  void measure_bends(const std::vector<std::array<Uv, 4>>& slopes);
  bool has_cell(Uv uv) const;
  std::size_t column(double u) const;
  std::size_t row(double v) const;
  void sort_into_cells();

  ChartFrame frame_;
  std::vector<ChartFace> faces_;
  Domain unit_;                             ///< of each face
  std::vector<std::array<Uv, 4>> corners_;  ///< of the faces, in the plane
  std::vector<BorderSide> border_;
  double face_size_ = 0;
  double squared_bulge_ = 0;  ///< how far sides of the border may be from their lines, at most
  std::vector<std::array<std::size_t, 4>> vertices_;  ///< of the faces, into `bends_`
  std::vector<Uv> slopes_;                            ///< at the vertices
  std::vector<Bend> bends_;                           ///< likewise
  // A grid over the corners.
  Uv lower_{0, 0}, upper_{0, 0};
  std::size_t columns_ = 1, rows_ = 1;
  std::vector<std::size_t> first_;     ///< by cell, into `in_cells_`
  std::vector<std::size_t> in_cells_;  ///< faces
};

/// The surface of a chart. Its parameters are coordinates in the plane.
///
/// So they run smoothly over the faces, whatever the parameters of those do, and elements of any
/// size may lie on them.
class ChartSurface : public CageSurface {
 public:
  /// `domain` is a rectangle in the plane.
  ChartSurface(std::shared_ptr<const Chart> chart, const Domain& domain, CellCount cells)
      : chart_(std::move(chart)), domain_(domain), cells_(cells) {}

  Jet evaluate(Uv uv, Order order) const override { return chart_->evaluate(uv, order); }
  Domain domain() const override { return domain_; }
  CellCount cells() const override { return cells_; }

  /// Cost     that of an evaluation of first order
  CagePlace place(Uv uv) const override { return chart_->place(uv); }

 private:
  std::shared_ptr<const Chart> chart_;
  Domain domain_;
  CellCount cells_;
};

}  // namespace surfmesh
