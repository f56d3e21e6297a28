#include "occ/occ_completed_face.hpp"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille::occ {
namespace {

TopoDS_Wire circle(double z, double radius, bool is_reversed) {
  const gp_Circ c(gp_Ax2(gp_Pnt(0, 0, z), gp_Dir(0, 0, 1)), radius);
  const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(c)).Wire();
  return is_reversed ? TopoDS::Wire(wire.Reversed()) : wire;
}

TopoDS_Face face(const Handle(Geom_Surface) & surface, const std::vector<TopoDS_Wire>& wires) {
  TopoDS_Face result;
  const BRep_Builder builder;
  builder.MakeFace(result, surface, 1e-7);
  for (const TopoDS_Wire& wire : wires) builder.Add(result, wire);
  return result;
}

struct Edges {
  int num = 0, num_seams = 0, num_poles = 0;  ///< uses
};

/// All have a curve in the parameters of the surface.
Edges edges_of(const TopoDS_Face& face) {
  Edges edges;
  for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next(), ++edges.num) {
    const TopoDS_Edge edge = TopoDS::Edge(e.Current());
    double first = 0, last = 0;
    EXPECT_FALSE(BRep_Tool::CurveOnSurface(edge, face, first, last).IsNull());
    edges.num_seams += BRep_Tool::IsClosed(edge, face);
    edges.num_poles += BRep_Tool::Degenerated(edge);
  }
  return edges;
}

TEST(Completed, tubes_get_a_seam_and_caps_a_pole) {
  const Edges tube = edges_of(
      completed(face(new Geom_CylindricalSurface(gp_Ax3(), 1), {circle(0, 1, false), circle(1, 1, true)}), "a.step"));
  EXPECT_EQ(tube.num, 4);
  EXPECT_EQ(tube.num_seams, 2);
  EXPECT_EQ(tube.num_poles, 0);
  const Edges cap =
      edges_of(completed(face(new Geom_SphericalSurface(gp_Ax3(), 1), {circle(0.8, 0.6, false)}), "a.step"));
  EXPECT_EQ(cap.num, 4);
  EXPECT_EQ(cap.num_seams, 2);
  EXPECT_EQ(cap.num_poles, 1);
}

TEST(BoxDiagonal, is_that_of_the_face) {
  EXPECT_NEAR(box_diagonal(BRepBuilderAPI_MakeFace(gp_Pln(), 0, 3, 0, 4).Face()), 5, 1e-6);
  TopoDS_Face without_surface;
  BRep_Builder().MakeFace(without_surface);
  EXPECT_EQ(message_of<FormatError>([&] { box_diagonal(without_surface); }), "the face has no extent");
}

}  // namespace
}  // namespace quadrille::occ
