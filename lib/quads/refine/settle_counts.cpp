#include "refine/settle_counts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/position_text.hpp"
#include "model/interfaces.hpp"
#include "refine/place_intervals.hpp"
#include "sizing/name_joints.hpp"

namespace quadrille::refine {
namespace {

constexpr double same_fraction = 1e-9;
/// An interval may be longer than planned by this factor if segments between breaks do not divide well.
constexpr double length_slack = 1.25 + 1e-9;
/// Breaks of opposite arcs have one anchor if they lie within this fraction of an interval.
constexpr double anchor_reach = 0.5;
/// Greatest number of increments of a chord's count in search of a symmetric division.
constexpr int max_tie_rounds = 24;

/// Two elements must not have two common edges, and no element may be its own neighbour.
int least_topological_count(const sizing::MeasuredLayout& measured, int arc) {
  const GraphArc& a = measured.blocks().arcs[arc];
  return a.from == a.to ? 3 : measured.is_parallel(arc) ? 2 : 1;
}

void require_bounded(const ChordTask& task, int count, const char* cause, const char* remedy) {
  if (count <= max_intervals) return;
  const Vec2 position = task.chain(0).at(0.5).position + task.measured.blocks().face.origin;
  throw ComputeError(fmt::format("{} requires more than {} elements along the arc through {}: {}", cause, max_intervals,
                                 position_text(position), remedy));
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
    if (is_on_cad_curve(task.measured.blocks(), task.arc(i)))
      for (const double f : task.chain(i).break_fractions())
        breaks.push_back({grading.cumulative(task.measured.chord_parameter(task.chord, i, f)), f, i});
  return breaks;
}

/// Whether a curve of a given name ends at the break: no edge may belong to both curves.
bool is_at_name_joint(const ChordTask& task, const Break& b) {
  const std::vector<double> joints = sizing::name_joints(task.chain(b.arc), task.measured.blocks().face);
  return std::any_of(joints.begin(), joints.end(),
                     [&](double joint) { return std::abs(joint - b.fraction) < same_fraction; });
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
  if (longest <= length_slack || task.plan.is_prescribed) return count;
  return count + std::max(1, count / 100);
}

}  // namespace

ChordDivision begin_division(const ChordTask& task) {
  ChordDivision division;
  division.grading = task.plan.grading;
  division.planned_count = std::min<double>(task.plan.count, task.plan.grading.count());
  division.least_count = first_count(task);
  for (int i = 0; i < task.num_arcs(); ++i)
    division.longest_arc = std::max(division.longest_arc, task.chain(i).length());
  division.arcs.resize(task.num_arcs());
  AnchoredSegments& anchored = division.anchored;
  anchored.anchors = find_anchors(boundary_breaks(task, division.grading), anchor_reach / division.least_count);
  for (std::size_t a = 0; a < anchored.anchors.size(); ++a) {
    const std::vector<Break>& breaks = anchored.anchors[a].breaks;
    if (std::any_of(breaks.begin(), breaks.end(), [&](const Break& b) { return is_at_name_joint(task, b); }))
      require_anchor(anchored, static_cast<int>(a));
  }
  return division;
}

void settle_counts(const ChordTask& task, ChordDivision& division) {
  const int first = std::max(division.least_count, division.anchored.segments.least_count());
  for (int count = first;;) {
    require_bounded(task, count, "the geometric tolerance", "raise --geometry-tol or --order");
    const int next = try_count(task, division, count, task.plan.is_prescribed || count - first >= max_tie_rounds);
    if (next == count) return;
    count = next;
  }
}

}  // namespace quadrille::refine
