#include "curve/face_boundary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "../triangulate/faces.hpp"
#include "base/angle.hpp"
#include "curve/nurbs.hpp"
#include "curve/project.hpp"

namespace quadrille::curve {
namespace {

using namespace testing_faces;

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double in(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  Vec2 in_square(double half) { return {in(-half, half), in(-half, half)}; }

 private:
  std::mt19937 engine_;
};

/// A closed curve about the origin whose radius varies by sines: splines of several spans and segments in turn.
Loop wavy_loop(Random& random, int num_curves) {
  const double phase = random.in(0, 6), depth = random.in(0.05, 0.3);
  const auto at = [&](double angle) { return (1 + depth * std::sin(5 * angle + phase)) * unit(angle); };
  Loop loop;
  for (int c = 0; c < num_curves; ++c) {
    const double a = 2 * pi * c / num_curves, b = 2 * pi * (c + 1) / num_curves;
    if (c % 2 == 0) {
      loop.push_back(segment(at(a), at(b)));
      continue;
    }
    std::vector<double> parameters;
    std::vector<Vec2> points;
    for (int i = 0; i <= 4; ++i) parameters.push_back(a + (b - a) * i / 4), points.push_back(at(parameters.back()));
    loop.push_back(cubic_spline(parameters, points, left_of(unit(a)), left_of(unit(b))));
  }
  return loop;
}

CadFace random_face(unsigned seed) {
  Random random(seed);
  std::vector<Loop> loops{wavy_loop(random, 5 + static_cast<int>(seed) * 4)};
  for (int h = 0; h < 5; ++h) loops.push_back(hole(0.4 * unit(2 * pi * h / 5), random.in(0.02, 0.15)));
  return make_face(loops);
}

std::vector<NearestPoint> all_feet(const CadFace& face, Vec2 x) {
  std::vector<NearestPoint> feet;
  for (int c = 0; c < face.num_curves(); ++c) {
    const Projection p = project(face.curves[c], x);
    feet.push_back({c, p.t, p.position, p.distance});
  }
  return feet;
}

bool is_less(const NearestPoint& a, const NearestPoint& b) { return a.distance < b.distance; }

void expect_same(const NearestPoint& found, const NearestPoint& expected) {
  EXPECT_EQ(found.curve, expected.curve);
  EXPECT_EQ(found.t, expected.t);
  EXPECT_EQ(found.position, expected.position);
  EXPECT_EQ(found.distance, expected.distance);
}

void expect_same(const std::vector<NearestPoint>& found, const std::vector<NearestPoint>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) expect_same(found[i], expected[i]);
}

TEST(CurveTree, hasTheAnswersOfLoopsOverAllCurves) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    const CadFace face = random_face(seed);
    const FaceBoundary boundary(face);
    Random random(100 + seed);
    for (int i = 0; i < 100; ++i) {
      const Vec2 x = random.in_square(2);
      std::vector<NearestPoint> feet = all_feet(face, x);
      const NearestPoint first = *std::min_element(feet.begin(), feet.end(), is_less);
      expect_same(boundary.nearest(x), first);
      const double reach = random.in(0, 1);
      auto within = feet;
      std::erase_if(within, [&](const NearestPoint& foot) { return foot.distance > reach; });
      expect_same(boundary.feet_within(x, reach), within);
      std::erase_if(feet, [&](const NearestPoint& foot) { return foot.distance > first.distance + 0.1; });
      expect_same(boundary.nearest_feet(x, 0.1), feet);
    }
  }
}

TEST(CurveTree, looksAtTheCurvesOfTheFilterOnly) {
  const CadFace face = random_face(3);
  const CurveTree tree(face.curves);
  for (int loop = 0; loop < face.num_loops(); ++loop) {
    const auto is_of_loop = [&](int c) { return face.loop_of(c) == loop; };
    auto feet = all_feet(face, {0.1, 0.05});
    std::erase_if(feet, [&](const NearestPoint& foot) { return !is_of_loop(foot.curve); });
    expect_same(tree.nearest({0.1, 0.05}, is_of_loop), *std::min_element(feet.begin(), feet.end(), is_less));
    expect_same(tree.feet_within({0.1, 0.05}, 9, is_of_loop), feet);
  }
  EXPECT_EQ(tree.nearest({0, 0}, [](int) { return false; }).curve, -1);
}

