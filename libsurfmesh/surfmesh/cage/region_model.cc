// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/region_model.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

#include "surfmesh/cage/region_borders.hh"
#include "surfmesh/cage/region_curves.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/geometry/crossing_segments.hh"
#include "surfmesh/geometry/parts.hh"

namespace surfmesh {
namespace {

using Side = FaceNeighbours::Side;
using Surfaces = std::vector<std::shared_ptr<const Surface>>;

/// How often the points of a free contour are smoothed, most first: one that does not stay within
/// the charts on both sides is smoothed less, and in the end runs along the edges.
constexpr std::array kSmoothings = {24, 6, 1};

/// Points of each part of a contour: the first stand for it in a polygon, the second tell whether
/// it stays within charts.
constexpr int kSamples = 3;
constexpr int kChecks = 8;

/// Distance of charts in space, in faces, from which on they are not one surface at a point.
constexpr double kApart = 1e-6;

/// Shares of a part of a contour that are joined to find crossings: sides of rough faces may meet
/// next to a corner.
constexpr std::array kCloseSamples = {0.0, 1.0 / 256, 1.0 / 64,     1.0 / 16,     0.25,
                                      0.5, 0.75,      1 - 1.0 / 16, 1 - 1.0 / 64, 1 - 1.0 / 256};

/// Distance of a chart from the corners of its faces, in faces, from which on it has missed them.
constexpr double kOff = 1e-4;

/// Cells of a control space that a face is wide.
constexpr double kCellsPerFace = 0.5;

/// What the domain of a chart has around its contours, in faces.
constexpr double kAround = 0.1;

/// The curves of a chain, by use; with their surfaces they give the same points.
using ChainCurves = std::vector<std::shared_ptr<const Curve>>;

/// The charts of regions, or the surfaces of single faces.
class RegionSurfaces {
 public:
  RegionSurfaces(const FaceNeighbours& neighbours, const Surfaces& surfaces,
                 const std::vector<FaceRegion>& regions)
      : neighbours_(neighbours), surfaces_(surfaces), regions_(regions), charts_(regions.size()) {
    share_indices(regions.size(), [this](std::size_t r) {
      if (regions_[r].is_chart) charts_[r] = chart_of(regions_[r]);
    });
  }

  bool is_chart(int region) const { return charts_[index(region)] != nullptr; }
  const std::shared_ptr<const Chart>& chart(int region) const { return charts_[index(region)]; }

  const std::shared_ptr<const Surface>& face(int number) const { return surfaces_[index(number)]; }

  FaceSide side(Side side) const {
    const auto& surface = surfaces_[index(side.face)];
    const Domain domain = surface->domain();
    return {surface, domain.corner(side.side),
            domain.corner((side.side + 1) % domain.corner_count())};
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  std::shared_ptr<const Chart> chart_of(const FaceRegion& region) const {
    std::vector<int> all = region.faces;
    all.insert(all.end(), region.margin.begin(), region.margin.end());
    std::sort(all.begin(), all.end());
    const auto place_of = [&](int face) {
      const auto found = std::lower_bound(all.begin(), all.end(), face);
      return found != all.end() && *found == face ? static_cast<int>(found - all.begin()) : -1;
    };
    std::vector<ChartFace> faces;
    for (const int face : all) {
      ChartFace chart_face{surfaces_[index(face)]};
      for (int i = 0; i < neighbours_.corner_count(); ++i) {
        chart_face.vertices[index(i)] = neighbours_.vertex({face, i});
        const Side beyond = neighbours_.across({face, i});
        if (beyond.face < 0) continue;
        chart_face.neighbours[index(i)] = {place_of(beyond.face), beyond.side};
      }
      faces.push_back(std::move(chart_face));
    }
    return std::make_shared<Chart>(region.frame, std::move(faces));
  }

  const FaceNeighbours& neighbours_;
  const Surfaces& surfaces_;
  const std::vector<FaceRegion>& regions_;
  std::vector<std::shared_ptr<const Chart>> charts_;  ///< by region; null for single faces
};

/// Lays the curves of chains.
class CurveMaker {
 public:
  explicit CurveMaker(const RegionSurfaces& surfaces) : surfaces_(surfaces) {}

  /// Along the edges of the cage.
  ChainCurves along_edges(const BorderChain& chain) const {
    ChainCurves curves;
    for (const BorderChain::Use& use : chain.uses) {
      std::vector<FaceSide> sides;
      for (const Side side : use.sides) {
        sides.push_back(surfaces_.side(side));
        if (!use.is_forward) std::swap(sides.back().from, sides.back().to);
      }
      if (surfaces_.is_chart(use.region)) {
        curves.push_back(
            std::make_shared<SidesInChart>(surfaces_.chart(use.region)->frame(), std::move(sides)));
      } else {
        curves.push_back(std::make_shared<SegmentCurve>(sides[0].from, sides[0].to));
      }
    }
    return curves;
  }

