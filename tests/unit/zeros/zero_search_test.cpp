#include "zeros/zero_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../support/polygon_field.hpp"
#include "../support/square_field.hpp"
#include "guide/find_critical_points.hpp"
#include "guide/valence.hpp"
#include "zeros/winding.hpp"

namespace quadrille::zeros {
namespace {

/// The identity on two triangles; the second is shifted by `jump` along x. An orthonormal mode of degree 0 is
/// 1/sqrt(2).
Field shifted(double jump) {
  Field field = interpolated_field(square_mesh({-1, -1}, 2, 1), 2, [](Vec2 x) { return x; });
  field.u[field.coef_offsets[1]] += std::sqrt(2.0) * jump;
  return field;
}

TEST(EdgeJumps, AreNoneForAContinuousField) { EXPECT_TRUE(edge_jumps(field::FieldEvaluator(shifted(0))).empty()); }

TEST(EdgeJumps, BoundWhatIsBetweenNeighbours) {
  Field field = shifted(1e-6);
  field.method = FieldMethod::dg;
  const auto jumps = edge_jumps(field::FieldEvaluator(field));
  ASSERT_EQ(jumps.size(), 2u);
  for (const Jumps& of_elem : jumps) {
    EXPECT_EQ(std::count(of_elem.edge.begin(), of_elem.edge.end(), 0.0), 2);  // all but the diagonal are boundary
    const double diagonal = *std::max_element(of_elem.edge.begin(), of_elem.edge.end());
    EXPECT_NEAR(diagonal, 2e-6, 1e-12);
    EXPECT_NEAR(*std::max_element(of_elem.vertex.begin(), of_elem.vertex.end()), 1e-6, 1e-12);
    EXPECT_EQ(*std::min_element(of_elem.vertex.begin(), of_elem.vertex.end()), 0);
  }
}

TEST(EdgeJumps, AddUpAtAVertexOverHalfTheEdges) {
  // Four squares, eight triangles; one triangle at the middle vertex is shifted: two of its edges end there.
  Field field = interpolated_field(square_mesh({-1, -1}, 2, 2), 1, [](Vec2 x) { return x; });
  field.method = FieldMethod::dg;
  const int middle = 4;
  int elem = 0, local = 0;
  for (int e = 0; e < field.mesh.num_elems(); ++e)
    for (int k = 0; k < 3; ++k)
      if (field.mesh.elem2vertices[e][k] == middle) elem = e, local = k;
  field.u[field.coef_offsets[elem]] += std::sqrt(2.0) * 1e-3;
  const auto jumps = edge_jumps(field::FieldEvaluator(field));
  EXPECT_NEAR(jumps[elem].vertex[local], 2e-3, 1e-12);  // (2e-3 + 2e-3) / 2
}

TEST(ZeroSearch, follows_zeros_to_where_they_are_and_finds_new_ones) {
  const auto product = [](Vec2 a, Vec2 b) { return Vec2{a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x}; };
  const Vec2 first{0.3, 0.2}, second{0.62, 0.25};
  const Field field = interpolated_field(square_mesh({0, 0}, 1, 1), 4, [&](Vec2 x) {
    const Vec2 conjugate{x.x - second.x, second.y - x.y};
    return product(x - first, conjugate);
  });
  const field::FieldEvaluator evaluator(field);
  ZeroSearch search(evaluator, {});
  for (int e = 0; e < field.mesh.num_elems(); ++e) search.follow(e, {});
  const std::vector<FoundZero> followed = distinct_zeros(evaluator, search.take().zeros);
  for (int e = 0; e < field.mesh.num_elems(); ++e) search.search(e);
  const std::vector<FoundZero> found = distinct_zeros(evaluator, search.zeros());
  ASSERT_EQ(found.size(), 2u);
  ASSERT_EQ(followed.size(), found.size());
  for (const FoundZero& zero : found)
    EXPECT_TRUE(std::any_of(followed.begin(), followed.end(), [&](const FoundZero& other) {
      return other.index == zero.index && distance(other.x, zero.x) < 1e-12;
    }));
}

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
    const CriticalPoints points = guide::find_critical_points(field::FieldEvaluator(field), {}, report);
    EXPECT_NO_THROW(guide::require_index_sum(points, field.mesh.face));
    const bool separate = excess > 1e-3;
    EXPECT_EQ(points.critical_points.size(), separate ? 1u : 0u) << excess;
    EXPECT_EQ(points.corners[2].valence, separate ? 2 : 1) << excess;
  }
}

