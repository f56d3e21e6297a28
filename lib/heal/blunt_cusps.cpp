#include "heal/blunt_cusps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/error.hpp"
#include "base/position_text.hpp"
#include "curve/arc_length.hpp"
#include "curve/nurbs.hpp"
#include "heal/cusp_cut.hpp"
#include "heal/heal_rules.hpp"
#include "heal/interior_angle.hpp"
#include "heal/report_repair.hpp"

namespace quadrille::heal {
namespace {

const LoopCurve& before(const Loop& loop, size_t i) { return loop[(i + loop.size() - 1) % loop.size()]; }

// For each curve of the loop, whether it starts at a cusp.
std::vector<bool> cusps_of(const Loop& loop) {
  std::vector<bool> cusps;
  for (size_t i = 0; i < loop.size(); ++i)
    cusps.push_back(is_cusp(interior_angle(before(loop, i).curve, loop[i].curve)));
  return cusps;
}

Cusp cusp_at(const Loop& loop, const std::vector<bool>& cusps, size_t i) {
  const size_t n = loop.size();
  return cusp_between(before(loop, i).curve, loop[i].curve, cusps[(i + 1) % n] || cusps[(i + n - 1) % n]);
}

// Two digits, rounded down.
double rounded_down(double x) {
  const double unit = std::pow(10, std::floor(std::log10(x)) - 1);
  return unit * std::floor(x / unit * (1 + 1e-9));
}

std::string cusp_text(const Loop& loop, size_t i, const BluntOptions& options) {
  return fmt::format("{}: edges {} and {} meet in a cusp at {}", options.file, before(loop, i).cad_edge,
                     loop[i].cad_edge, rounded_position_text(loop[i].curve.poles.front()));
}

double required_cut(const Loop& loop, const std::vector<bool>& cusps, size_t i, const BluntOptions& options) {
  const Cusp cusp = cusp_at(loop, cusps, i);
  const std::optional<double> length = cut_length(cusp, options.width);
  if (!length)
    throw FormatError(
        fmt::format("{}, which cannot be cut off at a width of {:.3g}, as its edges are too short: give "
                    "--blunt {:.2g}, the largest that would do, or less",
                    cusp_text(loop, i, options), options.width, rounded_down(widest_cut(cusp))));
  return *length;
}

// The loop where `cuts[i]` is cut off both curves of the joint at which curve i starts.
Loop cut_loop(const Loop& loop, const std::vector<double>& cuts) {
  Loop trimmed, result;
  for (size_t i = 0; i < loop.size(); ++i) {
    const Nurbs& curve = loop[i].curve;
    const curve::ArcLength length(curve);
    const double at_start = cuts[i], at_end = cuts[(i + 1) % loop.size()];
    const double begin = at_start > 0 ? length.parameter(at_start) : curve.begin();
    const double end = at_end > 0 ? length.parameter(length.total() - at_end) : curve.end();
    trimmed.push_back(loop[i]);
    trimmed.back().curve = curve::trimmed(curve, begin, end);
  }
  for (size_t i = 0; i < loop.size(); ++i) {
    result.push_back(trimmed[i]);
    const size_t next = (i + 1) % loop.size();
    if (cuts[next] > 0)
      result.push_back(
          {curve::segment(trimmed[i].curve.poles.back(), trimmed[next].curve.poles.front()), trimmed[i].cad_edge, ""});
  }
  return result;
}

Loop blunt_loop(const Loop& loop, const BluntOptions& options, std::vector<Repair>& repairs) {
  const std::vector<bool> cusps = cusps_of(loop);
  if (std::find(cusps.begin(), cusps.end(), true) == cusps.end()) return loop;
  std::vector<double> cuts(loop.size(), 0);
  for (size_t i = 0; i < loop.size(); ++i) {
    if (!cusps[i]) continue;
    cuts[i] = required_cut(loop, cusps, i, options);
    repairs.push_back({RepairKind::cusp, before(loop, i).cad_edge, loop[i].curve.poles.front(), cuts[i]});
  }
  return cut_loop(loop, cuts);
}

}  // namespace

void blunt_cusps(std::vector<Loop>& loops, const BluntOptions& options, std::vector<Repair>& repairs, Report& report) {
  if (options.width == 0) return;
  const double least = blunt_rules.least_width * options.diameter;
  if (options.width < least)
    throw FormatError(
        fmt::format("{}: --blunt {:.3g} is less than 1e-5 of the diameter, and such edges are not kept: "
                    "give {:.2g} or more",
                    options.file, options.width, 1.1 * least));
  const size_t healed = repairs.size();
  for (Loop& loop : loops) loop = blunt_loop(loop, options, repairs);
  for (size_t i = healed; i < repairs.size(); ++i) report_repair(repairs[i], i, report);
  report.set("heal.repairs", repairs.size());
}

void refuse_cusps(const std::vector<Loop>& loops, const BluntOptions& options) {
  double width = blunt_rules.proposed_width * options.diameter;
  std::string text;
  for (const Loop& loop : loops) {
    const std::vector<bool> cusps = cusps_of(loop);
    for (size_t i = 0; i < loop.size(); ++i) {
      if (!cusps[i]) continue;
      if (text.empty()) text = cusp_text(loop, i, options);
      width = std::min(width, 0.5 * widest_cut(cusp_at(loop, cusps, i)));
    }
  }
  if (text.empty()) return;
  const bool is_wide = width >= 1.1 * blunt_rules.least_width * options.diameter;
  throw FormatError(text + ", an angle of zero, which holds no quad: " +
                    (is_wide ? fmt::format("give --blunt {:.2g} to cut its tip off at that width", rounded_down(width))
                             : "cut its tip off in the drawing"));
}

}  // namespace quadrille::heal
