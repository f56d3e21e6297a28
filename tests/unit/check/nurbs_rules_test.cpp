#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "check/rules.hpp"

namespace quadrille::check {
namespace {

/// A quarter of the unit circle.
Nurbs arc() { return {2, {0, 0, 0, 1, 1, 1}, {{1, 0}, {1, 1}, {0, 1}}, {1, std::sqrt(0.5), 1}}; }

/// Two spans of degree 2 with a double knot between them.
Nurbs kinked() { return {2, {0, 0, 0, 1, 1, 2, 2, 2}, {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}}, {1, 1, 1, 1, 1}}; }

template <typename Change>
Nurbs with(Nurbs curve, const Change& change) {
  change(curve);
  return curve;
}

TEST(NurbsRules, SoundCurvesHaveNoFault) {
  for (const Nurbs& curve : {arc(), kinked()}) {
    EXPECT_EQ(structure_fault(curve), "");
    EXPECT_EQ(number_fault(curve), "");
  }
}

TEST(NurbsRules, ArraysThatDoNotFitAreNamed) {
  EXPECT_EQ(structure_fault(with(arc(), [](Nurbs& c) { c.degree = 26; })), "degree 26 is outside 1 to 25");
  EXPECT_EQ(structure_fault(with(arc(), [](Nurbs& c) { c.degree = 3; })), "3 poles are too few for degree 3");
  EXPECT_EQ(structure_fault(with(arc(), [](Nurbs& c) { c.weights.pop_back(); })), "2 weights for 3 poles");
  EXPECT_EQ(structure_fault(with(arc(), [](Nurbs& c) { c.knots.pop_back(); })), "5 knots for 3 poles of degree 2");
}

TEST(NurbsRules, NumbersThatNoCurveHasAreNamed) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(number_fault(with(arc(), [](Nurbs& c) { c.poles[1].y = nan; })), "pole 1 is not finite");
  EXPECT_EQ(number_fault(with(arc(), [](Nurbs& c) { c.weights[2] = 0; })), "weight 2 is not positive");
  EXPECT_EQ(number_fault(with(arc(), [](Nurbs& c) { c.weights[2] = 2e8; })),
            "weights 0.707 and 2e+08 differ by more than a factor of 1e+08");
  EXPECT_EQ(number_fault(with(arc(), [](Nurbs& c) { c.knots[0] = nan; })), "knot 0 is not finite");
  EXPECT_EQ(number_fault(with(arc(), [](Nurbs& c) { c.knots[5] = 0.5; })), "knot 5 is smaller than the one before");
  EXPECT_EQ(number_fault(with(arc(), [](Nurbs& c) { c.knots.assign(6, 0); })), "the domain is empty");
  EXPECT_EQ(number_fault(with(arc(), [](Nurbs& c) { c.knots[2] = 0.5; })), "the curve is not clamped at its ends");
  EXPECT_EQ(number_fault(with(kinked(),
                              [](Nurbs& c) {
                                c.knots = {0, 0, 0, 1, 1, 1, 2, 2, 2};
                                c.poles.push_back({3, 3});
                                c.weights.push_back(1);
                              })),
            "the curve is broken at knot 3");
}

TEST(NurbsRules, PolesBeyondAThousandDiametersAreFar) {
  CadFace face;
  face.diameter = 1;
  face.curves = {arc()};
  EXPECT_FALSE(has_far_pole(arc(), face));
  EXPECT_FALSE(has_far_pole(with(arc(), [](Nurbs& c) { c.poles[1].x = 1000; }), face));
  EXPECT_TRUE(has_far_pole(with(arc(), [](Nurbs& c) { c.poles[1].x = 1002; }), face));
}

}  // namespace
}  // namespace quadrille::check
