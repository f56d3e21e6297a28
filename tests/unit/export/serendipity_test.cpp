#include "export/serendipity.hpp"

#include <gtest/gtest.h>

#include "two_hexes.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

TEST(Serendipity, NodesOnEdgesAreCountedThoseInsideAreNot) {
  const QuadMesh quads = two_quads();  // of order 2
  const std::vector<int> numbers = serendipity_numbers(quads);
  for (int elem = 0; elem < 2; ++elem) EXPECT_EQ(numbers[quads.elem_nodes[9 * elem + 4]], 0);
  EXPECT_EQ(*std::max_element(numbers.begin(), numbers.end()), static_cast<int>(quads.nodes.size()) - 2);
  const HexMesh hexes = two_hexes({.order = 2});
  const std::vector<int> of_hexes = serendipity_numbers(hexes);
  EXPECT_EQ(*std::max_element(of_hexes.begin(), of_hexes.end()), 32);  // 12 corners, 20 edges
  for (const int local : {4, 10, 12, 13, 14, 16, 22}) EXPECT_EQ(of_hexes[hexes.elem_nodes[local]], 0);
}

TEST(Serendipity, TheLossIsTheDistanceOfTheMiddle) {
  EXPECT_EQ(serendipity_loss(two_straight_quads(), "a reader"), "");
  EXPECT_EQ(serendipity_loss(two_hexes({.order = 2}), "a reader"), "");
  HexMesh hexes = two_hexes({.order = 2});
  hexes.nodes[hexes.elem_nodes[13]].z += 0.01;
  EXPECT_EQ(
      serendipity_loss(hexes, "a reader"),
      "nodes on faces and inside elements are not stored, which moves these by up to 0.01 (0.002 of the diameter)");
}

}  // namespace
}  // namespace quadrille::exports
