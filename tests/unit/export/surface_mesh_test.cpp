// Meshes of curved faces in the formats that have coordinates in space.

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "export/format_table.hpp"
#include "export/gmsh_model.hpp"
#include "export/renode.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

/// On the surface z = x^2 / 4, far from the chart.
QuadMesh bent_quads() {
  QuadMesh mesh = two_quads();
  for (const Vec2 x : mesh.nodes) mesh.space_nodes.push_back({x.x + 10, x.y, x.x * x.x / 4});
  return mesh;
}

std::string exported(const QuadMesh& mesh, const char* format) {
  return export_mesh(mesh, *find_export_format(format), {}).bytes;
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(SurfaceMesh, PositionsAreThoseInSpace) {
  const QuadMesh mesh = bent_quads();
  const Frame frame = model_frame(mesh.face);
  const auto points = positions(mesh, frame, ElementPoints::equispaced);
  EXPECT_EQ(points[4], (std::array<double, 3>{14, 0, 4}));
  EXPECT_EQ(position(mesh, frame, 3), (std::array<double, 3>{13, 0, 2.25}));
  const auto controls = positions(mesh, frame, ElementPoints::bezier);
  EXPECT_NEAR(controls[1][2], 0, 1e-15) << "of x^2 on [0, 2]: 0, 0, 4";
  EXPECT_EQ(space_dimension(mesh, frame), 3);
  EXPECT_EQ(space_dimension(two_quads(), plane_frame(mesh.face)), 2);
}

TEST(SurfaceMesh, FormatsWithSpaceHaveThreeCoordinates) {
  const QuadMesh mesh = bent_quads();
  EXPECT_TRUE(holds(exported(mesh, "msh"), "14 0 4\n"));
  EXPECT_TRUE(holds(exported(mesh, "msh22"), "14 0 4\n"));
  EXPECT_TRUE(holds(exported(mesh, "mfem"), "VDim: 3\n"));
  EXPECT_TRUE(holds(exported(mesh, "mfem"), "14 0 4\n"));
  EXPECT_TRUE(holds(exported(mesh, "nektar"), "SPACE=\"3\""));
  EXPECT_TRUE(holds(exported(mesh, "nektar"), ">14 0 4</V>"));
  EXPECT_TRUE(holds(exported(mesh, "vtu"), "NumberOfComponents=\"3\""));
}

TEST(SurfaceMesh, EdgesThatAreStraightInTheChartAreCurvedInSpace) {
  const QuadMesh mesh = bent_quads();
  EXPECT_FALSE(is_straight_edge(mesh, side_nodes(mesh, 0, 0)));
  EXPECT_TRUE(is_straight_edge(mesh, side_nodes(mesh, 0, 3)));
  EXPECT_TRUE(is_straight_edge(two_quads(), side_nodes(mesh, 0, 0)));
}

TEST(SurfaceMesh, FormatsOfThePlaneRefuse) {
  for (const char* format : {"ism-v2", "ism-mm", "inp", "re2", "blockmesh"})
    EXPECT_THROW(exported(bent_quads(), format), ComputeError) << format;
}

TEST(SurfaceMesh, LengthsAreScaledInSpaceToo) {
  QuadMesh mesh = bent_quads();
  scale_lengths(mesh, {2, "unknown", 0});
  EXPECT_EQ(mesh.space_nodes[4], (Vec3{28, 0, 8}));
}

}  // namespace
}  // namespace quadrille::exports
