#include "curve/symmetry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "../triangulate/faces.hpp"
#include "base/angle.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::curve {

namespace {

using namespace testing_faces;

CadFace regular_polygon(int n, Vec2 centre = {0, 0}) {
  std::vector<Vec2> points;
  for (int k = 0; k < n; ++k) points.push_back(centre + unit(2 * pi * k / n));
  return make_face({polygon(points)});
}

CadFace rectangle(double a, double b) { return make_face({polygon({{0, 0}, {a, 0}, {a, b}, {0, b}})}); }

/// Ellipse-like closed spline of two halves: D2 only.
CadFace ellipse() {
  Nurbs right = circular_arc({0, 0}, 1, -half_pi, half_pi), left = circular_arc({0, 0}, 1, half_pi, 3 * half_pi);
  for (Nurbs* curve : {&right, &left})
    for (Vec2& p : curve->poles) p.y *= 0.5;
  return make_face({{right, left}});
}

std::pair<int, int> order_of(const CadFace& face) {
  int rotations = 0, mirrors = 0;
  for (const Isometry& g : symmetries(face)) ++(g.is_mirrored ? mirrors : rotations);
  return {rotations, mirrors};
}

using Order = std::pair<int, int>;

TEST(Symmetries, of_polygons) {
  EXPECT_EQ(order_of(square()), Order(4, 4));
  EXPECT_EQ(order_of(rectangle(2, 1)), Order(2, 2));
  for (const int n : {3, 5, 6, 7, 8, 12}) EXPECT_EQ(order_of(regular_polygon(n, {0.3, -0.7})), Order(n, n)) << n;
  EXPECT_EQ(order_of(l_shape()), Order(1, 1));
  EXPECT_EQ(order_of(make_face({polygon({{0, 0}, {2, 0}, {3, 1}, {1, 1}})})), Order(2, 0));  // a parallelogram
  EXPECT_EQ(order_of(make_face({polygon({{0, 0}, {3, 0}, {2, 1}, {0, 1.3}})})), Order(1, 0));
}

TEST(Symmetries, of_curved_faces) {
  EXPECT_EQ(order_of(half_disc()), Order(1, 1));
  EXPECT_EQ(order_of(stadium()), Order(2, 2));
  EXPECT_EQ(order_of(ellipse()), Order(2, 2));
}

TEST(Symmetries, of_concentric_circles_are_the_dihedral_group_through_joint_0) {
  for (const double angle : {0.0, 0.3, 2.0}) {
    for (const CadFace& face :
         {moved(annulus(), 3, angle, {5, 7}), moved(make_face({circle({0, 0}, 1)}), 3, angle, {5, 7})}) {
      const std::vector<Isometry> group = symmetries(face);
      ASSERT_EQ(order_of(face), Order(4, 4));
      const Vec2 joint = face.joints[0].position;
      EXPECT_TRUE(std::any_of(group.begin(), group.end(),
                              [&](const Isometry& g) { return g.is_mirrored && distance(g(joint), joint) < 1e-12; }));
    }
  }
}

TEST(Symmetries, holes_count) {
  const Loop outline = polygon({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
  EXPECT_EQ(order_of(make_face({outline, hole({0, 0}, 0.3)})), Order(4, 4));
  EXPECT_EQ(order_of(make_face({outline, hole({0.2, 0}, 0.3)})), Order(1, 1));
  EXPECT_EQ(order_of(make_face({outline, hole({0.2, 0.2}, 0.3)})), Order(1, 1));
  EXPECT_EQ(order_of(make_face({outline, hole({0.2, 0.1}, 0.3)})), Order(1, 0));
  EXPECT_EQ(order_of(make_face({outline, hole({0.5, 0.2}, 0.1), hole({-0.5, -0.2}, 0.1)})), Order(2, 0));
  EXPECT_EQ(order_of(make_face({circle({0, 0}, 1), hole({0.2, 0.1}, 0.3)})), Order(1, 1));
  EXPECT_EQ(order_of(make_face({circle({0, 0}, 1), hole({0.5, 0}, 0.1), hole({-0.25, 0.25 * std::sqrt(3)}, 0.1),
                                hole({-0.25, -0.25 * std::sqrt(3)}, 0.1)})),
            Order(3, 3));
}

TEST(Symmetries, do_not_depend_on_where_smooth_curves_are_cut) {
  const CadFace face = make_face({{circular_arc({0, 0}, 1, 0.1, 2.0), circular_arc({0, 0}, 1, 2.0, 0.1 + 2 * pi)},
                                  polygon({{-0.3, -0.3}, {-0.3, 0.3}, {0.3, 0.3}, {0.3, -0.3}})});
  EXPECT_EQ(order_of(face), Order(4, 4));
}

TEST(Symmetries, tolerance_is_1e_7_diameters) {
  const auto dented = [](double by) { return make_face({polygon({{0, 0}, {1, 0}, {1 + by, 1}, {0, 1}})}); };
  EXPECT_EQ(order_of(dented(1e-9)), Order(4, 4));
  EXPECT_EQ(order_of(dented(1e-5)), Order(1, 0));  // a square but for one vertex moved along a side
}

/// The group of the image of a face is the conjugate one: h g h^-1.
TEST(Symmetries, of_moved_faces_are_conjugate) {
  const std::vector<CadFace> faces = {square(),
                                      l_shape(),
                                      half_disc(),
                                      stadium(),
                                      ellipse(),
                                      regular_polygon(6),
                                      make_face({polygon({{0, 0}, {2, 0}, {3, 1}, {1, 1}})})};
  for (const CadFace& face : faces)
    for (const bool mirrored : {false, true})
      for (const double scale : {1e-3, 1.0, 1e3}) {
        const double angle = radians(37);
        const Vec2 shift = scale * Vec2{3, -11};
        const CadFace image = moved(face, scale, angle, shift, mirrored);
        const auto h = [&](Vec2 x) { return scale * Isometry{{0, 0}, angle, mirrored}.turned(x) + shift; };
        const std::vector<Isometry> group = symmetries(face), group_of_image = symmetries(image);
        ASSERT_EQ(group.size(), group_of_image.size());
        const Vec2 probe = {0.123, 0.77};
        for (const Isometry& g : group)
          EXPECT_TRUE(std::any_of(group_of_image.begin(), group_of_image.end(), [&](const Isometry& other) {
            return g.is_mirrored == other.is_mirrored &&
                   distance(other(h(probe)), h(g(probe))) < 1e-11 * image.diameter;
          }));
      }
}

TEST(Symmetries, of_rounded_and_far_coordinates) {
  const auto rounded = [](double v) { return std::round(v * 1e8) / 1e8; };
  CadFace face = moved(regular_polygon(6), 1, 0.4, {1, 1});
  std::vector<Vec2> points;
  for (const Joint& j : face.joints) points.push_back({rounded(j.position.x), rounded(j.position.y)});
  EXPECT_EQ(order_of(make_face({polygon(points)})), Order(6, 6));
  EXPECT_EQ(order_of(moved(stadium(), 1, 0.4, {2e4, -3e4})), Order(2, 2));
  EXPECT_EQ(order_of(moved(annulus(), 1, 0.4, {2e4, -3e4})), Order(4, 4));
  EXPECT_EQ(order_of(moved(l_shape(), 1, 0.4, {2e4, -3e4})), Order(1, 1));
}

TEST(Symmetries, are_a_group_that_maps_corners_onto_corners) {
  const CadFace face = moved(regular_polygon(6), 2, 0.4, {1, 1});
  const std::vector<Isometry> group = symmetries(face);
  EXPECT_EQ(group[0](Vec2{1, 2}), (Vec2{1, 2}));
  for (const Isometry& g : group)
    for (const Joint& j : face.joints)
      EXPECT_TRUE(std::any_of(face.joints.begin(), face.joints.end(),
                              [&](const Joint& k) { return distance(g(j.position), k.position) < 1e-13; }));
}

/// The symmetries of a rectangle about (0, 0).
const std::vector<Isometry> group_of_rectangle{
    {{0, 0}, 0, false}, {{0, 0}, pi, false}, {{0, 0}, 0, true}, {{0, 0}, pi, true}};

Orbits orbits_of(const std::vector<Vec2>& points, const std::vector<Isometry>& group = group_of_rectangle) {
  return orbits(points.size(), group,
                [&](const Isometry& g, int i, int j) { return distance(g(points[i]), points[j]) < 1e-9; });
}

TEST(Orbits, AreAscendingInTheOrderOfTheirFirstItems) {
  const Orbits result = orbits_of({{1, 0}, {2, 1}, {-1, 0}, {0, 0}, {2, -1}, {-2, 1}});
  EXPECT_EQ(result.sets, (std::vector<std::vector<int>>{{0, 2}, {1, 4, 5}, {3}}));
  EXPECT_EQ(result.first, (std::vector<int>{0, 1, 0, 3, 1, 1}));
}

TEST(Orbits, HaveMapsFromTheirFirstItems) {
  const std::vector<Vec2> points{{2, 1}, {-2, -1}, {2, -1}, {5, 5}};
  const Orbits result = orbits_of(points);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_NEAR(distance(result.map[i](points[result.first[i]]), points[i]), 0, 1e-14);
  EXPECT_EQ(result.map[0](points[0]), points[0]);
  EXPECT_TRUE(result.map[2].is_mirrored);
}

TEST(Orbits, HaveOneItemWithoutAnySymmetry) {
  EXPECT_EQ(orbits_of({{1, 0}, {-1, 0}}, {{{0, 0}, 0, false}}).sets, (std::vector<std::vector<int>>{{0}, {1}}));
  EXPECT_TRUE(orbits_of({}).sets.empty());
}

struct Place {
  Vec2 position;
  int kind = 0;
};

std::vector<int> images_of(const std::vector<Place>& places, const Isometry& isometry) {
  return images(places, isometry, 1e-6, [](const Place& a, const Place& b) { return a.kind == b.kind; });
}

TEST(Images, AreThoseOfTheSameKindWithinTheTolerance) {
  EXPECT_EQ(images_of({{{1, 0}}, {{5, 5}, 1}, {{-1, 1e-7}}, {{-5, -5}, 1}}, group_of_rectangle[1]),
            (std::vector<int>{2, 3, 0, 1}));
  EXPECT_TRUE(images_of({{{1, 0}}, {{-1, 1e-5}}}, group_of_rectangle[1]).empty());
  EXPECT_TRUE(images_of({{{1, 0}}, {{-1, 0}, 1}}, group_of_rectangle[1]).empty());
}

TEST(Images, AreOneToOneAndNearest) {
  EXPECT_EQ(images_of({{{2, 0}}, {{2, 0}}}, group_of_rectangle[2]), (std::vector<int>{0, 1}));
  EXPECT_EQ(images_of({{{2, 1e-8}}, {{2, -1e-8}}}, group_of_rectangle[2]), (std::vector<int>{1, 0}));
}

}  // namespace

}  // namespace quadrille::curve