  /// As smooth as may be.
  ChainCurves curves_of(const BorderChain& chain) const {
    ChainCurves along = along_edges(chain);
    if (!chain.is_free || chain.uses.size() != 2 || chain.edge_count() < 2) return along;
    std::vector<Uv> points;
    for (int i = 0; i <= chain.edge_count(); ++i) {
      points.push_back(along[0]->evaluate(double(i) / chain.edge_count()));
    }
    for (const int times : kSmoothings) {
      ChainCurves curves = {std::make_shared<UniformSpline>(smoothed(points, times))};
      curves.push_back(
          std::make_shared<CurveOfOtherChart>(surfaces_.chart(chain.uses[0].region), curves[0],
                                              surfaces_.chart(chain.uses[1].region)->frame()));
      if (stays_in_charts(chain, curves)) return curves;
    }
    return along;
  }

 private:
  bool stays_in_charts(const BorderChain& chain, const ChainCurves& curves) const {
    const Chart& a = *surfaces_.chart(chain.uses[0].region);
    const Chart& b = *surfaces_.chart(chain.uses[1].region);
    const double most = kApart * a.face_size();
    const int count = kChecks * chain.edge_count();
    for (int i = 1; i < count; ++i) {
      const double t = double(i) / count;
      const auto in_a = a.point_on_faces(curves[0]->evaluate(t));
      const auto in_b = b.point_on_faces(curves[1]->evaluate(t));
      if (!in_a || !in_b || !((*in_a - *in_b).norm() <= most)) return false;
    }
    return true;
  }

  const RegionSurfaces& surfaces_;
};

/// Lets curves run along the edges where smooth ones would cross others.
class CrossingMender {
 public:
  CrossingMender(const RegionBorders& borders, const RegionSurfaces& surfaces,
                 const CurveMaker& maker, std::vector<ChainCurves>& curves)
      : borders_(borders), surfaces_(surfaces), maker_(maker), curves_(curves) {
    for (const BorderChain& chain : borders.chains) is_smooth_.push_back(chain.is_free ? 1 : 0);
  }

  void run() {
    std::vector<std::size_t> due;
    for (std::size_t r = 0; r < borders_.loops.size(); ++r) {
      if (surfaces_.is_chart(static_cast<int>(r))) due.push_back(r);
    }
    while (!due.empty()) {
      std::vector<std::vector<int>> crossing(due.size());
      share_indices(due.size(), [&](std::size_t i) { crossing[i] = crossing_chains(due[i]); });
      std::set<std::size_t> changed;
      for (const std::vector<int>& chains : crossing) {
        for (const int chain : chains) lay_along_edges(static_cast<std::size_t>(chain), changed);
      }
      due.assign(changed.begin(), changed.end());
    }
  }

 private:
  /// Collects the charts whose borders change.
  void lay_along_edges(std::size_t chain, std::set<std::size_t>& changed) {
    if (!std::exchange(is_smooth_[chain], char{0})) return;
    curves_[chain] = maker_.along_edges(borders_.chains[chain]);
    for (const BorderChain::Use& use : borders_.chains[chain].uses) {
      if (surfaces_.is_chart(use.region)) changed.insert(static_cast<std::size_t>(use.region));
    }
  }

  /// The chains of a region whose curves cross.
  std::vector<int> crossing_chains(std::size_t region) const {
    std::vector<detail::NodeLoop> loops;
    std::vector<std::vector<int>> chain_of;  // by segment
    for (const std::vector<ChainUse>& loop : borders_.loops[region]) {
      loops.emplace_back();
      chain_of.emplace_back();
      for (const ChainUse& use : loop) add(use, loops.back(), chain_of.back());
    }
    std::vector<int> chains;
    for (const auto& [a, b] : detail::crossing_segments(loops)) {
      chains.push_back(chain_of[a.loop][a.node]);
      chains.push_back(chain_of[b.loop][b.node]);
    }
    return chains;
  }

  void add(const ChainUse& entry, detail::NodeLoop& nodes, std::vector<int>& chain_of) const {
    const BorderChain& chain = borders_.chains[static_cast<std::size_t>(entry.chain)];
    const auto use = static_cast<std::size_t>(entry.use);
    const Curve& curve = *curves_[static_cast<std::size_t>(entry.chain)][use];
    const int count = kSamples * chain.edge_count();
    for (int i = 0; i < count; ++i) {
      const double t = double(i) / count;
      nodes.push_back(curve.evaluate(chain.uses[use].is_forward ? t : 1 - t));
      chain_of.push_back(entry.chain);
    }
  }

