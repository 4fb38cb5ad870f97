// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/unused_sources.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "surfmesh/core/parallel.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/geometry/box_tree.hh"
#include "surfmesh/quality/face_corners.hh"
#include "surfmesh/quality/triangle_distance.hh"
#include "surfmesh/sizes/background_sizes.hh"
#include "surfmesh/sizes/source_place.hh"

namespace surfmesh::detail {
namespace {

using Box = BoxTree::Box;
using Triangle = std::array<Vec3, 3>;

/// The surface lies beside its triangles by no more than this share of their extent.
constexpr double kBulge = 0.1;

/// Points at which a curve is looked at.
constexpr int kCurvePoints = 64;

/// Places of a patch at which its fields are asked, about.
constexpr std::size_t kFieldPlaces = 200;

/// Lengths above this are those of a field that asks for none, but for the rounding of metrics.
constexpr double kNothing = 0.5 * kNoWish;

/// The text after the place of a source that nothing comes to.
constexpr const char* kEffect =
    "; it has no effect, or only where its size grows from there by the grade";

/// Places of sources, in space or in (u,v), and which of them a triangle comes to.
class Places {
 public:
  /// A source; its places follow.
  void add_source(std::string origin, std::string reason, std::vector<int> patches) {
    sources_.push_back({std::move(origin), std::move(reason), std::move(patches)});
  }

  void add_box(const Box& box) { add({box, Vec3::Zero(), -1}); }

  void add_ball(const Vec3& centre, double radius) {
    const Vec3 reach = Vec3::Constant(radius);
    add({Box(centre - reach, centre + reach), centre, radius});
  }

  void finish() {
    std::vector<Box> boxes;
    for (const Place& place : places_) boxes.push_back(place.box);
    tree_.emplace(std::move(boxes));
  }

  bool is_empty() const { return places_.empty(); }

  /// May be called by many threads at once.
  void meet(int patch, const Triangle& triangle) {
    Box box;
    for (const Vec3& corner : triangle) box.extend(corner);
    const double bulge = kBulge * box.diagonal().norm();
    box.min().array() -= bulge;
    box.max().array() += bulge;
    tree_->visit(box, [&](std::size_t i) {
      const Place& place = places_[i];
      Source& source = sources_[place.source];
      const std::atomic_ref<bool> is_met(source.is_met);
      if (is_met || !applies(source, patch)) return;
      if (place.radius < 0 ||
          triangle_distance(place.centre, triangle).distance <= place.radius + bulge) {
        is_met = true;
      }
    });
  }

  void tell(Notices& notices) const {
    for (const Source& source : sources_) {
      if (source.is_met) continue;
      notices.push_back(
          warning_at(source.origin, NoticeKind::UnusedSource, source.reason + kEffect));
      if (source.patches.size() == 1) notices.back().patch = source.patches.front();
    }
  }

 private:
  struct Source {
    std::string origin;
    std::string reason;
    std::vector<int> patches;  ///< empty for all
    bool is_met = false;
  };

  struct Place {
    Box box;
    Vec3 centre;
    double radius = -1;  ///< of a ball; negative for a box
    std::size_t source = 0;
  };

  void add(Place place) {
    place.source = sources_.size() - 1;
    places_.push_back(place);
  }

  static bool applies(const Source& source, int patch) {
    return source.patches.empty() ||
           std::find(source.patches.begin(), source.patches.end(), patch) != source.patches.end();
  }

