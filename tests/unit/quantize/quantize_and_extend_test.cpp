#include "quantize/quantize_and_extend.hpp"

#include <gtest/gtest.h>

#include "../support/square_t_mesh.hpp"
#include "base/error.hpp"
#include "curve/chain.hpp"
#include "graph/divide_at_point.hpp"
#include "graph/face_corners.hpp"

namespace quadrille::quantize {
namespace {

graph::CandidateLayout never(const InfeasibleTMesh&) { throw ComputeError("no lengths"); }

/// Divides a side of the square at a parameter.
void divide(graph::CandidateLayout& layout, int curve, double t) {
  const ArcGraph& graph = layout.graph();
  for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a) {
    const ArcPiece& piece = graph.arcs[a].pieces.front();
    if (piece.curve != curve || t <= piece.t0 || t >= piece.t1) continue;
    const Nurbs& side = graph.face.curves[curve];
    graph::divide_at_point(layout.subdivision, {a}, {curve::point(side, t), curve::tangent(side, t), 0, t});
    return;
  }
}

/// A line across the square, whose left and right sides are periodic, from one height to another, with the images of
/// its ends.
graph::CandidateLayout slanted(double left, double right) {
  SeparatrixGraph graph = square_t_mesh::make({{{0, left}, {1, right}, 3, 1}});
  graph.face.periodic_pairs = {{{3, 1}, 0, {1, 0}}};
  graph::CandidateLayout layout = graph::candidate_layout(std::move(graph));
  if (left == right) return layout;
  divide(layout, 1, left);
  divide(layout, 3, 1 - right);
  return layout;
}

TEST(QuantizeAndExtend, ALineContinuesToTheBoundary) {
  const graph::CandidateLayout t_mesh = graph::candidate_layout(square_t_mesh::make(square_t_mesh::one_t));
  const ExtendedTMesh extended = quantize_and_extend(t_mesh, PeriodicSides::separate, never, nullptr);
  EXPECT_TRUE(extended.layout.t_junctions.empty());
  EXPECT_EQ(graph::require_four_corners(extended.layout.subdivision), 4);
  EXPECT_EQ(extended.longest_arc, 7) << "a tenth of the diameter is one: a side is 1 / 0.1414 long";
}

TEST(QuantizeAndExtend, ATMeshWithoutLengthsIsReplaced) {
  int num_replaced = 0;
  const auto replace = [&](const InfeasibleTMesh& failed) {
    ++num_replaced;
    EXPECT_FALSE(failed.strips.empty());
    EXPECT_FALSE(failed.zero_arcs().empty());
    EXPECT_EQ(failed.t_mesh.graph().nodes.size(), 8U);
    return slanted(0.5, 0.5);
  };
  const ExtendedTMesh extended = quantize_and_extend(slanted(0.2, 0.8), PeriodicSides::glued, replace, nullptr);
  EXPECT_EQ(num_replaced, 1);
  EXPECT_EQ(graph::require_four_corners(extended.layout.subdivision), 2);
}

TEST(QuantizeAndExtend, SeparateSidesAreBoundariesLikeOthers) {
  const ExtendedTMesh extended = quantize_and_extend(slanted(0.2, 0.8), PeriodicSides::separate, never, nullptr);
  EXPECT_TRUE(extended.layout.t_junctions.empty());
}

}  // namespace
}  // namespace quadrille::quantize
