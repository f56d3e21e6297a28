#include "simplify/chord_group.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "graph/face_corners.hpp"

namespace quadrille::simplify {
namespace {

using graph::ChordStrip;
using graph::FixedSide;
using graph::Subdivision;

bool share_a_rail(const std::vector<ChordStrip>& strips) {
  std::set<int> rails;
  for (const ChordStrip& strip : strips)
    for (const std::vector<HalfEdge>* half_edges : {&strip.left, &strip.right})
      for (const HalfEdge h : *half_edges)
        if (!rails.insert(h.arc).second) return true;
  return false;
}

// Whether the curves around the ends of the marked arcs have the order of the topology.
bool are_drawn_in_order(const Subdivision& subdivision, const std::vector<bool>& is_marked) {
  std::set<int> nodes;
  for (int a = 0; a < subdivision.arc_bound(); ++a)
    if (is_marked[a]) nodes.insert({subdivision.start({a}), subdivision.end({a})});
  return std::all_of(nodes.begin(), nodes.end(), [&](int n) { return graph::is_drawn_in_order(subdivision, n); });
}

// The strip after the collapse of others that cross it.
bool collapse_one(const ChordStrip& old_strip, const std::vector<Blend>& blends, Trial& trial) {
  int arc = -1;
  for (const HalfEdge h : old_strip.rungs)
    if (arc < 0) arc = trial.arc2arc[h.arc];
  if (arc < 0) return false;
  const ChordStrip strip = graph::strip_through(trial.subdivision, arc);
  const std::vector<FixedSide> fixed = graph::fixed_sides(trial.subdivision, strip);
  if (fixed.empty()) return false;
  std::optional<ArcChanges> changes = collapse_strip(trial.subdivision, strip, fixed, blends);
  if (!changes || !are_drawn_in_order(trial.subdivision, changes->is_changed)) return false;
  for (std::size_t a = 0; a < trial.is_changed.size(); ++a)
    if (trial.is_changed[a] && changes->arc2arc[a] >= 0) changes->is_changed[changes->arc2arc[a]] = true;
  trial.is_changed = std::move(changes->is_changed);
  for (int& a : trial.arc2arc)
    if (a >= 0) a = changes->arc2arc[a];
  return true;
}

// The shortcut of a line after others were applied; splines keep their numbers.
bool shorten_one(int line, const Blend& blend, Trial& trial) {
  const std::vector<SpiralShortcut> now =
      find_shortcuts(trial.subdivision, graph::arc_lengths(trial.subdivision.graph()));
  const auto found = std::find_if(now.begin(), now.end(), [&](const SpiralShortcut& s) { return s.spline == line; });
  if (found == now.end()) return false;
  std::optional<Subdivision> result = with_shortcut(trial.subdivision, *found, blend);
  if (!result || result->num_faces() >= trial.subdivision.num_faces() ||
      !graph::faces_without_four_corners(*result).empty() ||
      !are_drawn_in_order(*result, std::vector<bool>(result->arc_bound(), true)))
    return false;
  trial.subdivision = std::move(*result);
  return true;
}

}  // namespace

std::optional<Trial> collapse_group(const field::FieldEvaluator& evaluator, const Subdivision& subdivision,
                                    const std::vector<ChordStrip>& strips, const BlendOptions& options) {
  if (share_a_rail(strips)) return std::nullopt;
  std::vector<Blend> blends;
  for (const ChordStrip& strip : strips) {
    const std::vector<FixedSide> fixed = graph::fixed_sides(subdivision, strip);
    if (fixed.empty()) return std::nullopt;
    auto own = blends_of(evaluator, subdivision, strip, fixed, options);
    if (!own) return std::nullopt;
    for (Blend& b : *own) blends.push_back(std::move(b));
  }
  Trial trial{subdivision, std::vector<int>(subdivision.arc_bound()), std::vector<bool>(subdivision.arc_bound(), false),
              0};
  std::iota(trial.arc2arc.begin(), trial.arc2arc.end(), 0);
  for (const ChordStrip& strip : strips)
    if (!collapse_one(strip, blends, trial)) return std::nullopt;
  for (const Blend& b : blends) trial.deviation = std::max(trial.deviation, b.deviation);
  return trial;
}

std::optional<Trial> shorten_group(const field::FieldEvaluator& evaluator, const Subdivision& subdivision,
                                   const std::vector<SpiralShortcut>& shortcuts, const BlendOptions& options) {
  std::map<int, Blend> line2blend;
  for (const SpiralShortcut& s : shortcuts) {
    auto blend = blend_of(evaluator, subdivision.graph(), s, options);
    if (!blend || !line2blend.emplace(s.spline, std::move(*blend)).second) return std::nullopt;
  }
  Trial trial{subdivision, {}, {}, 0};
  for (const auto& [line, blend] : line2blend) {
    if (!shorten_one(line, blend, trial)) return std::nullopt;
    trial.deviation = std::max(trial.deviation, blend.deviation);
  }
  return trial;
}

}  // namespace quadrille::simplify
