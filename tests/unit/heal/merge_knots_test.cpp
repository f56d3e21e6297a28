#include "heal/merge_knots.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"
#include "curve/project.hpp"
#include "heal/heal_face.hpp"
#include "raw_samples.hpp"

namespace quadrille::heal {
namespace {

// A cubic arch from (4, 0) to (0, 0) with these inner knots in (0, 1), which are breaks.
Nurbs arch(const std::vector<double>& inner) {
  Nurbs curve;
  curve.degree = 3;
  curve.knots.assign(4, 0);
  curve.knots.insert(curve.knots.end(), inner.begin(), inner.end());
  curve.knots.insert(curve.knots.end(), 4, 1);
  const size_t count = curve.knots.size() - 4;
  for (size_t i = 0; i < count; ++i) {
    const double t = (curve.knots[i + 1] + curve.knots[i + 2] + curve.knots[i + 3]) / 3;
    curve.poles.push_back({4 - 4 * t, std::sin(pi * t) * (1 + t)});
  }
  curve.poles.back().y = 0;
  curve.weights.assign(count, 1);
  return curve;
}

double greatest_distance(const Nurbs& a, const Nurbs& b) {
  double greatest = 0;
  for (int i = 0; i <= 100; ++i) greatest = std::max(greatest, curve::project(b, curve::point(a, i / 100.0)).distance);
  return greatest;
}

void expect_merged(const std::vector<double>& inner, size_t num_poles, double most) {
  const Nurbs old = arch(inner);
  Nurbs curve = old;
  const auto merged = merge_knots(curve, most);
  ASSERT_TRUE(merged);
  EXPECT_GT(merged->length, 0);
  EXPECT_LE(merged->length, most);
  EXPECT_EQ(curve.poles.size(), num_poles);
  EXPECT_EQ(curve.knots.size(), num_poles + 4);
  EXPECT_EQ(curve.weights.size(), num_poles);
  EXPECT_EQ(curve.poles.front(), old.poles.front());
  EXPECT_EQ(curve.poles.back(), old.poles.back());
  EXPECT_LE(greatest_distance(old, curve), merged->length);
  EXPECT_FALSE(merge_knots(curve, most));
}

TEST(MergeKnots, TwoSimpleKnotsBecomeADoubleOne) { expect_merged({0.5, 0.5 + 1e-6}, 6, 1e-4); }

TEST(MergeKnots, AKnotLosesPolesBeyondTheDegree) {
  expect_merged({0.5, 0.5, 0.5 + 1e-6, 0.5 + 1e-6}, 7, 1e-4);
  expect_merged({0.5, 0.5, 0.5 + 1e-6, 0.5 + 1e-6, 0.5 + 2e-6, 0.5 + 2e-6}, 7, 1e-4);
  expect_merged({0.5, 0.5, 0.5 + 1e-12, 0.5 + 1e-12}, 7, 1e-4);
}

TEST(MergeKnots, KnotsNearAnEndGoThere) {
  expect_merged({1e-6, 1e-6, 0.5, 0.5}, 6, 1e-4);
  expect_merged({0.5, 0.5, 1 - 1e-6, 1 - 1e-6}, 6, 1e-4);
  expect_merged({1e-6, 1e-6, 1 - 1e-6, 1 - 1e-6}, 4, 1e-4);
}

TEST(MergeKnots, KnotsFurtherApartAndShortCurvesStay) {
  Nurbs curve = arch({0.5, 0.5, 0.5 + 1e-3, 0.5 + 1e-3});
  const std::vector<double> knots = curve.knots;
  EXPECT_FALSE(merge_knots(curve, 1e-3));
  EXPECT_FALSE(merge_knots(curve, 100));
  EXPECT_EQ(curve.knots, knots);
}

TEST(MergeKnots, KnotsThatAreNoBreaksStay) {
  Nurbs line{3, {0, 0, 0, 0, 0.5, 0.5 + 1e-9, 1, 1, 1, 1}, {}, {1, 1, 1, 1, 1, 1}};
  for (size_t i = 0; i < 6; ++i)
    line.poles.push_back({(line.knots[i + 1] + line.knots[i + 2] + line.knots[i + 3]) / 3, 0});
  EXPECT_FALSE(merge_knots(line, 1e-4));
}

TEST(MergeKnots, HealingReportsIt) {
  RawFace raw = raw_face({curve::segment({0, 0}, {0, -3}), curve::segment({0, -3}, {4, -3}),
                          curve::segment({4, -3}, {4, 0}), arch({0.5, 0.5, 0.5 + 1e-6, 0.5 + 1e-6})});
  Report report;
  const auto repairs = heal_face(raw, {}, 6, report);
  ASSERT_EQ(repairs.size(), 1U);
  EXPECT_EQ(repairs[0].kind, RepairKind::knot);
  EXPECT_EQ(repairs[0].cad_edge, 3);
  EXPECT_TRUE(heal_face(raw, {}, 6, report).empty());
}

}  // namespace
}  // namespace quadrille::heal
