#include "prescribe/boundary_counts.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "../hand_made.hpp"
#include "../support/texts.hpp"
#include "base/error.hpp"
#include "block/extract_blocks.hpp"

namespace quadrille::prescribe {
namespace {

BlockLayout blocks(const SeparatrixGraph& graph) {
  Report report;
  return block::extract_blocks(graph, report);
}

/// The count of each chord that has a prescribed one.
std::map<int, int> counts(const BlockLayout& layout, const std::vector<BoundaryCount>& boundaries,
                          const std::vector<sizing::ChordCount>& chords = {},
                          const std::vector<LayeredCount>& layered = {}) {
  std::map<int, int> found;
  for (const sizing::ChordCount& c :
       with_boundary_counts(sizing::MeasuredLayout(layout), sizing::SizeField(0.1), chords, boundaries, layered))
    found[c.chord] = c.count;
  return found;
}

/// The top of blocks 1, 2 and 1 wide: curve 4 of chords 0, 1 and 2. The sides are curves 3 and 5 of chord 3.
BlockLayout three_blocks() { return blocks(hand_made::row({1, 2, 1})); }

TEST(BoundaryCounts, ABoundaryOfSeveralChordsHasTheExactNumberSharedOutByTheSizes) {
  EXPECT_EQ(counts(three_blocks(), {{"side_4", 40}}), (std::map<int, int>{{0, 10}, {1, 20}, {2, 10}}));
  const std::map<int, int> odd = counts(three_blocks(), {{"side_4", 41}});
  EXPECT_EQ(odd.at(0) + odd.at(1) + odd.at(2), 41);
  EXPECT_EQ(odd.at(0), odd.at(2)) << "mirror images";
  EXPECT_EQ(counts(three_blocks(), {{"side_4", 3}}), (std::map<int, int>{{0, 1}, {1, 1}, {2, 1}}));
}

TEST(BoundaryCounts, TheSmallestDifferenceOfLengthsDecidesNoTie) {
  for (const double wider : {1 - 1e-12, 1.0, 1 + 1e-12})
    EXPECT_EQ(counts(blocks(hand_made::row({1, wider})), {{"side_3", 5}}), (std::map<int, int>{{0, 2}, {1, 3}}));
}

TEST(BoundaryCounts, PrescribedChordsKeepTheirNumbersAndTheRestIsSharedOut) {
  EXPECT_EQ(counts(three_blocks(), {{"side_4", 40}}, {{1, 30}}), (std::map<int, int>{{0, 5}, {1, 30}, {2, 5}}));
}

TEST(BoundaryCounts, BoundariesThatShareChordsAgree) {
  // side_1 is the bottom of the middle block: its chord is free of choice, that of the top follows.
  EXPECT_EQ(counts(three_blocks(), {{"side_4", 40}, {"side_1", 16}}), (std::map<int, int>{{0, 12}, {1, 16}, {2, 12}}));
  EXPECT_EQ(counts(three_blocks(), {{"side_3", 7}, {"side_5", 7}}), (std::map<int, int>{{3, 7}}));
}

/// The outer chords have five layers, the middle one none.
const std::vector<LayeredCount> outer_layers{{15, 5}, {20, 0}, {15, 5}, {10, 0}};

TEST(BoundaryCounts, TheIntervalsBetweenLayersAreSharedOut) {
  const auto shares = [](int count) { return counts(three_blocks(), {{"side_4", count}}, {}, outer_layers); };
  EXPECT_EQ(shares(50), (std::map<int, int>{{0, 15}, {1, 20}, {2, 15}}));
  EXPECT_EQ(shares(90), (std::map<int, int>{{0, 25}, {1, 40}, {2, 25}}));
  EXPECT_EQ(shares(14), (std::map<int, int>{{0, 6}, {1, 2}, {2, 6}}));
}

TEST(BoundaryCounts, LayersThatExceedTheNumberLeaveOneIntervalEach) {
  const auto shares = [](int count, const std::vector<sizing::ChordCount>& chords) {
    return counts(three_blocks(), {{"side_4", count}}, chords, outer_layers);
  };
  for (const int count : {3, 12}) EXPECT_EQ(shares(count, {}), (std::map<int, int>{{0, 6}, {1, 1}, {2, 6}}));
  EXPECT_EQ(shares(13, {}), (std::map<int, int>{{0, 6}, {1, 1}, {2, 6}}));
  EXPECT_EQ(shares(20, {{0, 3}}).at(2) + shares(20, {{0, 3}}).at(1), 14) << "chord 0 has six, not three";
}

TEST(BoundaryCounts, ChordsAtAFineEndHaveMoreOfTheElements) {
  const BlockLayout layout = three_blocks();
  const std::vector<sizing::ChordCount> shares = with_boundary_counts(
      sizing::MeasuredLayout(layout), sizing::SizeField(0.1), {}, {{"side_4", 60}}, {}, {{"side_4", 0.01, 0}});
  std::map<int, int> found;
  for (const sizing::ChordCount& c : shares) found[c.chord] = c.count;
  EXPECT_EQ(found[0] + found[1] + found[2], 60);
  EXPECT_GT(found[2], found[0] + 5) << "the top runs from the right";
}

TEST(BoundaryCounts, AMissedNumberIsReportedInTheWordsOfTheUser) {
  const BlockLayout layout = three_blocks();
  const sizing::MeasuredLayout measured(layout);
  sizing::ArcDivisions divisions(measured.num_arcs());
  const auto messages = [&](int count, const std::vector<LayeredCount>& layered) {
    Report report;
    report_boundary_counts(measured, divisions, {{"side_4", count}}, layered, report);
    std::string all;
    for (const auto& warning : report.warnings()) all += warning.message;
    return all;
  };
  EXPECT_EQ(messages(3, {}), "");
  expect_contains(messages(2, {}), "--count side_4=2: the boundary 'side_4' has 3 elements, not 2: the geometric");
  expect_contains(messages(2, outer_layers), "its wall layers and one element between or above them need at least 13");
}

std::string refusal(const BlockLayout& layout, const std::vector<BoundaryCount>& boundaries,
                    const std::vector<sizing::ChordCount>& chords = {}) {
  return message_of<UsageError>([&] { counts(layout, boundaries, chords); });
}

TEST(BoundaryCounts, WhatCannotBeIsRefusedWithTheReasonAndTheNearestNumbers) {
  const std::string opposite = refusal(three_blocks(), {{"side_3", 7}, {"side_5", 8}});
  expect_contains(opposite, "side_5");
  expect_contains(opposite, "chord 3 (7 elements): possible is 7");
  expect_contains(refusal(three_blocks(), {{"side_4", 2}}), "possible is 3");
  expect_contains(refusal(three_blocks(), {{"nowhere", 2}}), "--count: there is no boundary \"nowhere\"");
}

TEST(BoundaryCounts, ABoundaryThatAChordReachesTwiceHasAnEvenNumber) {
  SeparatrixGraph graph = hand_made::unit_square();
  graph.face.curve_names = {"ends", "side", "ends", "side"};
  EXPECT_EQ(counts(blocks(graph), {{"ends", 8}}), (std::map<int, int>{{0, 4}}));
  const std::string odd = refusal(blocks(graph), {{"ends", 9}});
  expect_contains(odd, "chord 0 (along it 2 times)");
  expect_contains(odd, "possible are 8 and 10");
}

TEST(BoundaryCounts, ASideThatLeavesTheBoundaryIsRefusedWithTheChord) {
  const std::string partial = refusal(blocks(hand_made::elbow()), {{"curve_0", 8}});
  expect_contains(partial, "follows the boundary 'curve_0' in part only");
  expect_contains(partial, "number of its chord, 0");
}

TEST(BoundaryCounts, TextsAreChordsOrBoundaries) {
  std::vector<sizing::ChordCount> chords;
  std::vector<BoundaryCount> boundaries;
  parse_count("3=12", chords, boundaries);
  parse_count("outlet=24", chords, boundaries);
  parse_count("a=b=1", chords, boundaries);
  ASSERT_EQ(chords.size(), 1u);
  EXPECT_EQ(chords[0].chord, 3);
  EXPECT_EQ(chords[0].count, 12);
  ASSERT_EQ(boundaries.size(), 2u);
  EXPECT_EQ(boundaries[0].boundary, "outlet");
  EXPECT_EQ(boundaries[0].count, 24);
  EXPECT_EQ(boundaries[1].boundary, "a=b") << "the last = counts";
  for (const char* wrong : {"3", "=4", "3=", "3=0", "3=1.5", "outlet", "outlet=x", "3=-2"})
    EXPECT_THROW(parse_count(wrong, chords, boundaries), UsageError) << wrong;
}

}  // namespace
}  // namespace quadrille::prescribe
