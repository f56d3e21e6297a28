#include "occ/occ_splines.hpp"

#include <gtest/gtest.h>

#include "../curved_surfaces.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::occ {
namespace {

Vec3 vector(const gp_Pnt& p) { return {p.X(), p.Y(), p.Z()}; }

TEST(OccSplines, HaveThePointsOfOurs) {
  const NurbsSurface torus = tests::torus(2, 1);
  const SpaceCurve arc = tests::profile_arc(1, 2, 0.3, 2.5);
  for (const double t : {0.31, 1.0, 2.4}) {
    EXPECT_NEAR(distance(vector(occ_spline(arc)->Value(t)), surface::point(arc, t)), 0, 1e-14);
    EXPECT_NEAR(distance(vector(occ_spline(torus)->Value(t, 2 * t)), surface::point(torus, {t, 2 * t})), 0, 1e-14);
  }
}

TEST(OccSplines, APartMayLieAcrossTheSeams) {
  const NurbsSurface torus = tests::torus(2, 1);
  const Handle(Geom_BSplineSurface) part = occ_part(torus, {5, 0.5}, {7.5, 6.6});
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  part->Bounds(u0, u1, v0, v1);
  EXPECT_NEAR(u0, 5, 1e-12);
  EXPECT_NEAR(u1, 7.5, 1e-12);
  EXPECT_NEAR(v0, 0.5, 1e-12);
  EXPECT_NEAR(v1, 6.6, 1e-12);
  for (const double u : {5.0, 6.2, 6.4, 7.5})
    for (const double v : {0.5, 3.0, 6.5})
      EXPECT_NEAR(distance(vector(part->Value(u, v)), surface::point(torus, surface::in_domain(torus, {u, v}))), 0,
                  1e-12);
}

}  // namespace
}  // namespace quadrille::occ
