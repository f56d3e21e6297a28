#include "trace/step.hpp"

#include <gtest/gtest.h>

#include <complex>

#include "../support/square_field.hpp"

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

}  // namespace
}  // namespace quadrille::trace
