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

TEST(WallClearance, CurvesOfSeveralWallsHaveTheGreatestClearance) {
  const CadFace face = make_face({circle({0, 0}, 2), hole({0, 0}, 1)});
  EXPECT_EQ(clearance_of_curves(face, {{{0}, 0.2}, {{0, 1}, 0.1}}), (std::vector<double>{0.2, 0.1}));
  EXPECT_EQ(clearance_of_curves(face, {{{1}, 0.3}}), (std::vector<double>{0, 0.3}));
}

}  // namespace
}  // namespace quadrille::placement
