#include "couple/periodic_nodes.hpp"

#include <gtest/gtest.h>

#include "model/periodic.hpp"
#include "rectangles.hpp"

namespace quadrille::couple {
namespace {

TEST(SnapPeriodicNodes, MovesNodesOntoNearImages) {
  PeriodicSquare square({{0.3, 0.3 + 5e-9}});
  SeparatrixGraph graph = graph::separatrix_graph(std::move(square.layouts.layouts.front()));
  snap_periodic_nodes(graph);
  EXPECT_NEAR(graph.nodes[5].t, 0.3, 1e-15) << "the end on the second side";
  EXPECT_EQ(graph.splines[0].poles.back(), graph.nodes[5].position);
  EXPECT_EQ(periodic_arcs(graph).size(), 2U);
}

TEST(SnapPeriodicNodes, LeavesOthersAlone) {
  PeriodicSquare square({{0.3, 0.3001}});
  SeparatrixGraph graph = graph::separatrix_graph(std::move(square.layouts.layouts.front()));
  snap_periodic_nodes(graph);
  EXPECT_EQ(graph.nodes[5].t, 0.3001);
}

TEST(DividePeriodicSides, EachSideHasANodeWhereTheOtherOneHas) {
  PeriodicSquare square({{0.3, 0.5}});
  EXPECT_EQ(divide_periodic_sides(square.layouts.layouts.front()), 2);
  EXPECT_TRUE(square.has_node(0, {0, 0.5}));
  EXPECT_TRUE(square.has_node(0, {1, 0.3}));
  EXPECT_EQ(periodic_arcs(square.graph(0)).size(), 3U);
  EXPECT_EQ(divide_periodic_sides(square.layouts.layouts.front()), 0) << "now they are images of each other";
}

}  // namespace
}  // namespace quadrille::couple
