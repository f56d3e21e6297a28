#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

#include "../hand_made.hpp"
#include "../support/refined.hpp"
#include "export/format_table.hpp"
#include "export/writers.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {

namespace {

/// What follows the array's start tag, up to its end tag; "" where there is no such array.
std::string content(const std::string& text, const std::string& name) {
  const std::size_t at = text.find("Name=\"" + name + "\"");
  if (at == std::string::npos) return "";
  const std::size_t begin = text.find('>', at) + 2;
  return text.substr(begin, text.find("\n</DataArray>", begin) - begin);
}

std::vector<std::uint8_t> decoded(const std::string& base64) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::uint8_t> bytes;
  std::uint32_t word = 0;
  int bits = 0;
  for (const char c : base64) {
    if (c == '=') break;
    const std::size_t digit = digits.find(c);
    EXPECT_NE(digit, std::string::npos);
    word = (word << 6) | static_cast<std::uint32_t>(digit);
    if ((bits += 6) >= 8) bytes.push_back(static_cast<std::uint8_t>(word >> (bits -= 8)));
  }
  return bytes;
}

/// An array of the file: 12 characters hold the number of its bytes, then they come.
template <class T>
std::vector<T> values(const std::string& text, const std::string& name) {
  const std::string base64 = content(text, name);
  EXPECT_GE(base64.size(), 12u) << name;
  std::uint64_t size = 0;
  std::memcpy(&size, decoded(base64.substr(0, 12)).data(), sizeof size);
  const std::vector<std::uint8_t> bytes = decoded(base64.substr(12));
  EXPECT_EQ(bytes.size(), size) << name;
  std::vector<T> numbers(bytes.size() / sizeof(T));
  if (!numbers.empty()) std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(T));
  return numbers;
}

std::vector<std::string> texts(const std::string& text, const std::string& name) {
  std::istringstream in(content(text, name));
  std::vector<std::string> found(1);
  for (int code = 0; in >> code;) {
    if (code == 0)
      found.emplace_back();
    else
      found.back() += static_cast<char>(code);
  }
  found.pop_back();
  return found;
}

Vec2 point(const std::vector<double>& points, int k) {
  EXPECT_EQ(points[3 * k + 2], 0);
  return {points[3 * k], points[3 * k + 1]};
}

TEST(Vtu, NodesOfAQuadComeInVtkSequence) {
  // Corners round, then bottom, right, top and left each in the direction of rising coordinates, then inside.
  const QuadMesh mesh = refined(hand_made::unit_square(), {1, 3, 5e-7});
  const std::string text = vtu_lagrange(mesh, plane_frame(mesh.face)).bytes;
  const auto nodes = values<int>(text, "connectivity");
  const auto points = values<double>(text, "Points");
  const std::vector<Vec2> thirds{{0, 0}, {3, 0}, {3, 3}, {0, 3}, {1, 0}, {2, 0}, {3, 1}, {3, 2},
                                 {1, 3}, {2, 3}, {0, 1}, {0, 2}, {1, 1}, {2, 1}, {1, 2}, {2, 2}};
  ASSERT_EQ(nodes.size(), thirds.size());
  for (std::size_t k = 0; k < thirds.size(); ++k)
    EXPECT_NEAR(distance(point(points, nodes[k]), thirds[k] / 3), 0, 1e-15) << k;
  EXPECT_EQ(values<int>(text, "offsets"), std::vector<int>{16});
  EXPECT_EQ(values<std::uint8_t>(text, "types"), std::vector<std::uint8_t>{70});
}

TEST(Vtu, CellDataAreThoseOfTheMesh) {
  QuadMesh mesh = refined(hand_made::l_shape(), {0.5, 2, 5e-7});
  mesh.block_names = {"solid", "fluid", "solid"};
  mesh.unnamed_blocks.clear();
  const std::string text = vtu_lagrange(mesh, plane_frame(mesh.face)).bytes;
  EXPECT_EQ(values<int>(text, "block_id"), mesh.elem_block);
  EXPECT_EQ(values<double>(text, "least_scaled_jacobian"), mesh.elem_scaled_jacobian);
  EXPECT_EQ(values<double>(text, "least_jacobian_bound"), mesh.elem_jacobian_bound);
  EXPECT_EQ(texts(text, "block_names"), mesh.block_names);
  EXPECT_EQ(texts(text, "region_names"), (std::vector<std::string>{"solid", "fluid"}));
  const auto regions = values<int>(text, "region_id"), attributes = values<int>(text, "attribute");
  const auto ids = values<int>(text, "element_id");
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    EXPECT_EQ(regions[elem], mesh.elem_block[elem] == 1);
    EXPECT_EQ(attributes[elem], regions[elem] + 1);
    EXPECT_EQ(ids[elem], elem);
  }
}

