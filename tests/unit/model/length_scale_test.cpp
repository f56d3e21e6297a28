#include "model/length_scale.hpp"

#include <gtest/gtest.h>

#include "../support/texts.hpp"

namespace quadrille {
namespace {

CadFace face_in(const std::string& unit, double metres) {
  CadFace face;
  face.length_unit = unit, face.metres_per_unit = metres;
  return face;
}

TEST(LengthScale, ConvertsUnitsExactly) {
  const CadFace inches = face_in("inch", 0.0254), millimetres = face_in("millimetre", 0.001);
  EXPECT_EQ(length_scale(inches, {"mm"}).factor, 25.4);
  EXPECT_EQ(length_scale(inches, {"ft"}).factor, 0.0833333333333333);
  EXPECT_EQ(length_scale(millimetres, {"m"}).factor, 0.001);
  EXPECT_EQ(length_scale(millimetres, {"um"}).factor, 1000);
  EXPECT_EQ(length_scale(millimetres, {"m", 2}).factor, 0.002);
  EXPECT_EQ(length_scale(millimetres, {"m"}).unit, "metre");
  EXPECT_EQ(length_scale(millimetres, {"in"}).metres_per_unit, 0.0254);
}

TEST(LengthScale, WithoutAUnitTheFileKeepsItsOwn) {
  const LengthScale same = length_scale(face_in("inch", 0.0254), {});
  EXPECT_EQ(same.factor, 1);
  EXPECT_EQ(same.unit, "inch");
  EXPECT_EQ(same.metres_per_unit, 0.0254);
}

TEST(LengthScale, AFactorAloneGivesNumbersWithoutAUnitOrALargerShape) {
  const LengthScale numbers = length_scale(face_in("inch", 0.0254), {"file", 3});
  EXPECT_EQ(numbers.factor, 3);
  EXPECT_EQ(numbers.unit, "unknown");
  EXPECT_EQ(numbers.metres_per_unit, 0);
  EXPECT_EQ(length_scale(face_in("inch", 0.0254), {"file", 1}).unit, "unknown") << "1 is a factor as any other";
  const LengthScale larger = length_scale(face_in("inch", 0.0254), {"file", 3, true});
  EXPECT_EQ(larger.factor, 3);
  EXPECT_EQ(larger.unit, "inch");
}

TEST(LengthScale, AUnitNeedsThatOfTheFile) {
  EXPECT_EQ(message_of<UsageError>([] { length_scale(face_in("unknown", 0), {"m"}); }),
            "--unit m: the CAD file states no length unit: give the factor by --scale instead");
}

TEST(LengthScale, AllLengthsOfAGraphAreScaled) {
  ArcGraph graph;
  graph.face = face_in("millimetre", 0.001);
  graph.face.diameter = 4, graph.face.fit_distance = 1;
  graph.face.plane_origin = {1, 2, 3};
  graph.face.curves = {{1, {0, 0, 1, 1}, {{0, 0}, {2, 4}}, {1, 1}}};
  graph.face.joints.resize(1);
  graph.face.joints[0].position = {2, 4};
  graph.face.periodic_pairs = {{{0, 0}, 0, {2, 4}}};
  graph.splines = graph.face.curves;
  graph.nodes.resize(1);
  graph.nodes[0].position = {6, 8};
  scale_lengths(graph, {0.5, "unknown", 0});
  EXPECT_EQ(graph.face.diameter, 2);
  EXPECT_EQ(graph.face.fit_distance, 0.5);
  EXPECT_EQ(graph.face.plane_origin, (std::array<double, 3>{0.5, 1, 1.5}));
  for (const auto* curves : {&graph.face.curves, &graph.splines}) EXPECT_EQ((*curves)[0].poles[1], (Vec2{1, 2}));
  EXPECT_EQ(graph.face.joints[0].position, (Vec2{1, 2}));
  EXPECT_EQ(graph.face.periodic_pairs[0].shift, (Vec2{1, 2}));
  EXPECT_EQ(graph.nodes[0].position, (Vec2{3, 4}));
}

TEST(LengthScale, LengthsOfAMeshGetTheFactorAndJacobiansItsSquare) {
  QuadMesh mesh;
  mesh.nodes = {{3, 2.5}};
  mesh.face.diameter = 5;
  mesh.elem_jacobian_bound = mesh.elem_scaled_jacobian = {0.5, 0.5};
  mesh.face.origin = {10, 20};
  mesh.elem_node_distance = {0.5, 1};
  mesh.least_jacobian_bound = 0.5;
  scale_lengths(mesh, {0.1, "centimetre", 0.01});
  EXPECT_EQ(mesh.nodes[0], (0.1 * Vec2{3, 2.5}));
  EXPECT_EQ(mesh.face.origin, (0.1 * Vec2{10, 20}));
  EXPECT_DOUBLE_EQ(mesh.face.diameter, 0.5);
  EXPECT_DOUBLE_EQ(mesh.elem_jacobian_bound[1], 0.005);
  EXPECT_DOUBLE_EQ(mesh.least_jacobian_bound, 0.005);
  EXPECT_DOUBLE_EQ(mesh.elem_node_distance[0], 0.05);
  EXPECT_EQ(mesh.elem_scaled_jacobian, (std::vector<double>{0.5, 0.5}));
  EXPECT_EQ(mesh.face.length_unit, "centimetre");
  EXPECT_EQ(mesh.face.metres_per_unit, 0.01);
}

}  // namespace
}  // namespace quadrille
