#include "refine/arc_nodes.hpp"

#include <algorithm>

#include "spectral/quadrature.hpp"

namespace quadrille::refine {
namespace {

std::vector<double> node_fractions(const std::vector<double>& ends, int order) {
  const std::vector<double>& gll = spectral::gll_points(order);
  std::vector<double> fractions{ends.front()};
  for (std::size_t k = 1; k < ends.size(); ++k) {
    for (int i = 1; i < order; ++i) fractions.push_back(ends[k - 1] * (1 - gll[i]) / 2 + ends[k] * (1 + gll[i]) / 2);
    fractions.push_back(ends[k]);
  }
  return fractions;
}

void reverse(ArcNodes& nodes) {
  std::reverse(nodes.ids.begin(), nodes.ids.end());
  std::reverse(nodes.fractions.begin(), nodes.fractions.end());
  for (double& f : nodes.fractions) f = 1 - f;
}

}  // namespace

ArcNodes place_on_arc(const sizing::MeasuredLayout& measured, int arc, const sizing::ArcDivision& division,
                      const layers::WallPlan* walls, QuadMesh& mesh) {
  const bool is_layered = walls && !walls->arc_nodes[arc].empty();
  ArcNodes nodes{is_layered ? walls->arc_nodes[arc] : node_fractions(division.ends, mesh.order), {}};
  nodes.ids.push_back(measured.blocks().arcs[arc].from);
  for (std::size_t k = 1; k + 1 < nodes.fractions.size(); ++k) {
    nodes.ids.push_back(static_cast<int>(mesh.nodes.size()));
    mesh.nodes.push_back(measured.chain(arc).position(nodes.fractions[k]));
  }
  nodes.ids.push_back(measured.blocks().arcs[arc].to);
  return nodes;
}

std::array<ArcNodes, 4> side_nodes(const BlockLayout& layout, int block, const std::vector<ArcNodes>& arc_nodes) {
  std::array<ArcNodes, 4> sides;
  for (int side = 0; side < 4; ++side) {
    const HalfEdge directed = layout.block2arcs[block][side];
    sides[side] = arc_nodes[directed.arc];
    if (directed.is_backwards != (side >= 2)) reverse(sides[side]);
  }
  return sides;
}

}  // namespace quadrille::refine
