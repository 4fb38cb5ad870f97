// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/limit_surface.hh"

#include <fmt/format.h>
#include <opensubdiv/bfr/refinerSurfaceFactory.h>
#include <opensubdiv/sdc/crease.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "surfmesh/cage/bicubic_parts.hh"
#include "surfmesh/cage/bicubic_patch.hh"
#include "surfmesh/cage/face_evaluator.hh"
#include "surfmesh/cage/subdivision.hh"
#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

namespace Bfr = OpenSubdiv::Bfr;
namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

using BfrSurface = Bfr::Surface<double>;

/// Parameter step that tells the sign of a second derivative: small beside the distance to a
/// singular corner (2^-9 and more), large beside the rounding of first derivatives.
constexpr double kSignStep = 1.0 / 16384;

/// Nearer to a corner, rounding leaves no direction from it.
constexpr double kNoDirection = 1e-100;

/// Faces around a vertex from which on they share one refinement: each by itself takes time with
/// the square of their number. Below it, faces alone take less memory and evaluate faster.
constexpr int kSharedRefinement = 32;

/// A semi-sharp crease of this sharpness and more counts as an edge for sizes: its rounding, about
/// 2^(1 - sharpness) of a face wide, would ask for elements far smaller than the faces beside it.
constexpr double kCreaseSharpness = 4;

/// A side of the domain along which the surface is a narrowly rounded edge: a semi-sharp crease.
struct RoundedSide {
  int side = 0;  ///< from corner `side` of the domain to the next
  /// Share of the domain's width or height within which the curvature is that of the rounding.
  double reach = 0;
};

/// What the cage tells of a face's limit surface.
struct LimitTraits {
  Domain domain;
  bool is_regular = true;  ///< one polynomial
  std::vector<SingularPoint> singular_points = {};
  std::vector<RoundedSide> rounded_sides = {};
  bool has_parts = false;  ///< look for its bicubic pieces
  FaceOfCage face = {};
};

/// The limit surface over one face, with what makes it a surface for meshing.
class LimitSurface : public CageSurface {
 public:
  LimitSurface(std::unique_ptr<const FaceEvaluator> evaluator, const LimitTraits& traits)
      : evaluator_(std::move(evaluator)),
        domain_(traits.domain),
        is_sign_in_doubt_(traits.domain.shape == Domain::Shape::Triangle && !traits.is_regular),
        singular_points_(traits.singular_points),
        rounded_sides_(traits.rounded_sides),
        face_(traits.face) {
    if (!traits.has_parts) return;
    parts_.emplace([this](Uv uv, Order order) { return evaluator_->evaluate(uv, order); });
  }

  Jet evaluate(Uv uv, Order order) const override {
    Jet jet;
    if (std::isfinite(uv.u) && std::isfinite(uv.v)) {
      const Uv in_face = inside(uv);
      if (const auto* part = parts_ ? parts_->find(in_face) : nullptr) {
        return part->evaluate(in_face, order);
      }
      jet = evaluate_unchecked(in_face, order);
    }
    if (!is_finite(jet, order)) {
      throw Error(ErrorCode::Geometry,
                  fmt::format("the limit surface is not finite at ({}, {})", uv.u, uv.v));
    }
    return jet;
  }

  CagePlace place(Uv uv) const override { return place_on(face_, uv); }

  Domain domain() const override { return domain_; }

  std::vector<SingularPoint> singular_points() const override { return singular_points_; }

  /// Points in a rounding move towards the far corner of the domain.
  Uv beside_roundings(Uv uv) const override {
    for (const RoundedSide& rounded : rounded_sides_) {
      const Uv a = domain_.corner(rounded.side);
      const Uv b = domain_.corner((rounded.side + 1) % domain_.corner_count());
      // The step that leads from the side to the far end of the domain.
      const Uv opposite = domain_.corner((rounded.side + 2) % domain_.corner_count());
      const double distance = cross(b - a, uv - a) / cross(b - a, opposite - a);
      if (distance >= rounded.reach) continue;
      uv = lerp(uv, opposite, (rounded.reach - distance) / (1 - distance));
    }
    return uv;
  }

