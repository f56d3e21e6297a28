#include "heal/cusp_cut.hpp"

#include <algorithm>

#include "base/bracketed_root.hpp"
#include "curve/arc_length.hpp"
#include "curve/nurbs.hpp"
#include "heal/heal_rules.hpp"

namespace quadrille::heal {
namespace {

// The width of a cusp by the length cut off each of its curves.
class CuspWidth {
 public:
  explicit CuspWidth(const Cusp& cusp) : cusp_(cusp), length_in_(*cusp.in), length_out_(*cusp.out) {}

  double at(double cut) const {
    const Vec2 a = curve::point(*cusp_.in, length_in_.parameter(length_in_.total() - cut));
    return distance(a, curve::point(*cusp_.out, length_out_.parameter(cut)));
  }

  // The length of step `i` of those in which the reach is searched.
  double step(int i) const { return cusp_.reach * i / blunt_rules.search_steps; }

 private:
  Cusp cusp_;
  curve::ArcLength length_in_, length_out_;
};

}  // namespace

Cusp cusp_between(const Nurbs& in, const Nurbs& out, bool has_cusps_at_both_ends) {
  const double shorter = std::min(curve::ArcLength(in).total(), curve::ArcLength(out).total());
  return {&in, &out, blunt_rules.edge_fraction * (has_cusps_at_both_ends ? 0.5 : 1) * shorter};
}

std::optional<double> cut_length(const Cusp& cusp, double width) {
  const CuspWidth widths(cusp);
  for (int i = 1; i <= blunt_rules.search_steps; ++i)
    if (widths.at(widths.step(i)) >= width)
      return bisect([&](double cut) { return widths.at(cut) - width; }, widths.step(i - 1), widths.step(i));
  return std::nullopt;
}

double widest_cut(const Cusp& cusp) {
  const CuspWidth widths(cusp);
  double widest = 0;
  for (int i = 1; i <= blunt_rules.search_steps; ++i) widest = std::max(widest, widths.at(widths.step(i)));
  return widest;
}

}  // namespace quadrille::heal
