#include "cli/tool_main.hpp"

#include <gtest/gtest.h>

#include <new>

#include "base/error.hpp"
#include "base/parallel.hpp"

namespace quadrille::cli {
namespace {

/// What one run of a tool did.
struct Result {
  int code = 0;
  std::string out, err;
};

Result run(const Tool& tool, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), tool.name);
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  Result result;
  result.code = tool_main(static_cast<int>(argv.size()), argv.data(), tool);
  result.out = testing::internal::GetCapturedStdout();
  result.err = testing::internal::GetCapturedStderr();
  return result;
}

/// A tool with one option of each kind; `body` is what it does.
struct Sample {
  std::string input, output, name = "plain", mode = "fast";
  double size = 0.5;
  int order = 4;
  bool is_loud = false;
  Provenance chain;

  Tool tool(std::function<void(Session&)> body = [](Session&) {}) {
    Tool t;
    t.name = "sample";
    t.summary = "does nothing";
    t.examples = {"sample -o x"};
    t.options = [this](Options& o) {
      o.input("IN", input, "what is read");
      o.output(output, "what is written");
      o.number("--size", size, 0, 10, "length", "the size");
      o.integer("--order", order, 1, 20, "the order");
      o.choice("--mode", mode, {"fast", "slow"}, "the mode");
      o.text("--name", name, "NAME", "a name");
      o.flag("--loud", is_loud, "be loud");
    };
    t.run = [this, body](Session& session) {
      chain = session.provenance({}, {{"step", "abc"}});
      body(session);
    };
    return t;
  }
};

TEST(ToolMain, FillsVariablesAndReturnsDone) {
  Sample s;
  const Result r = run(s.tool(), {"--size", "2.5", "--order=7", "--mode", "slow", "--loud", "file", "-o", "out"});
  EXPECT_EQ(r.code, 0);
  EXPECT_EQ(r.out + r.err, "");
  EXPECT_EQ(s.size, 2.5);
  EXPECT_EQ(s.order, 7);
  EXPECT_EQ(s.mode, "slow");
  EXPECT_TRUE(s.is_loud);
  EXPECT_EQ(s.input, "file");
  EXPECT_EQ(s.output, "out");
}

TEST(ToolMain, InputAndOutputAreDashByDefault) {
  Sample s;
  EXPECT_EQ(run(s.tool(), {}).code, 0);
  EXPECT_EQ(s.input, "-");
  EXPECT_EQ(s.output, "-");
  EXPECT_EQ(run(s.tool(), {"-", "-o", "-"}).code, 0);
}

TEST(ToolMain, TheLastOfRepeatedOptionsCounts) {
  Sample s;
  EXPECT_EQ(run(s.tool(), {"--order", "3", "--order", "5"}).code, 0);
  EXPECT_EQ(s.order, 5);
}

TEST(ToolMain, AListKeepsAllItsValuesAndTheSequence) {
  Sample s;
  std::vector<std::string> parts;
  Tool tool = s.tool();
  tool.options = [&](Options& o) { o.texts("--part", parts, "A:B", "a part"); };
  EXPECT_EQ(run(tool, {"--part", "2:1", "--part=3:4"}).code, 0);
  EXPECT_EQ(parts, (std::vector<std::string>{"2:1", "3:4"}));
  EXPECT_EQ(s.chain.back().options, R"({"part":["2:1","3:4"]})");
  EXPECT_EQ(run(tool, {"--part"}).code, 2);
  EXPECT_EQ(run(tool, {"--part", "1", "2"}).code, 2);  // one value each
}

TEST(ToolMain, AnEmptyListNeedNotBeRecorded) {
  for (const bool records_none : {true, false}) {
    Sample s;
    std::vector<std::string> parts;
    Tool tool = s.tool();
    tool.options = [&](Options& o) { o.texts("--part", parts, "A:B", "a part", records_none); };
    EXPECT_EQ(run(tool, {}).code, 0);
    EXPECT_EQ(s.chain.back().options, records_none ? R"({"part":[]})" : "{}");
  }
}

