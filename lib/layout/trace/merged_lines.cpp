#include "trace/merged_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/position_text.hpp"
#include "graph/family_order.hpp"

namespace quadrille::trace {
namespace {

constexpr std::size_t many_lines = 500;

[[noreturn]] void fail_endless(const CadFace& face, const Streamline& line) {
  const size_t count = line.steps.size();
  const std::string steps = count < max_stream_steps ? "" : fmt::format(" and {} steps, the most allowed", count);
  throw ComputeError(
      fmt::format("the separatrix from {} at {:.2f} degrees has reached neither boundary "
                  "nor node after {:.3g} diameters{}, near {}",
                  position_text(line.launch.origin + face.origin), degrees(wrap_pi(line.launch.angle)),
                  line.length() / face.diameter, steps, position_text(line.end_position + face.origin)));
}

}  // namespace

MergedLines::MergedLines(const field::FieldEvaluator& evaluator, const std::vector<Streamline>& lines,
                         const std::vector<Vec2>& nodes, double merge_angle, double merge_distance, LineEnds ends,
                         const LineBounds& bounds)
    : evaluator_(evaluator),
      lines_(lines),
      ends_(ends),
      max_crossings_(bounds.max_crossings),
      plan_(evaluator, lines, nodes, {std::max(merge_angle, same_line_angle), merge_distance}, bounds.reach),
      fitter_(evaluator, lines) {}

bool MergedLines::merge(Progress* progress) {
  do {
    if (ends_ == LineEnds::optional) {
      arrangement_.chosen = plan_.choose_by_rules();
    } else {
      const std::optional<std::vector<int>> chosen = plan_.choose();
      if (!chosen) {
        if (const auto stuck = plan_.stuck_without_partner()) fail_endless(face(), lines_[*stuck]);
        return false;
      }
      arrangement_.chosen = *chosen;
    }
    arrange(progress);
  } while (reject_crossing_merges());
  require_family_order();
  return true;
}

bool MergedLines::reject_worst(const std::vector<int>& merges, double least_deviation) {
  if (!plan_.reject_worst(merges, least_deviation)) return false;
  // Lines that stop at others may be continued later: no other pass of such a pair may be merged then.
  if (ends_ == LineEnds::optional) plan_.reject_whole_pairs();
  return true;
}

// The worst of all; among many lines, the worse one at every crossing, as these are far from each other.
bool MergedLines::reject_crossing_merges() {
  std::vector<int> all;
  bool any = false;
  for (const graph::Crossing& c : arrangement_.inner_crossings) {
    if (!graph::is_of_one_family(c)) continue;
    std::vector<int> merges;
    for (const int i : {c.a, c.b})
      if (arrangement_.lines[i].merge >= 0) merges.push_back(arrangement_.lines[i].merge);
    all.insert(all.end(), merges.begin(), merges.end());
    if (lines_.size() > many_lines) any = plan_.reject_worst(merges, 0) || any;
  }
  if (lines_.size() <= many_lines) return reject_worst(all, 0);
  if (any && ends_ == LineEnds::optional) plan_.reject_whole_pairs();
  return any;
}

void MergedLines::arrange(Progress* progress) {
  const Progress::Part fitted(progress, "fitted lines", std::ssize(lines_));
  const std::vector<int> merge_of = plan_.merge_of_lines(arrangement_.chosen);
  arrangement_.lines.clear();
  for (int i = 0; i < static_cast<int>(lines_.size()); ++i, fitted.advance()) {
    const int c = merge_of[i];
    if (c >= 0 && plan_.candidate(c).b == i) continue;
    if (c < 0 && ends_ == LineEnds::required && lines_[i].is_endless()) fail_endless(face(), lines_[i]);
    arrangement_.lines.push_back(c >= 0 ? fitter_.pair(plan_.candidate(c), c) : fitter_.single(i));
  }
  std::vector<graph::CurveKey> keys;
  std::vector<Nurbs> splines;
  for (const MergedLine& m : arrangement_.lines) {
    keys.push_back(m.key);
    splines.push_back(m.line.spline);
  }
  arrangement_.crossings = cache_.find(keys, splines, relative_snap_tol * face().diameter,
                                       {.max_crossings = max_crossings_, .origin = face().origin, .sought = {}});
  arrangement_.inner_crossings.clear();
  for (const graph::Crossing& c : arrangement_.crossings)
    if (!is_common_end(c)) arrangement_.inner_crossings.push_back(c);
}

bool MergedLines::is_common_end(const graph::Crossing& crossing) const {
  const double near = 2 * (relative_snap_tol * face().diameter);
  const auto ends_there = [&](int i) {
    const Nurbs& spline = arrangement_.lines[i].line.spline;
    return distance(spline.poles.front(), crossing.position) <= near ||
           distance(spline.poles.back(), crossing.position) <= near;
  };
  return ends_there(crossing.a) && ends_there(crossing.b);
}

void MergedLines::require_family_order() const {
  std::vector<bool> is_exempt;  // cuts that stop at each other may start on two sides and be one line
  for (const MergedLine& m : arrangement_.lines)
    is_exempt.push_back(m.merge >= 0 || (ends_ == LineEnds::optional && m.line.kind == LineKind::cut));
  graph::require_family_order(arrangement_.inner_crossings, is_exempt, face().origin);
}

double MergedLines::largest_deviation() const {
  double deviation = 0;
  for (const int c : arrangement_.chosen) deviation = std::max(deviation, plan_.candidate(c).deviation);
  return deviation;
}

}  // namespace quadrille::trace
