#include "chain/chain_nodes.hpp"

#include <gtest/gtest.h>

#include "../region_samples.hpp"
#include "../support/texts.hpp"
#include "base/error.hpp"
#include "sample_chain.hpp"

namespace quadrille::chain {
namespace {

/// A run with a field, of which critpoints finds no irregular node but eight corners.
class MakeNodes : public testing::Test {
 protected:
  MakeNodes() { chain_.files.field.set(samples::two_regions_field(), false); }

  NodeFiles& files() { return chain_.files.of_nodes; }
  bool make(const std::vector<std::string>& words = {}) { return make_nodes(chain_, files(), words); }
  /// As after a run until critpoints, and in a later run from it on.
  CriticalPoints found_before() {
    chain_.keeps_files = true;
    EXPECT_TRUE(make());
    CriticalPoints points = files().nodes.release();
    run_.options.first = ChainStage::critpoints;
    run_.options.from = "critpoints";
    return points;
  }
  /// With one more node.
  static CriticalPoints with_node(CriticalPoints points, NodeSource source) {
    CriticalPoint node;
    node.position = {0.5, 0.5};
    node.index = 1;
    node.valence = 3;
    node.source = source;
    points.critical_points.push_back(node);
    return points;
  }
  CriticalPoints present() { return io::read_stage<CriticalPoints>(io::read_input(files().nodes.path())); }

