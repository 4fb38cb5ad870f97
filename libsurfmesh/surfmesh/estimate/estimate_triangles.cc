// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/estimate/estimate_triangles.hh"

#include <algorithm>
#include <cmath>
#include <utility>

#include "surfmesh/control/control_space.hh"
#include "surfmesh/control/surface_metric_field.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/estimate/patch_region.hh"
#include "surfmesh/geometry/first_form.hh"
#include "surfmesh/geometry/parts.hh"
#include "surfmesh/metric/size_tensor.hh"
#include "surfmesh/metric/tensor.hh"
#include "surfmesh/metric/triangle.hh"

namespace surfmesh {
namespace {

/// Triangles on a border of the region are divided down to this share of its area.
constexpr double kLeastShare = 1.0 / 4096;

/// They are not divided further where so little of an element is left: on the border of small
/// patches, that is nearly all the work.
constexpr double kLeastElements = 0.5;

/// Ratio of the areas of two sizes between which three points are enough for an integral.
constexpr double kEvenShare = 4;

constexpr int kChordsPerPart = 4;

/// Sizes below hmin by more than rounding are those around tubes.
constexpr double kJustBelow = 0.999;

/// No model has larger sizes.
constexpr double kGreatestSize = 1e100;

/// What is interpolated linearly in a triangle.
struct Node {
  Uv uv;
  double scale;  ///< area in space per area in parameters
  double l_s;
  double l_t;
};

Node mixed(const Node& a, const Node& b, const Node& c, double of_a, double of_b) {
  const double of_c = 1 - of_a - of_b;
  return {of_a * a.uv + of_b * b.uv + of_c * c.uv, of_a * a.scale + of_b * b.scale + of_c * c.scale,
          of_a * a.l_s + of_b * b.l_s + of_c * c.l_s, of_a * a.l_t + of_b * b.l_t + of_c * c.l_t};
}

struct NodeTriangle {
  Node a, b, c;

  UvTriangle uvs() const { return {a.uv, b.uv, c.uv}; }
  double area() const {
    const Uv ab = b.uv - a.uv, ac = c.uv - a.uv;
    return 0.5 * std::abs(ab.u * ac.v - ab.v * ac.u);
  }
  /// How many triangles of its sizes it holds, at the corner where they are most.
  double elements() const {
    const double most =
        std::max({a.scale / (a.l_s * a.l_t), b.scale / (b.l_s * b.l_t), c.scale / (c.l_s * c.l_t)});
    return most * area() / kUnitTriangleArea;
  }
  bool is_even() const {
    const auto [least, greatest] = std::minmax({a.l_s * a.l_t, b.l_s * b.l_t, c.l_s * c.l_t});
    return greatest <= kEvenShare * least;
  }
};

/// Collects the pieces of one patch.
class PatchIntegral {
 public:
  PatchIntegral(const Model& model, int patch, const ControlSpace& space)
      : model_(model),
        patch_(patch),
        space_(space),
        region_(model, patch),
        least_area_(kLeastShare * region_.area()) {}

  SizedPatch run() {
    add_faces();
    for (const PatchLoop& loop : model_.patch(patch_).loops) {
      for (const LoopEntry& entry : loop) add_contour(entry);
    }
    return std::move(result_);
  }

 private:
  std::vector<Node> nodes() const {
    const PolyMesh& mesh = space_.mesh();
    const auto uv_of = require(mesh, keys::vertex_uv);
    const auto size_of = require(mesh, keys::vertex_size);
    std::vector<Node> nodes;
    nodes.reserve(mesh.n_vertices());
    for (const VertexHandle vh : mesh.vertices()) {
      const Uv uv = mesh.property(uv_of, vh);
      const SizeRange range = size_range(mesh.property(size_of, vh));
      const FirstFormFactor form = space_.form(vh.idx());
      nodes.push_back({uv, form.l11 * form.l22, range.greatest, range.least});
    }
    return nodes;
  }

  void add_faces() {
    const std::vector<Node> all = nodes();
    const PolyMesh& mesh = space_.mesh();
    std::vector<const Node*> corners;
    for (const FaceHandle fh : mesh.faces()) {
      corners.clear();
      for (const VertexHandle vh : mesh.fv_range(fh)) {
        corners.push_back(&all[static_cast<std::size_t>(vh.idx())]);
      }
      for (std::size_t k = 2; k < corners.size(); ++k) {
        const NodeTriangle t{*corners[0], *corners[k - 1], *corners[k]};
        add_inside(t, region_.segments_at(t.uvs()));
      }
    }
  }

