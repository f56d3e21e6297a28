#include "guide/override_corners.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "../support/critical_points.hpp"
#include "../support/texts.hpp"
#include "../triangulate/faces.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/symmetry.hpp"
#include "guide/valence.hpp"

namespace quadrille::guide {
namespace {

TEST(ParseCornerOverride, reads_two_curves_and_a_valence) {
  const CornerOverride o = parse_corner_override("3:14=2");
  EXPECT_EQ(o.curve_a, 3);
  EXPECT_EQ(o.curve_b, 14);
  EXPECT_EQ(o.valence, 2);
  for (const char* text :
       {"", "3", "3:4", "3=4:2", "3:4=", ":4=2", "a:4=2", "3:4=2x", "-3:4=2", "3:4=-1", "3: 4=2", "3:4=99999999999"})
    EXPECT_THROW(parse_corner_override(text), UsageError) << text;
}

using namespace testing_faces;
using hand_made::expect_sound_changes;
using hand_made::node;
using hand_made::points_of;

std::string refusal(const CadFace& face, const std::vector<CornerOverride>& overrides) {
  CriticalPoints points = points_of(face);
  return message_of<UsageError>([&] { override_corners(face, overrides, points); });
}

void expect_sound(const CriticalPoints& points) {
  EXPECT_EQ(points.index_sum, points.index_sum_expected);
  EXPECT_EQ(index_sum_of(points), points.index_sum_expected);
  for (const NodeChange& change : points.changes) EXPECT_EQ(change.kind, ChangeKind::corner);
  expect_sound_changes(points.changes);
}

TEST(OverrideCorners, refuses_by_name) {
  EXPECT_NE(refusal(square(), {{0, 2, 1}}).find("no corner between curves 0 and 2: they do not meet"),
            std::string::npos);
  EXPECT_NE(refusal(square(), {{3, 4, 1}}).find("the face has curves 0 to 3"), std::string::npos);
  EXPECT_NE(refusal(stadium(), {{0, 1, 1}}).find("they meet smoothly"), std::string::npos);
  const std::string message = refusal(l_shape(), {{2, 3, 1}});  // 270 degrees at (1, 1)
  EXPECT_NE(message.find("270 degrees at (1, 1), between curves 2 and 3"), std::string::npos) << message;
  EXPECT_NE(message.find("admissible are 0, 2, 3, 4"), std::string::npos) << message;
  EXPECT_NE(refusal(square(), {{0, 1, 5}}).find("0 to 4"), std::string::npos);
  EXPECT_NE(refusal(square(), {{0, 1, 2}, {1, 0, 3}}).find("both valence 2 and 3"), std::string::npos);
}

TEST(OverrideCorners, what_is_there_already_changes_nothing) {
  CriticalPoints points = points_of(square());
  override_corners(square(), {{0, 1, 1}}, points);
  EXPECT_EQ(points.form, NodeForm::harmonic);
  EXPECT_TRUE(points.changes.empty());
}

TEST(OverrideCorners, adds_a_node_on_the_bisector) {
  CriticalPoints points = points_of(square());
  override_corners(square(), {{1, 0, 2}}, points);  // the corner (1, 0)
  expect_sound(points);
  EXPECT_EQ(points.form, NodeForm::phase);
  EXPECT_EQ(points.corners[1].valence, 2);
  EXPECT_EQ(points.corners[1].source, NodeSource::corner);
  ASSERT_EQ(points.critical_points.size(), 1u);
  EXPECT_EQ(points.critical_points[0].valence, 3);
  EXPECT_EQ(points.critical_points[0].source, NodeSource::corner);
  EXPECT_LT(distance(points.critical_points[0].position, {0.75, 0.25}), 1e-5);
  ASSERT_EQ(points.changes.size(), 1u);
}

TEST(OverrideCorners, adds_several_nodes_at_equal_angles) {
  CriticalPoints points = points_of(square());
  override_corners(square(), {{0, 1, 3}}, points);
  expect_sound(points);
  ASSERT_EQ(points.critical_points.size(), 2u);
  const Vec2 a = points.critical_points[0].position - Vec2{1, 0}, b = points.critical_points[1].position - Vec2{1, 0};
  EXPECT_NEAR(norm(a), norm(b), 1e-12);
  EXPECT_NEAR(std::abs(wrap_pi(angle_of(a) - angle_of(b))), pi / 6, 1e-9);
  CriticalPoints fewer = points_of(l_shape());
  override_corners(l_shape(), {{2, 3, 2}}, fewer);
  expect_sound(fewer);
  ASSERT_EQ(fewer.critical_points.size(), 1u);
  EXPECT_EQ(fewer.critical_points[0].valence, 5);
  EXPECT_NEAR(fewer.critical_points[0].position.x, fewer.critical_points[0].position.y, 1e-12);
  EXPECT_LT(fewer.critical_points[0].position.x, 1);
}

TEST(OverrideCorners, takes_the_nearest_node_of_the_opposite_index) {
  CriticalPoints points = points_of(square(), {node({0.8, 0.2}, 5), node({0.7, 0.2}, 3), node({0.1, 0.9}, 5)});
  override_corners(square(), {{0, 1, 2}}, points);
  expect_sound(points);
  ASSERT_EQ(points.critical_points.size(), 2u);
  EXPECT_EQ(points.critical_points[0].position, (Vec2{0.7, 0.2}));
  EXPECT_EQ(points.critical_points[1].position, (Vec2{0.1, 0.9}));
  EXPECT_EQ(points.zeros.size(), 3u);
}

TEST(OverrideCorners, nodes_that_are_far_or_equally_near_stay) {
  CriticalPoints far = points_of(square(), {node({0.3, 0.7}, 5)});
  override_corners(square(), {{0, 1, 2}}, far);
  expect_sound(far);
  EXPECT_EQ(far.critical_points.size(), 2u);

  CriticalPoints between = points_of(square(), {node({0.5, 0.1}, 5)});  // farther than a quarter: 0.51 > 0.35
  override_corners(square(), {{0, 1, 2}, {3, 0, 2}}, between);
  expect_sound(between);
  EXPECT_EQ(between.critical_points.size(), 3u);

  CriticalPoints two = points_of(square(), {node({0.9, 0.2}, 5), node({0.8, 0.1}, 5)});  // mirror images
  override_corners(square(), {{0, 1, 2}}, two);
  expect_sound(two);
  EXPECT_EQ(two.critical_points.size(), 3u);
}

TEST(OverrideCorners, exchange_between_corners_leaves_the_inside_alone) {
  // Opposite corners of 45 and 135 degrees.
  const CadFace face = make_face({polygon({{0, 0}, {2, 0}, {3, 1}, {1, 1}})});
  CriticalPoints points = points_of(face);
  points.corners[0].valence = 1, points.corners[1].valence = 1, points.corners[2].valence = 0;
  points.corners[3].valence = 2;
  points.index_sum = points.index_sum_expected = index_sum_of(points);
  override_corners(face, {{0, 1, 2}, {2, 3, 1}}, points);
  expect_sound(points);
  EXPECT_TRUE(points.critical_points.empty());
  EXPECT_EQ(points.corners[1].valence, 2);
  EXPECT_EQ(points.corners[3].valence, 1);
  ASSERT_EQ(points.changes.size(), 1u);
  EXPECT_EQ(points.changes[0].before.size(), 2u);
}

TEST(OverrideCorners, half_disc_corners_are_told_apart_by_the_sequence) {
  CriticalPoints right = points_of(half_disc()), left = points_of(half_disc());
  override_corners(half_disc(), {{0, 1, 2}}, right);
  override_corners(half_disc(), {{1, 0, 2}}, left);
  for (const Corner& c : right.corners) EXPECT_EQ(c.valence, c.position.x > 0 ? 2 : 1);
  for (const Corner& c : left.corners) EXPECT_EQ(c.valence, c.position.x < 0 ? 2 : 1);
}

TEST(OverrideCorners, symmetric_overrides_give_symmetric_nodes) {
  const std::vector<Vec2> places = {{0.2, 0.1}, {0.1, 0.2}, {0.8, 0.1}, {0.9, 0.2}};
  std::vector<CriticalPoint> nodes;
  for (const Vec2 x : places) nodes.push_back(node(x, 5)), nodes.push_back(node({x.x, 1 - x.y}, 5));
  for (const int valence : {2, 3, 4}) {
    CriticalPoints points = points_of(square(), nodes);
    override_corners(square(), {{0, 1, valence}, {1, 2, valence}, {2, 3, valence}, {3, 0, valence}}, points);
    expect_sound(points);
    for (const curve::Isometry& g : curve::symmetries(square()))
      for (const CriticalPoint& p : points.critical_points)
        EXPECT_TRUE(std::any_of(points.critical_points.begin(), points.critical_points.end(), [&](const auto& q) {
          return q.valence == p.valence && distance(g(p.position), q.position) < 1e-12;
        }));
  }
}

TEST(OverrideCorners, index_sum_holds_on_random_polygons) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 50; ++trial) {
    const int n = 4 + static_cast<int>(random() % 6);
    std::vector<Vec2> outline;
    for (int k = 0; k < n; ++k)
      outline.push_back((1 + static_cast<double>(random() % 100) / 60) * unit(2 * pi * k / n));
    const CadFace face = make_face({polygon(outline), hole({0, 0}, 0.2)});
    std::vector<CriticalPoint> nodes;
    for (int k = 0; k < 6; ++k) nodes.push_back(node((0.3 + 0.1 * k) * unit(k), k % 2 == 0 ? 3 : 5));
    CriticalPoints points = points_of(face, nodes);
    std::vector<CornerOverride> overrides;
    for (const Corner& c : points.corners) {
      const int valence = static_cast<int>(random() % 5);
      if (is_admissible_valence(c.angle_degrees, valence)) overrides.push_back({c.curves[0], c.curves[1], valence});
    }
    override_corners(face, overrides, points);
    expect_sound(points);
    for (const CornerOverride& o : overrides)
      for (const Corner& c : points.corners)
        if (c.curves[0] == o.curve_a) {
          EXPECT_EQ(c.valence, o.valence);
        }
  }
}

}  // namespace
}  // namespace quadrille::guide
