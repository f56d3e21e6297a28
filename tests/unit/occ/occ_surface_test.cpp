#include "occ/occ_surface.hpp"

#include <gtest/gtest.h>

#include <BRep_Builder.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <cmath>
#include <numbers>

#include "base/angle.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::occ {
namespace {

double greatest_deviation(const ConvertedSurface& surface, const ParameterBox& box) {
  double greatest = 0;
  for (const double f : {0.0, 0.2, 0.55, 1.0})
    for (const double g : {0.0, 0.35, 0.8, 1.0})
      greatest = std::max(greatest, surface.deviation({std::lerp(box.u0, box.u1, f), std::lerp(box.v0, box.v1, g)}));
  return greatest;
}

TEST(ConvertedSurface, quadrics_and_tori_are_exact) {
  const ParameterBox box{0.2, 1.9, -1, 0.5};
  for (const Handle(Geom_Surface) & surface : std::initializer_list<Handle(Geom_Surface)>{
           new Geom_Plane(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 1)), new Geom_CylindricalSurface(gp_Ax3(), 2),
           new Geom_ConicalSurface(gp_Ax3(), 0.5, 2), new Geom_SphericalSurface(gp_Ax3(), 2),
           new Geom_ToroidalSurface(gp_Ax3(), 3, 1)})
    EXPECT_LT(greatest_deviation(ConvertedSurface(surface, box, 1e-3), box), 1e-13);
}

TEST(ConvertedSurface, is_a_little_larger_than_the_face) {
  const NurbsSurface spline = ConvertedSurface(new Geom_CylindricalSurface(gp_Ax3(), 2), {1, 2, 0, 3}, 1e-3).spline();
  EXPECT_NEAR(spline.knots_u.front(), 0.95, 1e-12);
  EXPECT_NEAR(spline.knots_u.back(), 2.05, 1e-12);
  EXPECT_NEAR(spline.knots_v.front(), -0.15, 1e-12);
  EXPECT_NEAR(spline.knots_v.back(), 3.15, 1e-12);
}

TEST(ConvertedSurface, both_ends_leave_a_part_of_the_period_between_them) {
  const double gap = 0.03;
  const NurbsSurface spline =
      ConvertedSurface(new Geom_CylindricalSurface(gp_Ax3(), 2), {0, 2 * pi - gap, 0, 1}, 1e-3).spline();
  EXPECT_FALSE(spline.is_closed_u);
  EXPECT_NEAR(spline.knots_u.back() - spline.knots_u.front(), 2 * pi - gap / 3, 1e-12);
}

TEST(ConvertedSurface, is_whole_where_the_face_goes_all_the_way_round) {
  const ConvertedSurface tube(new Geom_CylindricalSurface(gp_Ax3(), 2), {1, 1 + 2 * pi, 0, 1}, 1e-3);
  EXPECT_TRUE(tube.spline().is_closed_u);
  EXPECT_FALSE(tube.spline().is_closed_v);
  EXPECT_NEAR(tube.spline().knots_u.front(), 0, 1e-15);
  EXPECT_NEAR(tube.spline().knots_u.back(), 2 * pi, 1e-14);
  const Vec2 once = tube.spline_parameters({0.7, 0.5}), again = tube.spline_parameters({0.7 - 2 * pi, 0.5});
  EXPECT_NEAR(again.x, once.x - 2 * pi, 1e-12);
  EXPECT_LT(tube.deviation({0.7, 0.5}), 1e-13);
  EXPECT_GT(std::abs(once.x - 0.7), 1e-4) << "arcs have other parameters than angles";
}

TEST(ConvertedSurface, ends_at_a_pole_or_an_apex) {
  const NurbsSurface cap =
      ConvertedSurface(new Geom_SphericalSurface(gp_Ax3(), 1), {0, 1, 1, half_pi + 1e-12}, 1e-3).spline();
  EXPECT_EQ(cap.knots_v.back(), half_pi);
  const Handle(Geom_Surface) cone = new Geom_ConicalSurface(gp_Ax3(), pi / 4, 1);
  const double apex = -std::numbers::sqrt2;
  EXPECT_NEAR(ConvertedSurface(cone, {0, 1, apex, 1}, 1e-3).spline().knots_v.front(), apex, 1e-12);
  const double near = ConvertedSurface(cone, {0, 1, apex + 0.01, 1}, 1e-3).spline().knots_v.front();
  EXPECT_GT(near, apex);
  EXPECT_LT(near, apex + 0.01) << "the normal turns over beyond the apex";
}

TEST(ConvertedSurface, others_are_approximated_within_the_tolerance) {
  const Handle(Geom_Surface) tube =
      new Geom_SurfaceOfLinearExtrusion(new Geom_Ellipse(gp_Ax2(), 3, 1), gp_Dir(0, 0, 1));
  const ParameterBox box{0, 1.5, 0, 2};
  EXPECT_LT(greatest_deviation(ConvertedSurface(tube, box, 1e-3), box), 1e-13) << "an extrusion is exact";
  const double tolerance = 1e-5;
  EXPECT_LT(greatest_deviation(ConvertedSurface(new Geom_OffsetSurface(tube, 0.5), box, tolerance), box),
            2 * tolerance);
}

TEST(BasisSurface, trims_and_offsets_of_quadrics_are_left_out) {
  const Handle(Geom_Surface) cylinder = new Geom_CylindricalSurface(gp_Ax3(), 2);
  const Handle(Geom_Surface) offset =
      new Geom_OffsetSurface(new Geom_RectangularTrimmedSurface(cylinder, 0., 2., 0., 3.), 1);
  TopoDS_Face face;
  BRep_Builder().MakeFace(face, new Geom_RectangularTrimmedSurface(offset, 0., 1., 0., 1.), 1e-7);
  const auto basis = Handle(Geom_CylindricalSurface)::DownCast(basis_surface(face));
  ASSERT_FALSE(basis.IsNull());
  EXPECT_NEAR(basis->Radius(), 3, 1e-15);
  TopoDS_Face without_surface;
  BRep_Builder().MakeFace(without_surface);
  EXPECT_TRUE(basis_surface(without_surface).IsNull());
}

}  // namespace
}  // namespace quadrille::occ