 private:
  /// Bfr looks for the sub-patch of a point and does not say what it does outside of the face.
  static Uv inside(Uv uv) { return {std::clamp(uv.u, 0.0, 1.0), std::clamp(uv.v, 0.0, 1.0)}; }

  static bool is_finite(const Jet& jet, Order order) {
    double sum = jet.point.sum();
    if (order >= Order::First) sum += jet.du.sum() + jet.dv.sum();
    if (order >= Order::Second) sum += jet.duu.sum() + jet.duv.sum() + jet.dvv.sum();
    return std::isfinite(sum);
  }

  Jet evaluate_unchecked(Uv uv, Order order) const {
    if (order == Order::Position) return evaluator_->evaluate(uv, order);
    const Uv usable = outside_of_reach(uv);
    Jet jet = evaluator_->evaluate(usable, order);
    if (order == Order::Second && is_sign_in_doubt_) correct_sign(usable, jet);
    if (!(usable == uv)) jet.point = evaluator_->evaluate(uv, Order::Position).point;
    return jet;
  }

  /// The point itself, or the nearest one in the same direction from a singular corner at which
  /// derivatives are those of the surface.
  Uv outside_of_reach(Uv uv) const {
    for (const SingularPoint& singular : singular_points_) {
      Uv step = uv - singular.at;
      if (step.u * step.u + step.v * step.v >= singular.reach * singular.reach) continue;
      double length = std::hypot(step.u, step.v);
      if (length < kNoDirection) {
        step = {singular.at.u > 0 ? -1.0 : 1.0, singular.at.v > 0 ? -1.0 : 1.0};
        if (domain_.shape == Domain::Shape::Triangle) step = to_middle_of_triangle(singular.at);
        length = std::hypot(step.u, step.v);
      }
      return inside(singular.at + singular.reach / length * step);
    }
    return uv;
  }

  static Uv to_middle_of_triangle(Uv corner) { return Uv{1.0 / 3, 1.0 / 3} - corner; }

  /// Turn second derivatives that have the wrong sign.
  ///
  /// Bfr 3.5.0 splits an irregular triangle into smaller ones, and where such a one is turned by
  /// 180 degrees gives all second derivatives with the opposite sign. It does not tell where; so
  /// a difference of first derivatives decides, in the direction in which they change most. Next
  /// to zeros of the second derivatives it may decide wrongly, where they are below
  /// kSignStep times the third ones.
  void correct_sign(Uv uv, Jet& jet) const {
    const double along_u = jet.duu.squaredNorm() + jet.duv.squaredNorm();
    const double along_v = jet.duv.squaredNorm() + jet.dvv.squaredNorm();
    const bool is_along_u = along_u >= along_v;
    const double h = (is_along_u ? uv.u : uv.v) >= kSignStep ? -kSignStep : kSignStep;
    const Jet other = evaluator_->evaluate(uv + (is_along_u ? Uv{h, 0} : Uv{0, h}), Order::First);
    const double agreement = (other.du - jet.du).dot(is_along_u ? jet.duu : jet.duv) +
                             (other.dv - jet.dv).dot(is_along_u ? jet.duv : jet.dvv);
    if (agreement * h >= 0) return;
    jet.duu = -jet.duu;
    jet.duv = -jet.duv;
    jet.dvv = -jet.dvv;
  }

  std::unique_ptr<const FaceEvaluator> evaluator_;
  Domain domain_;
  bool is_sign_in_doubt_;
  std::vector<SingularPoint> singular_points_;
  std::vector<RoundedSide> rounded_sides_;
  FaceOfCage face_;
  std::optional<detail::BicubicParts> parts_;
};

/// Tells the corners of faces at which a limit surface is not one polynomial.
class CornerClassifier {
 public:
  CornerClassifier(const Far::TopologyLevel& level, Sdc::SchemeType scheme)
      : level_(level), scheme_(scheme) {}

