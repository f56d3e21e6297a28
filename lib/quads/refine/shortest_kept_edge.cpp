#include "refine/shortest_kept_edge.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "model/interfaces.hpp"
#include "sizing/name_joints.hpp"

namespace quadrille::refine {
namespace {

class BoundaryWalk {
 public:
  explicit BoundaryWalk(const sizing::MeasuredLayout& measured)
      : measured_(measured), arcs_at_(measured.blocks().nodes.size()) {
    for (int a = 0; a < measured.num_arcs(); ++a)
      if (arc(a).is_boundary) arcs_at_[arc(a).from].push_back(a), arcs_at_[arc(a).to].push_back(a);
  }

  bool is_corner(int node) const { return measured_.blocks().nodes[node].kind == NodeKind::corner; }
  const std::vector<int>& arcs_at(int node) const { return arcs_at_[node]; }

  /// From a corner along boundary arc `a` to the next corner or joint of names. It ends in layouts from damaged files
  /// too, whose boundary need not lead back to a corner.
  double length_from(int corner, int a) const {
    double length = 0;
    int node = corner;
    for (int passed = 0; passed < measured_.num_arcs(); ++passed, a = other_arc(node, a)) {
      const std::vector<double> joints = sizing::name_joints(measured_.chain(a), measured_.blocks().face);
      const bool is_forward = arc(a).from == node;
      if (!joints.empty()) return length + measured_.length(a) * (is_forward ? joints.front() : 1 - joints.back());
      length += measured_.length(a);
      node = is_forward ? arc(a).to : arc(a).from;
      if (is_corner(node)) return length;
    }
    return length;
  }

 private:
  const GraphArc& arc(int a) const { return measured_.blocks().arcs[a]; }
  int other_arc(int node, int a) const {
    const std::vector<int>& both = arcs_at_[node];
    return both.front() == a ? both.back() : both.front();
  }

  const sizing::MeasuredLayout& measured_;
  std::vector<std::vector<int>> arcs_at_;  // the two boundary arcs at each boundary node
};

}  // namespace

double shortest_kept_edge(const sizing::MeasuredLayout& measured) {
  const BoundaryWalk walk(measured);
  double shortest = std::numeric_limits<double>::infinity();
  for (int node = 0; node < static_cast<int>(measured.blocks().nodes.size()); ++node)
    if (walk.is_corner(node))
      for (const int a : walk.arcs_at(node)) shortest = std::min(shortest, walk.length_from(node, a));
  for (int a = 0; a < measured.num_arcs(); ++a) {
    if (!is_on_cad_curve(measured.blocks(), measured.blocks().arcs[a])) continue;
    const std::vector<double> joints = sizing::name_joints(measured.chain(a), measured.blocks().face);
    for (std::size_t k = 1; k < joints.size(); ++k)
      shortest = std::min(shortest, (joints[k] - joints[k - 1]) * measured.length(a));
  }
  return shortest;
}

}  // namespace quadrille::refine
