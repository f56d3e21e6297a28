#include "trace/line_fitter.hpp"

namespace quadrille::trace {
namespace {

// The length is part of the key since a line may be continued later; its sign distinguishes a join from a merged pair.
graph::CurveKey key_of(int line, double length) { return {static_cast<double>(line), -1.0, length}; }
graph::CurveKey key_of(const MergeCandidate& c) {
  return {static_cast<double>(c.a), static_cast<double>(c.b), c.is_join ? -c.length() : c.length()};
}

}  // namespace

MergedLine LineFitter::single(int line) {
  const Streamline& l = lines_[line];
  const auto along = [&](double s, Vec2& direction) { return l.at(evaluator_, s, direction); };
  const graph::CurveKey key = key_of(line, l.length());
  const bool is_cut = l.launch.start.node < 0;
  const Nurbs& spline = fitted(key, along, l.length());
  return {{l.launch.start, l.reached, spline, is_cut ? LineKind::cut : LineKind::traced}, l.length(), -1, line, key};
}

MergedLine LineFitter::pair(const MergeCandidate& candidate, int merge) {
  const Streamline &a = lines_[candidate.a], &b = lines_[candidate.b];
  const graph::CurveKey key = key_of(candidate);
  const Nurbs& spline = fitted(key, merged_curve(evaluator_, a, b, candidate), candidate.length());
  return {{a.launch.start, b.launch.start, spline, LineKind::merged}, candidate.length(), merge, candidate.a, key};
}

const Nurbs& LineFitter::fitted(const graph::CurveKey& key, const curve::CurveFunction& curve, double length) {
  const auto known = fitted_.find(key);
  if (known != fitted_.end()) return known->second;
  return fitted_[key] = curve::fit_line(curve, length, relative_fit_tol * evaluator_.field().mesh.face.diameter);
}

}  // namespace quadrille::trace
