#include "chain/early_checks.hpp"

#include <gtest/gtest.h>

#include "../samples.hpp"
#include "../support/texts.hpp"
#include "base/error.hpp"
#include "sample_chain.hpp"

namespace quadrille::chain {
namespace {

using Texts = std::vector<std::string>;

/// Why the command line is refused; empty if it is not.
std::string refusal(const Texts& words) {
  return message_of<UsageError>([&] {
    ChainOptions options;
    read_command_line(words, options);
    check_command_line(options, stage_options(options));
  });
}

TEST(CheckCommandLine, there_is_a_shape_unless_a_later_stage_begins) {
  EXPECT_EQ(refusal({"a.step"}), "");
  EXPECT_EQ(refusal({}), "no shape given");
  EXPECT_EQ(refusal({"--from", "padapt", "--workdir", "w"}), "");
}

TEST(CheckCommandLine, parts_of_pages_are_known_and_need_a_page) {
  EXPECT_EQ(refusal({"a.step", "--html", "x.html", "--html-parts", "blocks,quads"}), "");
  EXPECT_EQ(refusal({"a.step", "--html-parts", "quads"}), "--html-parts needs --html FILE");
  EXPECT_EQ(
      refusal({"a.step", "--html", "x.html", "--html-parts", "quads,feld"}),
      "--html-parts: 'feld' is no part of a page (did you mean field?): the parts are triangles field nodes phase "
      "separatrices blocks quads hexahedra");
}

TEST(CheckCommandLine, pages_end_in_html) {
  EXPECT_EQ(refusal({"a.step", "--html", "x.html"}), "");
  for (const char* name : {"x.htm", ".html"})
    EXPECT_EQ(refusal({"a.step", "--html", name}), "--html: '" + std::string(name) + "' does not end in .html");
}

TEST(CheckCommandLine, stages_run_forward_with_a_folder) {
  EXPECT_EQ(refusal({"--from", "padapt", "--until", "fieldsolve", "--workdir", "w"}),
            "--from padapt comes after --until fieldsolve: no stage would run");
  EXPECT_EQ(refusal({"--from", "padapt"}),
            "--from padapt needs --workdir, the folder with the files of the stages before");
  EXPECT_EQ(refusal({"--from", "padapt", "--until", "padapt", "--workdir", "w"}), "");
}

TEST(CheckCommandLine, a_stage_file_has_not_the_name_of_a_mesh) {
  for (const char* name : {"-", "x.field.h5", "./x.h5", "/dev/null"})
    EXPECT_EQ(refusal({"a.step", "--until", "padapt", "-o", name}), "");
  EXPECT_EQ(refusal({"a.step", "--until", "padapt"}), "");
  EXPECT_EQ(refusal({"a.step", "--until", "padapt", "-o", "x.msh"}),
            "x.msh: --until padapt writes x.field.h5: end the name in .h5, or give --workdir");
  EXPECT_NE(refusal({"a.step", "--until", "critpoints", "-o", "x.h5"}), "");
  EXPECT_EQ(refusal({"a.step", "--until", "padapt", "-o", "x.msh", "--workdir", "w"}), "");
}

TEST(CheckCommandLine, options_of_skipped_stages_are_refused) {
  const auto skipped = [](const Texts& words) {
    Texts all{"--from", "separatrix", "--workdir", "w", "-o", "x.msh"};
    all.insert(all.end(), words.begin(), words.end());
    return refusal(all);
  };
  EXPECT_EQ(skipped({"--max-valence", "6"}),
            "--max-valence is an option of critpoints, which --from separatrix does not run: leave it out, or begin "
            "with --from critpoints");
  EXPECT_EQ(skipped({"--name", "wall=0"}),
            "--name is an option of cad2tri, which --from separatrix does not run: leave one of them out");
  EXPECT_EQ(skipped({"--chord", "1"}),
            "--chord makes a CAD file of points, which --from separatrix does not read: leave one of them out");
  EXPECT_EQ(skipped({"--size", "1"}), "");
  EXPECT_EQ(refusal({"--from", "quadexport", "--workdir", "w", "--unit", "mm"}), "") << "quadrefine has it too";
}

TEST(CheckCommandLine, what_stages_refuse_before_they_read_a_file_is_refused) {
  EXPECT_NE(refusal({"a.step", "--clearance", "wall"}), "");
  EXPECT_NE(refusal({"a.step", "--name", "wall"}), "");
  EXPECT_NE(refusal({"a.step", "--wall", "hole"}), "");
  EXPECT_NE(refusal({"a.step", "-o", "x.unknown"}), "");
}

TEST(CheckCommandLine, the_format_of_the_output_has_a_greatest_order) {
  EXPECT_EQ(refusal({"a.step", "-o", "x.xml", "--order", "12"}), "");
  EXPECT_NE(refusal({"a.step", "-o", "x.msh", "--order", "12"}), "");
  EXPECT_EQ(refusal({"a.step", "-o", "x.msh", "--order", "12", "--until", "quadrefine", "--workdir", "w"}), "");
}

TEST(CheckCommandLine, nodes_of_a_file_take_the_place_of_critpoints) {
  EXPECT_EQ(refusal({"a.step", "--nodes", "x.crit.json"}), "");
  EXPECT_EQ(refusal({"a.step", "--nodes", "x.crit.json", "--layout", "midpoint"}),
            "--nodes and --layout midpoint exclude each other: it uses no nodes");
  EXPECT_EQ(refusal({"--from", "blocksplit", "--workdir", "w", "--nodes", "x.crit.json"}),
            "--nodes needs separatrix, which --from blocksplit does not run");
  EXPECT_EQ(refusal({"a.step", "--until", "padapt", "--workdir", "w", "--nodes", "x.crit.json"}),
            "--nodes is not used before critpoints, where --until padapt ends");
  EXPECT_EQ(refusal({"a.step", "--nodes", "x.crit.json", "--ties", "field"}),
            "--nodes takes the place of critpoints: --ties is an option of it, leave it out");
  EXPECT_EQ(refusal({"a.step", "--nodes", "x.crit.json", "--symmetry", "axis"}), "") << "later stages have it too";
  EXPECT_EQ(refusal({"-", "--nodes", "-"}), "SHAPE and --nodes cannot both be standard input");
}

TEST(StemOf, is_the_name_without_folders_and_ending) {
  EXPECT_EQ(stem_of("a.b/plate.v2.step"), "plate.v2");
  EXPECT_EQ(stem_of("plate"), "plate");
  EXPECT_EQ(stem_of("-"), "shape");
}

TEST(ExportedEnding, a_step_file_is_made_of_blocks) {
  const StageOptions of_stages;
  ChainOptions options;
  EXPECT_EQ(exported_ending(options, of_stages), "quad.h5");
  options.output = "x.step";
  EXPECT_EQ(exported_ending(options, of_stages), "blocks.h5");
}

TEST(ShapeOf, is_found_in_the_folder_of_the_stages) {
  const TemporaryFolder folder;
  const StageOptions of_stages;
  ChainOptions options;
  read_command_line({"--from", "quadrefine", "--workdir", folder.path()}, options);
  const auto refused = [&] { return message_of<UsageError>([&] { shape_of(options, of_stages); }); };
  EXPECT_EQ(refused(), "--from quadrefine needs a file *.blocks.h5 in " + folder.path() + ", which has no such file");
  folder.touch("plate.v2.blocks.h5");
  folder.touch("other.sep.json");
  EXPECT_EQ(stem_of(shape_of(options, of_stages)), "plate.v2");
  folder.touch("other.blocks.h5");
  EXPECT_TRUE(refused().starts_with(folder.path() + " has files of several shapes"));
  options.shape = "given.step";
  EXPECT_EQ(shape_of(options, of_stages), "given.step");
}

/// A run on a shape that exists, which writes x.msh beside it.
class CheckFiles : public testing::Test {
 protected:
  CheckFiles() { run_.read({run_.put("plate.step", "shape"), "-o", file("x.msh")}); }

