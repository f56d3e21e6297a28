#include "occ/occ_space_edges.hpp"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Plane.hxx>
#include <TopLoc_Location.hxx>
#include <cmath>

#include "../support/texts.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::occ {
namespace {

const Handle(Geom_Curve) circle = new Geom_Circle(gp_Ax2({1, 2, 3}, {1, 1, 1}), 2);

TopoDS_Edge arc(double first, double last, const Handle(Geom_Curve) & curve = circle) {
  TopoDS_Edge edge;
  const BRep_Builder builder;
  builder.MakeEdge(edge, curve, 1e-7);
  builder.Range(edge, first, last);
  return edge;
}

TopoDS_Edge without_curve() {
  TopoDS_Edge edge;
  BRep_Builder().MakeEdge(edge);
  return edge;
}

TEST(FaceEdges, parts_have_the_number_of_their_edge) {
  const FaceEdges edges({arc(0, pi), arc(pi, 2 * pi), without_curve()});
  EXPECT_EQ(edges.size(), 3);
  EXPECT_EQ(edges.number_of(arc(1, 2)), 0);
  EXPECT_EQ(edges.number_of(arc(4, 5)), 1);
  EXPECT_EQ(edges.number_of(arc(2 * pi + 0.5, 2 * pi + 1)), 0) << "a period away";
  EXPECT_EQ(edges.number_of(arc(-1, -0.5)), 1);
  EXPECT_EQ(edges.number_of(arc(1, 2, new Geom_Circle(gp_Ax2(), 2))), -1) << "of another curve";
  EXPECT_EQ(edges.number_of(without_curve()), -1);
}

TEST(FaceEdges, gaps_between_edges_have_no_number) {
  EXPECT_EQ(FaceEdges({arc(0, 1), arc(2, 3)}).number_of(arc(1.2, 1.8)), -1);
}

TEST(ConvertedCurve, arcs_are_exact_and_keep_their_points) {
  const TopoDS_Edge edge = arc(0.2, 6);
  const ConvertedCurve converted(edge, 0.5, 4, 1e-3);
  EXPECT_EQ(converted.error(), 0);
  for (const double t : {0.5, 0.7, 1.9, 3.3, 4.0}) {
    const gp_Pnt p = circle->Value(t);
    EXPECT_LT(distance(surface::point(converted.curve(), converted.parameter(t)), {p.X(), p.Y(), p.Z()}), 1e-13) << t;
  }
  EXPECT_EQ(converted.parameter(0.1), converted.curve().begin());
  EXPECT_EQ(converted.parameter(5), converted.curve().end());
}

TEST(ConvertedCurve, lines_have_their_length_as_parameter) {
  const ConvertedCurve line(BRepBuilderAPI_MakeEdge(gp_Pnt(1, 0, 0), gp_Pnt(1, 3, 4)).Edge(), 1, 4, 1e-3);
  EXPECT_EQ(line.curve().degree, 1);
  EXPECT_NEAR(line.curve().end(), 3, 1e-15);
  EXPECT_LT(distance(line.curve().poles.front(), {1, 0.6, 0.8}), 1e-15);
  EXPECT_NEAR(line.parameter(2), 1, 1e-15);
}

TEST(ConvertedCurve, edges_without_a_curve_are_refused) {
  EXPECT_EQ(message_of<FormatError>([] { ConvertedCurve(without_curve(), 0, 1, 1e-3); }), "it has no curve");
}

TEST(RequireCurve, makes_the_curve_from_the_parameters_of_the_surface) {
  TopoDS_Edge edge = without_curve();
  const BRep_Builder builder;
  builder.UpdateEdge(edge, new Geom2d_Line(gp_Pnt2d(1, 0), gp_Dir2d(0, 1)),
                     new Geom_Plane(gp_Pnt(0, 0, 5), gp_Dir(0, 0, 1)), TopLoc_Location(), 1e-7);
  builder.Range(edge, 0, 2);
  require_curve(edge);
  double first = 0, last = 0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
  ASSERT_FALSE(curve.IsNull());
  EXPECT_LT(curve->Value(last).Distance(gp_Pnt(1, 2, 5)), 1e-15);
}

TEST(LabelsOf, are_those_of_the_model) {
  const TopoDS_Edge edge = arc(0, 1);
  OccModel model;
  model.labels[edge.TShape().get()] = {edge, {"rim", "wet", "ff0000"}};
  const heal::RawEdge labels = labels_of(model, edge, 7), none = labels_of(model, arc(0, 1), 8);
  EXPECT_EQ(labels.cad_edge, 7);
  EXPECT_EQ(labels.name, "rim");
  EXPECT_EQ(labels.layer, "wet");
  EXPECT_EQ(labels.colour, "ff0000");
  EXPECT_EQ(none.name, "");
}

}  // namespace
}  // namespace quadrille::occ
