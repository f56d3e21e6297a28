#include "export/vtk_xml.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>

namespace quadrille::exports {
namespace {

/// A square of one cell with a value of each kind.
VtkGrid one_cell() {
  VtkGrid grid;
  grid.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.5}};
  grid.cell_type = 9;
  grid.nodes_per_cell = 4;
  grid.connectivity = {0, 1, 2, 3};
  grid.cell_integers = {{"block", {7}}};
  grid.cell_reals = {{"quality", {0.25}}};
  grid.texts = {{"names", {"in", "a&b"}}};
  return grid;
}

std::vector<std::uint8_t> decoded(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i < text.size(); i += 4) {
    std::uint32_t word = 0;
    int padding = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      padding += text.at(i + k) == '=';
      word = (word << 6) | (text[i + k] == '=' ? 0u : static_cast<std::uint32_t>(digits.find(text[i + k])));
    }
    for (int k = 0; k < 3 - padding; ++k) bytes.push_back(static_cast<std::uint8_t>(word >> (16 - 8 * k)));
  }
  return bytes;
}

/// The numbers of the array with this name, after a head of eight bytes with their length.
template <class Number>
std::vector<Number> numbers(const std::string& text, const std::string& name) {
  const std::size_t tag = text.find("Name=\"" + name + "\"");
  EXPECT_NE(tag, std::string::npos) << name;
  const std::size_t begin = text.find(">\n", tag) + 2, end = text.find('\n', begin);
  const std::string line = text.substr(begin, end - begin);
  const std::vector<std::uint8_t> head = decoded(line.substr(0, 12)), bytes = decoded(line.substr(12));
  std::uint64_t size = 0;
  std::memcpy(&size, head.data(), 8);
  EXPECT_EQ(head.size(), 8u);
  EXPECT_EQ(size, bytes.size());
  std::vector<Number> found(bytes.size() / sizeof(Number));
  if (!found.empty()) std::memcpy(found.data(), bytes.data(), found.size() * sizeof(Number));
  return found;
}

TEST(VtkXml, ArraysReadBackToTheSameBits) {
  const std::string text = vtk_xml(one_cell());
  EXPECT_EQ(numbers<double>(text, "Points"), (std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0.5}));
  EXPECT_EQ(numbers<std::int32_t>(text, "connectivity"), (std::vector<std::int32_t>{0, 1, 2, 3}));
  EXPECT_EQ(numbers<std::int32_t>(text, "offsets"), (std::vector<std::int32_t>{4}));
  EXPECT_EQ(numbers<std::uint8_t>(text, "types"), (std::vector<std::uint8_t>{9}));
  EXPECT_EQ(numbers<std::int32_t>(text, "block"), (std::vector<std::int32_t>{7}));
  EXPECT_EQ(numbers<double>(text, "quality"), (std::vector<double>{0.25}));
}

TEST(VtkXml, Base64IsPaddedAsTheStandardSays) {
  // One, two and three bytes of cell types after the eight of their length.
  for (const auto& [cells, tail] : {std::pair{1, "CQ=="}, std::pair{2, "CQk="}, std::pair{3, "CQkJ"}}) {
    VtkGrid grid = one_cell();
    grid.cell_integers.clear(), grid.cell_reals.clear();
    grid.connectivity.clear();
    for (int c = 0; c < cells; ++c) grid.connectivity.insert(grid.connectivity.end(), {0, 1, 2, 3});
    EXPECT_NE(vtk_xml(grid).find(std::string("AAAAAAAAA=") + tail + "\n"), std::string::npos) << cells;
  }
}

TEST(VtkXml, OffsetsAreEndsOfCells) {
  VtkGrid grid = one_cell();
  grid.connectivity = {0, 1, 2, 3, 3, 2, 1, 0, 1, 2, 3, 0};
  EXPECT_EQ(numbers<std::int32_t>(vtk_xml(grid), "offsets"), (std::vector<std::int32_t>{4, 8, 12}));
}

TEST(VtkXml, CountsAndTextsStandInTheFile) {
  const std::string text = vtk_xml(one_cell());
  EXPECT_NE(text.find("<Piece NumberOfPoints=\"4\" NumberOfCells=\"1\">"), std::string::npos);
  EXPECT_NE(text.find("Name=\"names\" NumberOfTuples=\"2\" format=\"ascii\">\n105 110 0\n97 38 98 0\n"),
            std::string::npos);
  EXPECT_NE(text.find("byte_order=\"LittleEndian\" header_type=\"UInt64\""), std::string::npos);
}

TEST(VtkXml, AGridWithoutCellsIsEmpty) {
  VtkGrid grid;
  grid.nodes_per_cell = 4;
  const std::string text = vtk_xml(grid);
  EXPECT_NE(text.find("NumberOfPoints=\"0\" NumberOfCells=\"0\""), std::string::npos);
  EXPECT_TRUE(numbers<double>(text, "Points").empty());
}

}  // namespace
}  // namespace quadrille::exports
