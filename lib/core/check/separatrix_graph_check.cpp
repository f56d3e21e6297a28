#include <algorithm>
#include <iterator>

#include "check/rules.hpp"
#include "model/interfaces.hpp"

namespace quadrille::check {

namespace {

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
    // On the boundary V quads lie between V + 1 arcs; a degenerate corner (V = 0) has two boundary arcs as well.
    const int expected = node.is_inner() ? node.valence : std::max(node.valence, 1) + 1;
    if (count[i] != expected)
      findings.add("node {} has {} arcs, not the {} that valence {} requires, at {}", i, count[i], expected,
                   node.valence, position_text(graph.face, node.position));
  }
}

/// With F four-sided faces, and three sides where a corner is degenerate, 4 F = 2 inner + boundary arcs + degenerate
/// corners, and nodes - arcs + F is the Euler characteristic.
void four_sided_count_holds(const SeparatrixGraph& graph, Findings& findings) {
  if (!graph.t_junctions.empty()) return;  // sides of their faces consist of several arcs
  const int num_arcs = static_cast<int>(graph.arcs.size());
  const auto num_outer = static_cast<int>(
      std::count_if(graph.arcs.begin(), graph.arcs.end(), [](const auto& a) { return a.is_boundary; }));
  const auto num_degenerate = static_cast<int>(std::count_if(
      graph.nodes.begin(), graph.nodes.end(), [](const auto& n) { return !n.is_inner() && n.valence == 0; }));
  const int four_faces = 2 * (num_arcs - num_outer) + num_outer + num_degenerate;
  const int four_euler = 4 * (static_cast<int>(graph.nodes.size()) - num_arcs) + four_faces;
  if (four_euler != 4 * euler_characteristic_of_whole(graph))
    findings.add("{} nodes and {} arcs ({} on the boundary) cannot bound four-sided faces only", graph.nodes.size(),
                 num_arcs, num_outer);
}

void certificate_is_sound(const SeparatrixGraph& graph, Findings& findings) {
  const LayoutCertificate& c = graph.certificate;
  if (c.t_junctions < 0 || c.merged_lines < 0 || c.collapsed_chords < 0 || c.shortened_spirals < 0)
    findings.add("a count of the certificate is negative");
  if (!(c.largest_deviation_degrees >= 0 && c.largest_deviation_degrees < 180))
    findings.add("the certificate's largest deviation, {:.6g} degrees, is outside 0 to 180",
                 c.largest_deviation_degrees);
  for (std::size_t i = 0; i < c.face_valence_histogram.size(); ++i)
    if (c.face_valence_histogram[i].faces < 1 ||
        (i > 0 && c.face_valence_histogram[i].corners <= c.face_valence_histogram[i - 1].corners))
      return findings.add("the certificate's face_valence_histogram does not count faces by rising corners");
}

void certified_index_sum_holds(const SeparatrixGraph& graph, Findings& findings) {
  const LayoutCertificate& c = graph.certificate;
  if (!c.method) return;
  const int expected = 4 * euler_characteristic_of_whole(graph);
  if (c.index_sum != index_sum_of(graph) || c.index_sum != expected)
    findings.add("the certificate's index sum is {}, that of the nodes {}, that of the face {}", c.index_sum,
                 index_sum_of(graph), expected);
}

/// Faces and their corners, counted without walking round them: a connected graph has chi - nodes + arcs faces, and the
/// sectors at a node of valence V, V quarter turns together, have 2 corners each less V.
void certified_face_count_holds(const SeparatrixGraph& graph, Findings& findings) {
  const LayoutCertificate& c = graph.certificate;
  if (!c.method) return;
  long long faces = 0, corners = 0, expected_corners = 0;
  for (const FaceCount& count : c.face_valence_histogram) {
    faces += count.faces;
    corners += static_cast<long long>(count.corners) * count.faces;
  }
  const std::vector<int> num_arcs = arcs_at_nodes(graph);
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    const GraphNode& node = graph.nodes[i];
    expected_corners += 2LL * (node.is_inner() ? num_arcs[i] : num_arcs[i] - 1) - node.valence;
  }
  const long long expected_faces =
      euler_characteristic_of_whole(graph) + std::ssize(graph.arcs) - std::ssize(graph.nodes);
  if (faces != expected_faces || corners != expected_corners)
    findings.add("the certificate counts {} faces of {} corners together, the graph has {} of {}", faces, corners,
                 expected_faces, expected_corners);
  if (c.t_junctions != std::ssize(graph.t_junctions))
    findings.add("the certificate counts {} T-junctions, the graph has {}", c.t_junctions, graph.t_junctions.size());
}

/// Every face of a layout has four corners. A degenerate corner counts as two.
void certified_layout_conforms(const SeparatrixGraph& graph, Findings& findings) {
  const LayoutCertificate& c = graph.certificate;
  if (!c.method || c.method == LayoutMethod::t_mesh) return;
  const bool is_four_sided = std::all_of(c.face_valence_histogram.begin(), c.face_valence_histogram.end(),
                                         [](const auto& n) { return n.corners == 4; });
  if (!is_four_sided || c.t_junctions != 0)
    findings.add("a {} layout has faces without four corners or T-junctions", enum_name(*c.method));
}

constexpr Rule<SeparatrixGraph> separatrix_graph_rules[] = {
    {"SEP-R01", RuleKind::structure, [](const auto& g, Findings& f) { splines_are_sound(g, f); }},
    {"SEP-R02", RuleKind::structure, [](const auto& g, Findings& f) { graph_indices_exist(g, f); }},
    {"SEP-R03", RuleKind::structure, lines_exist},
    {"SEP-R04", RuleKind::structure, [](const auto& g, Findings& f) { pieces_are_sound(g, f); }},
    {"SEP-R05", RuleKind::quick, [](const auto& g, Findings& f) { arcs_are_chains(g, f); }},
    {"SEP-R06", RuleKind::quick, [](const auto& g, Findings& f) { boundary_is_covered(g, f); }},
    {"SEP-R07", RuleKind::quick, [](const auto& g, Findings& f) { node_kinds_fit(g, f); }},
    {"SEP-R08", RuleKind::quick, lines_are_chains},
    {"SEP-R09", RuleKind::full, valences_are_arcs},
    {"SEP-R10", RuleKind::full, four_sided_count_holds},
    {"SEP-R11", RuleKind::quick, certificate_is_sound},
    {"SEP-R12", RuleKind::full, certified_index_sum_holds},
    {"SEP-R13", RuleKind::full, certified_face_count_holds},
    {"SEP-R14", RuleKind::full, certified_layout_conforms},
};

}  // namespace

std::vector<Violation> violations_of(const SeparatrixGraph& graph, CheckDepth depth) {
  return apply_rules_after(graph.face, separatrix_graph_rules, graph, depth);
}

template std::vector<Violation> check_stage(const SeparatrixGraph&, CheckDepth);

}  // namespace quadrille::check
