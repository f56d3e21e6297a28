#pragma once
// A streamline of the guided cross angle: its launch, the steps of its integration, how it ended, and its passes of
// nodes, the local minima of its distance to them.
//
//   d xi / d s = (d x / d xi)^-1 e(psi'(x(xi))),   s the arc length, psi' the guided cross angle (paper, eq. 2 ff.)
//
// A step lies in the reference triangle of one element: the embedded Runge-Kutta pair of Dormand and Prince, orders 5
// and 4, with its continuous extension of order 4 (Hairer, Norsett, Wanner, "Solving ODEs I", II.5-6).

#include <array>
#include <unordered_map>
#include <vector>

#include "base/point_grid.hpp"
#include "base/vec2.hpp"
#include "field/evaluate.hpp"
#include "graph/build_graph.hpp"
#include "trace/launch.hpp"

namespace quadrille::trace {

/// The `elem` of a step whose coordinates are positions in the plane, as those of tests/benchmarks/adams_bashforth.
inline constexpr int in_the_plane = -1;

/// An accepted step, or the part of it up to the element's edge.
struct StreamStep {
  int elem = 0;       ///< or in_the_plane
  double s = 0;       ///< arc length at its beginning
  double h = 0;       ///< length of the whole step
  double length = 0;  ///< of the part that is used, <= h
  std::array<Vec2, 5> dense{};

  /// Reference coordinates at fraction theta of h.
  Vec2 xi(double theta) const;
  /// d xi / d theta.
  Vec2 slope(double theta) const;
};

/// State between steps.
struct StreamState {
  int elem = 0;
  Vec2 xi;
  double angle = 0;          ///< direction of the line, radians, continuous
  Vec2 rate;                 ///< d xi / d s
  bool is_straight = false;  ///< the direction stays as it is, whatever the field is
};

/// The state at (elem, xi) with the direction of the cross nearest to `direction` (radians), or with `direction` itself
/// if the line is straight.
StreamState stream_state(const field::FieldEvaluator& evaluator, int elem, Vec2 xi, double direction,
                         bool is_straight = false);

/// Tries a step of length h from `state`. `step.dense` and `end` receive the result; `error` is the estimated error's
/// length in the plane, infinite if the direction turns by more than 0.6 rad within the step, the field vanishes, or
/// det(dx/dxi) is not positive.
void try_step(const field::FieldEvaluator& evaluator, const StreamState& state, double h, StreamStep& step,
              StreamState& end, double& error);

/// The local edge through which a step exits its element, and the fraction of the step before it; edge -1: the step
/// ends inside.
struct ElementExit {
  int edge = -1;
  double fraction = 2;
};

/// The first edge that the step crosses outwards. A point up to 1e-12 (barycentric) beyond an edge counts as inside, so
/// that a line that grazes an edge does not alternate between both elements without advancing.
ElementExit first_exit(const StreamStep& step);

/// Fraction along local edge `edge` at which `xi` lies, in [0, 1], as in spectral::tri_edge_point.
double fraction_along_edge(int edge, Vec2 xi);

/// The arc length after which the tangent at `state` is outside the element by a twentieth of its size, at most
/// `limit`: much farther outside the polynomial of the field is inaccurate.
double length_to_exit(const StreamState& state, double limit);

/// Lines whose directions differ by less, radians, run along each other: far above errors of integration, and two lines
/// of one node are never as near.
inline constexpr double same_direction = 1e-3;

/// Of one line. Lines of 20 diameters need up to 18,000.
inline constexpr int max_stream_steps = 40000;

/// Where a line leaves the face. Curve -1: nowhere.
struct ExitPoint {
  int curve = -1;
  double t = 0;
  Vec2 position;
};

class Streamline {
 public:
  enum class End { boundary, node, length };
  /// A crossing of an element's edge, at arc length s.
  struct Pass {
    StreamState state;
    double s = 0;
  };
  /// What integration continues from.
  struct Front {
    StreamState state;
    double next_step = 0;                  ///< that is tried first
    std::unordered_map<int, Pass> passes;  ///< where the line last crossed each element edge, by 3 elem + edge
  };

  Launch launch;
  std::vector<StreamStep> steps;
  End end = End::length;
  graph::LineEnd reached;  ///< the node or the position on the boundary; neither for End::length
  Vec2 end_position;       ///< on the curve or the node, exactly
  double end_angle = 0;
  Front front;
  /// End::length: the line has returned to its crossing of an element's edge one lap before, within the hit distance
  /// and in the same direction: further laps repeat this one.
  bool is_limit_cycle = false;

  double length() const { return steps.empty() ? launch.radius : steps.back().s + steps.back().length; }
  /// Whether it has reached neither boundary nor node: it was too long, or it is a limit cycle.
  bool is_endless() const { return end == End::length; }
  /// Whether it has no end because its steps became too short: it cannot be continued.
  bool is_stuck() const { return is_endless() && steps.size() >= max_stream_steps; }
  /// Makes at() faster; to be called after steps were appended.
  void index_steps();
  /// Position at arc length s in [0, length()].
  Vec2 at(const field::FieldEvaluator& evaluator, double s) const;
  /// Position and unit direction.
  Vec2 at(const field::FieldEvaluator& evaluator, double s, Vec2& direction) const;
  /// Arc lengths at which steps begin, and the end.
  std::vector<double> step_ends() const;

 private:
  Vec2 lead_in(double s, Vec2& direction) const;
  const StreamStep& step_at(double s) const;

  std::vector<double> step_starts_;  // s of the steps that are indexed, near each other in memory
};

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
