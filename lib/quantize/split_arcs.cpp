#include "quantize/split_arcs.hpp"

namespace quadrille::quantize {
namespace {

void split_arc(const ArcGraph& t_mesh, int a, const curve::Chain& chain, const std::map<int, double>& fractions,
               SplitArcs& split, SeparatrixGraph& graph) {
  const GraphArc& arc = t_mesh.arcs[a];
  GraphArc part{arc.from, arc.to, arc.is_boundary, 0, {}};
  const auto add = [&](const ArcPiece& piece) {  // a crossing at a joint leaves nothing of the piece before it
    if (piece.t0 != piece.t1) part.pieces.push_back(piece);
  };
  const auto finish = [&](int to) {
    part.to = to;
    split.parts[a].push_back(static_cast<int>(graph.arcs.size()));
    graph.arcs.push_back(part);
    part.pieces.clear();
    part.from = to;
  };
  ArcPiece rest = arc.pieces.front();
  size_t k = 0;  // the piece of which `rest` is the remaining part
  for (const auto& [number, fraction] : fractions) {
    const curve::ChainPoint at = chain.at(fraction);
    for (; static_cast<int>(k) < at.piece; rest = arc.pieces[++k]) add(rest);
    add({rest.curve, rest.t0, at.t});
    rest.t0 = at.t;
    const int node = static_cast<int>(graph.nodes.size());
    graph.nodes.push_back(arc.is_boundary ? GraphNode{at.position, NodeKind::boundary, 2, rest.curve, at.t}
                                          : GraphNode{at.position, NodeKind::crossing, 4, -1, 0});
    split.node_of_crossing[{a, number}] = node;
    finish(node);
  }
  add(rest);
  for (++k; k < arc.pieces.size(); ++k) part.pieces.push_back(arc.pieces[k]);
  finish(arc.to);
}

}  // namespace

SplitArcs split_arcs(const ArcGraph& t_mesh, const std::vector<curve::Chain>& chains,
                     const CrossingFractions& fractions, SeparatrixGraph& graph) {
  SplitArcs split;
  split.parts.resize(t_mesh.arcs.size());
  for (int a = 0; a < static_cast<int>(t_mesh.arcs.size()); ++a)
    split_arc(t_mesh, a, chains[a], fractions[a], split, graph);
  return split;
}

}  // namespace quadrille::quantize
