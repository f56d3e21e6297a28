#include "simplify/chord_group.hpp"

#include <algorithm>
#include <map>
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

// Whether the curves around the ends of these arcs have the order of the topology.
bool are_drawn_in_order(const Subdivision& subdivision, const std::set<int>& arcs) {
  std::set<int> nodes;
  for (const int a : arcs) nodes.insert({subdivision.start({a}), subdivision.end({a})});
  return std::all_of(nodes.begin(), nodes.end(), [&](int n) { return graph::is_drawn_in_order(subdivision, n); });
}

std::set<int> all_arcs(const Subdivision& subdivision) {
  std::set<int> arcs;
  for (int a = 0; a < subdivision.arc_bound(); ++a) arcs.insert(arcs.end(), a);
  return arcs;
}

// The strip after the collapse of others that cross it.
bool collapse_one(Subdivision& subdivision, const ChordStrip& old_strip, const std::vector<Blend>& blends,
                  ArcChanges& changes) {
  int arc = -1;
  for (const HalfEdge h : old_strip.rungs)
    if (arc < 0) arc = changes.now(h.arc);
  if (arc < 0) return false;
  const ChordStrip strip = graph::strip_through(subdivision, arc);
  const std::vector<FixedSide> fixed = graph::fixed_sides(subdivision, strip);
  if (fixed.empty()) return false;
  const std::optional<ArcChanges> own = collapse_strip(subdivision, strip, fixed, blends);
  if (!own || !are_drawn_in_order(subdivision, own->changed)) return false;
  changes.add(*own);
  return true;
}

// The shortcut of a line after others were applied; splines keep their numbers.
bool shorten_one(int line, const Blend& blend, Shortened& trial) {
  const std::vector<SpiralShortcut> now =
      find_shortcuts(trial.subdivision, graph::arc_lengths(trial.subdivision.graph()));
  const auto found = std::find_if(now.begin(), now.end(), [&](const SpiralShortcut& s) { return s.spline == line; });
  if (found == now.end()) return false;
  std::optional<Subdivision> result = with_shortcut(trial.subdivision, *found, blend);
  if (!result || result->num_faces() >= trial.subdivision.num_faces() ||
      !graph::faces_without_four_corners(*result).empty() || !are_drawn_in_order(*result, all_arcs(*result)))
    return false;
  trial.subdivision = std::move(*result);
  return true;
}

}  // namespace

std::optional<std::vector<Blend>> blends_of_group(const field::FieldsOfRegions& fields, const Subdivision& subdivision,
                                                  const std::vector<ChordStrip>& strips, const BlendOptions& options) {
  if (share_a_rail(strips)) return std::nullopt;
  std::vector<Blend> blends;
  for (const ChordStrip& strip : strips) {
    const std::vector<FixedSide> fixed = graph::fixed_sides(subdivision, strip);
    if (fixed.empty()) return std::nullopt;
    auto own = blends_of(fields, subdivision, strip, fixed, options);
    if (!own) return std::nullopt;
    for (Blend& b : *own) blends.push_back(std::move(b));
  }
  return blends;
}

std::optional<ArcChanges> collapse_group(Subdivision& subdivision, const std::vector<ChordStrip>& strips,
                                         const std::vector<Blend>& blends) {
  ArcChanges changes;
  for (const ChordStrip& strip : strips)
    if (!collapse_one(subdivision, strip, blends, changes)) return std::nullopt;
  return changes;
}

double greatest_deviation(const std::vector<Blend>& blends) {
  double deviation = 0;
  for (const Blend& b : blends) deviation = std::max(deviation, b.deviation);
  return deviation;
}

std::optional<Shortened> shorten_group(const field::FieldsOfRegions& fields, const Subdivision& subdivision,
                                       const std::vector<SpiralShortcut>& shortcuts, const BlendOptions& options) {
  std::map<int, Blend> line2blend;
  for (const SpiralShortcut& s : shortcuts) {
    auto blend = blend_of(fields, subdivision.graph(), s, options);
    if (!blend || !line2blend.emplace(s.spline, std::move(*blend)).second) return std::nullopt;
  }
  Shortened trial{subdivision, 0};
  for (const auto& [line, blend] : line2blend) {
    if (!shorten_one(line, blend, trial)) return std::nullopt;
    trial.deviation = std::max(trial.deviation, blend.deviation);
  }
  return trial;
}

}  // namespace quadrille::simplify
