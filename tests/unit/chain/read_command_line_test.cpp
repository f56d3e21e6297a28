#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "../support/texts.hpp"
#include "base/error.hpp"
#include "chain/chain_options.hpp"
#include "temporary_folder.hpp"

namespace quadrille::chain {
namespace {

using Texts = std::vector<std::string>;

ChainOptions read(const Texts& words) {
  ChainOptions options;
  read_command_line(words, options);
  return options;
}

std::string refusal(const Texts& words) {
  return message_of<UsageError>([&] { read(words); });
}

TEST(ReadCommandLine, without_options_all_stages_run_and_write_to_standard_output) {
  const ChainOptions options = read({"plate.step"});
  EXPECT_EQ(options.shape, "plate.step");
  EXPECT_EQ(options.output, "");
  EXPECT_EQ(options.first, ChainStage::cad2tri);
  EXPECT_EQ(options.last, ChainStage::quadexport);
  EXPECT_FALSE(options.is_quiet || options.is_verbose || options.is_dry_run);
  EXPECT_TRUE(options.words.empty());
}

TEST(ReadCommandLine, letters_may_be_joined_and_values_follow_them) {
  for (const Texts& words : {Texts{"-qv", "-ox.msh"}, {"-q", "-v", "-o", "x.msh"}, {"-vqox.msh"}, {"-vqo", "x.msh"}}) {
    const ChainOptions options = read(words);
    EXPECT_TRUE(options.is_quiet && options.is_verbose);
    EXPECT_EQ(options.output, "x.msh");
  }
}

TEST(ReadCommandLine, values_follow_an_equals_sign_or_are_the_next_word) {
  EXPECT_EQ(read({"--output=x=1.msh"}).output, "x=1.msh");
  EXPECT_EQ(read({"--output", "x.msh"}).output, "x.msh");
  EXPECT_EQ(read({"--name=wall=0"}).words.at("cad2tri"), (Texts{"--name", "wall=0"}));
  EXPECT_EQ(read({"--size=0.5"}).words.at("quadrefine"), (Texts{"--size", "0.5"}));
  EXPECT_EQ(refusal({"--quiet=yes"}), "--quiet takes no value");
  EXPECT_EQ(refusal({"--allow-invalid=yes"}), "--allow-invalid takes no value");
}

TEST(ReadCommandLine, values_may_be_empty_or_begin_with_a_dash_but_are_no_options) {
  EXPECT_EQ(read({"-o", "-"}).output, "-");
  EXPECT_EQ(read({"--scale", "-1"}).words.at("quadexport"), (Texts{"--scale", "-1"}));
  EXPECT_EQ(read({"--name", ""}).words.at("cad2tri"), (Texts{"--name", ""}));
  EXPECT_FALSE(read({"--face", ""}).words.contains("cad2tri")) << "the only face";
  EXPECT_EQ(refusal({"-o"}), "-o needs a value");
  EXPECT_EQ(refusal({"--workdir", "--quiet"}), "--workdir needs a value, not the option --quiet");
  EXPECT_EQ(refusal({"--size", "--quiet"}), "--size needs a value, not the option --quiet");
}

TEST(ReadCommandLine, unknown_options_get_the_nearest_one) {
  EXPECT_EQ(refusal({"--outptu", "x"}), "unknown option --outptu: did you mean --output?");
  EXPECT_EQ(refusal({"--max-valance=6"}), "unknown option --max-valance: did you mean --max-valence?");
  EXPECT_EQ(refusal({"--nothing-like-it"}), "unknown option --nothing-like-it");
  EXPECT_EQ(refusal({"-x"}), "unknown option -x");
  EXPECT_EQ(refusal({"-vx"}), "unknown option -x");
}

TEST(ReadCommandLine, there_is_one_shape) {
  EXPECT_EQ(read({"-"}).shape, "-");
  EXPECT_EQ(refusal({"a.step", "b.step"}), "more than one shape: a.step and b.step");
  EXPECT_EQ(refusal({""}), "the name of the shape is empty");
}

TEST(ReadCommandLine, options_go_to_all_stages_that_have_them) {
  const ChainOptions options = read({"--unit", "mm", "--ties", "field", "--farfield", "box:9", "--face", "2"});
  EXPECT_EQ(options.words.at("quadrefine"), (Texts{"--unit", "mm"}));
  EXPECT_EQ(options.words.at("quadexport"), (Texts{"--unit", "mm"}));
  EXPECT_EQ(options.words.at("critpoints"), (Texts{"--ties", "field"}));
  EXPECT_EQ(options.words.at("points2step"), (Texts{"--farfield", "box:9"}));
  EXPECT_EQ(options.converter_option, "--farfield");
  EXPECT_EQ(options.cad_option, "--face");
  EXPECT_TRUE(options.has("critpoints", "--ties"));
  EXPECT_FALSE(options.has("critpoints", "--unit") || options.has("padapt", "--unit"));
}

TEST(ReadCommandLine, options_for_points_go_to_points2step) {
  const Texts words{"--points-corner-angle",
                    "80",
                    "--points-tolerance",
                    "2",
                    "--points-format",
                    "selig",
                    "--points-unit",
                    "mm",
                    "--straight",
                    "--face-name",
                    "water",
                    "--simplify-outline",
                    "0.1"};
  const ChainOptions options = read(words);
  EXPECT_EQ(options.words.at("points2step"), words);
  EXPECT_EQ(options.words.size(), 1);
  EXPECT_EQ(options.converter_option, "--simplify-outline");
  EXPECT_EQ(read({"--straight"}).converter_option, "--straight");
}

TEST(ReadCommandLine, nodes_are_a_rule_or_a_file) {
  EXPECT_EQ(read({"--nodes", "fewest"}).words.at("critpoints"), (Texts{"--nodes", "fewest"}));
  EXPECT_EQ(read({"--nodes", "fewest"}).nodes_file, "");
  EXPECT_EQ(read({"--nodes", "x.crit.json"}).nodes_file, "x.crit.json");
}

TEST(ReadCommandLine, stages_have_names) {
  const ChainOptions options = read({"--from", "padapt", "--until=separatrix"});
  EXPECT_EQ(options.first, ChainStage::padapt);
  EXPECT_EQ(options.last, ChainStage::separatrix);
  EXPECT_EQ(options.from + options.until, "padaptseparatrix");
  EXPECT_EQ(refusal({"--from", "critpoint"}),
            "--from: 'critpoint' is no stage (did you mean critpoints?): the stages are cad2tri fieldsolve padapt "
            "critpoints separatrix blocksplit quadrefine hexsweep quadexport");
}

TEST(ReadCommandLine, programs_take_the_place_of_stages) {
  const ChainOptions options = read({"--stage", "padapt=my padapt --x=1", "--stage=critpoints=c"});
  EXPECT_EQ(options.programs.at(ChainStage::padapt), "my padapt --x=1");
  EXPECT_EQ(options.programs.at(ChainStage::critpoints), "c");
  for (const char* text : {"padapt", "padapt="})
    EXPECT_EQ(refusal({"--stage", text}), "--stage: '" + std::string(text) + "' is not NAME=COMMAND");
  expect_contains(refusal({"--stage", "padap=x"}), "'padap' is no stage (did you mean padapt?)");
}

TEST(ReadCommandLine, limits_and_threads_are_numbers) {
  const ChainOptions options = read({"--max-seconds", "1.5", "--max-memory", "2K", "--threads", "3"});
  EXPECT_EQ(options.limits.seconds, 1.5);
  EXPECT_EQ(options.limits.memory, 2048U);
  EXPECT_EQ(options.num_threads, 3);
  EXPECT_EQ(options.threads, "3");
  EXPECT_EQ(read({"--threads", "auto"}).num_threads, 0);
  EXPECT_NE(refusal({"--threads", "0"}), "");
}

TEST(ReadCommandLine, every_option_is_listed_for_programs) {
  const std::string list = option_list();
  for (const char* line : {"quadmesh --region-name values\n", "quadmesh --offset values\n", "quadmesh --wall values\n",
                           "quadmesh --symmetry values\n", "quadmesh --stage values\n", "quadmesh --size-field file\n",
                           "quadmesh --boundary-names file\n", "quadmesh --keep-joints flag\n",
                           "quadmesh --farfield value\n", "quadmesh --straight flag\n", "quadmesh --size value\n",
                           "quadmesh --block-groups flag\n", "quadmesh --report value\n"})
    expect_contains(list, line);
  for (const char* name : {"--help", "--version", "--output"}) EXPECT_EQ(list.find(name), std::string::npos) << name;
}

TEST(ReadCommandLine, the_typed_command_has_files_without_folders) {
  const TemporaryFolder folder;
  EXPECT_EQ(read({folder.file("a.step"), "--output=" + folder.file("x.msh"), "--name", "hole @0/1=1"}).typed,
            "quadmesh a.step --output=x.msh --name 'hole @0/1=1'");
}

TEST(StageOptionsOfWords, are_those_of_the_stages) {
  const StageOptions values = stage_options(read({"--max-valence", "6", "--name", "wall=0", "--order", "7"}));
  EXPECT_EQ(values.critpoints.choose.max_valence, 6);
  EXPECT_EQ(values.cad2tri.curve_names, (Texts{"wall=0"}));
  EXPECT_EQ(values.quadrefine.refine.order, 7);
  EXPECT_EQ(message_of<UsageError>([] {
              stage_options(read({"--max-valence", "60"}));
            }),
            "--max-valence: 60 is outside its interval (5 to 12)");
}

TEST(ShellCommand, quotes_what_a_shell_would_change) {
  EXPECT_EQ(shell_command({"cp", "-", "a_b/c.d:e=f,g+h%i@j-k"}), "cp - a_b/c.d:e=f,g+h%i@j-k");
  EXPECT_EQ(shell_command({"a b", "", "it's", "*"}), "'a b' '' 'it'\\''s' '*'");
  EXPECT_EQ(shell_command({}), "");
}

TEST(HelpText, each_of_its_options_is_known) {
  std::istringstream lines(full_help_text());
  const std::regex row("^  (?:-., )?(--[a-z-]+).*");
  int num_options = 0;
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    // A list of words, which completions read, cannot be broken.
    const bool is_list = std::regex_match(line, std::regex("^  --[a-z-]+ [^ ]*\\|[^ ]*$"));
    EXPECT_TRUE(is_list || line.size() <= 120U) << line;
    if (!std::regex_match(line, match, row)) continue;
    ++num_options;
    EXPECT_FALSE(refusal({match[1], "1"}).starts_with("unknown option")) << line;
  }
  EXPECT_GT(num_options, 50);
}

TEST(HelpText, has_the_options_of_the_stages) {
  expect_counts(full_help_text(), {{"\nOPTIONS OF ", 6}, {"\nOPTIONS OF CRITPOINTS\n", 1}, {"\n  --max-valence ", 1}});
}

}  // namespace
}  // namespace quadrille::chain
