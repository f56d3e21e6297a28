#include <fmt/format.h>

#include <array>
#include <iterator>
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

/// A point or curve of the second of two periodic sides, and the one of the first that it is the image of.
struct GmshPeriodicLink {
  int dim = 0, entity = 0, master = 0;
  int pair = 0;                           // of CadFace::periodic_pairs
  std::vector<std::array<int, 2>> nodes;  // mesh nodes, each with that of the master
};

// Points first. A point that is the image of several has one link.
std::vector<GmshPeriodicLink> periodic_links(const GmshModel& model, const QuadMesh& mesh) {
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

}  // namespace

std::string gmsh_periodic(const GmshModel& model, const QuadMesh& mesh, const Frame& frame, const char* motion) {
  const std::vector<GmshPeriodicLink> links = periodic_links(model, mesh);
  if (links.empty()) return {};
  std::string text = fmt::format("$Periodic\n{}\n", links.size());
  const auto out = std::back_inserter(text);
  for (const GmshPeriodicLink& link : links) {
    fmt::format_to(out, "{} {} {}\n{}", link.dim, link.entity + 1, link.master + 1, motion);
    for (const double number : affine_motion(mesh.face, link.pair, frame)) fmt::format_to(out, " {}", number);
    fmt::format_to(out, "\n{}\n", link.nodes.size());
    for (const auto& [node, master] : link.nodes)
      fmt::format_to(out, "{} {}\n", model.node_tags[node], model.node_tags[master]);
  }
  return text + "$EndPeriodic\n";
}

}  // namespace quadrille::exports
