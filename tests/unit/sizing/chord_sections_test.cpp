#include "sizing/chord_sections.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../hand_made.hpp"
#include "block/extract_blocks.hpp"

namespace quadrille::sizing {
namespace {

BlockLayout layout_of(const SeparatrixGraph& graph) {
  Report report;
  return block::extract_blocks(graph, report);
}

ElementDensity density(const MeasuredLayout& measured, int chord, const SizeField& sizes, double u) {
  return ChordSections(measured, measured.chords()[chord], chord_blocks(measured)[chord], sizes).at(u);
}

TEST(ChordSections, EveryBlockLiesOnTwoChords) {
  const BlockLayout layout = layout_of(hand_made::l_shape());
  const MeasuredLayout measured(layout);
  std::vector<int> count(layout.num_blocks(), 0);
  for (const std::vector<ChordBlock>& blocks : chord_blocks(measured))
    for (const ChordBlock& b : blocks) ++count[b.block];
  EXPECT_EQ(count, (std::vector<int>{2, 2, 2}));
}

TEST(ChordSections, OneSizeIsAveragedOverTheLengthOfTheArcs) {
  // Arcs of length pi and pi / 2: the mean of the logarithms, weighted by length.
  const BlockLayout layout = layout_of(hand_made::quarter_annulus());
  const MeasuredLayout measured(layout);
  const ElementDensity d = density(measured, 1, SizeField(0.1), 0.3);
  EXPECT_NEAR(d.nearest, 10 * pi / std::cbrt(2.0), 1e-9);
  EXPECT_NEAR(d.greatest, 10 * pi, 1e-9);
}

TEST(ChordSections, AFineSizeOnOneArcWinsByTheSixthPower) {
  // Lines of length 1 with sizes from 0.05 at x = 0 to 0.05 + ln(1.2) at x = 1: two arcs, and lines between them.
  const BlockLayout layout = layout_of(hand_made::unit_square());
  const MeasuredLayout measured(layout);
  const SizeField sizes(1, {}, {{{0, -1}, {0, 2}, 0.05, 0.05}}, 1.2);
  const int chord = measured.chord_of(3);
  const ElementDensity d = density(measured, chord, sizes, 0.5);
  EXPECT_NEAR(d.greatest, 1 / 0.05, 1e-9) << "on the arc at x = 0";
  EXPECT_LT(d.nearest, d.greatest);
  EXPECT_GT(d.nearest, 0.8 * d.greatest);
}

TEST(ChordSections, ASourceInsideABlockIsSeenThere) {
  const BlockLayout layout = layout_of(hand_made::unit_square());
  const MeasuredLayout measured(layout);
  const SizeField sizes(0.5, {{{{0.5, 0.5}, 0.01, 0}}, {}, 0}, {}, 1.2);
  for (const int chord : {0, 1}) {
    EXPECT_GT(density(measured, chord, sizes, 0.5).greatest, 50);
    EXPECT_LT(density(measured, chord, sizes, 0.02).greatest, 15) << "far from the source";
  }
}

TEST(ChordSections, MirroredParametersOfASymmetricChordAgree) {
  const BlockLayout layout = layout_of(hand_made::unit_square());
  const MeasuredLayout measured(layout);
  const SizeField sizes(0.5, {{{{0.5, 0.5}, 0.02, 0.1}}, {}, 0}, {}, 1.3);
  for (const double u : {0.0, 0.1, 0.37}) {
    const ElementDensity low = density(measured, 0, sizes, u), high = density(measured, 0, sizes, 1 - u);
    EXPECT_NEAR(low.nearest, high.nearest, 1e-9 * low.nearest);
    EXPECT_NEAR(low.greatest, high.greatest, 1e-9 * low.greatest);
  }
}

}  // namespace
}  // namespace quadrille::sizing
