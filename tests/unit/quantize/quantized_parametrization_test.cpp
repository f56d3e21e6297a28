#include "quantize/quantized_parametrization.hpp"

#include <gtest/gtest.h>

#include "../support/square_t_mesh.hpp"
#include "base/error.hpp"
#include "curve/chain.hpp"
#include "t_faces.hpp"

namespace quadrille::quantize {
namespace {

// Face 0 is left of face 1 and of face 2 above it: arcs 0 and 1 lie between them, the second one directed downwards.
const std::vector<TFace> three_faces{face({{{2}, {0, -2}, {3}, {4}}}), face({{{5}, {6}, {7}, {-1}}}),
                                     face({{{-8}, {8}, {9}, {1}}})};
const std::vector<int> arc_lengths_of_three{2, 3, 1, 1, 5, 4, 2, 4, 3, 4};

struct Sides : testing::Test {
  IntegerSides sides{three_faces, arc_lengths_of_three};
};

TEST_F(Sides, HalfEdgesStartWhereThoseBeforeThemEnd) {
  const auto expect_at = [&](HalfEdge h, int face, int side, int offset) {
    const SidePosition& at = sides.position_of(h);
    EXPECT_EQ(at.face, face);
    EXPECT_EQ(at.side, side);
    EXPECT_EQ(at.offset, offset);
  };
  expect_at({0}, 0, 1, 0);
  expect_at({1, true}, 0, 1, 2);
  expect_at({0, true}, 1, 3, 0);
  expect_at({1}, 2, 3, 0);
}

TEST_F(Sides, ABoundaryArcHasNoFaceBehindIt) {
  EXPECT_EQ(sides.position_of({2}).face, 0);
  EXPECT_EQ(sides.position_of({2, true}).face, -1);
}

TEST_F(Sides, TotalsAreSumsOfTheLengths) {
  EXPECT_EQ(sides.total(0, 1), 5);
  EXPECT_EQ(sides.total(0, 3), 5);
  EXPECT_EQ(sides.total(0, 0), 1);
  EXPECT_EQ(sides.arc(5), 4);
}

TEST_F(Sides, APositionAtANodeBelongsToTheHalfEdgeThatEndsThere) {
  const auto at = [&](int position) { return sides.half_edge_at(0, 1, position); };
  EXPECT_EQ(at(1), (std::pair{HalfEdge{0}, 1}));
  EXPECT_EQ(at(2), (std::pair{HalfEdge{0}, 2}));
  EXPECT_EQ(at(3), (std::pair{HalfEdge{1, true}, 1}));
  EXPECT_EQ(at(5), (std::pair{HalfEdge{1, true}, 3}));
  EXPECT_THROW(at(6), Defect);
}

using Numbers = std::set<int>;

ArcGraph arcs(int num, const std::set<int>& inner) {
  ArcGraph graph;
  graph.arcs.resize(num);
  for (int a = 0; a < num; ++a) graph.arcs[a].is_boundary = !inner.contains(a);
  return graph;
}

int num_lines(const IsoLines& lines) {
  std::size_t sum = 0;
  for (const auto& of_face : lines.lines) sum += of_face[0].size() + of_face[1].size();
  return static_cast<int>(sum);
}

TEST(IsoLines, WithoutTJunctionsThereAreNone) {
  const std::vector<TFace> faces{face({{{0}, {1}, {2}, {3}}})};
  const std::vector<int> lengths{3, 2, 3, 2};
  const IsoLines lines = iso_lines(arcs(4, {}), IntegerSides(faces, lengths));
  EXPECT_EQ(num_lines(lines), 0);
  for (const Numbers& crossings : lines.crossings) EXPECT_TRUE(crossings.empty());
}

// Face 0 lies left of face 1 and of face 2 above it; the line between these, arc 5, stops at face 0.
const std::vector<TFace> one_t{face({{{2}, {0, 1}, {3}, {4}}}), face({{{6}, {7}, {-6}, {-1}}}),
                               face({{{5}, {8}, {9}, {-2}}})};

TEST(IsoLines, ALineContinuesToTheOppositeSideOfItsFace) {
  const std::vector<int> lengths{1, 2, 4, 4, 3, 5, 5, 1, 2, 5};
  const IsoLines lines = iso_lines(arcs(10, {0, 1, 5}), IntegerSides(one_t, lengths));
  EXPECT_EQ(num_lines(lines), 1);
  EXPECT_EQ(lines.lines[0][1], Numbers{1});   // from side 1, one above its begin
  EXPECT_EQ(lines.crossings[4], Numbers{2});  // counted downwards
  for (const int a : {0, 1, 2, 3, 5, 6, 7, 8, 9}) EXPECT_TRUE(lines.crossings[a].empty()) << a;
}

TEST(IsoLines, PointsAreNumberedInTheDirectionOfTheirArc) {
  std::vector<TFace> upwards = one_t;
  upwards[0][3] = {HalfEdge{4, true}};
  const std::vector<int> lengths{1, 2, 4, 4, 3, 5, 5, 1, 2, 5};
  EXPECT_EQ(iso_lines(arcs(10, {0, 1, 5}), IntegerSides(upwards, lengths)).crossings[4], Numbers{1});
}

// A face with two faces on its left (arc 10 between them) and two on its right (arc 11): arcs 0, 1 and 2, 3 from below.
const std::vector<TFace> two_ts{face({{{4}, {2, 3}, {5}, {-2, -1}}}), face({{{12}, {0}, {10}, {13}}}),
                                face({{{-11}, {1}, {14}, {15}}}), face({{{16}, {17}, {11}, {-3}}}),
                                face({{{-12}, {18}, {19}, {-4}}})};
const std::set<int> inner_of_two_ts{0, 1, 2, 3, 10, 11};

TEST(IsoLines, TJunctionsThatFaceEachOtherAreOneLine) {
  std::vector<int> lengths(20, 1);
  lengths[4] = lengths[5] = 7;
  const IsoLines lines = iso_lines(arcs(20, inner_of_two_ts), IntegerSides(two_ts, lengths));
  EXPECT_EQ(num_lines(lines), 1);
  EXPECT_EQ(lines.lines[0][1], Numbers{1});
  for (const Numbers& crossings : lines.crossings) EXPECT_TRUE(crossings.empty());
}

TEST(IsoLines, ALineThatMissesATJunctionContinuesBehindTheArc) {
  // The left T-junction is at 1 of 3, the right one at 2.
  std::vector<int> lengths(20, 1);
  lengths[1] = lengths[15] = lengths[2] = lengths[17] = 2;
  const IsoLines lines = iso_lines(arcs(20, inner_of_two_ts), IntegerSides(two_ts, lengths));
  EXPECT_EQ(lines.lines[0][1], (Numbers{1, 2}));
  EXPECT_EQ(lines.crossings[2], Numbers{1});   // the left one's line, on the lower of two arcs
  EXPECT_EQ(lines.crossings[17], Numbers{1});  // and through the face behind it, to the boundary
  EXPECT_EQ(lines.crossings[1], Numbers{1});
  EXPECT_EQ(lines.crossings[15], Numbers{1});
  EXPECT_EQ(num_lines(lines), 4);
}

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
