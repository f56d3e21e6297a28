#include "sizing/curve_sizes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../hand_made.hpp"
#include "base/angle.hpp"

namespace quadrille::sizing {
namespace {

double least_size(const std::vector<SizeSegment>& segments) {
  double least = 1e300;
  for (const SizeSegment& s : segments) least = std::min({least, s.size_a, s.size_b});
  return least;
}

TEST(CurveSizes, ShortCurvesAreDividedAndLongOnesAreNot) {
  // A rectangle 10 x 1: the short sides have 4 elements, the long ones are long enough.
  CadFace face = hand_made::face({{curve::segment({0, 0}, {10, 0}), curve::segment({10, 0}, {10, 1}),
                                   curve::segment({10, 1}, {0, 1}), curve::segment({0, 1}, {0, 0})}},
                                 std::sqrt(101.0));
  const std::vector<SizeSegment> segments = segments_by_curves(face, 4, 0, 0.5, 0.2);
  EXPECT_NEAR(least_size(segments), 0.25, 1e-12);
  for (const SizeSegment& s : segments) EXPECT_TRUE(s.a.x == s.b.x && (s.a.x == 0 || s.a.x == 10)) << s.a.x;
  EXPECT_NEAR(least_size(segments_by_curves(face, 4, 0.3, 0.5, 0.2)), 0.3, 1e-12) << "the limit";
  EXPECT_TRUE(segments_by_curves(face, 2, 0, 0.5, 0.2).empty()) << "sizes that are not finer are no sources";
}

TEST(CurveSizes, AHoleWithoutCornersHasThreeTimesAsMany) {
  const CadFace face = hand_made::cut_annulus(4).face;  // radii 1 and 0.5
  EXPECT_NEAR(least_size(segments_by_curves(face, 4, 0, 0.3, 0.2)), 2 * pi * 0.5 / 12, 1e-9);
}

TEST(CurveSizes, ARunPassesSmoothJointsAndEndsAtGivenNames) {
  // Line and quarter circle are one run of length 1 + pi; with names they are two.
  CadFace face = hand_made::elbow().face;
  const auto shortest_but = [&](double side) {
    double least = 1e300;
    for (const SizeSegment& s : segments_by_curves(face, 4, 0, 10, 0.2))
      if (std::abs(s.size_a - side) > 1e-9) least = std::min(least, s.size_a);
    return least;
  };
  EXPECT_NEAR(shortest_but(0.25), (1 + half_pi) / 4, 1e-9) << "the inner side: line and quarter circle";
  hand_made::give_name(face, 4, "wall");
  EXPECT_NEAR(shortest_but(0.25), half_pi / 4, 1e-9) << "the quarter circle alone";
}

TEST(CurveSizes, ATinyEdgeIsLimited) {
  CadFace face = hand_made::face({{curve::segment({0, 0}, {1, 0}), curve::segment({1, 0}, {1, 1e-5}),
                                   curve::segment({1, 1e-5}, {0, 1}), curve::segment({0, 1}, {0, 0})}},
                                 std::sqrt(2.0));
  EXPECT_NEAR(least_size(segments_by_curves(face, 4, 0, 0.1, 0.2)), 1e-3 * std::sqrt(2.0), 1e-12);
}

}  // namespace
}  // namespace quadrille::sizing
