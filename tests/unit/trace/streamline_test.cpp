#include "trace/streamline.hpp"

#include <gtest/gtest.h>

#include <complex>

#include "../support/square_field.hpp"
#include "spectral/tri_map.hpp"
#include "trace/advance.hpp"

namespace quadrille::trace {
namespace {

// v = z^4: the crosses of polar coordinates. Streamlines are circles about 0 and rays from it.
Vec2 polar_crosses(Vec2 p) {
  const std::complex<double> w = std::pow(std::complex<double>(p.x, p.y), 4);
  return {w.real(), w.imag()};
}

struct OneStep : testing::Test {
  Field field = interpolated_field(square_mesh({0.5, 0}, 1, 1), 4, polar_crosses);
  field::FieldEvaluator evaluator{field};

  StreamState start(Vec2 x) const {
    const mesh::Location at = evaluator.locator().find(x);
    return stream_state(evaluator, at.elem, at.xi, half_pi);
  }
  // Distance from the circle's point after a step of length h, at share theta of it.
  double miss(double h, double theta, double* error = nullptr) const {
    const Vec2 x{1, 0};
    StreamStep step;
    StreamState end;
    double estimate = 0;
    try_step(evaluator, start(x), h, step, end, estimate);
    if (error != nullptr) *error = estimate;
    return distance(evaluator.maps()[step.elem].position(step.xi(theta)), unit(h * theta));
  }
};

TEST_F(OneStep, LocalErrorFallsWithTheSixthPower) {
  // On circles part of the leading term cancels: the observed power lies between 6 and 7.
  const double power = std::log2(miss(0.2, 1) / miss(0.1, 1));
  EXPECT_GT(power, 5.7);
  EXPECT_LT(power, 7.3);
}

TEST_F(OneStep, ContinuousExtensionFallsWithTheFifthPower) {
  const double ratio = miss(0.2, 0.5) / miss(0.1, 0.5);
  EXPECT_GT(ratio, 24);
  EXPECT_LT(ratio, 80);
}

TEST_F(OneStep, TheEstimateBoundsTheError) {
  for (const double h : {0.05, 0.1, 0.2}) {
    double estimate = 0;
    const double actual = miss(h, 1, &estimate);
    EXPECT_GT(estimate, actual);
    EXPECT_LT(estimate, 1e4 * actual);
  }
}

TEST_F(OneStep, SlopeIsTheDerivativeOfTheExtension) {
  StreamStep step;
  StreamState end;
  double error = 0;
  const StreamState state = start({1, 0});
  try_step(evaluator, state, 0.1, step, end, error);
  EXPECT_NEAR(distance(step.slope(0) / 0.1, state.rate), 0, 1e-12);
  EXPECT_NEAR(distance(step.slope(1) / 0.1, end.rate), 0, 1e-12);
  for (const double theta : {0.2, 0.7})
    EXPECT_NEAR(distance((step.xi(theta + 1e-5) - step.xi(theta - 1e-5)) / 2e-5, step.slope(theta)), 0, 1e-9);
}

TEST_F(OneStep, AStepThatTurnsTooFarIsRefused) {
  StreamStep step;
  StreamState end;
  double error = 0;
  try_step(evaluator, start({1, 0}), 1.2, step, end, error);
  EXPECT_FALSE(std::isfinite(error));
}

// An element of a damaged file may be turned over: its lines would run back.
TEST_F(OneStep, AnElementThatIsTurnedOverIsRefused) {
  const StreamState state = start({1, 0});
  for (Vec2& x : field.mesh.vertices) x.y = -x.y;
  const field::FieldEvaluator turned_over{field};
  StreamStep step;
  StreamState end;
  double error = 0;
  try_step(turned_over, state, 0.01, step, end, error);
  EXPECT_FALSE(std::isfinite(error));
}

// A straight step in the reference triangle (-1, -1), (1, -1), (-1, 1).
StreamStep step(Vec2 from, Vec2 to) { return {0, 0, 1, 1, {from, to - from, {}, {}, {}}}; }

TEST(ElementExit, AStepInsideHasNone) { EXPECT_EQ(first_exit(step({-0.5, -0.5}, {-0.4, -0.6})).edge, -1); }

TEST(ElementExit, NamesTheEdgeAndTheFractionOfTheStep) {
  const ElementExit lower = first_exit(step({-0.5, -0.75}, {-0.5, -1.25}));
  EXPECT_EQ(lower.edge, 0);
  EXPECT_NEAR(lower.fraction, 0.5, 1e-15);
  EXPECT_EQ(first_exit(step({-0.5, -0.5}, {0.5, 0.5})).edge, 1);
  EXPECT_EQ(first_exit(step({-0.5, -0.5}, {-1.5, -0.5})).edge, 2);
}

TEST(ElementExit, OfTwoEdgesTheFirstCounts) {
  // Out of the lower edge at a third, beyond the left one at two thirds.
  const ElementExit exit = first_exit(step({-0.6, -0.9}, {-1.2, -1.2}));
  EXPECT_EQ(exit.edge, 0);
  EXPECT_NEAR(exit.fraction, 1.0 / 3, 1e-14);
}

TEST(ElementExit, RoundOffBeyondAnEdgeIsInside) {
  EXPECT_EQ(first_exit(step({-0.5, -0.9}, {0.2, -1 - 1e-12})).edge, -1);
  EXPECT_EQ(first_exit(step({-0.5, -0.9}, {0.2, -1 - 1e-11})).edge, 0);
}

TEST(ElementExit, FractionsAlongEdgesAreThoseOfTheEdgePoints) {
  for (int edge = 0; edge < 3; ++edge)
    for (const double f : {0.0, 0.25, 1.0})
      EXPECT_NEAR(fraction_along_edge(edge, spectral::tri_edge_point(edge, f)), f, 1e-15);
}

TEST(ElementExit, TheTangentMayLeaveTheElementByATwentieth) {
  const StreamState state{0, {-0.5, -0.5}, 0, {0, -1}};
  EXPECT_NEAR(length_to_exit(state, 10), 2 * (0.25 + 0.05), 1e-15);
  EXPECT_EQ(length_to_exit(state, 0.1), 0.1);
}

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