  std::string file(const std::string& name) const { return run_.folder.file(name); }
  template <typename Error>
  std::string refusal() const {
    return message_of<Error>([&] { check_files(run_.chain); });
  }

  SampleChain run_;
};

TEST_F(CheckFiles, inputs_are_files_that_are_not_empty) {
  EXPECT_NO_THROW(check_files(run_.chain));
  run_.options.shape = file("none.step");
  EXPECT_EQ(refusal<FormatError>(), file("none.step") + ": no such file");
  run_.options.shape = run_.folder.path();
  EXPECT_EQ(refusal<FormatError>(), run_.folder.path() + ": is a directory, not a file");
  run_.options.shape = run_.put("empty.step", "");
  EXPECT_EQ(refusal<FormatError>(), file("empty.step") + ": is empty");
}

TEST_F(CheckFiles, names_sizes_and_nodes_are_read) {
  run_.options.nodes_file = "nearest";
  EXPECT_EQ(refusal<FormatError>(), "--nodes nearest: no such file; the rules are none, fewest, field and auto");
  run_.options.nodes_file = "";
  for (std::string* path : {&run_.chain.values.cad2tri.names_file, &run_.chain.values.blocksplit.names_file,
                            &run_.chain.values.quadrefine.size_field_file, &run_.options.nodes_file}) {
    *path = file("none");
    EXPECT_THROW(check_files(run_.chain), FormatError);
    *path = run_.put("wrong", "{");
    EXPECT_THROW(check_files(run_.chain), FormatError);
    path->clear();
  }
  EXPECT_NO_THROW(check_files(run_.chain));
}

TEST_F(CheckFiles, the_files_of_the_stages_before_the_first_are_there) {
  run_.options.first = ChainStage::critpoints;
  run_.options.from = "critpoints";
  run_.put("shape.tri.h5", "triangles");
  run_.put("shape.field.h5", "");
  EXPECT_EQ(refusal<FormatError>(), "--from critpoints needs " + file("shape.field.h5") +
                                        ", which does not exist or is empty: begin with padapt or before");
  run_.put("shape.field.h5", "field");
  EXPECT_NO_THROW(check_files(run_.chain));
  run_.put("shape.field.h5", "");
  run_.chain.values.separatrix.layout = layout::LayoutChoice::midpoint;
  EXPECT_NO_THROW(check_files(run_.chain)) << "needs no field";
}

TEST_F(CheckFiles, outputs_replace_no_input) {
  std::filesystem::create_symlink(file("plate.step"), file("link.msh"));
  run_.options.output = file("link.msh");
  EXPECT_EQ(refusal<UsageError>(), file("link.msh") + ": is the input " + file("plate.step") +
                                       ", which --output would overwrite: give another file");
  run_.options.output = file("x.msh");
  run_.options.report = file("plate.step");
  EXPECT_EQ(refusal<UsageError>(), file("plate.step") + ": is the input " + file("plate.step") +
                                       ", which --report would overwrite: give another file");
  run_.options.report.clear();
  run_.options.output = file("x.vtu");
  run_.chain.values.quadrefine.size_field_file = run_.put("x.curves.vtu", "x,y,size\n0,0,1\n");
  EXPECT_EQ(refusal<UsageError>(), file("x.curves.vtu") + ": is the input " + file("x.curves.vtu") +
                                       ", which --output would overwrite: give another file");
  run_.options.output = file("x.msh");
  run_.options.words["points2step"] = {"--wake", file("plate.step")};
  run_.options.html = file("plate.step");
  EXPECT_EQ(refusal<UsageError>(), file("plate.step") + ": is the input " + file("plate.step") +
                                       ", which --html would overwrite: give another file");
}

TEST_F(CheckFiles, outputs_replace_no_file_of_the_stages) {
  run_.options.report = file("shape.phase.h5");
  EXPECT_NO_THROW(check_files(run_.chain)) << "stage files are not kept";
  run_.options.workdir = run_.folder.path();
  EXPECT_EQ(
      refusal<UsageError>(),
      file("shape.phase.h5") + ": would be written twice, by --report and by the stage critpoints: give two names");
}

TEST_F(CheckFiles, outputs_differ) {
  run_.options.report = file("./x.msh");
  EXPECT_EQ(refusal<UsageError>(),
            file("./x.msh") + ": would be written twice, by --output and by --report: give two names");
  run_.options.report = "-";
  EXPECT_NO_THROW(check_files(run_.chain));
  run_.options.output = "-";
  EXPECT_EQ(refusal<UsageError>(),
            "--output and --report cannot both go to standard output: name a file for one of them");
}

TEST_F(CheckFiles, outputs_can_be_written) {
  run_.options.output = file("none/x.msh");
  EXPECT_EQ(refusal<OutputError>(), file("none/x.msh") + ": cannot be written: there is no folder " + file("none"));
  run_.options.output = run_.folder.path();
  EXPECT_EQ(refusal<OutputError>(), run_.folder.path() + ": cannot be written: is a directory");
}

TEST(CheckFace, refuses_names_that_the_face_does_not_have) {
  for (const Texts& words : {Texts{"a.step", "--clearance", "hole=0.1"}, {"a.step", "--size-near", "hole=0.1"}}) {
    SampleChain run;
    run.read(words);
    run.chain.last = "before";
    run.chain.files.triangles.set(samples::tri_mesh(), false);
    ChainFailure failure;
    const std::string errors = errors_of([&] { failure = failure_of([&] { check_face(run.chain); }); });
    EXPECT_EQ(failure.code, ExitCode::usage) << words[1];
    EXPECT_EQ(failure.stage, "quadmesh");
    EXPECT_EQ(errors, "quadmesh: " + failure.message + "\ntry 'quadmesh --help'\n");
    EXPECT_EQ(run.chain.last, "") << "no picture";
  }
}

TEST(CheckFace, reads_the_first_file_that_there_is) {
  SampleChain run;
  run.read({"--size-near", "hole=0.1"});
  EXPECT_NO_THROW(check_face(run.chain)) << "there is no file yet";
  io::write_stage(run.chain.files.of_nodes.blocks.path(), samples::block_layout());
  EXPECT_NO_THROW(check_face(run.chain)) << "from the triangles on";
  run.options.first = ChainStage::quadrefine;
  errors_of([&] { EXPECT_EQ(failure_of([&] { check_face(run.chain); }).code, ExitCode::usage); });
}

}  // namespace
}  // namespace quadrille::chain
