#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "../hand_made.hpp"
#include "../support/refined.hpp"
#include "base/error.hpp"
#include "export/writers.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {

namespace {

using Numbers = std::vector<double>;

const std::string mark = "\xFA\x61\xD1\x40";  ///< 6.54321 in single precision

/// Little-endian doubles, put together byte by byte.
std::vector<double> numbers(const std::string& bytes, std::size_t at, std::size_t count) {
  std::vector<double> found;
  for (std::size_t n = 0; n < count; ++n) {
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < 8; ++k)
      bits |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes.at(at + 8 * n + k))) << (8 * k);
    double number = 0;
    std::memcpy(&number, &bits, 8);
    found.push_back(number);
  }
  return found;
}

TEST(NekRe2, TwoQuadsByteByByte) {
  const QuadMesh mesh = two_quads();
  const std::string bytes = nek_re2(mesh, plane_frame(mesh.face)).bytes;
  ASSERT_EQ(bytes.size(), 84u + 2 * 72 + 8 + 64 + 8 + 6 * 64);
  EXPECT_EQ(bytes.substr(0, 80), "#v004               2  2               2   1 hdr" + std::string(32, ' '));
  EXPECT_EQ(bytes.substr(80, 4), mark);
  EXPECT_EQ(numbers(bytes, 84, 9), (Numbers{0, 0, 2, 2, 0, 0, 0, 2, 2}));
  EXPECT_EQ(bytes.substr(100, 8), std::string("\0\0\0\0\0\0\0\x40", 8));  // 2.0
  EXPECT_EQ(numbers(bytes, 156, 9), (Numbers{0, 2, 4, 4, 2, 0, 0, 2, 2}));
  EXPECT_EQ(numbers(bytes, 228, 1), (Numbers{1}));
  EXPECT_EQ(numbers(bytes, 236, 7), (Numbers{2, 3, 3, 2.5, 0, 0, 0}));
  EXPECT_EQ(bytes.substr(292, 8), "m       ");
  EXPECT_EQ(numbers(bytes, 300, 1), (Numbers{6}));
  const std::vector<Numbers> sides{{1, 1, 1}, {1, 3, 1}, {1, 4, 3}, {2, 1, 1}, {2, 2, 2}, {2, 3, 1}};
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_EQ(numbers(bytes, 308 + 64 * k, 7), (Numbers{sides[k][0], sides[k][1], 0, 0, 0, 0, sides[k][2]}));
    EXPECT_EQ(bytes.substr(364 + 64 * k, 8), "MSH     ");
  }
}

TEST(NekRe2, TableNamesTheNumbers) {
  const QuadMesh mesh = two_quads();
  const Exported exported = nek_re2(mesh, plane_frame(mesh.face));
  EXPECT_TRUE(exported.is_binary);
  ASSERT_EQ(exported.side_files.size(), 2u);
  EXPECT_NE(exported.side_files[0].bytes.find("{\"id\": 2, \"name\": \"in & out\"}"), std::string::npos);
  EXPECT_EQ(exported.side_files[1].name.ending, "0.f00000");
}

TEST(NekRe2, OrderOneNeedsNoField) {
  const QuadMesh mesh = two_straight_quads();
  const Exported exported = nek_re2(mesh, plane_frame(mesh.face));
  EXPECT_EQ(exported.side_files.size(), 1u);
  EXPECT_EQ(exported.bytes.size(), 84u + 2 * 72 + 8 + 8 + 6 * 64);
}

TEST(NekRe2, RefusesEdgesThatNek5000CannotTellApart) {
  const QuadMesh mesh = ring_of_two_quads();
  EXPECT_THROW(nek_re2(mesh, plane_frame(mesh.face)), ComputeError);
}

std::string geometry_field(const QuadMesh& mesh) {
  return nek_re2(mesh, plane_frame(mesh.face)).side_files.at(1).bytes;
}

TEST(NekField, TwoQuadsByteByByte) {
  const QuadMesh mesh = two_quads();
  const std::string bytes = geometry_field(mesh);
  ASSERT_EQ(bytes.size(), 132u + 4 + 2 * 4 + 2 * 2 * 9 * 8);
  EXPECT_EQ(bytes.substr(0, 132),
            "#std 8  3  3  1          2          2  0.0000000000000E+00         0      0      1 X           "
            "1.0000000E+00 F" +
                std::string(132 - 110, ' '));
  EXPECT_EQ(bytes.substr(132, 4), mark);
  EXPECT_EQ(bytes.substr(136, 8), std::string("\1\0\0\0\2\0\0\0", 8));
  EXPECT_EQ(numbers(bytes, 144, 9), (Numbers{0, 1, 2, 0, 1, 2, 0, 1, 2}));
  EXPECT_EQ(numbers(bytes, 144 + 72, 9), (Numbers{0, 0, 0, 1, 1, 1, 2, 2, 2}));
  EXPECT_EQ(numbers(bytes, 144 + 3 * 72, 9), (Numbers{0, 0, 0, 1, 1.25, 1, 2, 2.5, 2}));
}

TEST(NekField, PositionsLieInTheFrameWithTheOriginAdded) {
  QuadMesh mesh = two_quads();
  mesh.face.origin = {100, 200};
  const std::string bytes = geometry_field(mesh);
  EXPECT_EQ(numbers(bytes, 144, 3), (Numbers{100, 101, 102}));
  EXPECT_EQ(numbers(bytes, 144 + 72, 3), (Numbers{200, 200, 200}));
}

TEST(NekField, TheHeaderCountsPointsAndElements) {
  const QuadMesh mesh = refined(hand_made::unit_square(), {0.5, 3, 5e-7});
  const std::string bytes = geometry_field(mesh);
  EXPECT_EQ(bytes.substr(0, 37), "#std 8  4  4  1          4          4");
  EXPECT_EQ(bytes.size(), 132u + 4 + 4 * 4 + 4 * 2 * 16 * 8);
}

}  // namespace

}  // namespace quadrille::exports
