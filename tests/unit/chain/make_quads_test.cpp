#include "chain/make_quads.hpp"

#include <gtest/gtest.h>

#include "../region_samples.hpp"
#include "../support/texts.hpp"
#include "sample_chain.hpp"

namespace quadrille::chain {
namespace {

/// A run after cad2tri, on two squares side by side.
class MakeQuads : public testing::Test {
 protected:
  MakeQuads() {
    chain_.files.triangles.set(samples::two_regions_mesh(), false);
    chain_.values.quadrefine.sizes.size = 0.5;
  }

  /// The stage finds no valid result.
  void fail(ChainStage stage) { run_.options.programs[stage] = "exit 1 #"; }

  SampleChain run_;
  ChainState& chain_ = run_.chain;
};

TEST_F(MakeQuads, are_those_of_the_field) {
  make_quads(chain_);
  EXPECT_EQ(run_.stages(), "fieldsolve padapt critpoints separatrix blocksplit quadrefine ");
  EXPECT_EQ(chain_.files.of_nodes.quads.model().num_elems(), 8) << "2 x 2 in each square";
  EXPECT_FALSE(chain_.has_other_way);
  EXPECT_FALSE(chain_.files.solve.is_in_memory()) << "padapt has read it";
}

TEST_F(MakeQuads, of_the_layout_midpoint_need_no_field) {
  chain_.values.separatrix.layout = layout::LayoutChoice::midpoint;
  make_quads(chain_);
  EXPECT_EQ(run_.stages(), "separatrix blocksplit quadrefine ");
  EXPECT_EQ(chain_.files.of_nodes.graph.model().certificate.method, LayoutMethod::midpoint);
}

TEST_F(MakeQuads, without_a_field_are_made_of_triangles) {
  fail(ChainStage::critpoints);
  const std::string errors = errors_of([&] { make_quads(chain_); });
  expect_contains(errors, "quadmesh: critpoints found no valid result: the quads are made without a field\n");
  EXPECT_EQ(run_.stages(), "fieldsolve padapt critpoints midpoint_separatrix midpoint_blocksplit midpoint_quadrefine ");
  EXPECT_EQ(chain_.files.of_nodes.graph.model().certificate.method, LayoutMethod::midpoint);
  EXPECT_GT(chain_.files.of_nodes.quads.model().num_elems(), 8);
  EXPECT_EQ(chain_.prefix, "");
  EXPECT_FALSE(chain_.has_other_way);
}

TEST_F(MakeQuads, fail_where_the_user_chose_the_layout) {
  chain_.values.separatrix.layout = layout::LayoutChoice::traced;
  fail(ChainStage::fieldsolve);
  errors_of([&] {
    const ChainFailure failure = failure_of([&] { make_quads(chain_); });
    EXPECT_EQ(failure.code, ExitCode::no_result);
    EXPECT_EQ(failure.stage, "fieldsolve");
  });
  EXPECT_EQ(run_.stages(), "fieldsolve ");
}

/// A run that ends with the nodes makes no quads of triangles.
TEST_F(MakeQuads, fail_where_the_run_ends_before_the_layout) {
  run_.options.last = ChainStage::critpoints;
  fail(ChainStage::padapt);
  errors_of([&] { EXPECT_EQ(failure_of([&] { make_quads(chain_); }).stage, "padapt"); });
  EXPECT_EQ(run_.stages(), "fieldsolve padapt ");
}

}  // namespace
}  // namespace quadrille::chain
