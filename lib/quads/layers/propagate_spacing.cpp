#include "layers/propagate_spacing.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "layers/divide_chord.hpp"
#include "layers/layer_rules.hpp"
#include "mesh/block_sides.hpp"

namespace quadrille::layers {
namespace {

/// Length of the interval at the end of an arc.
double end_interval(const WallInput& input, const sizing::ArcDivisions& divisions, const mesh::ArcEnd& at) {
  const std::vector<double>& ends = divisions[at.arc].ends;
  return (at.end == 0 ? ends[1] : 1 - ends[ends.size() - 2]) * input.measured.length(at.arc);
}

std::set<int> chords_with_spacing(const WallInput& input, const std::vector<ArcSpacing>& spacings) {
  std::set<int> chords;
  for (int arc = 0; arc < input.measured.num_arcs(); ++arc)
    for (const EndSpacing& end : spacings[arc])
      if (!end.is_free()) chords.insert(input.measured.chord_of(arc));
  return chords;
}

/// The least interval that is prescribed on the chord, layers included. Its arcs are shorter elsewhere, with as many
/// intervals.
double least_spacing(const WallInput& input, const mesh::Chord& chord, const std::vector<ArcSpacing>& spacings) {
  double least = INFINITY;
  for (const int arc : chord.arcs)
    for (const EndSpacing& end : spacings[arc]) {
      if (!end.is_free()) least = std::min(least, end.before);
      if (end.layers() > 0) least = std::min(least, end.layer_ends.front() * input.measured.length(arc));
    }
  return least;
}

}  // namespace

bool continue_spacing(double neighbour_interval, double own_interval, double growth, EndSpacing& to) {
  if (own_interval <= std::max(growth, layer_constants.greatest_jump) * neighbour_interval) return false;
  if (to.layers() > 0) return false;
  if (!to.is_free() && to.before <= neighbour_interval * (1 + layer_constants.equal_tol)) return false;
  to.before = neighbour_interval;
  to.growth = to.growth > 0 ? std::min(to.growth, growth) : growth;
  return true;
}

std::vector<int> propagate_spacing(const WallInput& input, const std::vector<std::vector<FreePart>>& chord_lines,
                                   std::vector<ArcSpacing>& spacings, ArcSizes& sizes,
                                   sizing::ArcDivisions& divisions) {
  const std::vector<mesh::ArcNeighbours> neighbours = mesh::arc_neighbours(input.blocks());
  std::set<int> changed = chords_with_spacing(input, spacings), divided;
  const auto pass = [&](const mesh::ArcEnd& from, const mesh::ArcEnd& to) {
    const int chord = input.measured.chord_of(from.arc);
    if (!divided.count(chord)) return;
    const mesh::Chord& arcs = input.measured.chords()[chord];
    const double interval = std::max(end_interval(input, divisions, from),
                                     layer_constants.least_propagated_fraction * least_spacing(input, arcs, spacings));
    if (continue_spacing(interval, end_interval(input, divisions, to), least_growth(arcs, spacings),
                         spacings[to.arc][to.end]))
      changed.insert(input.measured.chord_of(to.arc));
  };
  for (int sweep = 0; sweep < layer_constants.max_sweeps && !changed.empty(); ++sweep) {
    for (const int chord : changed) divide_chord(input, chord, spacings, chord_lines[chord], sizes, divisions);
    divided.insert(changed.begin(), changed.end());
    changed.clear();
    for (const auto& [a, b] : neighbours) pass(a, b), pass(b, a);
  }
  return {divided.begin(), divided.end()};
}

}  // namespace quadrille::layers
