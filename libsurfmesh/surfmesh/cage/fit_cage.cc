// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/fit_cage.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "surfmesh/cage/creases.hh"
#include "surfmesh/cage/interpolating_cage.hh"
#include "surfmesh/cage/limit_stencils.hh"
#include "surfmesh/cage/mesh_or_cage.hh"
#include "surfmesh/cage/mesh_turns.hh"
#include "surfmesh/cage/refine_cage.hh"
#include "surfmesh/cage/sharp_features.hh"
#include "surfmesh/cage/surface_waves.hh"
#include "surfmesh/core/counted.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/option_range.hh"

namespace surfmesh::detail {
namespace {

/// Distances of less than this share of the diagonal are rounding.
constexpr double kFitRounding = 1e-9;
/// Noise of vertices is up to about the roughness, a median; these multiples are tried as fits.
constexpr std::array kTriedFits = {1.0, 2.0, 4.0};
/// A fit that leaves less noise than this share of the limit for it is worth being named.
constexpr double kCalm = 0.5;

/// Triangles up to which nobody wonders that a cage is one.
constexpr std::size_t kFewTriangles = 150;

/// Times that vertices are passed by where the surface folds, before faces are kept flat there, and
/// times in all.
constexpr int kPassingRounds = 2;
constexpr int kMostFitRounds = 6;

std::string percent(double share) { return fmt::format("{:.2g}%", 100 * share); }

/// The faces that will have surfaces, as interpolation needs them.
Cage usable(const Cage& cage, Scheme scheme) {
  std::vector<int> numbers(cage.faces.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  return make_simple(cage, scheme, numbers).cage;
}

/// Makes a cage the one whose surface passes through its points.
class CageFitter {
 public:
  CageFitter(const CageOptions& options, Scheme scheme, const MeshTurns& turns, Cage& cage)
      : options_(options), scheme_(scheme), cage_(cage), turns_(turns) {}

  CageFit run() {
    fit_.noisy_share = turns_.noisy_share;
    tag();
    Cage mesh = usable(cage_, scheme_);
    const InterpolatingCage found = without_folds(mesh);
    record(found);
    tell_choice(found);
    if (found.is_least_squares) tell_distance(found);
    tell_passed_by(mesh, found);
    if (!flat_faces_.empty()) tell_flat();
    if (!waves_.folded_faces.empty()) tell_folds(mesh);
    tell_waves();
    if (fit_.fit == 0 && turns_.noisy_share > kNoisyShare) {
      tell_noise(mesh);
    } else if (fit_.fit == 0 && turns_.spikes > 0) {
      tell_spikes();
    }
    cage_.points = found.cage.points;
    return {fit_, std::move(notices_)};
  }

 private:
  /// The surface through the vertices, but for those beside which it would fold. Where it folds all
  /// the same, the faces stay as flat as they are.
  InterpolatingCage without_folds(Cage& mesh) {
    InterpolationOptions options{scheme_, options_.fit.value_or(Length())};
    InterpolatingCage found = interpolating_cage(mesh, options);
    waves_ = measure_waves(mesh, found.cage, scheme_);
    for (int round = 0; round < kMostFitRounds && !waves_.folded_faces.empty(); ++round) {
      if (round < kPassingRounds && options.fit.value == 0) {
        options.passed_by = passed_by_ = united(passed_by_, vertices_of(mesh, waves_.folded_faces));
      } else {
        flatten(waves_.folded_faces, mesh);
      }
      found = interpolating_cage(mesh, options);
      waves_ = measure_waves(mesh, found.cage, scheme_);
    }
    return found;
  }

  static std::vector<int> united(const std::vector<int>& a, const std::vector<int>& b) {
    std::vector<int> both;
    std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
    return both;
  }

  static std::vector<int> vertices_of(const Cage& mesh, const std::vector<int>& faces) {
    std::vector<int> vertices;
    for (const int f : faces) {
      const std::vector<int>& face = mesh.faces[static_cast<std::size_t>(f)];
      vertices.insert(vertices.end(), face.begin(), face.end());
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
  }

  /// Make corners of the vertices of faces, and creases of their sides.
  void flatten(const std::vector<int>& faces, Cage& mesh) {
    flat_faces_ = united(flat_faces_, faces);
    std::vector<std::vector<int>> outlines;
    for (const int f : faces) {
      outlines.push_back(mesh.faces[static_cast<std::size_t>(f)]);
      outlines.back().push_back(outlines.back().front());
    }
    for (Cage* cage : {&mesh, &cage_}) {
      for (const int vertex : vertices_of(mesh, faces)) cage->corners.push_back({vertex, kSharp});
      add_creases(outlines, kSharp, *cage);
    }
    if (outlines.empty()) return;
    flat_point_ = mesh.points[static_cast<std::size_t>(outlines.front().front())];
  }

  /// A warning at a place.
  void warn(NoticeKind kind, std::string text, const Vec3& point) {
    Notice notice = warning(kind, std::move(text));
    notice.point = point;
    notices_.push_back(std::move(notice));
  }

  const Vec3& point(int vertex) const { return cage_.points[static_cast<std::size_t>(vertex)]; }

  /// "vertex 7 at (1, 2, 3)".
  std::string place_text(int vertex) const {
    return fmt::format("vertex {} at {}", vertex, point_text(point(vertex)));
  }

  void tell_flat() {
    warn(NoticeKind::MissedPoints,
         fmt::format("the surface over {} would fold and is flat instead, one of them at {}; "
                     "smaller faces there help, or a {}",
                     counted(flat_faces_.size(), "face", "faces"), point_text(flat_point_),
                     ranges::kCreaseAngle.name),
         flat_point_);
  }

  /// Folds that all of this has left.
  void tell_folds(const Cage& mesh) {
    const std::vector<int>& faces = waves_.folded_faces;
    const Vec3& place = point(mesh.faces[static_cast<std::size_t>(faces.front())].front());
    warn(NoticeKind::WavySurface,
         fmt::format("the surface still folds over {}, one of them at {}; smaller faces there "
                     "help, or a {}",
                     counted(faces.size(), "face", "faces"), point_text(place),
                     ranges::kCreaseAngle.name),
         place);
  }

  /// Corners of flat faces are not missed.
  void tell_passed_by(const Cage& mesh, const InterpolatingCage& found) {
    const std::vector<int> corners = vertices_of(mesh, flat_faces_);
    std::vector<int> missed;
    std::set_difference(passed_by_.begin(), passed_by_.end(), corners.begin(), corners.end(),
                        std::back_inserter(missed));
    if (missed.empty()) return;
    const int first = missed.front();
    warn(NoticeKind::MissedPoints,
         fmt::format("the surface misses {} by up to {:.3g}, beside which it would fold; the first "
                     "is {}; smaller faces there help, or a {}",
                     counted(missed.size(), "vertex", "vertices"), found.distance,
                     place_text(first), ranges::kCreaseAngle.name),
         point(first));
  }

  void tag() {
    const SharpFeatures features = tag_features(options_.crease_angle, cage_);
    fit_.creases = features.creases;
    fit_.corners = features.corners;
  }

  void record(const InterpolatingCage& found) {
    fit_.vertices = found.vertices;
    fit_.fit = options_.fit.value_or(Length()).in_units(diagonal(cage_));
    fit_.distance = found.distance;
    fit_.mean_distance = found.mean_distance;
    fit_.greatest_move = found.greatest_move;
    fit_.moved_vertex = found.moved_vertex;
  }

  void tell_choice(const InterpolatingCage& found) {
    const bool is_chosen = options_.surface == SurfaceKind::Auto;
    const bool has_default_creases = !options_.crease_angle && fit_.creases + fit_.corners > 0;
    if (!is_chosen && !has_default_creases) return;
    std::string text = is_chosen ? reason() + "; " : std::string();
    text += nearness_text(found);
    if (has_default_creases) text += creases_text();
    notices_.push_back(information(NoticeKind::ChosenSurface, std::move(text)));
  }

  std::string reason() const {
    if (fit_.fit > 0) return "taken for a mesh of a surface, as a fit is requested";
    return fmt::format(
        "taken for a mesh of a surface, not for a control cage: {} faces without tags of "
        "subdivision, at half of whose edges they meet at less than {}° (with {} = limit it would "
        "be a cage)",
        cage_.faces.size(), smooth_turn(scheme_), ranges::kSurface.name);
  }

  /// How the surface relates to the vertices: through them, unless it misses some.
  std::string nearness_text(const InterpolatingCage& found) const {
    if (fit_.fit > 0 && !found.is_least_squares) {
      return fmt::format("the surface stays within {:.3g} of the vertices", fit_.fit);
    }
    if (found.distance <= kFitRounding * diagonal(cage_)) {
      return "the surface passes through the vertices";
    }
    return fmt::format("the surface misses the vertices by up to {:.3g}", found.distance);
  }

  std::string creases_text() const {
    std::string text = "; ";
    if (fit_.creases > 0) {
      text += fmt::format("{} of more than {}° became sharp creases",
                          counted(fit_.creases, "edge", "edges"), kFeatureAngle);
    }
    if (fit_.creases > 0 && fit_.corners > 0) text += ", and ";
    if (fit_.corners > 0) {
      text += fmt::format("{} where creases or borders turn became sharp corners",
                          counted(fit_.corners, "vertex", "vertices"));
    }
    return text + fmt::format(" ({} decides on creases)", ranges::kCreaseAngle.name);
  }

  void tell_distance(const InterpolatingCage& found) {
    if (fit_.distance <= std::max(fit_.fit, kFitRounding * diagonal(cage_))) return;
    std::string text = found.has_stopped
                           ? "no surface through all vertices was found before the search ended"
                           : "no surface of these faces passes through all vertices";
    text += fmt::format("; this one misses them by up to {:.3g}, at {}, and by {:.3g} on average",
                        found.distance, place_text(found.farthest_vertex), found.mean_distance);
    if (!found.has_stopped && scheme_ != Scheme::Loop) text += "; triangles in place of quads help";
    warn(NoticeKind::MissedPoints, std::move(text), point(found.farthest_vertex));
  }

  void tell_waves() {
    const SurfaceWaves& waves = waves_;
    if (waves.edges > 0) {
      fit_.wavy_share = static_cast<double>(waves.waves) / static_cast<double>(waves.edges);
    }
    fit_.greatest_wave = waves.greatest;
    if (waves.waves == 0) return;
    warn(
        NoticeKind::WavySurface,
        fmt::format("the surface turns more than the faces of the mesh at {} of {} edges, most, by "
                    "{:.3g}°, at {}; beside sharp edges a {} helps, elsewhere a {}",
                    waves.waves, waves.edges, waves.greatest, point_text(waves.point),
                    ranges::kCreaseAngle.name, ranges::kFit.name),
        waves.point);
  }

  void tell_spikes() {
    warn(NoticeKind::WavySurface,
         fmt::format("{} out of the surrounding mesh, and so does the surface; the worst, {}, by "
                     "{:.2g} of the length of its edges; a {} flattens such places",
                     counted(turns_.spikes, "vertex sticks", "vertices stick"),
                     place_text(turns_.spike), turns_.spike_height, ranges::kFit.name),
         point(turns_.spike));
  }

  /// The noise that is left in the surface with a fit.
  double noise_with(const Cage& mesh, double fit) const {
    Cage smooth = mesh;
    const Cage found = interpolating_cage(mesh, {scheme_, Length::units(fit)}).cage;
    smooth.points = limit_points(found, scheme_);
    return measure_turns(smooth).noisy_share;
  }

  /// Suggest the smallest tried fit that removes most noise, in words; empty if there is none.
  std::string advice(const Cage& mesh) const {
    const double noise = turns_.roughness * turns_.length;
    for (const double factor : kTriedFits) {
      const double fit = factor * noise;
      const double left = noise_with(mesh, fit);
      if (left > kCalm * kNoisyShare) continue;
      return fmt::format(": {} = {:.2g} leaves {}", ranges::kFit.name, fit, percent(left));
    }
    return "";
  }

  void tell_noise(const Cage& mesh) {
    notices_.push_back(warning(
        NoticeKind::NoisyInput,
        fmt::format("the mesh is noisy: it zigzags by more than {}° at {} of its inner vertices, "
                    "and so does the surface through them; a {} removes noise{}, and so does "
                    "smoothing beforehand",
                    kNoisyAngle, percent(turns_.noisy_share), ranges::kFit.name, advice(mesh))));
  }

  const CageOptions& options_;
  Scheme scheme_;
  Cage& cage_;
  MeshTurns turns_;
  SurfaceFit fit_;
  std::vector<int> passed_by_;   ///< vertices, ascending
  std::vector<int> flat_faces_;  ///< of the usable ones, ascending
  Vec3 flat_point_ = Vec3::Zero();
  SurfaceWaves waves_;
  Notices notices_;
};

bool has_fit(const CageOptions& options) { return options.fit && options.fit->value != 0; }

bool is_asked_for(const CageOptions& options) {
  return options.surface == SurfaceKind::Interpolate ||
         (options.surface == SurfaceKind::Auto && has_fit(options));
}

/// True if a cage may be a mesh, which its turns decide.
bool is_in_doubt(const CageOptions& options, Scheme scheme, const Cage& cage) {
  return options.surface == SurfaceKind::Auto && !has_tags(cage) && is_fine(cage, scheme);
}

/// True for triangles that are not few, though they are no fine mesh: cages of triangles are rare,
/// and nobody has named their scheme.
bool may_be_meant_as_mesh(const CageOptions& options, Scheme scheme, const Cage& cage) {
  return options.surface == SurfaceKind::Auto && options.scheme == Scheme::Auto &&
         scheme == Scheme::Loop && !has_tags(cage) && cage.faces.size() >= kFewTriangles;
}

}  // namespace

CageFit fit_cage(const CageOptions& options, Scheme scheme, Cage& cage) {
  check_option(ranges::kSurface, options.surface);
  check_option(ranges::kCreaseAngle, options.crease_angle.value_or(0));
  if (has_fit(options)) check_option(ranges::kFit, options.fit);
  if (is_asked_for(options) || is_in_doubt(options, scheme, cage)) {
    const MeshTurns turns = measure_turns(cage);
    if (is_asked_for(options) || is_mesh_of_surface(cage, scheme, turns)) {
      return CageFitter(options, scheme, turns, cage).run();
    }
  }
  if (options.crease_angle.value_or(0) > 0) add_creases(*options.crease_angle, cage);
  CageFit result;
  if (may_be_meant_as_mesh(options, scheme, cage)) {
    result.notices.push_back(information(
        NoticeKind::ChosenSurface,
        fmt::format("taken for a control cage: the surface is the limit surface of its {} "
                    "triangles, which shrinks from the vertices (with {} = interpolate it would "
                    "pass through them)",
                    cage.faces.size(), ranges::kSurface.name)));
  }
  if (has_fit(options)) {
    result.notices.push_back(
        warning(NoticeKind::UnusedOption,
                fmt::format("{} = {} has no effect on a limit surface; it is for {} = interpolate",
                            ranges::kFit.name, to_text(options.fit), ranges::kSurface.name)));
  }
  return result;
}

}  // namespace surfmesh::detail
