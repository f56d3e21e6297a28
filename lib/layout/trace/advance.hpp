#pragma once
// Integration of streamlines of the guided cross angle, from their launch to the boundary curve, a node or a bound.
//
// Integration runs in reference space, element by element: a step beyond the reference triangle is cut at the edge
// (root of its continuous extension) and continues in the neighbour at the same point of the shared edge. No search for
// elements is needed.

#include "base/point_grid.hpp"
#include "field/evaluate.hpp"
#include "trace/streamline.hpp"

namespace quadrille::trace {

struct AdvanceOptions {
  double tolerance = 1e-10;  ///< bound of a step's estimated error, a length
  double max_step = 0;       ///< a length
  double max_length = 0;     ///< of a line
  double hit_distance = 0;   ///< a line ends within this distance of a node, or of its position one lap before
};

/// Integrates from the launch. A spiral that has reached its limit cycle, and a line of max_stream_steps steps, end
/// with End::length. Throws ComputeError with the position where the field has no direction (it vanishes away from all
/// nodes).
Streamline advance(const field::FieldEvaluator& evaluator, const Launch& launch, const PointGrid& nodes,
                   const AdvanceOptions& options);

/// Continues a line that ended with End::length, to the length of these options: the steps are the same as in a single
/// advance(). Other lines, and limit cycles, are not changed.
void follow(const field::FieldEvaluator& evaluator, Streamline& line, const PointGrid& nodes,
            const AdvanceOptions& options);

}  // namespace quadrille::trace
