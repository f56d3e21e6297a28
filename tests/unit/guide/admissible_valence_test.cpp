#include "guide/admissible_valence.hpp"

#include <gtest/gtest.h>

namespace quadrille::guide {
namespace {

TEST(AdmissibleValence, blocks_have_15_to_165_degrees_but_those_of_sharp_corners) {
  EXPECT_TRUE(is_admissible_valence(90, 1));
  EXPECT_TRUE(is_admissible_valence(165, 1));
  EXPECT_FALSE(is_admissible_valence(166, 1));
  EXPECT_TRUE(is_admissible_valence(30, 2));
  EXPECT_FALSE(is_admissible_valence(29, 2));
  EXPECT_TRUE(is_admissible_valence(10, 0));
  EXPECT_FALSE(is_admissible_valence(10, 2));
  EXPECT_TRUE(is_admissible_valence(10, 1));  // a sharp corner needs a block
  EXPECT_FALSE(is_admissible_valence(90, -1));
  EXPECT_FALSE(is_admissible_valence(340, 5));
}

TEST(AdmissibleAfterAbsorption, keeps_blocks_between_15_and_165_degrees_and_near_right_angles) {
  EXPECT_TRUE(is_admissible_after_absorption(134, 1));
  EXPECT_TRUE(is_admissible_after_absorption(134, 2));
  EXPECT_FALSE(is_admissible_after_absorption(134, 3));
  EXPECT_TRUE(is_admissible_after_absorption(120, 2));   // 4/3 to 2: two thirds off
  EXPECT_FALSE(is_admissible_after_absorption(100, 2));  // 10/9 to 2
  EXPECT_FALSE(is_admissible_after_absorption(170, 1));
  EXPECT_TRUE(is_admissible_after_absorption(228.7, 2));
  EXPECT_TRUE(is_admissible_after_absorption(228.7, 3));
  EXPECT_FALSE(is_admissible_after_absorption(350, 5));
  EXPECT_FALSE(is_admissible_after_absorption(60, -1));
}

TEST(AdmissibleAfterAbsorption, zero_only_at_the_tie) {
  EXPECT_TRUE(is_admissible_after_absorption(45.5, 0));
  EXPECT_FALSE(is_admissible_after_absorption(60, 0));
}

}  // namespace
}  // namespace quadrille::guide
