#include "sizing/curve_sizes.hpp"

#include <gtest/gtest.h>

#include "../hand_made.hpp"
#include "block/extract_blocks.hpp"
#include "sizing/element_limit.hpp"

namespace quadrille::sizing {
namespace {

SeparatrixGraph rectangle(double width, double height) {
  CadFace face = hand_made::face({{curve::segment({0, 0}, {width, 0}), curve::segment({width, 0}, {width, height}),
                                   curve::segment({width, height}, {0, height}), curve::segment({0, height}, {0, 0})}},
                                 norm({width, height}));
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
