#include "layers/divide_chord.hpp"

#include <algorithm>

#include "layers/layer_rules.hpp"
#include "layers/layered_divisions.hpp"
#include "model/interfaces.hpp"
#include "sizing/interval_error.hpp"
#include "sizing/name_joints.hpp"

namespace quadrille::layers {
namespace {

/// Whether a curve of a given name ends inside the interval: no edge may belong to both.
bool parts_names(const WallInput& input, int arc, double low, double high) {
  const std::vector<double> joints = sizing::name_joints(input.measured.chain(arc), input.blocks().face);
  return std::any_of(joints.begin(), joints.end(), [&](double joint) {
    return joint > low + layer_constants.same_fraction && joint < high - layer_constants.same_fraction;
  });
}

bool meets_tolerance(const WallInput& input, int arc, double low, double high) {
  return !parts_names(input, arc, low, high) &&
         sizing::interval_error(input.measured.curves(), input.measured.chain(arc), low, high, input.order) <=
             input.tolerance;
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
  if (!is_on_cad_curve(input.blocks(), input.blocks().arcs[arc]) || meets_tolerance(input, arc, ends)) return true;
  move_onto_breaks(input, arc, ends);
  return meets_tolerance(input, arc, ends);
}

/// So that few rounds suffice for great counts, and small ones exceed the prescribed count by no more than necessary.
int raised_by(int count) { return 1 + count / layer_constants.count_steps; }

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

}  // namespace quadrille::layers
