#pragma once
// Separatrices on mirror axes.
//
// A separatrix that starts on a mirror axis of the field, along it, is that axis. Where the field turns away from the
// axis on both sides, lines beside it leave it exponentially, and an integrated line would leave it to the side to
// which round-off pushes it: images of one line would end at different places. Such lines are launched as straight
// ones.

#include <optional>
#include <vector>

#include "field/evaluate.hpp"
#include "model/critical_points.hpp"
#include "trace/launch.hpp"
#include "trace/streamline.hpp"

namespace quadrille::trace {

struct MirrorAxis {
  Vec2 point, direction;  ///< of unit length
};

/// The axes of reflections that map the face and its nodes, with their valences, onto themselves (curve/symmetry). None
/// if windings of holes are prescribed, which need not be symmetric.
std::vector<MirrorAxis> mirror_axes(const CadFace& face, const CriticalPoints& points);

struct PlannedLaunch {
  Launch launch;
  std::optional<Launch> straight;  ///< if it starts on a mirror axis, nearly along it
};

std::vector<PlannedLaunch> plan_launches(const field::FieldEvaluator& evaluator, const std::vector<MirrorAxis>& axes,
                                         const std::vector<Launch>& launches);

/// Whether the field has the line's direction at the ends of all of its steps, within 0.01 radians: it need not be
/// symmetric although face and nodes are.
bool follows_field(const field::FieldEvaluator& evaluator, const Streamline& line);

}  // namespace quadrille::trace