TEST(ToolMain, MistakesAreOneLineAndTryHelp) {
  const std::vector<std::vector<std::string>> mistakes{
      {"--nothing"},  {"--size", "-1"},           {"--size", "11"},   {"--size", "nan"},    {"--size", "1x"},
      {"--size", ""}, {"--order", "2.5"},         {"--order", "21"},  {"--order"},          {"--mode", "medium"},
      {"a", "b"},     {"--order", "99999999999"}, {"--threads", "0"}, {"--progress", "on"}, {"--loud=perhaps"}};
  for (const auto& mistake : mistakes) {
    Sample s;
    const Result r = run(s.tool(), mistake);
    EXPECT_EQ(r.code, 2) << mistake[0];
    EXPECT_EQ(r.out, "");
    EXPECT_EQ(r.err.rfind("sample: ", 0), 0u) << r.err;
    EXPECT_EQ(std::count(r.err.begin(), r.err.end(), '\n'), 2) << r.err;
    EXPECT_NE(r.err.find("\ntry 'sample --help'\n"), std::string::npos) << r.err;
  }
}

TEST(ToolMain, HelpStatesUnitDefaultAndInterval) {
  Sample s;
  const Result r = run(s.tool(), {"--order", "5", "--help"});
  EXPECT_EQ(r.code, 0);
  EXPECT_EQ(r.err, "");
  EXPECT_NE(r.out.find("Usage: sample [OPTIONS] [IN]"), std::string::npos);
  EXPECT_NE(r.out.find("(unit: length; default: 0.5; interval: 0 to 10)"), std::string::npos) << r.out;
  EXPECT_NE(r.out.find("(unit: none; default: 4; interval: 1 to 20)"), std::string::npos) << r.out;
  EXPECT_NE(r.out.find("EXAMPLES\n  sample -o x\n"), std::string::npos);
}

TEST(ToolMain, HelpAndVersionAreGivenWhateverElseTheLineHas) {
  Sample s;
  for (const std::vector<std::string>& others :
       std::vector<std::vector<std::string>>{{"--nonsense"}, {"--order"}, {"--order", "x"}, {"a", "b", "c"}, {"-z"}}) {
    for (const std::string word : {"--help", "-h", "-vh", "--version", "--list-options"}) {
      std::vector<std::string> before = others, after = others;
      before.insert(before.begin(), word);
      after.push_back(word);
      for (const std::vector<std::string>& words : {before, after}) {
        const Result r = run(s.tool(), words);
        EXPECT_EQ(r.code, 0) << word << others[0];
        EXPECT_EQ(r.err, "");
        EXPECT_EQ(r.out, run(s.tool(), {word}).out);
      }
    }
  }
  EXPECT_NE(run(s.tool(), {"--help", "--version"}).out.find("Usage"), std::string::npos) << "the first of them decides";
}

TEST(ToolMain, ListsTheToolsOwnOptionsForPrograms) {
  Sample s;
  std::string required;
  Tool tool = s.tool();
  tool.options = [&, sample_options = tool.options](Options& o) {
    sample_options(o);
    o.input("MORE", required, "not needed for the list", true);
  };
  const Result r = run(tool, {"--list-options"});
  EXPECT_EQ(r.code, 0);
  EXPECT_EQ(r.err, "");
  EXPECT_EQ(
      r.out,
      "sample --size value\nsample --order value\nsample --mode value\nsample --name value\nsample --loud flag\n");
  EXPECT_EQ(run(tool, {"--help"}).out.find("--list-options"), std::string::npos);
}

TEST(ToolMain, EveryFailureHasItsCode) {
  const auto code = [](const std::function<void()>& fail) {
    Sample s;
    return run(s.tool([&](Session&) { fail(); }), {});
  };
  EXPECT_EQ(code([] { throw ComputeError("no"); }).code, 1);
  EXPECT_EQ(code([] { throw UsageError("no"); }).code, 2);
  EXPECT_EQ(code([] { throw FormatError("no"); }).code, 3);
  EXPECT_EQ(code([] { throw OutputError("no"); }).code, 4);
  EXPECT_EQ(code([] { throw Defect("no"); }).code, 70);
  EXPECT_EQ(code([] { throw std::bad_alloc(); }).code, 1);
  EXPECT_EQ(code([] { throw std::out_of_range("no"); }).code, 70);
  EXPECT_EQ(code([] { throw 1; }).code, 70);
  EXPECT_EQ(code([] { throw ComputeError("too bad"); }).err, "sample: too bad\n");
  EXPECT_EQ(code([] { throw std::bad_alloc(); }).err.rfind("sample: out of memory, at ", 0), 0u);
  EXPECT_EQ(code([] { throw std::out_of_range("at"); }).err, "sample: internal error, please report it: at\n");
}