  bool is_singular(int face, int corner) const {
    if (scheme_ == Sdc::SCHEME_BILINEAR) return false;
    const int vertex = level_.GetFaceVertices(face)[corner];
    if (has_semi_sharp(vertex)) return true;
    const bool is_sharp = Sdc::Crease::IsInfinite(level_.GetVertexSharpness(vertex));
    const int cuts = cut_count(vertex);
    const Sector sector = sector_at(face, corner);
    if (sector.is_whole) return is_sharp || cuts > 0 || sector.faces != regular_valence();
    if (is_sharp || cuts > 2) return sector.faces != 1;
    return cuts != 2 || sector.faces != regular_valence() / 2;
  }

 private:
  /// Faces around a vertex that can be reached from one of them without crossing a sharp edge.
  struct Sector {
    int faces = 1;
    bool is_whole = false;  ///< no sharp edge was met on the way around
  };

  int regular_valence() const { return scheme_ == Sdc::SCHEME_LOOP ? 6 : 4; }

  /// True for edges across which the two faces do not see each other: also true boundaries.
  bool is_cut(int edge) const {
    return Sdc::Crease::IsInfinite(level_.GetEdgeSharpness(edge)) ||
           level_.GetEdgeFaces(edge).size() != 2;
  }

  int cut_count(int vertex) const {
    const Far::ConstIndexArray edges = level_.GetVertexEdges(vertex);
    return static_cast<int>(
        std::count_if(edges.begin(), edges.end(), [this](int edge) { return is_cut(edge); }));
  }

  bool has_semi_sharp(int vertex) const {
    const Far::ConstIndexArray edges = level_.GetVertexEdges(vertex);
    return Sdc::Crease::IsSemiSharp(level_.GetVertexSharpness(vertex)) ||
           std::any_of(edges.begin(), edges.end(), [this](int edge) {
             return Sdc::Crease::IsSemiSharp(level_.GetEdgeSharpness(edge));
           });
  }

  /// The two edges of a face at one of its corners: of the side before and of the side after it.
  std::array<int, 2> edges_at(int face, int corner) const {
    const Far::ConstIndexArray edges = level_.GetFaceEdges(face);
    return {edges[corner == 0 ? edges.size() - 1 : corner - 1], edges[corner]};
  }

  Sector sector_at(int face, int corner) const {
    Sector sector;
    const int vertex = level_.GetFaceVertices(face)[corner];
    // A face that passes the vertex twice could lead in a circle that leaves it out.
    const int face_count = level_.GetVertexFaces(vertex).size();
    for (int edge : edges_at(face, corner)) {
      int current = face;
      while (!is_cut(edge) && sector.faces <= face_count) {
        const Far::ConstIndexArray faces = level_.GetEdgeFaces(edge);
        current = faces[0] == current ? faces[1] : faces[0];
        if (current == face) return {sector.faces, true};
        ++sector.faces;
        const auto [before, after] =
            edges_at(current, level_.GetFaceVertices(current).FindIndex(vertex));
        edge = edge == before ? after : before;
      }
    }
    return sector;
  }

  const Far::TopologyLevel& level_;
  Sdc::SchemeType scheme_;
};

/// Makes the surfaces of one cage, in one thread: the factory keeps a cache.
class SurfaceMaker {
 public:
  SurfaceMaker(const Far::TopologyRefiner& refiner, const std::vector<Vec3>& points,
               const LimitSurfaceOptions& options, const std::vector<FaceOfCage>& faces)
      : refiner_(refiner),
        points_(points),
        options_(options),
        faces_(faces),
        level_(refiner.GetLevel(0)),
        scheme_(refiner.GetSchemeType()),
        shared_vertices_(shared_vertices(level_, scheme_)),
        factory_(refiner, factory_options(level_, options)) {}

  /// The surfaces of all faces, null for those that have none.
  std::vector<std::shared_ptr<const Surface>> make_all() const {
    const int count = level_.GetNumFaces();
    std::vector<std::shared_ptr<const Surface>> surfaces(static_cast<std::size_t>(count));
    std::vector<int> shared;
    for (int face = 0; face < count; ++face) {
      if (!factory_.FaceHasLimitSurface(face)) continue;
      check_size(face);
      if (is_shared(face)) {
        shared.push_back(face);
      } else {
        surfaces[static_cast<std::size_t>(face)] = make_alone(face);
      }
    }
    auto evaluators =
        make_shared_evaluators(refiner_, points_, shared, options_.approximation_level);
    for (std::size_t i = 0; i < shared.size(); ++i) {
      surfaces[static_cast<std::size_t>(shared[i])] =
          make_irregular(shared[i], std::move(evaluators[i]));
    }
    return surfaces;
  }

