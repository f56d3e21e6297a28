#include "refine/chord_division.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "surface/positions.hpp"

namespace quadrille::refine {
namespace {

bool has_two_of_one_arc(const std::vector<Break>& breaks) {
  std::set<int> arcs;
  return std::any_of(breaks.begin(), breaks.end(), [&](const Break& b) { return !arcs.insert(b.arc).second; });
}

Anchor anchor_of(std::vector<Break> breaks) {
  double sum = 0;
  for (const Break& b : breaks) sum += b.u;
  return {sum / static_cast<double>(breaks.size()), std::move(breaks)};
}

/// The segments with their ends at the arc's own breaks, and the fractions of these breaks.
struct OwnSegments {
  sizing::Segments segments;
  std::vector<double> break_fractions;  ///< by end; -1 where another arc's break made it
};

OwnSegments own_segments(const AnchoredSegments& anchored, int i) {
  OwnSegments own{anchored.segments, std::vector<double>(anchored.segments.ends.size(), -1)};
  for (std::size_t s = 0; s < anchored.required.size(); ++s)
    for (const Break& b : anchored.anchors[anchored.required[s]].breaks)
      if (b.arc == i) own.segments.ends[s + 1] = b.u, own.break_fractions[s + 1] = b.fraction;
  return own;
}

struct DivisionConstants {
  double length_slack = 1.25;  ///< by which an interval may be longer than planned if segments do not divide well
  double anchor_reach = 0.5;   ///< of an interval, within which breaks of opposite arcs have one anchor
  int max_tie_rounds = 24;     ///< increments of a chord's count in search of a symmetric division
};
constexpr DivisionConstants division_constants;

/// Two elements must not have two common edges, and no element may be its own neighbour.
int least_topological_count(const sizing::MeasuredLayout& measured, int arc) {
  const GraphArc& a = measured.blocks().arcs[arc];
  return a.from == a.to ? 3 : measured.is_parallel(arc) ? 2 : 1;
}

void require_bounded(const ChordTask& task, int count, const char* cause, const char* remedy) {
  if (count <= max_intervals) return;
  const CadFace& face = task.measured.blocks().face;
  throw ComputeError(fmt::format("{} requires more than {} elements along the arc through {}: {}", cause, max_intervals,
                                 surface::position_text(face, task.chain(0).at(0.5).position), remedy));
}

int first_count(const ChordTask& task) {
  int count = task.plan.count;
  for (const int arc : task.chord.arcs) count = std::max(count, least_topological_count(task.measured, arc));
  require_bounded(task, count, "the prescribed size", "raise --size");
  return count;
}

std::vector<Break> boundary_breaks(const ChordTask& task, const sizing::Grading& grading) {
  std::vector<Break> breaks;
  for (int i = 0; i < task.num_arcs(); ++i)
    if (task.measured.is_on_cad_curve(task.chord.arcs[i]))
      for (const double f : task.chain(i).break_fractions())
        breaks.push_back({grading.cumulative(task.measured.chord_parameter(task.chord, i, f)), f, i});
  return breaks;
}

/// Whether a curve of a given name ends at the break: no edge may belong to both curves.
bool is_at_name_joint(const ChordTask& task, const Break& b) {
  return sizing::has_fraction(task.measured.name_joints(task.chord.arcs[b.arc]), b.fraction);
}

/// Tries a count: fills in counts and arcs, and returns the count if it suits all arcs, else one to try after it.
int try_count(const ChordTask& task, ChordDivision& division, int count, bool break_ties) {
  division.counts = sizing::segment_counts(division.anchored.segments, count, break_ties);
  if (division.counts.empty()) return count + 1;
  double longest = 0;
  for (int i = 0; i < task.num_arcs(); ++i) {
    PlacedIntervals placed = place_intervals(task, division, i);
    division.arcs[i] = std::move(placed.division);
    longest = std::max(longest, placed.longest);
  }
  if (longest <= division_constants.length_slack + tolerance::round_off || task.plan.is_prescribed) return count;
  return count + std::max(1, count / 100);
}

}  // namespace

std::vector<Anchor> find_anchors(std::vector<Break> breaks, double reach) {
  std::sort(breaks.begin(), breaks.end(),
            [](const Break& a, const Break& b) { return std::tie(a.u, a.arc) < std::tie(b.u, b.arc); });
  std::vector<Anchor> anchors;
  for (std::size_t first = 0, last = 0; first < breaks.size(); first = last) {
    for (last = first + 1; last < breaks.size() && breaks[last].u - breaks[last - 1].u < reach;) ++last;
    std::vector<Break> group(breaks.begin() + first, breaks.begin() + last);
    if (!has_two_of_one_arc(group)) {
      anchors.push_back(anchor_of(std::move(group)));
    } else {
      const std::vector<Anchor> parts = find_anchors(std::move(group), reach / 2);
      anchors.insert(anchors.end(), parts.begin(), parts.end());
    }
  }
  return anchors;
}

void require_anchor(AnchoredSegments& anchored, int anchor) {
  std::vector<int>& required = anchored.required;
  const auto at = std::lower_bound(required.begin(), required.end(), anchor) - required.begin();
  if (at < std::ssize(required) && required[at] == anchor) return;
  required.insert(required.begin() + at, anchor);
  sizing::Segments& segments = anchored.segments;
  segments.ends.insert(segments.ends.begin() + at + 1, anchored.anchors[anchor].u);
  segments.least_counts[at] = 1;
  segments.least_counts.insert(segments.least_counts.begin() + at + 1, 1);
}

void move_breaks(AnchoredSegments& anchored, const std::function<double(const Break&)>& position) {
  for (Anchor& anchor : anchored.anchors) {
    anchor.u = 0;
    for (Break& b : anchor.breaks) {
      b.u = position(b);
      anchor.u += b.u / static_cast<double>(anchor.breaks.size());
    }
  }
  for (std::size_t s = 0; s < anchored.required.size(); ++s)
    anchored.segments.ends[s + 1] = anchored.anchors[anchored.required[s]].u;
}

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

ChordDivision begin_division(const ChordTask& task) {
  ChordDivision division;
  division.grading = task.plan.grading;
  division.planned_count = std::min<double>(task.plan.count, task.plan.grading.count());
  division.least_count = first_count(task);
  for (int i = 0; i < task.num_arcs(); ++i)
    division.longest_arc = std::max(division.longest_arc, task.chain(i).length());
  division.arcs.resize(task.num_arcs());
  AnchoredSegments& anchored = division.anchored;
  anchored.anchors =
      find_anchors(boundary_breaks(task, division.grading), division_constants.anchor_reach / division.least_count);
  for (std::size_t a = 0; a < anchored.anchors.size(); ++a) {
    const std::vector<Break>& breaks = anchored.anchors[a].breaks;
    if (std::any_of(breaks.begin(), breaks.end(), [&](const Break& b) { return is_at_name_joint(task, b); }))
      require_anchor(anchored, static_cast<int>(a));
  }
  return division;
}

void settle_counts(const ChordTask& task, ChordDivision& division) {
  const int first = std::max(division.least_count, division.anchored.segments.least_count());
  const bool may_break_ties = task.plan.is_prescribed && task.plan.is_by_user;
  for (int count = first;;) {
    require_bounded(task, count, "the geometric tolerance", "raise --geometry-tol or --order");
    const int next =
        try_count(task, division, count, may_break_ties || count - first >= division_constants.max_tie_rounds);
    if (next == count) return;
    count = next;
  }
}

}  // namespace quadrille::refine
