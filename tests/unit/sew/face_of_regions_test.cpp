#include "sew/face_of_regions.hpp"

#include <gtest/gtest.h>

#include "regions.hpp"

namespace quadrille::sew {
namespace {

using namespace testing_regions;

CadFace face_of(const std::vector<Region>& regions) {
  return face_of_regions(sew_regions(regions, 1e-5), heal::RawFace(), radians(1.0));
}

std::vector<Region> t_joint() {
  return regions_of({{rectangle({0, 0}, {2, 1})}, {rectangle({0, 1}, {0.75, 2})}, {rectangle({0.75, 1}, {2, 2})}});
}

TEST(FaceOfRegions, ListsLoopsAndPartnersRegionAfterRegion) {
  const CadFace face = face_of(t_joint());
  EXPECT_EQ(face.region_loops, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(face.loop_offsets, (std::vector<int>{0, 5, 9, 13}));
  EXPECT_EQ(face.partners, (std::vector<int>{-1, -1, 9, 5, -1, 3, 12, -1, -1, 2, -1, -1, 6}));
  EXPECT_NEAR(face.diameter, std::sqrt(8.0), 1e-14);
}

TEST(FaceOfRegions, JointsAreThoseOfEachRegionByItself) {
  const CadFace face = face_of(t_joint());
  EXPECT_DOUBLE_EQ(face.joints[3].interior_angle, pi);
  EXPECT_FALSE(face.joints[3].is_corner) << "the edge of the first region is straight there";
  EXPECT_DOUBLE_EQ(face.joints[6].interior_angle, half_pi);
  EXPECT_TRUE(face.joints[6].is_corner);
  EXPECT_TRUE(face.joints[9].is_corner);
}

TEST(FaceOfRegions, BothSidesOfAnInterfaceHaveOneName) {
  std::vector<Region> regions = t_joint();
  regions[0].curves[0].name = "floor";
  regions[2].curves[0].name = "bond";
  regions[1].curves[1].name = "seam", regions[2].curves[3].name = "other";
  regions[1].name = "";
  const CadFace face = face_of(regions);
  EXPECT_EQ(face.region_names, (std::vector<std::string>{"part0", "region_1", "part2"}));
  EXPECT_EQ(face.curve_names[0], "floor");
  EXPECT_EQ(face.curve_names[2], "bond") << "the second side has the name";
  EXPECT_EQ(face.curve_names[9], "bond");
  EXPECT_EQ(face.curve_names[6], "seam") << "the first side's name counts";
  EXPECT_EQ(face.curve_names[12], "seam");
  EXPECT_EQ(face.unnamed_curves, (std::vector<int>{1, 3, 4, 5, 7, 8, 10, 11}));
  EXPECT_EQ(face.curve_names[4], "curve_4");
}

TEST(FaceOfRegions, TheTipOfASlitHasTheFaceAllAround) {
  std::vector<Region> regions =
      regions_of({{polygon({{0, 0}, {1, 0}, {1, 1}, {0.5, 1}, {0.5, 0.5}, {0.5, 1}, {0, 1}})}});
  regions[0].other_sides[3] = 4, regions[0].other_sides[4] = 3;
  const CadFace face = face_of(regions);
  EXPECT_EQ(face.partners[3], 4);
  EXPECT_EQ(face.partners[4], 3);
  EXPECT_DOUBLE_EQ(face.joints[4].interior_angle, 2 * pi);
  EXPECT_TRUE(face.joints[4].is_corner);
  EXPECT_DOUBLE_EQ(face.joints[3].interior_angle, half_pi);
}

}  // namespace
}  // namespace quadrille::sew
