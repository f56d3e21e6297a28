#include "chain/stage_runner.hpp"

#include <gtest/gtest.h>

#include <csignal>

#include "../support/texts.hpp"
#include "base/error.hpp"
#include "sample_chain.hpp"

namespace quadrille::chain {
namespace {

using Texts = std::vector<std::string>;

/// Runs a stage silently.
StageEnd end_of(SampleChain& run, const StageTask& task, Share share = Share::all) {
  StageEnd end;
  errors_of([&] { end = run.runner.run(task, share); });
  return end;
}

TEST(CommandWords, end_with_the_output_and_what_all_stages_share) {
  StageTask task = task_of(ChainStage::padapt, {});
  ChainOptions options;
  EXPECT_EQ(command_words(task, options), (Texts{"in", "-o", "out"}));
  options.threads = "3";
  options.is_quiet = true;
  EXPECT_EQ(command_words(task, options), (Texts{"in", "-o", "out", "--threads", "3", "-q"}));
}

TEST(StageRunner, runs_here_or_in_a_child) {
  for (const bool in_child : {false, true}) {
    SampleChain run(in_child);
    const pid_t self = getpid();
    int num_dropped = 0;
    StageTask task = task_of(ChainStage::padapt, [&](quadrille::Run& stage_run) {
      stage_run.report().set("is_here", getpid() == self);
      stage_run.report().set("count", 5);
    });
    task.drop_result = [&] { ++num_dropped; };
    const StageEnd end = end_of(run, task);
    EXPECT_EQ(end.code, ExitCode::done);
    EXPECT_EQ(end.message + end.messages, "");
    EXPECT_EQ(io::value_of(end.report, "tool"), "padapt");
    EXPECT_EQ(io::value_of(end.report, "count"), "5");
    EXPECT_EQ(io::value_of(end.report, "exit_code"), "0");
    EXPECT_TRUE(io::value_of(end.report, "timings.total.cpu_seconds"));
    EXPECT_EQ(io::value_of(end.report, "is_here"), in_child ? "false" : "true");
    EXPECT_EQ(num_dropped, in_child ? 1 : 0);
    EXPECT_EQ(run.runner.reports().size(), 1U);
    EXPECT_EQ(run.runner.is_in_child(ChainStage::padapt), in_child);
  }
}

TEST(StageRunner, failures_have_a_code_and_a_message) {
  for (const bool in_child : {false, true}) {
    SampleChain run(in_child);
    StageEnd end = end_of(run, task_of(ChainStage::padapt, [](quadrille::Run&) { throw ComputeError("no field"); }));
    EXPECT_EQ(end.code, ExitCode::no_result);
    EXPECT_EQ(end.message, "no field");
    EXPECT_EQ(end.messages, "padapt: no field\n");
    EXPECT_EQ(io::value_of(end.report, "error"), "no field");
    EXPECT_FALSE(end.is_stopped);
    end = end_of(run, task_of(ChainStage::padapt, [](quadrille::Run&) { throw UsageError("--size: 0"); }));
    EXPECT_EQ(end.messages, "quadmesh: --size: 0\ntry 'quadmesh --help'\n") << "a mistake of the user";
    end = end_of(run, task_of(ChainStage::padapt, [](quadrille::Run&) { throw Defect("no face"); }));
    EXPECT_EQ(end.code, ExitCode::defect);
    expect_contains(end.messages, "padapt: internal error");
  }
}

TEST(StageRunner, prints_messages_of_failures_but_not_with_q) {
  SampleChain run;
  const StageTask task = task_of(ChainStage::padapt, [](quadrille::Run&) { throw ComputeError("no field"); });
  EXPECT_EQ(errors_of([&] { run.runner.run(task, Share::all); }), "padapt: no field\n");
  run.options.is_quiet = true;
  EXPECT_EQ(errors_of([&] { run.runner.run(task, Share::all); }), "");
}

TEST(StageRunner, a_child_that_crashes_fails) {
  SampleChain run(true);
  const StageEnd end = end_of(run, task_of(ChainStage::padapt, [](quadrille::Run&) {
                                std::signal(SIGSEGV, SIG_DFL);
                                raise(SIGSEGV);
                              }));
  EXPECT_EQ(static_cast<int>(end.code), 128 + SIGSEGV);
  EXPECT_EQ(end.messages, "padapt: ended by signal 11\n");
  EXPECT_FALSE(end.is_stopped);
}

TEST(StageRunner, a_child_that_is_killed_counts_as_stopped) {
  SampleChain run(true);
  const StageEnd end = end_of(run, task_of(ChainStage::padapt, [](quadrille::Run&) { raise(SIGKILL); }));
  EXPECT_EQ(end.code, ExitCode::no_result);
  EXPECT_TRUE(end.is_stopped);
  EXPECT_EQ(end.message, "killed by signal 9, as systems do when memory runs out");
  EXPECT_EQ(io::warnings_of(end.report).at(0).code, "W-RUN-001");
}

TEST(StageRunner, a_child_is_stopped_when_the_budget_is_used_up) {
  Limits limits;
  limits.seconds = 0.3;
  limits.grace = 0.1;
  SampleChain run(true, limits);
  const StageTask task = task_of(ChainStage::padapt, [](quadrille::Run&) { sleep(3600); });
  const StageEnd end = end_of(run, task);
  EXPECT_TRUE(end.is_stopped);
  EXPECT_TRUE(matches(end.message, "stopped after .* s of all stages: --max-seconds is 0.3")) << end.message;
  EXPECT_EQ(end.messages, "");
  EXPECT_EQ(io::value_of(end.report, "exit_code"), "1");
  const auto warnings = io::warnings_of(end.report);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].tool, "quadmesh");
  EXPECT_EQ(warnings[0].message, "padapt was " + end.message + ": the quads are made without a field");
  EXPECT_TRUE(end_of(run, task).message.starts_with("not started after ")) << "the next stage";
}

