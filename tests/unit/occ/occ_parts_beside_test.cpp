#include "occ/occ_parts_beside.hpp"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <gp_Pln.hxx>

namespace quadrille::occ {
namespace {

TEST(PartsBeside, are_in_no_face_and_not_of_the_chosen_ones) {
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(gp_Pln(), 0, 1, 0, 1).Face();
  const TopoDS_Shape side = TopExp_Explorer(face, TopAbs_EDGE).Current();
  const TopoDS_Edge other = BRepBuilderAPI_MakeEdge(gp_Pnt(5, 0, 0), gp_Pnt(6, 0, 0));
  TopoDS_Compound model;
  const BRep_Builder builder;
  builder.MakeCompound(model);
  for (const TopoDS_Shape& part : {TopoDS_Shape(face), side.Reversed(), TopoDS_Shape(other)}) builder.Add(model, part);

  const std::vector<TopoDS_Shape> beside = parts_beside(model, TopAbs_EDGE, TopAbs_FACE, {face});
  ASSERT_EQ(beside.size(), 1U);
  EXPECT_TRUE(beside[0].IsSame(other));
  EXPECT_EQ(parts_beside(model, TopAbs_EDGE, TopAbs_FACE, {}).size(), 2U) << "listed of its own";
  EXPECT_TRUE(parts_beside(model, TopAbs_VERTEX, TopAbs_EDGE, {face}).empty());
}

}  // namespace
}  // namespace quadrille::occ
