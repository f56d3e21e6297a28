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

/// Adds what skewness adds to the derivatives by x_s / h and x_t / h; returns what it adds to the energy.
double SizeEnergy::add_skewness_in_plane(int elem, const Tangents& at, Tangents& by) const {
  const Rule& of = rule(elem);
  const Vec2 scale = inverse_size_[elem];
  double sum = 0;
  for (int k = 0; k < of.size; ++k) {
    const Vec2 a = in_plane(elem, at.a[k]), b = in_plane(elem, at.b[k]);
    PointEnergy skew(a, b, 0);
    skew.value = 0, skew.by_a = skew.by_b = {};
    add_skewness(a, b, skew_weights[elem], skew);
    const double weight = multiplicities[elem] * of.weight[k];
    sum += weight * skew.value;
    by.a.add(k, scale.x * weight * skew.by_a), by.b.add(k, scale.y * weight * skew.by_b);
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
