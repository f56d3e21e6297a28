#include "cad/loaded_face.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "base/error.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::cad {

namespace {

LoadedFace some_face() {
  LoadedFace loaded;
  CadFace& face = loaded.face;
  face.length_unit = "inch";
  face.metres_per_unit = 0.0254;
  face.plane_origin = {1, 2, 1.0 / 3};
  face.origin = {1e6, -0.0};
  face.diameter = 0.1;
  face.curves = {curve::segment({0, 0}, {1, 0}), curve::circular_arc({0, 0}, 1, 0, 3)};
  face.curve_names = {"wall", std::string("zero\0inside", 11)};
  face.unnamed_curves = {1};
  face.curve_cad_edges = {4, 2};
  face.loop_offsets = {0, 2};
  face.joints = {{{1, 2}, 0.5, -0.5, 3, true}, {{0, std::numeric_limits<double>::denorm_min()}, 1, 1, 3.1, false}};
  face.name = "plate";
  loaded.repairs = {{RepairKind::joint, 3, {1, 2}, 0.25}};
  return loaded;
}

Report some_report() {
  Report report;
  report.set("a.count", 3);
  report.set("a.ratio", 0.1);
  report.set("a.flag", Report::Value(true));
  report.set("a.text", "word");
  report.set("a.list", Report::Value(std::vector<double>{1, 2.5}));
  report.warn("W-CAD-001", "beside");
  return report;
}

TEST(SpaceFaceBytes, come_back_as_they_were) {
  SpaceFace face;
  face.face = some_face().face;
  face.curves = {{1, {0, 0, 2, 2}, {{1, 2, 3}, {4, 5, 1.0 / 3}}, {1, 1}}};
  face.surface = {1,    1,    {0, 0, 1, 1}, {0, 0, 1, 1}, {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}}, {1, 1, 1, 1},
                  true, false};
  face.is_reversed = true;
  face.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  face.triangles = {{0, 1, 2}};
  face.triangle_uv = {{Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}}};
  face.boundary_edges = {{{0, 1}, 0, 0, 2}};
  Report report;
  const SpaceFace back = space_face_from_bytes(to_bytes(face, some_report()), report);
  EXPECT_EQ(to_bytes(back, report), to_bytes(face, some_report()));
  EXPECT_EQ(back.curves[0].poles[1], face.curves[0].poles[1]);
  EXPECT_TRUE(back.surface.is_closed_u);
  EXPECT_EQ(back.triangle_uv[0][2], (Vec2{0, 1}));
  EXPECT_EQ(back.boundary_edges[0].t1, 2);
}

TEST(FaceBytes, come_back_as_they_were) {
  Report report;
  const LoadedFace loaded = from_bytes(to_bytes(some_face(), some_report()), report);
  EXPECT_EQ(to_bytes(loaded, report), to_bytes(some_face(), some_report()));
  const LoadedFace original = some_face();
  const CadFace &face = loaded.face, &written = original.face;
  EXPECT_EQ(face.curve_names, written.curve_names);
  EXPECT_EQ(face.unnamed_curves, written.unnamed_curves);
  EXPECT_EQ(face.curves[1].poles, written.curves[1].poles);
  EXPECT_EQ(face.joints[1].position, written.joints[1].position);
  ASSERT_EQ(loaded.repairs.size(), 1U);
  EXPECT_EQ(loaded.repairs[0].kind, RepairKind::joint);
  EXPECT_EQ(loaded.repairs[0].position, (Vec2{1, 2}));
  EXPECT_EQ(report.entries(), some_report().entries());
  ASSERT_EQ(report.warnings().size(), 1U);
  EXPECT_EQ(report.warnings()[0].message, "beside");
}

TEST(FaceBytes, requests_come_back_as_they_were) {
  CadRequest request;
  request.task = CadTask::write;
  request.name = "a.step";
  request.bytes = std::string("a\0b", 3);
  request.options.corner_angle = 0.25;
  request.options.heal_tolerance = 1e-4;
  request.options.face = "lid.1";
  request.options.blunt_width = 0.5;
  request.face = some_face().face;
  const CadRequest copy = request_from_bytes(to_bytes(request));
  EXPECT_EQ(to_bytes(copy), to_bytes(request));
  EXPECT_EQ(copy.task, CadTask::write);
  EXPECT_EQ(copy.name, "a.step");
  EXPECT_EQ(copy.bytes, request.bytes);
  EXPECT_EQ(copy.options.corner_angle, 0.25);
  EXPECT_EQ(copy.options.heal_tolerance, 1e-4);
  EXPECT_EQ(copy.options.face, "lid.1");
  EXPECT_EQ(copy.options.blunt_width, 0.5);
  EXPECT_EQ(copy.face.curve_names, request.face.curve_names);
  EXPECT_THROW(request_from_bytes(to_bytes(request) + "x"), Defect);
  EXPECT_THROW(request_from_bytes("x"), Defect);
}

TEST(FaceBytes, cut_off_or_too_long_is_a_defect) {
  const std::string bytes = to_bytes(some_face(), some_report());
  Report report;
  for (size_t n = 0; n < bytes.size(); n += 7) EXPECT_THROW(from_bytes(bytes.substr(0, n), report), Defect) << n;
  EXPECT_THROW(from_bytes(bytes + "x", report), Defect);
}

}  // namespace

}  // namespace quadrille::cad
