#include "couple/continuations.hpp"

#include <gtest/gtest.h>

#include "rectangles.hpp"

namespace quadrille::couple {
namespace {

bool always(const graph::Subdivision&, const BoundaryPoint&) { return true; }

double height(const CadFace& face, const BoundaryPoint& point) { return point.position(face).y; }

TEST(Continuations, ALineThatEndsAloneIsTracedThroughTheNeighbour) {
  const Rectangles two({{{0.3, 0.3}}, {}});
  const std::vector<Continuation> found = continuations(two.layouts, CutEnds::included, always);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].region, 1);
  EXPECT_EQ(found[0].start.curve, 3) << "of the region: its left side";
  ASSERT_TRUE(found[0].line && found[0].line->ends_on_boundary);
  EXPECT_EQ(found[0].line->end.curve, 1);
  EXPECT_NEAR(height(two.graph(1).face, found[0].line->end), 0.3, 1e-7);
  EXPECT_NEAR(found[0].line->spline.end(), 1, 1e-7) << "by its length";
}

TEST(Continuations, LinesThatMeetNeedNone) {
  const Rectangles two({{{0.3, 0.3}}, {{0.3, 0.3}}});
  EXPECT_TRUE(continuations(two.layouts, CutEnds::included, always).empty());
}

TEST(Continuations, ThoseThatCannotBeInsertedAreLeftOut) {
  const Rectangles two({{{0.3, 0.3}}, {}});
  const auto never = [](const graph::Subdivision&, const BoundaryPoint&) { return false; };
  EXPECT_TRUE(continuations(two.layouts, CutEnds::included, never).empty());
}

TEST(Continuations, OppositeLinesThatAreNearMerge) {
  const Rectangles three({{{0.3, 0.3}}, {}, {{0.36, 0.36}}});
  const std::vector<Continuation> found = continuations(three.layouts, CutEnds::included, always);
  ASSERT_EQ(found.size(), 2U);
  ASSERT_TRUE(found[0].line);
  EXPECT_EQ(found[0].line->end, found[1].start);
  EXPECT_FALSE(found[1].line);
}

TEST(Continuations, OppositeLinesThatAreFarStayTwo) {
  const Rectangles three({{{0.3, 0.3}}, {}, {{0.5, 0.5}}});
  const std::vector<Continuation> found = continuations(three.layouts, CutEnds::included, always);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_TRUE(found[0].line && found[1].line);
}

}  // namespace
}  // namespace quadrille::couple