TEST(ToolMain, ProvenanceHoldsOptionsAfterDefaultsWithSortedKeys) {
  Sample s;
  EXPECT_EQ(run(s.tool(), {"--size", "0.1", "-v", "--threads", "3", "--report", "", "-o", "out", "in"}).code, 0);
  ASSERT_EQ(s.chain.size(), 1u);
  EXPECT_EQ(s.chain[0].tool, "sample");
  EXPECT_EQ(s.chain[0].inputs[0].sha256, "abc");
  EXPECT_EQ(s.chain[0].options, R"({"loud":false,"mode":"fast","name":"plain","order":4,"size":0.1})");
}

TEST(ToolMain, ThreadsAreAsManyAsProcessorsByDefault) {
  Sample s;
  int threads = 0;
  const Tool tool = s.tool([&](Session& session) { threads = session.threads(); });
  EXPECT_EQ(run(tool, {"--threads", "3"}).code, 0);
  EXPECT_EQ(threads, 3);
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{}, {"--threads", "auto"}}) {
    threads = 0;
    EXPECT_EQ(run(tool, arguments).code, 0);
    EXPECT_EQ(threads, available_processors());
  }
}

TEST(ToolMain, TextInProvenanceIsEscaped) {
  Sample s;
  run(s.tool(), {"--name", "a\"b\\\n"});
  EXPECT_NE(s.chain[0].options.find(R"("name":"a\"b\\\u000a")"), std::string::npos) << s.chain[0].options;
}

TEST(ToolMain, WarningsArePrintedUnlessQuiet) {
  Sample s;
  const Tool tool = s.tool([](Session& session) { session.report().warn("W-X-001", "odd"); });
  EXPECT_EQ(run(tool, {}).err, "sample: warning W-X-001: odd\n");
  EXPECT_EQ(run(tool, {"-q"}).err, "");
}

TEST(ToolMain, InformsWithV) {
  Sample s;
  const Tool tool = s.tool([](Session& session) { session.info("hello"); });
  EXPECT_EQ(run(tool, {}).err, "");
  EXPECT_EQ(run(tool, {"-v"}).err, "sample: hello\n");
  EXPECT_EQ(run(tool, {"-vq"}).err, "");
  const Tool detailed = s.tool([](Session& session) { session.info("more", 2); });
  EXPECT_EQ(run(detailed, {"-v"}).err, "");
  EXPECT_EQ(run(detailed, {"-vv"}).err, "sample: more\n");
}

TEST(ToolMain, CountsProgressOnlyIfItIsShown) {
  Sample s;
  bool is_counted = false;
  const Tool tool = s.tool([&](Session& session) { is_counted = session.report().progress() != nullptr; });
  run(tool, {});
  EXPECT_FALSE(is_counted);
  run(tool, {"--progress", "always"});
  EXPECT_TRUE(is_counted);
}

TEST(ToolMain, AnnouncesPhasesOnlyWhenAsked) {
  Sample s;
  const Tool tool = s.tool([](Session& session) { session.begin_phase("work"); });
  EXPECT_EQ(run(tool, {}).err, "");
  EXPECT_EQ(run(tool, {"--progress", "never"}).err, "");
  EXPECT_EQ(run(tool, {"--progress", "always"}).err, "sample: work ...\n");
}

TEST(ToolMain, TheReportIsWrittenAfterFailureToo) {
  for (const bool fails : {false, true}) {
    Sample s;
    std::vector<std::string> keys;
    Tool tool = s.tool([&](Session& session) {
      session.begin_phase("work");
      if (fails) throw ComputeError("too bad");
    });
    tool.report_writer = [&](const std::string& path, const std::string&, const std::string&, const Report& report) {
      EXPECT_EQ(path, "r.json");
      for (const auto& [key, value] : report.entries()) keys.push_back(key);
    };
    EXPECT_EQ(run(tool, {"--report", "r.json"}).code, fails ? 1 : 0);
    const auto has = [&](const char* key) { return std::find(keys.begin(), keys.end(), key) != keys.end(); };
    EXPECT_TRUE(has("timings.work.cpu_seconds"));
    EXPECT_TRUE(has("timings.total.wall_seconds"));
    EXPECT_TRUE(has("exit_code"));
    EXPECT_EQ(has("error"), fails);
  }
}

TEST(ToolMain, AReportThatCannotBeWrittenIsAnOutputError) {
  Sample s;
  Tool tool = s.tool();
  tool.report_writer = [](const auto&...) { throw OutputError("r.json: no space"); };
  EXPECT_EQ(run(tool, {"--report", "r.json"}).code, 4);
}

}  // namespace
}  // namespace quadrille::cli
