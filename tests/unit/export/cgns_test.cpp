#include <gtest/gtest.h>

#include "cell_masks.hpp"
#include "export/cgns_request.hpp"
#include "export/writers.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

TEST(Cgns, SectionsAreRegionsAndBoundaries) {
  const QuadMesh mesh = two_quads();
  const CgnsRequest request = cgns_request(cgns_unstructured(mesh, plane_frame(mesh.face)).bytes);
  ASSERT_EQ(request.zones.size(), 1u);
  const CgnsZone& zone = request.zones[0];
  EXPECT_EQ(zone.size, (std::vector<std::int64_t>{15, 2}));
  EXPECT_EQ(zone.x.size(), 2u);
  ASSERT_EQ(zone.sections.size(), 5u);
  EXPECT_EQ(zone.sections[0].name, "left");
  EXPECT_EQ(zone.sections[0].type, "QUAD_9");
  EXPECT_EQ(zone.sections[0].nodes, (std::vector<std::int64_t>{1, 3, 13, 11, 2, 8, 12, 6, 7}));
  EXPECT_EQ(zone.sections[2].name, "wall");
  EXPECT_EQ(zone.sections[2].type, "BAR_3");
  EXPECT_EQ(zone.sections[2].first, 3);
  EXPECT_EQ(zone.sections[2].count, 4);
  EXPECT_EQ(zone.sections[3].name, "in___out");
  ASSERT_EQ(zone.boundaries.size(), 3u);
  EXPECT_EQ(zone.boundaries[0].range, (std::vector<std::int64_t>{3, 6}));
  EXPECT_EQ(request.families[0].boundary, "BCWall");
  EXPECT_EQ(request.families[1].boundary, "UserDefined");
}

TEST(Cgns, AnInterfaceOfABoundarysNameIsInItsSectionAlone) {
  const QuadMesh mesh = with_interface_called("wall");
  const CgnsRequest request = cgns_request(cgns_unstructured(mesh, plane_frame(mesh.face)).bytes);
  const CgnsZone& zone = request.zones[0];
  EXPECT_EQ(zone.sections[2].name, "wall");
  EXPECT_EQ(zone.sections[2].count, 5);
  EXPECT_EQ(zone.boundaries[0].range, (std::vector<std::int64_t>{3, 6}));
  EXPECT_EQ(zone.boundaries[1].range, (std::vector<std::int64_t>{8, 8}));
}

/// The order of the ring inside, and its middle last.
TEST(Cgns, NodesOfOrderFourAreRings) {
  QuadMesh mesh = mesh_of_mask({"#"});
  mesh.order = 4;
  mesh.nodes.clear(), mesh.elem_nodes.clear();
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 5; ++i) {
      mesh.elem_nodes.push_back(static_cast<int>(mesh.nodes.size()));
      mesh.nodes.push_back({0.25 * i, 0.25 * j});
    }
  const CgnsRequest request = cgns_request(cgns_unstructured(mesh, plane_frame(mesh.face)).bytes);
  EXPECT_EQ(request.zones[0].sections[0].nodes,
            (std::vector<std::int64_t>{1,  5,  25, 21, 2, 3, 4,  10, 15, 20, 24, 23, 22,
                                       16, 11, 6,  7,  8, 9, 14, 19, 18, 17, 12, 13}));
}

}  // namespace
}  // namespace quadrille::exports
