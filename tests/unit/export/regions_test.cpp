// Meshes of several regions in the formats of other programs: regions as groups, interfaces as named lines.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "../support/refined.hpp"
#include "../support/region_graphs.hpp"
#include "block/extract_blocks.hpp"
#include "export/format_table.hpp"
#include "export/groups.hpp"
#include "export/skeleton.hpp"
#include "two_hexes.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

/// A disc of "steel" in a square of "air"; the outline is "outside", the circle "skin".
QuadMesh disc_mesh() {
  SeparatrixGraph graph = region_graphs::disc_in_square();
  graph.face.region_names = {"air", "steel"};
  graph.face.curve_names = {"outside", "outside", "outside", "outside", "skin", "skin"};
  Report report;
  BlockLayout layout = block::extract_blocks(graph, report);
  block::name_blocks(layout, {});
  return refine::refine(layout, {.size = 1.5, .order = 2, .geometry_tol = 1e-2}, report);
}

Exported exported(const std::string& format) { return export_mesh(disc_mesh(), *find_export_format(format)); }

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string all_losses(const Exported& file) {
  std::string text;
  for (const std::string& loss : file.losses) text += loss + "\n";
  return text;
}

TEST(ExportRegions, InterfacesAreGroupsAfterTheBoundaries) {
  const Groups groups = mesh_groups(disc_mesh());
  EXPECT_EQ(groups.boundary_names, std::vector<std::string>{"outside"});
  EXPECT_EQ(groups.interface_names, std::vector<std::string>{"skin"});
  EXPECT_EQ(groups.curve2boundary, (std::vector<int>{0, 0, 0, 0, 1, 1}));
  std::vector<std::string> regions = groups.region_names;
  std::sort(regions.begin(), regions.end());
  EXPECT_EQ(regions, (std::vector<std::string>{"air", "steel"}));
}

TEST(ExportRegions, BlocksWithoutANameHaveThatOfTheirRegion) {
  QuadMesh mesh = disc_mesh();
  for (std::size_t b = 0; b < mesh.block_names.size(); ++b) mesh.unnamed_blocks.push_back(static_cast<int>(b));
  const std::vector<std::string> names = region_of_blocks(mesh);
  for (std::size_t b = 0; b < names.size(); ++b) EXPECT_EQ(names[b], mesh.block_region[b] == 0 ? "air" : "steel");
  mesh = disc_mesh();
  mesh.block_names[3] = "bolt";
  separate_blocks(mesh);
  EXPECT_EQ(mesh.block_names[0], "block_0");
  EXPECT_EQ(mesh.block_names[3], "bolt");
}

TEST(ExportRegions, TheSkeletonKnowsTheCurvesOfInterfaces) {
  const QuadMesh mesh = disc_mesh();
  std::size_t num_edges = 0;
  for (const SkeletonCurve& curve : mesh_skeleton(mesh).curves) {
    if (curve.is_boundary() || curve.cad_curve < 0) continue;
    EXPECT_EQ(curve.cad_curve, 4) << "of the lower number";
    EXPECT_EQ(mesh.block_region[curve.blocks[0]], 0);
    EXPECT_EQ(mesh.block_region[curve.blocks[1]], 1);
    num_edges += curve.edges.size();
  }
  EXPECT_EQ(2 * num_edges, mesh.interface_edges.size());
}

TEST(ExportRegions, GmshHasLinesOnInterfaces) {
  const QuadMesh mesh = disc_mesh();
  const std::size_t num_lines = mesh.boundary_edges.size() + mesh.interface_edges.size() / 2;
  const std::string elements = std::to_string(num_lines + mesh.elem_block.size());
  const std::string msh = exported("msh").bytes, msh22 = exported("msh22").bytes;
  for (const std::string& text : {msh, msh22})
    for (const char* name : {"\n1 1 \"outside\"\n", "\n1 2 \"skin\"\n", "\n2 3 \"", "\"air\"", "\"steel\""})
      EXPECT_TRUE(contains(text, name)) << name;
  EXPECT_TRUE(contains(msh22, "$Elements\n" + elements + "\n"));
  EXPECT_TRUE(contains(msh, " " + elements + " 1 " + elements + "\n"));
}

TEST(ExportRegions, NektarHasACompositeForEach) {
  const std::string xml = exported("nektar").bytes;
  for (const char* text : {"<C ID=\"1\" NAME=\"outside\"> E[", "<C ID=\"2\" NAME=\"skin\"> E[", "NAME=\"air\"> Q[",
                           "NAME=\"steel\"> Q[", "C[3-4] </D>"})
    EXPECT_TRUE(contains(xml, text)) << text;
}

TEST(ExportRegions, MfemHasBoundaryElementsInside) {
  const QuadMesh mesh = disc_mesh();
  const std::size_t num_lines = mesh.boundary_edges.size() + mesh.interface_edges.size() / 2;
  const std::string text = exported("mfem13").bytes;
  EXPECT_TRUE(contains(text, "\nboundary\n" + std::to_string(num_lines) + "\n"));
  EXPECT_TRUE(contains(text, "bdr_attribute_sets\n2\n\"outside\" 1 1\n\"skin\" 1 2\n"));
  const Exported old = exported("mfem");
  ASSERT_EQ(old.side_files.size(), 1u);
  EXPECT_TRUE(contains(old.side_files[0].bytes, "\"interfaces\": [\n    {\"id\": 2, \"name\": \"skin\"}\n  ]"));
}

