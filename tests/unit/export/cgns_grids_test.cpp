#include <gtest/gtest.h>

#include "base/error.hpp"
#include "cell_masks.hpp"
#include "export/cgns_request.hpp"
#include "export/merge_blocks.hpp"
#include "export/writers.hpp"
#include "two_hexes.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

/// Own index of a donor's point by the transform, as the standard defines it.
TEST(CgnsGrids, TransformsMapRangesOntoThoseOfTheDonor) {
  for (const QuadMesh& mesh : {mesh_of_mask({"###", "#.#", "###"}), ring_of_cells(8, 3), ring_of_cells(3, 1)})
    for (const QuadMesh& blocks : {mesh, merge_blocks(mesh)}) {
      const CgnsRequest request = cgns_request(cgns_structured(blocks, plane_frame(mesh.face)).bytes);
      int count = 0;
      for (const CgnsZone& zone : request.zones)
        for (const CgnsConnection& c : zone.connections) {
          std::vector<std::int64_t> end{c.donor_range[0], c.donor_range[1]};
          for (int own = 0; own < 2; ++own) {
            const int donor = static_cast<int>(std::abs(c.transform[own])) - 1;
            end[donor] += (c.transform[own] > 0 ? 1 : -1) * (c.range[2 + own] - c.range[own]);
          }
          EXPECT_EQ(end, (std::vector<std::int64_t>{c.donor_range[2], c.donor_range[3]}));
          const std::array<bool, 2> negative{c.transform[0] < 0, c.transform[1] < 0};
          const bool is_swapped = std::abs(c.transform[0]) == 2;
          EXPECT_EQ(is_swapped, negative[0] != negative[1]) << "grids are counter-clockwise";
          ++count;
        }
      EXPECT_GT(count, 0);
    }
}

TEST(CgnsGrids, HaveFamiliesAndConnectionsInSpace) {
  const CgnsRequest request = cgns_request(cgns_structured(two_hexes({.order = 2, .map = bent})).bytes);
  EXPECT_TRUE(request.is_structured);
  EXPECT_EQ(request.cell_dimension, 3);
  ASSERT_EQ(request.zones.size(), 2u);
  EXPECT_EQ(request.zones[0].family, "fluid");
  EXPECT_EQ(request.zones[1].family, "solid");
  EXPECT_EQ(request.zones[0].size, (std::vector<std::int64_t>{3, 3, 3}));
  EXPECT_EQ(request.zones[0].x.at(2).size(), 27u);
  EXPECT_EQ(request.zones[0].boundaries.size(), 5u);
  ASSERT_EQ(request.zones[0].connections.size(), 1u);
  const CgnsConnection& c = request.zones[0].connections[0];
  EXPECT_EQ(c.donor, "block_1");
  EXPECT_EQ(c.range, (std::vector<std::int64_t>{3, 1, 1, 3, 3, 3}));
  EXPECT_EQ(c.donor_range, (std::vector<std::int64_t>{1, 1, 1, 1, 3, 3}));
  EXPECT_EQ(c.transform, (std::vector<std::int64_t>{1, 2, 3}));
}

TEST(CgnsGrids, OfThePlaneHaveRangesAlongTheirSides) {
  const QuadMesh mesh = two_quads_of_the_pages();
  const CgnsRequest request = cgns_request(cgns_structured(mesh, plane_frame(mesh.face)).bytes);
  EXPECT_EQ(request.cell_dimension, 2);
  ASSERT_EQ(request.zones.size(), 2u);
  EXPECT_EQ(request.zones[0].size, (std::vector<std::int64_t>{3, 3}));
  EXPECT_EQ(request.zones[0].x.size(), 2u);
  // Below from left to right, above from left to right, and the left side from below: ranges rise.
  std::vector<std::vector<std::int64_t>> ranges;
  for (const CgnsBoundary& b : request.zones[0].boundaries) {
    EXPECT_EQ(b.family, "wall");
    ranges.push_back(b.range);
  }
  EXPECT_EQ(ranges, (std::vector<std::vector<std::int64_t>>{{1, 1, 3, 1}, {1, 3, 3, 3}, {1, 1, 1, 3}}));
  ASSERT_EQ(request.zones[1].connections.size(), 1u);
  EXPECT_EQ(request.zones[1].connections[0].donor, "block_0");
}

TEST(CgnsGrids, InSpaceHaveThreeCoordinates) {
  const CgnsRequest request = cgns_request(cgns_structured(two_quads(), upright_frame()).bytes);
  ASSERT_EQ(request.zones[0].x.size(), 3u);
  EXPECT_EQ(request.zones[0].x[0], std::vector<double>(9, 7));
}

TEST(CgnsGrids, FoldedCellsAreRefused) {
  EXPECT_THROW(cgns_structured(two_hexes({.map =
                                              [](Vec3 x) {
                                                return Vec3{x.x == 0 ? 3 : x.x, x.y, x.z};
                                              }})),
               ComputeError);
}

}  // namespace
}  // namespace quadrille::exports
