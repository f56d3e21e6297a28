#include "trace/streamline.hpp"

#include <gtest/gtest.h>

#include "../support/square_field.hpp"

namespace quadrille::trace {
namespace {

/// From a node at the origin along the x axis: a lead-in up to 0.1, then two steps up to 0.5 in the plane, of which the
/// second is used by half.
Streamline two_steps() {
  Streamline line;
  line.launch.radius = 0.1;
  line.launch.x = {0.1, 0};
  line.steps = {{in_the_plane, 0.1, 0.2, 0.2, {Vec2{0.1, 0}, {0.2, 0}, {}, {}, {}}},
                {in_the_plane, 0.3, 0.4, 0.2, {Vec2{0.3, 0}, {0.4, 0}, {}, {}, {}}}};
  line.end_position = {0.5, 1e-9};
  line.end_angle = 0.01;
  return line;
}

struct InASquare : testing::Test {
  Field field = interpolated_field(square_mesh({-1, -1}, 2, 1), 1, [](Vec2) { return Vec2{1, 0}; });
  field::FieldEvaluator evaluator{field};
};

TEST_F(InASquare, TheLengthIsThatOfTheLastStepsUsedPart) {
  EXPECT_NEAR(two_steps().length(), 0.5, 1e-15);
  Streamline launched;
  launched.launch.radius = 0.1;
  EXPECT_EQ(launched.length(), 0.1);
}

TEST_F(InASquare, StepEndsBeginAtTheNode) {
  const std::vector<double> ends = two_steps().step_ends();
  ASSERT_EQ(ends.size(), 4u);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(ends[i], std::vector<double>({0, 0.1, 0.3, 0.5})[i], 1e-15);
}

TEST_F(InASquare, PositionsAreThoseAtTheArcLength) {
  const Streamline line = two_steps();
  for (const double s : {0.0, 0.05, 0.1, 0.2, 0.3, 0.45}) {
    Vec2 direction;
    EXPECT_NEAR(distance(line.at(evaluator, s, direction), {s, 0}), 0, 1e-15) << s;
    EXPECT_NEAR(distance(direction, {1, 0}), 0, 1e-15) << s;
  }
}

TEST_F(InASquare, PositionsAreTheSameWithAndWithoutTheIndexOfSteps) {
  Streamline line = two_steps();
  const Streamline plain = line;
  line.index_steps();
  const auto expect_equal = [&](const Streamline& expected) {
    for (const double s : {0.1, 0.1000001, 0.2, 0.3, 0.30000001, 0.45, 0.5, 0.55, 0.59})
      EXPECT_EQ(line.at(evaluator, s), expected.at(evaluator, s)) << s;
  };
  expect_equal(plain);
  // Appended steps count, whether they are indexed or not.
  Streamline longer = plain;
  for (Streamline* l : {&line, &longer})
    l->steps.push_back({in_the_plane, 0.5, 0.1, 0.1, {Vec2{0.5, 0}, {0, 0.1}, {}, {}, {}}});
  expect_equal(longer);
  line.index_steps();
  expect_equal(longer);
}

TEST_F(InASquare, TheEndIsExactAndNothingLiesBeyondIt) {
  const Streamline line = two_steps();
  for (const double s : {0.5, 0.7}) {
    Vec2 direction;
    EXPECT_EQ(line.at(evaluator, s, direction), (Vec2{0.5, 1e-9}));
    EXPECT_EQ(direction, unit(0.01));
  }
  EXPECT_EQ(line.at(evaluator, -1), (Vec2{0, 0}));
}

TEST_F(InASquare, TheLeadInHasTheDirectionsAtBothEnds) {
  Streamline line;
  line.launch.origin = {0.2, 0.1};
  line.launch.radius = 0.1;
  line.launch.angle = 0.3, line.launch.angle_there = 0.5;
  line.launch.x = line.launch.origin + 0.1 * unit(0.4);
  Vec2 direction;
  EXPECT_NEAR(distance(line.at(evaluator, 0, direction), line.launch.origin), 0, 1e-15);
  EXPECT_NEAR(angle_of(direction), 0.3, 1e-14);
  EXPECT_NEAR(distance(line.at(evaluator, 0.1, direction), line.launch.x), 0, 1e-15);
  EXPECT_NEAR(angle_of(direction), 0.5, 1e-14);
  // The arc of a circle, by a cubic.
  line.at(evaluator, 0.05, direction);
  EXPECT_NEAR(angle_of(direction), 0.4, 1e-3);
}

TEST_F(InASquare, StepsInAnElementAreMappedIntoThePlane) {
  // Element 0 has the corners (-1, -1), (1, -1), (1, 1): along its reference coordinate 2 a step
  // runs at 45 degrees.
  Streamline line;
  line.steps = {{0, 0, 1, 1, {Vec2{-0.8, -0.9}, {0, 1}, {}, {}, {}}}};
  line.end_position = evaluator.maps()[0].position({-0.8, 0.1});
  const Vec2 a = evaluator.maps()[0].position({-0.8, -0.9});
  Vec2 direction;
  EXPECT_NEAR(distance(line.at(evaluator, 0.5, direction), (a + line.end_position) / 2), 0, 1e-15);
  EXPECT_NEAR(distance(direction, unit(pi / 4)), 0, 1e-15);
}

TEST_F(InASquare, OnlyALineThatWasTooLongIsEndless) {
  Streamline line = two_steps();
  EXPECT_TRUE(line.is_endless());
  line.end = Streamline::End::node;
  EXPECT_FALSE(line.is_endless());
  line.end = Streamline::End::boundary;
  EXPECT_FALSE(line.is_endless());
}

}  // namespace
}  // namespace quadrille::trace
