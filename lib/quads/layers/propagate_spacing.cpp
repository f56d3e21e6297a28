#include "layers/propagate_spacing.hpp"

#include <algorithm>
#include <set>

#include "base/tolerance.hpp"
#include "layers/layer_rules.hpp"
#include "layers/layered_divisions.hpp"
#include "mesh/chords.hpp"
#include "sizing/interval_error.hpp"

namespace quadrille::layers {
namespace {

/// Whether a curve of a given name ends inside the interval: no edge may belong to both.
bool parts_names(const WallInput& input, int arc, double low, double high) {
  return std::ranges::any_of(input.measured.name_joints(arc), [&](double joint) {
    return joint > low + tolerance::round_off && joint < high - tolerance::round_off;
  });
}

bool meets_tolerance(const WallInput& input, int arc, double low, double high) {
  return !parts_names(input, arc, low, high) &&
         sizing::interval_error(input.measured, arc, low, high, input.order) <= input.tolerance;
}

bool meets_tolerance(const WallInput& input, int arc, const std::vector<double>& ends) {
  for (std::size_t k = 0; k + 1 < ends.size(); ++k)
    if (!meets_tolerance(input, arc, ends[k], ends[k + 1])) return false;
  return true;
}

/// Moves the nearest end of each interval that misses the tolerance onto the break inside it.
void move_onto_breaks(const WallInput& input, int arc, std::vector<double>& ends) {
  for (const double f : input.measured.chain(arc).break_fractions()) {
    const std::size_t k = std::upper_bound(ends.begin(), ends.end(), f) - ends.begin() - 1;
    if (k + 1 >= ends.size() || meets_tolerance(input, arc, ends[k], ends[k + 1])) continue;
    const bool take_low = k > 0 && (f - ends[k] < ends[k + 1] - f || k + 2 == ends.size());
    if (take_low || k + 2 < ends.size()) ends[take_low ? k : k + 1] = f;
  }
}

/// Whether a boundary arc's intervals meet the tolerance, if necessary after ends moved onto breaks.
bool fit_to_boundary(const WallInput& input, int arc, std::vector<double>& ends) {
  if (!input.measured.is_on_cad_curve(arc) || meets_tolerance(input, arc, ends)) return true;
  move_onto_breaks(input, arc, ends);
  return meets_tolerance(input, arc, ends);
}

/// So that few rounds suffice for great counts, and small ones exceed the prescribed count by no more than necessary.
int raised_by(int count) { return 1 + count / layer_constants.count_steps; }

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

void divide_chord(const WallInput& input, int chord, const std::vector<ArcSpacing>& spacings,
                  const std::vector<FreePart>& lines, ArcSizes& sizes, sizing::ArcDivisions& divisions) {
  const std::vector<int>& arcs = input.measured.chords()[chord].arcs;
  // Without layers the chord may already have needed more than the prescribed count.
  int prescribed = input.prescribed_count(chord);
  if (prescribed > 0) prescribed = std::max(prescribed, divisions[arcs.front()].num_intervals());
  bool meets = false;
  for (int round = 0; round < layer_constants.max_tolerance_rounds && !meets; ++round) {
    std::vector<sizing::ArcDivision> divided =
        layered_divisions(LayeredChord(input, chord, spacings, sizes), lines, layer_constants.least_count, prescribed);
    meets = true;
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      divisions[arcs[i]] = std::move(divided[i]);
      if (fit_to_boundary(input, arcs[i], divisions[arcs[i]].ends)) continue;
      if (prescribed == 0) sizes.scale[arcs[i]] *= layer_constants.shrink;
      meets = false;
    }
    if (prescribed > 0 && !meets)
      prescribed = std::max(prescribed, divisions[arcs.front()].num_intervals()) + raised_by(prescribed);
  }
}

bool continue_spacing(double neighbour_interval, double own_interval, double growth, EndSpacing& to) {
  if (own_interval <= std::max(growth, layer_constants.greatest_jump) * neighbour_interval) return false;
  if (to.layers() > 0) return false;
  if (!to.is_free() && to.before <= neighbour_interval * (1 + tolerance::tied)) return false;
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
