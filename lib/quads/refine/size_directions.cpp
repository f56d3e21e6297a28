// Sizes of elements in SizeEnergy, what a metric, prescribed directions and bent sides change, and where elements are,
// by which the first ones are found.
//
// Of a wave of number k the fourth derivative along a side with curvature kappa is, in sizes, k^4 + 6 k^3 kappa +
// 3 k^2 kappa^2 times |x_s|^4; its phases differ, so that the squared error grows by 1 + 36 X^2 + 9 X^4, X = kappa / k.
// In an element |x_ss| falls as (1 - t)^2 away from the side, and x_tt is kappa |x_s|^2 s (1 - s): the means are
// 1 + 36/5 X^2 + X^4 along the side, and 1 + 6/5 X^2 + X^4 / 70 across. The error grows with the power 2q of a length.

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/angle.hpp"
#include "refine/direction_energy.hpp"
#include "refine/point_energy.hpp"
#include "refine/size_energy.hpp"
#include "refine/skew_energy.hpp"

namespace quadrille::refine {
namespace {

constexpr int elements_per_wave = 3;  ///< of the prescribed size; fewer: bends count less

double shorter_by(double growth) { return std::pow(growth, -0.5 / mesh::resolution_power); }

}  // namespace

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

void SizeEnergy::set_sizes(const std::vector<Vec2>& sizes, std::vector<Vec2> log_size_gradients) {
  double squares = 0, count = 0;
  inverse_size_.assign(sizes.size(), {1, 1});
  for (int elem = 0; elem < static_cast<int>(sizes.size()); ++elem) {
    if (!is_free_[elem]) continue;
    const Tangents at = tangents(elem);
    double area = 0;
    for (int k = 0; k < rule(elem).size; ++k) area += rule(elem).weight[k] * cross(at.a[k], at.b[k]);
    squares += multiplicities[elem] * area / (sizes[elem].x * sizes[elem].y);
    count += multiplicities[elem];
  }
  const double factor = std::sqrt(count / squares);
  for (std::size_t elem = 0; elem < sizes.size(); ++elem)
    inverse_size_[elem] = {factor / sizes[elem].x, factor / sizes[elem].y};
  log_size_gradients_ = std::move(log_size_gradients);
  if (log_size_gradients_.empty()) return;
  first_inverse_size_ = inverse_size_;
  first_middle_.clear();
  for (int elem = 0; elem < static_cast<int>(sizes.size()); ++elem) first_middle_.push_back(middle(elem));
}

/// To those where the elements are now.
void SizeEnergy::update_sizes() {
  for (int elem = 0; elem < static_cast<int>(log_size_gradients_.size()); ++elem)
    inverse_size_[elem] =
        std::exp(-dot(log_size_gradients_[elem], middle(elem) - first_middle_[elem])) * first_inverse_size_[elem];
}

/// The derivative by the middle, as which the lengths grow: `by` are those by x_s and x_t.
Vec2 SizeEnergy::by_middle(int elem, const Tangents& at, const Tangents& by) const {
  if (log_size_gradients_.empty()) return {};
  const Vec2 scale = inverse_size_[elem];
  double by_scale = 0;  // by the logarithm of both inverse lengths
  for (int k = 0; k < rule(elem).size; ++k)
    by_scale += dot(by.a[k], in_plane(elem, at.a[k])) / scale.x + dot(by.b[k], in_plane(elem, at.b[k])) / scale.y;
  return -by_scale * log_size_gradients_[elem];
}

Vec2 SizeEnergy::middle(int elem) const {
  const auto& v = problem_.follow.elem_vertices()[elem];
  return (position_[v[0]] + position_[v[1]] + position_[v[2]] + position_[v[3]]) / 4;
}

/// The mean of a side, where it turns. Edges inside count as straight: as they become shorter their displacement stays,
/// so that the sizes there would be ever shorter than the edges.
double SizeEnergy::curvature(int elem, int side) const {
  const int number = curved_[elem_sides_[elem]].side[side];
  if (number < 0) return 0;
  const auto& v = problem_.follow.elem_vertices()[elem];
  const int from = v[side], to = v[(side + 1) % 4];
  if (sides_[number].edge < 0 && !(problem_.is_fixed[from] && problem_.is_fixed[to])) return 0;
  const Vec2 chord = position_[to] - position_[from];
  const SidePoints& slope = sides_[number].slope;
  double turn = 0;
  for (int p = 1; p < points; ++p) {
    const Vec2 before = chord + slope[p - 1], after = chord + slope[p];
    turn += std::abs(std::atan2(cross(before, after), dot(before, after)));
  }
  return turn / norm(chord);
}

Vec2 SizeEnergy::bend_factors(int elem, double size) const {
  Vec2 factors{1, 1};
  if (elem_sides_[elem] < 0) return factors;
  for (const int side : {0, 1}) {
    const double bend = std::max(curvature(elem, side), curvature(elem, side + 2));
    const double x = bend * elements_per_wave * size / (2 * pi), x2 = x * x;
    const double along = shorter_by(1 + 36.0 / 5 * x2 + x2 * x2), across = shorter_by(1 + 6.0 / 5 * x2 + x2 * x2 / 70);
    factors = side == 0 ? Vec2{factors.x * along, factors.y * across} : Vec2{factors.x * across, factors.y * along};
  }
  return factors;
}

std::vector<Vec2> SizeEnergy::middles(const VertexMoves& moves) {
  place(moves);
  std::vector<Vec2> middles;
  for (int elem = 0; elem < static_cast<int>(is_free_.size()); ++elem) middles.push_back(middle(elem));
  return middles;
}

}  // namespace quadrille::refine
