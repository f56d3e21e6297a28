#pragma once
// Rules common to separatrix graphs and block layouts: their splines, nodes and arcs. Private to check.

#include "check/rules.hpp"

namespace quadrille::check {

/// The members that both formats have.
struct GraphView {
  const CadFace& face;
  const std::vector<Nurbs>& splines;
  const std::vector<GraphNode>& nodes;
  const std::vector<GraphArc>& arcs;

  const Nurbs& curve(int id) const {
    return id < face.num_curves() ? face.curves[id] : splines[id - face.num_curves()];
  }
};

void splines_are_sound(const GraphView& graph, Findings& findings);
void graph_indices_exist(const GraphView& graph, Findings& findings);
void pieces_are_sound(const GraphView& graph, Findings& findings);
void arcs_are_chains(const GraphView& graph, Findings& findings);
void boundary_is_covered(const GraphView& graph, Findings& findings);
void node_kinds_fit(const GraphView& graph, Findings& findings);

}  // namespace quadrille::check
