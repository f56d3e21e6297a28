#include "couple/join_layouts.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "model/interfaces.hpp"
#include "rectangles.hpp"

namespace quadrille::couple {
namespace {

SeparatrixGraph joined(const std::vector<std::vector<Across>>& lines) {
  const Rectangles squares(lines);
  return join_layouts(squares.layouts);
}

int num_of_kind(const SeparatrixGraph& graph, NodeKind kind) {
  return static_cast<int>(
      std::count_if(graph.nodes.begin(), graph.nodes.end(), [&](const GraphNode& node) { return node.kind == kind; }));
}

TEST(JoinLayouts, LinesThatMeetShareANodeOfTheInterface) {
  const SeparatrixGraph graph = joined({{{0.3, 0.3}}, {{0.3, 0.3}}});
  EXPECT_EQ(graph.nodes.size(), 9U);
  EXPECT_TRUE(graph.t_junctions.empty());
  ASSERT_EQ(num_of_kind(graph, NodeKind::interface), 1);
  for (const GraphNode& node : graph.nodes) EXPECT_TRUE(node.kind != NodeKind::interface || node.valence == 4);
  EXPECT_EQ(graph::Subdivision(graph).num_faces(), 4);
  EXPECT_EQ(index_sum_of(graph), 4);
}

TEST(JoinLayouts, NodesWithin1e8DiametersAreOne) {
  const SeparatrixGraph graph = joined({{{0.3, 0.3}}, {{0.3 + 1e-8, 0.3}}});
  EXPECT_EQ(num_of_kind(graph, NodeKind::interface), 1);
  EXPECT_TRUE(graph.t_junctions.empty());
}

TEST(JoinLayouts, ALineThatEndsAloneEndsInATJunction) {
  const SeparatrixGraph graph = joined({{{0.3, 0.3}}, {{0.5, 0.5}}});
  EXPECT_EQ(num_of_kind(graph, NodeKind::interface), 2);
  EXPECT_EQ(graph.t_junctions.size(), 2U);
}

TEST(JoinLayouts, TheInterfaceIsThereOnceOnItsLowerCurve) {
  const SeparatrixGraph graph = joined({{{0.3, 0.3}}, {{0.5, 0.5}}});
  double length = 0;
  for (const GraphArc& arc : graph.arcs) {
    if (!is_on_interface(graph, arc)) continue;
    EXPECT_EQ(arc.pieces.front().curve, 1);
    length += arc.pieces.front().t1 - arc.pieces.front().t0;
  }
  EXPECT_NEAR(length, 1, 1e-12);
}

TEST(JoinLayouts, TheCertificateIsThatOfAllRegions) {
  Rectangles two({{{0.3, 0.3}}, {{0.3, 0.3}}});
  two.layouts.layouts[0].certificate.method = LayoutMethod::traced;
  two.layouts.layouts[1].certificate.method = LayoutMethod::quantized;
  two.layouts.layouts[1].certificate.reason = "spirals";
  two.layouts.layouts[0].certificate.merged_lines = 2;
  two.layouts.layouts[1].certificate.merged_lines = 3;
  two.layouts.layouts[0].certificate.largest_deviation_degrees = 7;
  const LayoutCertificate whole = join_layouts(two.layouts).certificate;
  EXPECT_EQ(whole.method, LayoutMethod::quantized);
  EXPECT_EQ(whole.reason, "spirals");
  EXPECT_EQ(whole.merged_lines, 5);
  EXPECT_EQ(whole.largest_deviation_degrees, 7);
}

TEST(CloseLines, MovesTheEndsOfSplinesToTheNodes) {
  SeparatrixGraph graph = joined({{{0.3, 0.3}}, {{0.3, 0.3}}});
  for (GraphNode& node : graph.nodes)
    if (node.kind == NodeKind::interface) node.position = {1, 0.31};
  close_lines(graph);
  for (const Nurbs& spline : graph.splines) {
    const bool is_closed = spline.poles.front() == Vec2{1, 0.31} || spline.poles.back() == Vec2{1, 0.31};
    EXPECT_TRUE(is_closed);
  }
}

}  // namespace
}  // namespace quadrille::couple
