// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <memory>
#include <utility>

#include "surfmesh/geometry/surface.hh"

/// Surfaces with a closed form and derivatives by hand.
namespace surfmesh::test {

/// A surface over a given domain.
class AnalyticSurface : public Surface {
 public:
  explicit AnalyticSurface(Domain domain) : domain_(domain) {}

  Domain domain() const override { return domain_; }
  Jet evaluate(Uv uv, Order order) const override {
    Jet jet = all(uv);
    if (order < Order::Second) jet.duu = jet.duv = jet.dvv = Vec3::Constant(kUnset);
    if (order < Order::First) jet.du = jet.dv = Vec3::Constant(kUnset);
    return jet;
  }

 protected:
  /// Position and all derivatives.
  virtual Jet all(Uv uv) const = 0;

 private:
  Domain domain_;
};

/// origin + u a + v b
class PlanePatch : public AnalyticSurface {
 public:
  PlanePatch(Vec3 origin, Vec3 a, Vec3 b, Domain domain = {})
      : AnalyticSurface(domain), origin_(std::move(origin)), a_(std::move(a)), b_(std::move(b)) {}

 protected:
  Jet all(Uv uv) const override {
    return {origin_ + uv.u * a_ + uv.v * b_, a_, b_, Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  }

 private:
  Vec3 origin_;
  Vec3 a_;
  Vec3 b_;
};

/// The unit square in the plane z = 0.
inline const PlanePatch kUnitPlane(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY());

/// Radius r about the z axis, u the angle, v the height.
class Cylinder : public AnalyticSurface {
 public:
  Cylinder(double radius, Domain domain) : AnalyticSurface(domain), r_(radius) {}

 protected:
  Jet all(Uv uv) const override {
    const double c = std::cos(uv.u);
    const double s = std::sin(uv.u);
    return {Vec3(r_ * c, r_ * s, uv.v),
            Vec3(-r_ * s, r_ * c, 0),
            Vec3(0, 0, 1),
            Vec3(-r_ * c, -r_ * s, 0),
            Vec3::Zero(),
            Vec3::Zero()};
  }

 private:
  double r_;
};

/// v the distance from the z axis, u the angle, slope the rise of z with v; the apex is at v = 0.
class Cone : public AnalyticSurface {
 public:
  Cone(double slope, Domain domain) : AnalyticSurface(domain), slope_(slope) {}

 protected:
  Jet all(Uv uv) const override {
    const double c = std::cos(uv.u);
    const double s = std::sin(uv.u);
    return {Vec3(uv.v * c, uv.v * s, slope_ * uv.v),
            Vec3(-uv.v * s, uv.v * c, 0),
            Vec3(c, s, slope_),
            Vec3(-uv.v * c, -uv.v * s, 0),
            Vec3(-s, c, 0),
            Vec3::Zero()};
  }

 private:
  double slope_;
};

/// Radius r about the origin, u the longitude, v the latitude; poles at v = ±π/2.
class Sphere : public AnalyticSurface {
 public:
  Sphere(double radius, Domain domain) : AnalyticSurface(domain), r_(radius) {}

 protected:
  Jet all(Uv uv) const override {
    const double cu = std::cos(uv.u);
    const double su = std::sin(uv.u);
    const double cv = std::cos(uv.v);
    const double sv = std::sin(uv.v);
    return {r_ * Vec3(cv * cu, cv * su, sv),   r_ * Vec3(-cv * su, cv * cu, 0),
            r_ * Vec3(-sv * cu, -sv * su, cv), r_ * Vec3(-cv * cu, -cv * su, 0),
            r_ * Vec3(sv * su, -sv * cu, 0),   r_ * Vec3(-cv * cu, -cv * su, -sv)};
  }

 private:
  double r_;
};

/// Centre circle of radius a about the z axis, tube of radius b; u along the centre circle.
class Torus : public AnalyticSurface {
 public:
  Torus(double a, double b, Domain domain) : AnalyticSurface(domain), a_(a), b_(b) {}

 protected:
  Jet all(Uv uv) const override {
    const double cu = std::cos(uv.u);
    const double su = std::sin(uv.u);
    const double cv = std::cos(uv.v);
    const double sv = std::sin(uv.v);
    const double w = a_ + b_ * cv;
    return {Vec3(w * cu, w * su, b_ * sv),     Vec3(-w * su, w * cu, 0),
            b_ * Vec3(-sv * cu, -sv * su, cv), Vec3(-w * cu, -w * su, 0),
            b_ * Vec3(sv * su, -sv * cu, 0),   b_ * Vec3(-cv * cu, -cv * su, -sv)};
  }

 private:
  double a_;
  double b_;
};

/// Centre circle of radius r, u in [0, 2π] along it, v across; p(2π, v) = p(0, -v).
class MobiusBand : public AnalyticSurface {
 public:
  MobiusBand(double radius, Domain domain) : AnalyticSurface(domain), r_(radius) {}

 protected:
  Jet all(Uv uv) const override {
    const double c = std::cos(uv.u);
    const double s = std::sin(uv.u);
    const double ch = std::cos(uv.u / 2);
    const double sh = std::sin(uv.u / 2);
    const double w = r_ + uv.v * ch;
    const double wu = -uv.v * sh / 2;
    const double wuu = -uv.v * ch / 4;
    return {Vec3(w * c, w * s, uv.v * sh),
            Vec3(wu * c - w * s, wu * s + w * c, uv.v * ch / 2),
            Vec3(ch * c, ch * s, sh),
            Vec3(wuu * c - 2 * wu * s - w * c, wuu * s + 2 * wu * c - w * s, -uv.v * sh / 4),
            Vec3(-sh * c / 2 - ch * s, -sh * s / 2 + ch * c, ch / 2),
            Vec3::Zero()};
  }

 private:
  double r_;
};

/// Another surface run through in s in [0,1] at the speed of (s³ + s)/2, over the base's u.
class Reparametrised : public AnalyticSurface {
 public:
  explicit Reparametrised(std::shared_ptr<const Surface> base)
      : AnalyticSurface({0, 1, base->domain().v0, base->domain().v1}), base_(std::move(base)) {}

 protected:
  Jet all(Uv uv) const override {
    const Domain d = base_->domain();
    const double s = uv.u;
    const double width = d.u1 - d.u0;
    const double speed = width * (3 * s * s + 1) / 2;
    Jet jet = base_->evaluate({d.u0 + width * (s * s * s + s) / 2, uv.v}, Order::Second);
    jet.duu = speed * speed * jet.duu + width * 3 * s * jet.du;
    jet.duv *= speed;
    jet.du *= speed;
    return jet;
  }

 private:
  std::shared_ptr<const Surface> base_;
};

/// Another surface, scaled about the origin and then moved.
class Placed : public AnalyticSurface {
 public:
  Placed(std::shared_ptr<const Surface> base, double scale, Vec3 offset)
      : AnalyticSurface(base->domain()),
        base_(std::move(base)),
        scale_(scale),
        offset_(std::move(offset)) {}

 protected:
  Jet all(Uv uv) const override {
    const Jet jet = base_->evaluate(uv, Order::Second);
    return {scale_ * jet.point + offset_,
            scale_ * jet.du,
            scale_ * jet.dv,
            scale_ * jet.duu,
            scale_ * jet.duv,
            scale_ * jet.dvv};
  }

 private:
  std::shared_ptr<const Surface> base_;
  double scale_;
  Vec3 offset_;
};

}  // namespace surfmesh::test
