#include <gtest/gtest.h>

#include "base/error.hpp"
#include "export/netcdf.hpp"
#include "export/writers.hpp"
#include "two_hexes.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

/// Bytes as the specification lists them, in words of four.
TEST(Netcdf, ASmallFileInFull) {
  NetcdfFile file;
  const int n = file.dimension("n", 3), records = file.dimension("t", 0);
  file.attribute("title", std::string("ab"));
  file.variable("k", {n}, std::vector<std::int32_t>{1, 2, -1});
  file.variable("time", {records}, std::vector<double>{});
  const std::string bytes = file.bytes();
  const auto word = [&](std::size_t k) {
    std::uint32_t value = 0;
    for (int byte = 0; byte < 4; ++byte) value = value << 8 | static_cast<unsigned char>(bytes[4 * k + byte]);
    return value;
  };
  std::vector<std::uint32_t> words;
  for (std::size_t k = 0; 4 * k < bytes.size(); ++k) words.push_back(word(k));
  const auto begin = static_cast<std::uint32_t>(4 * (words.size() - 3));
  EXPECT_EQ(words, (std::vector<std::uint32_t>{
                       0x43444602, 0,                                                                // CDF, no record
                       10,         2,          1,         0x6E000000, 3,          1, 0x74000000, 0,  // n = 3; t
                       12,         1,          5,         0x7469746C, 0x65000000, 2, 2,          0x61620000,  // title
                       11,         2,          1,         0x6B000000, 1,          0, 0,          0,
                       4,          12,         0,         begin,  // k
                       4,          0x74696D65, 1,         1,          0,          0, 6,          8,
                       0,          begin + 12,  // time
                       1,          2,          0xFFFFFFFF}));
  EXPECT_THROW(file.variable("m", {n}, std::vector<std::int32_t>{1}), Defect);
}

TEST(Exodus, BlocksAreRegionsAndSideSetsBoundaries) {
  const QuadMesh mesh = two_quads();
  const Exported exported = exodus(mesh, plane_frame(mesh.face));
  EXPECT_EQ(exported.bytes.substr(0, 4), std::string("CDF\2"));
  for (const char* word : {"QUAD9", "left", "right", "wall", "in___out", "curve_3", "num_side_ss3", "connect2"})
    EXPECT_NE(exported.bytes.find(word), std::string::npos) << word;
  ASSERT_EQ(exported.losses.size(), 1u);
  EXPECT_EQ(exported.losses[0], "1 name is written in at most 32 plain letters: \"in & out\" as in___out");
  EXPECT_NE(exodus(two_straight_quads(), plane_frame(mesh.face)).bytes.find("QUAD4"), std::string::npos);
}

TEST(Exodus, HexahedraHaveBlocksAndSideSets) {
  const std::string bytes = exodus(two_hexes({.order = 2, .map = bent})).bytes;
  for (const char* word : {"HEX27", "fluid", "solid", "outlet", "between", "coordz", "num_side_ss5", "connect2"})
    EXPECT_NE(bytes.find(word), std::string::npos) << word;
  // Sides 1, 3 and 4 of the first element, 1 and 3 of the second, as big-endian integers one after another.
  const std::string elems("\0\0\0\1\0\0\0\1\0\0\0\1\0\0\0\2\0\0\0\2", 20);
  const std::string sides("\0\0\0\1\0\0\0\3\0\0\0\4\0\0\0\1\0\0\0\3", 20);
  EXPECT_NE(bytes.find(elems + sides), std::string::npos);
  EXPECT_NE(exodus(two_hexes({})).bytes.find("HEX8"), std::string::npos);
}

}  // namespace
}  // namespace quadrille::exports
