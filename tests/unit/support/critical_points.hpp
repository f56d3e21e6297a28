#pragma once
// Irregular nodes and corners of faces made by hand, for tests of the rules that change them.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/angle.hpp"
#include "model/critical_points.hpp"

namespace quadrille::hand_made {

/// A node of the field, with the index of its valence.
inline CriticalPoint node(Vec2 position, int valence) {
  CriticalPoint p;
  p.position = position;
  p.valence = valence;
  p.index = 4 - valence;
  p.jacobian = {1, 0, 0, static_cast<double>(p.index)};
  p.error = 1e-9;
  return p;
}

/// The face's corners with the valences nearest to their angles.
inline std::vector<Corner> corners_of(const CadFace& face) {
  std::vector<Corner> corners;
  for (int j = 0; j < face.num_curves(); ++j) {
    const Joint& joint = face.joints[j];
    if (joint.is_corner)
      corners.push_back({j,
                         joint.position,
                         degrees(joint.interior_angle),
                         static_cast<int>(std::lround(joint.interior_angle / half_pi)),
                         {face.previous_in_loop(j), j}});
  }
  return corners;
}

/// These nodes and the face's corners; their index sum is taken for the expected one.
inline CriticalPoints points_of(const CadFace& face, const std::vector<CriticalPoint>& nodes = {}) {
  CriticalPoints points;
  points.critical_points = nodes;
  points.corners = corners_of(face);
  points.index_sum = points.index_sum_expected = index_sum_of(points);
  return points;
}

inline int index_of(const std::vector<NodeMark>& marks) {
  int sum = 0;
  for (const NodeMark& m : marks) sum += (m.location == NodeLocation::inside ? 4 : 2) - m.valence;
  return sum;
}

/// Each change keeps the index and has a reason.
inline void expect_sound_changes(const std::vector<NodeChange>& changes) {
  for (const NodeChange& change : changes) {
    EXPECT_EQ(index_of(change.before), index_of(change.after)) << change.reason;
    EXPECT_FALSE(change.reason.empty());
  }
}

}  // namespace quadrille::hand_made
