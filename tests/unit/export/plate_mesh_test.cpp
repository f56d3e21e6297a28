#include "export/plate_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "export/hex_periodic.hpp"
#include "mesh/straight_cells.hpp"
#include "periodic_row.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

PlateMesh plate_of(const QuadMesh& mesh, const std::vector<PatchType>& types = {}) {
  const Groups groups = mesh_groups(mesh);
  return plate_mesh(mesh, Frame{}, groups, cyclic_patches(mesh, groups, types), types);
}

TEST(PlateMesh, AQuadMeshIsAPlateOneCellThick) {
  const QuadMesh mesh = two_quads();
  const mesh::StraightCells cells = straight_cells(mesh, {});
  EXPECT_TRUE(cells.is_plate);
  EXPECT_EQ(cells.num_cells, 2);
  EXPECT_EQ(cells.faces.size(), 11U);
  const mesh::CellGeometry geometry = mesh::cell_geometry(cells, mesh::CellCentre::volume);
  EXPECT_NEAR(geometry.volumes[1], 4 * 0.5, 1e-14);
  EXPECT_NEAR(geometry.centres[1].x, 3, 1e-14);
}

TEST(PlateMesh, HasTheCornersOfTheQuadsBelowAndAbove) {
  const PlateMesh plate = plate_of(two_quads());
  EXPECT_EQ(plate.mesh.order, 1);
  ASSERT_EQ(plate.mesh.nodes.size(), 12u);
  for (int k = 0; k < 6; ++k) {
    EXPECT_EQ(plate.mesh.nodes[k].z, 0);
    EXPECT_EQ(plate.mesh.nodes[k + 6].z, 0.5) << "a tenth of the diameter";
    EXPECT_EQ(plate.mesh.nodes[k + 6].x, plate.mesh.nodes[k].x);
  }
  ASSERT_EQ(plate.types.size(), 1u);
  EXPECT_EQ(plate.types[0].pattern, "frontAndBack");
  EXPECT_EQ(plate.types[0].type, "empty");
  EXPECT_EQ(plate.mesh.face_groups.back().elems.size(), 4u);
}

TEST(PlateMesh, TheNameOfTheEndsIsNoOther) {
  QuadMesh mesh = two_quads();
  mesh.face.curve_names[1] = "frontAndBack";
  EXPECT_EQ(plate_of(mesh).mesh.face_groups.back().name, "frontAndBack_");
}

TEST(PlateMesh, InterfacesHaveANameAndNoFaces) {
  const PlateMesh plate = plate_of(with_interface_called("between"));
  const auto at = std::ranges::find(plate.mesh.face_groups, "between", &HexFaceGroup::name);
  ASSERT_NE(at, plate.mesh.face_groups.end());
  EXPECT_TRUE(at->is_interface && at->elems.empty());
}

TEST(PlateMesh, CyclicPatchesAreImagesFaceByFaceUnlessTheirTypeIsChosen) {
  const PlateMesh plate = plate_of(periodic_row(3));
  const std::vector<PeriodicFaces> pairs = periodic_faces(plate.mesh);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(plate.mesh.face_groups[pairs[0].group].name, "left");
  EXPECT_EQ(plate.mesh.face_groups[pairs[0].group].motion.shift, (Vec3{3, 0, 0}));
  EXPECT_TRUE(periodic_faces(plate_of(periodic_row(3), {{"left", "wall"}}).mesh).empty());
}

}  // namespace
}  // namespace quadrille::exports
