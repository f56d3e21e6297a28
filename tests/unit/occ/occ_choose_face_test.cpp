#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESBasic_Name.hxx>
#include <IGESControl_Writer.hxx>
#include <IGESData_IGESModel.hxx>
#include <IGESData_LevelListEntity.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Writer.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <sstream>

#include "../support/test_data.hpp"
#include "../support/texts.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "cad/load_face.hpp"
#include "curve/nurbs.hpp"
#include "occ/occ_quiet.hpp"

namespace quadrille::occ {
namespace {

const std::vector<gp_Pnt> corners{{0, 0, 0}, {4, 0, 0}, {0, 2, 0}};
const gp_Pnt hole_centre(0.8, 0.6, 0);
constexpr double radius = 0.25;

/// A right triangle without symmetry, with a round hole.
TopoDS_Shape part() {
  BRepBuilderAPI_MakePolygon outline(corners[0], corners[1], corners[2], true);
  BRepBuilderAPI_MakeFace face(gp_Pln(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), outline.Wire());
  const gp_Circ circle(gp_Ax2(hole_centre, gp_Dir(0, 0, 1)), radius);
  face.Add(TopoDS::Wire(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle)).Wire().Reversed()));
  return face.Face();
}

TopoDS_Shape group(const std::vector<TopoDS_Shape>& parts) {
  TopoDS_Compound compound;
  BRep_Builder builder;
  builder.MakeCompound(compound);
  for (const TopoDS_Shape& p : parts) builder.Add(compound, p);
  return compound;
}

TopoDS_Shape placed(const TopoDS_Shape& shape, const gp_Trsf& placement) { return shape.Moved(placement, false); }

gp_Trsf turn() {
  gp_Trsf turned, shifted;
  turned.SetRotation(gp_Ax1(gp_Pnt(1, 0, 0), gp_Dir(1, 2, 2)), 0.7);
  shifted.SetTranslation(gp_Vec(10, -3, 5));
  return shifted * turned;
}

gp_Trsf mirror() {
  gp_Trsf mirrored;
  mirrored.SetMirror(gp_Ax2(gp_Pnt(0.5, 0, 0), gp_Dir(1, 0.5, 0)));
  return mirrored;
}

gp_Trsf lift() {
  gp_Trsf lifted;
  lifted.SetTranslation(gp_Vec(0, 0, 7));
  return lifted;
}

/// The part as it is, and an assembly of a turned part and of a group that holds a lifted and a mirrored one.
TopoDS_Shape assembly(bool is_mirrored = true) {
  const TopoDS_Shape p = part();
  const TopoDS_Shape inner = group({placed(p, lift()), placed(p, is_mirrored ? mirror() : turn())});
  return group({p, placed(group({p, placed(inner, turn())}), turn())});
}

/// Where the parts of the assembly lie, in its order.
std::vector<gp_Trsf> placements(bool is_mirrored = true) {
  return {gp_Trsf(), turn(), turn() * turn() * lift(), turn() * turn() * (is_mirrored ? mirror() : turn())};
}

std::string brep(const TopoDS_Shape& shape) {
  std::ostringstream stream;
  BRepTools::Write(shape, stream);
  return stream.str();
}

std::string step(const TopoDS_Shape& shape) {
  quiet_kernel();
  STEPControl_Writer writer;
  Interface_Static::SetIVal("write.step.assembly", 1);
  writer.Transfer(shape, STEPControl_AsIs);
  const std::string path = testing::TempDir() + "quadrille_assembly.step";
  writer.Write(path.c_str());
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  std::remove(path.c_str());
  return text.str();
}

std::string iges(const TopoDS_Shape& shape) {
  quiet_kernel();
  IGESControl_Writer writer("MM", 0);
  writer.AddShape(shape);
  std::ostringstream stream;
  writer.Write(stream);
  return stream.str();
}

struct Chosen {
  CadFace face;
  double area = 0;
};

