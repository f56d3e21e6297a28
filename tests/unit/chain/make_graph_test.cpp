#include "chain/make_graph.hpp"

#include <gtest/gtest.h>

#include "../region_samples.hpp"
#include "../support/texts.hpp"
#include "chain/chain_nodes.hpp"
#include "sample_chain.hpp"

namespace quadrille::chain {
namespace {

/// A run whose field on two squares side by side and its nodes, the corners alone, were found.
class MakeGraph : public testing::Test {
 protected:
  MakeGraph() {
    chain_.keeps_files = true;
    chain_.files.triangles.set(samples::two_regions_mesh(), true);
    Field field = samples::two_regions_field();
    field.provenance = {{"fieldsolve", "0.1.0", {chain_.files.triangles.input().file.digest("tri-mesh")}, "{}"}};
    chain_.files.field.set(std::move(field), true);
    EXPECT_TRUE(make_nodes(chain_, files(), {}));
    run_.runner.reports().clear();
  }

  NodeFiles& files() { return chain_.files.of_nodes; }
  /// As if by hand: a node of valence 3 in the left square and one more block at its first corner.
  void edit_nodes(NodeForm form) {
    CriticalPoints points = files().nodes.release();
    CriticalPoint node;
    node.position = {0.4, 0.6}, node.index = 1, node.valence = 3, node.source = NodeSource::hand;
    points.critical_points.push_back(node);
    points.corners[0].valence = 2;
    points.form = form;
    files().nodes.set(std::move(points), true);
    chain_.has_fixed_nodes = true;
  }

  SampleChain run_;
  ChainState& chain_ = run_.chain;
};

TEST_F(MakeGraph, nodes_of_the_field_are_traced_in_it) {
  EXPECT_TRUE(make_graph(chain_, files()));
  EXPECT_EQ(run_.stages(), "separatrix ");
  EXPECT_EQ(files().graph.model().face.num_regions(), 2);
  EXPECT_EQ(chain_.last, files().graph.path());
  EXPECT_FALSE(run_.folder.has("shape.phase.h5"));
  EXPECT_TRUE(make_blocks(chain_, files()));
  EXPECT_EQ(files().blocks.model().num_blocks(), 2);
  EXPECT_EQ(chain_.last, files().blocks.path());
}

TEST_F(MakeGraph, nodes_of_the_phase_form_have_a_field_of_their_own) {
  edit_nodes(NodeForm::phase);
  EXPECT_TRUE(make_graph(chain_, files()));
  EXPECT_EQ(run_.stages(), "phase_fieldsolve phase_padapt separatrix ");
  EXPECT_EQ(files().phase.model().kind, FieldKind::phase);
  EXPECT_FALSE(files().phase_solve.is_in_memory());
  EXPECT_EQ(files().graph.model().provenance.back().inputs.at(0).sha256, files().phase.input().file.sha256);
}

TEST_F(MakeGraph, so_have_edited_nodes_that_the_field_does_not_have) {
  edit_nodes(NodeForm::harmonic);
  EXPECT_TRUE(make_graph(chain_, files()));
  EXPECT_EQ(run_.stages(), "phase_fieldsolve phase_padapt separatrix ");
}

TEST_F(MakeGraph, a_field_that_is_not_found_ends_the_work_if_there_is_another_way) {
  edit_nodes(NodeForm::phase);
  run_.options.programs[ChainStage::fieldsolve] = "exit 1 #";
  run_.options.is_quiet = true;
  chain_.has_other_way = true;
  EXPECT_FALSE(make_graph(chain_, files()));
  EXPECT_EQ(run_.stages(), "phase_fieldsolve ");
  ASSERT_TRUE(chain_.given_up);
  EXPECT_FALSE(run_.folder.has("shape.sep.json"));
}

TEST_F(MakeGraph, a_dry_run_states_when_a_field_of_the_nodes_is_solved) {
  run_.options.is_dry_run = true;
  const std::string printed = output_of([&] { EXPECT_TRUE(make_graph(chain_, files())); });
  expect_contains(printed, "# if \"form\" is \"phase\" in " + files().nodes.path() + ", or its nodes were edited; " +
                               "separatrix then reads " + files().phase.path() + ":\n");
  expect_counts(printed, {{"\n# fieldsolve --nodes ", 1}, {"\n# padapt ", 1}, {"\nseparatrix ", 1}});
  EXPECT_EQ(chain_.comment, "");
  EXPECT_EQ(chain_.last, files().graph.path());
}

TEST_F(MakeGraph, a_dry_run_with_nodes_of_the_phase_form_solves_it) {
  edit_nodes(NodeForm::phase);
  run_.options.is_dry_run = true;
  const std::string printed = output_of([&] { EXPECT_TRUE(make_graph(chain_, files())); });
  EXPECT_TRUE(printed.starts_with("fieldsolve --nodes " + files().nodes.path() + " --orders " +
                                  chain_.files.field.path() + ' ' + chain_.files.triangles.path() + " -o "))
      << printed;
  expect_contains(printed, "\nseparatrix " + files().phase.path() + ' ' + files().nodes.path());
  EXPECT_EQ(count(printed, "#"), 0);
}

TEST_F(MakeGraph, a_run_that_ends_before_it_makes_none) {
  edit_nodes(NodeForm::phase);
  run_.options.last = ChainStage::critpoints;
  const std::string before = chain_.last;
  EXPECT_TRUE(make_graph(chain_, files()));
  EXPECT_EQ(run_.stages(), "");
  EXPECT_EQ(chain_.last, before);
}

}  // namespace
}  // namespace quadrille::chain