 private:
  static Bfr::SurfaceFactory::Options factory_options(const Far::TopologyLevel& level,
                                                      const LimitSurfaceOptions& options) {
    Bfr::SurfaceFactory::Options result;
    result.SetApproxLevelSmooth(options.approximation_level);
    result.SetApproxLevelSharp(options.approximation_level);
    // Bfr 3.5.0 overwrites memory at fans of two faces when patches are shared through its cache.
    result.EnableCaching(!has_fan_of_two(level));
    return result;
  }

  static bool has_fan_of_two(const Far::TopologyLevel& level) {
    for (int v = 0; v < level.GetNumVertices(); ++v) {
      if (has_fan_of_two(level, v)) return true;
    }
    return false;
  }

  void check_size(int face) const {
    const int size = level_.GetFaceVertices(face).size();
    if (size == domain().corner_count()) return;
    throw Error(ErrorCode::InvalidInput,
                fmt::format("face {} has {} vertices: refine the cage once before taking limit "
                            "surfaces of its faces",
                            face, size));
  }

  Domain domain() const {
    Domain result;
    if (scheme_ == Sdc::SCHEME_LOOP) result.shape = Domain::Shape::Triangle;
    return result;
  }

  /// True if two faces share two edges of a vertex: a closed fan, even if the vertex has other
  /// faces, as only non-manifold ones do. Also true, without looking, if an edge has more than
  /// kMostFacesOfEdge faces: comparing pairs would take too long.
  static bool has_fan_of_two(const Far::TopologyLevel& level, int vertex) {
    constexpr int kMostFacesOfEdge = 8;
    if (!level.IsVertexNonManifold(vertex)) {
      return level.GetVertexFaces(vertex).size() == 2 && level.GetVertexEdges(vertex).size() == 2;
    }
    std::vector<std::pair<int, int>> neighbours;
    for (const int edge : level.GetVertexEdges(vertex)) {
      const Far::ConstIndexArray faces = level.GetEdgeFaces(edge);
      if (faces.size() > kMostFacesOfEdge) return true;
      for (int i = 0; i < faces.size(); ++i) {
        for (int j = 0; j < i; ++j) neighbours.push_back(std::minmax(faces[i], faces[j]));
      }
    }
    std::sort(neighbours.begin(), neighbours.end());
    return std::adjacent_find(neighbours.begin(), neighbours.end()) != neighbours.end();
  }

  /// Mark the vertices whose faces share a refinement: of wide fans, and around fans of two faces.
  /// There Bfr 3.5.0 reads memory out of bounds if there are tags.
  static std::vector<char> shared_vertices(const Far::TopologyLevel& level,
                                           Sdc::SchemeType scheme) {
    std::vector<char> is_shared(static_cast<std::size_t>(level.GetNumVertices()), 0);
    if (scheme == Sdc::SCHEME_BILINEAR) return is_shared;
    for (int v = 0; v < level.GetNumVertices(); ++v) {
      const Far::ConstIndexArray faces = level.GetVertexFaces(v);
      if (faces.size() >= kSharedRefinement) is_shared[static_cast<std::size_t>(v)] = 1;
      if (!has_fan_of_two(level, v)) continue;
      for (const int face : faces) {
        for (const int w : level.GetFaceVertices(face)) is_shared[static_cast<std::size_t>(w)] = 1;
      }
    }
    return is_shared;
  }

  bool is_shared(int face) const {
    const Far::ConstIndexArray vertices = level_.GetFaceVertices(face);
    return std::any_of(vertices.begin(), vertices.end(), [this](int vertex) {
      return shared_vertices_[static_cast<std::size_t>(vertex)] != 0;
    });
  }

