#include "sizing/measured_layout.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

namespace quadrille::sizing {
namespace {

/// By arc: whether another one has the same two ends.
std::vector<bool> parallel_arcs(const std::vector<GraphArc>& arcs) {
  std::map<std::pair<int, int>, int> count;
  for (const GraphArc& arc : arcs) ++count[std::minmax(arc.from, arc.to)];
  std::vector<bool> are_parallel;
  for (const GraphArc& arc : arcs) are_parallel.push_back(count[std::minmax(arc.from, arc.to)] > 1);
  return are_parallel;
}

/// By arc: the region of the blocks beside it; -1 where they differ, or are not known.
std::vector<int> regions_of_arcs(const BlockLayout& layout) {
  constexpr int unmet = -2;
  std::vector<int> regions(layout.arcs.size(), layout.block_region.empty() ? -1 : unmet);
  for (std::size_t b = 0; b < layout.block_region.size(); ++b)
    for (const HalfEdge side : layout.block2arcs[b]) {
      int& region = regions[side.arc];
      region = region == unmet || region == layout.block_region[b] ? layout.block_region[b] : -1;
    }
  return regions;
}

}  // namespace

MeasuredLayout::Geometry::Geometry(const BlockLayout& layout)
    : blocks(&layout),
      curves(layout.face, layout.splines),
      periodic(matched_arcs(layout)),
      arc_chord(mesh::arc_chords(layout.block2arcs, static_cast<int>(layout.arcs.size()), periodic)),
      arc_region(regions_of_arcs(layout)),
      chords(mesh::directed_chords(layout.block2arcs, arc_chord, periodic)),
      is_parallel(parallel_arcs(layout.arcs)) {
  for (const GraphArc& arc : layout.arcs) chains.emplace_back(curves, arc.pieces);
}

MeasuredLayout::MeasuredLayout(const BlockLayout& layout)
    : geometry_(std::make_shared<Geometry>(layout)), parameters_(layout.arcs.size()) {}

MeasuredLayout MeasuredLayout::with_parameters(std::vector<ArcParameter> parameters) const {
  MeasuredLayout other = *this;
  other.parameters_ = std::move(parameters);
  return other;
}

bool MeasuredLayout::has_equal_parameters() const {
  return std::all_of(parameters_.begin(), parameters_.end(), std::mem_fn(&ArcParameter::is_identity));
}

double MeasuredLayout::arc_fraction(const mesh::Chord& chord, int i, double u) const {
  return parameters_[chord.arcs[i]].fraction(chord.backwards[i] ? 1 - u : u);
}

double MeasuredLayout::chord_parameter(const mesh::Chord& chord, int i, double fraction) const {
  const double own = parameters_[chord.arcs[i]].parameter(fraction);
  return chord.backwards[i] ? 1 - own : own;
}

}  // namespace quadrille::sizing
