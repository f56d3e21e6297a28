#include "chain/end_of_run.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "../support/texts.hpp"
#include "sample_chain.hpp"

namespace quadrille::chain {

namespace {

/// A run that made a mesh of 8 quads.
class EndOfRun : public testing::Test {
 protected:
  EndOfRun() {
    run_.options.output = "x.msh";
    run_.runner.reports().push_back(
        {"quadexport", R"({"tool": "quadexport", "quads": 8, "timings": {"total": {"cpu_seconds": 1}}})"});
    chain_.form = NodeForm::phase;
    chain_.num_nodes = 3;
    chain_.remedy = "critpoints --ties field";
  }

  io::StageReport report() const { return {"quadmesh", run_.content("r.json")}; }

  SampleChain run_;
  ChainState& chain_ = run_.chain;
};

TEST_F(EndOfRun, a_line_about_the_mesh_is_printed) {
  EXPECT_EQ(output_of([&] { end_run(chain_); }), "8 quads\n");
  run_.options.is_verbose = true;
  EXPECT_TRUE(output_of([&] { end_run(chain_); }).starts_with("quadexport       1 s CPU, 100 %\nall stages "));
  run_.options.is_quiet = true;
  EXPECT_EQ(output_of([&] { end_run(chain_); }), "");
}

TEST_F(EndOfRun, the_line_is_not_mixed_with_a_mesh_or_report_on_standard_output) {
  for (const char* output : {"", "-"}) {
    run_.options.output = output;
    EXPECT_EQ(output_of([&] { EXPECT_EQ(errors_of([&] { end_run(chain_); }), "8 quads\n"); }), "");
  }
  run_.options.output = "x.msh";
  run_.options.report = "-";
  expect_contains(output_of([&] { EXPECT_EQ(errors_of([&] { end_run(chain_); }), "8 quads\n"); }), "\"quads\": 8");
}

TEST_F(EndOfRun, a_part_of_the_chain_ends_with_the_name_of_its_file) {
  run_.options.last = ChainStage::padapt;
  run_.options.until = "padapt";
  run_.options.output = "";
  run_.options.workdir = "w";
  chain_.last = "w/x.field.h5";
  EXPECT_EQ(output_of([&] { end_run(chain_); }), "stages up to padapt: w/x.field.h5\n");
  run_.options.workdir = "";
  run_.options.output = "y.field.h5";
  EXPECT_EQ(output_of([&] { end_run(chain_); }), "stages up to padapt: y.field.h5\n");
  run_.options.output = "";
  EXPECT_EQ(errors_of([&] { end_run(chain_); }), "stages up to padapt: standard output\n");
  run_.options.last = ChainStage::quadrefine;
  EXPECT_EQ(errors_of([&] { end_run(chain_); }), "8 quads\n");
}

TEST_F(EndOfRun, the_report_states_the_facts_of_the_run) {
  run_.options.report = run_.folder.file("r.json");
  output_of([&] { end_run(chain_); });
  EXPECT_EQ(io::value_of(report(), "form"), "phase");
  EXPECT_EQ(io::value_of(report(), "critical_points"), "3");
  EXPECT_EQ(io::value_of(report(), "remedy"), "critpoints --ties field");
  EXPECT_EQ(io::value_of(report(), "exit_code"), "0");
  EXPECT_TRUE(io::value_of(report(), "wall_seconds"));
}

TEST_F(EndOfRun, after_a_failure_the_report_has_it_and_a_line_tells_where_to_look) {
  run_.options.report = run_.folder.file("r.json");
  chain_.last = "x.tri.h5";
  const std::string hint =
      "quadmesh: run it again with --workdir DIR to keep the files of the stages before padapt and a picture\n";
  EXPECT_EQ(errors_of([&] { end_failed_run(chain_, {ExitCode::no_result, "padapt", "no field"}); }), hint);
  EXPECT_EQ(io::value_of(report(), "exit_code"), "1");
  EXPECT_EQ(io::value_of(report(), "stage"), "padapt");
  EXPECT_EQ(io::value_of(report(), "error"), "no field");
  EXPECT_EQ(errors_of([&] { end_failed_run(chain_, {ExitCode::defect, "padapt", "no field"}); }), hint);
  EXPECT_EQ(errors_of([&] { end_failed_run(chain_, {ExitCode::usage, "padapt", "--x"}); }), "") << "not the shape's";
  chain_.last.clear();
  EXPECT_EQ(errors_of([&] { end_failed_run(chain_, {ExitCode::no_result, "padapt", "no field"}); }), "");
}

TEST_F(EndOfRun, a_report_that_cannot_be_written_is_told_once) {
  const std::string path = run_.options.report = run_.folder.file("none/r.json");
  const std::string errors = errors_of([&] { end_failed_run(chain_, {ExitCode::usage, "padapt", "--x"}); });
  EXPECT_TRUE(errors.starts_with("quadmesh: " + path + ": cannot be written")) << errors;
  const ChainFailure failure{ExitCode::bad_output, "quadmesh", path + ": cannot be written: there is no folder"};
  EXPECT_EQ(errors_of([&] { end_failed_run(chain_, failure); }), "");
}

TEST(CommandPath, is_beside_this_program_or_left_to_the_shell) {
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe");
  EXPECT_EQ(command_path(self.filename().string()), self.string());
  EXPECT_EQ(command_path("no-such-program"), "no-such-program");
}

TEST(CommandPath, of_scripts_is_in_the_source_tree) {
  EXPECT_TRUE(command_path("points2step").ends_with("/pipelines/points2step")) << command_path("points2step");
}

}  // namespace

}  // namespace quadrille::chain
