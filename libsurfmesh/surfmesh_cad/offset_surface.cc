// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/offset_surface.hh"

#include <Eigen/Geometry>
#include <Standard_Failure.hxx>
#include <algorithm>
#include <utility>

#include "surfmesh_cad/file_points.hh"

namespace surfmesh {
namespace {

/// Where p_u and p_v of the base are nearly parallel, or one vanishes, the normal is that of
/// OpenCASCADE: the sine of their angle, and the share of the greater.
constexpr double kLeastSine = 1e-8;

/// The base surface with its third derivatives, where they are asked for.
struct BaseJet {
  Vec3 point, du, dv, duu, duv, dvv, duuu, duuv, duvv, dvvv;
};

BaseJet base_jet(const Geom_Surface& base, Uv uv, Order order) {
  gp_Pnt point;
  gp_Vec du, dv, duu, dvv, duv, duuu, dvvv, duuv, duvv;
  BaseJet jet;
  if (order == Order::Second) {
    base.D3(uv.u, uv.v, point, du, dv, duu, dvv, duv, duuu, dvvv, duuv, duvv);
    jet.duuu = to_vec3(duuu);
    jet.duuv = to_vec3(duuv);
    jet.duvv = to_vec3(duvv);
    jet.dvvv = to_vec3(dvvv);
  } else if (order == Order::First) {
    base.D2(uv.u, uv.v, point, du, dv, duu, dvv, duv);
  } else {
    base.D1(uv.u, uv.v, point, du, dv);
  }
  jet.point = to_vec3(point);
  jet.du = to_vec3(du);
  jet.dv = to_vec3(dv);
  jet.duu = to_vec3(duu);
  jet.duv = to_vec3(duv);
  jet.dvv = to_vec3(dvv);
  return jet;
}

/// The derivatives of n = N / |N|. With N = L n, and n perpendicular to its derivatives:
/// L_u = n·N_u, n_u = (N_u - L_u n) / L, and by another derivative
/// n_uv = (N_uv - L_uv n - L_u n_v - L_v n_u) / L with L_uv = n_v·N_u + n·N_uv.
class UnitNormal {
 public:
  UnitNormal(const BaseJet& base, const Vec3& normal) : length_(normal.norm()) {
    n = normal / length_;
    normal_u_ = base.duu.cross(base.dv) + base.du.cross(base.duv);
    normal_v_ = base.duv.cross(base.dv) + base.du.cross(base.dvv);
    length_u_ = n.dot(normal_u_);
    length_v_ = n.dot(normal_v_);
    nu = (normal_u_ - length_u_ * n) / length_;
    nv = (normal_v_ - length_v_ * n) / length_;
  }

  void add_second(const BaseJet& base) {
    const Vec3 normal_uu =
        base.duuu.cross(base.dv) + 2 * base.duu.cross(base.duv) + base.du.cross(base.duuv);
    const Vec3 normal_uv =
        base.duuv.cross(base.dv) + base.duu.cross(base.dvv) + base.du.cross(base.duvv);
    const Vec3 normal_vv =
        base.duvv.cross(base.dv) + 2 * base.duv.cross(base.dvv) + base.du.cross(base.dvvv);
    nuu = second(normal_uu, nu.dot(normal_u_), length_u_, nu, length_u_, nu);
    nuv = second(normal_uv, nv.dot(normal_u_), length_u_, nv, length_v_, nu);
    nvv = second(normal_vv, nv.dot(normal_v_), length_v_, nv, length_v_, nv);
  }

  Vec3 n, nu, nv, nuu, nuv, nvv;

 private:
  Vec3 second(const Vec3& normal, double turned, double length_a, const Vec3& b, double length_b,
              const Vec3& a) const {
    const double length = turned + n.dot(normal);
    return (normal - length * n - length_a * b - length_b * a) / length_;
  }

  double length_;
  double length_u_;
  double length_v_;
  Vec3 normal_u_;
  Vec3 normal_v_;
};

class OffsetSurface : public Surface {
 public:
  OffsetSurface(Handle(Geom_OffsetSurface) surface, const Domain& domain, UnevenCells cells)
      : surface_(std::move(surface)),
        base_(surface_->BasisSurface()),
        distance_(surface_->Offset()),
        domain_(domain),
        cells_(std::move(cells)) {}

  Jet evaluate(Uv uv, Order order) const override {
    try {
      return finite(jet(uv, order), uv, order);
    } catch (const Standard_Failure&) {
      fail_evaluation(uv);
    }
  }

  Domain domain() const override { return domain_; }
  CellCount cells() const override { return cells_.count(); }
  Uv from_cells(Uv point) const override { return cells_.from_cells(point); }
  Uv to_cells(Uv uv) const override { return cells_.to_cells(uv); }

 private:
  Jet jet(Uv uv, Order order) const {
    const BaseJet base = base_jet(*base_, uv, order);
    const Vec3 normal = base.du.cross(base.dv);
    const double greater = std::max(base.du.squaredNorm(), base.dv.squaredNorm());
    if (!(normal.norm() > kLeastSine * greater)) return file_jet(*surface_, uv, order);
    Jet jet;
    if (order == Order::Position) {
      jet.point = base.point + distance_ * normal.normalized();
      return jet;
    }
    UnitNormal unit(base, normal);
    jet.point = base.point + distance_ * unit.n;
    jet.du = base.du + distance_ * unit.nu;
    jet.dv = base.dv + distance_ * unit.nv;
    if (order == Order::First) return jet;
    unit.add_second(base);
    jet.duu = base.duu + distance_ * unit.nuu;
    jet.duv = base.duv + distance_ * unit.nuv;
    jet.dvv = base.dvv + distance_ * unit.nvv;
    return jet;
  }

  Handle(Geom_OffsetSurface) surface_;
  Handle(Geom_Surface) base_;
  double distance_;
  Domain domain_;
  UnevenCells cells_;
};

}  // namespace

std::shared_ptr<const Surface> offset_surface(const Handle(Geom_OffsetSurface) & surface,
                                              const Domain& domain, UnevenCells cells) {
  return std::make_shared<OffsetSurface>(surface, domain, std::move(cells));
}

}  // namespace surfmesh
