#include "layers/request_layers.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/position_text.hpp"
#include "layers/layer_fit.hpp"
#include "layers/layer_law.hpp"
#include "layers/normal_line.hpp"
#include "mesh/block_sides.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::layers {
namespace {

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
  const WallPoint start = start_on_wall(input.blocks(), wall, at);
  const std::vector<double> heights = node_heights(
      wall.own_intervals > 0 ? compressed_heights(layers, height_of_end(line, wall.line, start), wall.own_intervals)
                             : layers,
      input.order);
  std::vector<double> nodes = parameters_at_heights(line, wall.line, start, heights);
  if (nodes.size() == heights.size()) return nodes;
  throw ComputeError(
      fmt::format("--wall: the line between blocks that starts at the wall at {} turns back to it before "
                  "the layers end: use fewer or thinner layers",
                  position_text(line(0) + input.blocks().face.origin)));
}

/// `above`: the number of intervals in which the rest of the arc is divided in any case; 0: any.
EndSpacing layer_spacing(const std::vector<double>& nodes, int order, double length, double growth, int above) {
  EndSpacing spacing;
  for (std::size_t k = order - 1; k < nodes.size(); k += order) spacing.layer_ends.push_back(nodes[k]);
  const std::size_t count = spacing.layer_ends.size();
  const double below = count > 1 ? spacing.layer_ends[count - 2] : 0;
  spacing.before = (spacing.layer_ends.back() - below) * length;
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

LayerRequests request_layers(const WallInput& input, const WallSides& walls,
                             const std::vector<std::vector<double>>& spec_heights) {
  const int num_arcs = input.measured.num_arcs();
  LayerRequests requests;
  requests.spacings.resize(num_arcs);
  requests.nodes.resize(num_arcs);
  for (int arc = 0; arc < num_arcs; ++arc)
    for (const int end : {0, 1}) {
      const int number = walls.at_arc_end[arc][end];
      if (number < 0) continue;
      const WallSide& wall = walls.sides[number];
      requests.nodes[arc][end] = nodes_in_layers(input, wall, spec_heights[wall.spec], {arc, end});
      requests.spacings[arc][end] = layer_spacing(requests.nodes[arc][end], input.order, input.measured.length(arc),
                                                  growth_beyond(input.specs[wall.spec]), wall.own_intervals);
    }
  return requests;
}

std::vector<double> interval_nodes(const std::vector<double>& ends, int order) {
  const std::vector<double>& gll = spectral::gll_points(order);
  std::vector<double> nodes{ends.front()};
  for (std::size_t k = 1; k < ends.size(); ++k)
    for (int i = 1; i <= order; ++i)
      nodes.push_back(i == order ? ends[k] : ends[k - 1] * (1 - gll[i]) / 2 + ends[k] * (1 + gll[i]) / 2);
  return nodes;
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
