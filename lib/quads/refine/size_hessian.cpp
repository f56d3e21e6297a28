// The second derivatives of SizeEnergy, and the parts of elements in the resolution ratio.

#include <algorithm>
#include <cmath>

#include "refine/direction_energy.hpp"
#include "refine/point_energy.hpp"
#include "refine/size_energy.hpp"
#include "refine/skew_energy.hpp"

namespace quadrille::refine {
namespace {

/// S B S of a symmetric matrix B, (xx, xy, yy).
std::array<double, 3> stretched(const SymmetricTensor& s, const std::array<double, 3>& b) {
  const SymmetricTensor of{b[0], b[1], b[2]};
  const Vec2 x = of * Vec2{s.xx, s.xy}, y = of * Vec2{s.xy, s.yy};  // B times the columns of S
  return {dot({s.xx, s.xy}, x), dot({s.xx, s.xy}, y), dot({s.xy, s.yy}, y)};
}

/// S on a and on b.
Eigen::Matrix4d of_both(const SymmetricTensor& s) {
  Eigen::Matrix4d both = Eigen::Matrix4d::Zero();
  both.topLeftCorner<2, 2>() << s.xx, s.xy, s.xy, s.yy;
  both.bottomRightCorner<2, 2>() = both.topLeftCorner<2, 2>();
  return both;
}

/// At four corners the parts xx, xy, yy: of the vertex there, and of those at the other ends of its sides.
using CornerBlocks = std::array<std::array<std::array<double, 4>, 3>, 3>;

template <class Bends>
void set_blocks(const Bends& at, double by_s, double own_by_t, double by_t, int corner, CornerBlocks& blocks) {
  const std::array<std::array<double, 3>, 3> of{at.block(by_s, own_by_t), at.block(by_s, 0), at.block(0, by_t)};
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i) blocks[k][i][corner] = of[k][i];
}

void add_product(Vec2 v, std::array<double, 3>& sum) { sum[0] += v.x * v.x, sum[1] += v.x * v.y, sum[2] += v.y * v.y; }

}  // namespace

/// Adds the diagonal blocks of the Hessian without what may be negative, from the corners alone. At a corner the map
/// depends on the vertex there and on those at the other ends of its sides along s and t.
void SizeEnergy::add_blocks(int elem, const Tangents& at, EnergyDerivatives& sum) const {
  const int last = rule(elem).size - 1, along = last == 3 ? 1 : points - 1;
  const std::array<int, 4> point{0, along, last, last - along};
  const double by_s = inverse_size_[elem].x, by_t = inverse_size_[elem].y;
  const std::array<double, 4> own_by_t{by_t, -by_t, by_t, -by_t};
  const double shape = shape_weights[elem], skew = skew_weights[elem];
  std::array<Vec2, 4> a, b, plane_a, plane_b;
  for (int c = 0; c < 4; ++c) {
    a[c] = at.a[point[c]], b[c] = at.b[point[c]];
    plane_a[c] = in_plane(elem, a[c]), plane_b[c] = in_plane(elem, b[c]);
  }
  CornerBlocks bends, skews;
  for (int c = 0; c < 4; ++c) {  // compiled for several corners at once
    set_blocks(PointBends(a[c], b[c], shape), by_s, own_by_t[c], by_t, c, bends);
    set_blocks(SkewBends(plane_a[c], plane_b[c], skew), by_s, own_by_t[c], by_t, c, skews);
  }
  const auto& v = problem_.follow.elem_vertices()[elem];
  const double weight = multiplicities[elem] / 4;
  for (const int c : {0, 1, 3, 2}) {
    const std::array<Vec2, 3> by{{{by_s, own_by_t[c]}, {by_s, 0}, {0, by_t}}};
    const std::array<int, 3> vertex{v[c], v[c ^ 1], v[3 - c]};
    for (int k = 0; k < 3; ++k) {
      std::array<double, 3> block{bends[k][0][c], bends[k][1][c], bends[k][2][c]};
      if (direction(elem) != Vec2{}) {
        add_product(by[k].x * root_of_direction_bend(a[c], direction(elem)), block);
        add_product(by[k].y * root_of_direction_bend(b[c], direction(elem)), block);
      }
      if (!stretches.empty()) block = stretched(stretches[elem], block);
      for (int i = 0; i < 3; ++i) sum.blocks[vertex[k]][i] += weight * (block[i] + skews[k][i][c]);
    }
  }
}