TEST(Vtu, CurvesHoldBoundaryAndInterfaces) {
  QuadMesh mesh = refined(hand_made::l_shape(), {0.5, 4, 5e-7});
  mesh.face.curve_names.assign(mesh.face.curves.size(), "wall");
  const Exported file = vtu_lagrange(mesh, plane_frame(mesh.face));
  ASSERT_EQ(file.side_files.size(), 1u);
  EXPECT_EQ(file.side_files[0].name.ending, ".curves.vtu");
  const std::string& text = file.side_files[0].bytes;
  const auto is_interface = values<int>(text, "is_interface"), curve = values<int>(text, "curve_id");
  const auto name = values<int>(text, "name_id"), right = values<int>(text, "right_block");
  std::size_t outer = 0;
  for (std::size_t k = 0; k < curve.size(); ++k) {
    outer += is_interface[k] == 0;
    EXPECT_EQ(curve[k] < 0, is_interface[k] == 1);
    EXPECT_EQ(name[k], is_interface[k] ? -1 : 0);
    EXPECT_EQ(right[k] >= 0, is_interface[k] == 1);
  }
  EXPECT_EQ(outer, mesh.boundary_edges.size());
  EXPECT_EQ(curve.size() - outer, 4u);  // two interfaces of two edges
  EXPECT_EQ(texts(text, "boundary_names"), std::vector<std::string>{"wall"});
  // An edge: its ends, then three nodes between them in equal steps.
  const auto nodes = values<int>(text, "connectivity");
  const auto points = values<double>(text, "Points");
  ASSERT_EQ(nodes.size(), 5 * curve.size());
  for (std::size_t k = 0; k < curve.size(); ++k) {
    const Vec2 a = point(points, nodes[5 * k]), b = point(points, nodes[5 * k + 1]);
    for (int i = 1; i < 4; ++i)
      EXPECT_NEAR(distance(point(points, nodes[5 * k + 1 + i]), a + i / 4.0 * (b - a)), 0, 1e-15);
  }
}

TEST(Vtu, BezierHasItsTypesAndCorners) {
  const QuadMesh mesh = refined(hand_made::quarter_annulus(), {1, 2, 5e-7});
  const Exported file = vtu_bezier(mesh, plane_frame(mesh.face));
  EXPECT_EQ(values<std::uint8_t>(file.bytes, "types")[0], 77);
  EXPECT_EQ(values<std::uint8_t>(file.side_files[0].bytes, "types")[0], 75);
  const auto points = values<double>(file.bytes, "Points");
  const auto nodes = values<int>(file.bytes, "connectivity");
  const int* ids = &mesh.elem_nodes[0];
  EXPECT_EQ(point(points, nodes[0]), mesh.nodes[ids[0]]);
  EXPECT_NEAR(distance(point(points, nodes[4]), 2 * mesh.nodes[ids[1]] - (mesh.nodes[ids[0]] + mesh.nodes[ids[2]]) / 2),
              0, 1e-15);
}

TEST(Vtu, FrameInSpaceIsWritten) {
  QuadMesh mesh = refined(hand_made::unit_square(), {1, 1, 5e-7});
  mesh.face.plane_origin = {0, 0, 5}, mesh.face.plane_x = {0, 1, 0}, mesh.face.plane_y = {0, 0, 1};
  const auto points = values<double>(export_mesh(mesh, *find_export_format("vtu"), {.in_space = true}).bytes, "Points");
  EXPECT_EQ(std::vector<double>(points.begin(), points.begin() + 6), (std::vector<double>{0, 0, 5, 0, 1, 5}));
}

TEST(Vtu, Base64IsPaddedAsTheStandardSays) {
  // One, two and three bytes of cell types after the eight of their length.
  for (const auto& [mesh, tail] :
       {std::pair{refined(hand_made::unit_square(), {1, 1, 5e-7}), "Rg=="}, std::pair{two_quads(), "RkY="},
        std::pair{refined(hand_made::l_shape(), {1, 1, 5e-7}), "RkZG"}}) {
    const std::string text = vtu_lagrange(mesh, plane_frame(mesh.face)).bytes;
    EXPECT_NE(text.find(std::string("AAAAAAAAA=") + tail + "\n"), std::string::npos) << tail;
  }
}

TEST(Vtu, ArraysReadBackToTheSameBits) {
  const QuadMesh mesh = two_straight_quads();
  const std::string text = vtu_lagrange(mesh, plane_frame(mesh.face)).bytes;
  const auto points = values<double>(text, "Points");
  ASSERT_EQ(points.size(), 3 * mesh.nodes.size());
  for (std::size_t k = 0; k < mesh.nodes.size(); ++k) EXPECT_EQ(point(points, static_cast<int>(k)), mesh.nodes[k]);
  EXPECT_EQ(values<int>(text, "offsets"), (std::vector<int>{4, 8}));
  EXPECT_EQ(values<int>(text, "connectivity").size(), 8u);
}

TEST(Vtu, CountsAndTextsStandInTheFile) {
  QuadMesh mesh = two_straight_quads();
  mesh.block_names = {"in", "a&b"};
  const std::string text = vtu_lagrange(mesh, plane_frame(mesh.face)).bytes;
  EXPECT_NE(text.find("<Piece NumberOfPoints=\"6\" NumberOfCells=\"2\">"), std::string::npos);
  EXPECT_NE(text.find("Name=\"block_names\" NumberOfTuples=\"2\" format=\"ascii\">\n105 110 0\n97 38 98 0\n"),
            std::string::npos);
  EXPECT_NE(text.find("byte_order=\"LittleEndian\" header_type=\"UInt64\""), std::string::npos);
}

TEST(Vtu, AGridWithoutCellsIsEmpty) {
  QuadMesh mesh;
  mesh.order = 1;
  const std::string text = vtu_lagrange(mesh, plane_frame(mesh.face)).bytes;
  EXPECT_NE(text.find("NumberOfPoints=\"0\" NumberOfCells=\"0\""), std::string::npos);
  EXPECT_TRUE(values<double>(text, "Points").empty());
}

}  // namespace

}  // namespace quadrille::exports
