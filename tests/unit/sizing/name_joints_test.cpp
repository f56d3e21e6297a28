#include "sizing/name_joints.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "../hand_made.hpp"

namespace quadrille::sizing {
namespace {

/// The joint between a line of length 1 and one of length 3, whose curves have these names; the curves of `unnamed` got
/// theirs from their numbers.
std::vector<double> joints(const std::string& first, const std::string& second, std::vector<int> unnamed = {}) {
  CadFace face = hand_made::face(
      {{curve::segment({0, 0}, {1, 0}), curve::segment({1, 0}, {4, 0}), curve::segment({4, 0}, {0, 0})}}, 4);
  face.curve_names = {first, second, "rest"};
  face.unnamed_curves = std::move(unnamed);
  const std::vector<Nurbs> no_splines;
  const curve::CurveTable table(face, no_splines);
  return name_joints(curve::Chain(table, {{0, 0, 1}, {1, 0, 3}}), face);
}

TEST(NameJoints, LieWhereAGivenNameEnds) {
  for (const std::vector<double>& found : {joints("wall", "inlet"), joints("curve_0", "inlet", {0}),
                                           joints("wall", "curve_1", {1}), joints("curve_0", "curve_1", {1})}) {
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0], 0.25, 1e-12);
  }
}

TEST(NameJoints, OneNameOnBothSidesIsNone) { EXPECT_TRUE(joints("wall", "wall").empty()); }

TEST(NameJoints, NamesThatNobodyGaveAreNone) { EXPECT_TRUE(joints("curve_0", "curve_1_", {0, 1}).empty()); }

}  // namespace
}  // namespace quadrille::sizing
