#include "ties/tilted_field.hpp"

#include <gtest/gtest.h>

#include "plates.hpp"

namespace quadrille::ties {
namespace {

TEST(TieOrbits, a_chamfer_has_two_ties_of_135_degrees) {
  const TieOrbits ties = tie_orbits(plate(10, 6, {0, 0, 1, 0}));
  ASSERT_EQ(ties.ties.size(), 2u);
  EXPECT_NEAR(degrees(ties.ties[0].angle), 135, 1e-12);
  EXPECT_EQ(ties.ties[0].smaller, 1);
  EXPECT_EQ(ties.orbits.size(), 2u);
  EXPECT_EQ(ties.units.size(), 2u);
}

TEST(TieOrbits, the_window_is_two_degrees_wide_and_inside_it_the_angle_is_that_of_the_tie) {
  for (const double angle : {43.1, 44.98, 45.02, 46.9}) {
    const TieOrbits ties = tie_orbits(plate(10, 6, {0, 0, 1, 0}, angle));
    ASSERT_EQ(ties.ties.size(), 2u) << angle;
    EXPECT_NEAR(degrees(ties.ties[1].angle), 135, 1e-12);
  }
  EXPECT_TRUE(tie_orbits(plate(10, 6, {0, 0, 1, 0}, 42.9)).ties.empty());
  EXPECT_TRUE(tie_orbits(plate(10, 6, {0, 0, 1, 0}, 47.1)).ties.empty());
}

TEST(TieOrbits, mirror_images_make_one_orbit_of_two_units) {
  for (const double angle : {44.98, 45.0, 45.02}) {
    const TieOrbits square = tie_orbits(plate(6, 6, {1, 1, 1, 1}, angle));
    EXPECT_EQ(square.ties.size(), 8u);
    EXPECT_EQ(square.units.size(), 2u) << angle;
    ASSERT_EQ(square.orbits.size(), 1u) << angle;
    EXPECT_EQ(square.orbits[0], (std::vector<int>{0, 1}));
  }
  const TieOrbits rectangle = tie_orbits(plate(8, 6, {1, 1, 1, 1}));
  EXPECT_EQ(rectangle.orbits.size(), 2u);
  EXPECT_EQ(rectangle.units.size(), 4u);
}

TEST(TieOrbits, a_corner_of_45_degrees_has_no_choice) {
  const TieOrbits ties = tie_orbits(testing_faces::make_face({testing_faces::polygon({{0, 0}, {4, 0}, {0, 4}})}));
  EXPECT_EQ(ties.ties.size(), 2u);
  EXPECT_EQ(ties.ties[0].smaller, 0);
  EXPECT_TRUE(ties.units.empty());
}

TEST(TieOrbits, a_chamfer_pairs_the_orbits_at_its_ends) {
  const CadFace two = plate(10, 6, {0, 0.5, 1, 0});
  EXPECT_EQ(chamfers(two, tie_orbits(two)), (std::vector<std::vector<int>>{{0, 1}, {2, 3}}));
  const CadFace square = plate(6, 6, {1, 1, 1, 1});
  EXPECT_TRUE(chamfers(square, tie_orbits(square)).empty());
}

}  // namespace
}  // namespace quadrille::ties
