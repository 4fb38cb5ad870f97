// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "fuzz/byte_reader.hh"
#include "fuzz/checks.hh"
#include "fuzz/small_model.hh"
#include "fuzz/targets.hh"
#include "surfmesh/across/across.hh"
#include "surfmesh/assemble/assemble.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/geometry/predicates.hh"
#include "surfmesh/improve/improve.hh"
#include "surfmesh/pipeline/load_model.hh"
#include "surfmesh/pipeline/mesh_model.hh"
#include "surfmesh/pipeline/mesh_plan.hh"
#include "surfmesh/pipeline/report.hh"
#include "surfmesh/refine/boundary_triangulation.hh"
#include "surfmesh/refine/refine.hh"

namespace surfmesh::fuzz {
namespace {

/// Of processor time: runs that take longer are cancelled, which they have to obey.
constexpr double kSecondsOfRun = 2;
constexpr std::size_t kMostElementsOfRun = 500;

/// Check the triangles of a patch between two stages: proper, and each of positive area in (u,v).
void check_triangles(DelaunayMesh& delaunay, std::string_view stage) {
  delaunay.shrink();
  const PolyMesh& mesh = delaunay.mesh();
  check_links(mesh, stage);
  for (const FaceHandle fh : mesh.faces()) {
    std::vector<Uv> corners;
    for (const VertexHandle vh : mesh.fv_range(fh)) corners.push_back(delaunay.uv(vh));
    demand(corners.size() == 3 && orient2d(corners[0], corners[1], corners[2]) > 0,
           std::string(stage) + ": a triangle is not of positive area");
  }
}

/// The stages of one patch by themselves, each checked.
void check_stages(const MetricField& field, const PatchBoundary& boundary,
                  const PipelineOptions& options, const RunContext& context) {
  std::vector<std::vector<Uv>> loops;
  for (const BoundaryLoop& loop : boundary.loops) {
    std::vector<Uv>& uvs = loops.emplace_back();
    for (const BoundaryNode& node : loop) uvs.push_back(node.uv);
  }
  const BoundaryTriangulation made = triangulate_boundary(loops, field);
  check_triangles(*made.delaunay, "triangulate");
  refine(*made.delaunay, field, options.refine, context);
  check_triangles(*made.delaunay, "refine");
  improve(*made.delaunay, field, options.improve, context);
  check_triangles(*made.delaunay, "improve");
}

/// The stages of a run without a sag, each checked.
void mesh_in_stages(const ModelInput& input, Observer& observer) {
  const PipelineOptions& options = input.options;
  const bool has_quads = options.quads.is_on;
  const RunContext context(&observer, options.max_elements,
                           has_quads ? ElementKind::Quads : ElementKind::Triangles);
  const ResolvedSizing sizing = resolve(options.sizing, input.model);
  Report report;
  detail::MeshPlan plan(input.model, sizing, options, context, report);
  ControlSpaces control =
      make_control_spaces(input.model, input.sources, sizing, options.control, context);
  for (const auto& space : control.spaces) check_links(space->mesh(), "control");
  plan.take_spaces(std::move(control));
  ContourDemands demands;
  if (has_quads) demands.parity = SegmentParity::EvenPatches;
  plan.divide(demands, 0, nullptr);

  std::vector<PatchMesh> patches;
  for (std::size_t t = 0; t < plan.tiles().size(); ++t) {
    const PatchBoundary& boundary = plan.tiles()[t].boundary;
    if (!has_quads) {
      const auto patch = static_cast<std::size_t>(boundary.patch);
      check_stages(*plan.fields()[patch], boundary, options,
                   RunContext(&observer, kMostElementsOfRun));
    }
    patches.push_back(plan.mesh_tile(t, context).mesh);
    check_proper(*patches.back().mesh, "patch");
  }
  plan.make_proper(patches);
  for (const PatchMesh& patch : patches) check_proper(*patch.mesh, "make proper");

  PolyMesh mesh;
  const AssembleReport assembled =
      assemble(mesh, input.model, plan.nodes(), plan.numbers(), std::move(patches), context);
  check_proper(mesh, "assemble");
  if (!options.across.is_on) return;
  improve_across(mesh, input.model, plan.fields(), context, assembled.between_tiles);
  check_proper(mesh, "across");
}

void check_corners(const PolyMesh& mesh) {
  const auto uv_of = find(mesh, keys::corner_uv);
  const auto metric_of = find(mesh, keys::corner_metric);
  demand(uv_of.is_valid() && metric_of.is_valid(), "corners have parameters and a metric");
  for (const HalfedgeHandle heh : mesh.halfedges()) {
    if (mesh.is_boundary(heh)) continue;
    const Uv uv = mesh.property(uv_of, heh);
    demand(std::isfinite(uv.u) && std::isfinite(uv.v), "the (u,v) of corners are finite");
    const Metric m = mesh.property(metric_of, heh);
    demand(std::isfinite(m.m11) && std::isfinite(m.m12) && m.m11 > 0 && m.m22 > 0,
           "metrics of corners are metrics");
  }
}

void check_result(const MeshResult& result, const Model& model, bool may_have_quads) {
  check_proper(result.mesh, "result");
  check_corners(result.mesh);
  const auto patch_of = require(result.mesh, keys::face_patch);
  for (const FaceHandle fh : result.mesh.faces()) {
    const int patch = result.mesh.property(patch_of, fh);
    demand(patch >= 0 && static_cast<std::size_t>(patch) < model.patches.size(),
           "faces are of patches of the model");
    const unsigned corners = result.mesh.valence(fh);
    demand(corners == 3 || (corners == 4 && may_have_quads), "faces have three or four corners");
  }
  const Report& report = result.report;
  demand(report.mesh.triangles + report.mesh.quads == result.mesh.n_faces(), "faces are counted");
  demand(!to_json(report).empty() && !to_text(report).empty(), "reports can be written");
  for (const Notice& notice : report.notices) {
    demand(notice.kind != NoticeKind::BrokenPromise, notice.text);
  }
}

/// The positions of a mesh and the corners of its faces.
bool is_same(const PolyMesh& a, const PolyMesh& b) {
  const MeshArrays x = mesh_arrays(a), y = mesh_arrays(b);
  return x.points == y.points && x.faces == y.faces && x.patches == y.patches;
}

}  // namespace

bool try_pipeline(Bytes input) {
  ByteReader bytes(input);
  const bool is_repeated = bytes.happens(20), is_staged = bytes.happens(128);
  const SmallModel small = make_small_model(bytes);
  for (const Seed& cage : small.cages) write_scratch(cage.name, cage.bytes);
  const auto path = write_scratch("small.json", small.text);
  return accepts([&] {
    Deadline deadline(kSecondsOfRun);
    ModelInput model = load_model(path, {}, &deadline);
    model.options.threads = 1;
    model.options.max_elements = kMostElementsOfRun;
    if (is_staged && !model.options.sizing.sag) mesh_in_stages(model, deadline);
    const MeshResult result = mesh_model(model.model, model.sources, model.options, &deadline);
    check_result(result, model.model, model.options.quads.is_on);
    if (!is_repeated) return;
    model.options.threads = 2;
    Deadline again(kSecondsOfRun);
    demand(is_same(result.mesh, mesh_model(model.model, model.sources, model.options, &again).mesh),
           "the mesh does not depend on the number of threads");
  });
}

}  // namespace surfmesh::fuzz
