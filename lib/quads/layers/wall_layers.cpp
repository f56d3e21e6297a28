#include "layers/wall_layers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "base/warning_codes.hpp"
#include "curve/named_places.hpp"
#include "layers/layer_fit.hpp"
#include "layers/layer_rules.hpp"
#include "layers/propagate_spacing.hpp"
#include "layers/wall_spec.hpp"
#include "mesh/chords.hpp"
#include "model/name_rules.hpp"
#include "surface/positions.hpp"

namespace quadrille::layers {
namespace {

std::vector<std::vector<double>> fitted_heights(const WallInput& input, const std::vector<NormalLineSample>& lines) {
  std::vector<std::vector<double>> heights;
  for (const int count : fitting_layers(input.specs, lines, input.blocks().face, input.may_crowd))
    heights.push_back(layer_heights(input.specs[heights.size()], count));
  return heights;
}

/// By chord: the parts between the layers of the sampled lines across its blocks.
std::vector<std::vector<FreePart>> free_parts(const std::vector<NormalLineSample>& lines,
                                              const std::vector<std::vector<double>>& heights, std::size_t num_chords) {
  std::vector<std::vector<FreePart>> parts(num_chords);
  for (const NormalLineSample& line : lines) parts[line.chord].push_back(part_between_layers(line, heights));
  return parts;
}

/// By spec: the least thickness of its layers on the sampled lines.
std::vector<double> least_thicknesses(const std::vector<NormalLineSample>& lines,
                                      const std::vector<std::vector<double>>& heights) {
  std::vector<double> least;
  for (const std::vector<double>& own : heights) least.push_back(own.back());
  const auto add = [&](int spec, int own_intervals, const std::vector<double>& line_heights) {
    if (spec < 0 || own_intervals == 0) return;
    least[spec] = std::min(least[spec], compressed_heights(heights[spec], line_heights.back(), own_intervals).back());
  };
  for (const NormalLineSample& line : lines) {
    add(line.front, line.own_intervals[0], line.front_heights);
    add(line.back, line.own_intervals[1], line.back_heights);
  }
  return least;
}

/// A growth is a ratio of lengths in space.
void allow_for_chart(const WallInput& input, const std::vector<NormalLineSample>& lines, WallPlan& plan) {
  std::vector<double> ranges(input.specs.size(), 1);
  for (const NormalLineSample& line : lines)
    for (const int spec : {line.front, line.back})
      if (spec >= 0) ranges[spec] = std::max(ranges[spec], chart_growth_factor(input.specs[spec], line));
  for (const auto& [arc, end, side] : plan.walls.layered_ends())
    plan.requests.spacings[arc][end].growth *= ranges[plan.walls.sides[side].spec];
}

/// Pairs of specs with layers on one chord, at whichever ends of its arcs.
std::vector<std::array<int, 2>> specs_sharing_a_chord(const std::vector<mesh::Chord>& chords, const WallSides& walls) {
  std::set<std::array<int, 2>> pairs;
  for (const mesh::Chord& chord : chords) {
    std::set<int> specs;
    for (const int arc : chord.arcs)
      for (const int wall : walls.at_arc_end[arc])
        if (wall >= 0) specs.insert(walls.sides[wall].spec);
    for (auto a = specs.begin(); a != specs.end(); ++a)
      for (auto b = std::next(a); b != specs.end(); ++b) pairs.insert({*a, *b});
  }
  return {pairs.begin(), pairs.end()};
}

/// Requests the layers and divides the chords that they and their continuations reach.
void divide_with_layers(const WallInput& input, const std::vector<NormalLineSample>& lines, ArcSizes sizes,
                        WallPlan& plan, sizing::ArcDivisions& divisions) {
  plan.least_thickness = least_thicknesses(lines, plan.heights);
  plan.requests = request_layers(input, plan.walls, plan.heights);
  allow_for_chart(input, lines, plan);
  plan.chords = propagate_spacing(input, free_parts(lines, plan.heights, input.measured.chords().size()),
                                  plan.requests.spacings, sizes, divisions);
}

/// Counts the intervals above layers in blocks of their own. Returns whether a number changed.
bool count_own_intervals(const WallInput& input, const sizing::ArcDivisions& divisions, WallPlan& plan) {
  bool changed = false;
  for (WallSide& wall : plan.walls.sides) {
    if (wall.own_intervals == 0) continue;
    const int arc = mesh::half_edge(input.blocks(), wall.block, wall.side - 1).arc;
    const int layers = static_cast<int>(plan.heights[wall.spec].size());
    const int own = std::max(1, divisions[arc].num_intervals() - layers);
    changed = changed || own != wall.own_intervals;
    wall.own_intervals = own;
  }
  return changed;
}

/// In blocks that fold, or nearly, layers may have no room along an arc.
void require_room(const sizing::MeasuredLayout& measured, const sizing::ArcDivisions& divisions) {
  for (int arc = 0; arc < measured.num_arcs(); ++arc) {
    const std::vector<double>& ends = divisions[arc].ends;
    const auto at = std::ranges::adjacent_find(ends, [](double a, double b) { return !(a < b); });
    if (at == ends.end()) continue;
    const Vec2 position = measured.chain(arc).position(std::clamp(*at, 0.0, 1.0));
    throw ComputeError(
        fmt::format("--wall: the layers do not fit along the sides of blocks at {}: give fewer or thinner layers",
                    surface::position_text(measured.blocks().face, position)));
  }
}

/// Divisions by the plans alone, whatever the tolerance of the boundary requires.
sizing::ArcDivisions planned_divisions(const sizing::MeasuredLayout& measured,
                                       const std::vector<sizing::ChordPlan>& plans) {
  sizing::ArcDivisions divisions(measured.num_arcs());
  for (std::size_t c = 0; c < plans.size(); ++c) {
    const mesh::Chord& chord = measured.chords()[c];
    for (int i = 0; i < static_cast<int>(chord.arcs.size()); ++i) {
      std::vector<double>& ends = divisions[chord.arcs[i]].ends;
      for (int k = 1; k < plans[c].count; ++k)
        ends.push_back(measured.arc_fraction(chord, i, plans[c].grading.parameter(1.0 * k / plans[c].count)));
      std::ranges::sort(ends);
    }
  }
  return divisions;
}

/// By spec: whether the intervals above the layers of some arc are far shorter than its last layer.
std::vector<bool> crowded_specs(const WallInput& input, const WallPlan& plan) {
  std::vector<bool> crowded(plan.heights.size(), false);
  for (const auto& [arc, end, side] : plan.walls.layered_ends()) {
    const EndSpacing& spacing = plan.requests.spacings[arc][end];
    if (spacing.before * layer_constants.greatest_jump < spacing.last_layer() * input.measured.length(arc))
      crowded[plan.walls.sides[side].spec] = true;
  }
  return crowded;
}

}  // namespace

bool WallPlan::has_wall(int block) const {
  const std::array<int, 4>& sides = walls.of_block[block];
  return std::any_of(sides.begin(), sides.end(), [](int wall) { return wall >= 0; });
}

int WallPlan::num_fixed_on(int block, int side) const {
  const int wall = walls.of_block[block][side];
  if (wall < 0) return 0;
  const int fixed = num_fixed[walls.sides[wall].spec];
  return num_fixed_inside.empty() ? fixed : std::min(fixed, num_fixed_inside[wall]);
}

WallPlan plan_walls(const WallInput& input, sizing::ArcDivisions& divisions) {
  WallPlan plan;
  const std::vector<int> curve_spec = curve_walls(input.specs, input.blocks().face);
  plan.walls = find_wall_sides(input.blocks(), input.measured.curves(), curve_spec, input.specs, input.sizes.scale());
  const ArcSizes sizes = arc_sizes(input);
  const std::vector<NormalLineSample> lines = sample_normal_lines(input.measured, plan.walls, sizes.prescribed);
  plan.heights = fitted_heights(input, lines);
  for (const std::vector<double>& heights : plan.heights) plan.num_fixed.push_back(static_cast<int>(heights.size()));
  const sizing::ArcDivisions without_layers = divisions;
  divide_with_layers(input, lines, sizes, plan, divisions);
  if (count_own_intervals(input, divisions, plan)) {
    divisions = without_layers;
    const std::vector<NormalLineSample> counted = sample_normal_lines(input.measured, plan.walls, sizes.prescribed);
    divide_with_layers(input, counted, sizes, plan, divisions);
  }
  require_room(input.measured, divisions);
  for (int arc = 0; arc < input.measured.num_arcs(); ++arc)
    plan.is_graded.push_back(std::binary_search(plan.chords.begin(), plan.chords.end(), input.measured.chord_of(arc)));
  plan.arc_nodes = layered_arc_nodes(plan.requests, divisions, input.order);
  plan.sharing_a_chord = specs_sharing_a_chord(input.measured.chords(), plan.walls);
  return plan;
}

std::vector<prescribe::LayeredCount> layered_counts(const WallInput& input,
                                                    const std::vector<sizing::ChordPlan>& plans) {
  sizing::ArcDivisions divisions = planned_divisions(input.measured, plans);
  const LayerRequests requests = plan_walls(input, divisions).requests;
  std::vector<prescribe::LayeredCount> counts;
  for (const mesh::Chord& chord : input.measured.chords()) {
    prescribe::LayeredCount count{divisions[chord.arcs.front()].num_intervals(), 0};
    for (const int arc : chord.arcs)
      count.layers = std::max(count.layers, requests.spacings[arc][0].layers() + requests.spacings[arc][1].layers());
    counts.push_back(count);
  }
  return counts;
}

void release_compressed_layers(const WallInput& input, WallPlan& plan) {
  const std::vector<bool> is_crowded = crowded_specs(input, plan);
  for (std::size_t spec = 0; spec < plan.heights.size(); ++spec)
    if (is_crowded[spec] || plan.least_thickness[spec] < plan.heights[spec].back() * (1 - tolerance::tied))
      plan.num_fixed[spec] = 1;
  for (const auto& [arc, end, side] : plan.walls.layered_ends()) {
    const int fixed = plan.num_fixed[plan.walls.sides[side].spec];
    plan.requests.spacings[arc][end].layer_ends.resize(fixed);
    plan.requests.nodes[arc][end].resize(static_cast<std::size_t>(fixed) * input.order);
  }
}

void release_bent_layers(const WallInput& input, WallPlan& plan) {
  for (const WallSide& wall : plan.walls.sides) {
    const std::vector<double>& heights = plan.heights[wall.spec];
    const double bend = greatest_bend(input.measured.curves(), wall);
    int count = static_cast<int>(heights.size());
    while (count > 1 && heights[count - 1] * bend > layer_constants.greatest_bend_height) --count;
    plan.num_fixed_inside.push_back(count);
  }
}

void measure_released_layers(const WallInput& input, const sizing::ArcDivisions& divisions, WallPlan& plan) {
  for (const auto& [arc, end, side] : plan.walls.layered_ends()) {
    const int spec = plan.walls.sides[side].spec, count = static_cast<int>(plan.heights[spec].size());
    if (plan.num_fixed[spec] == count) continue;
    const std::vector<double>& ends = divisions[arc].ends;
    const double top = end == 0 ? ends[count] : 1 - ends[ends.size() - 1 - count];
    const Vec2 middle = input.measured.chain(arc).position(end == 0 ? top / 2 : 1 - top / 2);
    const double thickness = top * input.measured.length(arc) * plan.walls.sides[side].line.scale_at(middle);
    plan.least_thickness[spec] = std::min(plan.least_thickness[spec], thickness);
  }
}

void require_offsets(const std::vector<WallSpec>& specs, const CadFace& face) {
  for (const WallSpec& spec : specs)
    for (const std::string& name : spec.names)
      for (const int curve : spec.own_blocks ? curve::named_curves(face, name, "--wall") : std::vector<int>())
        if (!has_offset(face, face.curve_names[curve]))
          throw UsageError(
              fmt::format("--wall {}: blocks=own needs a curve {} in the face: give cad2tri --offset {}={:.17g}", name,
                          offset_name(face.curve_names[curve]), fmt::join(spec.names, ","), block_height(spec)));
}

LayeredBlock layered_block(const WallPlan& plan, const sizing::MeasuredLayout& measured, int block,
                           std::array<std::vector<double>, 4> fractions) {
  LayeredBlock result;
  for (int side = 0; side < 4; ++side) {
    const HalfEdge half = mesh::half_edge(measured.blocks(), block, side);
    const int number = plan.walls.of_block[block][side];
    const bool backwards = half.is_backwards,
               against_arc = backwards != (side >= 2);  // sides 2, 3 run against s, t
    const curve::Chain& chain = measured.chain(half.arc);
    result.tables[side] = SideTable(chain, against_arc);
    result.lengths[side] = chain.length();
    if (number < 0) continue;
    const WallSide& wall = plan.walls.sides[number];
    result.sides[side].wall = &wall.line;
    result.sides[side].heights = plan.heights[wall.spec];
    result.sides[side].heights.resize(plan.num_fixed_on(block, side));
    result.sides[side].own_intervals = wall.own_intervals;
    for (const double f : fractions[side])
      result.sides[side].feet.push_back(wall_point(wall, chain.at(against_arc ? 1 - f : f), backwards));
  }
  result.fractions = std::move(fractions);
  if (const sizing::HalvedSide* halved = measured.halved_side(block)) result.halved = *halved;
  return result;
}

void report_walls(const WallPlan& plan, const std::vector<WallSpec>& specs, Report& report) {
  const auto names = [&](int spec) { return fmt::format("{}", fmt::join(specs[spec].names, ",")); };
  for (std::size_t i = 0; i < specs.size(); ++i) {
    const std::string key = fmt::format("walls.{}.", i);
    report.set(key + "names", names(static_cast<int>(i)));
    report.set(key + "layers", plan.heights[i].size());
    report.set(key + "first", plan.heights[i].front());
    report.set(key + "thickness", plan.heights[i].back());
    if (specs[i].own_blocks) report.set(key + "least_thickness", plan.least_thickness[i]);
  }
  for (const auto& [a, b] : plan.sharing_a_chord)
    report.warn(warning::walls_share_a_chord,
                fmt::format("walls {} and {} have layers on one chord: each keeps its own heights, and both "
                            "share the chord's number of elements",
                            names(a), names(b)));
  for (const auto& [overruled, used] : plan.walls.overruled)
    report.warn(warning::walls_disagree,
                fmt::format("walls {} and {} are one smooth wall: the finer layers of {} are used along both",
                            names(overruled), names(used), names(used)));
}

}  // namespace quadrille::layers
