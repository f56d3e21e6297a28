#include "prescribe/end_grading.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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

std::vector<sizing::ChordPlan> graded(const BlockLayout& layout, const std::vector<EndGrading>& gradings, double size,
                                      const std::vector<sizing::ChordCount>& counts = {}) {
  const sizing::MeasuredLayout measured(layout);
  std::vector<sizing::ChordPlan> plans =
      sizing::grade_chords(measured, sizing::SizeField(size), sizing::SizeRule::nearest, counts);
  apply_end_gradings(measured, gradings, 1.2, plans);
  return plans;
}

/// Lengths of the elements of a plan, in u.
std::vector<double> lengths(const sizing::ChordPlan& plan) {
  std::vector<double> result;
  for (int k = 0; k < plan.count; ++k)
    result.push_back(plan.grading.parameter((k + 1.0) / plan.count) -
                     plan.grading.parameter(static_cast<double>(k) / plan.count));
  return result;
}

double worst_ratio(const std::vector<double>& values) {
  double worst = 1;
  for (std::size_t k = 1; k < values.size(); ++k)
    worst = std::max({worst, values[k] / values[k - 1], values[k - 1] / values[k]});
  return worst;
}

const BlockLayout& square() {
  static const BlockLayout layout = blocks(hand_made::unit_square());
  return layout;
}

TEST(EndGrading, BothEndsHaveTheirLengthsAndElementsGrowBetweenThem) {
  const std::vector<double> l = lengths(graded(square(), {{"side_0", 0.01, 0.02}}, 0.1)[0]);
  EXPECT_NEAR(l.front(), 0.01, 1e-4);
  EXPECT_NEAR(l.back(), 0.02, 2e-4);
  EXPECT_LT(worst_ratio(l), 1.2 * 1.01);
  EXPECT_GT(*std::max_element(l.begin(), l.end()), 0.06) << "grows towards the prescribed size";
}

TEST(EndGrading, TheDirectionIsThatOfTheCurve) {
  // Side 2 runs against side 0, of the same chord.
  const std::vector<double> l = lengths(graded(square(), {{"side_2", 0.01, 0}}, 0.1)[0]);
  EXPECT_NEAR(l.back(), 0.01, 1e-4);
  EXPECT_GT(l.front(), 0.05);
}

TEST(EndGrading, APrescribedNumberOfElementsDeterminesTheGrowth) {
  for (const int count : {6, 10, 30, 200}) {
    const sizing::ChordPlan plan = graded(square(), {{"side_0", 0.01, 0.02}}, 0.1, {{0, count}})[0];
    EXPECT_EQ(plan.count, count);
    EXPECT_NEAR(plan.grading.count(), count, 1e-6) << "no factor is left";
    EXPECT_NEAR(lengths(plan).front(), 0.01, 2e-4) << count;
    EXPECT_NEAR(lengths(plan).back(), 0.02, 4e-4) << count;
  }
}

TEST(EndGrading, EveryPrescribedNumberOfElementsHasBothLengthsAndElementsThatRiseAndFallOnce) {
  for (int count = 16; count <= 60; ++count) {
    const sizing::ChordPlan plan = graded(square(), {{"side_0", 0.01, 0.05}}, 0.1, {{0, count}})[0];
    const std::vector<double> l = lengths(plan);
    EXPECT_NEAR(l.front(), 0.01, 1e-4) << count;
    EXPECT_NEAR(l.back(), 0.05, 5e-4) << count;
    EXPECT_LT(worst_ratio(l), 1.6) << count;
    int turns = 0;
    for (int k = 2; k < count; ++k) turns += (l[k] > l[k - 1]) != (l[k - 1] > l[k - 2]);
    EXPECT_LE(turns, 1) << count;
  }
}

TEST(EndGrading, ChordsWithPrescribedNumbersContinueEachOtherAlongABoundary) {
  // The top of blocks 1 and 2 wide runs from the right: 3 = 0.02 (1 + q + ... + q^39).
  const BlockLayout row = blocks(hand_made::row({1, 2}));
  const std::vector<sizing::ChordPlan> plans = graded(row, {{"side_3", 0, 0.02}}, 0.2, {{0, 22}, {1, 18}});
  std::vector<double> all;
  for (int c = 0; c < 2; ++c)
    for (const double l : lengths(plans[c])) all.push_back(l * (c + 1));
  ASSERT_EQ(all.size(), 40u);
  EXPECT_NEAR(all.front(), 0.02, 2e-4);
  EXPECT_LT(worst_ratio(all), 1.1);
}

