// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/cage_model.hh"

#include <fmt/format.h>
#include <opensubdiv/sdc/crease.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/geometry/refine_cage.hh"
#include "surfmesh/geometry/subdivision_detail.hh"

namespace surfmesh {
namespace {

namespace Far = OpenSubdiv::Far;

/// The uses of a contour are the same points up to rounding: this share of the diagonal.
constexpr double kContourGap = 1e-9;

/// Builds the model of a cage of regular face sizes, face by face.
class ModelBuilder {
 public:
  ModelBuilder(const Far::TopologyLevel& level, Scheme scheme)
      : level_(level),
        scheme_(scheme),
        vertex_of_(static_cast<std::size_t>(level.GetNumVertices()), -1),
        contour_of_(static_cast<std::size_t>(level.GetNumEdges()), -1) {}

  void add_patch(int face, std::string name, int cage_face,
                 std::shared_ptr<const Surface> surface) {
    const int patch_index = static_cast<int>(model.patches.size());
    Patch patch;
    patch.name = std::move(name);
    patch.surface = std::move(surface);
    patch.cage_face = cage_face;
    const Domain domain = patch.surface->domain();
    const Far::ConstIndexArray vertices = level_.GetFaceVertices(face);
    for (int i = 0; i < vertices.size(); ++i) {
      add_vertex(vertices[i], *patch.surface, domain.corner(i));
    }
    PatchLoop loop;
    for (int i = 0; i < vertices.size(); ++i) {
      const int next = (i + 1) % vertices.size();
      const Side side = {vertices[i], vertices[next], domain.corner(i), domain.corner(next)};
      loop.push_back(add_use(level_.GetFaceEdges(face)[i], side, patch_index));
    }
    patch.loops.push_back(std::move(loop));
    model.patches.push_back(std::move(patch));
  }

  /// A contour that in the end has one use only is a true boundary, unless it is a point.
  void finish() {
    for (Contour& contour : model.contours) {
      contour.is_degenerate = contour.start == contour.end;
      if (contour.uses.size() == 1) contour.is_smooth = false;
    }
  }

  Model model;

 private:
  /// A side of a face, counter-clockwise: its vertices and its ends in the face's domain.
  struct Side {
    int from = -1;
    int to = -1;
    Uv from_uv;
    Uv to_uv;
  };

  void add_vertex(int vertex, const Surface& surface, Uv corner) {
    int& index = vertex_of_[static_cast<std::size_t>(vertex)];
    if (index >= 0) return;
    index = static_cast<int>(model.vertices.size());
    model.vertices.push_back({surface.evaluate(corner, Order::Position).point});
  }

  LoopEntry add_use(int edge, const Side& side, int patch) {
    const int from = vertex_of_[static_cast<std::size_t>(side.from)];
    int& index = contour_of_[static_cast<std::size_t>(edge)];
    if (index < 0) {
      index = static_cast<int>(model.contours.size());
      Contour contour;
      contour.name = fmt::format("e{}-{}", side.from, side.to);
      contour.start = from;
      contour.end = vertex_of_[static_cast<std::size_t>(side.to)];
      contour.is_smooth = scheme_ != Scheme::Bilinear &&
                          !OpenSubdiv::Sdc::Crease::IsInfinite(level_.GetEdgeSharpness(edge));
      model.contours.push_back(std::move(contour));
    }
    Contour& contour = model.contours[static_cast<std::size_t>(index)];
    ContourUse use;
    use.patch = patch;
    use.is_forward = contour.start == from;
    use.curve = use.is_forward ? std::make_shared<SegmentCurve>(side.from_uv, side.to_uv)
                               : std::make_shared<SegmentCurve>(side.to_uv, side.from_uv);
    contour.uses.push_back(std::move(use));
    return {index, static_cast<int>(contour.uses.size()) - 1};
  }

