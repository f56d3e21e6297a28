#include "choice/choose_nodes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../support/polygon_field.hpp"
#include "base/error.hpp"

namespace quadrille::choice {
namespace {

const std::vector<Vec2> hexagon{{2, 0}, {1, 1.7}, {-1, 1.7}, {-2, 0}, {-1, -1.7}, {1, -1.7}};

TEST(ChooseNodes, TheIndexSumHoldsAndThePartsBeginInOrder) {
  const Field field = adapted_field(polygon_face(hexagon));
  Report report;
  std::vector<std::string> parts;
  const CriticalPoints points = choose_nodes(field, {}, 1, report, [&](const char* part) { parts.emplace_back(part); });
  EXPECT_EQ(parts, (std::vector<std::string>{"search", "resolve", "place"}));
  EXPECT_EQ(index_sum_of(points), 4);
  for (const CriticalPoint& node : points.critical_points) EXPECT_GE(node.elem, 0) << "elements are set";
}

TEST(ChooseNodes, OverridesAreUsedAndCheckedAgainstTheFace) {
  const Field field = adapted_field(polygon_face({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  Report report;
  NodeOptions options;
  options.overrides = {{0, 1, 2}};
  EXPECT_EQ(index_sum_of(choose_nodes(field, options, 1, report)), 4);
  EXPECT_EQ(choose_nodes(field, options, 1, report).critical_points.size(), 1U);
  options.overrides = {{0, 2, 1}};
  EXPECT_THROW(choose_nodes(field, options, 1, report), UsageError);
}

TEST(ChooseNodes, ZerosOfAFieldWithTiesAreKeptWhenTheirNodesMove) {
  const Field field = adapted_field(polygon_face({{0, 0}, {10, 0}, {10, 2}, {6, 6}, {0, 6}}));
  Report report;
  NodeOptions options;
  EXPECT_TRUE(choose_nodes(field, options, 1, report).zeros.empty()) << "the nodes are the zeros";
  options.place = placement::PlaceRule::energy;
  const CriticalPoints points = choose_nodes(field, options, 1, report);
  ASSERT_EQ(points.critical_points.size(), 1U);
  EXPECT_EQ(points.critical_points[0].source, NodeSource::place);
  ASSERT_EQ(points.zeros.size(), 1U);
  EXPECT_EQ(points.zeros[0].source, NodeSource::zero);
  EXPECT_GT(distance(points.zeros[0].position, points.critical_points[0].position), 1e-3);
}

TEST(ChooseNodes, WhatIsFoundIsSharedByChoicesWithTheSameSearch) {
  const Field field = adapted_field(polygon_face({{0, 0}, {10, 0}, {10, 2}, {6, 6}, {0, 6}}));
  NodeOptions options;
  const auto reason = [&] {
    Report report;
    const CriticalPoints points = choose_nodes(field, options, 1, report);
    const auto& entries = report.entries();
    EXPECT_TRUE(std::any_of(entries.begin(), entries.end(), [](const auto& e) { return e.first == "ties.searches"; }));
    return points.changes.at(0).reason;
  };
  const std::string alone = reason();
  options.found = std::make_shared<Found>();
  EXPECT_EQ(reason(), alone);
  ASSERT_TRUE(options.found->nodes);
  options.found->nodes->points.changes.at(0).reason = "found before";
  options.place = placement::PlaceRule::energy;
  EXPECT_EQ(reason(), "found before");
  options.max_valence = 5;
  EXPECT_EQ(reason(), alone);
}

TEST(ChooseNodes, EnergiesAreSharedByChoicesThatPlaceTheSameNodes) {
  const Field field = adapted_field(polygon_face({{0, 0}, {10, 0}, {10, 2}, {6, 6}, {0, 6}}));
  NodeOptions options;
  options.place = placement::PlaceRule::energy;
  options.found = std::make_shared<Found>();
  const auto position = [&] {
    Report report;
    return choose_nodes(field, options, 1, report).critical_points.at(0).position;
  };
  const Vec2 first = position();
  const std::size_t computed = options.found->energies.size();
  EXPECT_GT(computed, 3U);
  options.nodes = topology::NodeRule::fewest;
  EXPECT_EQ(distance(position(), first), 0);
  EXPECT_EQ(options.found->energies.size(), computed);
  options.placement.weight = 1;
  EXPECT_GT(distance(position(), first), 1e-6);
}

}  // namespace
}  // namespace quadrille::choice
