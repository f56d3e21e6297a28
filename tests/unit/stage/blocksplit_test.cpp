#include "stage/blocksplit.hpp"

#include <gtest/gtest.h>

#include "../region_layout_samples.hpp"
#include "base/error.hpp"
#include "block/make_blocks.hpp"

namespace quadrille::stage {
namespace {

struct Blocksplit : testing::Test {
  SeparatrixGraph graph = samples::two_regions_graph();
  quadrille::Run run;  // a fixture has a member Run

  BlockLayout blocks(const std::optional<Input<std::vector<NameRule>>>& names) {
    return blocksplit({graph, {"x.sep.json", "digest of the graph"}}, names, {}, run);
  }
};

TEST_F(Blocksplit, BlocksAreThoseOfTheGraphWithTheNamesOfTheirRegions) {
  const BlockLayout layout = blocks({});
  EXPECT_EQ(layout.block_names, (std::vector<std::string>{"fluid", "solid"}));
  Report report;
  EXPECT_EQ(layout.num_blocks(), block::make_blocks(graph, report).layout.num_blocks());
  ASSERT_EQ(layout.provenance.size(), graph.provenance.size() + 1);
  EXPECT_EQ(layout.provenance.back().tool, "blocksplit");
  ASSERT_EQ(layout.provenance.back().inputs.size(), 1u);
  EXPECT_EQ(layout.provenance.back().inputs.front().sha256, "digest of the graph");
}

TEST_F(Blocksplit, RulesNameBlocksAndAreAnInput) {
  NameRule all;
  all.name = "all";
  const std::vector<NameRule> rules{all};
  const BlockLayout layout = blocks(Input<std::vector<NameRule>>(rules, {"names.json", "digest of the names"}));
  EXPECT_EQ(layout.block_names, (std::vector<std::string>{"all", "all"}));
  ASSERT_EQ(layout.provenance.back().inputs.size(), 2u);
  EXPECT_EQ(layout.provenance.back().inputs.back().format, "block-names");
}

TEST_F(Blocksplit, AGraphThatBreaksARuleIsRefusedByName) {
  graph.arcs[0].to = 99;
  try {
    blocks({});
    FAIL() << "no exception";
  } catch (const FormatError& error) {
    EXPECT_NE(std::string(error.what()).find("x.sep.json"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace quadrille::stage