  const Far::TopologyLevel& level_;
  Scheme scheme_;
  std::vector<int> vertex_of_;   ///< model vertex of a cage vertex, -1 if it has none
  std::vector<int> contour_of_;  ///< contour of an edge, -1 if it has none
};

void add_groups(const Cage& cage, Model& model) {
  std::vector<std::vector<int>> patches_of(cage.faces.size());
  for (std::size_t p = 0; p < model.patches.size(); ++p) {
    patches_of[static_cast<std::size_t>(model.patches[p].cage_face)].push_back(static_cast<int>(p));
  }
  for (const Cage::FaceGroup& group : cage.groups) {
    Group set{group.name, {}};
    for (int face : group.faces) {
      if (face < 0 || static_cast<std::size_t>(face) >= patches_of.size()) {
        model.warnings.push_back(
            fmt::format("group {} names face {}, which does not exist", group.name, face));
        continue;
      }
      const std::vector<int>& patches = patches_of[static_cast<std::size_t>(face)];
      set.patches.insert(set.patches.end(), patches.begin(), patches.end());
    }
    model.groups.push_back(std::move(set));
  }
}

/// Greatest distance between the uses of a contour, or between one and a vertex at its ends.
double gap_of(const Model& model, const Contour& contour) {
  const auto point_of = [&](const ContourUse& use, double t) {
    const Surface& surface = *model.patches[static_cast<std::size_t>(use.patch)].surface;
    return surface.evaluate(use.curve->evaluate(t), Order::Position).point;
  };
  const auto vertex_at = [&](int v) {
    return model.vertices[static_cast<std::size_t>(v)].position;
  };
  double gap = 0;
  for (double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const Vec3 wanted = t == 0   ? vertex_at(contour.start)
                        : t == 1 ? vertex_at(contour.end)
                                 : point_of(contour.uses[0], t);
    for (const ContourUse& use : contour.uses) {
      gap = std::max(gap, (point_of(use, t) - wanted).norm());
    }
  }
  return gap;
}

/// Bfr 3.5.0 sees one ring of faces, too little to know Chaikin creases after a step of
/// subdivision where their sharpness changes along them: its surfaces then differ at a contour.
void warn_of_gaps(Model& model) {
  double gap = 0;
  for (const Contour& contour : model.contours) gap = std::max(gap, gap_of(model, contour));
  if (gap <= kContourGap * model.diagonal) return;
  model.warnings.push_back(
      fmt::format("Chaikin creases of changing sharpness: surfaces of neighbouring faces differ by "
                  "{:.2g} where they meet",
                  gap));
}

Model model_of_faces(const RefinedCage& regular, Scheme scheme, int level) {
  const CageTopology topology = make_topology(regular.cage, scheme);
  const auto surfaces = make_limit_surfaces(*topology.refiner, regular.cage.points, {level, true});
  ModelBuilder builder(topology.refiner->GetLevel(0), scheme);
  int part = 0;
  for (std::size_t f = 0; f < surfaces.size(); ++f) {
    const int cage_face = regular.parent_faces[f];
    part = f > 0 && regular.parent_faces[f - 1] == cage_face ? part + 1 : 0;
    if (!surfaces[f]) continue;
    std::string name = fmt::format("f{}", cage_face);
    if (regular.is_refined) name += fmt::format(".{}", part);
    builder.add_patch(static_cast<int>(f), std::move(name), cage_face, surfaces[f]);
  }
  builder.finish();
  builder.model.warnings = regular.warnings;
  builder.model.warnings.insert(builder.model.warnings.end(), topology.warnings.begin(),
                                topology.warnings.end());
  return std::move(builder.model);
}

/// Throws   Geometry if the points of the cage, and so its surface, lie on a line
void check_area(const Model& model, const Cage& cage) {
  const Vec3& origin = cage.points.front();
  Vec3 axis = Vec3::Zero();
  for (const Vec3& point : cage.points) {
    if ((point - origin).norm() > axis.norm()) axis = point - origin;
  }
  axis.normalize();
  for (const Vec3& point : cage.points) {
    if ((point - origin).cross(axis).norm() > kContourGap * model.diagonal) return;
  }
  throw Error(ErrorCode::Geometry, "the points of the cage lie on a line: its surface has no area");
}

}  // namespace

Model model_from_cage(const Cage& cage, const CageOptions& options) {
  const Scheme scheme = resolve_scheme(cage, options.scheme);
  Model model = model_of_faces(make_regular(cage, scheme), scheme, options.approximation_level);
  if (model.patches.empty()) {
    throw Error(ErrorCode::InvalidInput,
                "no face of the cage has a limit surface: all are holes or, by the boundary rule "
                "none, at the boundary");
  }
  for (const Vec3& point : cage.points) model.box.extend(point);
  model.diagonal = diagonal(cage);
  if (model.diagonal > 0 && std::isfinite(model.diagonal)) check_area(model, cage);
  if (cage.is_chaikin) warn_of_gaps(model);
  add_groups(cage, model);
  return model;
}

}  // namespace surfmesh
