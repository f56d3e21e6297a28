#include "growth/limit_growth.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "growth/recount.hpp"
#include "growth/smooth_divisions.hpp"
#include "model/interfaces.hpp"
#include "sizing/interval_error.hpp"

namespace quadrille::growth {
namespace {

/// Part of the logarithm of what is aimed at from which on excess is weighted: against the other terms, some remains.
constexpr double excess_aim = 0.97;

double worst_ratio(const GrowthInput& input, const sizing::ArcDivisions& divisions) {
  double worst = 1;
  for (const IntervalPair& pair : adjacent_intervals(input, divisions))
    worst = std::max(worst, std::exp(std::abs(log_growth(input, divisions, pair))));
  return worst;
}

/// Whether no ratio exceeds this power of the limit.
bool is_within(const GrowthInput& input, double power, const sizing::ArcDivisions& divisions) {
  return worst_ratio(input, divisions) <= std::pow(input.limit, power) * (1 + growth_constants.equal_tol);
}

double num_elements(const BlockLayout& layout, const sizing::ArcDivisions& divisions) {
  double sum = 0;
  for (const auto& sides : layout.block2arcs)
    sum += 1.0 * divisions[sides[0].arc].num_intervals() * divisions[sides[1].arc].num_intervals();
  return sum;
}

/// The chords of the intervals that are too long beside a neighbour and have no neighbour that is too long beside them:
/// between a short and a long interval several may exceed the limit, and dividing the longest is the least change.
std::set<int> coarse_chords(const GrowthInput& input, const sizing::ArcDivisions& divisions) {
  const double most = std::log(input.limit * (1 + growth_constants.equal_tol));
  std::set<std::pair<int, int>> coarse, surpassed;  // arc, number
  for (const IntervalPair& pair : adjacent_intervals(input, divisions)) {
    const double growth = log_growth(input, divisions, pair);
    if (std::abs(growth) <= most) continue;
    const auto& [shorter, longer] = growth > 0 ? std::pair(pair.a, pair.b) : std::pair(pair.b, pair.a);
    if (is_layer(input, divisions, longer) || !input.may_raise(input.measured.chord_of(longer.arc))) continue;
    coarse.emplace(longer.arc, longer.k);
    surpassed.emplace(shorter.arc, shorter.k);
  }
  std::set<int> chords;
  for (const auto& interval : coarse)
    if (!surpassed.contains(interval)) chords.insert(input.measured.chord_of(interval.first));
  return chords;
}

bool misses_tolerance(const GrowthInput& input, int arc, const sizing::ArcDivision& division) {
  const sizing::MeasuredLayout& measured = input.measured;
  if (!is_on_cad_curve(measured.blocks(), measured.blocks().arcs[arc])) return false;
  for (int k = 0; k < division.num_intervals(); ++k)
    if (sizing::interval_error(measured.curves(), measured.chain(arc), division.low(k), division.high(k), input.order) >
        input.tolerance)
      return true;
  return false;
}

/// The excess over the limit has only as much weight as it takes: more skews the blocks.
void smooth_within_limit(const GrowthInput& input, const sizing::ArcDivisions& shape, sizing::ArcDivisions& divisions) {
  const double well_within = 1 - growth_constants.margin;
  DivisionSmoother smoother(input, shape);
  smoother.smooth({}, divisions);
  sizing::ArcDivisions sharper = divisions;
  const auto sharpen = [&](double weight, double power) {
    if (is_within(input, power, divisions)) return;
    smoother.smooth({weight, excess_aim * power}, sharper);
    if (worst_ratio(input, sharper) < worst_ratio(input, divisions)) divisions = sharper;
  };
  sharpen(growth_constants.excess_weights.front(), well_within);
  for (const double weight : growth_constants.excess_weights) sharpen(weight, 1);
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

GrowthOutcome limit_growth(const GrowthInput& input, sizing::ArcDivisions& divisions) {
  GrowthOutcome outcome;
  outcome.worst_before = worst_ratio(input, divisions);
  const BlockLayout& blocks = input.measured.blocks();
  const double most = growth_constants.most_refined * num_elements(blocks, divisions);
  sizing::ArcDivisions shape = divisions, now = divisions;
  std::set<int> raised;
  double least = 1e300;
  int best_round = 0;
  for (int round = 0; round < growth_constants.max_rounds && round <= best_round + growth_constants.patience; ++round) {
    smooth_within_limit(input, shape, now);
    std::set<int> chords = coarse_chords(input, now);
    const std::set<int> inaccurate = inaccurate_chords(input, now);
    const double worst = worst_ratio(input, now);
    if (inaccurate.empty() && worst < least * (1 - growth_constants.equal_tol)) {
      least = outcome.worst = worst;
      best_round = round;
      outcome.raised_chords = static_cast<int>(raised.size());
      divisions = now;
    }
    chords.insert(inaccurate.begin(), inaccurate.end());
    if (chords.empty() || !raise_counts(input, chords, shape, now, raised)) break;
    if (num_elements(blocks, now) > most) break;
  }
  if (least == 1e300) outcome.worst = outcome.worst_before;
  return outcome;
}

}  // namespace quadrille::growth