TEST(CurveTree, takesTheLowestNumberOfEquallyNearCurves) {
  const CadFace face = square();
  const FaceBoundary boundary(face);
  EXPECT_EQ(boundary.nearest({0.5, 0.5}).curve, 0);
  EXPECT_EQ(boundary.nearest({2, 2}).curve, 1);  // a joint belongs to both curves
  EXPECT_EQ(boundary.nearest_feet({0.5, 0.5}, 1e-6).size(), 4u);
  EXPECT_EQ(boundary.nearest_feet({0.5, 0.4}, 1e-6).size(), 1u);
}

TEST(CurveTree, isMadeOfMembersOfOtherThings) {
  struct Named {
    int number;
    Nurbs curve;
  };
  const std::vector<Named> items{{7, segment({0, 0}, {1, 0})}, {8, segment({0, 2}, {1, 2})}};
  EXPECT_EQ(CurveTree(items, &Named::curve).nearest({0.5, 1.5}).curve, 1);
  EXPECT_EQ(CurveTree(std::vector<Nurbs>()).nearest({0, 0}).curve, -1);
}

TEST(CurveTree, findsAllCrossingsOfARay) {
  const CadFace face = annulus();
  const CurveTree tree(face.curves);
  const std::vector<RayHit> hits = tree.hits({-2, 0.3}, {1, 0});
  ASSERT_EQ(hits.size(), 4u);
  const std::vector<double> expected{2 - std::sqrt(0.91), 1.6, 2.4, 2 + std::sqrt(0.91)};
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(hits[i].length, expected[i], 1e-14);
  EXPECT_EQ(hits[1].curve, 1);
  EXPECT_FALSE(hits[0].to_left);
  EXPECT_TRUE(hits[3].to_left);
  EXPECT_NEAR(tree.first_hit({-2, 0.3}, {2, 0})->length, expected[0] / 2, 1e-14);
  EXPECT_FALSE(tree.first_hit({-2, 0.3}, {1, 0}, 1));
  EXPECT_FALSE(tree.first_hit({-2, 0.3}, {-1, 0}));
  EXPECT_TRUE(tree.hits({-2, 1}, {1, 0}).empty());  // touches the circle
}

TEST(CurveTree, firstHitIsTheFirstOfAllAndTheirNumberTellsTheSide) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    const CadFace face = random_face(seed);
    const FaceBoundary boundary(face);
    Random random(200 + seed);
    for (int i = 0; i < 100; ++i) {
      const Vec2 x = random.in_square(1.3), direction = unit(random.in(-pi, pi));
      const std::vector<RayHit> hits = boundary.hits(x, direction);
      const std::optional<RayHit> first = boundary.first_hit(x, direction);
      ASSERT_EQ(first.has_value(), !hits.empty());
      if (first) {
        EXPECT_EQ(first->length, hits.front().length);
      }
      for (const RayHit& hit : hits)
        EXPECT_LE(distance(point(face.curves[hit.curve], hit.t), x + hit.length * direction), 1e-14);
      EXPECT_EQ(hits.size() % 2 == 1, boundary.contains(x));
      EXPECT_EQ(boundary.winding_number(x), boundary.contains(x) ? 1 : 0);
    }
  }
}

TEST(CurveTree, raysThroughJointsAndAlongCurvesWindOnce) {
  for (const CadFace& face : {square(), l_shape(), stadium()}) {
    const CurveTree tree(face.curves);
    for (const double x : {-0.75, 0.25, 0.5, 0.75})
      for (const double y : {0.0, 0.5, 1.0})
        if (tree.nearest({x, y}).distance > 1e-9) {
          EXPECT_EQ(tree.winding_number({x, y}), FaceBoundary(face).contains({x, y}) ? 1 : 0) << x << " " << y;
        }
  }
}

