#pragma once
// The last step, after all nodes are chosen: elements, order of the nodes.

#include <algorithm>
#include <vector>

#include "base/tolerance.hpp"
#include "field/evaluate.hpp"
#include "model/critical_points.hpp"

namespace quadrille::guide {

/// Sorts by the position at(point): by x, then y, in an order that does not depend on rounding errors, because x values
/// within `tol` count as equal. Comparison with a tolerance is not an ordering, so the points are divided into columns
/// of equal x first, and each column is then sorted by y.
template <typename Point, typename At>
void sort_by_position(std::vector<Point>& points, double tol, const At& at) {
  const auto x_of = [&](const Point& a) { return at(a).x; };
  const auto by_x = [&](const Point& a, const Point& b) { return at(a).x < at(b).x; };
  const auto by_y = [&](const Point& a, const Point& b) { return at(a).y < at(b).y; };
  std::stable_sort(points.begin(), points.end(), by_x);
  for (auto first = points.begin(); first != points.end();) {
    const auto last = end_of_chained_ties(first, points.end(), tol, x_of);
    std::stable_sort(first, last, by_y);
    first = last;
  }
}

/// Which nodes have no position of their own yet: those into which a cluster was split, unless it is far from the
/// boundary, and those added for a line field. The only node of a cluster is at its centre and has a position. A node
/// added for a corner keeps its position: the least energy would move it into the corner again.
std::vector<bool> nodes_without_position(const CadFace& face, const CriticalPoints& points);

/// Sets the element that contains each node and sorts the nodes by position. Throws ComputeError if a node is not
/// inside the mesh.
void complete_nodes(const field::FieldEvaluator& evaluator, CriticalPoints& points);

}  // namespace quadrille::guide
