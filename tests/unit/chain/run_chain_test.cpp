#include "chain/run_chain.hpp"

#include <gtest/gtest.h>

#include <csignal>

#include "../region_samples.hpp"
#include "../support/texts.hpp"
#include "sample_chain.hpp"

namespace quadrille::chain {
namespace {

/// A work folder with the triangles of two squares side by side, as of an earlier run on shape.step.
class RunChain : public testing::Test {
 protected:
  RunChain() { folder_.put("shape.tri.h5", io::stage_bytes(samples::two_regions_mesh())); }
  ~RunChain() override { std::signal(SIGXFSZ, SIG_DFL); }  // which a program ignores (cli/process_setup.cpp)

  /// From the field on, with these words.
  int run(std::vector<std::string> words) {
    const std::vector<std::string> common{"--from", "fieldsolve", "--workdir", folder_.folder.path(), "shape.step"};
    words.insert(words.end(), common.begin(), common.end());
    int code = -1;
    testing::internal::CaptureStdout();
    errors_ = errors_of([&] { code = run_chain(words); });
    printed_ = testing::internal::GetCapturedStdout();
    return code;
  }
  std::string file(const std::string& name) const { return folder_.folder.file(name); }

  SampleChain folder_;
  std::string printed_, errors_;
};

TEST_F(RunChain, makes_the_mesh_and_ends_with_a_line_about_it) {
  EXPECT_EQ(run({"--size", "0.5", "-o", file("x.msh")}), 0) << errors_;
  EXPECT_EQ(errors_, "");
  EXPECT_EQ(count(printed_, "\n"), 1) << printed_;
  expect_contains(printed_, "8 quads");
  for (const char* name :
       {"x.msh", "shape.field.h5", "shape.crit.json", "shape.sep.json", "shape.blocks.h5", "shape.quad.h5"})
    EXPECT_TRUE(folder_.folder.has(name)) << name;
  EXPECT_FALSE(folder_.folder.has(".shape.lock"));
}

TEST_F(RunChain, ends_with_the_stage_that_is_named) {
  EXPECT_EQ(run({"--until", "padapt"}), 0) << errors_;
  EXPECT_TRUE(folder_.folder.has("shape.field.h5"));
  EXPECT_FALSE(folder_.folder.has("shape.crit.json"));
  expect_contains(printed_, "stages up to padapt: ");
}

TEST_F(RunChain, sweeps_the_quads) {
  EXPECT_EQ(run({"--size", "0.5", "--sweep", "--layers", "2", "--bottom-name", "low", "--top-name", "high", "-q", "-o",
                 file("x.msh")}),
            0)
      << errors_;
  EXPECT_EQ(io::read_stage<HexMesh>(io::read_input(file("shape.hex.h5"))).num_elems(), 16);
}

TEST_F(RunChain, exports_blocks_as_a_cad_model) {
  EXPECT_EQ(run({"-q", "--dry-run", "-o", "x.step"}), 0);
  expect_contains(printed_, "quadexport " + file("shape.blocks.h5") + " -o x.step");
}

TEST_F(RunChain, a_dry_run_prints_the_commands) {
  EXPECT_EQ(run({"--dry-run", "-o", "x.msh", "--size", "0.5"}), 0);
  expect_counts(printed_, {{"\nfieldsolve ", 0}, {"\npadapt ", 1}, {"\nquadrefine ", 1}, {"\nquadexport ", 1}});
  EXPECT_TRUE(printed_.starts_with("fieldsolve " + file("shape.tri.h5"))) << printed_;
  EXPECT_FALSE(folder_.folder.has("shape.field.h5"));
}

TEST_F(RunChain, mistakes_on_the_command_line_are_code_2) {
  EXPECT_EQ(run({"--nonsense"}), 2);
  EXPECT_TRUE(errors_.starts_with("quadmesh: unknown option --nonsense")) << errors_;
  EXPECT_EQ(run({"--size", "-1", "-o", file("x.msh")}), 2);
  expect_contains(errors_, "--size: -1 is outside its interval");
  EXPECT_FALSE(folder_.folder.has("x.msh"));
}

TEST_F(RunChain, files_that_cannot_be_read_are_code_3) {
  folder_.put("shape.tri.h5", "no triangles");
  EXPECT_EQ(run({"-o", file("x.msh")}), 3);
  expect_contains(errors_, file("shape.tri.h5"));
  EXPECT_FALSE(folder_.folder.has(".shape.lock"));
}

TEST_F(RunChain, a_failure_is_reported) {
  EXPECT_EQ(run({"--max-elements", "1", "--size", "0.5", "-o", file("x.msh"), "--report", file("r.json")}), 1);
  const std::string report = folder_.content("r.json");
  expect_contains(report, "\"exit_code\": 1");
  expect_contains(report, "more than --max-elements 1");
  EXPECT_FALSE(folder_.folder.has("x.msh"));
}

TEST_F(RunChain, a_folder_that_cannot_be_made_is_code_3) {
  const std::string under_a_file = folder_.put("file", "") + "/folder";
  int code = 0;
  const std::string errors = errors_of([&] {
    code = run_chain({"x.step", "--workdir", under_a_file, "-o", file("x.msh")});
  });
  EXPECT_EQ(code, 3) << errors;
}

TEST(RunChainHelp, is_printed_and_nothing_is_done) {
  EXPECT_EQ(output_of([] { EXPECT_EQ(run_chain({"--help"}), 0); }), help_text());
  EXPECT_EQ(output_of([] { EXPECT_EQ(run_chain({"--help-all"}), 0); }), full_help_text());
  EXPECT_EQ(output_of([] { EXPECT_EQ(run_chain({"--list-options"}), 0); }), option_list());
}

}  // namespace
}  // namespace quadrille::chain