TEST(CurveTree, windsOppositelyAroundHoles) {
  EXPECT_EQ(CurveTree(hole({0, 0}, 1)).winding_number({0.5, 0}), -1);
  const Loop disc = circle({0, 0}, 1);
  EXPECT_EQ(CurveTree(disc).winding_number((1 - 1e-12) * unit(0.7)), 1);
  EXPECT_EQ(CurveTree(disc).winding_number((1 + 1e-12) * unit(0.7)), 0);
}

TEST(CurveTree, findsThePointThatIsFarthestFromTheNearestOfManyCurves) {
  const Loop curves{circular_arc({0, 0}, 1, 0, 2 * pi), circular_arc({5, 0}, 2, 0, 2 * pi), segment({0, 4}, {5, 4})};
  const CurveTree set(curves);
  const std::vector<Vec2> points{{0, 1.5}, {5, 2.25}, {2.5, 3.75}, {0, 0.75}};
  EXPECT_NEAR(set.farthest(points).distance, 0.5, 1e-14);
  EXPECT_EQ(set.farthest(points).position, points[0]);
  // On the second circle's left, nearer to it than to the first, to which the point before was nearest.
  EXPECT_NEAR(set.farthest({{1.25, 0}, {2.5, 0}}).distance, 0.5, 1e-14);
}

TEST(CurveTree, aGuessOnTheFarSideOfACircleIsNotTaken) {
  const Loop disc = circle({0, 0}, 1);
  EXPECT_NEAR(CurveTree(disc).farthest({{-1, 0}, {0.5, 0}}).distance, 0.5, 1e-14);
}

TEST(CurveTree, findsTheFarthestPointAmongManyCurves) {
  std::vector<Nurbs> circles;
  for (int i = 0; i < 50; ++i) circles.push_back(circular_arc({3.0 * (i % 7), 3.0 * ((3 * i) % 50)}, 1, 0, 2 * pi));
  const CurveTree set(circles);
  for (int i = 0; i < 50; ++i) {
    const int first = 13 * i % 50;
    const Vec2 on{3.0 * (first % 7), 3.0 * ((3 * first) % 50) + 1}, inside{3.0 * (i % 7) + 0.1, 3.0 * ((3 * i) % 50)};
    EXPECT_NEAR(set.farthest({on, inside}).distance, 0.9, 1e-13);
    EXPECT_EQ(set.farthest({on, inside}).position, inside);
  }
}

TEST(CurveTree, endsOfCurvesCount) {
  const Loop line{segment({0, 0}, {1, 0})};
  EXPECT_NEAR(CurveTree(line).farthest({{0.5, 0.1}, {4, 4}}).distance, 5, 1e-14);
  EXPECT_EQ(CurveTree(Loop()).farthest({{1, 1}}).distance, 0);
}

TEST(CurveTree, polesThatCoincideDoNotStopIt) {
  // The derivative vanishes at the start.
  const Loop curve{{3, {0, 0, 0, 0, 1, 1, 1, 1}, {{0, 0}, {0, 0}, {1, 0}, {2, 0}}, {1, 1, 1, 1}}};
  EXPECT_NEAR(CurveTree(curve).farthest({{0, 0}, {1.3, 0.25}}).distance, 0.25, 1e-12);
}

