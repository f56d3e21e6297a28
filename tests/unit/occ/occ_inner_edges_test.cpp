#include "occ/occ_inner_edges.hpp"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <cmath>
#include <gp_Circ.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Lin.hxx>

#include "base/warning_codes.hpp"

namespace quadrille::occ {
namespace {

/// A part of a cylinder of radius 1, two radians wide and one high, with edges beside it.
struct InnerEdges : testing::Test {
  InnerEdges() {
    face = BRepBuilderAPI_MakeFace(gp_Cylinder(gp_Ax3(), 1), 0, 2, 0, 1).Face();
    builder.MakeCompound(compound);
    builder.Add(compound, face);
    model.shape = compound;
  }
  void add(const TopoDS_Edge& edge, const std::string& name = "") {
    builder.Add(compound, edge);
    if (!name.empty()) model.labels[edge.TShape().get()] = {edge, {name, "", ""}};
    model.shape = compound;
  }
  static gp_Pnt at(double angle, double z) { return {std::cos(angle), std::sin(angle), z}; }
  UnitedFace with_edges() {
    const std::vector<FaceChoice> choices{{face, {}}};
    UnitedFace united = united_face(model, choices, "a.step", 1e-6);
    add_edges_inside(model, choices, "a.step", 1e-6, united, report);
    return united;
  }

  BRep_Builder builder;
  TopoDS_Face face;
  TopoDS_Compound compound;
  OccModel model;
  Report report;
};

TEST_F(InnerEdges, edges_on_the_face_are_inner_ones) {
  add(BRepBuilderAPI_MakeEdge(at(1, 0.2), at(1, 0.7)), "crack");
  add(BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2({0, 0, 0.5}, {0, 0, 1}), 1), 0, 0.7));
  const UnitedFace united = with_edges();
  ASSERT_EQ(united.inner.size(), 2U);
  EXPECT_EQ(united.inner[0].labels.name, "crack");
  EXPECT_EQ(united.inner[0].labels.cad_edge, 4) << "after those of the face";
  EXPECT_EQ(united.inner[1].labels.cad_edge, 5);
  EXPECT_TRUE(report.warnings().empty());
}

TEST_F(InnerEdges, others_are_ignored_with_a_warning) {
  add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(0, 0, 1)));   // the axis
  add(BRepBuilderAPI_MakeEdge(at(1, 0.5), at(1, 1.5)));             // sticks out
  add(BRepBuilderAPI_MakeEdge(at(2, 0), at(2, 1)));                 // along the boundary
  add(BRepBuilderAPI_MakeEdge(at(0.5, 0.5), at(1.5, 0.5)));         // a chord
  add(BRepBuilderAPI_MakeEdge(gp_Lin(at(1, 0), gp_Dir(0, 0, 1))));  // infinite
  EXPECT_TRUE(with_edges().inner.empty());
  ASSERT_EQ(report.warnings().size(), 1U);
  EXPECT_EQ(report.warnings()[0].code, warning::curves_ignored);
  EXPECT_EQ(report.warnings()[0].message, "a.step: ignored 5 curves beside the face");
}

}  // namespace
}  // namespace quadrille::occ
