// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/cage_model.hh"

#include <fmt/format.h>
#include <opensubdiv/sdc/crease.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <new>
#include <span>
#include <utility>

#include "surfmesh/cage/block_surface.hh"
#include "surfmesh/cage/face_neighbours.hh"
#include "surfmesh/cage/faces_of_cage.hh"
#include "surfmesh/cage/fit_cage.hh"
#include "surfmesh/cage/gather_blocks.hh"
#include "surfmesh/cage/gather_regions.hh"
#include "surfmesh/cage/interpolating_cage.hh"
#include "surfmesh/cage/mend_cage.hh"
#include "surfmesh/cage/refine_cage.hh"
#include "surfmesh/cage/region_model.hh"
#include "surfmesh/cage/subdivision.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/option_range.hh"
#include "surfmesh/core/out_of_memory.hh"
#include "surfmesh/geometry/parts.hh"
#include "surfmesh/model/finish_model.hh"
#include "surfmesh/model/pin_ends.hh"

namespace surfmesh {
namespace {

namespace Far = OpenSubdiv::Far;

/// The uses of a contour are the same points up to rounding: this share of the diagonal.
constexpr double kContourGap = 1e-9;

/// Models of fewer patches are as quick to mesh either way.
constexpr std::size_t kManyPatches = 200;

/// How many times fewer regions are chosen over blocks and faces, whose parameters follow the cage.
constexpr std::size_t kFewerPatches = 2;

using Level = Far::TopologyLevel;
using Surfaces = std::vector<std::shared_ptr<const Surface>>;

/// An edge of the cage on the border of a block, with the block on its left: its vertices and its
/// ends in the block's parameters.
struct BorderEdge {
  int edge = -1;
  int from = -1;
  int to = -1;
  Uv from_uv;
  Uv to_uv;
  bool starts_side = false;
};

using Border = std::vector<BorderEdge>;

/// The cell of the i-th face along a side of a block, counter-clockwise.
std::array<int, 2> cell_on_side(const Block& block, int side, int i) {
  switch (side) {
    case 0:
      return {i, 0};
    case 1:
      return {block.columns - 1, i};
    case 2:
      return {block.columns - 1 - i, block.rows - 1};
    default:
      return {0, block.rows - 1 - i};
  }
}

/// The edges around a block, counter-clockwise from its lower left.
Border border_of(const Level& level, const Block& block) {
  Domain cell;
  const int corners = level.GetFaceVertices(block.faces[0].face).size();
  if (corners == 3) cell.shape = Domain::Shape::Triangle;
  Border border;
  for (int side = 0; side < corners; ++side) {
    const int count = side % 2 == 0 ? block.columns : block.rows;
    for (int i = 0; i < count; ++i) {
      const auto [column, row] = cell_on_side(block, side, i);
      const BlockFace& f = block.faces[static_cast<std::size_t>(row * block.columns + column)];
      const int from = (f.rotation + side) % corners, to = (from + 1) % corners;
      const Far::ConstIndexArray vertices = level.GetFaceVertices(f.face);
      const Uv lower{static_cast<double>(column), static_cast<double>(row)};
      border.push_back({level.GetFaceEdges(f.face)[from], vertices[from], vertices[to],
                        lower + cell.corner(side), lower + cell.corner((side + 1) % corners),
                        i == 0});
    }
  }
  return border;
}

/// Tells where contours end: at the corners of blocks, where more or other borders meet than two
/// that go on into each other, and at corners of true boundaries.
class ContourEnds {
 public:
  ContourEnds(const Level& level, const std::vector<Border>& borders)
      : level_(level), vertices_(static_cast<std::size_t>(level.GetNumVertices())) {
    std::vector<int> uses(static_cast<std::size_t>(level.GetNumEdges()), 0);
    for (const Border& border : borders) {
      for (const BorderEdge& edge : border) {
        if (edge.starts_side) vertices_[static_cast<std::size_t>(edge.from)].is_end = true;
        if (uses[static_cast<std::size_t>(edge.edge)]++ == 0) meet(edge);
      }
    }
    for (const Border& border : borders) {
      for (const BorderEdge& edge : border) {
        if (uses[static_cast<std::size_t>(edge.edge)] == 1) end_at_corners(edge);
      }
    }
  }

  bool contains(int vertex) const {
    const Vertex& v = vertices_[static_cast<std::size_t>(vertex)];
    return v.is_end || v.edges != 2 || level_.GetVertexSharpness(vertex) > 0;
  }

