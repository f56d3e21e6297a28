#include "couple/periodic_nodes.hpp"

#include <algorithm>
#include <optional>

#include "couple/join_layouts.hpp"
#include "couple/side_pairs.hpp"
#include "curve/nurbs.hpp"
#include "graph/divide_at_point.hpp"
#include "model/periodic.hpp"

namespace quadrille::couple {
namespace {

// A node inside a curve and the boundary arcs beside it.
void move_node(SeparatrixGraph& graph, int node, const BoundaryPoint& point) {
  GraphNode& n = graph.nodes[node];
  for (GraphArc& arc : graph.arcs) {
    if (!arc.is_boundary) continue;
    ArcPiece &first = arc.pieces.front(), &last = arc.pieces.back();
    if (arc.from == node && first.curve == point.curve) first.t0 = point.t;
    if (arc.to == node && last.curve == point.curve) last.t1 = point.t;
  }
  n.t = point.t;
  n.position = point.position(graph.face);
}

// Where a boundary arc runs through a point.
struct InArc {
  int arc = -1;
  curve::ChainPoint at;
};

// No value where a node is.
std::optional<InArc> arc_through(const ArcGraph& graph, int curve, double t) {
  const Nurbs& c = graph.face.curves[curve];
  for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a) {
    const std::vector<ArcPiece>& pieces = graph.arcs[a].pieces;
    if (!graph.arcs[a].is_boundary) continue;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (pieces[i].curve != curve) continue;
      const bool is_start = is_same_parameter(c, t, pieces[i].t0), is_end = is_same_parameter(c, t, pieces[i].t1);
      if ((is_start && i == 0) || (is_end && i + 1 == pieces.size())) return std::nullopt;
      if (is_start || is_end || (t > pieces[i].t0 && t < pieces[i].t1))
        return InArc{a, {curve::point(c, t), curve::tangent(c, t), static_cast<int>(i), t}};
    }
  }
  return std::nullopt;
}

// Returns whether there was no node.
bool divide_at(graph::CandidateLayout& layout, int curve, double t) {
  const std::optional<InArc> found = arc_through(layout.graph(), curve, t);
  if (found) graph::divide_at_point(layout.subdivision, {found->arc}, found->at);
  return found.has_value();
}

bool has_node(const ArcGraph& graph, int curve, double t) {
  const Nurbs& c = graph.face.curves[curve];
  return std::any_of(graph.arcs.begin(), graph.arcs.end(), [&](const GraphArc& arc) {
    if (!arc.is_boundary) return false;
    const ArcPiece &first = arc.pieces.front(), &last = arc.pieces.back();
    return (first.curve == curve && is_same_parameter(c, t, first.t0)) ||
           (last.curve == curve && is_same_parameter(c, t, last.t1));
  });
}

// The parameters of the ends of boundary arcs on a curve.
std::vector<double> node_parameters(const ArcGraph& graph, int curve) {
  std::vector<double> parameters;
  for (const GraphArc& arc : graph.arcs) {
    if (!arc.is_boundary) continue;
    if (arc.pieces.front().curve == curve) parameters.push_back(arc.pieces.front().t0);
    if (arc.pieces.back().curve == curve) parameters.push_back(arc.pieces.back().t1);
  }
  return parameters;
}

}  // namespace

void snap_periodic_nodes(SeparatrixGraph& graph) {
  const CadFace& face = graph.face;
  for (const PeriodicPair& pair : face.periodic_pairs) {
    const auto [a, b] = pair.curves;
    for (int n = 0; n < static_cast<int>(graph.nodes.size()); ++n) {
      const GraphNode& node = graph.nodes[n];
      if (node.curve != b || node.t == face.curves[b].begin()) continue;
      for (const GraphNode& other : graph.nodes) {
        if (other.curve != a || other.t == face.curves[a].begin()) continue;
        const BoundaryPoint image{b, periodic_parameter(face, a, other.t, b)};
        if (distance(image.position(face), node.position) > relative_same * face.diameter) continue;
        move_node(graph, n, image);
        break;
      }
    }
  }
  close_lines(graph);
}

int divide_periodic_sides(graph::CandidateLayout& layout) {
  int num_divided = 0;
  for (const SidePair& pair : periodic_sides({layout.graph().face, {}, {}, {}})) {
    const CadFace& face = layout.graph().face;
    const int first = pair.curves[0].front(), last = pair.curves[0].back();
    num_divided += divide_at(layout, first, face.curves[first].begin());
    num_divided += divide_at(layout, last, face.curves[last].end());
  }
  const std::vector<PeriodicPair> pairs = layout.graph().face.periodic_pairs;
  for (const PeriodicPair& pair : pairs)
    for (const int side : {0, 1}) {
      const int own = pair.curves[side], other = pair.curves[1 - side];
      for (const double t : node_parameters(layout.graph(), own)) {
        const double image = periodic_parameter(layout.graph().face, own, t, other);
        if (!has_node(layout.graph(), other, image)) num_divided += divide_at(layout, other, image);
      }
    }
  return num_divided;
}

}  // namespace quadrille::couple
