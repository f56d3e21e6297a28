#include "chain/chain_inputs.hpp"

#include <gtest/gtest.h>

#include "../support/texts.hpp"
#include "sample_chain.hpp"

namespace quadrille::chain {

namespace {

TEST(ReadInput, is_a_file_or_what_standard_input_held) {
  SampleChain run;
  EXPECT_EQ(read_input(run.chain, run.put("nodes", "abc")).bytes, "abc");
  run.chain.standard_input = "def";
  const io::InputFile file = read_input(run.chain, "-");
  EXPECT_EQ(file.bytes, "def");
  EXPECT_EQ(file.name, "standard input");
  EXPECT_EQ(file.sha256, io::identity_of("", "def").sha256);
  EXPECT_EQ(read_input(run.chain, run.folder.file("nodes")).bytes, "abc");
  run.chain.standard_input = "";
  EXPECT_EQ(message_of<FormatError>([&] { read_input(run.chain, "-"); }), "standard input: is empty");
}

TEST(Names, are_read_from_the_files_that_the_options_name) {
  SampleChain run;
  EXPECT_FALSE(boundary_names(run.chain).file || boundary_names(run.chain).input());
  EXPECT_FALSE(block_names(run.chain).file);
  run.chain.values.cad2tri.names_file = run.put("boundaries", R"({"0": "wall"})");
  run.chain.values.blocksplit.names_file = run.put("blocks", R"("fluid")");
  const auto boundaries = boundary_names(run.chain), blocks = block_names(run.chain);
  EXPECT_EQ(boundaries.content.size(), 1U);
  EXPECT_EQ(boundaries.file->name, run.folder.file("boundaries"));
  EXPECT_EQ(&boundaries.input()->model, &boundaries.content);
  EXPECT_EQ(blocks.content.size(), 1U);
  run.put("blocks", "no names");
  EXPECT_THROW(block_names(run.chain), FormatError);
}

TEST(PrescribedSizes, are_in_the_coordinates_of_the_file) {
  SampleChain run;
  EXPECT_FALSE(prescribed_sizes(run.chain).file);
  run.chain.values.quadrefine.size_field_file = run.put("sizes.csv", "x,y,size\n0,0,1\n8,0,1\n0,8,2\n8,8,2\n");
  const auto sizes = prescribed_sizes(run.chain);
  EXPECT_TRUE(sizes.content.is_table);
  ASSERT_EQ(sizes.content.points.size(), 4U);
  EXPECT_EQ(sizes.content.points[1].position, (Vec3{8, 0, 0}));
}

}  // namespace

}  // namespace quadrille::chain
