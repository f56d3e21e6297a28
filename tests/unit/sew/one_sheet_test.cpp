#include "sew/one_sheet.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "regions.hpp"

namespace quadrille::sew {

namespace {

using namespace testing_regions;

TEST(RegionDistance, TheGapIsThatOfTheNearestPoints) {
  const auto regions = regions_of({{rectangle({0, 0}, {1, 1})}, {circle({2, 0.5}, 0.75)}, {rectangle({0, 0}, {1, 1})}});
  EXPECT_NEAR(gap_between(regions[0], regions[1]).size, 0.25, 1e-7);
  EXPECT_NEAR(distance(gap_between(regions[0], regions[1]).position, {1.125, 0.5}), 0, 1e-3);
  EXPECT_EQ(gap_between(regions[0], regions[2]).size, 0);
}

TEST(RegionDistance, NeighboursDoNotOverlap) {
  const auto regions = regions_of(
      {{rectangle({0, 0}, {1, 1}), hole({0.5, 0.5}, 0.2)}, {rectangle({1, 0}, {2, 1})}, {circle({0.5, 0.5}, 0.2)}});
  EXPECT_FALSE(overlap(regions[0], regions[1], 1e-9));
  EXPECT_FALSE(overlap(regions[0], regions[2], 1e-9));
}

TEST(RegionDistance, OverlapsHaveADepthAndAPlaceInBoth) {
  const auto regions =
      regions_of({{rectangle({0, 0}, {1, 1})}, {rectangle({0.75, 0.25}, {2, 0.75})}, {circle({0.5, 0.5}, 0.1)}});
  const auto found = overlap(regions[0], regions[1], 1e-9);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->size, 0.25, 0.05);
  const curve::CurveTree boundary = boundary_of(regions[0]);
  EXPECT_TRUE(boundary.winding_number(found->position) > 0 || boundary.nearest(found->position).distance < 1e-12);
  EXPECT_TRUE(overlap(regions[0], regions[2], 1e-9)) << "inside";
  EXPECT_FALSE(overlap(regions[0], regions[1], 0.5)) << "negligible";
}

using namespace testing_regions;

using Faces = std::vector<std::vector<Loop>>;

heal::HealScale scale(double tolerance = 1e-5) {
  heal::HealScale s;
  s.file = "x.step", s.diameter = 1, s.tolerance = tolerance;
  return s;
}

/// What is refused; empty if nothing is.
std::string refusal(const Faces& faces, bool is_asked = false, double tolerance = 1e-5) {
  try {
    require_one_sheet(sew_regions(regions_of(faces), tolerance), scale(tolerance), is_asked);
  } catch (const FormatError& e) {
    return e.what();
  }
  return {};
}

void expect_refused(const Faces& faces, const std::string& part) {
  const std::string text = refusal(faces);
  EXPECT_NE(text.find(part), std::string::npos) << text;
  EXPECT_EQ(text.rfind("x.step: ", 0), 0U) << text;
}

TEST(OneSheet, NeighboursInclusionsAndRingsAreAccepted) {
  EXPECT_EQ(refusal({{rectangle({0, 0}, {1, 1})}, {rectangle({1, 0}, {2, 1})}}), "");
  EXPECT_EQ(refusal({{rectangle({-2, -2}, {2, 2}), hole({0, 0}, 1)}, {circle({0, 0}, 1), hole({0, 0}, 0.5)}}), "");
  // Four cells around a hole: the boundary of the whole has a loop that no region has alone.
  const Faces around{{rectangle({0, 0}, {2, 1})},
                     {rectangle({2, 0}, {3, 2})},
                     {rectangle({1, 2}, {3, 3})},
                     {rectangle({0, 1}, {1, 3})}};
  EXPECT_EQ(refusal(around), "");
  EXPECT_EQ(whole_boundary(sew_regions(regions_of(around), 1e-5)).size(), 2U);
}

TEST(OneSheet, OverlapsAreNamed) {
  expect_refused({{rectangle({0, 0}, {1, 1})}, {rectangle({0.5, 0.25}, {2, 0.75})}},
                 "face 0 'part0' and face 1 'part1' overlap at (");
  expect_refused({{rectangle({-2, -2}, {2, 2})}, {circle({0, 0}, 1)}}, "overlap");
  expect_refused({{rectangle({0, 0}, {1, 1})}, {rectangle({0, 0}, {1, 1})}}, "overlap");
  // A third face on two that share an edge.
  expect_refused({{rectangle({0, 0}, {1, 1})}, {rectangle({1, 0}, {2, 1})}, {rectangle({1, 0}, {2, 0.5})}},
                 "face 1 'part1' and face 2 'part2' overlap");
}

TEST(OneSheet, SmallOverlapsAndGapsHaveAToleranceThatCloses) {
  const Faces overlapping{{rectangle({0, 0}, {1, 1})}, {rectangle({0.9998, 0}, {2, 1})}};
  expect_refused(overlapping, "give --heal-tolerance 0.0002");
  EXPECT_EQ(refusal(overlapping, true, 2.1e-4), "");
  const Faces apart{{rectangle({0, 0}, {1, 1})}, {rectangle({1.0002, 0}, {2, 1})}};
  expect_refused(apart, "are up to 0.0002 apart at (1.0001, ");
  expect_refused(apart, "give --heal-tolerance 0.0002");
  EXPECT_EQ(refusal(apart, true, 2.1e-4), "");
  // A hole that is a little too large all around.
  expect_refused({{rectangle({-2, -2}, {2, 2}), hole({0, 0}, 1.0003)}, {circle({0, 0}, 1)}}, "up to 0.0003 apart");
}

TEST(OneSheet, ACreviceBetweenNeighboursIsASlipUnlessItIsMeant) {
  const Faces faces{{rectangle({0, 0}, {2, 1})},
                    {polygon({{0, 1}, {0.5, 1}, {1, 1.0004}, {1, 2}, {0, 2}})},
                    {rectangle({1, 1}, {2, 2})}};
  expect_refused(faces, "do not meet: they are up to 0.0004 apart at (1, 1.0002)");
  EXPECT_NE(refusal(faces).find("if the gap is meant, give --heal-tolerance 8e-06"), std::string::npos);
  EXPECT_EQ(refusal(faces, true, 8e-6), "");
}

TEST(OneSheet, AShortSlotIsMeant) {
  EXPECT_EQ(refusal({{rectangle({0, 0}, {1, 0.5})},
                     {rectangle({0, 0.5}, {0.49975, 0.51})},
                     {rectangle({0.50025, 0.5}, {1, 0.51})}}),
            "");
}

TEST(OneSheet, FacesApartKeepTheMessageOfSeveralFaces) {
  expect_refused({{rectangle({0, 0}, {1, 1})}, {rectangle({1.5, 0}, {2, 1})}},
                 "the file holds several faces (2) that do not touch: face 0 'part0' and face 1 'part1' are 0.5 apart");
  expect_refused({{rectangle({0, 0}, {1, 1})}, {rectangle({1.5, 0}, {2, 1})}}, "choose one face with --face");
}

TEST(OneSheet, FacesThatTouchInAPointAreNamed) {
  expect_refused({{rectangle({0, 0}, {1, 1})}, {rectangle({1, 1}, {2, 2})}},
                 "face 0 'part0' and face 1 'part1' touch at (1, 1) in a point only");
  // Connected, but the boundary of the whole touches itself.
  expect_refused({{rectangle({0, 0}, {1, 1})},
                  {rectangle({1, 1}, {2, 2})},
                  {polygon({{-1, 0}, {0, 0}, {0, 1}, {-1, 3}})},
                  {polygon({{-1, 3}, {1, 2}, {2, 2}, {2, 3}})}},
                 "touch at (1, 1) in a point only");
}

}  // namespace

}  // namespace quadrille::sew
