#include "trace/line_passes.hpp"

#include <gtest/gtest.h>

#include "../support/square_field.hpp"
#include "trace/advance.hpp"

namespace quadrille::trace {
namespace {

// Crosses along the axes: a straight line from the left side of the square to the right one.
struct StraightLine : testing::Test {
  Field field = interpolated_field(square_mesh({0, 0}, 1, 4), 1, [](Vec2) { return Vec2{1, 0}; });
  field::FieldEvaluator evaluator{field};
  Streamline line = advance(evaluator, launch_from_boundary(evaluator, 3, 0.7), PointGrid({}), {1e-11, 0.1, 20, 1e-7});
  LinePasses passes{evaluator, line};
};

TEST_F(StraightLine, APassHasItsFootAbreastOfThePoint) {
  const Vec2 node{0.43, 0.35};
  std::vector<LinePass> found = passes.passes_of(node, 0, 0.2);
  ASSERT_EQ(found.size(), 1u);
  const double foot = passes.foot(node, found[0]);
  EXPECT_NEAR(line.at(evaluator, foot).x, 0.43, 1e-10);
  EXPECT_GE(foot, found[0].low);
  EXPECT_LE(foot, found[0].high);
}

TEST_F(StraightLine, PointsFartherAwayAreNotPassed) {
  EXPECT_TRUE(passes.passes_of({0.43, 0.9}, 0, 0.01).empty());
  EXPECT_EQ(passes.passes_of({0.43, 0.9}, 2, 0).size(), 1u);  // the distance allowed grows along the line
}

TEST_F(StraightLine, ALineThatEndsFarInFrontOfAPointDoesNotPassIt) {
  EXPECT_TRUE(passes.passes_of({1.1, 0.3}, 0, 1).empty());
  EXPECT_EQ(passes.passes_of({1.01, 0.35}, 0, 1).size(), 1u);  // it ends nearly abreast
}

}  // namespace
}  // namespace quadrille::trace
