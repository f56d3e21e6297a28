#include "features/automatic_size.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../hand_made.hpp"
#include "base/error.hpp"

namespace quadrille::features {
namespace {

CadFace rectangle(double width, double height) {
  using curve::segment;
  return hand_made::face({{segment({0, 0}, {width, 0}), segment({width, 0}, {width, height}),
                           segment({width, height}, {0, height}), segment({0, height}, {0, 0})}},
                         std::hypot(width, height));
}

TEST(AutomaticSize, IsAPartOfTheDiameterButNotMoreThanHalfTheWidth) {
  EXPECT_NEAR(automatic_feature_size(rectangle(30, 40)), 0.1, 1e-14);
  // Area by half the perimeter: the width of a long strip.
  EXPECT_NEAR(automatic_feature_size(rectangle(1000, 1)), 1000.0 / 2002, 1e-12);
}

TEST(AutomaticSize, HolesMakeAFaceNarrow) {
  CadFace ring = hand_made::face(
      {{curve::circular_arc({0, 0}, 1, 0, 2 * pi)}, {curve::circular_arc({0, 0}, 0.999, 2 * pi, 0)}}, 2);
  EXPECT_NEAR(automatic_feature_size(ring), 0.0005, 1e-10);
}

TEST(AutomaticSize, DoesNotDependOnHowFarAFarFieldReaches) {
  for (const double reach : {10.0, 100.0}) {
    CadFace face = hand_made::face(
        {{curve::circular_arc({0, 0}, reach, 0, 2 * pi)}, {curve::circular_arc({0, 0}, 1, 2 * pi, 0)}}, 2 * reach);
    face.curve_names = {"farfield", "body"};
    EXPECT_NEAR(automatic_feature_size(face), std::hypot(2, 2) / 500, 1e-12);
    face.curve_names[1] = "body_offset";
    EXPECT_NEAR(automatic_feature_size(face), 2 * reach / 500, 1e-12);
    face.curve_names = {"outline", "body"};
    EXPECT_NEAR(automatic_feature_size(face), 2 * reach / 500, 1e-12);
  }
}

TEST(AutomaticSize, TextsAreAutoOrALength) {
  const CadFace face = rectangle(30, 40);
  EXPECT_EQ(parse_feature_size("auto"), std::nullopt);
  EXPECT_EQ(parse_feature_size("0"), 0);
  EXPECT_EQ(parse_feature_size("2.5e-1"), 0.25);
  for (const char* text : {"-1", "1x", "", "nan", "inf", "automatic"})
    EXPECT_THROW(parse_feature_size(text), UsageError) << text;
}

}  // namespace
}  // namespace quadrille::features
