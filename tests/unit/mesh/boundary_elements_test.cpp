#include "mesh/boundary_elements.hpp"

#include <gtest/gtest.h>

#include "../region_samples.hpp"

namespace quadrille::mesh {
namespace {

TEST(BoundaryElements, EdgesOfOneNameAreCountedTogether) {
  QuadMesh mesh = samples::quad_mesh();  // two quads, 0.5 wide and 1 high
  mesh.face.curve_names = {"wall", "outlet", "wall", "inlet"};
  const std::vector<BoundaryElements> found = boundary_elements(mesh);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].name, "wall");
  EXPECT_EQ(found[0].count, 4);
  EXPECT_EQ(found[1].name, "outlet");
  EXPECT_EQ(found[1].count, 1);
  EXPECT_EQ(found[1].least_edge, 1);
  EXPECT_EQ(found[2].greatest_edge, 1);
  mesh.nodes[1].x = 0.25;
  EXPECT_EQ(boundary_elements(mesh)[0].least_edge, 0.25);
  EXPECT_EQ(boundary_elements(mesh)[0].greatest_edge, 0.75);
  mesh.space_nodes.assign(6, {});
  for (int k = 0; k < 6; ++k) mesh.space_nodes[k] = {2 * mesh.nodes[k].x, mesh.nodes[k].y, 0};
  EXPECT_EQ(boundary_elements(mesh)[0].greatest_edge, 1.5) << "in space";
}

TEST(BoundaryElements, AnInterfaceIsCountedFromOneSideAlsoIfItIsOpen) {
  QuadMesh mesh = samples::quad_mesh();
  mesh.face = samples::two_regions_face();
  mesh.boundary_edges = {{0, 0, 0}, {0, 2, 2}, {0, 3, 3}, {1, 0, 4}, {1, 1, 5}, {1, 2, 6}};
  mesh.interface_edges = {{0, 1, 1}, {1, 3, 7}};
  const auto counts = [&] {
    std::string text;
    for (const BoundaryElements& along : boundary_elements(mesh))
      text += along.name + "=" + std::to_string(along.count) + " ";
    return text;
  };
  EXPECT_EQ(counts(), "bottom=2 fluid-solid=1 top=2 inlet=1 outer=1 ");
  std::swap(mesh.boundary_edges, mesh.interface_edges);
  EXPECT_EQ(counts(), "bottom=2 fluid-solid=1 top=2 inlet=1 outer=1 ");
  mesh.interface_edges.clear();
  EXPECT_EQ(counts(), "fluid-solid=1 ");
}

TEST(BoundaryElements, TheReportHasThemByNumber) {
  Report report;
  report_boundary_elements(samples::quad_mesh(), report);
  ASSERT_EQ(report.entries().size(), 16U);
  EXPECT_EQ(report.entries()[0].first, "boundaries.0.name");
  EXPECT_EQ(std::get<std::string>(report.entries()[0].second), "side 0");
  EXPECT_EQ(report.entries()[1].first, "boundaries.0.elements");
  EXPECT_EQ(std::get<long long>(report.entries()[1].second), 2);
}

}  // namespace
}  // namespace quadrille::mesh
