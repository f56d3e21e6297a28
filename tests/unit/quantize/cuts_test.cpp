#include "quantize/cuts.hpp"

#include <gtest/gtest.h>

#include "../hand_made.hpp"
#include "base/angle.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::quantize {
namespace {

std::vector<Nurbs> rectangle(Vec2 low, Vec2 high) {
  const std::vector<Vec2> p{low, {high.x, low.y}, high, {low.x, high.y}};
  return {curve::segment(p[0], p[1]), curve::segment(p[1], p[2]), curve::segment(p[2], p[3]),
          curve::segment(p[3], p[0])};
}

// A square with two square holes, their curves 4 to 7 and 8 to 11.
CadFace face_with_holes() {
  return hand_made::face({rectangle({0, 0}, {10, 10}), rectangle({1, 1}, {2, 2}), rectangle({5, 5}, {6, 6})}, 14);
}

GraphNode on_curve(int curve) { return {{}, NodeKind::boundary, 2, curve, 0}; }

TEST(UnconnectedLoops, AreThoseThatNoArcsReach) {
  SeparatrixGraph graph;
  graph.face = face_with_holes();
  graph.nodes = {on_curve(0), on_curve(4), on_curve(8)};
  EXPECT_EQ(unconnected_loops(graph), (std::vector<int>{1, 2}));
  graph.arcs = {{1, 2, false, 0, {}}};  // the holes to each other
  EXPECT_EQ(unconnected_loops(graph), (std::vector<int>{1, 2}));
  graph.arcs.push_back({2, 0, false, 0, {}});
  EXPECT_TRUE(unconnected_loops(graph).empty());
}

TEST(CutFromLoop, StartsAtTheMiddleOfTheFirstCurveThenElsewhere) {
  const CadFace face = face_with_holes();
  const CutStart first = cut_from_loop(face, 1, 0);
  EXPECT_EQ(first.curve, 4);
  EXPECT_NEAR(first.t, (face.curves[4].begin() + face.curves[4].end()) / 2, 1e-15);
  // Half a loop farther, then a quarter and three quarters.
  EXPECT_EQ(cut_from_loop(face, 1, 1).curve, 6);
  EXPECT_EQ(cut_from_loop(face, 1, 2).curve, 5);
  EXPECT_EQ(cut_from_loop(face, 1, 3).curve, 7);
  EXPECT_EQ(cut_from_loop(face, 2, 1).curve, 10);
}

TEST(CutFromLoop, NeverStartsTwiceAtOnePoint) {
  const CadFace face = face_with_holes();
  for (int a = 0; a < 32; ++a)
    for (int b = 0; b < a; ++b) {
      const CutStart p = cut_from_loop(face, 2, a), q = cut_from_loop(face, 2, b);
      EXPECT_FALSE(p.curve == q.curve && p.t == q.t) << a << " " << b;
    }
}

}  // namespace
}  // namespace quadrille::quantize
