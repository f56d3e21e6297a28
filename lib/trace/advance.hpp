#pragma once
// Integration of streamlines of the guided cross angle, from their launch to the boundary curve, a node or a bound.
//
// Integration runs in reference space, element by element: a step that leaves the reference triangle is cut at the edge
// (root of its continuous extension) and continues in the neighbour at the same point of the shared edge. Nothing is
// searched for.

#include <vector>

#include "field/evaluate.hpp"
#include "trace/streamline.hpp"

namespace quadrille::trace {

struct AdvanceOptions {
  double tolerance = 1e-10;  ///< bound of a step's estimated error, a length
  double max_step = 0;       ///< a length
  double max_length = 0;     ///< of a line
  double hit_distance = 0;   ///< a line ends where it comes as near as this to a node, or to where it was a lap before
};

/// Integrates from the launch. A spiral ends, as by its length, where it has reached its limit cycle; a line also ends,
/// as by its length, after max_stream_steps. Throws ComputeError where the field has no direction (it vanishes at no
/// node), with the position.
Streamline advance(const field::FieldEvaluator& evaluator, const Launch& launch, const std::vector<Vec2>& nodes,
                   const AdvanceOptions& options);

/// Continues a line that its length ended, to the length of these options: the steps are those of one advance(). Other
/// lines, and limit cycles, stay as they are.
void follow(const field::FieldEvaluator& evaluator, Streamline& line, const std::vector<Vec2>& nodes,
            const AdvanceOptions& options);

}  // namespace quadrille::trace
