#include "guide/complete_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "surface/positions.hpp"

namespace quadrille::guide {

std::vector<bool> nodes_without_position(const CadFace& face, const CriticalPoints& points) {
  const auto is_at_centre = [&](const CriticalPoint& p) {
    return std::any_of(points.clusters.begin(), points.clusters.end(), [&](const Cluster& cluster) {
      return distance(cluster.centre, p.position) <= 1e-5 * face.diameter;
    });
  };
  std::vector<bool> are_free;
  for (const CriticalPoint& p : points.critical_points)
    are_free.push_back((p.source == NodeSource::cluster && !is_at_centre(p)) || p.source == NodeSource::line);
  return are_free;
}

void complete_nodes(const field::FieldEvaluator& evaluator, CriticalPoints& points) {
  const CadFace& face = evaluator.field().mesh.face;
  for (CriticalPoint& p : points.critical_points) {
    if (p.source == NodeSource::zero) continue;
    const mesh::Location at = evaluator.locator().find(p.position);
    if (at.elem < 0)
      throw ComputeError(
          fmt::format("the irregular node at {} lies outside the face", surface::position_text(face, p.position)));
    p.elem = at.elem;
    p.xi = at.xi;
  }
  sort_by_position(points.critical_points, tolerance::same_point * face.diameter,
                   [](const CriticalPoint& p) { return p.position; });
}

}  // namespace quadrille::guide
