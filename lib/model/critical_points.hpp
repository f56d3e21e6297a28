#pragma once
// Zeros of the guiding field and valences of corners (formats/critical-points.md, x.crit.json).
// Valence V = 4 - index for an interior node; at a corner V counts the blocks in its sector.

#include <array>
#include <vector>

#include "base/vec2.hpp"
#include "model/provenance.hpp"

namespace quadrille {

struct CriticalPoint {
  Vec2 position;
  int index = 0;
  int valence = 4;
  int elem = 0;                      ///< element of the field's mesh that holds it
  Vec2 xi;                           ///< reference coordinates there
  std::array<double, 4> jacobian{};  ///< d v / d x at the point: u_x, u_y, v_x, v_y
  double error = 0;                  ///< error bar |J^-1 e| of the position, e the field's error there; 0: unknown
};

struct Corner {
  int joint = 0;  ///< index into face.joints
  Vec2 position;
  double angle_degrees = 0;
  int valence = 2;
  std::array<int, 2> curves{};  ///< incoming and outgoing
};

struct CriticalPoints {
  Provenance provenance;
  std::vector<CriticalPoint> critical_points;
  std::vector<Corner> corners;  ///< every joint with is_corner, in the sequence of the joints
  int index_sum = 0;            ///< sum (4 - V) + sum (2 - V)
  int index_sum_expected = 0;   ///< 4 chi
  Vec2 origin;                  ///< positions are relative to it (cad-face.md)
};

}  // namespace quadrille
