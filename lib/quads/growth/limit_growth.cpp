#include "growth/limit_growth.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "base/tolerance.hpp"
#include "sizing/element_limit.hpp"
#include "sizing/grading.hpp"
#include "sizing/interval_error.hpp"

namespace quadrille::growth {
namespace {

/// The ends of an arc's intervals that no other count moves, by their numbers: the first and the last one, those of the
/// layers, and breaks.
std::vector<int> kept_ends(const GrowthInput& input, int arc, const sizing::ArcDivision& division) {
  const std::vector<double> fixed = fixed_fractions(input, arc);
  const int count = division.num_intervals(), low = input.num_layers(arc, 0), high = count - input.num_layers(arc, 1);
  std::vector<int> kept;
  for (int k = 0; k <= count; ++k)
    if (k <= low || k >= high || sizing::has_fraction(fixed, division.ends[k])) kept.push_back(k);
  return kept;
}

/// The parts between kept ends, with the sum of the present intervals as measure of each: a part with n intervals is as
/// long as n units. Layers are parts of one interval that gets no more.
struct Parts {
  std::vector<int> kept;
  sizing::Segments segments;  ///< of those that may get more
  std::vector<bool> is_layer;
};

Parts parts_of(const GrowthInput& input, int arc, const sizing::ArcDivision& division) {
  Parts parts{kept_ends(input, arc, division), {{0.0}, {}}, {}};
  const int count = division.num_intervals(), low = input.num_layers(arc, 0), high = count - input.num_layers(arc, 1);
  for (std::size_t i = 0; i + 1 < parts.kept.size(); ++i) {
    const int own = parts.kept[i + 1] - parts.kept[i];
    parts.is_layer.push_back(parts.kept[i] < low || parts.kept[i] >= high);
    if (parts.is_layer.back()) continue;
    parts.segments.ends.push_back(parts.segments.ends.back() + own);
    parts.segments.least_counts.push_back(1);
  }
  for (double& end : parts.segments.ends) end /= parts.segments.ends.back();
  return parts;
}

/// The end at a fraction of the present numbers of intervals between two kept ends.
double interpolated(const std::vector<double>& ends, int from, int to, double fraction) {
  const double position = from + fraction * (to - from);
  const int k = std::min(static_cast<int>(position), to - 1);
  return ends[k] + (position - k) * (ends[k + 1] - ends[k]);
}

sizing::ArcDivision divided_anew(const sizing::ArcDivision& division, const Parts& parts,
                                 const std::vector<int>& counts) {
  sizing::ArcDivision result{{division.ends.front()}};
  std::size_t next = 0;
  for (std::size_t i = 0; i + 1 < parts.kept.size(); ++i) {
    const int from = parts.kept[i], to = parts.kept[i + 1], count = parts.is_layer[i] ? 1 : counts[next++];
    for (int k = 1; k < count; ++k)
      result.ends.push_back(interpolated(division.ends, from, to, static_cast<double>(k) / count));
    result.ends.push_back(division.ends[to]);
  }
  return result;
}

/// No value if parts of an arc compete.
std::vector<sizing::ArcDivision> divided_chord(const GrowthInput& input, const std::vector<int>& arcs, int count,
                                               bool break_ties, const sizing::ArcDivisions& divisions) {
  std::vector<sizing::ArcDivision> result;
  for (const int arc : arcs) {
    const Parts parts = parts_of(input, arc, divisions[arc]);
    const int layers = input.num_layers(arc, 0) + input.num_layers(arc, 1);
    const int least = std::max(count, layers + parts.segments.least_count());
    const std::vector<int> counts = sizing::segment_counts(parts.segments, least - layers, break_ties);
    if (counts.empty()) return {};
    result.push_back(divided_anew(divisions[arc], parts, counts));
  }
  return result;
}

double worst_ratio(const GrowthInput& input, const sizing::ArcDivisions& divisions) {
  double worst = 1;
  for (const IntervalPair& pair : adjacent_intervals(input, divisions))
    worst = std::max(worst, std::exp(std::abs(log_growth(input, divisions, pair))));
  return worst;
}

/// The chords of the intervals that are too long beside a neighbour and have no neighbour that is too long beside them:
/// between a short and a long interval several may exceed the limit, and dividing the longest is the least change.
std::set<int> coarse_chords(const GrowthInput& input, const sizing::ArcDivisions& divisions) {
  const double most = std::log(input.limit * (1 + tolerance::tied));
  std::set<Interval> coarse, surpassed;
  for (const IntervalPair& pair : adjacent_intervals(input, divisions)) {
    const double growth = log_growth(input, divisions, pair);
    if (std::abs(growth) <= most) continue;
    const auto& [shorter, longer] = growth > 0 ? std::pair(pair.a, pair.b) : std::pair(pair.b, pair.a);
    if (is_layer(input, divisions, longer) || !input.may_raise(input.measured.chord_of(longer.arc))) continue;
    coarse.insert(longer);
    surpassed.insert(shorter);
  }
  std::set<int> chords;
  for (const Interval& interval : coarse)
    if (!surpassed.contains(interval)) chords.insert(input.measured.chord_of(interval.arc));
  return chords;
}

bool misses_tolerance(const GrowthInput& input, int arc, const sizing::ArcDivision& division) {
  if (!input.measured.is_on_cad_curve(arc)) return false;
  for (int k = 0; k < division.num_intervals(); ++k)
    if (sizing::interval_error(input.measured, arc, division.low(k), division.high(k), input.order) > input.tolerance)
      return true;
  return false;
}

/// The excess over the limit has only as much weight as it takes: more skews the blocks.
void smooth_within_limit(const GrowthInput& input, const sizing::ArcDivisions& shape, sizing::ArcDivisions& divisions) {
  DivisionSmoother smoother(input, shape);
  smoother.smooth({}, divisions);
  sizing::ArcDivisions sharper = divisions;
  for (const double weight : growth_constants.excess_weights) {
    const double worst = worst_ratio(input, divisions);
    if (worst <= input.limit * (1 + tolerance::tied)) return;
    smoother.smooth({weight, growth_constants.excess_aim}, sharper);
    if (worst_ratio(input, sharper) < worst) divisions = sharper;
  }
}

std::set<int> inaccurate_chords(const GrowthInput& input, const sizing::ArcDivisions& divisions) {
  std::set<int> chords;
  for (int arc = 0; arc < input.measured.num_arcs(); ++arc)
    if (misses_tolerance(input, arc, divisions[arc])) chords.insert(input.measured.chord_of(arc));
  return chords;
}

/// The intervals between the layers on the arc of a chord that has the fewest.
int num_free(const GrowthInput& input, int chord, int count) {
  int layers = 0;
  for (const int arc : input.measured.chords()[chord].arcs)
    layers = std::max(layers, input.num_layers(arc, 0) + input.num_layers(arc, 1));
  return count - layers;
}

/// Returns whether any count rose.
bool raise_counts(const GrowthInput& input, const std::set<int>& chords, sizing::ArcDivisions& shape,
                  sizing::ArcDivisions& divisions, std::set<int>& raised) {
  bool any = false;
  for (const int chord : chords) {
    if (!input.may_raise(chord)) continue;
    const int before = divisions[input.measured.chords()[chord].arcs.front()].num_intervals();
    const int count =
        before + std::max(1, static_cast<int>(std::ceil(growth_constants.raise * num_free(input, chord, before))));
    sizing::ArcDivisions anew = divisions;
    const int reached = recount_chord(input, chord, count, anew);
    divisions = anew;
    recount_chord(input, chord, reached, shape);
    raised.insert(chord);
    any = true;
  }
  return any;
}

}  // namespace

int recount_chord(const GrowthInput& input, int chord, int count, sizing::ArcDivisions& divisions) {
  const std::vector<int>& arcs = input.measured.chords()[chord].arcs;
  for (int i = 0;; ++i) {
    const bool is_last = i == growth_constants.max_tie_tries;
    const std::vector<sizing::ArcDivision> divided =
        divided_chord(input, arcs, is_last ? count : count + i, is_last, divisions);
    if (divided.empty()) continue;
    for (std::size_t k = 0; k < arcs.size(); ++k) divisions[arcs[k]] = divided[k];
    return divisions[arcs.front()].num_intervals();
  }
}

GrowthOutcome limit_growth(const GrowthInput& input, sizing::ArcDivisions& divisions) {
  GrowthOutcome outcome;
  outcome.worst_before = worst_ratio(input, divisions);
  const BlockLayout& blocks = input.measured.blocks();
  const double most = growth_constants.most_refined * sizing::num_divided(blocks, divisions);
  sizing::ArcDivisions shape = divisions, now = divisions;
  std::set<int> raised;
  double least = 1e300;
  int best_round = 0;
  for (int round = 0; round < growth_constants.max_rounds && round <= best_round + growth_constants.patience; ++round) {
    smooth_within_limit(input, shape, now);
    std::set<int> chords = coarse_chords(input, now);
    const std::set<int> inaccurate = inaccurate_chords(input, now);
    const double worst = worst_ratio(input, now);
    if (inaccurate.empty() && worst < least * (1 - tolerance::tied)) {
      least = outcome.worst = worst;
      best_round = round;
      outcome.raised_chords = static_cast<int>(raised.size());
      divisions = now;
    }
    chords.insert(inaccurate.begin(), inaccurate.end());
    if (chords.empty() || !raise_counts(input, chords, shape, now, raised)) break;
    if (sizing::num_divided(blocks, now) > most) break;
  }
  if (least == 1e300) outcome.worst = outcome.worst_before;
  return outcome;
}

}  // namespace quadrille::growth
