#include "heal/wire_edges.hpp"

#include <gtest/gtest.h>

#include "../support/texts.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"
#include "raw_samples.hpp"

namespace quadrille::heal {

namespace {

std::vector<bool> removed(const std::vector<Vec2>& polygon, double length) {
  const RawFace raw = raw_polygon(polygon);
  return short_edges(measured(raw.wires)[0], length, JointLimit(raw.wires, 2 * length));
}

TEST(ShortEdges, AShortChamferIsRemoved) {
  const std::vector<Vec2> plate{{0, 0}, {3.99, 0}, {4, 0.01}, {4, 4}, {0, 4}};
  EXPECT_EQ(removed(plate, 0.02), (std::vector<bool>{false, true, false, false, false}));
  EXPECT_EQ(removed(plate, 0.01), std::vector<bool>(5, false));
}

TEST(ShortEdges, AChainCountsTheSumOfItsLengths) {
  const std::vector<Vec2> arc{{0, 0}, {3.99, 0}, {3.996, 0.003}, {4, 0.01}, {4, 4}, {0, 4}};
  EXPECT_EQ(removed(arc, 0.02), (std::vector<bool>{false, true, true, false, false, false}));
  EXPECT_EQ(removed(arc, 0.012), std::vector<bool>(6, false));
}

TEST(ShortEdges, AnEdgeBetweenParallelsThatCannotBeJoinedStays) {
  // A step of 0.02: the short lines beside it may move by 0.005 only.
  const std::vector<Vec2> step{{0, 0},    {4, 0},       {4, 3},    {2.1, 3}, {2.1, 4},
                               {2.05, 4}, {2.05, 3.98}, {2, 3.98}, {2, 3},   {0, 3}};
  EXPECT_EQ(removed(step, 0.02), std::vector<bool>(10, false));
}

TEST(ShortEdges, AWireIsNeverRemoved) {
  EXPECT_EQ(removed({{0, 0}, {0.01, 0}, {0, 0.01}}, 0.1), std::vector<bool>(3, false));
}

std::vector<int> order(const std::vector<RawEdge>& edges, double near, double tol) {
  std::vector<const RawEdge*> pointers;
  for (const RawEdge& edge : edges) pointers.push_back(&edge);
  std::vector<int> numbers;
  for (const RawEdge* edge : chain_edges(pointers, near, tol, "f.step")) numbers.push_back(edge->cad_edge);
  return numbers;
}

// A square whose corners are 0.01 apart at edge 2.
std::vector<RawEdge> shuffled() {
  return {raw_edge(curve::segment({0, 0}, {1, 0}), 0), raw_edge(curve::segment({1.01, 1}, {0, 1}), 2),
          raw_edge(curve::segment({1, 0}, {1, 1}), 1), raw_edge(curve::segment({0, 1}, {0, 0}), 3)};
}

TEST(ChainEdges, TakesTheNearestEdgeWithinTheTolerance) {
  EXPECT_EQ(order(shuffled(), 1e-7, 0.02), (std::vector<int>{0, 1, 2, 3}));
}

TEST(ChainEdges, RefusesWiderGaps) {
  EXPECT_THROW(order(shuffled(), 1e-7, 0.005), FormatError);
  EXPECT_THROW(order({shuffled()[0], shuffled()[2]}, 1e-7, 0.02), FormatError);
}

TEST(ChainEdges, ACommonVertexConnectsEdgesThatDoNotReachIt) {
  std::vector<RawEdge> edges = shuffled();
  edges[2].end = edges[1].start = {1, 1.005};
  EXPECT_EQ(order(edges, 1e-7, 1e-6), (std::vector<int>{0, 1, 2, 3}));
}

HealScale scale(double tolerance) {
  HealScale scale;
  scale.file = "f.step";
  scale.tolerance = tolerance;
  return scale;
}

RawEdge line(Vec2 a, Vec2 b, int number) { return raw_edge(curve::segment(a, b), number); }

/// A square, its sides in no order and two of them backwards, and a circle in it.
RawFace square(double gap = 0) {
  RawFace raw;
  raw.wires = {{line({0, 0}, {1, 0}, 0), line({0, 1}, {1, 1}, 1),
                raw_edge(curve::circular_arc({0.5, 0.5}, 0.2, 0, 2 * pi), 2), line({1 + gap, 1}, {1, 0}, 3),
                line({0, 1}, {0, 0}, 4)}};
  return raw;
}

std::string refusal(RawFace raw, double tolerance) {
  return message_of<FormatError>([&] { close_wires(raw, scale(tolerance)); });
}

TEST(CloseWires, AnyOrderAndDirection) {
  RawFace raw = square();
  close_wires(raw, scale(1e-6));
  ASSERT_EQ(raw.wires.size(), 2U);
  std::vector<int> numbers;
  for (size_t i = 0; i < 4; ++i) {
    const RawEdge &edge = raw.wires[0].at(i), &next = raw.wires[0].at((i + 1) % 4);
    numbers.push_back(edge.cad_edge);
    EXPECT_EQ(edge.end, next.start);
    EXPECT_EQ(edge.curve.poles.front(), edge.start);
    EXPECT_EQ(edge.curve.poles.back(), edge.end);
  }
  EXPECT_EQ(numbers, (std::vector<int>{0, 3, 1, 4}));
  EXPECT_EQ(raw.wires[1].size(), 1U) << "the circle closes by itself";
}

TEST(CloseWires, GapsWithinTheToleranceAreClosed) {
  RawFace raw = square(1e-4);
  close_wires(raw, scale(1e-4));
  EXPECT_EQ(raw.wires.size(), 2U);
}

TEST(CloseWires, TheNarrowestGapIsNamed) {
  EXPECT_EQ(refusal(square(1e-3), 1e-5),
            "f.step: the file holds no face, and its curves leave 1 gap: edge 1 ends at (1, 1), 0.001 from edge 3 at "
            "(1.001, 1) (0.001 diameters; the tolerance is 1e-05): give --heal-tolerance 0.001");
  RawFace two = square(1e-3);
  two.wires[0].pop_back();
  expect_contains(refusal(two, 1e-5), "leave 2 gaps: edge 1 ends at (1, 1)");
  RawFace arc;
  arc.wires = {{line({0, 0}, {1, 0}, 7)}};
  expect_contains(refusal(arc, 1e-5), "edge 7 ends at (0, 0), 1 from edge 7 at (1, 0)");
}

TEST(CloseWires, BranchesAreRefused) {
  RawFace raw = square();
  raw.wires[0].push_back(line({1, 1}, {2, 2}, 5));
  expect_contains(refusal(raw, 1e-5), "its curves bound none: 3 curves end at (1, 1), such as edges 1 and 3");
}

}  // namespace

}  // namespace quadrille::heal
