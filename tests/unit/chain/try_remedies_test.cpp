#include "chain/try_remedies.hpp"

#include <gtest/gtest.h>

#include "../samples.hpp"
#include "sample_chain.hpp"

namespace quadrille::chain {

namespace {

constexpr const char* report_with_remedies = R"({"tool": "separatrix", "exit_code": 0,
  "certificate": {"method": "midpoint"}, "quantize": {"remedies": "--corner-absorb 0, --ties field"},
  "other_grids": "--topology o"})";

/// A run after separatrix could only divide triangles. Programs that know one remedy take the place of critpoints and
/// separatrix: the former writes its words to the file `tried`.
class TryRemedies : public testing::Test {
 protected:
  TryRemedies() {
    run_.put("nodes.json", io::stage_bytes(samples::critical_points()));
    run_.put("graph.json", io::stage_bytes(samples::separatrix_graph()));
    run_.options.is_quiet = true;
    chain_.has_other_way = true;
    chain_.files.field.set(samples::field(), false);
    run_.put("shape.crit.json", "nodes before");
    run_.put("shape.sep.json", "graph before");
    chain_.last = run_.folder.file("shape.sep.json");
    chain_.num_nodes = 7;
    run_.runner.reports().push_back({"separatrix", report_with_remedies});
  }

  /// Runs them; `remedy` is the one that gives a layout.
  void try_with(const std::string& remedy) {
    program(ChainStage::critpoints,
            "echo $2 $3 >>tried; cp nodes.json \"$OUT\"; echo '{\"tool\": \"critpoints\"}' >$REPORT");
    program(ChainStage::separatrix, "method=midpoint; test \"$(tail -n 1 tried)\" = '" + remedy +
                                        "' && method=traced; cp graph.json \"$OUT\"; echo '{\"tool\": \"separatrix\", "
                                        "\"certificate\": {\"method\": \"'$method'\"}}' >$REPORT");
    try_remedies(chain_);
  }
  /// What the program does, in the folder of the run, with its paths OUT and REPORT.
  void program(ChainStage stage, const std::string& work) {
    const std::string find =
        "for word; do case $before in -o) OUT=$word;; --report) REPORT=$word;; esac; "
        "before=$word; done; cd '" +
        run_.folder.path() + "'; ";
    run_.options.programs[stage] = "sh '" + run_.put(enum_name(stage) + ".sh", find + work) + "'";
  }

  SampleChain run_;
  ChainState& chain_ = run_.chain;
};

TEST_F(TryRemedies, the_first_that_gives_a_layout_is_taken) {
  try_with("--ties field");
  EXPECT_EQ(run_.content("tried"), "--corner-absorb 0\n--ties field\n");
  EXPECT_EQ(run_.stages(), "trial_separatrix trial_critpoints trial_separatrix remedy_critpoints remedy_separatrix ");
  EXPECT_EQ(chain_.remedy, "critpoints --ties field");
  EXPECT_EQ(run_.content("shape.crit.json"), run_.content("nodes.json"));
  EXPECT_EQ(run_.content("shape.sep.json"), run_.content("graph.json"));
  EXPECT_FALSE(run_.folder.has("shape.remedy.crit.json") || run_.folder.has("shape.remedy.sep.json"));
  EXPECT_EQ(chain_.last, run_.folder.file("shape.sep.json"));
  EXPECT_EQ(chain_.num_nodes, 2U);
  EXPECT_EQ(chain_.files.of_nodes.graph.model().arcs.size(), 7U);
  EXPECT_EQ(chain_.prefix, "");
}

TEST_F(TryRemedies, without_success_nothing_changes) {
  try_with("none");
  EXPECT_EQ(run_.content("tried"), "--corner-absorb 0\n--ties field\n--topology o\n");
  EXPECT_TRUE(run_.stages().starts_with("separatrix trial_critpoints trial_separatrix trial_critpoints "))
      << run_.stages();
  EXPECT_EQ(chain_.remedy, "");
  EXPECT_EQ(run_.content("shape.crit.json"), "nodes before");
  EXPECT_EQ(run_.content("shape.sep.json"), "graph before");
  EXPECT_FALSE(run_.folder.has("shape.remedy.crit.json") || run_.folder.has("shape.remedy.sep.json"));
  EXPECT_EQ(chain_.num_nodes, 7U);
  EXPECT_FALSE(chain_.given_up);
  EXPECT_TRUE(chain_.has_other_way);
}

TEST_F(TryRemedies, options_of_the_user_are_not_replaced) {
  run_.options.words["critpoints"] = {"--ties", "rule"};
  try_with("--topology o");
  EXPECT_EQ(run_.content("tried"), "--corner-absorb 0\n--topology o\n");
  EXPECT_EQ(chain_.remedy, "critpoints --topology o");
}

TEST_F(TryRemedies, a_remedy_that_fails_is_followed_by_the_next) {
  program(ChainStage::critpoints, "exit 1");
  program(ChainStage::separatrix, "exit 1");
  try_remedies(chain_);
  EXPECT_EQ(run_.stages(), "separatrix trial_critpoints trial_critpoints trial_critpoints ");
  EXPECT_FALSE(chain_.given_up);
}

TEST_F(TryRemedies, a_layout_needs_none) {
  run_.runner.reports()[0].json = R"({"certificate": {"method": "traced"}, "other_grids": "--topology o"})";
  try_with("--topology o");
  EXPECT_FALSE(run_.folder.has("tried"));
  run_.runner.reports()[0].json = R"({"certificate": {"method": "midpoint"}})";
  try_with("--topology o");
  EXPECT_FALSE(run_.folder.has("tried")) << "none is proposed";
}

TEST_F(TryRemedies, nodes_of_the_user_stay) {
  chain_.has_fixed_nodes = true;
  try_with("--ties field");
  EXPECT_FALSE(run_.folder.has("tried"));
  chain_.has_fixed_nodes = false;
  chain_.has_other_way = false;
  try_with("--ties field");
  EXPECT_FALSE(run_.folder.has("tried")) << "the user chose the layout";
}

}  // namespace

}  // namespace quadrille::chain
