#include "model/enclosed_joints.hpp"

#include <gtest/gtest.h>

#include "../triangulate/faces.hpp"

namespace quadrille {
namespace {

using namespace testing_faces;

std::vector<int> enclosed(const CadFace& face) {
  const std::vector<bool> are_enclosed = enclosed_joints(face);
  std::vector<int> joints;
  for (int j = 0; j < face.num_curves(); ++j)
    if (are_enclosed[j]) joints.push_back(j);
  return joints;
}

TEST(EnclosedJoints, AreAllOfASlit) {
  EXPECT_EQ(enclosed(slit_square()), (std::vector<int>{4, 5}));
  EXPECT_EQ(enclosed(bent_slit(0.5)), (std::vector<int>{4, 5, 6, 7}));
  EXPECT_EQ(enclosed(open_slit()), (std::vector<int>{2, 3, 4})) << "the ends on the outline too";
}

TEST(EnclosedJoints, AreThoseWhereARegionTouchesItself) {
  EXPECT_EQ(enclosed(pinched_square()), (std::vector<int>{5, 8}));
}

TEST(EnclosedJoints, AreNoOrdinaryCorners) {
  EXPECT_TRUE(enclosed(l_shape()).empty());
  EXPECT_TRUE(enclosed(annulus()).empty());
}

}  // namespace
}  // namespace quadrille