TEST(StageRunner, an_external_program_takes_the_place_of_a_stage) {
  SampleChain run;
  run.options.programs[ChainStage::padapt] = "sh '" + run.put("program", R"(
test -e )" + run.folder.file("input") + R"( || exit 7
echo "$*" >)" + run.folder.file("words") + R"(
for last; do :; done
test "$last" = -q && shift $(($# - 2)) && last=$1
echo '{"tool": "padapt", "exit_code": 0, "count": 5}' >"$last"
)") + "'";
  bool is_dropped = false;
  StageTask task = task_of(ChainStage::padapt, [](quadrille::Run&) { FAIL() << "runs here"; });
  task.words = {"a b", "--order", "3"};
  task.write_inputs = [&] { run.folder.touch("input"); };
  task.drop_result = [&] { is_dropped = true; };
  const StageEnd end = end_of(run, task);
  EXPECT_EQ(end.code, ExitCode::done);
  EXPECT_EQ(io::value_of(end.report, "count"), "5");
  EXPECT_TRUE(is_dropped);
  EXPECT_TRUE(run.content("words").starts_with("a b --order 3 -o out --report ")) << run.content("words");
  EXPECT_TRUE(run.runner.is_in_child(ChainStage::padapt));
  EXPECT_FALSE(run.runner.is_in_child(ChainStage::critpoints));
}

TEST(StageRunner, an_external_program_fails_as_a_stage_does) {
  SampleChain run;
  run.options.programs[ChainStage::padapt] = "echo 'mine: no field' >&2; exit 1; :";
  const StageEnd end = end_of(run, task_of(ChainStage::padapt, {}));
  EXPECT_EQ(end.code, ExitCode::no_result);
  EXPECT_EQ(end.messages, "mine: no field\n");
  EXPECT_EQ(io::value_of(end.report, "tool"), "padapt") << "though it wrote no report";
  EXPECT_EQ(io::value_of(end.report, "exit_code"), "1");
  EXPECT_EQ(end.message, "ended with the exit code 1");
  run.options.programs[ChainStage::padapt] = "/no/such/program";
  EXPECT_EQ(static_cast<int>(end_of(run, task_of(ChainStage::padapt, {})).code), 127);
}

TEST(StageRunner, helpers_return_their_code_and_messages) {
  SampleChain run;
  const auto [code, messages] = run.runner.run_helper({"/bin/sh", "-c", "echo message >&2; exit 3"});
  EXPECT_EQ(code, 3);
  EXPECT_EQ(messages, "message\n");
  EXPECT_TRUE(run.runner.reports().empty());
}

}  // namespace
}  // namespace quadrille::chain
