#include "chain/shape_converters.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "chain/chain_options.hpp"

namespace quadrille::chain {

namespace {

ChainOptions options_of(const std::string& shape, const std::vector<std::string>& words = {}) {
  std::vector<std::string> arguments{shape};
  arguments.insert(arguments.end(), words.begin(), words.end());
  ChainOptions options;
  read_command_line(arguments, options);
  return options;
}

std::string command_for(const std::string& shape, const std::vector<std::string>& words = {}) {
  const ShapeConverter* converter = converter_of_shape(options_of(shape, words));
  return converter ? std::string(converter->command) : "";
}

std::string refusal(const std::string& shape, const std::vector<std::string>& words) {
  try {
    converter_of_shape(options_of(shape, words));
  } catch (const UsageError& error) {
    return error.what();
  }
  return {};
}

TEST(ShapeConverters, the_ending_tells_the_command) {
  EXPECT_EQ(command_for("a.dat"), "points2step");
  EXPECT_EQ(command_for("folder.svg/a.xy"), "points2step");
  EXPECT_EQ(command_for("a.dxf"), "drawing2step");
  EXPECT_EQ(command_for("A.DXF"), "drawing2step");
  EXPECT_EQ(command_for("a.svg"), "drawing2step");
  EXPECT_EQ(command_for("a.step"), "");
  EXPECT_EQ(command_for("-"), "");
}

TEST(ShapeConverters, an_option_tells_the_command) {
  EXPECT_EQ(command_for("-", {"--farfield", "box:2"}), "points2step");
  EXPECT_EQ(command_for("a.txt", {"--straight"}), "points2step");
  EXPECT_EQ(command_for("-", {"--regions"}), "drawing2step");
  EXPECT_EQ(options_of("a.dxf", {"--embed", "axis", "--regions"}).words.at("drawing2step"),
            (std::vector<std::string>{"--embed", "axis", "--regions"}));
}

TEST(ShapeConverters, options_for_another_kind_of_shape_are_refused) {
  EXPECT_EQ(refusal("a.dxf", {"--chord", "2"}),
            "--chord is an option for points (.dat, .xy), but the shape is a drawing: leave it out");
  EXPECT_EQ(refusal("a.dat", {"--regions"}),
            "--regions is an option for a drawing (.dxf, .svg), but the shape is points: leave it out");
  EXPECT_EQ(refusal("-", {"--regions", "--straight"}),
            "--regions is an option for a drawing (.dxf, .svg), but the shape is points: leave it out");
}

TEST(ShapeConverters, no_two_commands_share_an_option_or_an_ending) {
  for (const ShapeConverter& converter : shape_converters()) {
    for (const auto& [flag, takes_value] : converter.options)
      EXPECT_EQ(converter_with_option(flag), &converter) << flag;
    for (const std::string& ending : converter.endings) EXPECT_EQ(command_for("a" + ending), converter.command);
  }
}

}  // namespace

}  // namespace quadrille::chain
