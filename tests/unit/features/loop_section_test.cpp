#include "features/loop_section.hpp"

#include <gtest/gtest.h>

#include "feature_faces.hpp"

namespace quadrille::features {
namespace {

using namespace testing_features;

/// Sides of length 4; curve k starts at the k-th corner, counter-clockwise from the lower left.
CadFace square() { return plate(2); }

TEST(LoopSection, MeasuresFractionsOfItsLengthOverJoints) {
  const CadFace face = square();
  const LoopSection section(face, {{0, 1, 4}, {1, 0, 1}}, false);  // from (-1, -2) to (2, -1)
  EXPECT_NEAR(section.length(), 4, 1e-14);
  EXPECT_NEAR(distance(section.at(0.25).position, {0, -2}), 0, 1e-14);
  EXPECT_EQ(section.at(0.25).curve, 0);
  EXPECT_NEAR(distance(section.at(1).position, {2, -1}), 0, 1e-14);
  EXPECT_NEAR(distance(section.at(1.5).position, {2, -1}), 0, 1e-14);  // clamped
  EXPECT_NEAR(distance(section.at(-1).position, {-1, -2}), 0, 1e-14);
}

TEST(LoopSection, NamesAJointByTheCurveThatBeginsThere) {
  const CadFace face = square();
  const SectionPoint joint = LoopSection(face, {{0, 1, 4}, {1, 0, 1}}, false).at(0.75);
  EXPECT_EQ(joint.curve, 1);
  EXPECT_EQ(joint.t, face.curves[1].begin());
  const SectionPoint last = LoopSection(face, {{3, 0, 4}}, false).at(1);
  EXPECT_EQ(last.curve, 0);
}

TEST(LoopSection, WrapsRoundWhereItIsClosed) {
  const CadFace face = square();
  const LoopSection whole = whole_loop(face, 0);
  EXPECT_TRUE(whole.is_closed());
  EXPECT_NEAR(whole.length(), 16, 1e-13);
  EXPECT_NEAR(distance(whole.at(1.125).position, {0, -2}), 0, 1e-13);
  EXPECT_NEAR(distance(whole.at(-0.125).position, {-2, 0}), 0, 1e-13);
}

TEST(LoopSection, FindsTheNearestPoint) {
  const CadFace face = square();
  const SectionFoot foot = LoopSection(face, {{0, 0, 4}, {1, 0, 4}}, false).foot({1.5, 1});
  EXPECT_NEAR(foot.fraction, 7.0 / 8, 1e-14);
  EXPECT_NEAR(foot.distance, 0.5, 1e-14);
  EXPECT_NEAR(distance(foot.position, {2, 1}), 0, 1e-14);
}

TEST(LoopSection, OverlapsWhereIntervalsDoButNotAtTheirEnds) {
  const CadFace face = square();
  const LoopSection a(face, {{0, 0, 2}}, false), b(face, {{0, 2, 4}}, false), c(face, {{0, 1, 3}}, false),
      d(face, {{1, 1, 3}}, false);
  EXPECT_FALSE(do_overlap(a, b));
  EXPECT_TRUE(do_overlap(a, c));
  EXPECT_FALSE(do_overlap(c, d));
}

}  // namespace
}  // namespace quadrille::features
