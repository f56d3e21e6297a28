#include "layers/end_spacing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "layers/normal_line.hpp"
#include "spectral/quadrature.hpp"
#include "wall_samples.hpp"

namespace quadrille::layers {
namespace {

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

TEST(GradedIntervals, AreEqualBetweenFreeEnds) {
  EXPECT_EQ(graded_intervals({}, 4, 2, 1), (std::vector<double>{0.5, 0.5, 0.5, 0.5}));
}

TEST(GradedIntervals, GrowFromTheirNeighbourAndFillTheLength) {
  const std::vector<double> grown = graded_intervals({0.01, 0}, 20, 2, 0.2);
  EXPECT_NEAR(sum(grown), 2, 1e-12);
  EXPECT_TRUE(std::is_sorted(grown.begin(), grown.end()));
  EXPECT_LE(grown.back(), 0.2);
}

TEST(GradedIntervals, AreMirroredWithTheirEnds) {
  std::vector<double> there = graded_intervals({0.01, 0.05}, 15, 1, 0.2);
  const std::vector<double> back = graded_intervals({0.05, 0.01}, 15, 1, 0.2);
  std::reverse(there.begin(), there.end());
  for (std::size_t k = 0; k < back.size(); ++k) EXPECT_NEAR(there[k], back[k], 1e-13);
}

TEST(GradedIntervals, OfTheNeighboursLengthStayAsTheyAre) {
  for (const double interval : graded_intervals({0.1, 0.1}, 10, 1, 5)) EXPECT_NEAR(interval, 0.1, 1e-12);
}

TEST(GradedIntervals, ShrinkWhereThereIsLittleRoom) {
  const std::vector<double> crowded = graded_intervals({0.1, 0}, 10, 0.5, 1);
  EXPECT_NEAR(sum(crowded), 0.5, 1e-12);
  EXPECT_TRUE(std::is_sorted(crowded.rbegin(), crowded.rend()));
}

TEST(GradedIntervals, LeastCountKeepsGrowthAndSizeAndOneLessDoesNot) {
  for (const GradedEnds ends : {GradedEnds{1e-3, 0}, GradedEnds{0, 1e-3}, GradedEnds{1e-3, 4e-3}}) {
    const int count = least_graded_count(ends, 1, 0.1, 1.2, 1000);
    const auto intervals = graded_intervals(ends, count, 1, 0.1), fewer = graded_intervals(ends, count - 1, 1, 0.1);
    EXPECT_LE(worst_growth(ends, intervals), 1.2 * (1 + 2e-6));
    EXPECT_LE(*std::max_element(intervals.begin(), intervals.end()), 0.1 * (1 + 1e-6));
    EXPECT_TRUE(worst_growth(ends, fewer) > 1.2 || *std::max_element(fewer.begin(), fewer.end()) > 0.1);
  }
  EXPECT_EQ(least_graded_count({}, 1, 0.3, 1.2, 1000), 4);
}

TEST(GradedIntervals, WorstGrowthCountsTheNeighbours) {
  EXPECT_DOUBLE_EQ(worst_growth({1, 0}, {2, 2}), 2);
  EXPECT_DOUBLE_EQ(worst_growth({0, 8}, {2, 2}), 4);
  EXPECT_DOUBLE_EQ(worst_growth({}, {2, 2}), 1);
}

const EndSpacing free_end, layers_of_three{{0.01, 0.03, 0.07}, 0.04, 1.5};

TEST(EndSpacing, TheFreePartLiesBetweenTheLayersOfBothEnds) {
  const FreePart part = free_part({layers_of_three, {{0.1}, 0.2, 1.2}}, 2, 0.3);
  EXPECT_NEAR(part.length, 2 * (1 - 0.07 - 0.1), 1e-15);
  EXPECT_EQ(part.layers, 4);
  EXPECT_EQ(part.ends.before, 0.04);
  EXPECT_EQ(part.ends.after, 0.2);
  EXPECT_EQ(part.size, 0.3);
  const FreePart all = free_part({}, 2, 0.3);
  EXPECT_EQ(all.length, 2);
  EXPECT_TRUE(all.ends.are_free());
}

TEST(EndSpacing, FreeEndsMakeEqualIntervals) {
  const std::vector<double> ends = spaced_ends({}, 3, 0.1, 4);
  ASSERT_EQ(ends.size(), 5u);
  for (int k = 0; k <= 4; ++k) EXPECT_NEAR(ends[k], k / 4.0, 1e-15);
}

TEST(EndSpacing, LayersStayWhereTheyArePrescribedAtBothEnds) {
  const std::vector<double> ends = spaced_ends({layers_of_three, {{0.1}, 0.1, 1.2}}, 1, 0.1, 12);
  ASSERT_EQ(ends.size(), 13u);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(ends[k + 1], layers_of_three.layer_ends[k]);
  EXPECT_EQ(ends[11], 1 - 0.1);
  EXPECT_EQ(ends.front(), 0);
  EXPECT_EQ(ends.back(), 1);
  for (std::size_t k = 1; k < ends.size(); ++k) EXPECT_GT(ends[k], ends[k - 1]);
}

TEST(EndSpacing, IntervalsGrowFromThePrescribedOne) {
  const std::vector<double> ends = spaced_ends({{{{}, 0.01, 1.2}, free_end}}, 1, 0.2, 12);
  double last = 0.01;
  for (std::size_t k = 1; k < ends.size(); ++k) {
    EXPECT_GT(ends[k] - ends[k - 1], last);
    last = ends[k] - ends[k - 1];
  }
}

TEST(EndSpacing, TheEvenSizeIsThePrescribedOneOrTheLeastWithWhichIntervalsGrowEvenly) {
  const ArcSpacing spacing{{{{0.01}, 0.01, 1.2}, {}}};
  const auto greatest_growth = [&](double size, int count) {
    const std::vector<double> ends = spaced_ends(spacing, 1, size, count);
    double greatest = 1;
    for (std::size_t k = 2; k < ends.size(); ++k)
      greatest = std::max(greatest, (ends[k] - ends[k - 1]) / (ends[k - 1] - ends[k - 2]));
    return greatest;
  };
  EXPECT_EQ(even_size(spacing, 1, 0.1, 1.2, 40), 0.1) << "many intervals";
  const double some = even_size(spacing, 1, 0.1, 1.2, 18);
  EXPECT_GT(some, 0.1);
  EXPECT_NEAR(greatest_growth(some, 18), 1.2, 1e-3);
  const double few = even_size(spacing, 1, 0.1, 1.2, 9);
  EXPECT_NEAR(greatest_growth(few, 9), 1.5702, 1e-3) << "1 + q + ... + q^8 = 100";
  EXPECT_EQ(even_size({}, 1, 0.1, 1.2, 3), 0.1) << "without prescribed ends";
}

using wall_samples::PlannedWalls;

TEST(RequestLayers, PrescribesTheLayersAtTheEndsThatStartAtTheWall) {
  const PlannedWalls p(wall_samples::row({1, 1}), 0.3, {"side_0:first=0.1,growth=1.5,layers=2"}, 3);
  const LayerRequests requests = request_layers(p.input, p.plan.walls, p.plan.heights);
  int num_layered = 0;
  for (const Vec2 foot : {Vec2{0, 0}, Vec2{1, 0}}) {
    const int arc = p.arc_between(foot, foot + Vec2{0, 1});
    const int end = distance(p.layout.nodes[p.layout.arcs[arc].from].position, foot) < 1e-9 ? 0 : 1;
    const EndSpacing& spacing = requests.spacings[arc][end];
    ASSERT_EQ(spacing.layers(), 2);
    EXPECT_NEAR(spacing.layer_ends[0], 0.1, 1e-12);
    EXPECT_NEAR(spacing.layer_ends[1], 0.25, 1e-12);
    EXPECT_NEAR(spacing.before, 0.15, 1e-12);
    EXPECT_EQ(spacing.growth, 1.5);
    const std::vector<double> heights = node_heights({0.1, 0.25}, 3);
    ASSERT_EQ(requests.nodes[arc][end].size(), heights.size());
    for (std::size_t k = 0; k < heights.size(); ++k) EXPECT_NEAR(requests.nodes[arc][end][k], heights[k], 1e-12);
  }
  for (const ArcSpacing& spacing : requests.spacings)
    for (const EndSpacing& end : spacing) num_layered += end.layers() > 0;
  EXPECT_EQ(num_layered, 2);
}

TEST(RequestLayers, NodesOfAnArcFollowTheLayersThenItsIntervals) {
  LayerRequests requests;
  requests.spacings = {{EndSpacing{{0.2}, 0.2, 1.2}, {}}, {}};
  requests.nodes = {{std::vector<double>{0.12, 0.2}, {}}, {}};
  const std::vector<std::vector<double>> nodes = layered_arc_nodes(requests, {{{0, 0.2, 1}}, {{0, 0.5, 1}}}, 2);
  ASSERT_EQ(nodes[0].size(), 5u);
  const std::vector<double> expected{0, 0.12, 0.2, 0.6, 1};
  for (int k = 0; k < 5; ++k) EXPECT_NEAR(nodes[0][k], expected[k], 1e-15);
  EXPECT_TRUE(nodes[1].empty()) << "no layers";
}

TEST(RequestLayers, AnArcWhoseLayerMovedHasNoNodesOfItsOwn) {
  LayerRequests requests;
  requests.spacings = {{EndSpacing{}, EndSpacing{{0.2}, 0.2, 1.2}}};
  requests.nodes = {{std::vector<double>{}, std::vector<double>{0.12, 0.2}}};
  EXPECT_FALSE(layered_arc_nodes(requests, {{{0, 0.5, 1 - 0.2, 1}}}, 2)[0].empty());
  EXPECT_TRUE(layered_arc_nodes(requests, {{{0, 0.5, 0.75, 1}}}, 2)[0].empty());
}

TEST(ArcSizes, AreTheHarmonicMeanOfTheSizeField) {
  // h(x) = 0.1 + ln(1.5) |x| on the bottom side, from a source in its beginning.
  const wall_samples::PlannedWalls p(hand_made::unit_square(), 1, {"side_0:first=0.1,layers=1"});
  const double slope = std::log(1.5);
  const sizing::SizeField sizes(10, SizeSources{{{{0, 0}, 0.1, 0}}, {}, 0}, {}, 1.5);
  const WallInput input{p.measured, p.specs, sizes, 4, 1e-3};
  ArcSizes arcs = arc_sizes(input);
  const int bottom = p.arc_between({0, 0}, {1, 0});
  EXPECT_NEAR(arcs.at(bottom), slope / std::log((0.1 + slope) / 0.1), 1e-3);
  arcs.scale[bottom] = 0.5;
  EXPECT_EQ(arcs.at(bottom), 0.5 * arcs.prescribed[bottom]);
}

}  // namespace
}  // namespace quadrille::layers
