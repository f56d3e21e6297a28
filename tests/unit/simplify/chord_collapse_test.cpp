#include "simplify/chord_collapse.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../support/hall.hpp"
#include "../support/square_field.hpp"
#include "graph/face_corners.hpp"

namespace quadrille::simplify {
namespace {

constexpr double step = 0.1;

struct Collapse : testing::Test {
  Field field = interpolated_field(square_mesh({-1, -2}, 6, 3), 1, [](Vec2) { return Vec2{1, 0}; });
  field::FieldEvaluator evaluator{field};
  graph::Subdivision subdivision = hall(step).subdivision;
  graph::ChordStrip strip = thin_strip_of_hall(subdivision, step);
  std::vector<graph::FixedSide> fixed = graph::fixed_sides(subdivision, strip);
  std::vector<Blend> blends = blends_of(evaluator, subdivision, strip, fixed, {1, 1e-9}).value();
};

TEST_F(Collapse, TheStripIsGoneAndEveryFaceHasFourCorners) {
  const int num_faces = subdivision.num_faces(), num_arcs = subdivision.arc_bound();
  const auto changes = collapse_strip(subdivision, strip, fixed, blends);
  ASSERT_TRUE(changes);
  subdivision.compact();
  EXPECT_EQ(subdivision.num_faces(), num_faces - strip.num_blocks());
  EXPECT_EQ(subdivision.arc_bound(), num_arcs - 3 - 2);  // three rungs, one rail of two blocks
  EXPECT_TRUE(graph::faces_without_four_corners(subdivision).empty());
  for (int n = 0; n < subdivision.node_bound(); ++n) EXPECT_TRUE(graph::is_drawn_in_order(subdivision, n));
  const graph::Subdivision built(subdivision.graph());
  for (int f = 0; f < built.face_bound(); ++f) EXPECT_EQ(subdivision.cycle(f), built.cycle(f));
}

TEST_F(Collapse, ArcsAreFollowedAndChangesMarked) {
  const ArcGraph before = subdivision.graph();
  const auto changes = collapse_strip(subdivision, strip, fixed, blends);
  ASSERT_TRUE(changes);
  for (const HalfEdge rung : strip.rungs) EXPECT_EQ(changes->now(rung.arc), -1);
  for (int b = 0; b < strip.num_blocks(); ++b)
    EXPECT_EQ(changes->now(strip.left[b].arc), changes->now(strip.right[b].arc));
  const auto same = [](const ArcPiece& p, const ArcPiece& q) {
    return p.curve == q.curve && p.t0 == q.t0 && p.t1 == q.t1;
  };
  for (std::size_t a = 0; a < before.arcs.size(); ++a) {
    const int now = changes->now(static_cast<int>(a));
    if (now < 0 || changes->changed.contains(now)) continue;
    const auto &p = before.arcs[a].pieces, &q = subdivision.graph().arcs[now].pieces;
    if (std::none_of(strip.left.begin(), strip.left.end(), [&](HalfEdge h) { return h.arc == static_cast<int>(a); }) &&
        std::none_of(strip.right.begin(), strip.right.end(),
                     [&](HalfEdge h) { return h.arc == static_cast<int>(a); })) {
      EXPECT_TRUE(std::equal(p.begin(), p.end(), q.begin(), q.end(), same)) << a;
    }
  }
}

TEST_F(Collapse, WithoutItsBlendNothingIsChanged) {
  const graph::Subdivision before = subdivision;
  EXPECT_FALSE(collapse_strip(subdivision, strip, fixed, {}));
  EXPECT_EQ(subdivision.num_faces(), before.num_faces());
  EXPECT_EQ(subdivision.graph().splines.size(), before.graph().splines.size());
  for (int f = 0; f < before.face_bound(); ++f) EXPECT_EQ(subdivision.cycle(f), before.cycle(f));
}

TEST_F(Collapse, ABlendThatDeviatesTooFarIsNone) {
  EXPECT_FALSE(blends_of(evaluator, subdivision, strip, fixed, {0.9 * deviation_of_hall(step), 1e-9}));
}

}  // namespace
}  // namespace quadrille::simplify
