#include "export/nek_re2.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "export/nek_field.hpp"
#include "nek_numbers.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

using Numbers = std::vector<double>;

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
  EXPECT_EQ(exported.side_files[1].bytes, nek_geometry_field(mesh, plane_frame(mesh.face)));
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

}  // namespace
}  // namespace quadrille::exports
