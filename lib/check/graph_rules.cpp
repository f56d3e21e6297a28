#include "check/graph_rules.hpp"

#include <algorithm>

#include "check/nurbs_rules.hpp"

namespace quadrille::check {

void splines_are_sound(const GraphView& graph, Findings& findings) {
  for (std::size_t i = 0; i < graph.splines.size(); ++i) {
    std::string fault = structure_fault(graph.splines[i]);
    if (fault.empty()) fault = number_fault(graph.splines[i]);
    if (!fault.empty()) findings.add("spline {}: {}", i, fault);
  }
}

void graph_indices_exist(const GraphView& graph, Findings& findings) {
  const std::size_t num_curves = graph.face.curves.size();
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    const GraphNode& node = graph.nodes[i];
    if (node.curve != -1 && !is_index(node.curve, num_curves))
      findings.add("node {}: curve {} does not exist", i, node.curve);
  }
  for (std::size_t i = 0; i < graph.arcs.size(); ++i) {
    const GraphArc& arc = graph.arcs[i];
    if (!is_index(arc.from, graph.nodes.size()) || !is_index(arc.to, graph.nodes.size()))
      findings.add("arc {}: an end node does not exist", i);
    for (const ArcPiece& piece : arc.pieces)
      if (!is_index(piece.curve, num_curves + graph.splines.size()))
        findings.add("arc {}: curve {} does not exist", i, piece.curve);
  }
}

void pieces_are_sound(const GraphView& graph, Findings& findings) {
  for (std::size_t i = 0; i < graph.nodes.size(); ++i)
    if (!is_finite(graph.nodes[i].position) || !is_finite(graph.nodes[i].t))
      findings.add("node {} contains a number that is not finite", i);
  for (std::size_t i = 0; i < graph.arcs.size(); ++i) {
    const GraphArc& arc = graph.arcs[i];
    if (arc.pieces.empty()) findings.add("arc {} has no pieces", i);
    if (arc.length < 0) findings.add("arc {}: its length is negative", i);
    for (const ArcPiece& piece : arc.pieces) {
      const Nurbs& curve = graph.curve(piece.curve);
      const double tol = 1e-12 * (curve.end() - curve.begin());
      const auto is_inside = [&](double t) { return t >= curve.begin() - tol && t <= curve.end() + tol; };
      if (!is_inside(piece.t0) || !is_inside(piece.t1) || piece.t0 == piece.t1)
        findings.add("arc {}: parameters {:.9g} to {:.9g} are not a part of curve {}", i, piece.t0, piece.t1,
                     piece.curve);
      if (arc.is_boundary != (piece.curve < graph.face.num_curves()))
        findings.add("arc {}: boundary arcs follow CAD curves, inner arcs splines", i);
    }
  }
}

namespace {

Vec2 clamped_point(const Nurbs& curve, double t) {
  return curve_point(curve, std::clamp(t, curve.begin(), curve.end()));
}

}  // namespace

void arcs_are_chains(const GraphView& graph, Findings& findings) {
  for (std::size_t i = 0; i < graph.splines.size(); ++i)
    if (has_far_pole(graph.splines[i], graph.face))
      findings.add("spline {} has a pole farther out than 1000 diameters", i);
  const double tol = 1e-5 * graph.face.diameter;  // the gap that FAC-R06 allows at joints
  for (std::size_t i = 0; i < graph.arcs.size(); ++i) {
    const GraphArc& arc = graph.arcs[i];
    Vec2 end = graph.nodes[arc.from].position;
    const auto meet = [&](Vec2 next) {
      if (distance(end, next) > tol)
        findings.add("arc {} is broken: {} and {} do not meet", i, position_text(graph.face, end),
                     position_text(graph.face, next));
    };
    for (const ArcPiece& piece : arc.pieces) {
      meet(clamped_point(graph.curve(piece.curve), piece.t0));
      end = clamped_point(graph.curve(piece.curve), piece.t1);
    }
    meet(graph.nodes[arc.to].position);
  }
}

void boundary_is_covered(const GraphView& graph, Findings& findings) {
  struct Part {
    int curve;
    double low, high;
    auto operator<=>(const Part&) const = default;
  };
  std::vector<Part> parts;
  for (const GraphArc& arc : graph.arcs)
    for (const ArcPiece& piece : arc.pieces)
      if (arc.is_boundary) parts.push_back({piece.curve, std::min(piece.t0, piece.t1), std::max(piece.t0, piece.t1)});
  std::sort(parts.begin(), parts.end());
  std::size_t i = 0;
  for (int c = 0; c < graph.face.num_curves(); ++c) {
    const Nurbs& curve = graph.face.curves[c];
    const double tol = 1e-9 * (curve.end() - curve.begin());
    double t = curve.begin();
    for (; i < parts.size() && parts[i].curve == c && std::abs(parts[i].low - t) <= tol; ++i) t = parts[i].high;
    if (std::abs(t - curve.end()) > tol || (i < parts.size() && parts[i].curve == c))
      return findings.add("the boundary arcs do not cover curve {} exactly once, near parameter {:.9g}", c, t);
  }
}

void node_kinds_fit(const GraphView& graph, Findings& findings) {
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    const GraphNode& node = graph.nodes[i];
    const bool must_be_outer = node.kind == NodeKind::corner || node.kind == NodeKind::boundary;
    const bool must_be_inner = node.kind == NodeKind::crossing;
    if ((must_be_outer && node.curve < 0) || (must_be_inner && node.curve >= 0))
      findings.add("node {}: boundary nodes and corners name a CAD curve, crossings do not", i);
    if (node.valence < 0 || node.valence > 64) findings.add("node {}: valence {} is outside 0 to 64", i, node.valence);
    if (node.curve < 0) continue;
    const Nurbs& curve = graph.face.curves[node.curve];
    const double tol = 1e-9 * (curve.end() - curve.begin());
    if (node.t < curve.begin() - tol || node.t > curve.end() + tol ||
        distance(clamped_point(curve, node.t), node.position) > 1e-5 * graph.face.diameter)
      findings.add("node {} does not lie on curve {} at its parameter, near {}", i, node.curve,
                   position_text(graph.face, node.position));
  }
}

}  // namespace quadrille::check
