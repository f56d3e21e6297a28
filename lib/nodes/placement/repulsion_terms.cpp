#include "placement/repulsion_terms.hpp"

#include <algorithm>

#include "base/angle.hpp"

namespace quadrille::placement {

namespace {

struct Charge {
  Vec2 position;
  double value;
};

std::vector<Charge> boundary_charges(const CadFace& face, const CriticalPoints& points) {
  std::vector<Charge> charges;
  for (const Corner& c : points.corners)
    charges.push_back({c.position, 4 - 2 * pi * c.valence / face.joints[c.joint].interior_angle});
  for (const IrregularBoundaryPoint& b : points.boundary_nodes) charges.push_back({b.position, 4.0 - 2 * b.valence});
  return charges;
}

Vec2 other_position(const RepulsionTerm& term, const CriticalPoints& points) {
  return term.other ? points.critical_points[*term.other].position : term.position;
}

}  // namespace

std::vector<RepulsionTerm> repulsion_terms(const CadFace& face, const CriticalPoints& points,
                                           const std::vector<bool>& is_free, double greatest_reach) {
  const std::vector<Charge> charges = boundary_charges(face, points);
  const int n = static_cast<int>(points.critical_points.size());
  std::vector<RepulsionTerm> terms;
  const auto add = [&](RepulsionTerm term, double product) {
    if (product > -1e-6) return;
    term.reach = std::min(greatest_reach, pair_distance(term, points) / 2);
    term.strength = -2 * pi * product;
    terms.push_back(term);
  };
  for (int i = 0; i < n; ++i) {
    const int d = 4 - points.critical_points[i].valence;
    for (int j = i + 1; j < n; ++j)
      if (is_free[i] || is_free[j]) add({i, j, {}, 0, 0}, d * (4 - points.critical_points[j].valence));
    if (!is_free[i]) continue;
    for (const Charge& charge : charges) add({i, {}, charge.position, 0, 0}, d * charge.value);
  }
  return terms;
}

double pair_distance(const RepulsionTerm& term, const CriticalPoints& points) {
  return distance(points.critical_points[term.node].position, other_position(term, points));
}

double repulsion_energy(const RepulsionTerm& term, const CriticalPoints& points, std::vector<Vec2>& gradient) {
  const double r = pair_distance(term, points);
  if (r >= term.reach) return 0;
  const double excess = term.reach / r - 1;
  const double slope = -3 * term.strength * excess * excess * term.reach / (r * r);
  const Vec2 away = slope / r * (points.critical_points[term.node].position - other_position(term, points));
  gradient[term.node] += away;
  if (term.other) gradient[*term.other] -= away;
  return term.strength * excess * excess * excess;
}

}  // namespace quadrille::placement
