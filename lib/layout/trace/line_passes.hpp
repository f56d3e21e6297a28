#pragma once
// Passes of a streamline near points: the local minima of its distance to them.

#include <vector>

#include "base/point_grid.hpp"
#include "trace/streamline.hpp"

namespace quadrille::trace {

/// A part of a line, between two arc lengths, that contains a local minimum of its distance to a point.
struct LinePass {
  double low = 0, high = 0;
  double foot = -1;  ///< arc length of the nearest point; -1: not yet computed (LinePasses::foot)
};

class LinePasses {
 public:
  /// Samples the line at the ends and middles of its steps: they bracket every minimum. `evaluator` and `line` must
  /// outlive it.
  LinePasses(const field::FieldEvaluator& evaluator, const Streamline& line);

  /// The passes of a node, ascending, whose distance is at most max(slope s, max_distance), s the arc length, up to the
  /// sampling. A line that ends before it has passed the node counts only if it ends in the node or nearly abreast of
  /// it (a corner): otherwise a hole may lie between.
  std::vector<LinePass> passes_of(Vec2 node, double slope, double max_distance) const;

  /// Nodes of which the line may have passes, ascending: all others are farther than that from every sample.
  std::vector<int> nodes_near(const PointGrid& nodes, double slope, double max_distance) const;

  /// Arc length of the nearest point of a pass; computed once.
  double foot(Vec2 node, LinePass& pass) const;

 private:
  /// The greatest distance of a node that passes at sample i.
  double reach(size_t i, double slope, double max_distance) const;
  bool ends_beside(Vec2 node) const;

  const field::FieldEvaluator& evaluator_;
  const Streamline& line_;
  std::vector<double> s_;
  std::vector<Vec2> x_;
};

}  // namespace quadrille::trace
