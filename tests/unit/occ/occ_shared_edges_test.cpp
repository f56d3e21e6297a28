#include "occ/occ_shared_edges.hpp"

#include <gtest/gtest.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRep_Builder.hxx>
#include <Geom_Plane.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

namespace quadrille::occ {
namespace {

TopoDS_Face rectangle(double x0, double x1, double y0 = 0, double y1 = 1) {
  return BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), x0, x1, y0, y1).Face();
}

int number_of(TopAbs_ShapeEnum kind, const std::vector<TopoDS_Face>& faces) {
  TopTools_IndexedMapOfShape parts;
  for (const TopoDS_Face& face : faces) TopExp::MapShapes(face, kind, parts);
  return parts.Extent();
}

TEST(WithSharedEdges, edges_that_lie_upon_each_other_become_one) {
  for (const double gap : {0.0, 1e-7, -1e-7}) {
    const std::vector<TopoDS_Face> faces = with_shared_edges({rectangle(0, 1), rectangle(1 + gap, 2)}, 1e-6);
    EXPECT_EQ(number_of(TopAbs_EDGE, faces), 7) << gap;
    EXPECT_EQ(number_of(TopAbs_VERTEX, faces), 6) << gap;
    EXPECT_EQ(number_of(TopAbs_EDGE, {faces[1]}), 4) << gap;
  }
}

TEST(WithSharedEdges, others_stay) {
  EXPECT_EQ(number_of(TopAbs_EDGE, with_shared_edges({rectangle(0, 1), rectangle(1 + 1e-5, 2)}, 1e-6)), 8);
  const std::vector<TopoDS_Face> beside_a_part = with_shared_edges({rectangle(0, 1), rectangle(1, 2, 0, 0.5)}, 1e-6);
  EXPECT_EQ(number_of(TopAbs_EDGE, beside_a_part), 8);
  EXPECT_EQ(number_of(TopAbs_VERTEX, beside_a_part), 7);
}

/// A rectangle whose right side is an arc.
TopoDS_Face bulged(double bulge) {
  const gp_Pnt a(0, 0, 0), b(1, 0, 0), c(1, 1, 0), d(0, 1, 0);
  const TopoDS_Edge bottom = BRepBuilderAPI_MakeEdge(a, b), top = BRepBuilderAPI_MakeEdge(c, d),
                    left = BRepBuilderAPI_MakeEdge(d, a);
  const double radius = (0.25 + bulge * bulge) / (2 * bulge);
  const gp_Circ circle(gp_Ax2(gp_Pnt(1 + bulge - radius, 0.5, 0), gp_Dir(0, 0, 1)), radius);
  const TopoDS_Edge right = BRepBuilderAPI_MakeEdge(circle, b, c);
  BRepBuilderAPI_MakeWire wire(bottom, right, top, left);
  return BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), wire.Wire()).Face();
}

TEST(WithSharedEdges, curves_with_the_same_ends_may_be_apart_between_them) {
  EXPECT_EQ(number_of(TopAbs_EDGE, with_shared_edges({rectangle(1, 2), bulged(0.01)}, 1e-6)), 8);
  EXPECT_EQ(number_of(TopAbs_EDGE, with_shared_edges({rectangle(1, 2), bulged(0.01)}, 0.02)), 7);
}

TopoDS_Edge circle_about(const gp_Dir& axis, double radius) {
  return BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(0, 0, 0), axis, gp_Dir(1, 0, 0)), radius));
}

/// Of the travel of the only edge of this radius round the origin, from its orientation.
bool is_counter_clockwise(const TopoDS_Face& face, double radius) {
  for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) {
    const BRepAdaptor_Curve curve(TopoDS::Edge(e.Current()));
    gp_Pnt p;
    gp_Vec tangent;
    curve.D1(1, p, tangent);
    if (std::abs(p.Distance(gp_Pnt(0, 0, 0)) - radius) > 1e-9) continue;
    const bool is_forward = e.Current().Orientation() == TopAbs_FORWARD;
    return (gp_Vec(gp_Pnt(0, 0, 0), p).Crossed(tangent).Z() > 0) == is_forward;
  }
  throw std::runtime_error("no such circle");
}

TEST(WithSharedEdges, closed_edges_keep_their_sense) {
  const gp_Pln plane(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));
  const TopoDS_Face disc =
      BRepBuilderAPI_MakeFace(plane, BRepBuilderAPI_MakeWire(circle_about({0, 0, 1}, 1)).Wire()).Face();
  for (const bool is_turned : {false, true}) {
    const TopoDS_Wire hole = BRepBuilderAPI_MakeWire(circle_about({0, 0, is_turned ? -1. : 1.}, 1)).Wire();
    BRepBuilderAPI_MakeFace ring(plane, BRepBuilderAPI_MakeWire(circle_about({0, 0, 1}, 2)).Wire());
    ring.Add(is_turned ? hole : TopoDS::Wire(hole.Reversed()));
    ASSERT_FALSE(is_counter_clockwise(ring.Face(), 1));
    const std::vector<TopoDS_Face> faces = with_shared_edges({disc, ring.Face()}, 1e-6);
    EXPECT_EQ(number_of(TopAbs_EDGE, faces), 2);
    EXPECT_TRUE(is_counter_clockwise(faces[0], 1));
    EXPECT_FALSE(is_counter_clockwise(faces[1], 1)) << is_turned;
  }
}

/// A triangle whose edges have a vertex of their own at each end, `gap` apart.
TopoDS_Face loose_triangle(double gap) {
  const std::vector<gp_Pnt> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  TopoDS_Face face;
  TopoDS_Wire wire;
  const BRep_Builder builder;
  builder.MakeFace(face, new Geom_Plane(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 1e-7);
  builder.MakeWire(wire);
  for (int k = 0; k < 3; ++k)
    builder.Add(wire, BRepBuilderAPI_MakeEdge(corners[k].Translated(gp_Vec(0, 0, gap)), corners[(k + 1) % 3]).Edge());
  builder.Add(face, wire);
  return face;
}

TEST(WithSharedVertices, edges_of_a_wire_meet) {
  EXPECT_EQ(number_of(TopAbs_VERTEX, {loose_triangle(1e-7)}), 6);
  EXPECT_EQ(number_of(TopAbs_VERTEX, {with_shared_vertices(loose_triangle(1e-7), 1e-6)}), 3);
  EXPECT_EQ(number_of(TopAbs_VERTEX, {with_shared_vertices(loose_triangle(1e-5), 1e-6)}), 6);
}

}  // namespace
}  // namespace quadrille::occ
