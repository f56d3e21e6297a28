#include "curve/chain.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::curve {
namespace {

// A slot's side: a unit line into a quarter arc of radius 1, then a spline that is no CAD curve.
struct ChainTest : testing::Test {
  ChainTest() {
    face.curves = {segment({-1, 0}, {0, 0}), circular_arc({0, 1}, 1, -half_pi, 0)};
    splines = {cubic_spline({0, 1, 2}, {{1, 1}, {1.2, 2}, {1, 3}}, {0, 1}, {0, 1})};
  }
  CadFace face;
  std::vector<Nurbs> splines;
};

TEST_F(ChainTest, runs_through_its_pieces_by_length) {
  const CurveTable table(face, splines);
  const Chain chain(table, {{0, 0, 1}, {1, 0, half_pi}});
  EXPECT_NEAR(chain.length(), 1 + half_pi, 1e-14);
  EXPECT_EQ(chain.at(0).position, (Vec2{-1, 0}));
  EXPECT_EQ(chain.at(1).position, face.curves[1].poles.back());
  const ChainPoint middle = chain.at((1 + pi / 4) / chain.length());
  EXPECT_EQ(middle.piece, 1);
  EXPECT_NEAR(distance(middle.position, Vec2{0, 1} + unit(-pi / 4)), 0, 1e-14);
  EXPECT_NEAR(distance(middle.tangent, unit(pi / 4)), 0, 1e-14);
}

TEST_F(ChainTest, walked_backwards_gives_the_same_points) {
  const CurveTable table(face, splines);
  const Chain there(table, {{0, 0, 1}, {1, 0, half_pi}}), back(table, {{1, half_pi, 0}, {0, 1, 0}});
  for (int i = 0; i <= 20; ++i) {
    const ChainPoint a = there.at(i / 20.0), b = back.at(1 - i / 20.0);
    EXPECT_NEAR(distance(a.position, b.position), 0, 1e-14);
    EXPECT_NEAR(distance(a.tangent, -b.tangent), 0, 1e-13);
    EXPECT_EQ(there.position(i / 20.0), a.position);
    EXPECT_EQ(back.position(1 - i / 20.0), b.position);
  }
}

TEST_F(ChainTest, breaks_are_joints_and_breaks_of_cad_curves_but_not_of_splines) {
  // The spline has a break at its middle when taken for a CAD curve.
  const CurveTable table(face, splines);
  const Chain mixed(table, {{1, 0, half_pi}, {2, 0, 2}});
  EXPECT_EQ(mixed.break_fractions(), mixed.joint_fractions());
  ASSERT_EQ(mixed.joint_fractions().size(), 1U);
  EXPECT_NEAR(mixed.joint_fractions()[0] * mixed.length(), half_pi, 1e-13);

  CadFace with_spline = face;
  with_spline.curves.push_back(splines[0]);
  const std::vector<Nurbs> none;
  const CurveTable cad(with_spline, none);
  const Chain chain(cad, {{2, 2, 0}});
  ASSERT_EQ(chain.break_fractions().size(), 1U);
  EXPECT_NEAR(chain.break_fractions()[0], 0.5, 1e-13);
}

TEST_F(ChainTest, breaks_next_to_an_end_count_as_that_end) {
  CadFace drawn = face;
  drawn.diameter = 2;
  const int first = drawn.num_curves();
  drawn.curves.push_back(segment({0, 0}, {1, 0}));
  drawn.curves.push_back(segment({1, 0}, {1, 1}));
  drawn.curves.push_back(segment({1, 1}, {1, 1 + 1e-6}));
  const CurveTable table(drawn, splines);
  const auto breaks = [&](double of_first, double of_second) {
    return Chain(table, {{first, 1 - of_first, 1}, {first + 1, 0, of_second}}).break_fractions().size();
  };
  EXPECT_EQ(breaks(1.9e-6, 1), 0U);
  EXPECT_EQ(breaks(2.1e-6, 1), 1U);
  EXPECT_EQ(breaks(1, 1e-9), 0U);
  EXPECT_EQ(breaks(1e-7, 1e-7), 1U) << "a short chain keeps its inner breaks";
  // A whole curve that is so short may have a name.
  EXPECT_EQ(Chain(table, {{first + 1, 0, 1}, {first + 2, 0, 1e-6}}).break_fractions().size(), 1U);
  EXPECT_EQ(Chain(table, {{first + 2, 1e-6, 0}, {first + 1, 1, 0}}).break_fractions().size(), 1U);
}

TEST_F(ChainTest, the_seam_of_a_circle_is_no_break_but_that_of_a_drop_is) {
  CadFace closed = face;
  const int circle = closed.num_curves();
  closed.curves.push_back(circular_arc({0, 0}, 1, 0.3, 0.3 + 2 * pi));
  closed.curves.push_back({3, {0, 0, 0, 0, 1, 1, 1, 1}, {{0, 0}, {2, 1}, {-2, 1}, {0, 0}}, {1, 1, 1, 1}});
  const CurveTable table(closed, splines);
  const double end = closed.curves[circle].end();
  const Chain there(table, {{circle, end - 1, end}, {circle, 0, 1}});
  EXPECT_EQ(there.joint_fractions().size(), 1U);
  EXPECT_TRUE(there.break_fractions().empty());
  EXPECT_TRUE(Chain(table, {{circle, 1, 0}, {circle, end, end - 1}}).break_fractions().empty());
  EXPECT_EQ(Chain(table, {{circle + 1, 0.5, 1}, {circle + 1, 0, 0.5}}).break_fractions().size(), 1U);
}

}  // namespace
}  // namespace quadrille::curve
