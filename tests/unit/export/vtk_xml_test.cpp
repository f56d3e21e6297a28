#include "export/vtk_xml.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <optional>

#include "../support/texts.hpp"
#include "base/base64.hpp"

namespace quadrille::exports {
namespace {

VtkGrid two_lines() {
  VtkGrid grid;
  grid.points = {{0, 0, 0}, {1, 0, 0}, {1, 2, 0}};
  grid.cell_type = 3, grid.nodes_per_cell = 2;
  grid.connectivity = {0, 1, 1, 2};
  return grid;
}

/// The bytes of the array with these attributes, behind its length.
std::string bytes_of(const std::string& text, const std::string& attributes) {
  const std::size_t at = text.find(attributes);
  if (at == std::string::npos) return "missing";
  const std::size_t begin = text.find('\n', at) + 1, end = text.find('\n', begin);
  const std::string encoded = text.substr(begin, end - begin);
  const auto length = bytes_of_base64(encoded.substr(0, 12)), bytes = bytes_of_base64(encoded.substr(12));
  if (!length || !bytes) return "no base64";
  std::uint64_t size = 0;
  std::memcpy(&size, length->data(), 8);
  EXPECT_EQ(size, bytes->size()) << "the length and the bytes are encoded separately";
  return {bytes->begin(), bytes->end()};
}

template <class Value>
std::vector<Value> values_of(const std::string& text, const std::string& attributes) {
  const std::string bytes = bytes_of(text, attributes);
  std::vector<Value> values(bytes.size() / sizeof(Value));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(Value));
  return values;
}

TEST(VtkXml, HasPointsAndCells) {
  const std::string text = vtk_xml(two_lines());
  expect_contains(text, "<Piece NumberOfPoints=\"3\" NumberOfCells=\"2\">");
  EXPECT_EQ(values_of<double>(text, "Name=\"Points\""), (std::vector<double>{0, 0, 0, 1, 0, 0, 1, 2, 0}));
  EXPECT_EQ(values_of<int>(text, "Name=\"connectivity\""), (std::vector<int>{0, 1, 1, 2}));
  EXPECT_EQ(values_of<int>(text, "Name=\"offsets\""), (std::vector<int>{2, 4}));
  EXPECT_EQ(values_of<std::uint8_t>(text, "Name=\"types\""), (std::vector<std::uint8_t>{3, 3}));
}

TEST(VtkXml, CellsHaveValuesAndTextsAreTheNumbersOfTheirBytes) {
  VtkGrid grid = two_lines();
  grid.cell_integers = {{"block", {4, 5}}};
  grid.cell_reals = {{"size", {0.5, -1}}};
  grid.texts = {{"names", {"ab", "\xc3\x9f", ""}}};
  const std::string text = vtk_xml(grid);
  EXPECT_EQ(values_of<int>(text, "Name=\"block\""), (std::vector<int>{4, 5}));
  EXPECT_EQ(values_of<double>(text, "Name=\"size\""), (std::vector<double>{0.5, -1}));
  expect_contains(text, "Name=\"names\" NumberOfTuples=\"3\" format=\"ascii\">\n97 98 0\n195 159 0\n0\n</DataArray>");
}

TEST(VtkXml, AnEmptyGridIsWhole) {
  VtkGrid grid;
  grid.nodes_per_cell = 4;
  const std::string text = vtk_xml(grid);
  expect_contains(text, "NumberOfPoints=\"0\" NumberOfCells=\"0\"");
  EXPECT_TRUE(text.ends_with("</VTKFile>\n"));
  EXPECT_EQ(bytes_of(text, "Name=\"Points\""), "");
}

/// Corners first, then the sides bottom, right, top, left, all in the direction of rising xi.
TEST(VtkQuadOrder, OfOrderThree) {
  EXPECT_EQ(vtk_quad_order(1), (std::vector<int>{0, 1, 3, 2}));
  EXPECT_EQ(vtk_quad_order(3), (std::vector<int>{0, 3, 15, 12, 1, 2, 7, 11, 13, 14, 4, 8, 5, 6, 9, 10}));
}

TEST(ProvenanceLines, HaveToolVersionAndOptions) {
  EXPECT_EQ(provenance_lines({{"cad2tri", "1.0", {}, "{}"}, {"fieldsolve", "1.1", {}, R"({"a":1})"}}),
            (std::vector<std::string>{"cad2tri 1.0 {}", R"(fieldsolve 1.1 {"a":1})"}));
}

}  // namespace
}  // namespace quadrille::exports
