#include "layers/request_layers.hpp"

#include <gtest/gtest.h>

#include "layers/normal_line.hpp"
#include "spectral/quadrature.hpp"
#include "wall_samples.hpp"

namespace quadrille::layers {
namespace {

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

}  // namespace
}  // namespace quadrille::layers
