#include "cad/periodic_in_space.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "../chart_samples.hpp"
#include "../support/texts.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "cad/periodic_pairing.hpp"
#include "cad/periodic_sides.hpp"
#include "curve/nurbs.hpp"
#include "model/periodic.hpp"
#include "space/space_curve.hpp"
#include "surface/nurbs_surface.hpp"
#include "surface/periodic_motion.hpp"

namespace quadrille::cad {
namespace {

/// A patch of the sphere between two meridians, a quarter turn apart: curves 0 and 3.
CadFace patch() {
  CadFace face = samples::sphere_face();
  face.curve_names = {"from", "east", "north", "to"};
  face.unnamed_curves.clear();
  return face;
}

CadFace paired(CadFace face, const std::string& option = "from=to") {
  pair_periodic_sides(face, periodic_options({option}));
  return face;
}

/// The curve over another parameter, t -> (1 + c) t / (1 + c t).
template <class Curve>
Curve with_uneven_parameters(Curve curve, double c) {
  for (std::size_t i = 0; i < curve.weights.size(); ++i) curve.weights[i] *= std::pow(1 + c, -static_cast<double>(i));
  return curve;
}

void expect_images(const CadFace& face, const PeriodicPair& pair) {
  const auto [first, second] = pair.curves;
  const SpaceMotion motion = surface::periodic_motion(face, pair);
  const SpaceCurve &from = face.chart->space_curves[first], &to = face.chart->space_curves[second];
  for (int k = 0; k <= 20; ++k) {
    const double t = from.begin() + (from.end() - from.begin()) * k / 20;
    const double other = periodic_parameter(face, first, t, second);
    const Vec3 moved = surface::image(motion, surface::point(from, t));
    EXPECT_LE(distance(moved, surface::point(to, other)), 1e-14);
    EXPECT_LE(distance(samples::on_sphere(curve::point(face.curves[second], other)), moved), 2e-9);
  }
}

TEST(PeriodicInSpace, TheCurveInSpaceIsTheImageAndThatOfTheChartHasItsParameters) {
  const CadFace face = paired(patch());
  ASSERT_EQ(face.periodic_pairs.size(), 1U);
  EXPECT_EQ(face.periodic_pairs[0].curves, (std::array<int, 2>{0, 3}));
  EXPECT_NEAR(face.periodic_pairs[0].angle, pi / 2, 1e-15);
  EXPECT_EQ(face.periodic_pairs[0].shift, (Vec2{0, 0}));
  expect_images(face, face.periodic_pairs[0]);
}

TEST(PeriodicInSpace, SidesWithOtherParametersGetThoseOfTheFirstOne) {
  CadFace face = patch();
  Chart chart = *face.chart;
  face.curves[3] = with_uneven_parameters(face.curves[3], 0.5);
  chart.space_curves[3] = with_uneven_parameters(chart.space_curves[3], 0.5);
  for (double& knot : face.curves[3].knots) knot *= 3;
  for (double& knot : chart.space_curves[3].knots) knot *= 3;
  face.chart = std::make_shared<const Chart>(chart);
  face = paired(face);
  EXPECT_EQ(face.curves[3].end(), face.curves[0].end());
  expect_images(face, face.periodic_pairs[0]);
}

TEST(PeriodicInSpace, AJointThatTheOtherSideLacksIsMadeThere) {
  CadFace face = patch();
  Chart chart = *face.chart;
  const SpaceCurve whole = chart.space_curves[0];
  SpaceCurve rest = space::trimmed(whole, 0.3, 1);
  for (double& knot : rest.knots) knot -= 0.3;
  chart.space_curves[0] = space::trimmed(whole, 0, 0.3);
  chart.space_curves.insert(chart.space_curves.begin() + 1, rest);
  face.chart = std::make_shared<const Chart>(chart);
  split_curve(face, 0, 0.3);
  face = paired(face);
  ASSERT_EQ(face.num_curves(), 6);
  ASSERT_EQ(face.chart->space_curves.size(), 6U);
  ASSERT_EQ(face.periodic_pairs.size(), 2U);
  EXPECT_EQ(face.periodic_pairs[0].curves, (std::array<int, 2>{0, 5}));
  EXPECT_EQ(face.periodic_pairs[1].curves, (std::array<int, 2>{1, 4}));
  EXPECT_EQ(face.curve_names[4], "to");
  for (const PeriodicPair& pair : face.periodic_pairs) expect_images(face, pair);
}

TEST(PeriodicInSpace, SidesThatNoMotionMapsAreRefusedWithThePlace) {
  const std::string text = message_of<FormatError>([] { paired(patch(), "from=north"); });
  EXPECT_NE(text.find("--periodic from=north: the sides are not equal up to a motion: the point ("), std::string::npos)
      << text;
  EXPECT_NE(text.find("diameters) away from"), std::string::npos) << text;
}

TEST(PeriodicInSpace, AMotionOfThePlaneIsRefused) {
  const std::string text = message_of<UsageError>([] { paired(patch(), "from=to:rotate=90"); });
  EXPECT_NE(text.find("leave it out"), std::string::npos) << text;
}

TEST(PeriodicInSpace, SidesThatTheChartScalesDifferentlyAreRefused) {
  CadFace face = patch();
  face.curves[3].poles.front() = 1.1 * face.curves[3].poles.front();
  const std::string text = message_of<UsageError>([&] { paired(face); });
  EXPECT_NE(text.find("scales 'from' and 'to' differently"), std::string::npos) << text;
}

}  // namespace
}  // namespace quadrille::cad
