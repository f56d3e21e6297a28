#include "curve/pole_box.hpp"

#include <gtest/gtest.h>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::curve {
namespace {

TEST(PoleBox, of_a_segment_has_its_ends_as_corners) {
  const PoleBox box = pole_box(segment({3, 1}, {-1, 4}));
  EXPECT_EQ(box.low, (Vec2{-1, 1}));
  EXPECT_EQ(box.high, (Vec2{3, 4}));
  EXPECT_EQ(box.centre(), (Vec2{1, 2.5}));
  EXPECT_DOUBLE_EQ(box.diagonal(), 5);
}

TEST(PoleBox, of_an_arc_contains_it) {
  const Nurbs arc = circular_arc({5, -2}, 2, 0.3, 2.9);
  const PoleBox box = pole_box(arc);
  for (int i = 0; i <= 100; ++i)
    EXPECT_TRUE(box.contains(point(arc, arc.begin() + (arc.end() - arc.begin()) * i / 100)));
}

TEST(PoleBox, of_several_curves_contains_the_last_one_too) {
  const PoleBox box = pole_box(std::vector<Nurbs>{segment({0, 0}, {1, 0}), segment({1, 0}, {7, -3})});
  EXPECT_EQ(box.low, (Vec2{0, -3}));
  EXPECT_EQ(box.high, (Vec2{7, 0}));
}

TEST(PoleBox, a_margin_widens_every_side) {
  const PoleBox box = pole_box(segment({0, 0}, {2, 1}));
  for (const Vec2 x : {Vec2{-0.1, 0.5}, Vec2{2.1, 0.5}, Vec2{1, -0.1}, Vec2{1, 1.1}}) {
    EXPECT_FALSE(box.contains(x));
    EXPECT_FALSE(box.contains(x, 0.05));
    EXPECT_TRUE(box.contains(x, 0.15));
  }
}

TEST(PoleBox, is_nearer_than_its_curve) {
  const std::vector<Nurbs> curves{circular_arc({3, 1}, 0.5, 0, 2 * pi), segment({-1, 4}, {-2, 4})};
  const std::vector<PoleBox> boxes = pole_boxes(curves);
  EXPECT_EQ(boxes[0].distance_from({3, 1}), 0);
  EXPECT_NEAR(boxes[0].distance_from({5, 1}), 1.5, 1e-15);
  EXPECT_EQ(boxes[1].distance_from({2, 8}), 5);
  for (const Vec2 x : {Vec2{0, 0}, Vec2{5, 2}, Vec2{-1, -2}})
    EXPECT_LE(boxes[0].distance_from(x), distance(x, {3, 1}) - 0.5 + 1e-15);
}

}  // namespace
}  // namespace quadrille::curve