TEST(EndGrading, TheReportHasTheGrowthAndAWarningWhereTheNumberRequiresMore) {
  const sizing::MeasuredLayout measured(square());
  const auto warnings = [&](int count, double end, const std::vector<sizing::ChordCount>& counts) {
    const sizing::ChordPlan plan = graded(square(), {{"side_0", end, end}}, 0.1, {{0, count}})[0];
    sizing::ArcDivisions divisions(measured.num_arcs());
    for (const int arc : measured.chords()[0].arcs) {
      divisions[arc].ends.clear();
      for (int k = 0; k <= count; ++k) divisions[arc].ends.push_back(plan.grading.parameter(1.0 * k / count));
    }
    Report report;
    report_end_gradings(measured, divisions, {{"side_0", end, end}}, 1.2, counts, report);
    std::vector<std::string> codes;
    for (const auto& warning : report.warnings()) codes.push_back(warning.code);
    return codes;
  };
  EXPECT_EQ(warnings(24, 0.3, {{0, 24}}), std::vector<std::string>{"W-SIZ-003"});
  EXPECT_EQ(warnings(24, 0.3, {}), std::vector<std::string>{});
  EXPECT_EQ(warnings(3, 0.32, {{0, 3}}), std::vector<std::string>{}) << "0.32, 0.36 and 0.32";
}

TEST(EndGrading, EndsThatAreCoarserThanTheSizesShrinkTowardsThem) {
  const std::vector<double> l = lengths(graded(square(), {{"side_0", 0.1, 0}}, 0.02)[0]);
  EXPECT_NEAR(l.front(), 0.1, 4e-3);
  EXPECT_LT(worst_ratio(l), 1.25);
  EXPECT_NEAR(l.back(), 0.02, 2e-3);
}

TEST(EndGrading, ABoundaryOfSeveralBlocksHasOneGrading) {
  // The top of blocks 0.1, 0.3 and 2 wide runs from the right.
  const BlockLayout row = blocks(hand_made::row({0.1, 0.3, 2}));
  const std::vector<sizing::ChordPlan> plans = graded(row, {{"side_4", 0, 0.01}}, 0.2);
  std::vector<double> all;
  const std::vector<double> widths{0.1, 0.3, 2};
  for (int c = 0; c < 3; ++c)
    for (const double l : lengths(plans[c])) all.push_back(l * widths[c]);
  EXPECT_NEAR(all.front(), 0.01, 2e-4);
  EXPECT_LT(worst_ratio(all), 1.45) << "whole numbers of elements in narrow blocks leave something";
  EXPECT_EQ(plans[3], graded(row, {}, 0.2)[3]) << "chords that leave the boundary stay";
}

TEST(EndGrading, WhatHasNoEndsIsRefused) {
  SeparatrixGraph annulus = hand_made::cut_annulus(4);
  const BlockLayout layout = blocks(annulus);
  expect_contains(message_of<UsageError>([&] { graded(layout, {{"side_0", 0.1, 0}}, 0.1); }), "is closed");
  expect_contains(message_of<UsageError>([&] { graded(layout, {{"roof", 0.1, 0}}, 0.1); }), "roof");
}

TEST(EndGrading, TextsHaveTwoLengthsOfWhichOneMayBeLeftOut) {
  EXPECT_EQ(parse_end_grading("a:b=0.1:0.2").boundary, "a:b");
  EXPECT_EQ(parse_end_grading("in=0.1:0.2").last, 0.2);
  EXPECT_EQ(parse_end_grading("in=0.1:").first, 0.1);
  EXPECT_EQ(parse_end_grading("in=:0.2").first, 0);
  for (const char* wrong : {"in", "in=0.1", "in=:", "=0.1:0.2", "in=0.1:x", "in=-1:1", "in=0:0", "in=inf:1"})
    EXPECT_THROW(parse_end_grading(wrong), UsageError) << wrong;
}

}  // namespace
}  // namespace quadrille::prescribe
