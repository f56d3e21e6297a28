#include "occ/occ_section.hpp"

#include <gtest/gtest.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "occ/occ_face.hpp"
#include "occ/occ_model.hpp"
#include "occ/read_face.hpp"

namespace quadrille::occ {
namespace {

OccModel model_of(const TopoDS_Shape& shape) {
  OccModel model;
  model.shape = shape;
  for (TopExp_Explorer e(shape, TopAbs_FACE); e.More(); e.Next()) ++model.num_faces;
  for (TopExp_Explorer e(shape, TopAbs_SOLID); e.More(); e.Next()) ++model.num_solids;
  return model;
}

double area_of(const OccModel& model) {
  GProp_GProps measured;
  BRepGProp::SurfaceProperties(model.shape, measured);
  return std::abs(measured.Mass());
}

std::set<std::string> edge_names(const OccModel& model) {
  std::set<std::string> names;
  for (TopExp_Explorer e(model.shape, TopAbs_EDGE); e.More(); e.Next()) names.insert(model.label_of(e.Current()).name);
  return names;
}

cad::SectionPlane at_height(double z) { return {{0, 0, z}, {0, 0, 1}}; }

/// 4 x 3 x 2, with a hole of radius 0.5.
TopoDS_Shape drilled_box() {
  const gp_Ax2 axis(gp_Pnt(1, 1, 0), gp_Dir(0, 0, 1));
  return BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(4, 3, 2).Shape(), BRepPrimAPI_MakeCylinder(axis, 0.5, 2).Shape());
}

std::string error_of(const OccModel& model, const cad::SectionPlane& plane) {
  Report report;
  try {
    section(model, plane, "x.step", report);
  } catch (const FormatError& e) {
    return e.what();
  }
  return "no error";
}

TEST(Section, OfADrilledBoxIsAFaceWithAHole) {
  Report report;
  const OccModel cut = section(model_of(drilled_box()), at_height(0.7), "x.step", report);
  EXPECT_EQ(cut.num_faces, 1);
  EXPECT_EQ(cut.num_solids, 0);
  EXPECT_NEAR(area_of(cut), 12 - pi / 4, 1e-12);
  EXPECT_EQ(list_faces(cut).faces.front().edges.size(), 5U);
}

TEST(Section, EdgesAreNamedLikeTheFacesOfTheSolid) {
  Report report;
  OccModel model = model_of(drilled_box());
  std::string number_of_hole;
  const std::vector<TopoDS_Face> faces = faces_of(model);
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (kind_of(faces[f]) == "cylinder") number_of_hole = "face_" + std::to_string(f);
  std::set<std::string> names = edge_names(section(model, at_height(0.7), "x.step", report));
  EXPECT_EQ(names.size(), 5U);
  EXPECT_TRUE(names.contains(number_of_hole));
  for (const TopoDS_Face& face : faces)
    if (kind_of(face) == "cylinder") model.labels[face.TShape().get()] = {face, {"bore", "", ""}};
  names = edge_names(section(model, at_height(0.7), "x.step", report));
  EXPECT_TRUE(names.contains("bore"));
  EXPECT_FALSE(names.contains(number_of_hole));
}

TEST(Section, OfPlacedSolidsHasAFaceOfEachWithItsPart) {
  Report report;
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 1, 1).Shape();
  gp_Trsf move;
  move.SetTranslation(gp_Vec(1, 0, 0));
  TopoDS_Compound both;
  const BRep_Builder builder;
  builder.MakeCompound(both);
  builder.Add(both, box);
  builder.Add(both, box.Moved(move));
  OccModel model = model_of(both);
  model.parts[box.TShape().get()] = {{"brick"}, "2"};
  const OccModel cut = section(model, at_height(0.25), "x.step", report);
  const cad::FaceList list = list_faces(cut);
  ASSERT_EQ(list.faces.size(), 2U);
  EXPECT_EQ(list.faces[0].part, "brick");
  EXPECT_EQ(list.faces[1].part, "brick");
  EXPECT_EQ(list.faces[1].layer, "2");
  EXPECT_NEAR(list.faces[1].face.place[0] - list.faces[0].face.place[0], 1, 1e-12);
}