  const RegionBorders& borders_;
  const RegionSurfaces& surfaces_;
  const CurveMaker& maker_;
  std::vector<ChainCurves>& curves_;
  std::vector<char> is_smooth_;  ///< by chain
};

/// Puts the pieces together.
class ModelMaker {
 public:
  ModelMaker(const FaceNeighbours& neighbours, const RegionBorders& borders,
             const RegionSurfaces& surfaces, std::vector<ChainCurves> curves)
      : borders_(borders),
        surfaces_(surfaces),
        curves_(std::move(curves)),
        vertex_of_(static_cast<std::size_t>(neighbours.level().GetNumVertices()), -1) {}

  Model run(const std::vector<FaceRegion>& regions) {
    model_.contours.resize(borders_.chains.size());
    for (std::size_t c = 0; c < borders_.chains.size(); ++c) add_contour(c);
    for (std::size_t r = 0; r < regions.size(); ++r) add_patch(regions[r], static_cast<int>(r));
    return std::move(model_);
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  void add_contour(std::size_t c) {
    const BorderChain& chain = borders_.chains[c];
    Contour& contour = model_.contours[c];
    contour.name = fmt::format("e{}-{}", chain.start, chain.second);
    if (chain.edge_count() > 1) contour.name += fmt::format("..{}", chain.end);
    contour.breaks = even_breaks(chain.edge_count());
    // One that has a single use is a true boundary.
    contour.is_smooth = chain.is_smooth && chain.uses.size() > 1;
    const FaceSide first = surfaces_.side(chain.uses[0].sides.front());
    const FaceSide last = surfaces_.side(chain.uses[0].sides.back());
    contour.start = vertex(chain.start, first.surface->evaluate(first.from, Order::Position).point);
    contour.end = vertex(chain.end, last.surface->evaluate(last.to, Order::Position).point);
    contour.is_degenerate = contour.start == contour.end && contour.breaks.empty();
    for (std::size_t u = 0; u < chain.uses.size(); ++u) {
      const BorderChain::Use& use = chain.uses[u];
      contour.uses.push_back({use.region, curves_[c][u], use.is_forward});
    }
  }

  int vertex(int of_cage, const Vec3& position) {
    int& number = vertex_of_[index(of_cage)];
    if (number >= 0) return number;
    number = static_cast<int>(model_.vertices.size());
    model_.vertices.push_back({position});
    return number;
  }

  void add_patch(const FaceRegion& region, int r) {
    Patch& patch = model_.patches.emplace_back();
    for (const std::vector<ChainUse>& loop : borders_.loops[index(r)]) {
      PatchLoop& entries = patch.loops.emplace_back();
      for (const ChainUse& use : loop) entries.push_back({use.chain, use.use});
    }
    if (!region.is_chart) {
      patch.surface = surfaces_.face(region.faces[0]);
      return;
    }
    patch.surface = surface_of(r);
    const auto outer =
        std::max_element(patch.loops.begin(), patch.loops.end(),
                         [&](const PatchLoop& a, const PatchLoop& b) { return area(a) < area(b); });
    std::iter_swap(patch.loops.begin(), outer);
  }

  /// The points of a loop that stand for its curves.
  std::vector<Uv> samples(const PatchLoop& loop) const {
    std::vector<Uv> points;
    for (const LoopEntry& entry : loop) {
      const ContourUse& use = model_.use(entry);
      const int count = kSamples * model_.contour(entry).part_count();
      for (int i = 0; i < count; ++i) {
        const double t = double(i) / count;
        points.push_back(use.curve->evaluate(use.is_forward ? t : 1 - t));
      }
    }
    return points;
  }

  double area(const PatchLoop& loop) const {
    const std::vector<Uv> points = samples(loop);
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      sum += cross(points[i], points[(i + 1) % points.size()]);
    }
    return sum / 2;
  }

  /// The chart of a region with a domain around its contours.
  std::shared_ptr<const Surface> surface_of(int r) const {
    const double size = surfaces_.chart(r)->face_size();
    Domain box{kUnset, kUnset, kUnset, kUnset};
    for (const PatchLoop& loop : model_.patch(r).loops) {
      for (const Uv uv : samples(loop)) {
        box = {std::fmin(box.u0, uv.u), std::fmax(box.u1, uv.u), std::fmin(box.v0, uv.v),
               std::fmax(box.v1, uv.v)};
      }
    }
    const double around = kAround * size;
    box = {box.u0 - around, box.u1 + around, box.v0 - around, box.v1 + around};
    const auto cells = [&](double width) {
      return std::max(1, static_cast<int>(std::lround(kCellsPerFace * width / size)));
    };
    return std::make_shared<ChartSurface>(
        surfaces_.chart(r), box, CellCount{cells(box.u1 - box.u0), cells(box.v1 - box.v0)});
  }

