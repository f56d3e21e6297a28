#include "export/poly_faces.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../support/texts.hpp"
#include "base/error.hpp"
#include "two_hexes.hpp"

namespace quadrille::exports {
namespace {

TEST(PolyFaces, AHexahedralMeshHasItsCornersAsCellsAndItsPeriodicFacesCoupled) {
  HexMesh mesh = two_hexes({.order = 2});
  join_ends(mesh, 1);
  const mesh::StraightCells cells = straight_cells(mesh, poly_faces(mesh, {}));
  EXPECT_EQ(cells.num_cells, 2);
  EXPECT_EQ(cells.points.size(), 12U);
  ASSERT_EQ(cells.faces.size(), 11U);
  EXPECT_EQ(cells.faces[0].neighbour, 1);
  const mesh::CellGeometry geometry = mesh::cell_geometry(cells, mesh::CellCentre::volume);
  EXPECT_NEAR(geometry.volumes[0], 4, 1e-14);
  ASSERT_EQ(cells.coupled.size(), 2U);
  for (const mesh::CoupledFaces& pair : cells.coupled) {
    EXPECT_EQ(geometry.face_centres[pair.first].z, 0);
    EXPECT_EQ(geometry.face_centres[pair.first] + pair.motion.shift, geometry.face_centres[pair.second]);
  }
  EXPECT_TRUE(cells.planes.empty());
  const mesh::StraightCells walls = straight_cells(mesh, poly_faces(mesh, {{"top", "symmetryPlane"}}));
  EXPECT_TRUE(walls.coupled.empty());
  ASSERT_EQ(walls.planes.size(), 1U);
  ASSERT_EQ(walls.planes[0].size(), 2U);
  for (const int face : walls.planes[0])
    EXPECT_EQ(mesh::cell_geometry(walls, mesh::CellCentre::volume).face_centres[face].z, 1);
}

TEST(PolyFaces, AFaceOfTheBoundaryIsInOneGroup) {
  const std::string text = "a face of the boundary is in no group or in two: make the mesh again (hexsweep)";
  HexMesh mesh = two_hexes({});
  mesh.face_groups[1].elems.clear(), mesh.face_groups[1].faces.clear();
  EXPECT_EQ(message_of<ComputeError>([&] { poly_faces(mesh, {}); }), text);
}

/// Ends that a rotation of 60 degrees about an axis maps onto each other; that passes through `point`.
HexMesh turned(Vec3 point, Vec3 axis) {
  const Vec3 across = normalized(cross(axis, Vec3{0.3, -0.5, 0.2})), other = cross(axis, across);
  const double turn = std::acos(-1.0) / 3;
  const auto at = [&](Vec3 x) {  // x along the axis, y away from it, z turns
    const double angle = turn * x.z;
    return point + x.x * axis + (3 + x.y) * (std::cos(angle) * across + std::sin(angle) * other);
  };
  HexMesh mesh = two_hexes({.map = [&](Vec3 x) { return at({x.x, -x.y, x.z}); }});
  mesh.length_unit = "unknown";
  mesh.face_groups[3].periodic_with = 4;
  SpaceMotion& motion = mesh.face_groups[3].motion;
  const auto image = [&](Vec3 x) {  // Rodrigues
    const double c = std::cos(turn), s = std::sin(turn);
    return c * x + s * cross(axis, x) + (1 - c) * dot(axis, x) * axis;
  };
  const Vec3 ex = image({1, 0, 0}), ey = image({0, 1, 0}), ez = image({0, 0, 1});
  motion.matrix = {Vec3{ex.x, ey.x, ez.x}, Vec3{ex.y, ey.y, ez.y}, Vec3{ex.z, ey.z, ez.z}};
  motion.shift = point - image(point);
  return mesh;
}

TEST(PolyFaces, ARotationIsCyclicWhereverItsAxisIs) {
  const Vec3 axis = normalized(Vec3{1, 2, 3});  // the shift of points on it is a rounding error
  for (const Vec3 point : {Vec3{0, 0, 0}, Vec3{5, 0, 0}, 7.3 * axis, 31 * axis, -5.7 * axis}) {
    const PolyFaces faces = poly_faces(turned(point, axis), {});
    EXPECT_FALSE(faces.are_periodic_lost) << point.x;
    const PolyPatch& bottom = faces.patches[faces.groups.curve2boundary[3]];
    EXPECT_EQ(bottom.type, "cyclic") << point.x;
    EXPECT_TRUE(bottom.entries.starts_with("        transform rotational;\n")) << bottom.entries;
  }
}

TEST(PolyFaces, AScrewIsNoCyclicPatch) {
  HexMesh mesh = two_hexes({.map = [](Vec3 x) {
    const double angle = std::acos(-1.0) / 2 * x.z;
    return Vec3{std::cos(angle) * x.x - std::sin(angle) * x.y, std::sin(angle) * x.x + std::cos(angle) * x.y, x.z};
  }});
  mesh.face_groups[3].periodic_with = 4;
  mesh.face_groups[3].motion = {{Vec3{0, -1, 0}, Vec3{1, 0, 0}, Vec3{0, 0, 1}}, {0, 0, 1}};
  const PolyFaces faces = poly_faces(mesh, {});
  EXPECT_TRUE(faces.are_periodic_lost);
  for (const PolyPatch& patch : faces.patches) EXPECT_EQ(patch.neighbour, -1);
}

TEST(VectorText, HasNoNegativeZero) { EXPECT_EQ(vector_text({-0.0, 0.5, -2}), "(0 0.5 -2)"); }

}  // namespace
}  // namespace quadrille::exports