/// Into sides_, of a side whose points slide with its ends, else -1.
int SizeEnergy::sliding_side(int elem, int side) const {
  const int k = elem_sides_[elem] < 0 ? -1 : curved_[elem_sides_[elem]].side[side];
  return k >= 0 && sides_[k].edge >= 0 ? k : -1;
}

/// Derivatives of a and b by the moves of the corners.
SizeEnergy::MoveSlopes SizeEnergy::move_slopes(int elem) const {
  const auto& v = problem_.follow.elem_vertices()[elem];
  const Rule& at = rule(elem);
  MoveSlopes by_move;
  for (int k = 0; k < at.size; ++k) {
    by_move[k].setZero();
    const std::array<Vec2, 4> slopes = corner_slopes(at.s[k], at.t[k]);
    for (int c = 0; c < 4; ++c) {
      if (problem_.is_fixed[v[c]]) continue;
      const double by_s = inverse_size_[elem].x * slopes[c].x, by_t = inverse_size_[elem].y * slopes[c].y;
      const auto add = [&](int column, Vec2 d) {
        by_move[k].col(2 * c + column) << by_s * d.x, by_s * d.y, by_t * d.x, by_t * d.y;
      };
      const bool slides = problem_.follow.on_boundary(v[c]) >= 0;
      add(0, slides ? tangent_[v[c]] : Vec2{1, 0});
      if (!slides) add(1, {0, 1});
    }
  }
  for (int side = 0; side < 4; ++side)
    if (sliding_side(elem, side) >= 0) add_slides_of_points(elem, side, by_move);
  if (stretches.empty()) return by_move;
  const Eigen::Matrix4d stretch = of_both(stretches[elem]);
  for (int k = 0; k < at.size; ++k) by_move[k] = stretch.lazyProduct(by_move[k]).eval();
  return by_move;
}

/// The points between the ends of a side slide with these.
void SizeEnergy::add_slides_of_points(int elem, int side, MoveSlopes& by_move) const {
  const Sides& sides = curved_[elem_sides_[elem]];
  const CurvedSide& on_curve = sides_[sides.side[side]];
  const SlidingEdge& edge = problem_.boundary.edges()[on_curve.edge];
  const Vec2 scale = inverse_size_[elem];
  const Blend& blended = blend(sides, side);
  const SideFrame frame = side_frame(side, points);
  const bool is_along_a = side % 2 == 0;
  for (const bool is_end : {false, true}) {
    const int corner = (side + is_end) % 4;
    if (problem_.is_fixed[problem_.follow.elem_vertices()[elem][corner]]) continue;
    const double direction = problem_.follow.direction(is_end ? edge.to : edge.from);
    SidePoints shift{};
    for (int p = 1; p < points - 1; ++p) {
      const double t = along_[p];
      shift[p] = direction * (is_end ? t : 1 - t) * (on_curve.tangent[p] - on_curve.tangent[is_end ? points - 1 : 0]);
    }
    const SidePoints slope = slopes_of(shift);
    for (int p = 0; p < points; ++p)
      for (int r = 0; r < points; ++r) {
        const Vec2 by_s = frame.along * blended.value[r] * slope[p], by_t = frame.across * blended.slope[r] * shift[p];
        const Vec2 a = scale.x * (is_along_a ? by_s : by_t), b = scale.y * (is_along_a ? by_t : by_s);
        by_move[frame.point(p, r)].col(2 * corner) += Eigen::Vector4d(a.x, a.y, b.x, b.y);
      }
  }
}