  SampleChain run_;
  ChainState& chain_ = run_.chain;
};

TEST_F(MakeNodes, finds_those_of_the_field) {
  EXPECT_TRUE(make());
  EXPECT_EQ(files().nodes.model().corners.size(), 8U);
  EXPECT_EQ(chain_.num_nodes, files().nodes.model().critical_points.size());
  EXPECT_EQ(chain_.form, files().nodes.model().form);
  EXPECT_FALSE(chain_.has_fixed_nodes);
  EXPECT_FALSE(run_.folder.has("shape.crit.json"));
}

TEST_F(MakeNodes, words_are_added_to_the_chosen_options) {
  EXPECT_TRUE(make({"--corner-valence", "4:5=2"}));
  EXPECT_EQ(chain_.num_nodes, 1U);
  errors_of([&] { EXPECT_EQ(failure_of([&] { make({"--corner-valence", "9:9=2"}); }).code, ExitCode::usage); });
}

TEST_F(MakeNodes, copies_those_of_a_user) {
  const std::string bytes = io::stage_bytes(samples::critical_points());
  run_.options.nodes_file = run_.put("given.json", bytes);
  EXPECT_TRUE(make());
  EXPECT_EQ(run_.content("shape.crit.json"), bytes);
  EXPECT_EQ(files().nodes.name(), run_.folder.file("given.json")) << "in messages";
  EXPECT_EQ(chain_.num_nodes, 2U);
  EXPECT_TRUE(chain_.has_fixed_nodes);
  EXPECT_TRUE(run_.runner.reports().empty());
}

TEST_F(MakeNodes, takes_those_of_standard_input_if_they_keep_their_rules) {
  run_.options.nodes_file = "-";
  chain_.standard_input = io::stage_bytes(samples::critical_points());
  EXPECT_TRUE(make());
  EXPECT_EQ(run_.content("shape.crit.json"), *chain_.standard_input);
  chain_.standard_input = io::stage_bytes(samples::tri_mesh());
  EXPECT_THROW(make(), FormatError);
}

TEST_F(MakeNodes, does_not_run_critpoints_before_the_first_stage) {
  found_before();
  run_.options.first = ChainStage::separatrix;
  chain_.num_nodes = 99;
  EXPECT_TRUE(make());
  EXPECT_EQ(chain_.num_nodes, 0U);
  EXPECT_TRUE(chain_.has_fixed_nodes);
  EXPECT_EQ(run_.runner.reports().size(), 1U);
}

TEST_F(MakeNodes, found_again_they_are_the_same) {
  const std::string bytes = io::stage_bytes(found_before());
  EXPECT_TRUE(make());
  EXPECT_EQ(run_.content("shape.crit.json"), bytes);
  EXPECT_FALSE(chain_.has_fixed_nodes);
  EXPECT_EQ(chain_.last, files().nodes.path());
}

TEST_F(MakeNodes, edited_ones_are_kept) {
  for (const NodeSource source : {NodeSource::zero, NodeSource::hand}) {
    io::write_stage(files().nodes.path(), with_node(found_before(), source));
    expect_contains(errors_of([&] { EXPECT_TRUE(make()); }), "was edited after critpoints wrote it");
    EXPECT_TRUE(chain_.has_fixed_nodes);
    EXPECT_EQ(chain_.num_nodes, 1U);
    EXPECT_EQ(present().critical_points.size(), 1U);
    std::filesystem::remove(files().nodes.path());
    chain_.has_fixed_nodes = false;
    run_.options.first = ChainStage::cad2tri;
  }
}

TEST_F(MakeNodes, those_of_other_options_are_replaced) {
  io::write_stage(files().nodes.path(), with_node(found_before(), NodeSource::zero));
  chain_.values.critpoints.corner_valences = {"4:5=2"};
  EXPECT_TRUE(make());
  EXPECT_FALSE(chain_.has_fixed_nodes);
  EXPECT_GT(present().critical_points.at(0).position.x, 1) << "in the file too";
  EXPECT_EQ(files().nodes.input().file.sha256, io::read_input(files().nodes.path()).sha256);
}

TEST_F(MakeNodes, those_set_by_hand_with_other_options_are_refused) {
  io::write_stage(files().nodes.path(), with_node(found_before(), NodeSource::hand));
  chain_.values.critpoints.corner_valences = {"4:5=2"};
  const ChainFailure failure = failure_of([&] { make(); });
  EXPECT_EQ(failure.code, ExitCode::usage);
  expect_contains(failure.message, "was edited, but made with other options of critpoints");
  EXPECT_EQ(present().critical_points.at(0).position, (Vec2{0.5, 0.5}));
}

TEST_F(MakeNodes, a_dry_run_prints_a_copy) {
  run_.options.is_dry_run = true;
  run_.options.nodes_file = "-";
  EXPECT_EQ(output_of([&] { make(); }), "cp /dev/stdin " + files().nodes.path() + "\n");
}

TEST_F(MakeNodes, a_field_of_their_own_is_needed_by_form_or_if_they_are_not_of_the_field) {
  CriticalPoints points = found_before();
  run_.options.first = ChainStage::cad2tri;
  files().nodes.set(points, false);
  chain_.has_fixed_nodes = true;
  EXPECT_FALSE(needs_own_field(chain_, files()));
  chain_.files.field.read({{"x.field.h5", "another digest"}, io::stage_bytes(samples::two_regions_field())});
  EXPECT_TRUE(needs_own_field(chain_, files()));
  chain_.has_fixed_nodes = false;
  EXPECT_FALSE(needs_own_field(chain_, files())) << "as critpoints found them";
  points.form = NodeForm::phase;
  files().nodes.set(points, false);
  EXPECT_TRUE(have_phase_form(chain_, files()));
  EXPECT_TRUE(needs_own_field(chain_, files()));
}

TEST(HavePhaseForm, is_read_from_the_file_if_there_is_one) {
  SampleChain run;
  EXPECT_FALSE(have_phase_form(run.chain, run.chain.files.of_nodes));
  io::write_stage(run.folder.file("given.json"), samples::resolved_points());
  run.options.nodes_file = run.folder.file("given.json");
  EXPECT_TRUE(have_phase_form(run.chain, run.chain.files.of_nodes));
}

TEST(RequireNodes, that_keep_their_rules) {
  const auto refusal = [](const std::string& bytes) {
    return message_of<FormatError>([&] { require_nodes({{"given.json", ""}, bytes}); });
  };
  CriticalPoints points = samples::critical_points();
  EXPECT_EQ(refusal(io::stage_bytes(points)), "");
  points.index_sum_expected = 3;
  EXPECT_TRUE(refusal(io::stage_bytes(points)).starts_with("given.json: CRT-R"));
  EXPECT_EQ(refusal(io::stage_bytes(samples::quad_mesh())),
            "given.json: expected a critical-points file (x.crit.json), found format quad-mesh");
}

}  // namespace
}  // namespace quadrille::chain
