#include "sew/cut_curve.hpp"

#include <algorithm>
#include <cmath>

#include "curve/nurbs.hpp"
#include "sew/joined_curve.hpp"

namespace quadrille::sew {
namespace {

/// Part of the parameter interval: a cut as near to a knot or the seam is at it, so that no piece has a span as short.
constexpr double rounding = 1e-9;

double at_inner_knot(const Nurbs& curve, double t, double near) {
  for (const double knot : curve.knots)
    if (std::abs(knot - t) <= near && knot > curve.begin() && knot < curve.end()) return knot;
  return t;
}

std::vector<CutPiece> open_pieces(const Nurbs& curve, const std::vector<Cut>& cuts, int start) {
  std::vector<CutPiece> pieces;
  double begin = curve.begin();
  for (const Cut& cut : cuts) {
    pieces.push_back({curve::trimmed(curve, begin, cut.t), start});
    begin = cut.t, start = cut.place;
  }
  pieces.push_back({curve::trimmed(curve, begin, curve.end()), start});
  return pieces;
}

}  // namespace

std::vector<CutPiece> cut_curve(const Nurbs& curve, std::vector<Cut> cuts, int start) {
  const double near = rounding * (curve.end() - curve.begin());
  for (Cut& cut : cuts) cut.t = at_inner_knot(curve, cut.t, near);
  std::stable_sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.t < b.t; });
  if (start >= 0 || cuts.empty()) return open_pieces(curve, cuts, start);
  if (curve.end() - cuts.back().t <= near) std::rotate(cuts.begin(), cuts.end() - 1, cuts.end());
  if (const Cut first = cuts.front(); std::min(first.t - curve.begin(), curve.end() - first.t) <= near) {
    cuts.erase(cuts.begin());
    return open_pieces(curve, cuts, first.place);
  }
  const Nurbs head = curve::trimmed(curve, curve.begin(), cuts.front().t);
  const Nurbs tail = curve::trimmed(curve, cuts.back().t, curve.end());
  std::vector<CutPiece> pieces;
  for (size_t i = 0; i + 1 < cuts.size(); ++i)
    pieces.push_back({curve::trimmed(curve, cuts[i].t, cuts[i + 1].t), cuts[i].place});
  pieces.push_back({joined_curve(tail, head), cuts.back().place});
  return pieces;
}

}  // namespace quadrille::sew