Chosen chosen(const std::string& bytes, const std::string& name, const std::string& face) {
  Report report;
  cad::LoadOptions options;
  options.face = face;
  Chosen c{cad::load_face_guarded(bytes, name, options, report).face};
  for (const auto& [key, value] : report.entries())
    if (key == "face.area") c.area = std::get<double>(value);
  return c;
}

std::string refusal(const std::string& bytes, const std::string& face) {
  return message_of<FormatError>([&] { chosen(bytes, "a.step", face); });
}

gp_Pnt in_space(const CadFace& face, Vec2 x) {
  gp_XYZ p;
  for (int k = 0; k < 3; ++k)
    p.SetCoord(k + 1, face.plane_origin[k] + (x.x + face.origin.x) * face.plane_x[k] +
                          (x.y + face.origin.y) * face.plane_y[k]);
  return gp_Pnt(p);
}

double to_nearest_corner(const gp_Pnt& p, const gp_Trsf& placement) {
  double least = 1e9;
  for (const gp_Pnt& corner : corners) least = std::min(least, p.Distance(corner.Transformed(placement)));
  return least;
}

void expect_part_at(const Chosen& c, const gp_Trsf& placement, double tolerance) {
  ASSERT_EQ(c.face.num_loops(), 2);
  ASSERT_EQ(c.face.loop_offsets[1], 3);
  EXPECT_NEAR(c.area, 4 - pi * radius * radius, tolerance) << "the outline is counter-clockwise, the hole clockwise";
  for (int i = 0; i < 3; ++i) {
    EXPECT_LT(to_nearest_corner(in_space(c.face, c.face.joints[i].position), placement), tolerance);
    EXPECT_LT(c.face.joints[i].interior_angle, half_pi + 1e-9);
  }
  for (int i = 3; i < c.face.num_curves(); ++i) {
    const Nurbs& arc = c.face.curves[i];
    const gp_Pnt p = in_space(c.face, curve::point(arc, 0.7 * arc.begin() + 0.3 * arc.end()));
    EXPECT_NEAR(p.Distance(hole_centre.Transformed(placement)), radius, tolerance);
  }
}

void expect_parts(const std::string& bytes, const std::string& name, const std::vector<gp_Trsf>& places) {
  SCOPED_TRACE(name);
  const cad::FaceList list = cad::list_faces_guarded(bytes, name);
  ASSERT_EQ(list.faces.size(), places.size());
  for (size_t i = 0; i < places.size(); ++i) {
    EXPECT_EQ(list.faces[i].face.kind, "plane");
    EXPECT_NEAR(list.faces[i].face.length, 6 + std::sqrt(20.0) + 2 * pi * radius, 1e-6);
    ASSERT_EQ(list.faces[i].edges.size(), 4U);
    expect_part_at(chosen(bytes, name, std::to_string(i)), places[i], 1e-6);
  }
}

TEST(ChooseFace, each_part_of_a_nested_and_mirrored_assembly_is_where_it_is_placed) {
  expect_parts(brep(assembly()), "a.brep", placements());
  expect_parts(iges(assembly()), "a.iges", placements());
  expect_parts(step(assembly(false)), "a.step", placements(false));
  expect_parts(step(assembly()), "a.step", placements());
}

TEST(ChooseFace, every_face_of_a_solid) {
  const std::string solid = test_bytes("bad/solid.step");
  const cad::FaceList list = cad::list_faces_guarded(solid, "solid.step");
  ASSERT_EQ(list.faces.size(), 6U);
  EXPECT_EQ(list.length_unit, "millimetre");
  for (int i = 0; i < 6; ++i) {
    const Chosen c = chosen(solid, "solid.step", std::to_string(i));
    EXPECT_GT(c.area, 0);
    EXPECT_EQ(c.face.num_curves(), 4);
    EXPECT_EQ(list.faces[i].edges[2].kind, "line");
    const std::array<double, 3>& place = list.faces[i].face.place;
    const gp_XYZ normal = gp_XYZ(c.face.plane_x[0], c.face.plane_x[1], c.face.plane_x[2])
                              .Crossed(gp_XYZ(c.face.plane_y[0], c.face.plane_y[1], c.face.plane_y[2]));
    EXPECT_NEAR((gp_XYZ(place[0], place[1], place[2]) - in_space(c.face, {0, 0}).XYZ()).Dot(normal), 0, 1e-12);
  }
}

