#include "sizing/make_size_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../hand_made.hpp"
#include "base/error.hpp"

namespace quadrille::sizing {
namespace {

CadFace square() { return hand_made::unit_square().face; }

TEST(MakeSizeField, WithoutOptionsIsATwentiethOfTheDiameterWhereNoCurveIsShort) {
  const SizeField sizes = make_size_field(square(), {});
  EXPECT_TRUE(sizes.is_uniform());
  EXPECT_NEAR(sizes.greatest(), std::sqrt(2.0) / 20, 1e-15);
}

TEST(MakeSizeField, SizesGrowAwayFromANamedBoundary) {
  SizeOptions options;
  options.size = 0.2;
  options.near = {{"side_0", 0.01}};
  options.growth = 1.5;
  const SizeField sizes = make_size_field(square(), options);
  EXPECT_NEAR(sizes.at({0.3, 0}), 0.01, 1e-12);
  EXPECT_NEAR(sizes.at({0.3, 0.1}), 0.01 + 0.1 * std::log(1.5), 1e-12);
  EXPECT_EQ(sizes.at({0.3, 1}), 0.2);
}

TEST(MakeSizeField, ShortCurvesAreFinerWhereThatIsPrescribed) {
  const CadFace face = hand_made::quarter_annulus(0.02, 2).face;  // an arc of 0.0314
  SizeOptions options;
  EXPECT_TRUE(make_size_field(face, options).is_uniform());
  options.per_curve = 4;
  EXPECT_NEAR(make_size_field(face, options).at(0.02 * unit(0.5)), 0.01 * pi / 4, 1e-7);
  options.per_curve = 8;
  EXPECT_NEAR(make_size_field(face, options).at(0.02 * unit(0.5)), 0.01 * pi / 8, 1e-7);
  options.least_along_curves = 0.01;
  EXPECT_NEAR(make_size_field(face, options).at(0.02 * unit(0.5)), 0.01, 1e-7);
  options.least_along_curves = 0;
  options.size = 0.2;
  EXPECT_NEAR(make_size_field(face, options).at(0.02 * unit(0.5)), 0.01 * pi / 8, 1e-7) << "as prescribed";
  options.per_curve = -2;
  EXPECT_THROW(options.validate(), UsageError);
}

TEST(MakeSizeField, ANumberOfElementsPerCurveIsRead) {
  EXPECT_EQ(parse_per_curve("auto"), SizeOptions::automatic);
  EXPECT_EQ(parse_per_curve("3"), 3);
  for (const char* bad : {"", "few", "-1", "1.5", "10001"}) EXPECT_THROW(parse_per_curve(bad), UsageError) << bad;
}

TEST(MakeSizeField, ATableHasItsOwnGreatestSize) {
  SizeOptions options;
  options.sources.points = {{{0, 0}, 0.3, 0}, {{1, 0}, 0.6, 0}};
  options.sources.is_table = true;
  EXPECT_EQ(make_size_field(square(), options).greatest(), 0.6);
  options.size = 0.4;
  EXPECT_EQ(make_size_field(square(), options).greatest(), 0.4);
}

TEST(MakeSizeField, TheGrowthOfTheOptionGoesBeforeThatOfTheFile) {
  SizeOptions options;
  options.sources = {{{{0.5, 0.5}, 0.01, 0}}, {}, 1.4};
  EXPECT_NEAR(make_size_field(square(), options).slope(), std::log(1.4), 1e-15);
  options.growth = 1.1;
  EXPECT_NEAR(make_size_field(square(), options).slope(), std::log(1.1), 1e-15);
  options.growth = options.sources.growth = 0;
  EXPECT_NEAR(make_size_field(square(), options).slope(), std::log(SizeField::default_growth), 1e-15);
}

TEST(MakeSizeField, CurvaturePrescribesElementsPerTurn) {
  const CadFace face = hand_made::quarter_annulus().face;
  SizeOptions options;
  options.size = 1;
  options.curvature = 40;
  const SizeField sizes = make_size_field(face, options);
  EXPECT_NEAR(sizes.at(unit(0.5)), 2 * pi / 40, 1e-4) << "on the circle of radius 1";
}

TEST(MakeSizeField, RefusesWhatIsNoSize) {
  SizeOptions options;
  options.near = {{"no such boundary", 0.1}};
  EXPECT_THROW(make_size_field(square(), options), UsageError);
  for (const auto& change : {+[](SizeOptions& o) { o.size = -1; }, +[](SizeOptions& o) { o.growth = 1; },
                             +[](SizeOptions& o) { o.curvature = -1; }}) {
    SizeOptions wrong;
    change(wrong);
    EXPECT_THROW(make_size_field(square(), wrong), UsageError);
  }
}

TEST(MakeSizeField, ParsesSizesNearABoundary) {
  EXPECT_EQ(parse_near_size("hole=0.5").boundary, "hole");
  EXPECT_EQ(parse_near_size("hole=0.5").size, 0.5);
  EXPECT_EQ(parse_near_size("a=b=1e-3").boundary, "a=b") << "the last = counts";
  for (const char* wrong : {"hole", "=1", "hole=", "hole=0", "hole=-1", "hole=x", "hole=inf"})
    EXPECT_THROW(parse_near_size(wrong), UsageError) << wrong;
}

TEST(MakeSizeField, ParsesSizesThatGrowAlongABoundary) {
  EXPECT_EQ(parse_near_size("wake=0.1:0.5").size, 0.1);
  EXPECT_EQ(parse_near_size("wake=0.1:0.5").other_size, 0.5);
  EXPECT_EQ(parse_near_size("wake=0.1").other_size, 0);
  for (const char* wrong : {"wake=0.1:", "wake=:0.1", "wake=0.1:0", "wake=0.1:0.2:0.3", "wake=0.1:x"})
    EXPECT_THROW(parse_near_size(wrong), UsageError) << wrong;
}

TEST(MakeSizeField, SizesGrowFromTheLeftEndOfABoundaryToTheRightOne) {
  // Whatever the direction of the curves: the bottom of the square runs to the right, its top to the left.
  const CadFace face = hand_made::unit_square().face;
  SizeOptions options;
  options.size = 10;
  options.growth = 1.5;
  for (const char* side : {"0", "2"}) {
    options.near = {{side, 0.01, 0.05}};
    const SizeField field = make_size_field(face, options);
    const double y = *side == '0' ? 0 : 1;
    EXPECT_NEAR(field.at({0, y}), 0.01, 1e-12);
    EXPECT_NEAR(field.at({0.25, y}), 0.02, 1e-6);
    EXPECT_NEAR(field.at({1, y}), 0.05, 1e-12);
  }
  options.near = {{"1", 0.01, 0.05}};  // upright: from the lower end
  EXPECT_NEAR(make_size_field(face, options).at({1, 0.5}), 0.03, 1e-6);
}

}  // namespace
}  // namespace quadrille::sizing
