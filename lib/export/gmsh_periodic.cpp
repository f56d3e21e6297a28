#include <map>
#include <set>
#include <utility>

#include "export/gmsh_model.hpp"
#include "export/periodic_edges.hpp"

namespace quadrille::exports {
namespace {

// The links of curves by the side of an element.
using SideTable = std::map<std::pair<int, int>, int>;

SideTable curves_by_side(const GmshModel& model) {
  SideTable table;
  for (std::size_t c = 0; c < model.skeleton.curves.size(); ++c)
    if (model.skeleton.curves[c].is_boundary())
      for (const SkeletonEdge& e : model.skeleton.curves[c].edges) table[{e.elem, e.side}] = static_cast<int>(c);
  return table;
}

}  // namespace

std::vector<GmshPeriodicLink> gmsh_periodic_links(const GmshModel& model, const QuadMesh& mesh) {
  const SideTable curves = curves_by_side(model);
  std::map<int, GmshPeriodicLink> points, links;  // by the entity
  std::map<int, int> point_of_node;
  for (std::size_t p = 0; p < model.skeleton.points.size(); ++p)
    point_of_node[model.skeleton.points[p]] = static_cast<int>(p);
  std::set<std::pair<int, int>> known;  // the curve and the node
  for (const PeriodicEdges& edges : periodic_edges(mesh)) {
    const QuadBoundaryEdge &first = mesh.boundary_edges[edges.first], &second = mesh.boundary_edges[edges.second];
    const int master = curves.at({first.elem, first.side}), curve = curves.at({second.elem, second.side});
    GmshPeriodicLink& link = links.try_emplace(curve, GmshPeriodicLink{1, curve, master, edges.pair, {}}).first->second;
    const std::vector<int> from = side_nodes(mesh, first.elem, first.side);
    const std::vector<int> to = side_nodes(mesh, second.elem, second.side);
    for (int k = 0; k <= mesh.order; ++k) {
      const int node = to[k], of = from[mesh.order - k];
      if (known.insert({curve, node}).second) link.nodes.push_back({node, of});
      const auto point = point_of_node.find(node), origin = point_of_node.find(of);
      if (point == point_of_node.end() || origin == point_of_node.end() || node == of) continue;
      points.try_emplace(point->second, GmshPeriodicLink{0, point->second, origin->second, edges.pair, {{node, of}}});
    }
  }
  std::vector<GmshPeriodicLink> all;
  for (const auto* of : {&points, &links})
    for (const auto& [entity, link] : *of) all.push_back(link);
  return all;
}

}  // namespace quadrille::exports
