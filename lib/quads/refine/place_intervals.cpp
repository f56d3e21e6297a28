#include "refine/place_intervals.hpp"

#include <algorithm>
#include <cmath>

namespace quadrille::refine {
namespace {

constexpr double no_break = -1;

/// The segments with their ends at the arc's own breaks, and the fractions of these breaks.
struct OwnSegments {
  sizing::Segments segments;
  std::vector<double> break_fractions;  ///< by end; no_break where another arc's break made it
};

OwnSegments own_segments(const AnchoredSegments& anchored, int i) {
  OwnSegments own{anchored.segments, std::vector<double>(anchored.segments.ends.size(), no_break)};
  for (std::size_t s = 0; s < anchored.required.size(); ++s)
    for (const Break& b : anchored.anchors[anchored.required[s]].breaks)
      if (b.arc == i) own.segments.ends[s + 1] = b.u, own.break_fractions[s + 1] = b.fraction;
  return own;
}

}  // namespace

PlacedIntervals place_intervals(const ChordTask& task, const ChordDivision& division, int i) {
  const std::vector<int>& counts = division.counts;
  const OwnSegments own = own_segments(division.anchored, i);
  const std::vector<double> v = sizing::interval_ends(own.segments, counts);
  std::vector<double> u, ends;
  for (const double position : v) u.push_back(division.grading.parameter(position));
  for (const double at : u) ends.push_back(task.measured.arc_fraction(task.chord, i, at));
  for (std::size_t s = 0, at = 0; s < counts.size(); at += counts[s++])
    if (own.break_fractions[s] >= 0) ends[at] = own.break_fractions[s];

  double longest = 0;
  for (std::size_t k = 1; k < u.size(); ++k) {
    // The factor by which the arc's own parameter stretches the interval, if no edge may be longer than planned.
    const double stretch = task.plan.is_bound ? std::abs(ends[k] - ends[k - 1]) / (u[k] - u[k - 1]) : 1;
    longest = std::max(longest, stretch * (v[k] - v[k - 1]));
  }
  if (task.chord.backwards[i]) std::reverse(ends.begin(), ends.end());
  return {{std::move(ends)}, longest * division.planned_count * task.chain(i).length() / division.longest_arc};
}

}  // namespace quadrille::refine
