#include "outline/simplify_loops.hpp"

#include <algorithm>
#include <utility>

#include "curve/simplify_spline.hpp"
#include "heal/report_repair.hpp"

namespace quadrille::outline {

double simplify_loops(std::vector<heal::Loop>& loops, double tolerance, double diameter, std::vector<Repair>& repairs,
                      Report& report) {
  if (!(tolerance > 0)) return 0;
  int num_curves = 0, knots_before = 0, knots_after = 0;
  double greatest = 0;
  for (heal::Loop& loop : loops)
    for (heal::LoopCurve& c : loop) {
      auto simplified = curve::simplified_spline(c.curve, tolerance * diameter);
      if (!simplified) continue;
      c.curve = std::move(simplified->curve);
      repairs.push_back({RepairKind::fit, c.cad_edge, c.curve.poles.front(), simplified->distance});
      heal::report_repair(repairs.back(), repairs.size() - 1, report);
      ++num_curves;
      knots_before += simplified->knots_before, knots_after += simplified->knots_after;
      greatest = std::max(greatest, simplified->distance);
    }
  report.set("fit.tolerance", tolerance);
  report.set("fit.curves", num_curves);
  if (num_curves == 0) return 0;
  report.set("fit.knots_before", knots_before);
  report.set("fit.knots_after", knots_after);
  report.set("fit.greatest", greatest / diameter);
  report.set("heal.repairs", repairs.size());
  return greatest;
}

}  // namespace quadrille::outline