TEST(Section, OfTouchingSolidsHasRegionsWithACommonCurve) {
  Report report;
  TopoDS_Compound both;
  const BRep_Builder builder;
  builder.MakeCompound(both);
  builder.Add(both, BRepPrimAPI_MakeBox(1, 1, 1).Shape());
  builder.Add(both, BRepPrimAPI_MakeBox(gp_Pnt(1, 0, 0), 2, 1, 1).Shape());
  std::ostringstream bytes;
  BRepTools::Write(both, bytes);
  KernelFormat format = brep_format();
  format.cut = section;
  cad::LoadOptions options;
  options.section = at_height(0.5);
  const CadFace face = read_face(format, bytes.str(), "x.brep", options, report).face;
  EXPECT_EQ(face.num_regions(), 2);
  EXPECT_EQ(std::count_if(face.partners.begin(), face.partners.end(), [](int p) { return p >= 0; }), 2);
}

TEST(Section, ByASlantedPlaneIsAnEllipse) {
  Report report;
  const TopoDS_Shape solid = BRepPrimAPI_MakeCylinder(1, 10).Shape();
  const OccModel cut = section(model_of(solid), {{0, 0, 5}, {0, 0.6, 0.8}}, "x.step", report);
  EXPECT_NEAR(area_of(cut), pi / 0.8, 1e-10);
  EXPECT_TRUE(report.warnings().empty());
}

TEST(Section, OfATorusHasOneFaceOrTwo) {
  Report report;
  const OccModel model = model_of(BRepPrimAPI_MakeTorus(2, 0.5).Shape());
  EXPECT_EQ(section(model, at_height(0.1), "x.step", report).num_faces, 1);
  EXPECT_EQ(section(model, {{0, 0.1, 0}, {0, 1, 0}}, "x.step", report).num_faces, 2);
}

TEST(Section, CurvesLieOnTheSurfaces) {
  Report report;
  const OccModel model = model_of(BRepPrimAPI_MakeTorus(2, 0.5).Shape());
  const OccModel cut = section(model, {{0, 0.1, 0}, {0, 1, 0}}, "x.step", report);
  double worst = 0;
  for (TopExp_Explorer e(cut.shape, TopAbs_EDGE); e.More(); e.Next()) {
    const BRepAdaptor_Curve curve(TopoDS::Edge(e.Current()));
    for (int i = 0; i <= 200; ++i) {
      const gp_Pnt x = curve.Value(curve.FirstParameter() + (curve.LastParameter() - curve.FirstParameter()) * i / 200);
      const double r = std::hypot(x.X(), x.Y()) - 2;
      worst = std::max(worst, std::abs(std::hypot(r, x.Z()) - 0.5));
    }
  }
  EXPECT_LT(worst, 1e-6);
  ASSERT_EQ(report.warnings().size(), 1U);
  EXPECT_NE(report.warnings()[0].message.find("approximates them, up to"), std::string::npos);
}

TEST(Section, RefusesPlanesThatCutNothingOrLieInAFace) {
  const OccModel box = model_of(BRepPrimAPI_MakeBox(4, 3, 2).Shape());
  EXPECT_NE(error_of(box, at_height(5)).find("cuts no solid: along its normal the model reaches from -5 to -3"),
            std::string::npos);
  EXPECT_NE(error_of(box, at_height(2)).find("of a solid lies in the plane"), std::string::npos);
  const TopoDS_Shape face = TopExp_Explorer(box.shape, TopAbs_FACE).Current();
  EXPECT_NE(error_of(model_of(face), at_height(1)).find("the file holds none (1 face)"), std::string::npos);
}

}  // namespace
}  // namespace quadrille::occ
