#include "placement/node_guards.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"

namespace quadrille::placement {

namespace {

struct Charge {
  Vec2 place;
  double value;
};

std::vector<Charge> boundary_charges(const CadFace& face, const CriticalPoints& points) {
  std::vector<Charge> charges;
  for (const Corner& c : points.corners)
    charges.push_back({c.position, 4 - 2 * pi * c.valence / face.joints[c.joint].interior_angle});
  for (const IrregularBoundaryPoint& b : points.boundary_nodes) charges.push_back({b.position, 4.0 - 2 * b.valence});
  return charges;
}

}  // namespace

std::vector<NodeGuard> node_guards(const CadFace& face, const CriticalPoints& points, const std::vector<bool>& is_free,
                                   double greatest_reach) {
  const std::vector<Charge> charges = boundary_charges(face, points);
  const int n = static_cast<int>(points.critical_points.size());
  std::vector<NodeGuard> guards;
  const auto add = [&](NodeGuard guard, double product) {
    if (product > -1e-6) return;
    guard.reach = std::min(greatest_reach, guarded_distance(guard, points) / 2);
    guard.strength = -2 * pi * product;
    guards.push_back(guard);
  };
  for (int i = 0; i < n; ++i) {
    const int d = 4 - points.critical_points[i].valence;
    for (int j = i + 1; j < n; ++j)
      if (is_free[i] || is_free[j]) add({i, j, {}, 0, 0}, d * (4 - points.critical_points[j].valence));
    if (!is_free[i]) continue;
    for (const Charge& charge : charges) add({i, -1, charge.place, 0, 0}, d * charge.value);
  }
  return guards;
}

double guarded_distance(const NodeGuard& guard, const CriticalPoints& points) {
  const Vec2 other = guard.other < 0 ? guard.place : points.critical_points[guard.other].position;
  return distance(points.critical_points[guard.node].position, other);
}

double guard_energy(const NodeGuard& guard, const CriticalPoints& points, std::vector<Vec2>& gradient) {
  const double r = guarded_distance(guard, points);
  if (r >= guard.reach) return 0;
  const double excess = guard.reach / r - 1;
  const double slope = -3 * guard.strength * excess * excess * guard.reach / (r * r);
  const Vec2 other = guard.other < 0 ? guard.place : points.critical_points[guard.other].position;
  const Vec2 away = slope / r * (points.critical_points[guard.node].position - other);
  gradient[guard.node] += away;
  if (guard.other >= 0) gradient[guard.other] -= away;
  return guard.strength * excess * excess * excess;
}

}  // namespace quadrille::placement