  const RegionBorders& borders_;
  const RegionSurfaces& surfaces_;
  std::vector<ChainCurves> curves_;  ///< by chain
  std::vector<int> vertex_of_;       ///< model vertex of a cage vertex, -1 if it has none
  Model model_;
};

}  // namespace

namespace {

/// Finds the charts that cannot be patches: whose loops cross all the same, as where a rough
/// surface folds between the samples that were looked at, or whose contours lead elsewhere than
/// those of their neighbours.
class ChartCheck {
 public:
  ChartCheck(const RegionBorders& borders, const RegionSurfaces& surfaces,
             const std::vector<ChainCurves>& curves)
      : borders_(borders), surfaces_(surfaces), curves_(curves) {}

  /// By region, 1 for such.
  std::vector<char> run() const {
    std::vector<char> is_bad(borders_.loops.size(), 0);
    share_indices(is_bad.size(), [&](std::size_t r) {
      const int region = static_cast<int>(r);
      if (surfaces_.is_chart(region)) is_bad[r] = crosses(region) || is_apart(region) ? 1 : 0;
    });
    return is_bad;
  }

 private:
  bool crosses(int region) const {
    std::vector<detail::NodeLoop> loops;
    for (const std::vector<ChainUse>& loop : borders_.loops[static_cast<std::size_t>(region)]) {
      detail::NodeLoop& nodes = loops.emplace_back();
      for (const ChainUse& use : loop) {
        const BorderChain& chain = borders_.chains[static_cast<std::size_t>(use.chain)];
        for (int i = 0; i < chain.edge_count(); ++i) {
          for (const double share : kCloseSamples) {
            nodes.push_back(at(use, (i + share) / chain.edge_count()));
          }
        }
      }
    }
    return !detail::crossing_segments(loops).empty();
  }

  /// True if the chart is not where the faces along its contours are.
  bool is_apart(int region) const {
    const Chart& chart = *surfaces_.chart(region);
    for (const std::vector<ChainUse>& loop : borders_.loops[static_cast<std::size_t>(region)]) {
      for (const ChainUse& use : loop) {
        const BorderChain& chain = borders_.chains[static_cast<std::size_t>(use.chain)];
        const BorderChain::Use& sides = chain.uses[static_cast<std::size_t>(use.use)];
        for (int i = 0; i < chain.edge_count(); ++i) {
          const FaceSide side = surfaces_.side(sides.sides[static_cast<std::size_t>(i)]);
          const Vec3 end = side.surface->evaluate(side.from, Order::Position).point;
          const Uv uv = chart.frame().project(end);
          const Vec3 gap = chart.evaluate(uv, Order::Position).point - end;
          if (!(gap.norm() <= kOff * chart.face_size())) return true;
        }
      }
    }
    return false;
  }

  Uv at(const ChainUse& entry, double t) const {
    const BorderChain& chain = borders_.chains[static_cast<std::size_t>(entry.chain)];
    const auto use = static_cast<std::size_t>(entry.use);
    const Curve& curve = *curves_[static_cast<std::size_t>(entry.chain)][use];
    return curve.evaluate(chain.uses[use].is_forward ? t : 1 - t);
  }

  const RegionBorders& borders_;
  const RegionSurfaces& surfaces_;
  const std::vector<ChainCurves>& curves_;
};

/// The regions, with the bad ones taken to pieces.
std::vector<FaceRegion> without(const std::vector<char>& is_bad, std::vector<FaceRegion> regions) {
  std::vector<FaceRegion> kept;
  for (std::size_t r = 0; r < regions.size(); ++r) {
    if (is_bad[r] == 0) {
      kept.push_back(std::move(regions[r]));
    } else {
      for (const int face : regions[r].faces) kept.push_back({{face}});
    }
  }
  std::sort(kept.begin(), kept.end(), [](const FaceRegion& a, const FaceRegion& b) {
    return a.faces.front() < b.faces.front();
  });
  return kept;
}

}  // namespace

RegionModel model_of_regions(const FaceNeighbours& neighbours, const Surfaces& surfaces,
                             std::vector<FaceRegion> regions) {
  for (;;) {
    const RegionBorders borders = find_borders(neighbours, regions);
    const RegionSurfaces region_surfaces(neighbours, surfaces, regions);
    const CurveMaker maker(region_surfaces);
    std::vector<ChainCurves> curves(borders.chains.size());
    share_indices(curves.size(),
                  [&](std::size_t c) { curves[c] = maker.curves_of(borders.chains[c]); });
    CrossingMender(borders, region_surfaces, maker, curves).run();
    const std::vector<char> is_bad = ChartCheck(borders, region_surfaces, curves).run();
    if (std::find(is_bad.begin(), is_bad.end(), 1) == is_bad.end()) {
      Model model =
          ModelMaker(neighbours, borders, region_surfaces, std::move(curves)).run(regions);
      return {std::move(model), std::move(regions)};
    }
    regions = without(is_bad, std::move(regions));
  }
}

}  // namespace surfmesh
