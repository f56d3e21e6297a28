#include "layers/end_spacing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/bracketed_root.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "layers/layer_rules.hpp"
#include "layers/normal_line.hpp"
#include "layers/wall_spec.hpp"
#include "mesh/chords.hpp"
#include "surface/positions.hpp"

namespace quadrille::layers {
namespace {

double mean_size(const sizing::SizeField& sizes, const curve::Chain& chain, int region) {
  constexpr int samples = layer_constants.size_samples;
  if (sizes.is_uniform()) return sizes.greatest();
  double sum = 0;
  for (int k = 0; k < samples; ++k) {
    const curve::ChainPoint at = chain.at((k + 0.5) / samples);
    sum += 1 / sizes.along(at.tangent, at.position, region);
  }
  return samples / sum;
}

/// F after `steps`, with s = log q; written so that no power overflows.
double grown(double h, double s, double steps, double cap) {
  return s > 0 ? cap * h / (cap * std::exp(-s * steps) + h * (1 - std::exp(-s * steps)))
               : cap * h * std::exp(s * steps) / (cap + h * (std::exp(s * steps) - 1));
}

std::vector<double> family(const GradedEnds& ends, int count, double s, double cap) {
  std::vector<double> intervals;
  for (int i = 1; i <= count; ++i) {
    const double x = static_cast<double>(i) / (count + 1);
    const double front = ends.before > 0 ? grown(ends.before, s, i, cap) : 0;
    const double back = ends.after > 0 ? grown(ends.after, s, count + 1 - i, cap) : 0;
    intervals.push_back(front > 0 && back > 0 ? std::pow(front, 1 - x) * std::pow(back, x) : std::max(front, back));
  }
  return intervals;
}

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// Rule 21: if an arc is too short for first intervals as fine as its neighbours', its own would become finer from
/// block to block. Layers are always continued.
void relax_crowding(const ArcSpacing& spacing, int count, FreePart& part) {
  const double most = layer_constants.greatest_crowding * part.length / (count - part.layers);
  if (spacing[0].layers() == 0) part.ends.before = std::min(part.ends.before, most);
  if (spacing[1].layers() == 0) part.ends.after = std::min(part.ends.after, most);
}

/// The start of an arc on a wall: at the beginning or the end of the wall's side.
WallPoint start_on_wall(const BlockLayout& layout, const WallSide& wall, const mesh::ArcEnd& at) {
  const mesh::ArcEnd before = mesh::ending(mesh::half_edge(layout, wall.block, wall.side - 1));
  return before.arc == at.arc && before.end == at.end ? wall.begin : wall.end;
}

/// The nodes of an arc in the layers of the wall at which it starts.
std::vector<double> nodes_in_layers(const WallInput& input, const WallSide& wall, const std::vector<double>& layers,
                                    const mesh::ArcEnd& at) {
  const curve::Chain& chain = input.measured.chain(at.arc);
  const NormalLine line = [&chain, &at](double u) { return chain.at(at.end == 0 ? u : 1 - u).position; };
  std::vector<double> nodes = parameters_in_layers(line, wall.line, start_on_wall(input.blocks(), wall, at), layers,
                                                   wall.own_intervals, input.order);
  if (nodes.size() == layers.size() * input.order) return nodes;
  throw ComputeError(
      fmt::format("--wall: the line between blocks that starts at the wall at {} turns back to it before "
                  "the layers end: use fewer or thinner layers",
                  surface::position_text(input.blocks().face, line(0))));
}

/// `above`: the number of intervals in which the rest of the arc is divided in any case; 0: any.
EndSpacing layer_spacing(const std::vector<double>& nodes, int order, double length, double growth, int above) {
  EndSpacing spacing;
  for (std::size_t k = order - 1; k < nodes.size(); k += order) spacing.layer_ends.push_back(nodes[k]);
  spacing.before = spacing.last_layer() * length;
  if (above > 0) spacing.before = std::min(spacing.before, (1 - spacing.layer_ends.back()) * length / above);
  spacing.growth = growth;
  return spacing;
}

/// False if the end of a layer had to move onto a break.
bool keeps_layers(const ArcSpacing& spacing, const std::vector<double>& ends) {
  const std::vector<double>&low = spacing[0].layer_ends, &high = spacing[1].layer_ends;
  for (std::size_t k = 0; k < low.size(); ++k)
    if (ends[k + 1] != low[k]) return false;
  for (std::size_t k = 0; k < high.size(); ++k)
    if (ends[ends.size() - 2 - k] != 1 - high[k]) return false;
  return true;
}

}  // namespace

ArcSizes arc_sizes(const WallInput& input) {
  ArcSizes sizes;
  for (int arc = 0; arc < input.measured.num_arcs(); ++arc)
    sizes.prescribed.push_back(mean_size(input.sizes, input.measured.chain(arc), input.measured.region_of(arc)));
  sizes.scale.assign(sizes.prescribed.size(), 1);
  return sizes;
}

std::vector<double> graded_intervals(const GradedEnds& ends, int count, double length, double cap) {
  if (ends.are_free()) return std::vector<double>(count, length / count);
  // The family must be able to reach the sum, and to start from its neighbours.
  const double reach = std::max({cap, 1.25 * length / count, 2 * ends.before, 2 * ends.after});
  const double log_ratio = bisect([&](double s) { return sum(family(ends, count, s, reach)) - length; }, -30, 30);
  std::vector<double> intervals = family(ends, count, log_ratio, reach);
  const double factor = length / sum(intervals);
  for (double& interval : intervals) interval *= factor;
  return intervals;
}

double worst_growth(const GradedEnds& ends, const std::vector<double>& intervals) {
  double worst = 1;
  const auto compare = [&](double a, double b) {
    if (a > 0 && b > 0) worst = std::max({worst, a / b, b / a});
  };
  compare(ends.before, intervals.front());
  for (std::size_t i = 1; i < intervals.size(); ++i) compare(intervals[i - 1], intervals[i]);
  compare(intervals.back(), ends.after);
  return worst;
}

int least_graded_count(const GradedEnds& ends, double length, double cap, double growth, int most) {
  const auto suffices = [&](int count) {
    if (length > (1 + tolerance::tied) * count * cap) return false;
    const std::vector<double> intervals = graded_intervals(ends, count, length, cap);
    // The intervals are already crowded, and a larger count would not change this.
    const double neighbour =
        std::min(ends.before > 0 ? ends.before : ends.after, ends.after > 0 ? ends.after : ends.before);
    const bool is_crowded = !ends.are_free() && std::ranges::min(intervals) < neighbour * (1 - tolerance::tied);
    return is_crowded || worst_growth(ends, intervals) <= growth * (1 + tolerance::tied);
  };
  int low = 0, high = 1;
  while (high < most && !suffices(high)) low = high, high = std::min(2 * high, most);
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    (suffices(middle) ? high : low) = middle;
  }
  return high;
}