/// What points on curves add where these turn against the derivatives `by` a and b.
void SizeEnergy::add_bends(int elem, const Tangents& by, ElementHessian& sum) const {
  const auto& v = problem_.follow.elem_vertices()[elem];
  std::array<Vec2, 4> force = by_corners(elem, by);
  for (int from = 0; from < 4; ++from) {
    if (sliding_side(elem, from) < 0) continue;
    const CurvedSide& side = sides_[sliding_side(elem, from)];
    const SidePoints by_shift = by_shifts(curved_[elem_sides_[elem]], from, by);
    const SlidingEdge& edge = problem_.boundary.edges()[side.edge];
    const int to = (from + 1) % 4;
    for (int p = 1; p < points - 1; ++p) {
      const double t = along_[p];
      force[from] += (t - 1) * by_shift[p], force[to] += -t * by_shift[p];
      Eigen::Matrix<double, 8, 1> slide = Eigen::Matrix<double, 8, 1>::Zero();
      if (!problem_.is_fixed[v[from]]) slide[2 * from] = problem_.follow.direction(edge.from) * (1 - t);
      if (!problem_.is_fixed[v[to]]) slide[2 * to] = problem_.follow.direction(edge.to) * t;
      sum += std::max(0.0, dot(by_shift[p], side.bend[p])) * slide * slide.transpose();
    }
  }
  for (int c = 0; c < 4; ++c)
    if (!problem_.is_fixed[v[c]] && problem_.follow.on_boundary(v[c]) >= 0)
      sum(2 * c, 2 * c) += std::max(0.0, dot(force[c], bend_[v[c]]));
}

/// The second derivatives by a and b of the terms of angles: of skewness in the plane, and of directions.
Eigen::Matrix4d SizeEnergy::bend_of_angles(int elem, Vec2 a, Vec2 b) const {
  Eigen::Matrix4d sum = skew_hessian(in_plane(elem, a), in_plane(elem, b), skew_weights[elem]);
  if (!stretches.empty()) {
    const Eigen::Matrix4d back = of_both(inverse(stretches[elem]));
    sum = (back * sum * back).eval();
  }
  if (direction(elem) == Vec2{}) return sum;
  sum.topLeftCorner<2, 2>() += direction_bend(a, direction(elem));
  sum.bottomRightCorner<2, 2>() += direction_bend(b, direction(elem));
  return sum;
}

ElementHessian SizeEnergy::hessian(int elem) const {
  const Tangents at = tangents(elem);
  const MoveSlopes by_move = move_slopes(elem);
  const Rule& of = rule(elem);
  ElementHessian sum = ElementHessian::Zero();
  for (int k = 0; k < of.size; ++k) {
    const double weight = multiplicities[elem] * of.weight[k];
    const Eigen::Matrix4d bend =
        weight * point_hessian(at.a[k], at.b[k], shape_weights[elem], bend_of_angles(elem, at.a[k], at.b[k]));
    const Eigen::Matrix<double, 4, 8> column = bend.lazyProduct(by_move[k]);
    sum += by_move[k].transpose().lazyProduct(column);
  }
  Tangents by;
  slopes(elem, at, by);
  add_bends(elem, by, sum);
  return sum;
}

std::vector<ElementHessian> SizeEnergy::hessians() const {
  std::vector<ElementHessian> hessians(is_free_.size());
  for (std::size_t elem = 0; elem < is_free_.size(); ++elem)
    if (is_free_[elem]) hessians[elem] = hessian(static_cast<int>(elem));
  return hessians;
}

std::vector<mesh::ElementPowers> SizeEnergy::powers(const std::vector<double>& lengths) const {
  std::vector<mesh::ElementPowers> powers(lengths.size());
  for (std::size_t elem = 0; elem < lengths.size(); ++elem) {
    if (!(lengths[elem] > 0)) continue;
    const Tangents at = tangents(static_cast<int>(elem), curved_rule_);
    const Vec2 scale = lengths[elem] * inverse_size_[elem];
    for (int k = 0; k < curved_rule_.size; ++k) {
      const Vec2 a = at.a[k] / scale.x, b = at.b[k] / scale.y;
      const double area = curved_rule_.weight[k] * std::abs(cross(a, b)), aa = norm2(a), bb = norm2(b);
      powers[elem].along[0] += area * aa * aa * aa * aa;
      powers[elem].along[1] += area * bb * bb * bb * bb;
      powers[elem].area += area;
    }
  }
  return powers;
}

}  // namespace quadrille::refine