TEST(ExportRegions, VtuMarksInterfaces) {
  const Exported file = exported("vtu");
  ASSERT_EQ(file.side_files.size(), 1u);
  EXPECT_TRUE(file.losses.empty());
  EXPECT_TRUE(contains(file.bytes, "region_names"));
}

TEST(ExportRegions, IsmMmHasMaterials) {
  const Exported file = exported("ism-mm");
  EXPECT_EQ(file.bytes.substr(0, 7), "ISM-MM\n");
  EXPECT_TRUE(contains(file.bytes, " air\n"));
  EXPECT_TRUE(contains(file.bytes, " steel\n"));
  EXPECT_TRUE(contains(all_losses(file), "1 interface is not stored: \"skin\"\n"));
  EXPECT_FALSE(contains(all_losses(file), "region"));
  EXPECT_TRUE(contains(all_losses(exported("ism-v2")), "2 region names are not stored"));
}

TEST(ExportRegions, IsmMmIsIsmV2WithoutEdges) {
  const QuadMesh mesh = two_quads();
  const Exported file = export_mesh(mesh, *find_export_format("ism-mm"));
  EXPECT_EQ(file.bytes,
            "ISM-MM\n6 7 2 2\n"
            "0 0 0\n2 0 0\n2 2 0\n0 2 0\n4 0 0\n4 2 0\n"
            "1 2 3 4 left\n0 0 0 0\nwall --- wall curve_3\n"
            "2 5 6 3 right\n0 0 1 0\n2 2 0\n3 2.5 0\n4 2 0\nwall in___out wall ---\n");
}

TEST(ExportRegions, NekHasGroupsOfMaterials) {
  const Exported file = exported("re2");
  ASSERT_FALSE(file.side_files.empty());
  EXPECT_TRUE(contains(file.side_files[0].bytes, "\"name\": \"steel\""));
  EXPECT_TRUE(contains(all_losses(file), "1 interface is not stored: \"skin\"\n"));
  EXPECT_FALSE(contains(all_losses(file), "region"));
  const QuadMesh mesh = disc_mesh();
  const Groups groups = mesh_groups(mesh);
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    double group = 0;  // after the header of 84 bytes; nine numbers for each element
    std::memcpy(&group, file.bytes.data() + 84 + 72 * elem, sizeof group);
    EXPECT_EQ(group, 1 + groups.block2region[mesh.elem_block[elem]]);
  }
}

TEST(ExportRegions, OpenFoamHasCellZones) {
  const Exported file = exported("blockmesh");
  EXPECT_TRUE(contains(file.bytes, ") air ("));
  EXPECT_TRUE(contains(file.bytes, ") steel ("));
  EXPECT_FALSE(contains(file.bytes, "skin")) << "no patch inside";
  EXPECT_TRUE(contains(all_losses(file), "1 interface is not stored: \"skin\" (blockMesh makes no face zones"));
}

bool loses_interfaces(const Exported& file) { return contains(all_losses(file), "interface is not stored"); }

void expect_same_files(const Exported& a, const Exported& b, std::string_view format) {
  EXPECT_EQ(a.bytes, b.bytes) << format;
  ASSERT_EQ(a.side_files.size(), b.side_files.size()) << format;
  for (std::size_t k = 0; k < a.side_files.size(); ++k) EXPECT_EQ(a.side_files[k].bytes, b.side_files[k].bytes);
}

/// Of all formats that have no interfaces.
TEST(ExportRegions, InterfacesOfABoundarysNameAreNoPartOfIt) {
  int num_formats = 0, num_hex_formats = 0;
  HexMesh hexes = two_hexes({}), hexes_without = hexes;
  hexes.face_groups[2].name = "wall";
  hexes_without.face_groups.erase(hexes_without.face_groups.begin() + 2);
  for (const ExportFormat& format : export_formats()) {
    if (loses_interfaces(export_mesh(with_interface_called("between"), format))) {
      const Exported file = export_mesh(with_interface_called("wall"), format);
      expect_same_files(file, export_mesh(two_quads(), format), format.name);
      EXPECT_TRUE(contains(all_losses(file), "1 interface is not stored: \"wall\"")) << format.name;
      ++num_formats;
    }
    if (format.write_hex != nullptr && loses_interfaces(export_mesh(two_hexes({}), format))) {
      const Exported file = export_mesh(hexes, format);
      expect_same_files(file, export_mesh(hexes_without, format), format.name);
      EXPECT_TRUE(contains(all_losses(file), "1 interface is not stored: \"wall\"")) << format.name;
      ++num_hex_formats;
    }
  }
  EXPECT_GT(num_formats, 0);
  EXPECT_GT(num_hex_formats, 0);
}

TEST(ExportRegions, ACrackIsABoundaryWithTwoSides) {
  SeparatrixGraph graph = region_graphs::slit_plate(true);
  hand_made::give_name(graph.face, 4, "crack");
  hand_made::give_name(graph.face, 5, "crack");
  const QuadMesh mesh = refined(graph, {.size = 0.5, .order = 2});
  const Groups groups = mesh_groups(mesh);
  EXPECT_TRUE(groups.interface_names.empty());
  EXPECT_EQ(groups.boundary_names.back(), "crack");
  for (const SkeletonCurve& curve : mesh_skeleton(mesh).curves) EXPECT_TRUE(curve.cad_curve < 0 || curve.is_boundary());
}

}  // namespace
}  // namespace quadrille::exports
