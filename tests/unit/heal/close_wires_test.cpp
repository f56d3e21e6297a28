#include "heal/close_wires.hpp"

#include <gtest/gtest.h>

#include "../support/texts.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"
#include "raw_samples.hpp"

namespace quadrille::heal {
namespace {

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
