#include "topology/corners_without_nodes.hpp"

#include <gtest/gtest.h>

#include "../support/critical_points.hpp"
#include "../triangulate/faces.hpp"

namespace quadrille::topology {
namespace {

using namespace testing_faces;
using hand_made::points_of;

/// The corners of the face with the index sum that it requires, whatever their valences.
CriticalPoints corners_of(const CadFace& face) {
  CriticalPoints points = points_of(face);
  points.index_sum_expected = 4 * face.euler_characteristic();
  return points;
}

std::vector<int> new_valences(const CadFace& face, const CriticalPoints& points) {
  std::vector<int> valences;
  for (const guide::CornerOverride& o : corners_without_nodes(face, points)) valences.push_back(o.valence);
  return valences;
}

TEST(CornersWithoutNodes, WhereTheSumHoldsNothingChanges) {
  for (const CadFace& face : {square(), l_shape(), annulus()})
    EXPECT_TRUE(new_valences(face, corners_of(face)).empty());
}

TEST(CornersWithoutNodes, ASquareAroundAHoleHasFourDiagonals) {
  const CadFace face = make_face({polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}), hole({2, 2}, 1)});
  EXPECT_EQ(new_valences(face, corners_of(face)), (std::vector<int>{2, 2, 2, 2}));
}

TEST(CornersWithoutNodes, SymmetricCornersChangeTogether) {
  // A regular hexagon needs two corners of valence 2, but all six are images of each other.
  std::vector<Vec2> points;
  for (int k = 0; k < 6; ++k) points.push_back(unit(k * pi / 3));
  const CadFace hexagon = make_face({polygon(points)});
  EXPECT_TRUE(new_valences(hexagon, corners_of(hexagon)).empty());
  // Stretched, the four corners that are images of each other are too many, the two others are enough.
  for (Vec2& x : points) x.x *= 1.5;
  const CadFace stretched = make_face({polygon(points)});
  const std::vector<guide::CornerOverride> chosen = corners_without_nodes(stretched, corners_of(stretched));
  ASSERT_EQ(chosen.size(), 2U);
  for (const guide::CornerOverride& o : chosen) {
    EXPECT_EQ(o.valence, 2);
    EXPECT_EQ(o.curve_b % 3, 0);  // at (1.5, 0) and (-1.5, 0)
  }
}

TEST(CornersWithoutNodes, PrescribedValencesStay) {
  const CadFace face = make_face({polygon({{0, 0}, {4, 0}, {4, 3}, {0, 3}}), hole({2, 1.5}, 1)});
  CriticalPoints points = corners_of(face);
  for (Corner& c : points.corners) c.source = NodeSource::corner;
  EXPECT_TRUE(new_valences(face, points).empty());
}

TEST(CornersWithoutNodes, AsFewNodesAsPossibleIfSomeAreRequired) {
  // Two holes require index -8 with right angles of valence 1, and -4 with valence 2; valence 3 has too thin blocks.
  const CadFace face = make_face({polygon({{0, 0}, {8, 0}, {8, 4}, {0, 4}}), hole({2, 2}, 1), hole({6, 2}, 1)});
  EXPECT_EQ(new_valences(face, corners_of(face)), (std::vector<int>{2, 2, 2, 2}));
}

TEST(CornersWithoutNodes, BoundaryNodesAndNodesOfDividedCornersCount) {
  const CadFace face = make_face({polygon({{0, 0}, {4, 0}, {4, 3}, {0, 3}}), hole({2, 1.5}, 1)});
  CriticalPoints points = corners_of(face);
  points.boundary_nodes.assign(4, {});  // four of valence 3: index -4
  EXPECT_TRUE(new_valences(face, points).empty());
  points.boundary_nodes.clear();
  points.critical_points.assign(4, hand_made::node({1, 1}, 5));
  for (CriticalPoint& p : points.critical_points) p.source = NodeSource::divide;
  EXPECT_TRUE(new_valences(face, points).empty());
}

}  // namespace
}  // namespace quadrille::topology