  std::vector<Source> sources_;
  std::vector<Place> places_;
  std::optional<BoxTree> tree_;  ///< of the places, once all are known
};

/// How far a size near a place matters: as far as it holds and, if it is given at points, as far as
/// it grows up to hmax.
double reach_of(const LocalSize& wish, const ResolvedSizing& sizing) {
  const SizeBounds& bounds = sizing.bounds;
  double reach = bounds.radius(wish.radius);
  if (wish.outer) reach += bounds.radius(wish.outer->radius);
  if (reach > 0 || sizing.grade == 0) return reach;
  if (sizing.grade == 1) return std::numeric_limits<double>::infinity();
  const SizeLengths lengths = bounds.clamped(wish.size);
  return (bounds.hmax - std::min(lengths.along, lengths.across)) / std::log(sizing.grade);
}

void add_near(const NearSource& source, std::string origin, const ResolvedSizing& sizing,
              Places& places) {
  places.add_source(std::move(origin), "no patch comes near enough to this place for its size",
                    source.patches);
  const double reach = reach_of(source.wish, sizing);
  if (source.line.size() == 1) places.add_ball(source.line.front(), reach);
  for (std::size_t i = 1; i < source.line.size(); ++i) {
    const Vec3 &a = source.line[i - 1], &b = source.line[i];
    const Vec3 wide = Vec3::Constant(reach);
    places.add_box(Box(a.cwiseMin(b) - wide, a.cwiseMax(b) + wide));
  }
}

void add_inner(const BoxSource& source, std::string origin, const SizeBounds& bounds,
               Places& places) {
  places.add_source(std::move(origin), "no patch has a point in this box", source.patches);
  const double outer = source.wish.outer ? bounds.radius(source.wish.outer->radius) : 0;
  const Vec3 wide = Vec3::Constant(bounds.radius(source.wish.radius) + outer);
  places.add_box(Box(source.box.min() - wide, source.box.max() + wide));
}

Places places_in_space(const Sources& sources, const ResolvedSizing& sizing) {
  Places places;
  for (std::size_t i = 0; i < sources.near.size(); ++i) {
    add_near(sources.near[i], place_of(sources.near[i], "near", i), sizing, places);
  }
  for (std::size_t i = 0; i < sources.boxes.size(); ++i) {
    add_inner(sources.boxes[i], place_of(sources.boxes[i], "boxes", i), sizing.bounds, places);
  }
  places.finish();
  return places;
}

/// A point of the (u,v) of a patch: patches lie one above the other.
Vec3 plane_point(Uv uv, int patch) { return {uv.u, uv.v, static_cast<double>(patch)}; }

template <class Points>
Box plane_box_of(const Points& points, int patch) {
  Box box;
  for (const Uv uv : points) box.extend(plane_point(uv, patch));
  return box;
}

std::vector<Uv> points_of(const Curve& curve) {
  std::vector<Uv> points;
  for (int i = 0; i <= kCurvePoints; ++i) {
    points.push_back(curve.evaluate(static_cast<double>(i) / kCurvePoints));
  }
  return points;
}

Places places_in_domains(const Model& model, const Sources& sources) {
  Places places;
  const auto add = [&](const auto& source, const char* list, std::size_t i, const char* what) {
    places.add_source(place_of(source, list, i),
                      fmt::format("{} lies outside of the loops of patch {}", what,
                                  model.patch(source.patch).name),
                      {source.patch});
  };
  for (std::size_t i = 0; i < sources.at.size(); ++i) {
    const AtSource& source = sources.at[i];
    add(source, "at", i, "this point");
    places.add_box(plane_box_of(std::vector{source.at}, source.patch));
  }
  for (std::size_t i = 0; i < sources.along.size(); ++i) {
    const AlongSource& source = sources.along[i];
    add(source, "along", i, "this curve");
    for (const auto& curve : source.curves) {
      const std::vector<Uv> points = points_of(*curve);
      for (std::size_t k = 1; k < points.size(); ++k) {
        places.add_box(plane_box_of(std::vector{points[k - 1], points[k]}, source.patch));
      }
    }
  }
  for (std::size_t i = 0; i < sources.inside.size(); ++i) {
    add(sources.inside[i], "inside", i, "this polygon");
    places.add_box(plane_box_of(sources.inside[i].polygon, sources.inside[i].patch));
  }
  places.finish();
  return places;
}

/// Counts the places of patches at which fields ask for no size.
class FieldCover {
 public:
  FieldCover(const PolyMesh& mesh, const Model& model, const Sources& sources)
      : mesh_(mesh), model_(model), sources_(sources), fields_of_(model.patches.size()) {
    for (std::size_t i = 0; i < sources.fields.size(); ++i) {
      // Without bounds they are functions of users, which ask for a size everywhere.
      if (!sources.fields[i].has_bounds()) continue;
      fields_of_.at(static_cast<std::size_t>(sources.fields[i].patch)).push_back(i);
    }
  }

