#include "sizing/advice.hpp"

#include <gtest/gtest.h>

#include "../hand_made.hpp"
#include "base/report.hpp"
#include "block/extract_blocks.hpp"
#include "refine/refine.hpp"
#include "sizing/report_sizes.hpp"

namespace quadrille::sizing {
namespace {

/// The mesh of the unit square with these counts of its two chords, as if they followed from the options.
QuadMesh square_mesh(int along_x, int along_y, const SizeOptions& sizes) {
  Report report;
  const BlockLayout layout = block::extract_blocks(hand_made::unit_square(), report);
  refine::RefineOptions options;
  options.counts = {{0, along_x}, {1, along_y}};
  options.size_field = make_size_field(layout.face, sizes);
  return refine::refine(layout, options, report);
}

SizeOptions size_of(double size) {
  SizeOptions sizes;
  sizes.size = size;
  sizes.per_curve = 0;
  return sizes;
}

std::optional<Advice> advice(const QuadMesh& mesh, const SizeOptions& sizes) {
  return advice_for(mesh, mesh::verdict_of(mesh), sizes, sizes);
}

TEST(Advice, IsTheGreatestSizeAtWhichTheRatioIsAFifth) {
  const SizeOptions sizes = size_of(1);
  const QuadMesh mesh = square_mesh(1, 4, sizes);  // 1 by 1/4
  const auto found = advice(mesh, sizes);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->option, "--size 0.5") << "8 quads of 1/2 by 1/4, with a ratio of 8 in place of 128";
  EXPECT_EQ(found->quads, 8);
  EXPECT_EQ(describe(*found), "; give --size 0.5 (about 8 quads) for a lower resolution ratio");
}

TEST(Advice, IsNothingForAGoodMesh) {
  const SizeOptions sizes = size_of(0.25);
  EXPECT_FALSE(advice(square_mesh(4, 4, sizes), sizes));
}

TEST(Advice, IsNoSizeWhereAnotherOnePrescribesElements) {
  SizeOptions sizes = size_of(1);
  for (const char* side : {"side_0", "side_1", "side_2", "side_3"}) sizes.near.push_back({side, 0.05, 0});
  sizes.growth = 1.001;  // nearly the same everywhere: elements are long for it, and a size changes nothing
  EXPECT_FALSE(advice(square_mesh(1, 8, sizes), sizes));
}

TEST(Advice, IsNothingForAnAreaJump) {
  const SizeOptions sizes = size_of(0.25);
  QuadMesh mesh = square_mesh(4, 4, sizes);
  mesh.elem_area_jump[0] = 50;
  EXPECT_EQ(mesh::verdict_of(mesh).grade(), mesh::Grade::usable);
  EXPECT_FALSE(advice(mesh, sizes));
}

}  // namespace
}  // namespace quadrille::sizing
