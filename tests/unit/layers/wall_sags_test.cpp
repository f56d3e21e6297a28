#include "layers/wall_sags.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../hand_made.hpp"
#include "block/extract_blocks.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::layers {
namespace {

/// The unit square, cut at x = 1/2, with a wall along the left part of its lower side alone.
struct CutSquare {
  BlockLayout layout;
  std::vector<WallSpec> walls;

  CutSquare() {
    SeparatrixGraph g;
    g.face = hand_made::face(
        {{curve::segment({0, 0}, {0.5, 0}), curve::segment({0.5, 0}, {1, 0}), curve::segment({1, 0}, {1, 1}),
          curve::segment({1, 1}, {0, 1}), curve::segment({0, 1}, {0, 0})}},
        std::sqrt(2.0));
    g.face.joints[1].is_corner = false;
    hand_made::give_name(g.face, 0, "wall");
    for (const int joint : {0, 2, 3, 4}) hand_made::add_joint_node(g, joint);
    const int low = hand_made::add_boundary_node(g, 1, 0), high = hand_made::add_boundary_node(g, 3, 0.5);
    hand_made::add_arc(g, 0, low, true, {hand_made::whole(g, 0)});
    hand_made::add_arc(g, low, 1, true, {hand_made::whole(g, 1)});
    hand_made::add_arc(g, 1, 2, true, {hand_made::whole(g, 2)});
    hand_made::add_arc(g, 2, high, true, {{3, 0, 0.5}});
    hand_made::add_arc(g, high, 3, true, {{3, 0.5, 1}});
    hand_made::add_arc(g, 3, 0, true, {hand_made::whole(g, 4)});
    hand_made::add_cut(g, low, high);
    layout = block::extract_blocks(g);
    walls.emplace_back();
    walls[0].names = {"wall"};
    walls[0].first = 0.03;
    walls[0].layers = 2;
  }
};

TEST(WallSags, LimitsAlsoHoldWhereLayersGoOnBesideTheWall) {
  const CutSquare square;
  std::vector<Vec2> starts;
  for (const sizing::SagLimit& limit : wall_sags(sizing::MeasuredLayout(square.layout), square.walls, 1.0 / 3)) {
    EXPECT_NEAR(limit.sag, 0.01, 1e-15);
    starts.push_back(curve::point(limit.curve, limit.curve.begin()));
  }
  std::ranges::sort(starts, {}, &Vec2::x);
  ASSERT_EQ(starts.size(), 2U) << "the wall and its continuation, not the upper side";
  EXPECT_EQ(starts[0], (Vec2{0, 0}));
  EXPECT_EQ(starts[1], (Vec2{0.5, 0}));
}

}  // namespace
}  // namespace quadrille::layers