TEST(ChooseFace, faces_that_are_not_planar_are_listed_and_refused) {
  const std::string sphere = test_bytes("bad/sphere.step");
  const cad::FaceList list = cad::list_faces_guarded(sphere, "sphere.step");
  ASSERT_EQ(list.faces.size(), 1U);
  EXPECT_EQ(list.faces[0].face.kind, "sphere");
  EXPECT_NE(refusal(sphere, "0").find("not planar"), std::string::npos);
}

TEST(ChooseFace, names_come_before_numbers_and_one_that_is_given_twice_is_refused) {
  std::string two = test_bytes("bad/two_faces.step");
  const auto name = [&](const std::string& text) {
    const std::string mark = "ADVANCED_FACE('',";
    ASSERT_NE(two.find(mark), std::string::npos);
    two.replace(two.find(mark), mark.size(), "ADVANCED_FACE('" + text + "',");
  };
  name("lid"), name("0");
  EXPECT_EQ(chosen(two, "a.step", "lid").face.name, "lid");
  EXPECT_EQ(chosen(two, "a.step", "0").face.name, "0") << "the name, not the number";
  EXPECT_EQ(chosen(two, "a.step", "1").face.name, "0");
  two.replace(two.find("ADVANCED_FACE('0'"), 17, "ADVANCED_FACE('lid'");
  EXPECT_NE(refusal(two, "lid").find("--face lid: the faces 0, 1 have this name: choose one by its number"),
            std::string::npos);
  EXPECT_NE(refusal(two, "2").find("--face 2: no face has this name or number; the file holds 2"), std::string::npos);
  for (const char* wrong : {"-1", "1x", "Lid", "99999999999"})
    EXPECT_NE(refusal(two, wrong).find("no face has this name"), std::string::npos) << wrong;
}

void expect_held(const cad::ListedFace& face, const std::string& part, const std::string& layer) {
  EXPECT_EQ(face.part, part);
  EXPECT_EQ(face.layer, layer);
}

// An assembly "rig" of a tetrahedron "bolt", twice, and a "plate" of two surface models with one and two faces.
TEST(ChooseFace, faces_are_listed_with_the_parts_and_layers_that_hold_them) {
  const cad::FaceList list = cad::list_faces_guarded(test_bytes("assemblies/parts.step"), "parts.step");
  ASSERT_EQ(list.faces.size(), 11U);
  for (int i = 0; i < 8; ++i) expect_held(list.faces[i], "rig/bolt/shank", "steel");
  expect_held(list.faces[8], "rig/plate/inlet", "wet");
  expect_held(list.faces[9], "rig/plate/outlet", "wet");
  expect_held(list.faces[10], "rig/plate/outlet", "");
}

TEST(ChooseFace, a_part_or_layer_chooses_its_only_face) {
  const std::string parts = test_bytes("assemblies/parts.step");
  for (const char* name : {"inlet", "rig/plate/inlet"})
    EXPECT_EQ(chosen(parts, "a.step", name).face.plane_origin[2], 20) << name;
  EXPECT_NE(refusal(parts, "wet").find("--face wet: the faces 8, 9 lie in the part or layer of this name"),
            std::string::npos);
  EXPECT_NE(refusal(parts, "bolt").find("the faces 0-7 lie"), std::string::npos);
  EXPECT_NE(refusal(parts, "nut")
                .find("no face has this name or number; the file holds 11, numbered from 0, and no part or layer"),
            std::string::npos);
}

