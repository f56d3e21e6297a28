#include "refine/divide_arcs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/tolerance.hpp"
#include "sizing/interval_error.hpp"

namespace quadrille::refine {
namespace {

struct CorrectionConstants {
  /// Of an interval's length. An element between two breaks, or a break and an end, that are nearer would be thin: it
  /// is made only if the tolerance cannot be met otherwise.
  double thin_part = 0.1;
  /// Factors by which an interval that misses the tolerance becomes shorter.
  double least_reduction = 1.05, greatest_reduction = 4;
};
constexpr CorrectionConstants correction_constants;

/// The number of intervals that should replace one.
double reduction(const DivideOptions& options, double error) {
  return std::min(correction_constants.greatest_reduction,
                  1.02 * std::pow(error / options.tolerance, 1.0 / (options.order + 1)));
}

int raised_count(const DivideOptions& options, int count, double error) {
  return std::max(count + 1, static_cast<int>(std::ceil(count * reduction(options, error) - 1e-6)));
}

std::size_t segment_of(const std::vector<int>& counts, int interval) {
  std::size_t s = 0;
  while (interval >= counts[s]) interval -= counts[s++];
  return s;
}

/// An anchor and the fraction of its break on one arc.
struct ArcBreak {
  int anchor = 0;
  double fraction = 0;
};

std::vector<ArcBreak> breaks_between(const std::vector<Anchor>& anchors, int i, double low, double high) {
  std::vector<ArcBreak> inside;
  for (std::size_t a = 0; a < anchors.size(); ++a)
    for (const Break& b : anchors[a].breaks)
      if (b.arc == i && b.fraction > low + tolerance::round_off && b.fraction < high - tolerance::round_off)
        inside.push_back({static_cast<int>(a), b.fraction});
  return inside;
}

/// Of breaks that are nearer to each other than `least_distance`, the one nearest to the middle; none so near to an
/// end.
std::vector<int> spaced(std::vector<ArcBreak> breaks, double low, double high, double least_distance) {
  const auto from_middle = [&](const ArcBreak& b) { return std::abs(2 * b.fraction - low - high); };
  std::stable_sort(breaks.begin(), breaks.end(),
                   [&](const ArcBreak& a, const ArcBreak& b) { return from_middle(a) < from_middle(b); });
  std::vector<double> taken{low, high};
  std::vector<int> anchors;
  for (const ArcBreak& b : breaks) {
    const auto is_near = [&](double f) { return std::abs(f - b.fraction) < least_distance; };
    if (std::any_of(taken.begin(), taken.end(), is_near)) continue;
    taken.push_back(b.fraction);
    anchors.push_back(b.anchor);
  }
  return anchors;
}

/// The part of an interval between the breaks that are near its ends.
std::pair<double, double> without_near_breaks(const std::vector<ArcBreak>& breaks, double low, double high,
                                              double least_distance) {
  std::pair<double, double> rest{low, high};
  for (const ArcBreak& b : breaks) {
    if (b.fraction < low + least_distance) rest.first = std::max(rest.first, b.fraction);
    if (b.fraction > high - least_distance) rest.second = std::min(rest.second, b.fraction);
  }
  return rest;
}

/// The anchors inside an interval of arc i at which elements should end; none if it is smooth, if its breaks are many
/// and spread, or if all are near its ends and the part between them misses the tolerance as well.
std::vector<int> anchors_that_end_elements(const ChordTask& task, const std::vector<Anchor>& anchors, int i, double low,
                                           double high) {
  const std::vector<ArcBreak> inside = breaks_between(anchors, i, low, high);
  if (inside.empty()) return {};
  const auto [first, last] = std::minmax_element(
      inside.begin(), inside.end(), [](const ArcBreak& a, const ArcBreak& b) { return a.fraction < b.fraction; });
  if (inside.size() > 2 && last->fraction - first->fraction > (high - low) / 2) return {};
  const double least_distance = correction_constants.thin_part * (high - low);
  if (std::vector<int> found = spaced(inside, low, high, least_distance); !found.empty()) return found;
  const auto [a, b] = without_near_breaks(inside, low, high, least_distance);
  if (sizing::interval_error(task.measured, task.chord.arcs[i], a, b, task.options.order) > task.options.tolerance)
    return {};
  return spaced(inside, low, high, 0);
}

sizing::MaxLengthConstraint constraint(const ChordTask& task, int i, double low, double high, double error) {
  const double a = task.measured.chord_parameter(task.chord, i, low);
  const double b = task.measured.chord_parameter(task.chord, i, high);
  const double factor = std::max(correction_constants.least_reduction, reduction(task.options, error));
  return {std::min(a, b), std::max(a, b), std::abs(b - a) / factor, factor};
}

void raise_counts(const Corrections& corrections, const DivideOptions& options, ChordDivision& division) {
  std::vector<int>& least = division.anchored.segments.least_counts;
  for (std::size_t s = 0; s < corrections.worst_errors.size(); ++s)
    if (const double worst = corrections.worst_errors[s]; worst > 0)
      least[s] = std::max(least[s], raised_count(options, division.counts[s], worst));
}

void refine_grading(const ChordTask& task, const std::vector<sizing::MaxLengthConstraint>& constraints,
                    ChordDivision& division) {
  const double slope = task.plan.slope > 0 ? task.plan.slope : std::numeric_limits<double>::infinity();
  division.grading = sizing::refine_grading(division.grading, division.count(), constraints, slope);
  division.planned_count = division.grading.count();
  division.least_count =
      static_cast<int>(std::min<double>(max_intervals + 1, std::ceil(division.planned_count * (1 - 1e-6))));
  move_breaks(division.anchored, [&](const Break& b) {
    return division.grading.cumulative(task.measured.chord_parameter(task.chord, b.arc, b.fraction));
  });
}

std::vector<sizing::ArcDivision> divide_chord(const ChordTask& task) {
  ChordDivision division = begin_division(task);
  do settle_counts(task, division);
  while (correct_misses(task, division));
  return std::move(division.arcs);
}

}  // namespace

Corrections find_corrections(const ChordTask& task, const ChordDivision& division, int i) {
  const sizing::ArcDivision& arc = division.arcs[i];
  Corrections found;
  found.worst_errors.assign(division.counts.size(), 0.0);
  for (int k = 0; k < arc.num_intervals(); ++k) {
    const double error =
        sizing::interval_error(task.measured, task.chord.arcs[i], arc.low(k), arc.high(k), task.options.order);
    if (error <= task.options.tolerance) continue;
    found.is_needed = true;
    const std::vector<int> anchors =
        anchors_that_end_elements(task, division.anchored.anchors, i, arc.low(k), arc.high(k));
    found.anchors.insert(found.anchors.end(), anchors.begin(), anchors.end());
    if (!anchors.empty()) continue;
    if (task.plan.slope == 0 && !task.options.shortens_single_intervals) {
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
  bool is_any = false, is_cut = false;
  std::vector<Corrections> all;
  std::vector<sizing::MaxLengthConstraint> constraints;
  for (int i = 0; i < task.num_arcs(); ++i) {
    if (!task.measured.is_on_cad_curve(task.chord.arcs[i])) continue;
    all.push_back(find_corrections(task, division, i));
    is_any |= all.back().is_needed;
    is_cut |= !all.back().anchors.empty();
    constraints.insert(constraints.end(), all.back().constraints.begin(), all.back().constraints.end());
  }
  for (const Corrections& corrections : all) {
    for (const int anchor : corrections.anchors) require_anchor(division.anchored, anchor);
    if (!is_cut) raise_counts(corrections, task.options, division);
  }
  if (!constraints.empty()) refine_grading(task, constraints, division);
  return is_any;
}

sizing::ArcDivisions divide_arcs(const sizing::MeasuredLayout& measured, const std::vector<sizing::ChordPlan>& plans,
                                 const DivideOptions& options, Progress* progress, const KnownDivisions& known) {
  sizing::ArcDivisions divisions(measured.num_arcs());
  const std::vector<mesh::Chord>& chords = measured.chords();
  const Progress::Part part(progress, "chords", static_cast<int>(chords.size()));
  for (std::size_t c = 0; c < chords.size(); ++c, part.advance()) {
    if (known.plans && (*known.plans)[c] == plans[c]) {
      for (const int arc : chords[c].arcs) divisions[arc] = (*known.divisions)[arc];
      continue;
    }
    std::vector<sizing::ArcDivision> divided = divide_chord({measured, chords[c], plans[c], options});
    for (std::size_t i = 0; i < divided.size(); ++i) divisions[chords[c].arcs[i]] = std::move(divided[i]);
  }
  return divisions;
}

int divided_count(const sizing::MeasuredLayout& measured, int chord, const sizing::ChordPlan& plan,
                  const DivideOptions& options) {
  return divide_chord({measured, measured.chords()[chord], plan, options})[0].num_intervals();
}

void match_fractions(const PeriodicArcs& arcs, std::vector<double>& first, std::vector<double>& second) {
  if (first.size() != second.size()) return;
  // With the face on the left of both, the image of the first runs against the second.
  const bool is_mirrored = arcs[0].is_backwards == arcs[1].is_backwards;
  const std::size_t count = first.size();
  for (std::size_t k = 1; k + 1 < count; ++k) {
    double& other = second[is_mirrored ? count - 1 - k : k];
    const double mean = (first[k] + (is_mirrored ? 1 - other : other)) / 2;
    first[k] = mean;
    other = is_mirrored ? 1 - mean : mean;
  }
}

void match_periodic(const std::vector<PeriodicArcs>& pairs, sizing::ArcDivisions& divisions,
                    std::vector<std::vector<double>>& layered_nodes) {
  for (const PeriodicArcs& arcs : pairs) {
    match_fractions(arcs, divisions[arcs[0].arc].ends, divisions[arcs[1].arc].ends);
    if (layered_nodes.empty()) continue;
    std::vector<double>&first = layered_nodes[arcs[0].arc], &second = layered_nodes[arcs[1].arc];
    if (first.size() == second.size())
      match_fractions(arcs, first, second);
    else
      first.clear(), second.clear();  // they follow from the divisions
  }
}

}  // namespace quadrille::refine