 private:
  struct Vertex {
    int edges = 0;         ///< of borders
    float sharpness = -1;  ///< of the first of them
    bool is_end = false;
  };

  void meet(const BorderEdge& edge) {
    const float sharpness = level_.GetEdgeSharpness(edge.edge);
    for (const int end : {edge.from, edge.to}) {
      Vertex& v = vertices_[static_cast<std::size_t>(end)];
      if (++v.edges == 1) v.sharpness = sharpness;
      v.is_end |= edge.from == edge.to || v.sharpness != sharpness;
    }
  }

  /// Beside faces that are left out (holes) a true boundary runs along edges that have faces on
  /// both sides. It is smooth on creases and through vertices of four faces; at others it has a
  /// corner, even in the middle of a block's side: half of three faces is not half of the angle.
  void end_at_corners(const BorderEdge& edge) {
    if (level_.GetEdgeFaces(edge.edge).size() == 1 ||
        OpenSubdiv::Sdc::Crease::IsInfinite(level_.GetEdgeSharpness(edge.edge))) {
      return;
    }
    for (const int end : {edge.from, edge.to}) {
      const bool is_regular =
          level_.GetVertexFaces(end).size() == 4 && level_.GetVertexEdges(end).size() == 4;
      vertices_[static_cast<std::size_t>(end)].is_end |= !is_regular;
    }
  }

  const Level& level_;
  std::vector<Vertex> vertices_;
};

/// Builds the model of a cage of regular face sizes, block by block.
class ModelBuilder {
 public:
  ModelBuilder(const Level& level, Scheme scheme, const std::vector<Block>& blocks)
      : level_(level),
        scheme_(scheme),
        borders_(borders_of(level, blocks)),
        ends_(level, borders_),
        vertex_of_(static_cast<std::size_t>(level.GetNumVertices()), -1),
        contour_of_(static_cast<std::size_t>(level.GetNumEdges()), -1) {}

  /// Add the patch of the next block.
  void add_patch(Patch patch) {
    const int patch_index = static_cast<int>(model.patches.size());
    const Border& border = borders_[model.patches.size()];
    for (const BorderEdge& edge : border) {
      if (ends_.contains(edge.from)) add_vertex(edge.from, *patch.surface, edge.from_uv);
    }
    PatchLoop loop;
    for (auto first = border.begin(); first != border.end();) {
      const auto last = std::find_if(
          first, border.end(), [this](const BorderEdge& edge) { return ends_.contains(edge.to); });
      loop.push_back(add_use({first, last + 1}, patch_index));
      first = last + 1;
    }
    patch.loops.push_back(std::move(loop));
    model.patches.push_back(std::move(patch));
  }

  /// A contour that in the end has one use only is a true boundary, unless it is a point.
  void finish() {
    for (Contour& contour : model.contours) {
      contour.is_degenerate = contour.start == contour.end && contour.breaks.empty();
      if (contour.uses.size() == 1) contour.is_smooth = false;
    }
  }

  Model model;

 private:
  /// Edges of a border between two ends of contours.
  using Chain = std::span<const BorderEdge>;

  static std::vector<Border> borders_of(const Level& level, const std::vector<Block>& blocks) {
    std::vector<Border> borders;
    for (const Block& block : blocks) borders.push_back(border_of(level, block));
    return borders;
  }

  void add_vertex(int vertex, const Surface& surface, Uv uv) {
    int& index = vertex_of_[static_cast<std::size_t>(vertex)];
    if (index >= 0) return;
    index = static_cast<int>(model.vertices.size());
    model.vertices.push_back({surface.evaluate(uv, Order::Position).point});
  }

  LoopEntry add_use(Chain chain, int patch) {
    const int known = contour_of_[static_cast<std::size_t>(chain[0].edge)];
    const int index = known >= 0 ? known : add_contour(chain);
    Contour& contour = model.contour(index);
    const int from = vertex_of_[static_cast<std::size_t>(chain[0].from)];
    const Uv from_uv = chain.front().from_uv, to_uv = chain.back().to_uv;
    ContourUse use;
    use.patch = patch;
    // Around a closed contour its first edge tells the direction.
    use.is_forward =
        contour.start == from && first_edge_[static_cast<std::size_t>(index)] == chain[0].edge;
    use.curve = use.is_forward ? std::make_shared<SegmentCurve>(from_uv, to_uv)
                               : std::make_shared<SegmentCurve>(to_uv, from_uv);
    contour.uses.push_back(std::move(use));
    return {index, static_cast<int>(contour.uses.size()) - 1};
  }

