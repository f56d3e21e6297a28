#include "chain/chain_state.hpp"

#include <gtest/gtest.h>

#include "../samples.hpp"
#include "../support/texts.hpp"
#include "base/error.hpp"
#include "sample_chain.hpp"
#include "temporary_folder.hpp"

namespace quadrille::chain {

namespace {

TEST(StageFile, keeps_a_struct_in_memory_until_its_file_is_needed) {
  const TemporaryFolder folder;
  StageFile<TriMesh> file(folder.file("x.tri.h5"));
  EXPECT_FALSE(file.is_in_memory());
  EXPECT_THROW(file.input(), FormatError);
  file.set(samples::tri_mesh(), false);
  EXPECT_TRUE(file.is_in_memory());
  EXPECT_FALSE(folder.has("x.tri.h5"));
  EXPECT_EQ(file.input().file.sha256, "") << "not known";
  file.write();
  EXPECT_EQ(file.input().file.sha256, io::read_input(file.path()).sha256);
  EXPECT_EQ(file.input().file.name, file.path());
}

TEST(StageFile, reads_what_another_program_wrote) {
  const TemporaryFolder folder;
  StageFile<TriMesh> file(folder.file("x.tri.h5"));
  file.set(samples::tri_mesh(), true);
  TriMesh other = samples::tri_mesh();
  other.face.name = "other";
  io::write_stage(file.path(), other);
  EXPECT_EQ(file.model().face.name, "square");
  file.forget();
  EXPECT_EQ(file.model().face.name, "other");
  EXPECT_EQ(file.input().file.sha256, io::read_input(file.path()).sha256);
}

TEST(StageFile, releases_its_struct) {
  const TemporaryFolder folder;
  StageFile<TriMesh> file(folder.file("x.tri.h5"));
  file.set(samples::tri_mesh(), true);
  EXPECT_EQ(file.release().face.name, "square");
  EXPECT_FALSE(file.is_in_memory());
  EXPECT_EQ(file.release().face.name, "square") << "from the file";
}

TEST(StageFile, a_struct_of_another_file_has_its_name_and_digest) {
  const TemporaryFolder folder;
  StageFile<TriMesh> file(folder.file("x.tri.h5"));
  const std::string bytes = io::stage_bytes(samples::tri_mesh());
  file.read({{"other.h5", "digest"}, bytes});
  EXPECT_EQ(file.input().file.name, "other.h5");
  EXPECT_EQ(file.input().file.sha256, "digest");
  EXPECT_EQ(file.path(), folder.file("x.tri.h5"));
  StageFile<TriMesh> taking(folder.file("y.tri.h5"));
  taking.take(file);
  EXPECT_FALSE(file.is_in_memory());
  EXPECT_EQ(taking.input().file.sha256, "digest");
  EXPECT_EQ(taking.input().file.name, folder.file("y.tri.h5"));
}

using Texts = std::vector<std::string>;

void nothing(quadrille::Run&) {}
void no_result(quadrille::Run&) { throw ComputeError("no result"); }

TEST(RunStage, notes_the_report_and_the_last_file) {
  SampleChain run;
  EXPECT_TRUE(run_stage(run.chain, task_of(ChainStage::padapt, nothing)));
  StageTask phase = task_of(ChainStage::padapt, nothing);
  phase.is_of_phase = true;
  phase.output = "phase";
  run.chain.prefix = "remedy_";
  EXPECT_TRUE(run_stage(run.chain, phase));
  ASSERT_EQ(run.runner.reports().size(), 2U);
  EXPECT_EQ(run.runner.reports()[0].stage, "padapt");
  EXPECT_EQ(run.runner.reports()[1].stage, "remedy_phase_padapt");
  EXPECT_EQ(run.chain.last, "phase");
}

TEST(RunStage, runs_no_stage_outside_the_range) {
  SampleChain run;
  run.options.first = ChainStage::critpoints;
  run.options.last = ChainStage::separatrix;
  EXPECT_TRUE(run_stage(run.chain, task_of(ChainStage::padapt, no_result)));
  EXPECT_EQ(run.chain.last, "out") << "a file of a stage before";
  run.chain.last = "before";
  EXPECT_TRUE(run_stage(run.chain, task_of(ChainStage::blocksplit, no_result)));
  EXPECT_EQ(run.chain.last, "before");
  EXPECT_TRUE(run.runner.reports().empty());
  StageTask phase = task_of(ChainStage::padapt, nothing);
  phase.is_of_phase = true;
  run_stage(run.chain, phase);
  EXPECT_EQ(run.runner.reports().size(), 1U) << "a part of separatrix";
}

TEST(RunStage, prints_the_command_of_a_dry_run) {
  SampleChain run;
  run.read({"--ties", "field", "--threads", "2", "--dry-run"});
  run.chain.added["critpoints"] = {"--clearance", "a b=1"};
  run.chain.comment = "# ";
  EXPECT_EQ(output_of([&] { run_stage(run.chain, task_of(ChainStage::critpoints, no_result)); }),
            "# critpoints in --ties field --clearance 'a b=1' -o out --threads 2\n");
  EXPECT_EQ(run.chain.last, "out");
}

TEST(RunStage, goes_on_where_there_is_another_way) {
  SampleChain run;
  run.chain.has_other_way = true;
  for (const ChainStage stage :
       {ChainStage::fieldsolve, ChainStage::padapt, ChainStage::critpoints, ChainStage::separatrix}) {
    run.chain.given_up.reset();
    EXPECT_EQ(errors_of([&] { EXPECT_FALSE(run_stage(run.chain, task_of(stage, no_result))); }),
              enum_name(stage) + ": no result\n");
    ASSERT_TRUE(run.chain.given_up);
    EXPECT_EQ(run.chain.given_up->message, "no result");
    EXPECT_EQ(run.chain.last, "");
  }
}

TEST(RunStage, ends_with_a_failure_otherwise) {
  SampleChain run;
  const auto failure = [&](ChainStage stage, const std::function<void(quadrille::Run&)>& compute) {
    ChainFailure found;
    errors_of([&] { found = failure_of([&] { run_stage(run.chain, task_of(stage, compute)); }); });
    return found;
  };
  const ChainFailure first = failure(ChainStage::padapt, no_result);
  EXPECT_EQ(first.code, ExitCode::no_result);
  EXPECT_EQ(first.stage, "padapt");
  EXPECT_EQ(first.message, "no result");
  run.chain.has_other_way = true;
  for (const ChainStage stage :
       {ChainStage::cad2tri, ChainStage::blocksplit, ChainStage::quadrefine, ChainStage::quadexport})
    EXPECT_EQ(failure(stage, no_result).code, ExitCode::no_result) << enum_name(stage);
  EXPECT_EQ(failure(ChainStage::padapt, [](quadrille::Run&) { throw UsageError("no"); }).code, ExitCode::usage);
  EXPECT_EQ(failure(ChainStage::padapt, [](quadrille::Run&) { throw FormatError("no"); }).code, ExitCode::bad_input);
  EXPECT_EQ(failure(ChainStage::padapt, [](quadrille::Run&) { throw Defect("no"); }).code, ExitCode::defect);
  EXPECT_FALSE(run.chain.given_up);
}

TEST(RunStage, goes_on_after_quads_that_are_not_valid) {
  SampleChain run;
  run.chain.has_other_way = true;
  const auto with_validity = [](bool is_valid) {
    return task_of(ChainStage::quadrefine, [is_valid](quadrille::Run& stage_run) {
      stage_run.report().set("valid", is_valid);
      throw ComputeError("not as prescribed");
    });
  };
  errors_of([&] {
    EXPECT_FALSE(run_stage(run.chain, with_validity(false)));
    EXPECT_EQ(failure_of([&] { run_stage(run.chain, with_validity(true)); }).code, ExitCode::no_result);
  });
}

TEST(RunStage, prints_each_warning_once) {
  SampleChain run;
  const StageTask task = task_of(ChainStage::padapt, [](quadrille::Run& stage_run) {
    stage_run.report().warn("W-X-001", "two\nlines");
    stage_run.report().warn("W-X-001", "another");
  });
  EXPECT_EQ(errors_of([&] { run_stage(run.chain, task); }),
            "padapt: warning W-X-001: two lines\npadapt: warning W-X-001: another\n");
  EXPECT_EQ(errors_of([&] { run_stage(run.chain, task); }), "");
  SampleChain quiet;
  quiet.options.is_quiet = true;
  EXPECT_EQ(errors_of([&] { run_stage(quiet.chain, task); }), "");
}

TEST(RunStage, warnings_of_remedies_wait_until_one_is_taken) {
  SampleChain run;
  run.chain.prefix = "trial_";
  const StageTask task =
      task_of(ChainStage::separatrix, [](quadrille::Run& stage_run) { stage_run.report().warn("W-X-001", "odd"); });
  EXPECT_EQ(errors_of([&] { run_stage(run.chain, task); }), "");
  run.runner.reports()[0].stage = "remedy_separatrix";
  EXPECT_EQ(errors_of([&] { print_warnings(run.chain, 0); }), "separatrix: warning W-X-001: odd\n");
}

TEST(RunStage, quiet_runs_print_the_failure_that_ends_them) {
  SampleChain run;
  run.options.is_quiet = true;
  run.chain.has_other_way = true;
  EXPECT_EQ(errors_of([&] { run_stage(run.chain, task_of(ChainStage::padapt, no_result)); }), "");
  run.chain.has_other_way = false;
  EXPECT_EQ(errors_of([&] { failure_of([&] { run_stage(run.chain, task_of(ChainStage::padapt, no_result)); }); }),
            "padapt: no result\n");
}

TEST(RunStage, a_stopped_stage_is_another_way_too) {
  Limits limits;
  limits.seconds = 1e-9;
  SampleChain run(true, limits);
  run.chain.has_other_way = true;
  EXPECT_EQ(errors_of([&] { EXPECT_FALSE(run_stage(run.chain, task_of(ChainStage::blocksplit, nothing))); }), "");
  EXPECT_TRUE(run.chain.given_up->is_stopped);
  expect_contains(errors_of([&] { print_stop(run.chain); }), "quadmesh: warning W-RUN-001: blocksplit was not started");
  run.chain.has_other_way = false;
  run.chain.last = "before";
  const std::string errors =
      errors_of([&] { failure_of([&] { run_stage(run.chain, task_of(ChainStage::blocksplit, nothing)); }); });
  EXPECT_TRUE(errors.starts_with("quadmesh: blocksplit was not started after ")) << errors;
  EXPECT_EQ(run.chain.last, "") << "no picture";
}

TEST(Inform, not_quiet_runs) {
  SampleChain run;
  EXPECT_EQ(errors_of([&] { inform(run.chain, "a sentence"); }), "quadmesh: a sentence\n");
  run.options.is_quiet = true;
  EXPECT_EQ(errors_of([&] { inform(run.chain, "a sentence"); }), "");
}

}  // namespace

}  // namespace quadrille::chain
