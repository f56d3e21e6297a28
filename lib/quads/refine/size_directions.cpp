// What a metric and prescribed directions change in SizeEnergy, and where elements are, by which both are found.

#include "refine/direction_energy.hpp"
#include "refine/point_energy.hpp"
#include "refine/size_energy.hpp"
#include "refine/skew_energy.hpp"

namespace quadrille::refine {

/// By S, which is symmetric: derivatives by a become those by x_s / h in the same way.
void SizeEnergy::stretch(int elem, const Rule& of, Tangents& at) const {
  if (stretches.empty()) return;
  for (int k = 0; k < of.size; ++k) at.a.set(k, stretches[elem] * at.a[k]), at.b.set(k, stretches[elem] * at.b[k]);
}

Vec2 SizeEnergy::in_plane(int elem, Vec2 a) const {
  return stretches.empty() ? a : inverse_of_unit(stretches[elem]) * a;
}

/// Adds what keeps the angles in the plane (refine/skew_energy) where a and b are those of a metric.
double SizeEnergy::add_stretched_skewness(int elem, const Tangents& at, Tangents& by) const {
  const Rule& of = rule(elem);
  const SymmetricTensor back = inverse_of_unit(stretches[elem]);
  double sum = 0;
  for (int k = 0; k < of.size; ++k) {
    const Vec2 a = back * at.a[k], b = back * at.b[k];
    PointEnergy e(a, b, 0);
    e.value = 0, e.by_a = e.by_b = {};
    add_skewness(a, b, skew_weights[elem], e);
    const double weight = multiplicities[elem] * of.weight[k];
    sum += weight * e.value;
    by.a.add(k, inverse_size_[elem].x * weight * (back * e.by_a));
    by.b.add(k, inverse_size_[elem].y * weight * (back * e.by_b));
  }
  return sum;
}

/// Adds what prescribed directions add to the derivatives by a and b; returns what they add to the energy.
double SizeEnergy::add_direction(int elem, const Tangents& at, Tangents& by) const {
  const Rule& of = rule(elem);
  const Vec2 scale = inverse_size_[elem];
  double sum = 0;
  for (int k = 0; k < of.size; ++k) {
    const DirectionEnergy a(at.a[k], directions[elem]), b(at.b[k], directions[elem]);
    const double weight = multiplicities[elem] * of.weight[k];
    sum += weight * (a.value + b.value);
    by.a.add(k, scale.x * weight * a.by_a), by.b.add(k, scale.y * weight * b.by_a);
  }
  return sum;
}

std::vector<Vec2> SizeEnergy::middles(const VertexMoves& moves) {
  place(moves);
  std::vector<Vec2> middles;
  for (const auto& v : problem_.follow.elem_vertices())
    middles.push_back((position_[v[0]] + position_[v[1]] + position_[v[2]] + position_[v[3]]) / 4);
  return middles;
}

}  // namespace quadrille::refine
