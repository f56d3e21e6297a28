#include "trace/adams_bashforth.hpp"

#include <gtest/gtest.h>

#include <complex>

#include "../support/square_field.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::trace {
namespace {

// v = z^4, which elements of order 4 hold exactly: streamlines are circles about 0 and rays from it.
struct PolarCrosses : testing::Test {
  Field field = interpolated_field(square_mesh({0, 0}, 1, 4), 4, [](Vec2 p) {
    const std::complex<double> w = std::pow(std::complex<double>(p.x, p.y), 4);
    return Vec2{w.real(), w.imag()};
  });
  field::FieldEvaluator evaluator{field};

  Streamline quarter_circle(double radius, double step) const {
    return advance_adams_bashforth(evaluator, launch_from_boundary(evaluator, 0, radius), PointGrid({}),
                                   {1, step, 20, 1e-7});
  }
  static double miss(const Streamline& line) { return distance(line.end_position, {0, line.launch.x.x}); }
};

TEST_F(PolarCrosses, EndsOnTheBoundaryAndOnItsCurve) {
  const Streamline line = quarter_circle(0.6, 0.005);
  ASSERT_EQ(line.end, Streamline::End::boundary);
  EXPECT_EQ(line.reached.curve, 3);
  EXPECT_EQ(line.end_position, curve::point(field.mesh.face.curves[3], line.reached.t));
  EXPECT_LT(miss(line), 1e-8);
  EXPECT_NEAR(line.length(), 0.6 * half_pi, 1e-8);
}

TEST_F(PolarCrosses, PositionsBetweenStepsLieOnTheCircle) {
  const Streamline line = quarter_circle(0.6, 0.01);
  for (int i = 0; i <= 50; ++i) {
    Vec2 direction;
    const Vec2 x = line.at(evaluator, line.length() * i / 50, direction);
    EXPECT_NEAR(norm(x), 0.6, 1e-7);
    EXPECT_NEAR(norm(direction), 1, 1e-15);
    EXPECT_NEAR(dot(direction, x), 0, 1e-5);
  }
}

TEST_F(PolarCrosses, TheErrorFallsWithTheFourthPower) {
  const double power = std::log2(miss(quarter_circle(0.6, 0.04)) / miss(quarter_circle(0.6, 0.02)));
  EXPECT_GT(power, 3.5);
  EXPECT_LT(power, 5);
}

TEST_F(PolarCrosses, ABoundOnTheLengthEndsIt) {
  const Streamline line = advance_adams_bashforth(evaluator, launch_from_boundary(evaluator, 0, 0.6), PointGrid({}),
                                                  {1, 0.01, 0.505, 1e-7});
  EXPECT_EQ(line.end, Streamline::End::length);
  EXPECT_NEAR(line.length(), 0.51, 1e-9);  // the first step that ends beyond it
}

TEST(AdamsBashforth, GivesUpWhereTheFieldVanishes) {
  const Field field = interpolated_field(square_mesh({0, 0}, 1, 2), 1, [](Vec2) { return Vec2{0, 0}; });
  const field::FieldEvaluator evaluator(field);
  EXPECT_THROW(
      advance_adams_bashforth(evaluator, launch_from_boundary(evaluator, 0, 0.6), PointGrid({}), {1, 0.01, 0.5, 1e-7}),
      ComputeError);
}

}  // namespace
}  // namespace quadrille::trace
