#include "graph/open_interfaces.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../regions/faces_of_regions.hpp"
#include "../support/region_graphs.hpp"
#include "base/error.hpp"
#include "check/check.hpp"
#include "graph/subdivision.hpp"
#include "model/interfaces.hpp"

namespace quadrille::graph {
namespace {

using namespace testing_faces;

CadFace walled_squares() {
  CadFace face = face_of_regions({rectangle({0, 0}, {1, 1}), rectangle({1, 0}, {2, 1})});
  face.curve_names[1] = face.curve_names[7] = "wall";
  face.unnamed_curves = {0, 2, 3, 4, 5, 6};
  return face;
}

TEST(OpenCurves, BothSidesLoseTheirPartners) {
  const CadFace face = with_open_curves(walled_squares(), {"wall"}, "--open");
  for (int c = 0; c < face.num_curves(); ++c) EXPECT_FALSE(face.is_interface(c));
  EXPECT_TRUE(with_open_curves(walled_squares(), {}, "--open").is_interface(1));
}

TEST(OpenCurves, ABoundaryCannotBeOpened) {
  EXPECT_THROW(with_open_curves(walled_squares(), {"curve_0"}, "--open"), UsageError);
  EXPECT_THROW(with_open_curves(walled_squares(), {"nowhere"}, "--open"), UsageError);
}

TEST(OpenCurves, NonconformingInterfacesAreNamed) {
  EXPECT_EQ(nonconforming_interfaces({"wall=nonconforming", "a=b=nonconforming"}),
            (std::vector<std::string>{"wall", "a=b"}));
  for (const char* option : {"wall", "=nonconforming", "wall=conforming"})
    EXPECT_THROW(nonconforming_interfaces({option}), UsageError) << option;
}

using region_graphs::disc_in_square, region_graphs::slit_plate, region_graphs::two_squares;

SeparatrixGraph opened(SeparatrixGraph graph) {
  std::vector<bool> is_open(graph.face.curves.size());
  for (int c = 0; c < graph.face.num_curves(); ++c) is_open[c] = graph.face.is_interface(c);
  open_interfaces(graph, is_open);
  return graph;
}

std::string faults(const SeparatrixGraph& graph) {
  std::string all;
  for (const check::Violation& v : check::check_stage(graph, check::CheckDepth::full))
    all += v.rule + ": " + v.text + "\n";
  return all;
}

TEST(OpenInterfaces, ACrackHasDoubledNodesButForItsTips) {
  const SeparatrixGraph graph = opened(slit_plate(false)), by_hand = slit_plate(true);
  EXPECT_EQ(faults(graph), "");
  EXPECT_EQ(graph.nodes.size(), by_hand.nodes.size());
  EXPECT_EQ(graph.arcs.size(), by_hand.arcs.size());
  EXPECT_EQ(index_sum_of(graph), 0);
  EXPECT_EQ(euler_characteristic_of_whole(graph), 0);
  const auto num_at = [&](Vec2 x) {
    return std::count_if(graph.nodes.begin(), graph.nodes.end(), [&](const GraphNode& n) { return n.position == x; });
  };
  EXPECT_EQ(num_at({2, 1}), 2);
  EXPECT_EQ(num_at({1, 1}), 1);
  EXPECT_EQ(num_at({3, 1}), 1);
  const Subdivision subdivision(graph);
  EXPECT_EQ(subdivision.num_faces(), 8);
  for (int f = 0; f < 8; ++f) EXPECT_EQ(subdivision.num_corners(f), 4);
}

TEST(OpenInterfaces, ArcsMayRunAgainstTheirCurve) {
  SeparatrixGraph graph = slit_plate(false);
  for (GraphArc& arc : graph.arcs)
    if (is_on_interface(graph, arc)) {
      std::swap(arc.from, arc.to);
      std::swap(arc.pieces[0].t0, arc.pieces[0].t1);
    }
  EXPECT_EQ(faults(opened(graph)), "");
}

TEST(OpenInterfaces, ASlitFromTheBoundaryDividesItsNodeThereToo) {
  const SeparatrixGraph graph = opened(two_squares());
  EXPECT_EQ(faults(graph), "");
  EXPECT_EQ(graph.nodes.size(), 8u) << "two squares of their own";
  EXPECT_EQ(graph.arcs.size(), 8u);
  for (const GraphNode& node : graph.nodes) {
    EXPECT_EQ(node.kind, NodeKind::corner);
    EXPECT_EQ(node.valence, 1);
  }
}

TEST(OpenInterfaces, AClosedInterfaceDividesThePlane) {
  SeparatrixGraph graph = disc_in_square();
  // A line from a corner of the square through the circle to an irregular node.
  const auto arc_between = [&](int a, int b) {
    for (int i = 0; i < static_cast<int>(graph.arcs.size()); ++i)
      if (graph.arcs[i].from == a && graph.arcs[i].to == b) return i;
    return -1;
  };
  graph.lines = {{0, 8, LineKind::traced, {arc_between(0, 4), arc_between(4, 8)}}};
  graph.certificate.method = LayoutMethod::quantized;
  graph.certificate.index_sum = 4;
  graph.certificate.face_valence_histogram = {{4, 9}};
  const SeparatrixGraph open = opened(graph);
  EXPECT_EQ(faults(open), "");
  EXPECT_EQ(open.nodes.size(), graph.nodes.size() + 4);
  ASSERT_EQ(open.lines.size(), 2u);
  EXPECT_EQ(open.lines[0].origin, 0);
  EXPECT_EQ(open.lines[1].end, 8);
  EXPECT_NE(open.lines[0].end, open.lines[1].origin);
  EXPECT_EQ(open.nodes[open.lines[0].end].position, open.nodes[open.lines[1].origin].position);
}

TEST(OpenInterfaces, OthersStayClosed) {
  SeparatrixGraph graph = slit_plate(false);
  open_interfaces(graph, std::vector<bool>(6, false));
  EXPECT_EQ(graph.nodes.size(), slit_plate(false).nodes.size());
  EXPECT_EQ(faults(graph), "");
}

}  // namespace
}  // namespace quadrille::graph
