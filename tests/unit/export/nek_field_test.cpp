#include "export/nek_field.hpp"

#include <gtest/gtest.h>

#include "nek_numbers.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

using Numbers = std::vector<double>;

TEST(NekField, TwoQuadsByteByByte) {
  const QuadMesh mesh = two_quads();
  const std::string bytes = nek_geometry_field(mesh, plane_frame(mesh.face));
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
  const std::string bytes = nek_geometry_field(mesh, plane_frame(mesh.face));
  EXPECT_EQ(numbers(bytes, 144, 3), (Numbers{100, 101, 102}));
  EXPECT_EQ(numbers(bytes, 144 + 72, 3), (Numbers{200, 200, 200}));
}

TEST(NekField, TheHeaderCountsPointsAndElements) {
  const QuadMesh mesh = two_straight_quads();
  const std::string bytes = nek_geometry_field(mesh, plane_frame(mesh.face));
  EXPECT_EQ(bytes.substr(0, 13), "#std 8  2  2 ");
  EXPECT_EQ(bytes.size(), 132u + 4 + 2 * 4 + 2 * 2 * 4 * 8);
}

}  // namespace
}  // namespace quadrille::exports
