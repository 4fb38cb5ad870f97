// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/option_table.hh"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <type_traits>

#include "surfmesh/cage/interpolating_cage.hh"
#include "surfmesh/cage/mend_cage.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/io/nearest_word.hh"
#include "surfmesh/model/cad_input.hh"
#include "surfmesh/model/join_sides.hh"
#include "surfmesh/pipeline/set_option.hh"

namespace surfmesh {
namespace {

using Options = PipelineOptions;

/// Access to a member that is a number, a bool or an enum; `at` makes a reference to it.
template <class At>
constexpr NumberAccess number(const OptionRange& range, At) {
  return {&range, [](const Options& options) { return static_cast<double>(At{}(options)); },
          [](Options& options, double value) {
            auto& member = At{}(options);
            member = static_cast<std::remove_reference_t<decltype(member)>>(value);
          }};
}

template <class At>
constexpr LengthAccess length(const LengthRange& range, At) {
  return {&range, [](const Options& options) -> std::optional<Length> { return At{}(options); },
          [](Options& options, const std::optional<Length>& value) {
            auto& member = At{}(options);
            if constexpr (std::is_same_v<decltype(member), Length&>) {
              member = value.value();
            } else {
              member = value;
            }
          }};
}

/// Its default depends on the sag.
constexpr NumberAccess kCurvature = {
    &ranges::kCurvature, [](const Options& options) { return options.sizing.curvature_factor(); },
    [](Options& options, double value) { options.sizing.curvature = value; }};

/// Its default depends on the segments of a circle.
constexpr LengthAccess kHmin = {
    &ranges::kHmin,
    [](const Options& options) -> std::optional<Length> { return options.sizing.least_size(); },
    [](Options& options, const std::optional<Length>& value) { options.sizing.hmin = value; }};

/// A cage in a model file may have its own, which off from the command line beats, unset does not.
constexpr LengthAccess kWeld = {&ranges::kWeld,
                                [](const Options& options) -> std::optional<Length> {
                                  return options.weld && options.weld->value != 0 ? options.weld
                                                                                  : std::nullopt;
                                },
                                [](Options& options, const std::optional<Length>& value) {
                                  options.weld = value.value_or(Length());
                                }};

constexpr LengthAccess kJoining = {
    &ranges::kJoining,
    [](const Options& options) -> std::optional<Length> {
      return options.joining.value_or(JoinOptions().joining);
    },
    [](Options& options, const std::optional<Length>& value) { options.joining = value; }};

constexpr LengthAccess kSew = {&ranges::kSew,
                               [](const Options& options) -> std::optional<Length> {
                                 const Length sew =
                                     options.sew.value_or(Length::share(ranges::kSew.on));
                                 return sew.value != 0 ? std::optional(sew) : std::nullopt;
                               },
                               [](Options& options, const std::optional<Length>& value) {
                                 options.sew = value.value_or(Length());
                               }};

constexpr NumberAccess kOrient = {
    &ranges::kOrient,
    [](const Options& options) { return options.orient.value_or(false) ? 1.0 : 0.0; },
    [](Options& options, double value) { options.orient = value != 0; }};

constexpr NumberAccess kCreaseAngle = {
    &ranges::kCreaseAngle, [](const Options& options) { return options.crease_angle.value_or(0); },
    [](Options& options, double value) { options.crease_angle = value; }};

/// As kWeld.
constexpr LengthAccess kFit = {&ranges::kFit,
                               [](const Options& options) -> std::optional<Length> {
                                 return options.fit && options.fit->value != 0 ? options.fit
                                                                               : std::nullopt;
                               },
                               [](Options& options, const std::optional<Length>& value) {
                                 options.fit = value.value_or(Length());
                               }};

constexpr std::string_view kLengthUnit = "model units or % of the diagonal";
constexpr OptionGroup kSizes = OptionGroup::Sizes;
constexpr OptionGroup kControl = OptionGroup::ControlSpace;
constexpr OptionGroup kMeshing = OptionGroup::Meshing;
constexpr OptionGroup kCages = OptionGroup::Cages;

constexpr auto kTable = std::to_array<Option>({
    {kSizes, true, "", "share of the radius of curvature; off with size, by default with sag",
     kCurvature},
    {kSizes, true, "segments", "segments of a full circle, in place of curvature",
     number(
         ranges::kSegmentsPerCircle,
         [](auto& o) -> auto& { return o.sizing.segments_per_circle; })},
    {kSizes, true, kLengthUnit, "one length everywhere, whatever the other sizes are; 0 is off",
     length(
         ranges::kSize, [](auto& o) -> auto& { return o.sizing.size; })},
    {kSizes, true, kLengthUnit, "greatest distance between mesh and surface; 0 is off",
     length(
         ranges::kSag, [](auto& o) -> auto& { return o.sizing.sag; })},
    {kSizes, true, kLengthUnit, "lower bound of all sizes", kHmin},
    {kSizes, true, kLengthUnit, "upper bound of all sizes",
     length(
         ranges::kHmax, [](auto& o) -> auto& { return o.sizing.hmax; })},
    {kSizes, false, "",
     "what hmin and hmax in % refer to: the diagonal of the model, or of each part of it",
     number(
         ranges::kSharesOf, [](auto& o) -> auto& { return o.sizing.shares_of; })},
    {kSizes, true, "", "greatest ratio of the two sizes from curvature",
     number(
         ranges::kStretch, [](auto& o) -> auto& { return o.sizing.stretch; })},
    {kSizes, false, "", "the least size at a point in all directions",
     number(
         ranges::kIsotropic, [](auto& o) -> auto& { return o.sizing.isotropic; })},
    {kSizes, true, "", "growth of sizes: by at most its logarithm per unit of length",
     number(
         ranges::kGrade, [](auto& o) -> auto& { return o.sizing.grade; })},
    {kSizes, false, "",
     "sizes from the curvature of boundaries, creases and trims; off without curvature and sag",
     number(
         ranges::kContourCurvature, [](auto& o) -> auto& { return o.sizing.contour_curvature; })},
    {kSizes, true, "elements", "elements wanted across a gap between two parts of a boundary",
     number(
         ranges::kProximity, [](auto& o) -> auto& { return o.sizing.proximity; })},
    {kSizes, false, "", "finer sizes near short contours",
     number(
         ranges::kFeatures, [](auto& o) -> auto& { return o.sizing.features; })},
    {kSizes, false, "", "source of curvature: second derivatives, or differences of positions",
     number(
         ranges::kCurvatureFrom, [](auto& o) -> auto& { return o.sizing.curvature_from; })},
    {kControl, false, "nodes",
     "control nodes: chosen to the precision, or so many regular ones in each patch, as a square",
     number(
         ranges::kNodes, [](auto& o) -> auto& { return o.control.regular_nodes; })},
    {kControl, false, "", "conformity of the control space with the sizes asked for",
     number(
         ranges::kPrecision, [](auto& o) -> auto& { return o.control.precision; })},
    {kControl, false, "",
     "control space: cells, a triangulation of nodes (mesh), or a regular grid; auto is mesh if an "
     "option of mesh is set, otherwise cells",
     number(
         ranges::kControl, [](auto& o) -> auto& { return o.control.kind; })},
    {kControl, false, "",
     "interpolation of sizes: linear in a triangle of nodes, or by distance from one node (s), "
     "its triangle (t), all circumcircles (o), or the cheapest that agrees with o (auto)",
     number(
         ranges::kInterpolation, [](auto& o) -> auto& { return o.control.interpolation; })},
    {kControl, false, "", "conformity with o below which interpolation auto takes a cheaper one",
     number(
         ranges::kEpsilon, [](auto& o) -> auto& { return o.control.epsilon; })},
    {kControl, false, "", "averages of lengths, or of their logarithms",
     number(
         ranges::kBlend, [](auto& o) -> auto& { return o.control.blend; })},
    {kControl, false, "",
     "reach of a size with a radius: its whole disc, or only the triangles at its node",
     number(
         ranges::kLookup, [](auto& o) -> auto& { return o.control.lookup; })},
    {kControl, false, "", "more control nodes, for the shape of the control triangles",
     number(
         ranges::kInnerNodes, [](auto& o) -> auto& { return o.control.inner_nodes; })},
    {kControl, false, "",
     "metric distance within which smoothing by elements uses the last sizes again",
     number(
         ranges::kReuse, [](auto& o) -> auto& { return o.control.reuse; })},
    {kMeshing, false, "", "where new nodes go: at the front, or to circumcentres",
     number(
         ranges::kPlacement, [](auto& o) -> auto& { return o.refine.placement; })},
    {kMeshing, false, "", "connection of new nodes: by their cavity, or by edge swaps",
     number(
         ranges::kKernel, [](auto& o) -> auto& { return o.refine.kernel; })},
    {kMeshing, false, "",
     "circumcentres are given up unless the metric there conforms with that of the triangle: by "
     "its "
     "circle, or to within a logarithm of a ratio of lengths (with placement circumcentre)",
     number(
         ranges::kConformity, [](auto& o) -> auto& { return o.refine.conformity; })},
    {kMeshing, false, "",
     "smoothing of the inner nodes: best for lengths, or as in the paper by the metric at the node "
     "(laplace) or in the triangles (element); a number is best with so many sweeps",
     number(
         ranges::kSmoothing, [](auto& o) -> auto& { return o.improve.smoothing; })},
    {kMeshing, false, "sweeps",
     "smoothing sweeps over the inner nodes; more than a few of laplace or element harm",
     number(
         ranges::kSweeps, [](auto& o) -> auto& { return o.improve.sweeps; })},
    {kMeshing, false, "passes",
     "most passes over bad triangles, after edges far too short or long are collapsed or split",
     number(
         ranges::kRepairs, [](auto& o) -> auto& { return o.improve.repairs; })},
    {kCages, true, "", "patches of a cage: its faces, blocks of quads, or regions of faces",
     number(
         ranges::kPatches, [](auto& o) -> auto& { return o.patches; })},
    {kCages, true, kLengthUnit, "distance within which vertices of a cage become one; 0 is off",
     kWeld},
    {kCages, false, kLengthUnit, "distance within which sides of formula patches become one",
     kJoining},
    {kCages, false, kLengthUnit,
     "distance within which free edges of CAD faces become one; 0 is off", kSew},
    {kCages, false, "", "faces of a cage turned to agree with their neighbours", kOrient},
    {kCages, true, "degrees", "creases of a cage where its faces meet at more than this angle",
     kCreaseAngle},
    {kCages, false, "",
     "surface of a cage: its limit surface, or one through its points (auto: the second for "
     "meshes)",
     number(
         ranges::kSurface, [](auto& o) -> auto& { return o.surface; })},
    {kCages, false, kLengthUnit,
     "how far a surface through points may stay from them, to lose noise; 0 is off", kFit},
    {kMeshing, true, "", "quads in place of triangles, square in the metric",
     number(
         ranges::kQuads, [](auto& o) -> auto& { return o.quads.is_on; })},
    {kMeshing, false, "", "way to quads: nodes placed for them, or conversion of the triangles",
     number(
         ranges::kQuadMethod, [](auto& o) -> auto& { return o.quads.method; })},
    {kMeshing, false, "", "conversion from the fronts: merging of triangles, advancing, or both",
     number(
         ranges::kQuadFront, [](auto& o) -> auto& { return o.quads.front; })},
    {kMeshing, false, "", "elements that cross contours which merely divide a smooth surface",
     number(
         ranges::kAcross, [](auto& o) -> auto& { return o.across.is_on; })},
    {kMeshing, true, "", "normals of the surface in .obj, .glb and .om files",
     number(
         ranges::kNormals, [](auto& o) -> auto& { return o.output.normals; })},
    {kMeshing, false, "", "parameters (u,v) of the corners in .obj and .glb files",
     number(
         ranges::kUv, [](auto& o) -> auto& { return o.output.uv; })},
    {kMeshing, false, "",
     "texture coordinates of the cage in .obj, .glb and .om files, in place of (u,v)",
     number(
         ranges::kTexture, [](auto& o) -> auto& { return o.output.texture; })},
    {kMeshing, false, "", "version of .msh files, binary or text",
     number(
         ranges::kMsh, [](auto& o) -> auto& { return o.output.msh; })},
    {kMeshing, false, "triangles",
     "parts into which larger patches are cut, to share their work and save memory traffic; the "
     "mesh hardly differs",
     number(
         ranges::kTile, [](auto& o) -> auto& { return o.tile; })},
    {kMeshing, true, "threads",
     "threads; all is one for each core, and the mesh is always the same",
     number(
         ranges::kThreads, [](auto& o) -> auto& { return o.threads; })},
    {kMeshing, true, "elements", "triangles or quads above which the run ends with an error",
     number(
         ranges::kMaxElements, [](auto& o) -> auto& { return o.max_elements; })},
});

/// The words of core, which does not know the enums, stand for the values that they name.
template <class Enum, std::size_t n>
constexpr bool stands_for(const std::array<OptionWord, n>& words, std::string_view word,
                          Enum value) {
  return std::any_of(words.begin(), words.end(), [&](const OptionWord& w) {
    return w.word == word && w.value == static_cast<double>(value);
  });
}

static_assert(stands_for(words::kCurvatureFrom, "exact", CurvatureFrom::Exact));
static_assert(stands_for(words::kCurvatureFrom, "differences", CurvatureFrom::Differences));
static_assert(stands_for(words::kSharesOf, "model", SharesOf::Model));
static_assert(stands_for(words::kSharesOf, "part", SharesOf::Part));
static_assert(stands_for(words::kControl, "mesh", ControlKind::Mesh));
static_assert(stands_for(words::kControl, "grid", ControlKind::Grid));
static_assert(stands_for(words::kControl, "cells", ControlKind::Cells));
static_assert(stands_for(words::kControl, "auto", ControlKind::Automatic));
static_assert(stands_for(words::kInterpolation, "s", Interpolation::Single));
static_assert(stands_for(words::kInterpolation, "t", Interpolation::Triangle));
static_assert(stands_for(words::kInterpolation, "o", Interpolation::Circles));
static_assert(stands_for(words::kInterpolation, "auto", Interpolation::Automatic));
static_assert(stands_for(words::kInterpolation, "linear", Interpolation::Linear));
static_assert(stands_for(words::kBlend, "linear", Blend::Linear));
static_assert(stands_for(words::kBlend, "log", Blend::Logarithmic));
static_assert(stands_for(words::kLookup, "disc", DiscLookup::Disc));
static_assert(stands_for(words::kLookup, "vertices", DiscLookup::Vertices));
static_assert(stands_for(words::kPlacement, "frontal", Placement::Frontal));
static_assert(stands_for(words::kPlacement, "circumcentre", Placement::Circumcentre));
static_assert(stands_for(words::kKernel, "cavity", Kernel::Cavity));
static_assert(stands_for(words::kKernel, "swap", Kernel::Swap));
static_assert(stands_for(words::kSmoothing, "off", Smoothing::Off));
static_assert(stands_for(words::kSmoothing, "best", Smoothing::Best));
static_assert(stands_for(words::kSmoothing, "laplace", Smoothing::Laplace));
static_assert(stands_for(words::kSmoothing, "element", Smoothing::Element));
static_assert(stands_for(words::kQuadMethod, "best", QuadMethod::Best));
static_assert(stands_for(words::kQuadMethod, "frontal", QuadMethod::Frontal));
static_assert(stands_for(words::kQuadFront, "lee-lo", QuadFront::LeeLo));
static_assert(stands_for(words::kQuadFront, "q-morph", QuadFront::QMorph));
static_assert(stands_for(words::kQuadFront, "mixed", QuadFront::Mixed));
static_assert(stands_for(words::kMsh, "4.1", MshVersion::Binary41));
static_assert(stands_for(words::kMsh, "4.1-text", MshVersion::Text41));
static_assert(stands_for(words::kMsh, "2.2", MshVersion::Binary22));
static_assert(stands_for(words::kMsh, "2.2-text", MshVersion::Text22));
static_assert(stands_for(words::kPatches, "auto", PatchKind::Auto));
static_assert(stands_for(words::kPatches, "faces", PatchKind::Faces));
static_assert(stands_for(words::kPatches, "blocks", PatchKind::Blocks));
static_assert(stands_for(words::kPatches, "regions", PatchKind::Regions));
static_assert(stands_for(words::kSurface, "auto", SurfaceKind::Auto));
static_assert(stands_for(words::kSurface, "limit", SurfaceKind::Limit));
static_assert(stands_for(words::kSurface, "interpolate", SurfaceKind::Interpolate));

}  // namespace

std::string_view Option::name() const {
  return std::visit([](const auto& a) { return a.range->name; }, access);
}

std::string Option::range_text() const {
  return std::visit([](const auto& a) { return to_text(*a.range); }, access);
}

std::vector<std::string_view> Option::words() const {
  std::vector<std::string_view> result;
  if (const auto* number = std::get_if<NumberAccess>(&access)) {
    for (const OptionWord& word : number->range->words) result.push_back(word.word);
  } else {
    const LengthRange& range = *std::get<LengthAccess>(access).range;
    if (range.can_be_off) result.push_back("off");
    if (range.on > 0) result.insert(result.end(), {"on", "true", "false"});
  }
  return result;
}

std::string Option::value_text(const PipelineOptions& options) const {
  if (const auto* number = std::get_if<NumberAccess>(&access)) {
    return to_text(*number->range, number->get(options));
  }
  return to_text(std::get<LengthAccess>(access).get(options));
}

std::span<const Option> option_table() { return kTable; }

const Option& find_option(std::string_view name) {
  const auto found = std::find_if(kTable.begin(), kTable.end(),
                                  [name](const Option& option) { return option.name() == name; });
  if (found != kTable.end()) return *found;
  const std::string front = fmt::format("there is no option '{}'", name.substr(0, kLongestQuote));
  if (const auto near = nearest_word(name, option_names())) {
    throw Error(ErrorCode::InvalidOption, fmt::format("{}; did you mean {}?", front, *near));
  }
  throw Error(ErrorCode::InvalidOption,
              fmt::format("{}; there are {}", front, fmt::join(option_names(), ", ")));
}

}  // namespace surfmesh
