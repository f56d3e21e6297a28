#include "outline/outline_checks.hpp"

#include <gtest/gtest.h>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::outline {
namespace {

using Loop = std::vector<Nurbs>;

Loop polygon(const std::vector<Vec2>& p) {
  Loop loop;
  for (size_t i = 0; i < p.size(); ++i) loop.push_back(curve::segment(p[i], p[(i + 1) % p.size()]));
  return loop;
}

Loop circle(Vec2 centre, double radius) { return {curve::circular_arc(centre, radius, 0.2, 0.2 + 2 * pi)}; }

constexpr double tol = 1e-9;

TEST(OutlineChecks, simple_loops_have_no_contact) {
  EXPECT_FALSE(find_contact({polygon({{0, 0}, {1, 0}, {1, 1}})}, tol));
  EXPECT_FALSE(find_contact({circle({0, 0}, 1)}, tol));
  EXPECT_FALSE(find_contact({circle({0, 0}, 1), circle({0.3, 0}, 0.6)}, tol));
  // A lens of two arcs, and a corner of nearly 360 degrees.
  const Nurbs up = curve::circular_arc({0, -1}, std::sqrt(2.0), pi / 4, 3 * pi / 4);
  EXPECT_FALSE(find_contact({{curve::segment({-1, 0}, {1, 0}), up}}, tol));
  EXPECT_FALSE(find_contact({polygon({{0, 0}, {2, 0}, {2, 2}, {1, 0.5}, {0.9999, 2}, {0, 2}})}, tol));
}

TEST(OutlineChecks, a_double_pole_at_an_end_is_no_contact) {
  // As healing leaves it: the last two poles coincide within rounding.
  const std::vector<Vec2> poles = {{-4.612995143962634, -16.224960745688918},
                                   {-4.463998438350208, -15.964978140723272},
                                   {-4.371999825826212, -15.77099074951917},
                                   {-4.326000075110979, -15.650998338002726},
                                   {-4.318, -15.624},
                                   {-4.3180000000000005, -15.624}};
  std::vector<double> knots = {0, 0, 0};
  for (int k = 0; k <= 3; ++k) knots.push_back(k);
  knots.insert(knots.end(), 3, knots.back());
  const Nurbs stopping{3, knots, poles, std::vector<double>(poles.size(), 1)};
  EXPECT_FALSE(
      find_contact({{stopping, curve::segment(poles.back(), {5, -15}), curve::segment({5, -15}, poles[0])}}, 3.7e-8));
}

TEST(OutlineChecks, thin_gaps_are_no_contact_and_touching_is) {
  // Two circles that come as close as 1e-7, then touch.
  EXPECT_FALSE(find_contact({circle({0, 0}, 1), circle({0.5 - 1e-7, 0}, 0.5)}, tol));
  const auto contact = find_contact({circle({0, 0}, 1), circle({0.5, 0}, 0.5)}, tol);
  ASSERT_TRUE(contact);
  EXPECT_NEAR(distance(contact->position, {1, 0}), 0, 1e-4);
}

TEST(OutlineChecks, the_tip_of_a_cusp_is_no_contact) {
  // A line and an arc that meet with opposite tangents; then a curve whose curvature at the tip is 0, too.
  const Nurbs arc = curve::circular_arc({0, 1}, 1, -half_pi, half_pi);
  EXPECT_FALSE(find_contact(
      {{curve::segment({2, 0}, {0, 0}), arc, curve::segment({0, 2}, {2, 3}), curve::segment({2, 3}, {2, 0})}}, tol));
  const Nurbs cubic{3, {0, 0, 0, 0, 1, 1, 1, 1}, {{0, 0}, {1, 0}, {2, 0}, {3, 1}}, {1, 1, 1, 1}};
  EXPECT_FALSE(find_contact({{curve::segment({3, 0}, {0, 0}), cubic, curve::segment({3, 1}, {3, 0})}}, tol));
}

TEST(OutlineChecks, curves_that_cross_beyond_the_tip_of_a_cusp_are_in_contact) {
  const Nurbs wave{3, {0, 0, 0, 0, 1, 1, 1, 1}, {{0, 0}, {1, 0}, {2, 1}, {3, -1}}, {1, 1, 1, 1}};
  const auto crossing = find_contact({{curve::segment({3, 0}, {0, 0}), wave, curve::segment({3, -1}, {3, 0})}}, tol);
  ASSERT_TRUE(crossing);
  EXPECT_NEAR(crossing->position.y, 0, 1e-8);
  EXPECT_TRUE(find_contact({{curve::segment({3, 0}, {0, 0}), curve::segment({0, 0}, {3, 0})}}, tol));
}

TEST(OutlineChecks, crossings_are_located) {
  const auto bow = find_contact({polygon({{0, 0}, {2, 2}, {2, 0}, {0, 2}})}, tol);
  ASSERT_TRUE(bow);
  EXPECT_NEAR(distance(bow->position, {1, 1}), 0, 1e-12);
  const auto hole = find_contact({polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}}), circle({2, 1}, 0.5)}, tol);
  ASSERT_TRUE(hole);
  EXPECT_EQ(hole->loop_a, 0);
  EXPECT_EQ(hole->curve_a, 1);
  EXPECT_EQ(hole->loop_b, 1);
  EXPECT_NEAR(hole->position.x, 2, 1e-8);
}

TEST(OutlineChecks, curves_upon_each_other_are_a_contact) {
  EXPECT_TRUE(find_contact({circle({0, 0}, 1), circle({0, 0}, 1)}, tol));
  const Nurbs arc = curve::circular_arc({0, 0}, 1, 0, 1);
  EXPECT_TRUE(find_contact({{arc, curve::reversed(arc)}}, tol));
}

TEST(OutlineChecks, a_curve_that_crosses_itself_is_found) {
  const Nurbs loop{3, {0, 0, 0, 0, 1, 1, 1, 1}, {{0, 0}, {3, 2}, {-1, 2}, {2, 0}}, {1, 1, 1, 1}};
  EXPECT_TRUE(find_contact({{loop, curve::segment({2, 0}, {0, 0})}}, tol));
}

TEST(OutlineChecks, winding_number_tells_inside_from_outside_close_to_the_curve) {
  const Loop disc = circle({0, 0}, 1);
  EXPECT_EQ(winding_number(disc, {0, 0}), 1);
  EXPECT_EQ(winding_number(disc, (1 - 1e-12) * unit(0.7)), 1);
  EXPECT_EQ(winding_number(disc, (1 + 1e-12) * unit(0.7)), 0);
  EXPECT_EQ(winding_number({curve::reversed(disc[0])}, {0.5, 0}), -1);
}

}  // namespace
}  // namespace quadrille::outline
