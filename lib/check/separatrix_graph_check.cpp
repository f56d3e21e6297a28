#include <algorithm>

#include "check/graph_rules.hpp"

namespace quadrille {

namespace {

GraphView view(const SeparatrixGraph& g) { return {g.face, g.splines, g.nodes, g.arcs}; }

void lines_exist(const SeparatrixGraph& graph, Findings& findings) {
  for (std::size_t i = 0; i < graph.lines.size(); ++i) {
    const SeparatrixLine& line = graph.lines[i];
    bool is_sound = is_index(line.origin, graph.nodes.size()) && is_index(line.end, graph.nodes.size());
    for (const int arc : line.arcs) is_sound = is_sound && is_index(arc, graph.arcs.size());
    if (!is_sound) findings.add("line {} names a node or an arc that does not exist", i);
  }
  for (const int node : graph.t_junctions)
    if (!is_index(node, graph.nodes.size())) findings.add("t_junctions names node {}, which does not exist", node);
}

/// The arcs of a line, in either direction, lead from its origin to its end.
void lines_are_chains(const SeparatrixGraph& graph, Findings& findings) {
  for (std::size_t i = 0; i < graph.lines.size(); ++i) {
    const SeparatrixLine& line = graph.lines[i];
    int node = line.origin;
    bool is_chain = !line.arcs.empty();
    for (const int id : line.arcs) {
      const GraphArc& arc = graph.arcs[id];
      is_chain = is_chain && (arc.from == node || arc.to == node);
      node = arc.from == node ? arc.to : arc.from;
    }
    if (!is_chain || node != line.end) findings.add("the arcs of line {} do not lead from its origin to its end", i);
  }
}

std::vector<int> arcs_at_nodes(const SeparatrixGraph& graph) {
  std::vector<int> count(graph.nodes.size());
  for (const GraphArc& arc : graph.arcs) {
    ++count[arc.from];
    ++count[arc.to];
  }
  return count;
}

void valences_are_arcs(const SeparatrixGraph& graph, Findings& findings) {
  const std::vector<int> count = arcs_at_nodes(graph);
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    const GraphNode& node = graph.nodes[i];
    if (std::find(graph.t_junctions.begin(), graph.t_junctions.end(), static_cast<int>(i)) != graph.t_junctions.end())
      continue;
    // On the boundary V quads lie between V + 1 arcs; a degenerate corner (V = 0) has its two sides all the same.
    const int expected = node.curve < 0 ? node.valence : std::max(node.valence, 1) + 1;
    if (count[i] != expected)
      findings.add("node {} has {} arcs, not the {} that valence {} asks for, at {}", i, count[i], expected,
                   node.valence, place(graph.face, node.position));
  }
}

/// With F four-sided faces, and three sides where a corner is degenerate, 4 F = 2 inner + boundary arcs + degenerate
/// corners, and nodes - arcs + F is the Euler characteristic.
void census_holds(const SeparatrixGraph& graph, Findings& findings) {
  if (!graph.t_junctions.empty()) return;  // their faces have sides of several arcs
  const int num_arcs = static_cast<int>(graph.arcs.size());
  const auto num_outer = static_cast<int>(
      std::count_if(graph.arcs.begin(), graph.arcs.end(), [](const auto& a) { return a.is_boundary; }));
  const auto num_degenerate = static_cast<int>(std::count_if(
      graph.nodes.begin(), graph.nodes.end(), [](const auto& n) { return n.curve >= 0 && n.valence == 0; }));
  const int four_faces = 2 * (num_arcs - num_outer) + num_outer + num_degenerate;
  const int four_euler = 4 * (static_cast<int>(graph.nodes.size()) - num_arcs) + four_faces;
  if (four_euler != 4 * graph.face.euler_characteristic())
    findings.add("{} nodes and {} arcs ({} on the boundary) cannot bound four-sided faces only", graph.nodes.size(),
                 num_arcs, num_outer);
}

constexpr Rule<SeparatrixGraph> rules[] = {
    {"SEP-R01", RuleKind::structure, [](const auto& g, Findings& f) { splines_are_sound(view(g), f); }},
    {"SEP-R02", RuleKind::structure, [](const auto& g, Findings& f) { graph_indices_exist(view(g), f); }},
    {"SEP-R03", RuleKind::structure, lines_exist},
    {"SEP-R04", RuleKind::structure, [](const auto& g, Findings& f) { pieces_are_sound(view(g), f); }},
    {"SEP-R05", RuleKind::quick, [](const auto& g, Findings& f) { arcs_are_chains(view(g), f); }},
    {"SEP-R06", RuleKind::quick, [](const auto& g, Findings& f) { boundary_is_covered(view(g), f); }},
    {"SEP-R07", RuleKind::quick, [](const auto& g, Findings& f) { node_kinds_fit(view(g), f); }},
    {"SEP-R08", RuleKind::quick, lines_are_chains},
    {"SEP-R09", RuleKind::full, valences_are_arcs},
    {"SEP-R10", RuleKind::full, census_holds},
};

}  // namespace

std::vector<Violation> check_separatrix_graph(const SeparatrixGraph& graph, CheckDepth depth) {
  std::vector<Violation> all = check_cad_face(graph.face, depth);
  if (!all.empty()) return all;
  return apply_rules(rules, graph, depth);
}

}  // namespace quadrille
