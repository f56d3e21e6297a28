#include "model/interfaces.hpp"

#include <gtest/gtest.h>

#include "../support/region_graphs.hpp"
#include "../triangulate/faces.hpp"

namespace quadrille {

namespace {

TEST(Interfaces, CurvesKnowTheirRegions) {
  const SeparatrixGraph disc = region_graphs::disc_in_square();
  EXPECT_EQ(curve_regions(disc.face), (std::vector<int>{0, 0, 0, 0, 0, 1}));
  EXPECT_EQ(disc.face.partners, (std::vector<int>{-1, -1, -1, -1, 5, 4}));
}

TEST(Interfaces, ArcsBetweenRegionsAreNoBoundary) {
  const SeparatrixGraph squares = region_graphs::two_squares();
  for (int a = 0; a < 7; ++a) {
    EXPECT_TRUE(is_on_cad_curve(squares, squares.arcs[a]));
    EXPECT_EQ(is_on_interface(squares, squares.arcs[a]), a == 1);
  }
  const SeparatrixGraph plate = region_graphs::slit_plate(false);
  int num_on_slit = 0;
  for (const GraphArc& arc : plate.arcs) num_on_slit += is_on_interface(plate, arc);
  EXPECT_EQ(num_on_slit, 2);
}

TEST(Interfaces, ACurveInsideAFaceSeparatesRegionsOfOneName) {
  SeparatrixGraph squares = region_graphs::two_squares();
  const std::vector<int> regions = curve_regions(squares.face);
  squares.face.region_names = {"fluid", "solid"};
  for (int a = 0; a < 7; ++a) EXPECT_EQ(separates_faces(squares, squares.arcs[a], regions), a == 1);
  squares.face.region_names = {"fluid", "fluid"};
  EXPECT_FALSE(separates_faces(squares, squares.arcs[1], regions));
  const SeparatrixGraph plate = region_graphs::slit_plate(false);
  for (const GraphArc& arc : plate.arcs) EXPECT_FALSE(separates_faces(plate, arc, curve_regions(plate.face)));
}

TEST(Interfaces, TheLeftSideIsThatOfTheCurveOrOfItsPartner) {
  SeparatrixGraph squares = region_graphs::two_squares();
  const std::vector<int> regions = curve_regions(squares.face);
  EXPECT_EQ(region_on_left(squares, {1}, regions), 0);
  EXPECT_EQ(region_on_left(squares, {1, true}, regions), 1);
  EXPECT_EQ(region_on_left(squares, {5}, regions), 1);
  std::swap(squares.arcs[1].pieces[0].t0, squares.arcs[1].pieces[0].t1);
  EXPECT_EQ(region_on_left(squares, {1}, regions), 1);
}

TEST(Interfaces, APointHasOneParameterOnEachSide) {
  const SeparatrixGraph disc = region_graphs::disc_in_square();
  for (const double t : {0.0, 0.25, 1.0}) {
    const PartnerPoint at = partner_point(disc.face, 4, t * disc.face.curves[4].end());
    EXPECT_EQ(at.curve, 5);
    EXPECT_LT(distance(curve::point(disc.face.curves[5], at.t),
                       curve::point(disc.face.curves[4], t * disc.face.curves[4].end())),
              1e-14);
  }
}

TEST(Interfaces, RegionsPutTogetherHaveTheCharacteristicOfTheWhole) {
  EXPECT_EQ(euler_characteristic_of_whole(region_graphs::two_squares()), 1);
  EXPECT_EQ(euler_characteristic_of_whole(region_graphs::disc_in_square()), 1);
  EXPECT_EQ(euler_characteristic_of_whole(region_graphs::slit_plate(false)), 1);
  EXPECT_EQ(euler_characteristic_of_whole(region_graphs::slit_plate(true)), 0) << "a crack is a hole";
  EXPECT_EQ(euler_characteristic_of_whole(hand_made::cut_annulus(4)), 0) << "one region";
  for (const SeparatrixGraph& graph : {region_graphs::two_squares(), region_graphs::disc_in_square(),
                                       region_graphs::slit_plate(false), region_graphs::slit_plate(true)})
    EXPECT_EQ(index_sum_of(graph), 4 * euler_characteristic_of_whole(graph));
}

using namespace testing_faces;

std::vector<int> enclosed(const CadFace& face) {
  const std::vector<bool> are_enclosed = enclosed_joints(face);
  std::vector<int> joints;
  for (int j = 0; j < face.num_curves(); ++j)
    if (are_enclosed[j]) joints.push_back(j);
  return joints;
}

TEST(EnclosedJoints, AreAllOfASlit) {
  EXPECT_EQ(enclosed(slit_square()), (std::vector<int>{4, 5}));
  EXPECT_EQ(enclosed(bent_slit(0.5)), (std::vector<int>{4, 5, 6, 7}));
  EXPECT_EQ(enclosed(open_slit()), (std::vector<int>{2, 3, 4})) << "the ends on the outline too";
}

TEST(EnclosedJoints, AreThoseWhereARegionTouchesItself) {
  EXPECT_EQ(enclosed(pinched_square()), (std::vector<int>{5, 8}));
}

TEST(EnclosedJoints, AreNoOrdinaryCorners) {
  EXPECT_TRUE(enclosed(l_shape()).empty());
  EXPECT_TRUE(enclosed(annulus()).empty());
}

}  // namespace

}  // namespace quadrille
