#include "sizing/hole_rings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../hand_made.hpp"
#include "../support/refined.hpp"
#include "block/extract_blocks.hpp"

namespace quadrille::sizing {
namespace {

std::vector<HoleRing> rings_of(const SeparatrixGraph& graph, double size) {
  const BlockLayout layout = block::extract_blocks(graph);
  return hole_rings(MeasuredLayout(layout), SizeField(size));
}

TEST(HoleRings, AreAroundHolesThatAreSmallBesideTheSize) {
  const SeparatrixGraph graph = hand_made::cut_annulus(4, 0.15);
  const std::vector<HoleRing> rings = rings_of(graph, 0.2);
  ASSERT_EQ(rings.size(), 1U);
  EXPECT_EQ(rings[0].loop, 1);
  EXPECT_NEAR(rings[0].thickness, 0.135, 1e-9);
  EXPECT_EQ(rings_of(graph, 0.1351).size(), 1U);
  EXPECT_TRUE(rings_of(graph, 0.135).empty());
}

TEST(HoleRings, AreNotAroundLongHoles) {  // 2 pi r < 12/20 diameters
  EXPECT_EQ(rings_of(hand_made::cut_annulus(4, 0.19), 1).size(), 1U);
  EXPECT_TRUE(rings_of(hand_made::cut_annulus(4, 0.2), 1).empty());
}

TEST(HoleRings, HaveRoomOfTwoRadii) {
  EXPECT_TRUE(rings_of(hand_made::cut_annulus(4, 0.1), 1)[0].has_room);
  EXPECT_TRUE(rings_of(hand_made::cut_annulus(4, 0.1, {0, 0.7}), 1)[0].has_room);
  EXPECT_FALSE(rings_of(hand_made::cut_annulus(4, 0.1, {0, 0.7001}), 1)[0].has_room);
  EXPECT_FALSE(rings_of(hand_made::cut_annulus(4, 0.1, {0.501, 0.501}), 1)[0].has_room);
}

TEST(HoleRings, NeedSizesBelowWhichTheHoleIs) {
  const BlockLayout layout = block::extract_blocks(hand_made::cut_annulus(4, 0.15));
  const SizeField sizes(0.2, {}, {{{0.15, 0}, {0.15, 0}, 0.1, 0.1}}, 1.2);
  EXPECT_TRUE(hole_rings(MeasuredLayout(layout), sizes).empty());
}

TEST(HoleRings, AddARowUnlessTheCountIsPrescribed) {
  std::vector<ChordPlan> plans(3);
  plans[1].count = plans[2].count = 4;
  plans[2].is_prescribed = true;
  add_ring_rows({{.chord = 1}, {.chord = 2}}, plans);
  EXPECT_EQ(plans[0].count, 1);
  EXPECT_EQ(plans[1].count, 5);
  EXPECT_EQ(plans[2].count, 4);
}

TEST(HoleRings, LengthsGrowFromRowToRow) {
  for (const int order : {1, 3}) {
    const QuadMesh mesh = refined(
        hand_made::cut_annulus(4, 0.15),
        {.size = 0.2, .order = order, .geometry_tol = 0.1, .relax = refine::Relax::none, .rings = refine::Rings::none});
    EXPECT_TRUE(ring_lengths(mesh, {}).empty());
    std::vector<double> least;
    for (const Vec2 length : ring_lengths(mesh, {{.loop = 1, .thickness = 0.12}})) {
      EXPECT_GT(std::max(length.x, length.y), 10) << "edges along the rows have no limit";
      least.push_back(std::min(length.x, length.y));
    }
    std::ranges::sort(least);
    const std::size_t around = std::ranges::count_if(mesh.boundary_edges, [](const auto& e) { return e.curve == 1; });
    for (std::size_t k = 0; k < 3 * around; ++k) EXPECT_NEAR(least[k], 0.12 * std::pow(1.5, k / around), 1e-12);
  }
}

}  // namespace
}  // namespace quadrille::sizing
