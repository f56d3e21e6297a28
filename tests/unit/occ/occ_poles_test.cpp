#include "occ/occ_poles.hpp"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_SphericalSurface.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Circ.hxx>

#include "base/angle.hpp"

namespace quadrille::occ {
namespace {

/// A quarter of the unit sphere, between the half circles z = 0, y > 0 and y = 0, z > 0, with its poles on this axis.
TopoDS_Face quarter(const gp_Dir& axis) {
  const gp_Pnt right(1, 0, 0), left(-1, 0, 0);
  const gp_Circ equator(gp_Ax2({0, 0, 0}, {0, 0, 1}, {1, 0, 0}), 1),
      meridian(gp_Ax2({0, 0, 0}, {0, 1, 0}, {-1, 0, 0}), 1);
  const TopoDS_Edge a = BRepBuilderAPI_MakeEdge(equator, right, left);
  const TopoDS_Edge b = BRepBuilderAPI_MakeEdge(meridian, TopExp::LastVertex(a), TopExp::FirstVertex(a));
  TopoDS_Face face;
  const BRep_Builder builder;
  builder.MakeFace(face, new Geom_SphericalSurface(gp_Ax3({0, 0, 0}, axis), 1), 1e-7);
  builder.Add(face, BRepBuilderAPI_MakeWire(a, b).Wire());
  return face;
}

TopTools_IndexedMapOfShape parts(const TopoDS_Face& face, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape result;
  TopExp::MapShapes(face, kind, result);
  return result;
}

TEST(SplitAtPoles, edges_have_a_vertex_where_they_run_through_a_pole) {
  const TopoDS_Face split = split_at_poles(quarter({0, 0, 1}));
  const TopTools_IndexedMapOfShape edges = parts(split, TopAbs_EDGE);
  ASSERT_EQ(edges.Extent(), 3);
  EXPECT_EQ(parts(split, TopAbs_VERTEX).Extent(), 3);
  double first = 0, last = 0;
  for (const int part : {2, 3}) {
    BRep_Tool::Range(TopoDS::Edge(edges(part)), first, last);
    EXPECT_NEAR(first, part == 2 ? 0 : half_pi, 1e-12);
    EXPECT_NEAR(last, part == 2 ? half_pi : pi, 1e-12);
  }
}

TEST(SplitAtPoles, poles_off_the_edges_or_at_their_ends_change_nothing) {
  for (const gp_Dir& axis : {gp_Dir(1, 0, 0), gp_Dir(1, 1, 1)}) {
    const TopoDS_Face face = quarter(axis);
    EXPECT_TRUE(split_at_poles(face).IsSame(face));
  }
}

}  // namespace
}  // namespace quadrille::occ
