#include "trace/fixed_nodes.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/position_text.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::trace {
namespace {

graph::FixedNode irregular_node(const CadFace& face, const CriticalPoint& p) {
  if (p.valence > 2) return {p.position, NodeKind::irregular, p.valence, -1};
  throw ComputeError(
      fmt::format("the zero of the field at {} has index {:+d}: it must be split into nodes of valence "
                  "3: run critpoints",
                  position_text(p.position + face.origin), p.index));
}

graph::FixedNode corner_node(const CadFace& face, const Corner& c) {
  if (c.valence > 0) return {face.joints[c.joint].position, NodeKind::corner, c.valence, c.joint};
  throw ComputeError(
      fmt::format("the corner of {:.1f} degrees at {} has valence 0 and makes a block of three sides: critpoints "
                  "--degenerate divide splits it into three blocks of four sides",
                  c.angle_degrees, position_text(c.position + face.origin)));
}

graph::FixedNode boundary_node(const CadFace& face, const IrregularBoundaryPoint& b) {
  const Nurbs& curve = face.curves[b.curve];
  const double tol = 1e-12 * (curve.end() - curve.begin());
  graph::FixedNode node{curve::point(curve, b.t), NodeKind::boundary, b.valence, -1, b.curve, b.t};
  if (b.t <= curve.begin() + tol) node.joint = b.curve;
  if (b.t >= curve.end() - tol) node.joint = face.next_in_loop(b.curve);
  if (node.joint >= 0) node.position = face.joints[node.joint].position;
  if (b.valence >= 3) return node;
  throw ComputeError(
      fmt::format("a node of valence {} on the smooth boundary at {} makes a block whose "
                  "sides form a straight angle there: no valid element has such a corner",
                  b.valence, position_text(node.position + face.origin)));
}

}  // namespace

std::vector<graph::FixedNode> fixed_nodes(const CadFace& face, const CriticalPoints& points) {
  std::vector<graph::FixedNode> nodes;
  for (const CriticalPoint& p : points.critical_points) nodes.push_back(irregular_node(face, p));
  for (const Corner& c : points.corners) nodes.push_back(corner_node(face, c));
  for (const IrregularBoundaryPoint& b : points.boundary_nodes) nodes.push_back(boundary_node(face, b));
  return nodes;
}

std::vector<Vec2> positions(const std::vector<graph::FixedNode>& nodes) {
  std::vector<Vec2> positions;
  positions.reserve(nodes.size());
  for (const graph::FixedNode& node : nodes) positions.push_back(node.position);
  return positions;
}

}  // namespace quadrille::trace
