#include "sizing/make_size_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "../hand_made.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "block/extract_blocks.hpp"
#include "sizing/element_limit.hpp"

namespace quadrille::sizing {
namespace {

TEST(MakeSizeField, TakesAllSourcesTogether) {
  const CadFace face = hand_made::unit_square().face;
  SizeOptions options;
  EXPECT_NEAR(make_size_field(face, options).at({0.5, 0.5}), face.diameter / 20, 1e-15);
  options.size = 0.5;
  options.near = {{"side_0", 0.1}, {"2", 0.2}};
  options.sources.growth = 1.4;
  EXPECT_NEAR(make_size_field(face, options).at({0.5, 0.25}), 0.1 + std::log(1.4) * 0.25, 1e-15);
  EXPECT_NEAR(make_size_field(face, options).at({0.5, 0.9}), 0.2 + std::log(1.4) * 0.1, 1e-15);
  options.growth = 1.1;
  EXPECT_NEAR(make_size_field(face, options).at({0.5, 0.25}), 0.1 + std::log(1.1) * 0.25, 1e-15);
  options.growth = 1;
  EXPECT_THROW(make_size_field(face, options), UsageError);
}

TEST(MakeSizeField, StraightEdgesKeepTheirDistanceFromCurves) {
  const double size = 0.4, sag = 2 - std::sqrt(4 - size * size / 4);  // of an edge of this length on the circle
  SizeOptions options;
  options.size = 10;
  options.sags = {{curve::circular_arc({0, 0}, 2, 0, 2 * pi), sag}};
  EXPECT_NEAR(make_size_field(hand_made::unit_square().face, options).at({2, 0}), size, 1e-3);
}

TEST(MakeSizeField, ParsesWhatTheCommandLineHas) {
  EXPECT_EQ(parse_near_size("a=b=0.5").boundary, "a=b");
  EXPECT_EQ(parse_near_size("wall=2e-3").size, 2e-3);
  for (const char* text : {"wall", "wall=", "=1", "wall=x", "wall=0", "wall=-1", "wall=1x", "wall=inf"})
    EXPECT_THROW(parse_near_size(text), UsageError) << text;
}

double least_size(const std::vector<SizeSegment>& segments) {
  double least = 1e300;
  for (const SizeSegment& s : segments) least = std::min({least, s.size_a, s.size_b});
  return least;
}

TEST(CurveSizes, ShortCurvesAreDividedAndLongOnesAreNot) {
  // A rectangle 10 x 1: the short sides have 4 elements, the long ones are long enough.
  CadFace face = hand_made::face({{curve::segment({0, 0}, {10, 0}), curve::segment({10, 0}, {10, 1}),
                                   curve::segment({10, 1}, {0, 1}), curve::segment({0, 1}, {0, 0})}},
                                 std::sqrt(101.0));
  const std::vector<SizeSegment> segments = segments_by_curves(face, 4, 0, 0.5, 0.2);
  EXPECT_NEAR(least_size(segments), 0.25, 1e-12);
  for (const SizeSegment& s : segments) EXPECT_TRUE(s.a.x == s.b.x && (s.a.x == 0 || s.a.x == 10)) << s.a.x;
  EXPECT_NEAR(least_size(segments_by_curves(face, 4, 0.3, 0.5, 0.2)), 0.3, 1e-12) << "the limit";
  EXPECT_TRUE(segments_by_curves(face, 2, 0, 0.5, 0.2).empty()) << "sizes that are not finer are no sources";
}

TEST(CurveSizes, AHoleWithoutCornersHasThreeTimesAsMany) {
  const CadFace face = hand_made::cut_annulus(4).face;  // radii 1 and 0.5
  EXPECT_NEAR(least_size(segments_by_curves(face, 4, 0, 0.3, 0.2)), 2 * pi * 0.5 / 12, 1e-9);
}

TEST(CurveSizes, ARunPassesSmoothJointsAndEndsAtGivenNames) {
  // Line and quarter circle are one run of length 1 + pi; with names they are two.
  CadFace face = hand_made::elbow().face;
  const auto shortest_but = [&](double side) {
    double least = 1e300;
    for (const SizeSegment& s : segments_by_curves(face, 4, 0, 10, 0.2))
      if (std::abs(s.size_a - side) > 1e-9) least = std::min(least, s.size_a);
    return least;
  };
  EXPECT_NEAR(shortest_but(0.25), (1 + half_pi) / 4, 1e-9) << "the inner side: line and quarter circle";
  hand_made::give_name(face, 4, "wall");
  EXPECT_NEAR(shortest_but(0.25), half_pi / 4, 1e-9) << "the quarter circle alone";
}

TEST(CurveSizes, ATinyEdgeIsLimited) {
  CadFace face = hand_made::face({{curve::segment({0, 0}, {1, 0}), curve::segment({1, 0}, {1, 1e-5}),
                                   curve::segment({1, 1e-5}, {0, 1}), curve::segment({0, 1}, {0, 0})}},
                                 std::sqrt(2.0));
  EXPECT_NEAR(least_size(segments_by_curves(face, 4, 0, 0.1, 0.2)), 1e-3 * std::sqrt(2.0), 1e-12);
}

CadFace square() { return hand_made::unit_square().face; }

TEST(MakeSizeField, OfAHalfIsThatOfTheWhole) {
  CadFace half = hand_made::unit_square().face;
  half.curve_names[0] = "symmetry";
  SizeOptions options;
  options.symmetry = {"symmetry"};
  EXPECT_NEAR(make_size_field(half, options).greatest(), std::sqrt(5.0) / 20, 1e-12);
}

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

TEST(MakeSizeField, NumbersThatAreNoneAreRefused) {
  for (double SizeOptions::*member : {&SizeOptions::size, &SizeOptions::growth, &SizeOptions::curvature}) {
    SizeOptions options;
    options.*member = std::nan("");
    EXPECT_THROW(options.validate(), UsageError);
  }
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

SeparatrixGraph rectangle(double width, double height) {
  CadFace face = hand_made::face({{curve::segment({0, 0}, {width, 0}), curve::segment({width, 0}, {width, height}),
                                   curve::segment({width, height}, {0, height}), curve::segment({0, height}, {0, 0})}},
                                 norm(Vec2{width, height}));
  return hand_made::one_block(std::move(face), {{0}, {1}, {2}, {3}});
}

BlockLayout layout_of(const SeparatrixGraph& graph) {
  Report report;
  return block::extract_blocks(graph, report);
}

double num_elements(const BlockLayout& layout, const SizeOptions& options) {
  const MeasuredLayout measured(layout);
  return num_planned(measured, grade_chords(measured, make_size_field(layout.face, options), SizeRule::nearest, {}));
}

SizeOptions automatic(const BlockLayout& layout, SizeOptions options = {}) {
  return with_curve_sizes(MeasuredLayout(layout), options, SizeRule::nearest);
}

TEST(AutomaticSizes, ShortCurvesAreFollowedWhereThatMakesFewMoreElements) {
  // The short sides, of length 1, are to have 4 elements of 0.25 where the size is 0.3.
  const BlockLayout layout = layout_of(rectangle(6, 1));
  const SizeOptions sizes = automatic(layout);
  EXPECT_EQ(sizes.per_curve, 4);
  EXPECT_NEAR(sizes.least_along_curves, 0.25, 1e-12);
}

TEST(AutomaticSizes, ThereAreAtMostTwiceAsManyElements) {
  // Sides of 0.5 with 4 elements make 4 rows of more than 20 in place of 2 of 20.
  const BlockLayout layout = layout_of(rectangle(6, 0.5));
  SizeOptions none;
  none.per_curve = 0;
  const double coarse = num_elements(layout, none);
  SizeOptions all;
  all.per_curve = 4;
  EXPECT_GT(num_elements(layout, all), 2 * coarse);
  const SizeOptions sizes = automatic(layout);
  EXPECT_EQ(sizes.per_curve, 4);
  EXPECT_LE(num_elements(layout, sizes), 2 * coarse);
  EXPECT_GT(num_elements(layout, sizes), 1.2 * coarse);
  SizeOptions finer = sizes;
  finer.least_along_curves /= 1.2;
  EXPECT_GT(num_elements(layout, finer), 2 * coarse) << "the least size is not much too great";
}

TEST(AutomaticSizes, LongCurvesNeedNone) {
  const SizeOptions sizes = automatic(layout_of(hand_made::unit_square()));
  EXPECT_EQ(sizes.per_curve, 0);
}

TEST(AutomaticSizes, APrescribedSizeTableOrNumberIsKept) {
  const BlockLayout layout = layout_of(rectangle(6, 1));
  SizeOptions options;
  options.size = 0.3;
  EXPECT_EQ(automatic(layout, options).per_curve, 0);
  options = {};
  options.sources.is_table = true;
  options.sources.points = {{{0, 0}, 0.3, 0}};
  EXPECT_EQ(automatic(layout, options).per_curve, 0);
  options = {};
  options.per_curve = 7;
  EXPECT_EQ(automatic(layout, options).per_curve, 7);
}

TEST(AutomaticSizes, InAFarFieldElementsMayBeMany) {
  BlockLayout layout = layout_of(rectangle(6, 0.5));
  std::fill(layout.face.curve_names.begin(), layout.face.curve_names.end(), "farfield");
  layout.face.unnamed_curves.clear();
  const SizeOptions sizes = automatic(layout);
  EXPECT_EQ(sizes.per_curve, 4);
  EXPECT_EQ(sizes.least_along_curves, 0);
}

TEST(AutomaticSizes, ElementsGrowSlowlyAlongAWake) {
  // The upper side is the wake: 0.3 at both ends but for the short sides, which have elements of 0.125.
  BlockLayout layout = layout_of(rectangle(6, 0.5));
  layout.face.curve_names = {"farfield", "farfield", "wake", "body"};
  layout.face.unnamed_curves.clear();
  const SizeOptions sizes = automatic(layout);
  ASSERT_EQ(sizes.near.size(), 1u);
  EXPECT_EQ(sizes.near[0].boundary, "wake");
  EXPECT_NEAR(sizes.near[0].size, 0.125, 1e-9);
  EXPECT_NEAR(sizes.near[0].other_size, 0.125 + 6 * std::log(1.05), 1e-9);
  SizeOptions own;
  own.near = {{"wake@fluid", 0.2, 0.4}};
  EXPECT_EQ(automatic(layout, own).near.size(), 1u) << "the prescribed one";
}

}  // namespace
}  // namespace quadrille::sizing