TEST(FaceBoundary, theDistanceHasTheSideAsSign) {
  const auto signed_distance = [](const CadFace& face, Vec2 x) { return FaceBoundary(face).signed_distance(x); };
  EXPECT_NEAR(signed_distance(square(), {0.3, 0.4}), 0.3, 1e-14);
  EXPECT_NEAR(signed_distance(square(), {1.3, 0.4}), -0.3, 1e-14);
  EXPECT_NEAR(signed_distance(annulus(), {0.6, 0}), 0.1, 1e-14);
  EXPECT_NEAR(signed_distance(annulus(), {0.1, 0}), -0.4, 1e-14);
  EXPECT_NEAR(signed_distance(annulus(), {0, 1.5}), -0.5, 1e-14);
  EXPECT_NEAR(signed_distance(square(), {-0.3, -0.4}), -0.5, 1e-14);
  EXPECT_NEAR(signed_distance(l_shape(), {0.97, 0.96}), 0.05, 1e-14);  // the reflex corner at (1, 1), from inside
  EXPECT_NEAR(signed_distance(l_shape(), {1.1, 1.2}), -0.1, 1e-14);
  for (const double side : {1.0, -1.0}) {  // of a slit
    EXPECT_NEAR(signed_distance(slit_square(), {0.5, 0.5 + 0.1 * side}), 0.1, 1e-14);
    EXPECT_NEAR(signed_distance(open_slit(), {0.9, 0.5 + 0.05 * side}), 0.05, 1e-14);
  }
}

TEST(FaceBoundary, theFirstPartOfARayInsideMayBeginLater) {
  const auto length_inside = [](const CadFace& face, Vec2 x, Vec2 direction) {
    return FaceBoundary(face).length_inside(x, direction);
  };
  EXPECT_NEAR(length_inside(square(), {0.25, 0.5}, {1, 0}), 0.75, 1e-12);
  EXPECT_NEAR(length_inside(square(), {0.25, 0.5}, {-1, 0}), 0.25, 1e-12);
  EXPECT_NEAR(length_inside(annulus(), {0, 0}, unit(1.0)), 0.5, 1e-12);
  EXPECT_NEAR(length_inside(annulus(), {-2, 0}, {1, 0}), 0.5, 1e-12);
  EXPECT_EQ(length_inside(square(), {2, 0.5}, {1, 0}), 0);
  EXPECT_NEAR(length_inside(slit_square(), {0.5, 0.25}, {0, 1}), 0.25, 1e-12);
}

/// By steps as long as the distance to the boundary.
bool is_visible_by_steps(const CadFace& face, Vec2 a, Vec2 b) {
  const double length = distance(a, b);
  for (double s = 0; s < length;) {
    const auto feet = all_feet(face, a + (s / length) * (b - a));
    const double clearance = std::min_element(feet.begin(), feet.end(), is_less)->distance;
    if (clearance < 1e-9 * face.diameter) return false;
    s += clearance;
  }
  return true;
}

TEST(FaceBoundary, segmentsAreVisibleIfTheyKeepOffTheBoundary) {
  const CadFace face = random_face(2);
  const FaceBoundary boundary(face);
  Random random(5);
  int num_visible = 0, num_tested = 0;
  while (num_tested < 100) {
    const Vec2 a = random.in_square(1), b = random.in_square(1);
    if (!boundary.contains(a) || !boundary.contains(b)) continue;
    ++num_tested;
    num_visible += boundary.is_visible(a, b);
    EXPECT_EQ(boundary.is_visible(a, b), is_visible_by_steps(face, a, b)) << num_tested;
  }
  EXPECT_GT(num_visible, 10);
  EXPECT_LT(num_visible, 90);
}

TEST(FaceBoundary, aReflexCornerOnTheSegmentHidesItsEndFromBothSides) {
  const CadFace face = l_shape();
  const FaceBoundary boundary(face);
  EXPECT_FALSE(boundary.is_visible({0.5, 1.5}, {1.5, 0.5}));
  EXPECT_FALSE(boundary.is_visible({1.5, 0.5}, {0.5, 1.5}));
  EXPECT_TRUE(boundary.is_visible({0.5, 1.49}, {1.49, 0.5}));
  EXPECT_TRUE(boundary.is_visible({0.5, 0.5}, {0.5, 0.5}));
}

}  // namespace
}  // namespace quadrille::curve
