// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/reach_sag_detail.hh"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include <cstdlib>
#include "surfmesh/control/parse_length.hh"
#include "surfmesh/control/size_bounds.hh"
#include "surfmesh/control/tables_from_mesh.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/geometry/first_form.hh"
#include "surfmesh/metric/size_tensor.hh"
#include "surfmesh/quality/sag.hh"

namespace surfmesh::detail {
namespace {

double env(const char* n, double d) { const char* s = getenv(n); return s ? atof(s) : d; }
const int kBalancingRounds = (int)env("BAL", 2);
const int kLocalRounds = (int)env("LOC", 8);
const double kAim = env("AIM", 0.9);
const double kMostGrowth = env("GROW", 2);
const double kMostShrinking = env("SHRINK", 0.5);
const double kRadius = env("RAD", 0.6);
const double kLocalShrink = env("LSH", 0.93);
const double kMix = env("MIX", 1);

class SagLoop {
 public:
  SagLoop(const Model& model, const Sources& sources, const PipelineOptions& options,
          const MeshOnce& mesh_once)
      : model_(model),
        sources_(sources),
        asked_(options.sizing.sag->in_units(model.diagonal)),
        mesh_once_(mesh_once),
        search_(model) {}

  MeshResult run() {
    MeshResult best;
    double best_sag = INFINITY;
    for (int round = 0;; ++round) {
      MeshResult now = mesh_once_(sources_, round >= kBalancingRounds);
      const Sag sag = measure_sag(now.mesh, model_, search_);
      { double sum=0; size_t over=0; for (double x : sag.of_faces) { sum += x; over += x > asked_; }
      double ms=1; for (const FaceHandle fh : now.mesh.faces()) { std::vector<Vec3> q; for (auto vh : now.mesh.fv_range(fh)) q.push_back(to_eigen(now.mesh.point(vh))); double x = 3.4641*(q[1]-q[0]).cross(q[2]-q[0]).norm()/((q[1]-q[0]).squaredNorm()+(q[2]-q[0]).squaredNorm()+(q[1]-q[2]).squaredNorm()); ms=std::min(ms,x); if (getenv("POOR") && x<0.08) fmt::print(stderr, "  poor {:.3f} patch {} at {:.4f} {:.4f} {:.4f} sides {:.4f} {:.4f} {:.4f}\n", x, model_.patches[size_t(now.mesh.property(require(now.mesh, keys::face_patch), fh))].name, q[0][0],q[0][1],q[0][2],(q[1]-q[0]).norm(),(q[1]-q[2]).norm(),(q[0]-q[2]).norm()); }
      fmt::print(stderr, "minshape {:.3f} round {} triangles {} sag {:.3f} mean {:.3f} over {} nodes {} control {:.2f} mesh {:.2f}\n", ms, round, now.mesh.n_faces(), sag.max / asked_, sum/double(sag.of_faces.size())/asked_, over, now.report.control.nodes, now.report.seconds.control, now.report.seconds.total); }
      if (round < kBalancingRounds) {
        PolyMesh mesh = now.mesh;
        balance(mesh, sag);
      } else if (sag.max > asked_ && round < kBalancingRounds + kLocalRounds) {
        refine_locally(now.mesh, sag);
      }
      const bool is_reached = sag.max <= asked_;
      const bool is_better = is_reached ? best_sag > asked_ || now.mesh.n_faces() < best.mesh.n_faces() : sag.max < best_sag;
      if (is_better) { best = std::move(now); best_sag = sag.max; }
      if (round >= kBalancingRounds && (is_reached || round >= kBalancingRounds + kLocalRounds)) break;
    }
    best.report.sag = {asked_, best_sag};
    if (best_sag > asked_) best.report.shortfalls.push_back(fmt::format("the sag reached is {:.4g}, asked for is {:.4g}", best_sag, asked_));
    return best;
  }

 private:
  double factor(double sag) const {
    return std::clamp(std::sqrt(kAim * asked_ / sag), kMostShrinking, kMostGrowth);
  }

  void balance(PolyMesh& mesh, const Sag& sag) {
    const auto metric_of = require(mesh, keys::corner_metric);
    for (const VertexHandle vh : mesh.vertices()) {
      double least = INFINITY, sum = 0; int n = 0;
      for (const FaceHandle fh : mesh.vf_range(vh)) {
        const double f = factor(sag.of_faces[static_cast<std::size_t>(fh.idx())]);
        least = std::min(least, f);
        sum += std::log(f); ++n;
      }
      const double mean = std::exp(sum / n);
      const double f = std::pow(least, kMix) * std::pow(mean, 1 - kMix);
      for (const HalfedgeHandle corner : mesh.vih_range(vh)) {
        if (mesh.is_boundary(corner)) continue;
        Metric& m = mesh.property(metric_of, corner);
        m = {m.m11 / (f * f), m.m12 / (f * f), m.m22 / (f * f)};
      }
    }
    sources_.sag = tables_from_mesh(mesh);
  }

  void refine_locally(const PolyMesh& mesh, const Sag& sag) {
    const auto patch_of = require(mesh, keys::face_patch);
    const auto uv_of = require(mesh, keys::corner_uv);
    const auto metric_of = require(mesh, keys::corner_metric);
    for (const FaceHandle fh : mesh.faces()) {
      const double s = sag.of_faces[static_cast<std::size_t>(fh.idx())];
      if (s <= asked_) continue;
      Uv uv{0, 0}; Metric m{0, 0, 0};
      for (const HalfedgeHandle heh : mesh.fh_range(fh)) {
        uv = uv + (1.0 / 3) * mesh.property(uv_of, heh);
        const Metric& c = mesh.property(metric_of, heh);
        m = {m.m11 + c.m11 / 3, m.m12 + c.m12 / 3, m.m22 + c.m22 / 3};
      }
      const int patch = mesh.property(patch_of, fh);
      const Jet jet = model_.patches[static_cast<std::size_t>(patch)].surface->evaluate(uv, Order::First);
      const PrincipalSizes h = principal_sizes(size_from_metric(first_form_factor(jet.du, jet.dv), m));
      const double f = std::min(kLocalShrink, factor(s));
      if (getenv("DUMP")) fmt::print(stderr, "  patch {} uv {:.3f} {:.3f} sag {:.3f} h {:.4f} {:.4f} ang {:.2f} quality M-area\n", model_.patches[size_t(patch)].name, uv.u, uv.v, s/asked_, h.l_s, h.l_t, h.angle);
      AtSource at{patch, uv, {{f * h.l_s, false}, {f * h.l_t, false}, h.angle}};
      at.radius = {kRadius * h.l_t, false};
      sources_.at.push_back(at);
    }
  }

  const Model& model_;
  Sources sources_;
  double asked_;
  const MeshOnce& mesh_once_;
  SurfaceSearch search_;
};

}  // namespace

MeshResult reach_sag(const Model& model, const Sources& sources, const PipelineOptions& options,
                     const MeshOnce& mesh_once) {
  return SagLoop(model, sources, options, mesh_once).run();
}

}  // namespace surfmesh::detail
