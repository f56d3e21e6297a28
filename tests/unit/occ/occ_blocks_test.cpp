#include "occ/occ_blocks.hpp"

#include <gtest/gtest.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <map>

#include "../hand_made.hpp"
#include "../region_samples.hpp"

namespace quadrille::occ {
namespace {

TopTools_IndexedMapOfShape parts(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape found;
  TopExp::MapShapes(shape, kind, found);
  return found;
}

std::map<GeomAbs_CurveType, int> kinds_of(const TopoDS_Shape& shape) {
  std::map<GeomAbs_CurveType, int> kinds;
  const TopTools_IndexedMapOfShape edges = parts(shape, TopAbs_EDGE);
  for (int i = 1; i <= edges.Extent(); ++i) ++kinds[BRepAdaptor_Curve(TopoDS::Edge(edges(i))).GetType()];
  return kinds;
}

TEST(OccFaceShape, curves_are_edges_in_the_unit_of_the_shape) {
  CadFace face = hand_made::quarter_annulus().face;
  face.plane_origin = {0, 0, 5};
  const TopoDS_Shape shape = occ_face_shape(face, 10).shape;
  EXPECT_EQ(shape.ShapeType(), TopAbs_FACE);
  EXPECT_EQ(parts(shape, TopAbs_VERTEX).Extent(), 4);
  EXPECT_EQ(kinds_of(shape), (std::map<GeomAbs_CurveType, int>{{GeomAbs_Line, 2}, {GeomAbs_Circle, 2}}));
  const TopTools_IndexedMapOfShape vertices = parts(shape, TopAbs_VERTEX);
  for (int i = 1; i <= vertices.Extent(); ++i) {
    const gp_Pnt p = BRep_Tool::Pnt(TopoDS::Vertex(vertices(i)));
    EXPECT_NEAR(p.Z(), 50, 1e-13);
    EXPECT_TRUE(std::abs(p.X() + p.Y() - 10) < 1e-12 || std::abs(p.X() + p.Y() - 20) < 1e-12);
  }
}

/// An ellipse is a rational parabola too, but no circle.
TEST(OccFaceShape, other_curves_are_splines) {
  CadFace face = hand_made::quarter_annulus().face;
  for (Nurbs& curve : face.curves)
    for (Vec2& pole : curve.poles) pole.x *= 1.001;
  EXPECT_EQ(kinds_of(occ_face_shape(face, 1).shape),
            (std::map<GeomAbs_CurveType, int>{{GeomAbs_Line, 2}, {GeomAbs_BSplineCurve, 2}}));
}

TEST(OccFaceShape, given_names_alone_are_kept) {
  CadFace face = hand_made::unit_square().face;
  face.name = "lid";
  face.unnamed_curves = {0, 2};
  const OccShape shape = occ_face_shape(face, 1);
  std::vector<std::string> names;
  for (const auto& [named, name] : shape.names) names.push_back(name);
  EXPECT_EQ(names, (std::vector<std::string>{face.curve_names[1], face.curve_names[3], "lid"}));
}

TEST(OccFaceShape, regions_share_the_edges_between_them) {
  const CadFace face = samples::two_regions_mesh().face;
  const TopoDS_Shape shape = occ_face_shape(face, 1).shape;
  EXPECT_EQ(shape.ShapeType(), TopAbs_SHELL);
  EXPECT_EQ(parts(shape, TopAbs_FACE).Extent(), 2);
  EXPECT_EQ(parts(shape, TopAbs_EDGE).Extent(), 7);
  EXPECT_EQ(parts(shape, TopAbs_VERTEX).Extent(), 6);
}

TEST(OccFaceShape, slits_are_free_edges_each_once) {
  CadFace face = hand_made::unit_square().face;
  const Nurbs slit = curve::segment({0.25, 0.5}, {0.75, 0.5});
  face.curves.insert(face.curves.end(), {slit, curve::reversed(slit)});
  face.curve_names.insert(face.curve_names.end(), {"slit", "slit"});
  face.loop_offsets.push_back(6);
  face.partners = {-1, -1, -1, -1, 5, 4};
  const TopoDS_Shape shape = occ_face_shape(face, 1).shape;
  ASSERT_EQ(shape.ShapeType(), TopAbs_COMPOUND);
  std::vector<TopAbs_ShapeEnum> kinds;
  for (TopoDS_Iterator part(shape); part.More(); part.Next()) kinds.push_back(part.Value().ShapeType());
  EXPECT_EQ(kinds, (std::vector<TopAbs_ShapeEnum>{TopAbs_FACE, TopAbs_EDGE}));
  EXPECT_EQ(parts(shape, TopAbs_EDGE).Extent(), 5);
}

}  // namespace
}  // namespace quadrille::occ
