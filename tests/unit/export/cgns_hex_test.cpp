#include <gtest/gtest.h>

#include <set>

#include "export/cgns_request.hpp"
#include "export/writers.hpp"
#include "two_hexes.hpp"

namespace quadrille::exports {
namespace {

CgnsRequest written(const HexMesh& mesh) { return cgns_request(cgns_unstructured(mesh).bytes); }

TEST(CgnsHex, SectionsAreRegionsAndGroupsOfFaces) {
  const HexMesh mesh = two_hexes({.order = 1, .first_corner = 1});
  const CgnsRequest request = written(mesh);
  EXPECT_FALSE(request.is_structured);
  EXPECT_EQ(request.cell_dimension, 3);
  ASSERT_EQ(request.zones.size(), 1u);
  const CgnsZone& zone = request.zones[0];
  EXPECT_EQ(zone.size, (std::vector<std::int64_t>{12, 2}));
  EXPECT_EQ(zone.x.size(), 3u);
  ASSERT_EQ(zone.sections.size(), 7u);
  EXPECT_EQ(zone.sections[0].name, "fluid");
  EXPECT_EQ(zone.sections[0].type, "HEXA_8");
  EXPECT_EQ(zone.sections[0].nodes, (std::vector<std::int64_t>{1, 2, 5, 4, 7, 8, 11, 10}));
  EXPECT_EQ(zone.sections[1].nodes, (std::vector<std::int64_t>{3, 6, 5, 2, 9, 12, 11, 8}));
  EXPECT_EQ(zone.sections[2].name, "wall");
  EXPECT_EQ(zone.sections[2].type, "QUAD_4");
  EXPECT_EQ(zone.sections[2].first, 3);
  EXPECT_EQ(zone.sections[2].count, 5);
  EXPECT_EQ(zone.sections[6].name, "between");
  EXPECT_EQ(zone.sections[6].nodes, (std::vector<std::int64_t>{2, 5, 11, 8}));
  ASSERT_EQ(zone.boundaries.size(), 4u) << "the interface is no boundary";
  EXPECT_EQ(zone.boundaries[0].range, (std::vector<std::int64_t>{3, 7}));
  ASSERT_EQ(request.families.size(), 6u);
  EXPECT_EQ(request.families[0].boundary, "BCWall");
  EXPECT_EQ(request.families[1].boundary, "BCOutflow");
  EXPECT_EQ(request.families[2].boundary, "UserDefined");
}

/// Places in a grid of (N + 1)^3 of the first element, which is all of the nodes with x <= 2.
std::vector<std::array<int, 3>> places(int order) {
  const CgnsRequest request = written(two_hexes({.order = order}));
  const CgnsZone& zone = request.zones[0];
  std::vector<std::array<int, 3>> result;
  for (const std::int64_t node : zone.sections[0].nodes)
    result.push_back({static_cast<int>(std::lround(order * zone.x[0][node - 1] / 2)),
                      static_cast<int>(std::lround(order * zone.x[1][node - 1] / 2)),
                      static_cast<int>(std::lround(order * zone.x[2][node - 1]))});
  return result;
}

/// The table of HEXA_27 in the standard.
TEST(CgnsHex, NodesOfOrderTwo) {
  EXPECT_EQ(places(2),
            (std::vector<std::array<int, 3>>{
                {0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}, {1, 0, 0},
                {2, 1, 0}, {1, 2, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}, {1, 0, 2}, {2, 1, 2},
                {1, 2, 2}, {0, 1, 2}, {1, 1, 0}, {1, 0, 1}, {2, 1, 1}, {1, 2, 1}, {0, 1, 1}, {1, 1, 2}, {1, 1, 1}}));
}

/// Nodes 33 to 56 are those of the faces, 57 to 64 two rings inside.
TEST(CgnsHex, NodesOfOrderThreeInsideAreRings) {
  const std::vector<std::array<int, 3>> all = places(3);
  ASSERT_EQ(all.size(), 64u);
  EXPECT_EQ((std::vector<std::array<int, 3>>(all.begin() + 32, all.end())),
            (std::vector<std::array<int, 3>>{
                {1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {1, 0, 1}, {2, 0, 1}, {2, 0, 2}, {1, 0, 2},
                {3, 1, 1}, {3, 2, 1}, {3, 2, 2}, {3, 1, 2}, {2, 3, 1}, {1, 3, 1}, {1, 3, 2}, {2, 3, 2},
                {0, 2, 1}, {0, 1, 1}, {0, 1, 2}, {0, 2, 2}, {1, 1, 3}, {2, 1, 3}, {2, 2, 3}, {1, 2, 3},
                {1, 1, 1}, {2, 1, 1}, {2, 2, 1}, {1, 2, 1}, {1, 1, 2}, {2, 1, 2}, {2, 2, 2}, {1, 2, 2}}));
}

TEST(CgnsHex, NodesOfOrderFourAreAllOfTheGrid) {
  const std::vector<std::array<int, 3>> all = places(4);
  EXPECT_EQ((std::set<std::array<int, 3>>(all.begin(), all.end()).size()), 125u);
  EXPECT_EQ(all[52], (std::array<int, 3>{2, 2, 0})) << "the middle of the bottom";
  EXPECT_EQ(all[124], (std::array<int, 3>{2, 2, 3})) << "the middle of the highest layer inside";
}

}  // namespace
}  // namespace quadrille::exports
