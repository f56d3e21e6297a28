#include <gtest/gtest.h>

#include <numbers>

#include "export/writers.hpp"
#include "periodic_row.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

std::string pyfr_section(const std::string& text, const std::string& name) {
  const std::size_t begin = text.find('$' + name + '\n') + name.size() + 2;
  return text.substr(begin, text.find("$End" + name) - begin);
}

TEST(GmshPyfr, AllElementsAreFluidAndNamesAreWordsThatDifferInLowerCase) {
  QuadMesh mesh = two_quads();
  mesh.face.curve_names = {"Wall", "wall", "Periodic", "fluid"};
  const Exported exported = gmsh_pyfr(mesh, plane_frame(mesh.face));
  EXPECT_EQ(pyfr_section(exported.bytes, "PhysicalNames"), R"(5
1 1 "Wall"
1 2 "wall_2"
1 3 "_Periodic"
1 4 "fluid_2"
2 5 "fluid"
)");
  ASSERT_EQ(exported.losses.size(), 2u);
  EXPECT_EQ(exported.losses[0], "2 region names are not stored");
  ASSERT_EQ(exported.side_files.size(), 1u);
  EXPECT_NE(exported.side_files[0].bytes.find(R"("name": "Periodic", "tag": "_Periodic")"), std::string::npos);
}

TEST(GmshPyfr, PeriodicSidesHaveItsNames) {
  const QuadMesh mesh = periodic_row(3);
  const Exported exported = gmsh_pyfr(mesh, plane_frame(mesh.face));
  EXPECT_EQ(pyfr_section(exported.bytes, "PhysicalNames"), R"(5
1 1 "low"
1 2 "periodic_0_r"
1 3 "high"
1 4 "periodic_0_l"
2 5 "fluid"
)");
  ASSERT_EQ(exported.losses.size(), 1u);
  EXPECT_EQ(exported.losses[0],
            "periodic sides have the names that PyFR requires: \"left\" as periodic_0_l, \"right\" as periodic_0_r");
}

TEST(GmshPyfr, RotatedSidesStayBoundaries) {
  QuadMesh mesh = periodic_row(2);  // bent to a quarter of a ring
  for (Vec2& x : mesh.nodes) x = (2 - x.y) * unit(std::numbers::pi / 4 * x.x);
  mesh.face.periodic_pairs[0] = {{3, 1}, std::numbers::pi / 2, {0, 0}};
  const Exported exported = gmsh_pyfr(mesh, plane_frame(mesh.face));
  EXPECT_EQ(exported.bytes.find("periodic_"), std::string::npos);
  ASSERT_EQ(exported.losses.size(), 1u);
  EXPECT_NE(exported.losses[0].find("PyFR couples two sides"), std::string::npos) << exported.losses[0];
}

TEST(GmshPyfr, InterfacesHaveNoLines) {
  QuadMesh mesh = two_quads();
  mesh.face.curves.resize(5);
  mesh.face.curve_names.emplace_back("between");
  mesh.interface_edges = {{0, 1, 4}};
  EXPECT_NE(gmsh_msh41(mesh, plane_frame(mesh.face)).bytes.find("between"), std::string::npos);
  const Exported exported = gmsh_pyfr(mesh, plane_frame(mesh.face));
  EXPECT_EQ(exported.bytes.find("between"), std::string::npos);
  EXPECT_EQ(pyfr_section(exported.bytes, "Elements").substr(0, 9), "8 8 1 8\n1");
  EXPECT_EQ(exported.losses[0], "1 interface is not stored: \"between\"");
}

}  // namespace
}  // namespace quadrille::exports