  /// Add what is inside the region of a triangle through which some segments pass, in pieces of
  /// about one size.
  void add_inside(const NodeTriangle& t, const std::vector<int>& segments) {
    const bool is_small = t.area() <= least_area_ || t.elements() <= kLeastElements;
    if ((segments.empty() && t.is_even()) || is_small) {
      if (region_.contains(mixed(t.a, t.b, t.c, 1.0 / 3, 1.0 / 3).uv)) add(t);
      return;
    }
    const Node ab = mixed(t.a, t.b, t.c, 0.5, 0.5), bc = mixed(t.a, t.b, t.c, 0, 0.5),
               ca = mixed(t.a, t.b, t.c, 0.5, 0);
    for (const NodeTriangle& part :
         {NodeTriangle{t.a, ab, ca}, {ab, t.b, bc}, {ca, bc, t.c}, {ab, bc, ca}}) {
      add_inside(part, region_.segments_at(part.uvs(), segments));
    }
  }

  void add(const NodeTriangle& t) {
    const double third = t.area() / 3;
    if (third == 0) return;
    constexpr double near = 2.0 / 3, far = 1.0 / 6;
    for (const Node& n : {mixed(t.a, t.b, t.c, near, far), mixed(t.a, t.b, t.c, far, near),
                          mixed(t.a, t.b, t.c, far, far)}) {
      result_.pieces.push_back({third * n.scale, n.l_s, n.l_t});
    }
  }

  void add_contour(const LoopEntry& entry) {
    const Contour& contour = model_.contour(entry);
    auto& chords = result_.contours.emplace_back();
    if (contour.is_degenerate) return;
    const Surface& surface = model_.surface(patch_);
    const Curve& curve = *model_.use(entry).curve;
    const SurfaceMetricField field(surface, space_);
    const std::vector<double> ends = divided_parts(contour.breaks, kChordsPerPart);
    Vec3 last = surface.evaluate(curve.evaluate(0), Order::Position).point;
    for (std::size_t i = 1; i < ends.size(); ++i) {
      const Uv from = curve.evaluate(ends[i - 1]), to = curve.evaluate(ends[i]);
      const Vec3 next = surface.evaluate(to, Order::Position).point;
      const double length = (next - last).norm();
      const double units =
          std::sqrt(squared_length(field.at(lerp(from, to, 0.5), hint_), to - from));
      if (units > 0) chords.push_back({length, length / units});
      last = next;
    }
  }

  const Model& model_;
  int patch_;
  const ControlSpace& space_;
  PatchRegion region_;
  double least_area_;
  QueryHint hint_;
  SizedPatch result_;
};

}  // namespace

double TriangleEstimate::triangles_of(const SizedPatch& patch, double hmin) const {
  const auto raised = [&](double size) {
    return size < bounded_from_ ? size : std::max(size, hmin);
  };
  double area = 0;
  for (const SizedPiece& piece : patch.pieces) {
    area += piece.area / (raised(piece.l_s) * raised(piece.l_t));
  }
  double segments = 0;
  for (const auto& contour : patch.contours) {
    double units = 0;
    for (const SizedChord& chord : contour) units += chord.length / raised(chord.size);
    segments += contour.empty() ? 0 : std::max(1.0, units);
  }
  // By Euler's formula, a disc without inner nodes has two triangles less than nodes.
  return std::max(area / kUnitTriangleArea, segments - 2);
}

double TriangleEstimate::triangles_with(double hmin) const {
  double triangles = 0;
  for (const SizedPatch& patch : patches_) triangles += triangles_of(patch, hmin);
  return triangles;
}

std::vector<double> TriangleEstimate::triangles_of_patches() const {
  std::vector<double> triangles;
  for (const SizedPatch& patch : patches_) triangles.push_back(triangles_of(patch, 0));
  return triangles;
}

std::optional<double> TriangleEstimate::fitting_hmin(double triangles) const {
  double low = 0, high = bounded_from_;
  for (const SizedPatch& patch : patches_) {
    for (const SizedPiece& piece : patch.pieces) high = std::max(high, piece.l_s);
  }
  // Sizes may all be too small: the size that holds everywhere has no bound among them.
  while (triangles_with(high) > triangles) {
    if (!(high > 0 && high < kGreatestSize)) return std::nullopt;
    low = high;
    high *= 2;
  }
  while (high - low > 0.01 * high) {
    const double middle = 0.5 * (low + high);
    (triangles_with(middle) > triangles ? low : high) = middle;
  }
  return high;
}

TriangleEstimate estimate_triangles(const Model& model,
                                    const std::vector<std::unique_ptr<ControlSpace>>& spaces,
                                    double hmin, const RunContext& context) {
  std::vector<SizedPatch> patches(spaces.size());
  share_indices(spaces.size(), [&](std::size_t p) {
    context.throw_if_cancelled();
    patches[p] = PatchIntegral(model, static_cast<int>(p), *spaces[p]).run();
  });
  return TriangleEstimate(std::move(patches), kJustBelow * hmin);
}

}  // namespace surfmesh
