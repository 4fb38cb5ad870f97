// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <ostream>
#include <string>
#include <vector>

/// Metrics of the unit square as formulas of u and v, as model files have them.
namespace surfmesh::testing {

struct MetricFormulas {
  std::string name;
  std::string m11, m12, m22;
};

inline void PrintTo(const MetricFormulas& formulas, std::ostream* out) { *out << formulas.name; }

/// Sizes `across` along the unit normal (c,s), `along` across it.
inline MetricFormulas directed_formulas(const std::string& name, const std::string& c,
                                        const std::string& s, const std::string& across,
                                        const std::string& along) {
  return {name, fmt::format("({0})^2/({2})^2+({1})^2/({3})^2", c, s, across, along),
          fmt::format("({0})*({1})*(1/({2})^2-1/({3})^2)", c, s, across, along),
          fmt::format("({1})^2/({2})^2+({0})^2/({3})^2", c, s, across, along)};
}

/// An oblique shock: elements 3e-4 across it, 0.3 along it, growing with the distance.
inline MetricFormulas shock_formulas(double scale = 1) {
  return directed_formulas("Shock1000", "0.6", "0.8",
                           fmt::format("sqrt(({}*3e-4)^2+(0.15*(0.6*u+0.8*v-0.7))^2)", scale),
                           fmt::format("{}*0.3", scale));
}

/// A circular layer 2e-4 thick. Along it elements are no longer than their sagitta, 0.05 of the
/// size across, allows.
inline MetricFormulas ring_formulas(double scale = 1) {
  const std::string r = "hypot(u-0.5,v-0.5+1e-9)";
  const std::string across = fmt::format("sqrt(({}*2e-4)^2+(0.15*({}-0.3))^2)", scale, r);
  return directed_formulas("ThinRing", fmt::format("(u-0.5)/{}", r),
                           fmt::format("(v-0.5+1e-9)/{}", r), across,
                           fmt::format("max({0},min(0.1,sqrt(0.4*{1}*{0})))", across, r));
}

/// Sizes that jump by a factor of 19 across a wavy line.
inline MetricFormulas jump_formulas(double scale = 1) {
  const std::string m =
      fmt::format("1/({}*(0.0525-0.0475*tanh((u-0.43-0.1*sin(6*v))/0.02)))^2", scale);
  return {"Jump", m, "0", m};
}

/// A boundary layer of aspect 1,000.
inline MetricFormulas layer_formulas(double scale = 1) {
  return directed_formulas("BoundaryLayer", "0", "1", fmt::format("{}*1e-4+0.12*v", scale),
                           fmt::format("{}*(0.1+0.05*sin(5*u))", scale));
}

/// Two shocks that cross.
inline MetricFormulas crossing_formulas(double scale = 1) {
  const auto shock = [&](const char* c, const char* s, const char* distance) {
    return directed_formulas("", c, s,
                             fmt::format("sqrt(({}*1e-3)^2+(0.15*({}))^2)", scale, distance),
                             fmt::format("{}*0.1", scale));
  };
  const MetricFormulas a = shock("0.6", "0.8", "0.6*u+0.8*v-0.7");
  const MetricFormulas b = shock("0.8", "-0.6", "0.8*u-0.6*v-0.1");
  return {"CrossingShocks", a.m11 + "+" + b.m11, a.m12 + "+" + b.m12, a.m22 + "+" + b.m22};
}

/// Elements of aspect 1,000 whose direction turns by 30 radians along each side of the
/// square: none can follow.
inline MetricFormulas turning_formulas() {
  return directed_formulas("Turning", "cos(30*(u+v))", "sin(30*(u+v))", "0.0003", "0.3");
}

/// The model file of the unit square with a metric and nothing else.
inline std::string model_text(const MetricFormulas& metric) {
  return fmt::format(
      R"({{"patches": [{{"name": "square", "surface": {{"z": "0"}},
      "domain": {{"u": [0, 1], "v": [0, 1]}},
      "sources": [{{"field": {{"m11": "{}", "m12": "{}", "m22": "{}"}}}}]}}],
      "sizing": {{"curvature": 0, "grade": 0, "hmin": 1e-6, "hmax": 1, "contour_curvature": false,
      "proximity": 0, "features": false}}}})",
      metric.m11, metric.m12, metric.m22);
}

}  // namespace surfmesh::testing
