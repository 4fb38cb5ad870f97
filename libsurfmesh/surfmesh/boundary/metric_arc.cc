// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/boundary/metric_arc.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

constexpr int kFirstPieces = 8;
/// Pieces are cut at the golden section: halving would see no wave that has its zeros there.
constexpr double kCut = 0.381966011250105;
/// Cuts of a first piece: enough for a size of 1e-9 of it, and an end for curves of infinite
/// length.
constexpr int kMaxDepth = 43;
constexpr double kLongestPiece = 0.5;
/// Pieces in all: more than a contour of a million segments needs.
constexpr std::size_t kMaxPieces = 8'000'000;
/// Relative disagreement at which a piece is not cut any more; that of the whole is smaller.
constexpr double kAgreement = 1e-3;
/// Pieces shorter than this do not matter, whatever their agreement.
constexpr double kNegligible = 1e-4;

struct Station {
  double t;
  Uv uv;
  Metric metric;
};

double piece_length(const Station& a, const Station& b) {
  const Uv step = b.uv - a.uv;
  return edge_length(std::sqrt(squared_length(a.metric, step)),
                     std::sqrt(squared_length(b.metric, step)));
}

/// Interpolate linearly in a table with increasing x.
double look_up(const std::vector<double>& xs, const std::vector<double>& ys, double x) {
  const auto after = std::upper_bound(xs.begin(), xs.end(), x);
  if (after == xs.begin()) return ys.front();
  if (after == xs.end()) return ys.back();
  const auto i = static_cast<std::size_t>(after - xs.begin());
  const double share = (x - xs[i - 1]) / (xs[i] - xs[i - 1]);
  return (1 - share) * ys[i - 1] + share * ys[i];
}

class Bisection {
 public:
  Bisection(const Curve& curve, const MetricField& field, const RunContext& context,
            std::vector<double>& parameters, std::vector<double>& arcs)
      : curve_(curve), field_(field), context_(context), parameters_(parameters), arcs_(arcs) {}

  Station station(double t) {
    if (++stations_ % kStepsBetweenCancellation == 0) context_.throw_if_cancelled();
    const Uv uv = curve_.evaluate(t);
    const Metric metric = field_.at(uv, hint_);
    if (!std::isfinite(metric.m11 + metric.m12 + metric.m22)) {
      throw Error(ErrorCode::Geometry,
                  fmt::format("the metric at (u,v) = ({}, {}) is not finite", uv.u, uv.v));
    }
    return {t, uv, metric};
  }

  const QueryCounts& queries() const { return hint_.answers; }

  void add(const Station& a, const Station& b) { add(a, b, piece_length(a, b), kMaxDepth); }

 private:
  /// `whole` is the length of the piece.
  void add(const Station& a, const Station& b, double whole, int depth) {
    const Station middle = station((1 - kCut) * a.t + kCut * b.t);
    const double first = piece_length(a, middle), second = piece_length(middle, b);
    const double parts = first + second;
    const bool is_good = parts <= kNegligible ||
                         (parts <= kLongestPiece && std::abs(whole - parts) <= kAgreement * parts);
    if (is_good || depth == 0) {
      append(middle.t, first);
      append(b.t, second);
      return;
    }
    add(a, middle, first, depth - 1);
    add(middle, b, second, depth - 1);
  }

  void append(double t, double length) {
    if (parameters_.size() > kMaxPieces) {
      const Uv uv = curve_.evaluate(t);
      throw Error(ErrorCode::Limit,
                  fmt::format("sizes near (u,v) = ({}, {}) ask for more than {} segments of one "
                              "contour",
                              uv.u, uv.v, kMaxPieces / 8));
    }
    parameters_.push_back(t);
    arcs_.push_back(arcs_.back() + length);
  }

  const Curve& curve_;
  const MetricField& field_;
  const RunContext& context_;
  std::size_t stations_ = 0;
  QueryHint hint_;
  std::vector<double>& parameters_;
  std::vector<double>& arcs_;
};

}  // namespace

MetricArc::MetricArc(const Curve& curve, const MetricField& field, const RunContext& context)
    : parameters_{0.0}, arcs_{0.0} {
  Bisection bisection(curve, field, context, parameters_, arcs_);
  Station from = bisection.station(0);
  for (int i = 1; i <= kFirstPieces; ++i) {
    const Station to = bisection.station(double(i) / kFirstPieces);
    bisection.add(from, to);
    from = to;
  }
  queries_ = bisection.queries();
}

double MetricArc::arc(double t) const { return look_up(parameters_, arcs_, t); }

double MetricArc::parameter(double arc) const { return look_up(arcs_, parameters_, arc); }

}  // namespace surfmesh
