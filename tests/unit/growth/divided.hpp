#pragma once
// Divided arcs of small layouts.

#include <algorithm>
#include <cmath>
#include <vector>

#include "../hand_made.hpp"
#include "block/extract_blocks.hpp"
#include "growth/smooth_divisions.hpp"
#include "refine/divide_arcs.hpp"
#include "sizing/grade_chords.hpp"

namespace quadrille::growth {

/// `counts`: by block, of its sides 0 and 2.
struct Divided {
  Divided(const SeparatrixGraph& graph, double size, const std::vector<int>& counts = {})
      : layout(block::extract_blocks(graph, report)), measured(layout) {
    std::vector<sizing::ChordCount> prescribed;
    for (std::size_t block = 0; block < counts.size(); ++block)
      prescribed.push_back({measured.chord_of(layout.block2arcs[block][0].arc), counts[block]});
    const auto plans = sizing::grade_chords(measured, sizing::SizeField(size), sizing::SizeRule::nearest, prescribed);
    divisions = refine::divide_arcs(measured, plans, {4, 1e-3});
  }
  GrowthInput input(double limit = 1.3) const { return {measured, limit, 4, 1e-3}; }
  int arc(int block, int side) const { return layout.block2arcs[block][side].arc; }
  int count(int block) const { return divisions[arc(block, 0)].num_intervals(); }
  double length(int block, int k) const {
    const sizing::ArcDivision& bottom = divisions[arc(block, 0)];
    return (bottom.high(k) - bottom.low(k)) * measured.length(arc(block, 0));
  }

  Report report;
  BlockLayout layout;
  sizing::MeasuredLayout measured;
  sizing::ArcDivisions divisions;
};

inline double greatest_ratio(const Divided& d, const sizing::ArcDivisions& divisions) {
  double greatest = 1;
  for (const IntervalPair& pair : adjacent_intervals(d.input(), divisions))
    greatest = std::max(greatest, std::exp(std::abs(log_growth(d.input(), divisions, pair))));
  return greatest;
}

inline bool starts_at_left(const Divided& d, int arc) {
  const GraphArc& a = d.layout.arcs[arc];
  return d.layout.nodes[a.from].position.x < d.layout.nodes[a.to].position.x;
}

}  // namespace quadrille::growth
