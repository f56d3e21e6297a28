#include "placement/placement_objective.hpp"

#include "base/angle.hpp"

namespace quadrille::placement {

NodeEnergy PlacementObjective::at(const CriticalPoints& points) const {
  NodeEnergy sum = energy(points);
  for (const int k : free) {
    const double d = 4 - points.critical_points[k].valence, factor = weight * pi * d * d;
    Vec2 slope;
    sum.value -= factor * boundary.log_smooth(points.critical_points[k].position, slope);
    sum.gradient[k] -= factor * slope;
  }
  for (const RepulsionTerm& term : repulsion) sum.value += repulsion_energy(term, points, sum.gradient);
  return sum;
}

double PlacementObjective::allowed_part(const CriticalPoints& points, const std::vector<Vec2>& moves) const {
  double part = 1;
  const auto limit = [&](double way, double clearance) {
    if (way * part > clearance / 2) part = clearance / 2 / way;
  };
  const auto& nodes = points.critical_points;
  for (const int k : free) {
    limit(norm(moves[k]), boundary.nearest(nodes[k].position));
    for (int j = 0; j < static_cast<int>(nodes.size()); ++j)
      if (j != k) limit(distance(moves[k], moves[j]), distance(nodes[k].position, nodes[j].position));
  }
  for (const RepulsionTerm& term : repulsion)
    if (!term.other) limit(norm(moves[term.node]), pair_distance(term, points));
  return part;
}

}  // namespace quadrille::placement
