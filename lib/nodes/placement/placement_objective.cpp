#include "placement/placement_objective.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "curve/gauss.hpp"

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

double mean_scale(const LogScale& log_scale, const curve::FaceBoundary& boundary, Vec2 x, Vec2 y) {
  if (!log_scale) return 1;
  const double length = distance(x, y);
  const double part = length > 0 ? std::min(1.0, boundary.length_inside(x, (y - x) / length) / length) : 0;
  Vec2 slope;
  return curve::gauss_integral<3>([&](double u) { return std::exp(log_scale(x + part * u * (y - x), slope)); }, 0, 1);
}

NodeEnergy PlacementObjective::at(const CriticalPoints& points) const {
  NodeEnergy sum = energy(points);
  for (const int k : free) {
    const double d = 4 - points.critical_points[k].valence, factor = weight * pi * d * d;
    Vec2 slope;
    sum.value -= factor * boundary.log_smooth(points.critical_points[k].position, slope);
    sum.gradient[k] -= factor * slope;
    if (!log_scale) continue;
    const double of_scale = pi * d * (d - 8);
    sum.value += of_scale * log_scale(points.critical_points[k].position, slope);
    sum.gradient[k] += of_scale * slope;
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
    limit(norm(moves[k]), boundary.nearest(nodes[k].position).distance);
    for (int j = 0; j < static_cast<int>(nodes.size()); ++j)
      if (j != k) limit(distance(moves[k], moves[j]), distance(nodes[k].position, nodes[j].position));
  }
  for (const RepulsionTerm& term : repulsion)
    if (!term.other) limit(norm(moves[term.node]), pair_distance(term, points));
  return part;
}

}  // namespace quadrille::placement
