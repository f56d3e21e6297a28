#include "zeros/zero_search.hpp"

#include <gtest/gtest.h>

#include "../support/polygon_field.hpp"
#include "guide/find_critical_points.hpp"
#include "guide/index_sum.hpp"
#include "zeros/winding.hpp"

namespace quadrille::zeros {
namespace {

/// A plate with a slanted left side and a chamfer `excess` radians off 45 degrees: 135 degrees - excess at (2, 0.7).
CadFace chamfered(double excess) {
  return polygon_face({{0, 0}, {2, 0}, {2, 0.7}, {1.7, 0.7 + 0.3 * std::tan(pi / 4 + excess)}, {0, 1.4}});
}

TEST(ZeroSearch, finds_the_zero_that_hugs_a_corner_near_a_tie) {
  // The chord passes 0 at a distance of 2 excess; the next term, r^(4/3), makes up for it close to the corner.
  double last = 0, last_excess = 0;
  for (const double excess : {1e-5, 1e-4, 1e-3, 1e-2}) {
    const Field field = adapted_field(chamfered(excess));
    const field::FieldEvaluator evaluator(field);
    ZeroSearch search(evaluator, {});
    for (int e = 0; e < field.mesh.num_elems(); ++e) search.search(e);
    EXPECT_TRUE(search.open_cells().empty());
    ASSERT_GE(search.zeros().size(), 1u) << excess;
    for (const FoundZero& zero :
         search.zeros())  // an edge of the mesh bisects the corner: it may be found on both sides
      EXPECT_NEAR(distance(zero.x, search.zeros()[0].x), 0, 1e-11);
    const double r = distance(search.zeros()[0].x, {2, 0.7});
    if (last > 0) {
      EXPECT_NEAR(std::log(r / last) / std::log(excess / last_excess), 0.75, 0.06);
    }
    last_excess = excess;
    last = r;
  }
}

TEST(ZeroSearch, every_cell_is_accounted_for) {
  const Field field = adapted_field(polygon_face(regular_polygon(5, 0.1)));
  const field::FieldEvaluator evaluator(field);
  ZeroSearch search(evaluator, {});
  for (int e = 0; e < field.mesh.num_elems(); ++e) search.search(e);
  const SearchCounts& n = search.counts();
  EXPECT_EQ(n.examined, 2 * (n.excluded + n.isolated) - field.mesh.num_elems());
  EXPECT_EQ(n.ignored, 0);
}

TEST(ZeroSearch, the_corner_absorbs_what_is_closer_than_a_block) {
  for (const double excess : {-1e-4, 0.0, 1e-7, 1e-5, 1e-4, 2e-3}) {
    const Field field = adapted_field(chamfered(excess));
    Report report;
    const CriticalPoints points = guide::find_critical_points(field::FieldEvaluator(field), report);
    EXPECT_NO_THROW(guide::require_index_sum(points));
    const bool separate = excess > 1e-3;
    EXPECT_EQ(points.critical_points.size(), separate ? 1u : 0u) << excess;
    EXPECT_EQ(points.corners[2].valence, separate ? 2 : 1) << excess;
  }
}

TEST(ZeroSearch, regular_polygons_have_their_zero_at_the_centre) {
  for (const int n : {3, 5}) {
    const Field field = adapted_field(polygon_face(regular_polygon(n, 0.3)));
    Report report;
    const CriticalPoints points = guide::find_critical_points(field::FieldEvaluator(field), report);
    ASSERT_EQ(points.critical_points.size(), 1u);
    EXPECT_NEAR(norm(points.critical_points[0].position), 0, 1e-12);
    EXPECT_EQ(points.critical_points[0].index, 4 - n);
    EXPECT_NO_THROW(guide::require_index_sum(points));
  }
}

TEST(ZeroSearch, a_turned_and_moved_face_has_its_points_turned_and_moved) {
  const std::vector<Vec2> corners{{0, 0}, {3, 0.4}, {2.6, 1.9}, {1.1, 1.2}, {0.3, 2.2}};
  const auto move = [](Vec2 p) { return Vec2{0.8 * p.x - 0.6 * p.y + 5, 0.6 * p.x + 0.8 * p.y - 3}; };
  std::vector<Vec2> moved;
  for (const Vec2 c : corners) moved.push_back(move(c));
  Report report;
  const Field a = adapted_field(polygon_face(corners)), b = adapted_field(polygon_face(moved));
  const CriticalPoints here = guide::find_critical_points(field::FieldEvaluator(a), report);
  const CriticalPoints there = guide::find_critical_points(field::FieldEvaluator(b), report);
  EXPECT_NO_THROW(guide::require_index_sum(here));
  ASSERT_EQ(here.critical_points.size(), there.critical_points.size());
  ASSERT_GE(here.critical_points.size(), 1u);
  for (const CriticalPoint& p : here.critical_points) {
    double nearest = 1e9;
    for (const CriticalPoint& q : there.critical_points)
      if (q.index == p.index) nearest = std::min(nearest, distance(move(p.position), q.position));
    EXPECT_LT(nearest, 1e-8);
  }
  for (std::size_t i = 0; i < corners.size(); ++i) EXPECT_EQ(here.corners[i].valence, there.corners[i].valence);
}

TEST(CircleIndex, counts_the_zeros_inside) {
  const Field field = adapted_field(polygon_face(regular_polygon(5, 0.3)));
  const field::FieldEvaluator evaluator(field);
  double least = 0;
  EXPECT_EQ(circle_index(evaluator, {0, 0}, 0.2, least), -1);
  EXPECT_GT(least, 1e-6);
  EXPECT_EQ(circle_index(evaluator, {0.3, 0.1}, 0.1, least), 0);
  EXPECT_EQ(circle_index(evaluator, {0.3, 0.1}, 0.9, least), std::nullopt);
}

}  // namespace
}  // namespace quadrille::zeros