TEST(ChooseFace, names_and_numbers_of_faces_come_before_names_of_parts) {
  std::string parts = test_bytes("assemblies/parts.step");
  const std::string mark = "SHELL_BASED_SURFACE_MODEL('inlet'";
  ASSERT_NE(parts.find(mark), std::string::npos);
  const auto with_name = [&](const std::string& name) {
    return std::string(parts).replace(parts.find(mark), mark.size(), "SHELL_BASED_SURFACE_MODEL('" + name + "'");
  };
  const auto least_x = [&](const std::string& name) {
    double least = 1e9;
    const CadFace face = chosen(with_name(name), "a.step", name).face;
    for (const Joint& joint : face.joints) least = std::min(least, joint.position.x + face.origin.x);
    return least;
  };
  EXPECT_NEAR(least_x("the inlet"), 0, 1e-9) << "the part holds face 8";
  EXPECT_NEAR(least_x("rim"), 20, 1e-9) << "face 10 has this name";
  EXPECT_NEAR(least_x("9"), 10, 1e-9) << "face 9 has this number";
}

std::string replaced(const std::string& text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error("no " + from);
  return text.substr(0, at) + to + text.substr(at + from.size());
}

// Face 10, "rim", without its plane.
std::string parts_without_rim() { return replaced(test_bytes("assemblies/parts.step"), "(#200),#201", "(#200),$"); }

TEST(ChooseFace, faces_that_cannot_be_built_are_named) {
  const cad::FaceList list = cad::list_faces_guarded(parts_without_rim(), "parts.step");
  EXPECT_EQ(list.faces.size(), 10U);
  EXPECT_EQ(list.not_built, std::vector<std::string>{"#202 'rim'"});
  EXPECT_TRUE(cad::list_faces_guarded(test_bytes("assemblies/parts.step"), "parts.step").not_built.empty());
  EXPECT_NE(refusal(parts_without_rim(), "rim").find("could not be built: #202 'rim'"), std::string::npos);
}

// A box in IGES whose entities of type `kind` have the name "NAME_kind" and the level `kind`.
std::string labelled_iges(int mode, const std::vector<int>& kinds) {
  quiet_kernel();
  IGESControl_Writer writer("MM", mode);
  writer.AddShape(group({BRepPrimAPI_MakeBox(1., 2., 3.).Shape()}));
  writer.ComputeModel();
  const Handle(IGESData_IGESModel) model = writer.Model();
  for (int i = model->NbEntities(); i > 0; --i) {
    const Handle(IGESData_IGESEntity) entity = model->Entity(i);
    if (std::find(kinds.begin(), kinds.end(), entity->TypeNumber()) == kinds.end()) continue;
    const Handle(IGESBasic_Name) name = new IGESBasic_Name;
    name->Init(1, new TCollection_HAsciiString(("NAME_" + std::to_string(entity->TypeNumber())).c_str()));
    model->AddEntity(name);
    entity->AddProperty(name);
    entity->InitLevel(nullptr, entity->TypeNumber());
  }
  std::ostringstream stream;
  writer.Write(stream);
  return stream.str();
}

TEST(ChooseFace, solids_shells_groups_and_levels_of_iges_hold_faces) {
  const cad::FaceList solid = cad::list_faces_guarded(labelled_iges(1, {186, 514}), "a.iges");
  ASSERT_EQ(solid.faces.size(), 6U);
  for (const cad::ListedFace& face : solid.faces) expect_held(face, "NAME_186/NAME_514", "level_514");
  const cad::FaceList faces = cad::list_faces_guarded(labelled_iges(1, {186, 510}), "a.iges");
  ASSERT_EQ(faces.faces.size(), 6U);
  expect_held(faces.faces[3], "NAME_186", "level_510");
  EXPECT_EQ(faces.faces[3].face.name, "NAME_510");
  const cad::FaceList surfaces = cad::list_faces_guarded(labelled_iges(0, {402}), "a.iges");
  ASSERT_EQ(surfaces.faces.size(), 6U);
  expect_held(surfaces.faces[5], "NAME_402", "level_402");
}

TEST(ChooseFace, several_faces_are_refused_with_both_ways_to_choose) {
  for (const char* file : {"bad/two_faces.step", "regions/bad/two_planes.step", "bad/solid.step"}) {
    const std::string message = refusal(test_bytes(file), "");
    for (const char* option : {"--face NUMBER", "--face NAME", "--list"})
      EXPECT_NE(message.find(option), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace quadrille::occ