  int add_contour(Chain chain) {
    const int index = static_cast<int>(model.contours.size());
    Contour contour;
    contour.name = fmt::format("e{}-{}", chain[0].from, chain[0].to);
    if (chain.size() > 1) contour.name += fmt::format("..{}", chain.back().to);
    contour.start = vertex_of_[static_cast<std::size_t>(chain.front().from)];
    contour.end = vertex_of_[static_cast<std::size_t>(chain.back().to)];
    contour.breaks = even_breaks(static_cast<int>(chain.size()));
    contour.is_smooth = scheme_ != Scheme::Bilinear && !OpenSubdiv::Sdc::Crease::IsInfinite(
                                                           level_.GetEdgeSharpness(chain[0].edge));
    model.contours.push_back(std::move(contour));
    first_edge_.push_back(chain[0].edge);
    for (const BorderEdge& edge : chain) contour_of_[static_cast<std::size_t>(edge.edge)] = index;
    return index;
  }

  const Level& level_;
  Scheme scheme_;
  std::vector<Border> borders_;  ///< by block
  ContourEnds ends_;
  std::vector<int> vertex_of_;   ///< model vertex of a cage vertex, -1 if it has none
  std::vector<int> contour_of_;  ///< contour of an edge, -1 if it has none
  std::vector<int> first_edge_;  ///< of each contour
};

/// `stand_ins` has for each face of the cage the one whose patches it has; -1 for none.
void add_groups(const Cage& cage, const std::vector<int>& stand_ins, Model& model) {
  std::vector<std::vector<int>> patches_of(cage.faces.size());
  for (std::size_t p = 0; p < model.patches.size(); ++p) {
    for (const int face : model.patches[p].cage_faces) {
      patches_of[static_cast<std::size_t>(face)].push_back(static_cast<int>(p));
    }
  }
  for (const Cage::FaceGroup& group : cage.groups) {
    Group set{group.name, {}, group.is_material};
    std::vector<char> is_in(model.patches.size(), 0);
    for (int face : group.faces) {
      if (face < 0 || static_cast<std::size_t>(face) >= patches_of.size()) {
        model.notices.push_back(
            warning(NoticeKind::IgnoredInput,
                    fmt::format("group {} names face {}, which does not exist", group.name, face)));
        continue;
      }
      const int stand_in = stand_ins[static_cast<std::size_t>(face)];
      if (stand_in < 0) continue;
      for (const int patch : patches_of[static_cast<std::size_t>(stand_in)]) {
        if (!std::exchange(is_in[static_cast<std::size_t>(patch)], char{1})) {
          set.patches.push_back(patch);
        }
      }
    }
    model.groups.push_back(std::move(set));
  }
}

/// Bfr 3.5.0 sees one ring of faces, too little to know Chaikin creases after a step of
/// subdivision where their sharpness changes along them: its surfaces then differ at a contour.
void warn_of_gaps(Model& model) {
  double gap = 0;
  for (const Contour& contour : model.contours) gap = std::max(gap, gap_of(model, contour));
  if (gap <= kContourGap * model.diagonal) return;
  model.notices.push_back(warning(
      NoticeKind::SurfaceGap,
      fmt::format("Chaikin creases of changing sharpness: surfaces of neighbouring faces differ by "
                  "{:.2g} where they meet",
                  gap)));
}

/// By face a number that tells the groups it is in; -1 for faces without a surface.
std::vector<int> group_sets(const Cage& cage, const Surfaces& surfaces) {
  std::vector<std::vector<int>> groups_of(cage.faces.size());
  for (std::size_t g = 0; g < cage.groups.size(); ++g) {
    for (const int face : cage.groups[g].faces) {
      if (face < 0 || static_cast<std::size_t>(face) >= groups_of.size()) continue;
      groups_of[static_cast<std::size_t>(face)].push_back(static_cast<int>(g));
    }
  }
  std::map<std::vector<int>, int> numbers;
  std::vector<int> sets;
  for (std::size_t f = 0; f < groups_of.size(); ++f) {
    const int next = static_cast<int>(numbers.size());
    sets.push_back(surfaces[f] ? numbers.try_emplace(groups_of[f], next).first->second : -1);
  }
  return sets;
}

std::shared_ptr<const Surface> surface_of(const Block& block, const Surfaces& surfaces) {
  if (block.faces.size() == 1) return surfaces[static_cast<std::size_t>(block.faces[0].face)];
  std::vector<BlockCell> cells;
  for (const BlockFace& f : block.faces) {
    cells.push_back({surfaces[static_cast<std::size_t>(f.face)], f.rotation});
  }
  return std::make_shared<BlockSurface>(block.columns, std::move(cells));
}

/// f<face>, or f<face>.<part> if the faces are parts of those of the cage.
std::string name_of(int face, const RefinedCage& regular) {
  const auto parent = [&](int f) { return regular.parent_faces[static_cast<std::size_t>(f)]; };
  if (!regular.is_refined) return fmt::format("f{}", parent(face));
  // The parts of a face follow each other.
  int part = 0;
  while (face > part && parent(face - part - 1) == parent(face)) ++part;
  return fmt::format("f{}.{}", parent(face), part);
}

/// The faces of the given cage that some of the regular one are parts of.
std::vector<int> cage_faces_of(const std::vector<int>& of_regular, const RefinedCage& regular) {
  std::vector<int> faces;
  for (const int f : of_regular) faces.push_back(regular.parent_faces[static_cast<std::size_t>(f)]);
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

/// Under bilinear subdivision every edge is a crease, so there faces are all that blocks can be.
bool has_blocks(PatchKind kind, Scheme scheme) {
  return kind != PatchKind::Faces && scheme == Scheme::CatmullClark;
}

/// Facets of a bilinear cage meet in edges everywhere.
bool has_regions(PatchKind kind, Scheme scheme) {
  return (kind == PatchKind::Auto || kind == PatchKind::Regions) && scheme != Scheme::Bilinear;
}

Model model_of_blocks(const CageTopology& topology, const RefinedCage& regular,
                      const Surfaces& surfaces, const std::vector<Block>& blocks, Scheme scheme) {
  ModelBuilder builder(topology.refiner->GetLevel(0), scheme, blocks);
  for (const Block& block : blocks) {
    std::vector<int> faces;
    for (const BlockFace& f : block.faces) faces.push_back(f.face);
    Patch patch;
    patch.name = name_of(first_face(block), regular);
    patch.surface = surface_of(block, surfaces);
    patch.cage_faces = cage_faces_of(faces, regular);
    builder.add_patch(std::move(patch));
  }
  builder.finish();
  return std::move(builder.model);
}

Model model_of_regions(const FaceNeighbours& neighbours, const RefinedCage& regular,
                       const Surfaces& surfaces, std::vector<FaceRegion> gathered) {
  RegionModel made = model_of_regions(neighbours, surfaces, std::move(gathered));
  const std::vector<FaceRegion>& regions = made.regions;
  Model& model = made.model;
  for (std::size_t r = 0; r < regions.size(); ++r) {
    model.patches[r].name = name_of(regions[r].faces.front(), regular);
    model.patches[r].cage_faces = cage_faces_of(regions[r].faces, regular);
  }
  // Where a region touches itself in a corner, its loops do so to the last bit.
  model.diagonal = diagonal(regular.cage);
  pin_ends(model);
  return std::move(model);
}

/// `faces` tells for each face of the regular cage what it is of the cage as given.
Model model_of_regular(const RefinedCage& regular, const std::vector<FaceOfCage>& faces,
                       Scheme scheme, const CageOptions& options) {
  const CageTopology topology = make_topology(regular.cage, scheme);
  const Surfaces surfaces = make_limit_surfaces(*topology.refiner, regular.cage.points,
                                                {options.approximation_level, true}, faces);
  const std::vector<int> sets = group_sets(regular.cage, surfaces);
  const FaceNeighbours neighbours(*topology.refiner, sets);
  std::vector<FaceRegion> regions;
  std::vector<Block> blocks;
  if (options.patches != PatchKind::Regions || scheme == Scheme::Bilinear) {
    blocks = has_blocks(options.patches, scheme)
                 ? gather_blocks(*topology.refiner, sets, regular.cage.points)
                 : single_faces(sets);
  }
  const bool may_have_regions = blocks.empty() || blocks.size() >= kManyPatches;
  if (may_have_regions && has_regions(options.patches, scheme)) {
    regions = gather_regions(neighbours, surfaces);
  }
  const bool takes_regions = blocks.empty() || kFewerPatches * regions.size() <= blocks.size();
  Model model = !regions.empty() && takes_regions
                    ? model_of_regions(neighbours, regular, surfaces, std::move(regions))
                    : model_of_blocks(topology, regular, surfaces, blocks, scheme);
  model.notices = regular.notices;
  model.notices.insert(model.notices.end(), topology.notices.begin(), topology.notices.end());
  return model;
}

/// Tell where blocks or regions were asked for, but each face is a patch.
void warn_of_faces(PatchKind kind, Scheme scheme, Model& model) {
  if (kind == PatchKind::Blocks && !has_blocks(kind, scheme)) {
    model.notices.push_back(warning(NoticeKind::IgnoredInput,
                                    "only Catmull-Clark cages have blocks; each face is a patch"));
  }
  if (kind == PatchKind::Regions && !has_regions(kind, scheme)) {
    model.notices.push_back(
        warning(NoticeKind::IgnoredInput, "bilinear cages have no regions; each face is a patch"));
  }
}

/// Throws   Geometry if the points of the cage, and so its surface, lie on a line
void check_area(const Model& model, const Cage& cage) {
  const std::vector<int> used = used_vertices(cage);
  const auto point_of = [&](int v) -> const Vec3& {
    return cage.points[static_cast<std::size_t>(v)];
  };
  const Vec3& origin = point_of(used.front());
  Vec3 axis = Vec3::Zero();
  for (const int v : used) {
    if ((point_of(v) - origin).norm() > axis.norm()) axis = point_of(v) - origin;
  }
  axis.normalize();
  for (const int v : used) {
    if ((point_of(v) - origin).cross(axis).norm() > kContourGap * model.diagonal) return;
  }
  throw Error(ErrorCode::Geometry, "the points of the cage lie on a line: its surface has no area");
}

MendOptions mend_options(const Cage& cage, const CageOptions& options) {
  MendOptions mend;
  if (options.weld && options.weld->value != 0) {
    check_option(ranges::kWeld, options.weld);
    mend.weld = options.weld->in_units(diagonal(cage));
  }
  mend.orient = options.orient.value_or(false);
  return mend;
}

/// What the options change.
std::vector<MadeWith> made_with(const CageOptions& options) {
  std::vector<MadeWith> made;
  const auto add = [&](std::string_view name, std::string value) {
    made.push_back({std::string(name), std::move(value)});
  };
  if (options.patches != PatchKind::Auto) {
    add(ranges::kPatches.name, to_text(ranges::kPatches, static_cast<double>(options.patches)));
  }
  if (options.weld && options.weld->value != 0) add(ranges::kWeld.name, to_text(options.weld));
  if (options.orient.value_or(false)) add(ranges::kOrient.name, to_text(ranges::kOrient, 1));
  if (options.crease_angle.value_or(0) > 0) {
    add(ranges::kCreaseAngle.name, to_text(ranges::kCreaseAngle, *options.crease_angle));
  }
  if (options.surface != SurfaceKind::Auto) {
    add(ranges::kSurface.name, to_text(ranges::kSurface, static_cast<double>(options.surface)));
  }
  if (options.fit && options.fit->value != 0) add(ranges::kFit.name, to_text(options.fit));
  return made;
}

}  // namespace

Model model_from_cage(const Cage& cage, const CageOptions& options) try {
  MendedCage mended = mend_cage(cage, mend_options(cage, options));
  const Scheme scheme = resolve_scheme(mended.cage, options.scheme);
  const detail::CageFit fitted = detail::fit_cage(options, scheme, mended.cage);
  const RefinedCage regular = make_regular(mended.cage, scheme, mended.parent_faces);
  Model model = model_of_regular(regular, faces_of_cage(cage, mended, regular), scheme, options);
  const auto given = std::make_shared<const Cage>(cage);
  for (Patch& patch : model.patches) {
    patch.cage = given;
    patch.is_interpolating = fitted.fit.has_value();
  }
  if (fitted.fit) model.fits.push_back(*fitted.fit);
  model.notices.insert(model.notices.begin(), fitted.notices.begin(), fitted.notices.end());
  model.notices.insert(model.notices.begin(), std::make_move_iterator(mended.notices.begin()),
                       std::make_move_iterator(mended.notices.end()));
  if (model.patches.empty()) {
    throw Error(ErrorCode::InvalidInput,
                "no face of the cage has a limit surface: all are holes or, by the boundary rule "
                "none, at the boundary");
  }
  model.box = bounding_box(cage);
  model.diagonal = diagonal(cage);
  if (model.diagonal > 0 && std::isfinite(model.diagonal)) check_area(model, cage);
  if (cage.is_chaikin) warn_of_gaps(model);
  warn_of_faces(options.patches, scheme, model);
  add_groups(cage, mended.stand_ins, model);
  model.made_with = made_with(options);
  return model;
} catch (const std::bad_alloc&) {
  fail_without_memory("while making the model of a cage");
}

}  // namespace surfmesh
