#include <gtest/gtest.h>

#include <cstring>

#include "base/error.hpp"
#include "export/hex_blend.hpp"
#include "export/writers.hpp"
#include "two_hexes.hpp"

namespace quadrille::exports {
namespace {

double number_at(const std::string& bytes, std::size_t at) {
  double number = 0;
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

std::vector<double> numbers_at(const std::string& bytes, std::size_t at, int count) {
  std::vector<double> numbers;
  for (int k = 0; k < count; ++k) numbers.push_back(number_at(bytes, at + 8 * k));
  return numbers;
}

constexpr std::size_t elements = 84, after_two = elements + 2 * 200;

TEST(NekRe2Hex, CornersOfTheBottomComeBeforeThoseOfTheTop) {
  const std::string bytes = nek_re2(two_hexes({.order = 2})).bytes;
  EXPECT_EQ(bytes.substr(0, 50), "#v004               2  3               2   1 hdr  ");
  EXPECT_EQ(numbers_at(bytes, elements, 25),
            (std::vector<double>{1, 0, 2, 2, 0, 0, 2, 2, 0, 0, 0, 2, 2, 0, 0, 2, 2, 0, 0, 0, 0, 1, 1, 1, 1}));
  EXPECT_EQ(number_at(bytes, elements + 200), 2) << "the second region";
  EXPECT_EQ(number_at(bytes, after_two), 0) << "no curved edge";
}

TEST(NekRe2Hex, FacesHaveNumbersOfTheirNamesAndInterfacesNone) {
  const Exported exported = nek_re2(two_hexes({.order = 2, .first_corner = 1}));
  const std::size_t first = after_two + 8;
  EXPECT_EQ(number_at(exported.bytes, first), 10) << "of 11 outer faces and one interface";
  EXPECT_EQ(exported.bytes.size(), first + 8 + 10 * 64);
  EXPECT_EQ(numbers_at(exported.bytes, first + 8, 7), (std::vector<double>{1, 1, 0, 0, 0, 0, 1}));
  EXPECT_EQ(numbers_at(exported.bytes, first + 8 + 3 * 64, 7), (std::vector<double>{1, 5, 0, 0, 0, 0, 3}));
  EXPECT_EQ(numbers_at(exported.bytes, first + 8 + 5 * 64, 7), (std::vector<double>{2, 1, 0, 0, 0, 0, 2}))
      << "the turned element has the outlet on its first face";
  EXPECT_EQ(exported.bytes.substr(first + 8 + 56, 8), "MSH     ");
  ASSERT_EQ(exported.losses.size(), 2u);
  EXPECT_NE(exported.losses[1].find("1 interface is not stored"), std::string::npos);
}

TEST(NekRe2Hex, CurvedEdgesHaveTheirMiddles) {
  const auto raised = [](Vec3 x) { return Vec3{x.x, x.y, x.z * (1 + x.x * (4 - x.x) * (2 - x.y) / 32)}; };
  const Exported exported = nek_re2(two_hexes({.order = 3, .map = raised}));
  EXPECT_EQ(number_at(exported.bytes, after_two), 2) << "one edge of each element: y = 0, z = 1";
  const std::vector<double> record = numbers_at(exported.bytes, after_two + 8, 7);
  EXPECT_EQ(record[0], 1);
  EXPECT_EQ(record[1], 5);
  EXPECT_NEAR(record[2], 1, 1e-15);
  EXPECT_EQ(record[3], 0);
  EXPECT_NEAR(record[4], 1.1875, 1e-15);
  EXPECT_EQ(exported.bytes.substr(after_two + 8 + 56, 8), "m       ");
  EXPECT_EQ(exported.losses.size(), 2u) << "the shape is that of its quadratic edges";
}

TEST(NekRe2Hex, PeriodicFacesNameEachOther) {
  HexMesh mesh = two_hexes({.order = 1, .layers = 2});
  join_ends(mesh, 2);
  const std::string bytes = nek_re2(mesh).bytes;
  const std::size_t first = elements + 4 * 200 + 16;
  EXPECT_EQ(numbers_at(bytes, first + 3 * 64, 7), (std::vector<double>{1, 5, 3, 6, 0, 0, 3}));
  EXPECT_EQ(bytes.substr(first + 3 * 64 + 56, 8), "P       ");
}

TEST(NekRe2Hex, TheFieldHasAllNodesAxisByAxis) {
  const HexMesh mesh = two_hexes({.order = 3, .first_corner = 2, .map = bent});
  const Exported exported = nek_re2(mesh);
  ASSERT_EQ(exported.side_files.size(), 2u);
  const std::string& field = exported.side_files[1].bytes;
  EXPECT_EQ(field.substr(0, 16), "#std 8  4  4  4 ");
  ASSERT_EQ(field.size(), 132u + 4 + 8 + 2 * 3 * 64 * 8);
  for (int k = 0; k < 64; ++k) {
    const Vec3 x = mesh.nodes[mesh.elem_nodes[64 + k]];
    EXPECT_EQ(number_at(field, 144 + 8 * (3 * 64 + k)), x.x);
    EXPECT_EQ(number_at(field, 144 + 8 * (5 * 64 + k)), x.z);
  }
}

TEST(NekRe2Hex, LossesAreMeasuredAndFoldsRefused) {
  HexMesh mesh = two_hexes({.order = 2});
  mesh.nodes[mesh.elem_nodes[13]].x += 0.125;
  EXPECT_NEAR(quadratic_edge_loss(mesh, "Nek5000").others, 0.125, 1e-15);
  EXPECT_EQ(quadratic_edge_loss(mesh, "Nek5000").edges, 0);
  const auto bulged = [](Vec3 x) { return Vec3{x.x, x.y, x.z * (1 - 2 * x.x * (2 - x.x) * x.y * (2 - x.y))}; };
  const HexMesh bad = two_hexes({.order = 2, .map = bulged});  // the middle of the top is below the bottom
  EXPECT_NO_THROW(quadratic_edge_loss(bad, "Nek5000")) << "its edges are straight";
  const auto folded = [](Vec3 x) { return Vec3{x.x, x.y, x.z * (1 - 2 * x.x * (2 - x.x))}; };
  try {
    nek_re2(two_hexes({.order = 2, .map = folded}));
    FAIL();
  } catch (const ComputeError& e) {
    EXPECT_NE(std::string(e.what()).find("the hexahedron at (0, 0, 0) is folded"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace quadrille::exports
