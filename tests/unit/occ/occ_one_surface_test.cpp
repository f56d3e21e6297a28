#include "occ/occ_one_surface.hpp"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRep_Builder.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <cmath>
#include <gp_Circ.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>

#include "base/vec3.hpp"

namespace quadrille::occ {
namespace {

/// A part about an axis that points up or down.
TopoDS_Face tube(double radius, double from, double to, double up = 1) {
  return BRepBuilderAPI_MakeFace(gp_Cylinder(gp_Ax3({0, 0, 0}, {0, 0, up}, {1, 0, 0}), radius), from, to, 0, 1).Face();
}

TopoDS_Face rectangle(const gp_Dir& normal) {
  return BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 0), normal), 0, 3, 0, 4).Face();
}

/// Bounded by the circle about the z axis of radius 0.6 at z = 0.8 alone.
TopoDS_Face inside_circle(const Handle(Geom_Surface) & surface) {
  TopoDS_Face face;
  const BRep_Builder builder;
  builder.MakeFace(face, surface, 1e-7);
  const gp_Circ circle(gp_Ax2(gp_Pnt(0, 0, 0.8), gp_Dir(0, 0, 1)), 0.6);
  builder.Add(face, BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle)).Wire());
  return face;
}

TEST(GapFromSurface, parts_of_one_surface_have_none) {
  EXPECT_LT(gap_from_surface(tube(2, 0, 1), tube(2, 3, 4)).distance, 1e-12);
  EXPECT_LT(gap_from_surface(tube(2, 0, 1), tube(2, 3, 4, -1)).distance, 1e-12) << "from another entity";
}

TEST(GapFromSurface, is_the_greatest_with_its_place) {
  EXPECT_NEAR(gap_from_surface(tube(2, 0, 1), tube(1.9, 0, 1)).distance, 0.1, 1e-12);
  const SurfaceGap gap = gap_from_surface(rectangle({0, 0, 1}), rectangle({0, -0.01, 1}));
  EXPECT_NEAR(gap.distance, 4 * std::sin(std::atan(0.01)), 1e-12);
  EXPECT_NEAR(gap.position.y, 4, 1e-12);
}

/// The circle is a meridian circle of no pole in the plane, and round the pole of both spheres.
TEST(GapFromSurface, surfaces_that_meet_in_all_edges_are_two) {
  const TopoDS_Face cap = inside_circle(new Geom_SphericalSurface(gp_Ax3(), 1)),
                    turned = inside_circle(new Geom_SphericalSurface(gp_Ax3({0, 0, 1.6}, {0, 0, 1}), 1)),
                    disc = inside_circle(new Geom_Plane(gp_Pnt(0, 0, 0.8), gp_Dir(0, 0, 1)));
  EXPECT_NEAR(gap_from_surface(disc, cap).distance, 0.2, 1e-9);
  EXPECT_GT(gap_from_surface(cap, disc).distance, 0.1);
  EXPECT_GT(gap_from_surface(cap, turned).distance, 0.1);
}

TEST(HasOppositeNormal, is_about_the_surfaces) {
  EXPECT_FALSE(has_opposite_normal(rectangle({0, 0, 1}), rectangle({0, 0, 1})));
  EXPECT_TRUE(has_opposite_normal(rectangle({0, 0, 1}), rectangle({0, 0, -1})));
  EXPECT_FALSE(has_opposite_normal(tube(2, 0, 1), tube(2, 3, 4, -1))) << "both point outwards";
}

TEST(ExtentOfEdges, is_the_diagonal_of_their_box) {
  EXPECT_NEAR(extent_of_edges(rectangle({0, 0, 1})), 5, 1e-12);
  TopoDS_Face empty;
  BRep_Builder().MakeFace(empty);
  EXPECT_EQ(extent_of_edges(empty), 0);
}

TEST(SameSurfaceTolerance, is_that_of_the_file_or_of_the_size) {
  EXPECT_EQ(same_surface_tolerance(rectangle({0, 0, 1}), 1e-3), 1e-3);
  EXPECT_NEAR(same_surface_tolerance(rectangle({0, 0, 1}), 1e-9), 5e-7, 1e-15);
}

}  // namespace
}  // namespace quadrille::occ