  std::shared_ptr<const Surface> make_alone(int face) const {
    BfrSurface surface;
    if (!factory_.InitVertexSurface(face, &surface)) return nullptr;
    auto evaluator = make_bfr_evaluator(surface, points_);
    if (!surface.IsRegular()) return make_irregular(face, std::move(evaluator));
    if (scheme_ == Sdc::SCHEME_CATMARK && options_.is_regular_by_hand) {
      return as_bicubic(LimitSurface(std::move(evaluator), {.domain = domain()}), of_cage(face));
    }
    return std::make_shared<LimitSurface>(
        std::move(evaluator),
        LimitTraits{
            .domain = domain(), .rounded_sides = rounded_sides(face), .face = of_cage(face)});
  }

  std::shared_ptr<const Surface> make_irregular(
      int face, std::unique_ptr<const FaceEvaluator> evaluator) const {
    const bool has_parts = scheme_ == Sdc::SCHEME_CATMARK && options_.is_regular_by_hand;
    return std::make_shared<LimitSurface>(std::move(evaluator),
                                          LimitTraits{.domain = domain(),
                                                      .is_regular = false,
                                                      .singular_points = singular_points(face),
                                                      .rounded_sides = rounded_sides(face),
                                                      .has_parts = has_parts,
                                                      .face = of_cage(face)});
  }

  FaceOfCage of_cage(int face) const {
    if (!faces_.empty()) return faces_[static_cast<std::size_t>(face)];
    return {.face = face, .corners = level_.GetFaceVertices(face).size()};
  }

  static std::shared_ptr<const Surface> as_bicubic(const LimitSurface& surface,
                                                   const FaceOfCage& face) {
    std::array<Jet, 4> corners;
    for (int i = 0; i < 4; ++i) {
      corners[static_cast<std::size_t>(i)] =
          surface.evaluate(surface.domain().corner(i), Order::Second);
    }
    return make_bicubic_patch(corners, face);
  }

  std::vector<SingularPoint> singular_points(int face) const {
    const Domain domain = this->domain();
    const CornerClassifier classifier(level_, scheme_);
    const double reach = std::ldexp(1.0, 1 - options_.approximation_level);
    std::vector<SingularPoint> result;
    for (int i = 0; i < domain.corner_count(); ++i) {
      if (classifier.is_singular(face, i)) result.push_back({domain.corner(i), reach});
    }
    return result;
  }

  std::vector<RoundedSide> rounded_sides(int face) const {
    std::vector<RoundedSide> result;
    const Far::ConstIndexArray edges = level_.GetFaceEdges(face);
    for (int i = 0; i < edges.size(); ++i) {
      const double sharpness = level_.GetEdgeSharpness(edges[i]);
      if (sharpness < kCreaseSharpness || level_.GetEdgeFaces(edges[i]).size() != 2 ||
          Sdc::Crease::IsInfinite(static_cast<float>(sharpness))) {
        continue;
      }
      result.push_back({i, std::exp2(1 - sharpness)});
    }
    return result;
  }

  const Far::TopologyRefiner& refiner_;
  const std::vector<Vec3>& points_;
  LimitSurfaceOptions options_;
  const std::vector<FaceOfCage>& faces_;  ///< empty if they are those of the level
  Far::TopologyLevel level_;
  Sdc::SchemeType scheme_;
  std::vector<char> shared_vertices_;  ///< by vertex: its faces share a refinement
  Bfr::RefinerSurfaceFactory<> factory_;
};

}  // namespace

std::vector<std::shared_ptr<const Surface>> make_limit_surfaces(
    const Far::TopologyRefiner& refiner, const std::vector<Vec3>& points,
    const LimitSurfaceOptions& options, const std::vector<FaceOfCage>& faces) {
  if (options.approximation_level < 1 || options.approximation_level > 10) {
    throw Error(ErrorCode::InvalidOption, fmt::format("approximation level {} is not in 1 to 10",
                                                      options.approximation_level));
  }
  return SurfaceMaker(refiner, points, options, faces).make_all();
}

std::vector<std::shared_ptr<const Surface>> make_limit_surfaces(const Cage& cage, Scheme scheme,
                                                                int approximation_level) {
  const CageTopology topology = make_topology(cage, resolve_scheme(cage, scheme));
  return make_limit_surfaces(*topology.refiner, cage.points, {approximation_level, true});
}

}  // namespace surfmesh
