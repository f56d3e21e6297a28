#include "heal/blunt_cusps.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/angle.hpp"
#include "base/bracketed_root.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/name_text.hpp"
#include "base/warning_codes.hpp"
#include "curve/chain.hpp"
#include "curve/nurbs.hpp"
#include "curve/pole_box.hpp"
#include "heal/heal_rules.hpp"
#include "heal/touching_loops.hpp"
#include "model/name_rules.hpp"

namespace quadrille::heal {

double interior_angle(const Nurbs& in, const Nurbs& out) {
  const Vec2 a = curve::tangent(in, in.end(), true), b = curve::tangent(out, out.begin());
  const double turn = std::atan2(cross(a, b), dot(a, b));
  if (std::abs(turn) < 1e-9) return pi;
  if (pi - std::abs(turn) > 1e-6) return pi - turn;
  const curve::ArcLength length_in(in), length_out(out);
  const double h = 1e-3 * std::min(length_in.total(), length_out.total());
  const Vec2 joint = out.poles.front();
  const Vec2 back = curve::point(in, length_in.parameter(length_in.total() - h)) - joint;
  const Vec2 ahead = curve::point(out, length_out.parameter(h)) - joint;
  const bool outside = cross(ahead, back) < 0;
  const double deficit = pi - std::abs(turn);
  return outside ? 2 * pi - std::max(deficit, 1e-15) : std::max(deficit, 1e-300);
}

bool is_cusp(double interior_angle) { return interior_angle <= blunt_rules.largest_cusp; }

namespace {

/// The two curves of a cusp, `in` ending at its tip and `out` starting there, and how much may be cut off each of them,
/// a length. The pointers must outlive the object.
struct Cusp {
  const Nurbs* in = nullptr;
  const Nurbs* out = nullptr;
  double reach = 0;
};

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

/// `has_cusps_at_both_ends`: of one of the curves; then only half of the shorter curve may be cut off.
Cusp cusp_between(const Nurbs& in, const Nurbs& out, bool has_cusps_at_both_ends) {
  const double shorter = std::min(curve::ArcLength(in).total(), curve::ArcLength(out).total());
  return {&in, &out, blunt_rules.edge_fraction * (has_cusps_at_both_ends ? 0.5 : 1) * shorter};
}

/// The least length to cut off both curves such that the distance of their new ends is `width`; std::nullopt if the
/// cusp is nowhere as wide within its reach.
std::optional<double> cut_length(const Cusp& cusp, double width) {
  const CuspWidth widths(cusp);
  for (int i = 1; i <= blunt_rules.search_steps; ++i)
    if (widths.at(widths.step(i)) >= width)
      return bisect([&](double cut) { return widths.at(cut) - width; }, widths.step(i - 1), widths.step(i));
  return std::nullopt;
}

/// The greatest width at which the cusp can be cut.
double widest_cut(const Cusp& cusp) {
  const CuspWidth widths(cusp);
  double widest = 0;
  for (int i = 1; i <= blunt_rules.search_steps; ++i) widest = std::max(widest, widths.at(widths.step(i)));
  return widest;
}

using Flags = std::vector<std::vector<bool>>;

const LoopCurve& before(const Loop& loop, size_t i) { return loop[(i + loop.size() - 1) % loop.size()]; }

// For each curve of the loops, whether it starts at a cusp or sharp corner, or at a convex one that touches another.
Flags tips_of(const std::vector<Loop>& loops, bool keeps_contacts) {
  Flags tips = contacts_at_starts(loops);
  for (size_t l = 0; l < loops.size(); ++l)
    for (size_t i = 0; i < loops[l].size(); ++i) {
      const double angle = interior_angle(before(loops[l], i).curve, loops[l][i].curve);
      tips[l][i] = angle < blunt_rules.sharp_angle || (!keeps_contacts && tips[l][i] && angle < pi);
    }
  return tips;
}

Cusp cusp_at(const Loop& loop, const std::vector<bool>& tips, size_t i) {
  const size_t n = loop.size();
  return cusp_between(before(loop, i).curve, loop[i].curve, tips[(i + 1) % n] || tips[(i + n - 1) % n]);
}

// Two digits, rounded down.
double rounded_down(double x) {
  const double unit = std::pow(10, std::floor(std::log10(x)) - 1);
  return unit * std::floor(x / unit * (1 + 1e-9));
}

bool starts_at_cusp(const Loop& loop, size_t i) {
  return is_cusp(interior_angle(before(loop, i).curve, loop[i].curve));
}

std::string tip_text(const Loop& loop, size_t i) {
  const double angle = interior_angle(before(loop, i).curve, loop[i].curve);
  const std::string kind = is_cusp(angle)                    ? "cusp"
                           : angle < blunt_rules.sharp_angle ? fmt::format("corner of {:.2g} degrees", degrees(angle))
                                                             : "corner that touches another one";
  return fmt::format("edges {} and {} meet in a {} at {}", before(loop, i).cad_edge, loop[i].cad_edge, kind,
                     rounded_position_text(loop[i].curve.poles.front()));
}

/// The diameter of the face; in a far field, that of the box around the bodies, as for the size of features
/// (features/small_features.hpp).
double reference_length(const std::vector<Loop>& loops, double diameter) {
  std::vector<Nurbs> bodies;
  bool has_far_field = false;
  for (const Loop& loop : loops)
    for (const LoopCurve& c : loop)
      if (c.name == far_field_name)
        has_far_field = true;
      else if (!matches_wildcard(c.name, symmetry_pattern))
        bodies.push_back(c.curve);
  return has_far_field && !bodies.empty() ? std::min(diameter, curve::pole_box(bodies).diagonal()) : diameter;
}

double automatic_width_of(const Cusp& cusp, double reference) {
  return std::min(blunt_rules.automatic_width * reference, 0.5 * widest_cut(cusp));
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

/// Cuts off the tips of loops.
class TipCutter {
 public:
  TipCutter(const std::vector<Loop>& loops, const BluntOptions& options)
      : loops_(loops),
        options_(options),
        tips_(tips_of(loops, options.keeps_contacts)),
        reference_(reference_length(loops, options.diameter)) {}

  double least_width() const { return blunt_rules.least_width * reference_; }

  std::vector<Loop> cut(std::vector<Repair>& repairs) {
    std::vector<Loop> result;
    for (size_t l = 0; l < loops_.size(); ++l) result.push_back(cut_one(loops_[l], tips_[l], repairs));
    return result;
  }

  void warn(Report& report) const {
    if (texts_.empty() || options_.width != automatic_width) return;
    report.warn(warning::tip_cut_off,
                fmt::format("{}: no quad fits into {}, which {} cut off: {}: give --blunt WIDTH for another width, "
                            "--blunt 0 to refuse such faces",
                            options_.file, texts_.size() == 1 ? "a tip" : fmt::format("{} tips", texts_.size()),
                            texts_.size() == 1 ? "is" : "are", fmt::join(texts_, "; ")));
  }

 private:
  double width_of(const Cusp& cusp) const {
    return options_.width == automatic_width ? automatic_width_of(cusp, reference_) : options_.width;
  }

  /// 0 if the tip is too narrow to be cut off without being asked: cusps and contacts are refused then.
  double required_cut(const Loop& loop, const std::vector<bool>& tips, size_t i) {
    const Cusp cusp = cusp_at(loop, tips, i);
    const double width = width_of(cusp);
    if (width < least_width()) return 0;
    const std::optional<double> length = cut_length(cusp, width);
    if (!length)
      throw FormatError(
          fmt::format("{}: {}, which cannot be cut off at a width of {:.3g}, as its edges are too short: give "
                      "--blunt {:.2g}, the largest that would do, or less",
                      options_.file, tip_text(loop, i), width, rounded_down(widest_cut(cusp))));
    texts_.push_back(fmt::format("{}, {:.2g} long and {:.2g} wide", tip_text(loop, i), *length, width));
    return *length;
  }

  Loop cut_one(const Loop& loop, const std::vector<bool>& tips, std::vector<Repair>& repairs) {
    if (std::find(tips.begin(), tips.end(), true) == tips.end()) return loop;
    std::vector<double> cuts(loop.size(), 0);
    for (size_t i = 0; i < loop.size(); ++i) {
      if (!tips[i]) continue;
      cuts[i] = required_cut(loop, tips, i);
      if (cuts[i] > 0)
        repairs.push_back({RepairKind::cusp, before(loop, i).cad_edge, loop[i].curve.poles.front(), cuts[i]});
    }
    return cut_loop(loop, cuts);
  }

  const std::vector<Loop>& loops_;
  const BluntOptions& options_;
  Flags tips_;
  double reference_;
  std::vector<std::string> texts_;  ///< of each tip that was cut off
};

// What to do about the tips of the loops.
std::string blunt_remedy(const std::vector<Loop>& loops, const BluntOptions& options, const char* what) {
  const Flags tips = tips_of(loops, options.keeps_contacts);
  const double reference = reference_length(loops, options.diameter);
  double width = blunt_rules.automatic_width * reference;
  for (size_t l = 0; l < loops.size(); ++l)
    for (size_t i = 0; i < loops[l].size(); ++i)
      if (tips[l][i]) width = std::min(width, automatic_width_of(cusp_at(loops[l], tips[l], i), reference));
  const bool is_wide = width >= 1.1 * blunt_rules.least_width * reference;
  return is_wide ? fmt::format("give --blunt {:.2g} to cut {} off at that width", rounded_down(width), what)
                 : fmt::format("cut {} off in the drawing", what);
}

}  // namespace

void blunt_cusps(std::vector<Loop>& loops, const BluntOptions& options, std::vector<Repair>& repairs, Report& report) {
  if (options.width == 0) return;
  TipCutter cutter(loops, options);
  const double least = cutter.least_width();
  if (options.width != automatic_width && options.width < least)
    throw FormatError(
        fmt::format("{}: --blunt {:.3g} is less than 1e-5 of the diameter, and such edges are not kept: "
                    "give {:.2g} or more",
                    options.file, options.width, 1.1 * least));
  const size_t healed = repairs.size();
  loops = cutter.cut(repairs);
  cutter.warn(report);
  for (size_t i = healed; i < repairs.size(); ++i) report_repair(repairs[i], i, report);
  report.set("heal.repairs", repairs.size());
}

void refuse_contacts(const std::vector<Loop>& loops, const BluntOptions& options) {
  const Flags contacts = contacts_at_starts(loops);
  for (size_t l = 0; l < loops.size(); ++l)
    for (size_t i = 0; i < loops[l].size(); ++i) {
      if (!contacts[l][i]) continue;
      const Loop& loop = loops[l];
      throw FormatError(
          fmt::format("{}: the boundary touches itself at {}, where edges {} and {} meet: the face has a "
                      "width of zero there: {}, or draw them apart",
                      options.file, rounded_position_text(loop[i].curve.poles.front()), before(loop, i).cad_edge,
                      loop[i].cad_edge, blunt_remedy(loops, options, "the corners")));
    }
}

void refuse_cusps(const std::vector<Loop>& loops, const BluntOptions& options) {
  for (const Loop& loop : loops)
    for (size_t i = 0; i < loop.size(); ++i)
      if (starts_at_cusp(loop, i))
        throw FormatError(fmt::format("{}: {}, an angle of zero, which holds no quad: {}", options.file,
                                      tip_text(loop, i), blunt_remedy(loops, options, "its tip")));
}

}  // namespace quadrille::heal