TEST(ZeroSearch, regular_polygons_have_their_zero_at_the_centre) {
  for (const int n : {3, 5}) {
    const Field field = adapted_field(polygon_face(regular_polygon(n, 0.3)));
    Report report;
    const CriticalPoints points = guide::find_critical_points(field::FieldEvaluator(field), {}, report);
    ASSERT_EQ(points.critical_points.size(), 1u);
    EXPECT_NEAR(norm(points.critical_points[0].position), 0, 1e-12);
    EXPECT_EQ(points.critical_points[0].index, 4 - n);
    EXPECT_NO_THROW(guide::require_index_sum(points, field.mesh.face));
  }
}

TEST(ZeroSearch, a_turned_and_moved_face_has_its_points_turned_and_moved) {
  const std::vector<Vec2> corners{{0, 0}, {3, 0.4}, {2.6, 1.9}, {1.1, 1.2}, {0.3, 2.2}};
  const auto move = [](Vec2 p) { return Vec2{0.8 * p.x - 0.6 * p.y + 5, 0.6 * p.x + 0.8 * p.y - 3}; };
  std::vector<Vec2> moved;
  for (const Vec2 c : corners) moved.push_back(move(c));
  Report report;
  const Field a = adapted_field(polygon_face(corners)), b = adapted_field(polygon_face(moved));
  const CriticalPoints here = guide::find_critical_points(field::FieldEvaluator(a), {}, report);
  const CriticalPoints there = guide::find_critical_points(field::FieldEvaluator(b), {}, report);
  EXPECT_NO_THROW(guide::require_index_sum(here, a.mesh.face));
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

struct DistinctZeros : testing::Test {
  Field field = interpolated_field(square_mesh({0, 0}, 1, 1), 1, [](Vec2) { return Vec2{1, 0}; });
  field::FieldEvaluator evaluator{field};

  /// A zero of the polynomial of `elem`, at x, found in a cell of radius 0.1.
  FoundZero zero(int elem, Vec2 x, int index = 1, double shift = 0) const {
    FoundZero result;
    result.elem = elem;
    result.x = x;
    result.index = index;
    result.cell_radius = 0.1;
    result.shift = shift;
    evaluator.maps()[elem].invert(x, result.xi);
    return result;
  }
};

TEST_F(DistinctZeros, KeepsOneOfThoseFoundOnBothSidesOfAnEdge) {
  const Vec2 on_diagonal{0.5, 0.5};
  const auto zeros = distinct_zeros(evaluator, {zero(0, on_diagonal), zero(1, on_diagonal + Vec2{1e-13, 0})});
  ASSERT_EQ(zeros.size(), 1u);
  EXPECT_EQ(zeros[0].elem, 0);
}

TEST_F(DistinctZeros, PrefersTheOneInsideItsOwnElement) {
  // Both lie above the diagonal, in element 1: the one of element 0 is beyond its edge.
  const auto zeros =
      distinct_zeros(evaluator, {zero(0, {0.5, 0.5 + 1e-6}, 1, 1e-6), zero(1, {0.5, 0.5 + 2e-6}, 1, 1e-6)});
  ASSERT_EQ(zeros.size(), 1u);
  EXPECT_EQ(zeros[0].elem, 1);
}

TEST_F(DistinctZeros, KeepsTwoOfOppositeIndexOrFarApart) {
  EXPECT_EQ(distinct_zeros(evaluator, {zero(0, {0.6, 0.2}, 1), zero(0, {0.6, 0.2}, -1)}).size(), 2u);
  EXPECT_EQ(distinct_zeros(evaluator, {zero(0, {0.6, 0.2}), zero(0, {0.61, 0.2})}).size(), 2u);
  EXPECT_EQ(distinct_zeros(evaluator, {zero(0, {0.6, 0.2}, 1, 2e-3), zero(0, {0.61, 0.2})}).size(), 1u);
}

TEST_F(DistinctZeros, KeepsAZeroThatFallsIntoTheGapButNoneBeyondTheMesh) {
  const auto gap = distinct_zeros(evaluator, {zero(0, {0.5, 0.5 + 1e-6})});
  EXPECT_EQ(gap.size(), 1u);
  EXPECT_TRUE(distinct_zeros(evaluator, {zero(0, {0.5, -1e-3})}).empty());
}

TEST_F(DistinctZeros, UnexplainedAreOpenCellsThatNoZeroReaches) {
  const OpenCell cell{0, {0.6, 0.2}, 1e-6, {}};
  EXPECT_EQ(cells_without_zero({cell}, {zero(0, {0.6, 0.2}, 1, 1e-7)}).size(), 1u);
  EXPECT_TRUE(cells_without_zero({cell}, {zero(0, {0.6, 0.2}, 1, 1e-6)}).empty());
  EXPECT_EQ(cells_without_zero({cell}, {}).size(), 1u);
}

}  // namespace
}  // namespace quadrille::zeros
