#include "quantize/quantized_parametrization.hpp"

#include <gtest/gtest.h>

#include "../support/square_t_mesh.hpp"
#include "curve/chain.hpp"

namespace quadrille::quantize {
namespace {

std::vector<double> arc_lengths(const SeparatrixGraph& graph) {
  const curve::CurveTable table(graph.face, graph.splines);
  std::vector<double> lengths;
  for (const GraphArc& arc : graph.arcs) lengths.push_back(curve::Chain(table, arc.pieces).length());
  return lengths;
}

// The square with a line at x = 0.3 and one at y = 0.4 that stops there. Side x = 0 has length two, all other arcs one.
struct OneT : testing::Test {
  SeparatrixGraph graph = square_t_mesh::make(square_t_mesh::one_t);
  std::vector<TFace> faces = t_mesh_faces(graph::Subdivision(graph));
  std::vector<int> lengths = square_t_mesh::lengths_of_one_t(graph, faces);
  QuantizedParametrization parametrization{graph, faces, lengths, arc_lengths(graph)};
};

TEST_F(OneT, SidesAreNumberLines) {
  const IntegerSides& sides = parametrization.sides();
  for (int f = 0; f < static_cast<int>(faces.size()); ++f)
    for (int side = 0; side < 4; ++side) {
      EXPECT_EQ(sides.total(f, side), sides.total(f, (side + 2) % 4));
      int position = 0;
      for (const HalfEdge h : faces[f][side]) {
        EXPECT_EQ(sides.position_of(h).offset, position);
        EXPECT_EQ(sides.half_edge_at(f, side, position + 1).first, h);
        position += lengths[h.arc];
      }
      EXPECT_EQ(position, sides.total(f, side));
    }
}

TEST_F(OneT, TheStoppedLineContinuesThroughOneFaceToTheBoundary) {
  int num_lines = 0, num_crossings = 0;
  for (const auto& face : parametrization.lines().lines) num_lines += static_cast<int>(face[0].size() + face[1].size());
  EXPECT_EQ(num_lines, 1);
  for (size_t a = 0; a < graph.arcs.size(); ++a)
    for (const int number : parametrization.lines().crossings[a]) {
      ++num_crossings;
      EXPECT_EQ(number, 1);
      EXPECT_EQ(lengths[a], 2);
      EXPECT_TRUE(graph.arcs[a].is_boundary);
    }
  EXPECT_EQ(num_crossings, 1);
}

TEST_F(OneT, TheCrossingMovesToTheHeightOfTheStoppedLine) {
  // The boundary runs down the left side: y = 0.4 is at 0.6 of it.
  for (const auto& arc : parametrization.crossing_fractions())
    for (const auto& [number, fraction] : arc) EXPECT_NEAR(fraction, 0.6, 1e-9);
}

TEST_F(OneT, FractionsOfASideAreThoseOfTheLengthsInThePlane) {
  for (int f = 0; f < static_cast<int>(faces.size()); ++f)
    for (int side = 0; side < 4; ++side)
      EXPECT_NEAR(parametrization.side_fraction(f, side, parametrization.sides().total(f, side)), 1, 1e-14);
}

}  // namespace
}  // namespace quadrille::quantize
