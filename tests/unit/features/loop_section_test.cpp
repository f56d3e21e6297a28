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

using namespace testing_features;

TEST(CurvedRuns, AreTheFilletsOfARectangleToTheLeft) {
  const CadFace face = hand_made::face({rectangle({0, 0}, {4, 2}, 0.5)}, std::sqrt(20.0));
  const std::vector<CurvedRun> runs = curved_runs(face, 0, 0.01);
  ASSERT_EQ(runs.size(), 4u);
  for (const CurvedRun& run : runs) {
    EXPECT_EQ(run.side(), TurnSide::left);
    EXPECT_NEAR(run.turning(), half_pi, 1e-12);
    EXPECT_NEAR(run.least_radius(), 0.5, 1e-12);
    EXPECT_FALSE(run.is_loop);
  }
  EXPECT_TRUE(curved_runs(face, 0, 2.1).empty());  // curvature 2 is not above 2.1
}

TEST(CurvedRuns, OfAHoleTurnToTheRightAndCloseRoundACircle) {
  const CadFace face = plate(4, {window({-1, -1}, {1, 1}, 0.5), round_hole({3, 3}, 0.5)});
  const std::vector<CurvedRun> fillets = curved_runs(face, 1, 0.01), circle = curved_runs(face, 2, 0.01);
  ASSERT_EQ(fillets.size(), 4u);
  EXPECT_EQ(fillets[0].side(), TurnSide::right);
  ASSERT_EQ(circle.size(), 1u);
  EXPECT_TRUE(circle[0].is_loop);
  EXPECT_NEAR(circle[0].turning(), 2 * pi, 1e-12);
}

TEST(CurvedRuns, GoOnOverSmoothJointsAndAlsoOverTheFirst) {
  // A half circle of two quarters, cut where the loop begins.
  const Loop slot{curve::circular_arc({1, 0}, 0.3, 0, -half_pi), curve::segment({1, -0.3}, {-1, -0.3}),
                  curve::circular_arc({-1, 0}, 0.3, -half_pi, -3 * half_pi), curve::segment({-1, 0.3}, {1, 0.3}),
                  curve::circular_arc({1, 0}, 0.3, half_pi, 0)};
  const std::vector<CurvedRun> runs = curved_runs(plate(4, {slot}), 1, 0.01);
  ASSERT_EQ(runs.size(), 2u);
  for (const CurvedRun& run : runs) EXPECT_NEAR(run.turning(), pi, 1e-12);
  EXPECT_EQ(runs[0].parts.size(), 2u);
  EXPECT_EQ(runs[0].intervals().front().curve, 8);  // 4 sides of the plate before the slot's 5 curves
}

TEST(CurvedRuns, StopAtCorners) {
  const Loop lens{curve::circular_arc({0, -0.5}, 1, radians(150), radians(30)),
                  curve::circular_arc({0, 0.5}, 1, radians(-30), radians(-150))};
  EXPECT_EQ(curved_runs(plate(4, {lens}), 1, 0.01).size(), 2u);
}

TEST(CurvedRuns, EndWhereTheCurvatureFallsBelowTheLimit) {
  // An ellipse with half axes 1 and 0.2: curvature 25 at its ends, 0.2 on its flanks.
  Loop ellipse = round_hole({0, 0}, 1);
  for (Vec2& pole : ellipse[0].poles) pole.y *= 0.2;
  const CadFace face = plate(4, {ellipse});
  const std::vector<CurvedRun> ends = curved_runs(face, 1, 10);
  ASSERT_EQ(ends.size(), 2u);
  for (const CurvedRun& run : ends)
    for (const CurveInterval& part : run.intervals())
      for (const double t : {part.t0, part.t1}) {
        const double k = std::abs(curve::curvature(face.curves[part.curve], t));
        EXPECT_TRUE(std::abs(k - 10) < 1e-6 || k > 10) << k;  // its end, or a joint inside the run
      }
  EXPECT_TRUE(curved_runs(face, 1, 0.1)[0].is_loop);
}

}  // namespace
}  // namespace quadrille::features
