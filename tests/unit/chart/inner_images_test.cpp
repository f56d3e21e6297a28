#include "chart/inner_images.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "chart/make_chart.hpp"
#include "curve/nurbs.hpp"
#include "surface/nurbs_surface.hpp"
#include "surface_samples.hpp"

namespace quadrille::chart {
namespace {

CadFace chart_of(const SpaceFace& face) {
  Report report;
  return make_chart(face, {}, report);
}

SpaceFace with_curve(SpaceFace face, const SpaceCurve& curve) {
  face.inner_curves = {{curve, "inner", 9, {0, 0}}};
  return face;
}

TEST(InnerImages, AFaceWithoutThemHasNone) {
  EXPECT_TRUE(inner_curves_in_chart(cylinder_patch(), chart_of(cylinder_patch())).empty());
}

/// An arc of a radian at the height 1.5 of a cylinder of radius 2 is a line of length 2.
TEST(InnerImages, AnArcOfACylinderIsALine) {
  SpaceCurve arc = tests::profile_arc(0, 2, 0.5, 1.5);
  for (Vec3& pole : arc.poles) pole = {pole.x, pole.z, 1.5};
  const SpaceFace face = with_curve(cylinder_patch(), arc);
  const std::vector<ImagedCurve> curves = inner_curves_in_chart(face, chart_of(face));
  ASSERT_EQ(curves.size(), 1u);
  const Nurbs& image = curves[0].image;
  EXPECT_EQ(image.begin(), curves[0].space.begin());
  const Vec2 from = image.poles.front(), to = image.poles.back();
  EXPECT_NEAR(distance(from, to), 2, 1e-6);
  for (int k = 0; k <= 20; ++k) {
    const double t = image.begin() + (image.end() - image.begin()) * k / 20;
    const Vec3 x = surface::point(curves[0].space, t);
    const double part = std::atan2(x.y, x.x) - 0.5;
    EXPECT_LT(distance(curve::point(image, t), from + part * (to - from)), 1e-6);
  }
}

TEST(InnerImages, InAPlaneTheyAreExact) {
  const SpaceFace sector =
      tests::face_of(tests::revolved(tests::line({1, 0, 3}, {2, 0, 3}), 0, 1), {{0, 1, 2, 3}}, 12, 5);
  const SpaceFace face = with_curve(sector, tests::line({1.2, 0.3, 3}, {1.1, 0.9, 3}));
  const std::vector<ImagedCurve> curves = inner_curves_in_chart(face, chart_of(face));
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_EQ(curves[0].image.degree, 1);
  EXPECT_EQ(curves[0].image.knots, curves[0].space.knots);
  EXPECT_NEAR(distance(curves[0].image.poles[0], curves[0].image.poles[1]), std::hypot(0.1, 0.6), 1e-13);
}

}  // namespace
}  // namespace quadrille::chart
