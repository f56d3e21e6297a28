#include "refine/direction_energy.hpp"

#include <cmath>

namespace quadrille::refine {

DirectionEnergy::DirectionEnergy(Vec2 a, Vec2 target) {
  const double length2 = norm2(a);
  const Vec2 twice{(a.x * a.x - a.y * a.y) / length2, 2 * a.x * a.y / length2};
  const Vec2 four_times{twice.x * twice.x - twice.y * twice.y, 2 * twice.x * twice.y};
  turn = left_of(a) / length2;
  value = norm(target) - dot(target, four_times);
  by_a = 4 * cross(target, four_times) * turn;
  bend = 16 * dot(target, four_times);
}

Vec2 root_of_direction_bend(Vec2 a, Vec2 target) {
  const DirectionEnergy energy(a, target);
  return std::sqrt(std::abs(energy.bend)) * energy.turn;
}

Eigen::Matrix2d direction_bend(Vec2 a, Vec2 target) {
  const DirectionEnergy energy(a, target);
  const double length4 = norm2(a) * norm2(a), slope = dot(energy.by_a, left_of(a));  // by the angle
  const double xy = 2 * a.x * a.y / length4, yy = (a.y * a.y - a.x * a.x) / length4;
  const Eigen::Vector2d turn(energy.turn.x, energy.turn.y);
  Eigen::Matrix2d sum = energy.bend * turn * turn.transpose();
  sum(0, 0) += slope * xy, sum(1, 1) -= slope * xy;
  sum(0, 1) += slope * yy, sum(1, 0) += slope * yy;
  return sum;
}

}  // namespace quadrille::refine
