#include "refine/tip_rounding.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "../samples.hpp"
#include "refine/refine.hpp"
#include "refine/tip_patch.hpp"

namespace quadrille::refine {
namespace {

class TipRounding : public ::testing::Test {
 protected:
  void SetUp() override {
    RefineOptions options;
    options.order = 3;
    options.size = 0.1;
    options.geometry_tol = 0.1;
    Report report;
    before_ = refine(samples::block_layout(), options, report);
    const auto corner = std::ranges::find(before_.nodes, Vec2{0, 0});
    ASSERT_NE(corner, before_.nodes.end());
    std::map<QuadSide, int> curves;
    for (const QuadBoundaryEdge& e : before_.boundary_edges) curves[{e.elem, e.side}] = e.curve;
    patches_ = tip_patches(before_, static_cast<int>(corner - before_.nodes.begin()), 2, curves);
    ASSERT_EQ(patches_.size(), 1U);
    after_ = before_;
  }

  QuadMesh before_, after_;
  std::vector<TipPatch> patches_;
};

TEST_F(TipRounding, VerticesMoveAlongTheirRaysTowardsTheCircle) {
  const TipPatch& patch = patches_[0];
  round_outer_vertices(patch, {}, after_);
  const Vec2 from = before_.nodes[patch.vertex(2, 2)], to = after_.nodes[patch.vertex(2, 2)];
  EXPECT_NEAR(cross(from, to), 0, 1e-15);
  EXPECT_LT(norm(to), 0.9 * norm(from));
  EXPECT_GE(norm(to), norm(before_.nodes[patch.outer_vertex(0)]));
  for (const int end : {0, 4}) EXPECT_EQ(after_.nodes[patch.outer_vertex(end)], before_.nodes[patch.outer_vertex(end)]);
}

TEST_F(TipRounding, FixedVerticesAndOtherElementsStay) {
  const TipPatch& patch = patches_[0];
  round_outer_vertices(patch, {patch.outer_vertex(1), patch.outer_vertex(2), patch.outer_vertex(3)}, after_);
  EXPECT_EQ(after_.nodes, before_.nodes);
  round_outer_vertices(patch, {}, after_);
  for (std::size_t k = 0; k < before_.nodes.size(); ++k)
    if (norm(before_.nodes[k]) > 0.5) {
      EXPECT_EQ(after_.nodes[k], before_.nodes[k]);
    }
}

}  // namespace
}  // namespace quadrille::refine