  void look() {
    const auto patch_of = require(mesh_, keys::face_patch);
    std::vector<std::size_t> faces(model_.patches.size(), 0);
    for (const auto face : mesh_.faces()) ++faces[index_of(mesh_.property(patch_of, face))];
    std::vector<std::size_t> seen(model_.patches.size(), 0);
    for (const auto face : mesh_.faces()) {
      const std::size_t patch = index_of(mesh_.property(patch_of, face));
      if (fields_of_[patch].empty()) continue;
      if (seen[patch]++ % (faces[patch] / kFieldPlaces + 1) == 0) ask(patch, face);
    }
  }

  void tell(Notices& notices) const {
    for (const auto& [origin, count] : counts_) {
      if (count.nothing == 0) continue;
      const double percent =
          100.0 * static_cast<double>(count.nothing) / static_cast<double>(count.asked);
      const std::string text =
          count.nothing == count.asked
              ? "its patches lie beyond the background mesh; it has no effect"
              : fmt::format(
                    "{:.1f} % of its patches lie beyond the background mesh; it has no "
                    "effect there",
                    percent);
      notices.push_back(warning_at(origin, NoticeKind::UnusedSource, text));
    }
  }

 private:
  struct Count {
    std::size_t asked = 0;
    std::size_t nothing = 0;
  };

  static std::size_t index_of(int patch) { return static_cast<std::size_t>(patch); }

  /// Ask the fields of a patch in the middle of a face.
  void ask(std::size_t patch, FaceHandle face) {
    const auto uv_of = require(mesh_, keys::corner_uv);
    Uv sum{0, 0};
    double corners = 0;
    for (const HalfedgeHandle corner : mesh_.fh_range(face)) {
      sum = sum + mesh_.property(uv_of, corner);
      ++corners;
    }
    const Surface& surface = *model_.patches[patch].surface;
    const Domain domain = surface.domain();
    const Uv uv = domain.fold(domain.clamp((1 / corners) * sum));
    const Jet jet = surface.evaluate(uv, Order::First);
    for (const std::size_t i : fields_of_[patch]) {
      Count& count = counts_[place_of(sources_.fields[i], "fields", i)];
      ++count.asked;
      if (asks_for_nothing(sources_.fields[i], uv, jet)) ++count.nothing;
    }
  }

  static bool asks_for_nothing(const FieldSource& field, Uv uv, const Jet& jet) {
    if (!field.metric) return field.size(uv, jet.point) > kNothing;
    return jet.du.squaredNorm() > kNothing * kNothing * field.metric(uv, jet.point).m11;
  }

  const PolyMesh& mesh_;
  const Model& model_;
  const Sources& sources_;
  std::vector<std::vector<std::size_t>> fields_of_;  ///< by patch, indices
  std::map<std::string, Count> counts_;              ///< by where the source is given
};

}  // namespace

Notices unused_sources(const PolyMesh& mesh, const Model& model, const Sources& sources,
                       const ResolvedSizing& sizing) {
  Places in_space = places_in_space(sources, sizing);
  Places in_domains = places_in_domains(model, sources);
  Notices notices;
  if (!sources.fields.empty()) {
    FieldCover cover(mesh, model, sources);
    cover.look();
    cover.tell(notices);
  }
  if (in_space.is_empty() && in_domains.is_empty()) return notices;
  const auto patch_of = require(mesh, keys::face_patch);
  const auto uv_of = require(mesh, keys::corner_uv);
  const auto meet = [&](FaceHandle face) {
    const int patch = mesh.property(patch_of, face);
    visit_triangles(corners_of(mesh, face), [&](const std::array<HalfedgeHandle, 3>& corners) {
      if (!in_space.is_empty()) in_space.meet(patch, points_of(mesh, corners));
      if (in_domains.is_empty()) return;
      Triangle in_domain;
      for (std::size_t k = 0; k < 3; ++k) {
        in_domain[k] = plane_point(mesh.property(uv_of, corners[k]), patch);
      }
      in_domains.meet(patch, in_domain);
    });
  };
  share_ranges(mesh.n_faces(), [&](std::size_t first, std::size_t end) {
    for (std::size_t f = first; f < end; ++f) meet(FaceHandle(static_cast<int>(f)));
  });
  in_space.tell(notices);
  in_domains.tell(notices);
  return notices;
}

}  // namespace surfmesh::detail
