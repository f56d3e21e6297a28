#include "trace/require_nodes.hpp"

#include <gtest/gtest.h>

#include "../support/square_field.hpp"
#include "base/error.hpp"

namespace quadrille {
namespace {

// v = (x + i y - a)(...): one zero of index +1 at (0.25, 0.125) in a square whose corners make up for it.
struct OneZero : testing::Test {
  Field field = interpolated_field(square_mesh({-1, -1}, 2, 3), 1, [](Vec2 p) {
    return Vec2{p.x - 0.25, p.y - 0.125};
  });
  FieldEvaluator evaluator{field};

  CriticalPoints points() const {
    CriticalPoints all;
    all.critical_points.push_back({{0.25, 0.125}, 1, 3, 0, {}, {}});
    // 1 + 4 - 1 = 4 chi: one corner counts 2.
    for (int j = 0; j < 4; ++j) all.corners.push_back({j, field.mesh.face.joints[j].position, 90, j == 0 ? 2 : 1, {}});
    return all;
  }
};

TEST_F(OneZero, AcceptsTheFieldsOwnZeros) { EXPECT_NO_THROW(require_nodes_of_field(evaluator, points())); }

TEST_F(OneZero, AcceptsAnErrorBelowAMillionthOfTheDiameter) {
  CriticalPoints p = points();
  p.critical_points[0].position.x += 0.9e-6 * field.mesh.face.diameter;
  EXPECT_NO_THROW(require_nodes_of_field(evaluator, p));
  p.critical_points[0].position.x += 0.2e-6 * field.mesh.face.diameter;
  EXPECT_THROW(require_nodes_of_field(evaluator, p), FormatError);
}

TEST_F(OneZero, RefusesAnotherIndexOrPlace) {
  CriticalPoints p = points();
  p.critical_points[0].index = -1, p.critical_points[0].valence = 5;
  EXPECT_THROW(require_nodes_of_field(evaluator, p), FormatError);
  p = points();
  p.critical_points[0].position = {3, 3};
  EXPECT_THROW(require_nodes_of_field(evaluator, p), FormatError);
}

TEST_F(OneZero, RefusesAWrongIndexSum) {
  CriticalPoints p = points();
  p.critical_points.clear();
  EXPECT_THROW(require_nodes_of_field(evaluator, p), FormatError);
  p = points();
  p.corners[1].valence = 2;
  EXPECT_THROW(require_nodes_of_field(evaluator, p), FormatError);
}

}  // namespace
}  // namespace quadrille