FreePart free_part(const ArcSpacing& spacing, double length, double size) {
  const auto top = [](const EndSpacing& end) { return end.layer_ends.empty() ? 0 : end.layer_ends.back(); };
  return {{spacing[0].before, spacing[1].before},
          (1 - top(spacing[0]) - top(spacing[1])) * length,
          size,
          spacing[0].layers() + spacing[1].layers()};
}

double least_growth(const mesh::Chord& chord, const std::vector<ArcSpacing>& spacings) {
  double least = 0;
  for (const int arc : chord.arcs)
    for (const EndSpacing& end : spacings[arc])
      if (!end.is_free()) least = least > 0 ? std::min(least, end.growth) : end.growth;
  return least;
}

std::vector<double> spaced_ends(const ArcSpacing& spacing, double length, double size, int count) {
  FreePart part = free_part(spacing, length, size);
  relax_crowding(spacing, count, part);
  std::vector<double> ends{0.0};
  ends.insert(ends.end(), spacing[0].layer_ends.begin(), spacing[0].layer_ends.end());
  const int num_free = count - part.layers;
  const std::vector<double> intervals = graded_intervals(part.ends, num_free, part.length, part.size);
  const double low = ends.back();
  double sum = 0;
  for (int k = 0; k + 1 < num_free; ++k) ends.push_back(low + (sum += intervals[k]) / length);
  for (int k = spacing[1].layers(); k-- > 0;) ends.push_back(1 - spacing[1].layer_ends[k]);
  ends.push_back(1);
  return ends;
}

double even_size(const ArcSpacing& spacing, double length, double size, double growth, int count) {
  constexpr double unlimited = 1e3;  // lengths of the arc: what grows towards it is a geometric series
  FreePart part = free_part(spacing, length, size);
  relax_crowding(spacing, count, part);
  const auto is_even = [&](double cap) {
    const std::vector<double> intervals = graded_intervals(part.ends, count - part.layers, part.length, cap);
    return worst_growth(part.ends, intervals) <= growth * (1 + tolerance::tied);
  };
  if (part.ends.are_free() || is_even(size)) return size;
  double low = std::log(size), high = std::log(std::max(size, unlimited * length));
  for (int step = 0; step < 40; ++step) {
    const double middle = (low + high) / 2;
    (is_even(std::exp(middle)) ? high : low) = middle;
  }
  return std::exp(high);
}

LayerRequests request_layers(const WallInput& input, const WallSides& walls,
                             const std::vector<std::vector<double>>& spec_heights) {
  const int num_arcs = input.measured.num_arcs();
  LayerRequests requests;
  requests.spacings.resize(num_arcs);
  requests.nodes.resize(num_arcs);
  for (const auto& [arc, end, side] : walls.layered_ends()) {
    const WallSide& wall = walls.sides[side];
    requests.nodes[arc][end] = nodes_in_layers(input, wall, spec_heights[wall.spec], {arc, end});
    requests.spacings[arc][end] = layer_spacing(requests.nodes[arc][end], input.order, input.measured.length(arc),
                                                growth_beyond(input.specs[wall.spec]), wall.own_intervals);
  }
  return requests;
}

std::vector<std::vector<double>> layered_arc_nodes(const LayerRequests& requests, const sizing::ArcDivisions& divisions,
                                                   int order) {
  std::vector<std::vector<double>> arc_nodes(divisions.size());
  for (std::size_t arc = 0; arc < divisions.size(); ++arc) {
    const auto& [low, high] = requests.nodes[arc];
    if (low.empty() && high.empty()) continue;
    if (!keeps_layers(requests.spacings[arc], divisions[arc].ends)) continue;
    std::vector<double>& nodes = arc_nodes[arc] = interval_nodes(divisions[arc].ends, order);
    for (std::size_t k = 0; k < low.size(); ++k) nodes[k + 1] = low[k];
    for (std::size_t k = 0; k < high.size(); ++k) nodes[nodes.size() - 2 - k] = 1 - high[k];
  }
  return arc_nodes;
}

}  // namespace quadrille::layers
