#include <gtest/gtest.h>

#include <sstream>

#include "base/error.hpp"
#include "export/format_table.hpp"
#include "export/writers.hpp"
#include "periodic_row.hpp"
#include "two_hexes.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

std::string file_of(const Exported& exported, const std::string& name) {
  for (const SideFile& side : exported.side_files)
    if (side.name.ending == name) return side.bytes;
  return {};
}

std::string body(const std::string& text) { return text.substr(text.find("}\n\n") + 3); }

HexMesh page_mesh() {
  HexMesh mesh = two_hexes_of_the_pages();
  mesh.length_unit = "unknown";
  return mesh;
}

TEST(PolyMesh, ThePageShowsWhatIsWritten) {
  const Exported exported = poly_mesh(page_mesh());
  const std::string shown = page("openfoam.md");
  EXPECT_NE(shown.find("```\n" + body(file_of(exported, "faces")) + "```\n"), std::string::npos);
  EXPECT_NE(shown.find("```\n" + body(file_of(exported, "boundary")) + "```\n"), std::string::npos);
}

TEST(PolyMesh, TheOneInnerFacePointsFromTheLowerElement) {
  const Exported exported = poly_mesh(page_mesh());
  EXPECT_EQ(body(file_of(exported, "neighbour")), "1\n(\n1\n)\n");
  EXPECT_EQ(body(file_of(exported, "owner")), "11\n(\n0\n0\n0\n0\n1\n1\n1\n0\n1\n0\n1\n)\n");
  EXPECT_EQ(body(file_of(exported, "faces")).substr(0, 17), "11\n(\n4(1 2 6 5)\n4");
  EXPECT_NE(file_of(exported, "owner").find("note \"nPoints: 12 nCells: 2 nFaces: 11 nInternalFaces: 1\";"),
            std::string::npos);
  EXPECT_EQ(exported.losses.size(), 1u) << "the interface";
}

TEST(PolyMesh, PointsAreInMetres) {
  EXPECT_NE(poly_mesh(two_hexes({})).bytes.find("\n(0.002 0 0)\n"), std::string::npos);
  EXPECT_NE(poly_mesh(page_mesh()).bytes.find("\n(2 0 0)\n"), std::string::npos);
}

TEST(PolyMesh, InnerFacesAreSortedByOwnerAndNeighbour) {
  const Exported exported = poly_mesh(two_hexes({.order = 2, .layers = 3, .first_corner = 3}));
  EXPECT_EQ(body(file_of(exported, "owner")).substr(0, 18), "29\n(\n0\n0\n1\n2\n2\n3\n4");
  EXPECT_EQ(body(file_of(exported, "neighbour")), "7\n(\n1\n2\n3\n3\n4\n5\n5\n)\n");
}

TEST(PolyMesh, PeriodicGroupsAreCyclicPatchesUnlessTheirTypeIsChosen) {
  HexMesh mesh = two_hexes({.order = 2, .layers = 3});
  mesh.length_unit = "unknown";
  join_ends(mesh, 3);
  std::swap(mesh.face_groups[3].elems[0], mesh.face_groups[3].elems[1]);
  std::swap(mesh.face_groups[4].elems[0], mesh.face_groups[4].elems[1]);
  const Exported exported = poly_mesh(mesh);
  EXPECT_NE(file_of(exported, "boundary")
                .find("    top\n    {\n        type cyclic;\n        neighbourPatch bottom;\n"
                      "        transform translational;\n"
                      "        separationVector (0 0 -3);\n        separation (0 0 3);\n"),
            std::string::npos)
      << file_of(exported, "boundary");
  // The bottom of the second element, from its corner 3, and its image: from that on the other way round.
  EXPECT_NE(file_of(exported, "faces").find("\n4(2 9 8 1)\n4(3 2 1 0)\n4(20 19 22 23)\n4(21 18 19 20)\n)"),
            std::string::npos)
      << file_of(exported, "faces");
  const Exported other = poly_mesh(mesh, {{"t*", "wall"}});
  EXPECT_NE(file_of(other, "boundary").find("    top\n    {\n        type wall;\n        nFaces 2;"),
            std::string::npos);
  EXPECT_EQ(other.losses.size(), exported.losses.size() + 1);
  mesh.face_groups[3].motion.shift.x = 1e-3;
  EXPECT_THROW(poly_mesh(mesh), ComputeError);
}

TEST(PolyMesh, ARotationHasItsAxisAndCentre) {
  HexMesh mesh = two_hexes({.order = 1, .map = [](Vec3 x) {
                              const double angle = std::acos(-1.0) / 3 * x.z, r = 3 + x.x;
                              return Vec3{5 + r * std::cos(angle), x.y, r * std::sin(angle)};
                            }});
  mesh.length_unit = "unknown";
  const double cosine = 0.5, sine = std::sqrt(0.75);
  mesh.face_groups[3].periodic_with = 4;
  mesh.face_groups[3].motion.matrix = {Vec3{cosine, 0, -sine}, Vec3{0, 1, 0}, Vec3{sine, 0, cosine}};
  mesh.face_groups[3].motion.shift = {5 * (1 - cosine), 0, -5 * sine};
  const std::string boundary = file_of(poly_mesh(mesh), "boundary");
  EXPECT_NE(boundary.find("transform rotational;\n        rotationAxis (0 -1 0);\n        rotationCentre (5 0 "),
            std::string::npos)
      << boundary;
}

TEST(PolyMesh, TypesFollowFromNamesAndPlanes) {
  HexMesh mesh = two_hexes({});
  mesh.face_groups[0].name = "symmetry_around", mesh.face_groups[3].name = "symmetry_below";
  const std::string boundary = file_of(poly_mesh(mesh), "boundary");
  EXPECT_NE(boundary.find("symmetry_around\n    {\n        type symmetry;"), std::string::npos);
  EXPECT_NE(boundary.find("symmetry_below\n    {\n        type symmetryPlane;"), std::string::npos);
}

TEST(PolyMesh, CurvedEdgesAreLostAndFoldedCellsRefused) {
  const Exported bent_mesh = poly_mesh(two_hexes({.order = 3, .map = bent}));
  EXPECT_NE(bent_mesh.losses.at(0).find("cells have straight edges, which moves nodes by up to 0.0"),
            std::string::npos);
  const auto folded = [](Vec3 x) { return Vec3{x.x, x.y, x.x == 2 && x.y == 0 ? -x.z : x.z}; };
  EXPECT_THROW(poly_mesh(two_hexes({.order = 1, .map = folded})), ComputeError);
}

TEST(PolyMesh, AQuadMeshIsAPlateOneCellThick) {
  QuadMesh mesh = two_quads();
  const Exported exported = poly_mesh(mesh, plane_frame(mesh.face));
  const std::string boundary = file_of(exported, "boundary");
  EXPECT_NE(boundary.find("frontAndBack\n    {\n        type empty;\n        nFaces 4;\n        startFace 7;"),
            std::string::npos)
      << boundary;
  EXPECT_NE(exported.bytes.find("\n(4 2 0.5)\n"), std::string::npos);
  EXPECT_NE(exported.losses.back().find("cells have straight sides, which moves the boundary by up to 0.5"),
            std::string::npos);
  const QuadMesh row = periodic_row(3);
  const std::string cyclic = file_of(poly_mesh(row, plane_frame(row.face)), "boundary");
  EXPECT_NE(cyclic.find("type cyclic;\n        neighbourPatch "), std::string::npos) << cyclic;
}

}  // namespace
}  // namespace quadrille::exports
