#include "sew/half_edges.hpp"

#include <algorithm>
#include <map>

#include "base/angle.hpp"
#include "curve/arc_length.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::sew {
namespace {

/// Directions are compared at this part of the length of the shortest curve at the node.
constexpr double compared_at = 1e-3;

struct Node {
  std::vector<int> in, out;
  double shortest = 0;  ///< length of a curve
};

std::map<int, Node> nodes_of(const std::vector<SideOfCurve>& sides) {
  std::map<int, Node> nodes;
  for (int s = 0; s < static_cast<int>(sides.size()); ++s) {
    const double length = curve::ArcLength(sides[s].curve.curve).total();
    nodes[sides[s].from].out.push_back(s);
    nodes[sides[s].to].in.push_back(s);
    for (const int n : {sides[s].from, sides[s].to})
      nodes[n].shortest = nodes[n].shortest > 0 ? std::min(nodes[n].shortest, length) : length;
  }
  return nodes;
}

/// The direction in which the side leaves its start, or looks back from its end.
double angle_at(const Nurbs& curve, bool is_at_start, double away) {
  const curve::ArcLength length(curve);
  const double t = length.parameter(is_at_start ? away : length.total() - away);
  return angle_of(curve::point(curve, t) - (is_at_start ? curve.poles.front() : curve.poles.back()));
}

/// The side that starts next clockwise from the direction back along side `in`.
int successor(const std::vector<SideOfCurve>& sides, const Node& node, int in) {
  if (node.out.size() == 1) return node.out.front();
  const double away = compared_at * node.shortest;
  const double back = angle_at(sides[in].curve.curve, false, away);
  int best = -1;
  double least = 0;
  for (const int out : node.out) {
    const double turn =
        out == sides[in].twin ? 2 * pi : wrap_two_pi(back - angle_at(sides[out].curve.curve, true, away));
    if (best < 0 || turn < least) best = out, least = turn;
  }
  return best;
}

}  // namespace

std::vector<std::vector<int>> traced_loops(const std::vector<SideOfCurve>& sides) {
  std::vector<int> next(sides.size(), -1);
  for (const auto& [number, node] : nodes_of(sides))
    for (const int in : node.in) next[in] = successor(sides, node, in);
  std::vector<std::vector<int>> loops;
  std::vector<bool> is_done(sides.size(), false);
  for (int first = 0; first < static_cast<int>(sides.size()); ++first) {
    if (is_done[first]) continue;
    loops.emplace_back();
    for (int s = first; !is_done[s]; s = next[s]) {
      is_done[s] = true;
      loops.back().push_back(s);
    }
  }
  return loops;
}

}  // namespace quadrille::sew
