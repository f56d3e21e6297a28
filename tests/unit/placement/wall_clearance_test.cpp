#include "placement/wall_clearance.hpp"

#include <gtest/gtest.h>

#include "../triangulate/faces.hpp"
#include "base/error.hpp"

namespace quadrille::placement {
namespace {

using namespace testing_faces;

TEST(WallClearance, ReadsNameAndLength) {
  const NamedClearance wall = parse_clearance("a=b=0.5");
  EXPECT_EQ(wall.name, "a=b");
  EXPECT_EQ(wall.clearance, 0.5);
  for (const char* text : {"wall", "=1", "wall=", "wall=0", "wall=-1", "wall=x", "wall=1x", "wall=inf"})
    EXPECT_THROW(parse_clearance(text), UsageError) << text;
}

TEST(WallClearance, UnknownNamesAreRefused) {
  const CadFace disc = make_face({circle({0, 0}, 1)});
  EXPECT_THROW(wall_clearances(disc, {{"roof", 1}}), UsageError);
  EXPECT_EQ(wall_clearances(disc, {{"0", 0.25}}).at(0).curves, std::vector<int>{0});
}

TEST(WallClearance, TheTermEndsAtItsReachAndHasItsGradient) {
  const CadFace disc = make_face({circle({0, 0}, 1)});
  const WallClearance wall{{0}, 0.2};
  Vec2 gradient;
  EXPECT_EQ(clearance_energy(disc, wall, 1, {0.69, 0}, gradient), 0);
  EXPECT_EQ(gradient, Vec2{});
  constexpr double h = 1e-6;
  Vec2 ignored;
  const double low = clearance_energy(disc, wall, 2, {0.8 - h, 0}, ignored);
  const double high = clearance_energy(disc, wall, 2, {0.8 + h, 0}, ignored);
  clearance_energy(disc, wall, 2, {0.8, 0}, gradient);
  EXPECT_NEAR(gradient.x, (high - low) / (2 * h), 1e-4);
  EXPECT_GT(gradient.x, 0) << "it falls away from the wall";
  EXPECT_NEAR(gradient.y, 0, 1e-9);
}

TEST(WallClearance, NodesNearerThanTheClearanceAreNear) {
  const CadFace disc = make_face({circle({0, 0}, 1)});
  CriticalPoints points;
  for (const double x : {0.85, 0.75, 0.5}) {
    points.critical_points.emplace_back();
    points.critical_points.back().position = {x, 0};
  }
  EXPECT_EQ(nodes_near_walls(disc, {{{0}, 0.2}}, points), (std::vector<bool>{true, false, false}));
  EXPECT_EQ(nodes_near_walls(disc, {{{0}, 0.3}}, points), (std::vector<bool>{true, true, false}));
  EXPECT_EQ(nodes_near_walls(disc, {}, points), (std::vector<bool>{false, false, false}));
}

}  // namespace
}  // namespace quadrille::placement
