#include "refine/correct_misses.hpp"

#include <algorithm>
#include <cmath>

#include "sizing/interval_error.hpp"

namespace quadrille::refine {
namespace {

constexpr double same_fraction = 1e-9;
/// An interval that misses the tolerance becomes shorter by this factor at least.
constexpr double least_reduction = 1.05;
constexpr double greatest_reduction = 4;

/// The number of intervals that should replace one.
double reduction(const DivideOptions& options, double error) {
  return std::min(greatest_reduction, 1.02 * std::pow(error / options.tolerance, 1.0 / (options.order + 1)));
}

int raised_count(const DivideOptions& options, int count, double error) {
  return std::max(count + 1, static_cast<int>(std::ceil(count * reduction(options, error) - 1e-6)));
}

std::size_t segment_of(const std::vector<int>& counts, int interval) {
  std::size_t s = 0;
  while (interval >= counts[s]) interval -= counts[s++];
  return s;
}

/// The anchors inside an interval of arc i at which elements should end; none if it is smooth, or if its breaks are
/// many and spread.
std::vector<int> curing_anchors(const std::vector<Anchor>& anchors, int i, double low, double high) {
  std::vector<int> inside;
  std::vector<double> fractions;
  for (std::size_t a = 0; a < anchors.size(); ++a)
    for (const Break& b : anchors[a].breaks)
      if (b.arc == i && b.fraction > low + same_fraction && b.fraction < high - same_fraction) {
        inside.push_back(static_cast<int>(a));
        fractions.push_back(b.fraction);
      }
  if (inside.empty()) return {};
  const auto [first, last] = std::minmax_element(fractions.begin(), fractions.end());
  if (inside.size() > 2 && *last - *first > (high - low) / 2) return {};
  return inside;
}

sizing::MaxLengthConstraint constraint(const ChordTask& task, int i, double low, double high, double error) {
  const double a = task.measured.chord_parameter(task.chord, i, low);
  const double b = task.measured.chord_parameter(task.chord, i, high);
  const double factor = std::max(least_reduction, reduction(task.options, error));
  return {std::min(a, b), std::max(a, b), std::abs(b - a) / factor, factor};
}

/// Segments keep the numbers from the last settle_counts, also if an earlier arc has cut one since: then more elements
/// may be added to another segment in this round, which the next round corrects.
void apply(const Corrections& corrections, const DivideOptions& options, ChordDivision& division) {
  std::vector<int>& least = division.anchored.segments.least_counts;
  for (std::size_t s = 0; s < corrections.worst_errors.size(); ++s)
    if (const double worst = corrections.worst_errors[s]; worst > 0)
      least[s] = std::max(least[s], raised_count(options, division.counts[s], worst));
  for (const int anchor : corrections.anchors) require_anchor(division.anchored, anchor);
}

void refine_grading(const ChordTask& task, const std::vector<sizing::MaxLengthConstraint>& constraints,
                    ChordDivision& division) {
  division.grading = sizing::refine_grading(division.grading, division.count(), constraints, task.plan.slope);
  division.planned_count = division.grading.count();
  division.least_count =
      static_cast<int>(std::min<double>(max_intervals + 1, std::ceil(division.planned_count * (1 - 1e-6))));
  move_breaks(division.anchored, [&](const Break& b) {
    return division.grading.cumulative(task.measured.chord_parameter(task.chord, b.arc, b.fraction));
  });
}

}  // namespace

Corrections find_corrections(const ChordTask& task, const ChordDivision& division, int i) {
  const sizing::ArcDivision& arc = division.arcs[i];
  Corrections found;
  found.worst_errors.assign(division.counts.size(), 0.0);
  for (int k = 0; k < arc.num_intervals(); ++k) {
    const double error =
        sizing::interval_error(task.measured.curves(), task.chain(i), arc.low(k), arc.high(k), task.options.order);
    if (error <= task.options.tolerance) continue;
    found.is_needed = true;
    const std::vector<int> anchors = curing_anchors(division.anchored.anchors, i, arc.low(k), arc.high(k));
    found.anchors.insert(found.anchors.end(), anchors.begin(), anchors.end());
    if (!anchors.empty()) continue;
    if (division.grading.is_identity()) {
      const int along_chord = task.chord.backwards[i] ? arc.num_intervals() - 1 - k : k;
      double& worst = found.worst_errors[segment_of(division.counts, along_chord)];
      worst = std::max(worst, error);
    } else {
      found.constraints.push_back(constraint(task, i, arc.low(k), arc.high(k), error));
    }
  }
  return found;
}

bool correct_misses(const ChordTask& task, ChordDivision& division) {
  bool is_any = false;
  std::vector<sizing::MaxLengthConstraint> constraints;
  for (int i = 0; i < task.num_arcs(); ++i) {
    if (!task.arc(i).is_boundary) continue;
    const Corrections corrections = find_corrections(task, division, i);
    is_any |= corrections.is_needed;
    apply(corrections, task.options, division);
    constraints.insert(constraints.end(), corrections.constraints.begin(), corrections.constraints.end());
  }
  if (!constraints.empty()) refine_grading(task, constraints, division);
  return is_any;
}

}  // namespace quadrille::refine
