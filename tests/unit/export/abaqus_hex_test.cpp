#include <gtest/gtest.h>

#include "export/writers.hpp"
#include "two_hexes.hpp"

namespace quadrille::exports {
namespace {

TEST(AbaqusHex, OrderOneInFull) {
  const Exported exported = abaqus_c3d(two_hexes({.order = 1}));
  EXPECT_EQ(exported.bytes, R"(*HEADING
hexahedra of order 1
*NODE, NSET=NALL
1, 0, 0, 0
2, 2, 0, 0
3, 4, 0, 0
4, 0, 2, 0
5, 2, 2, 0
6, 4, 2, 0
7, 0, 0, 1
8, 2, 0, 1
9, 4, 0, 1
10, 0, 2, 1
11, 2, 2, 1
12, 4, 2, 1
*ELEMENT, TYPE=C3D8, ELSET=fluid
1, 1, 2, 5, 4, 7, 8, 11, 10
*ELEMENT, TYPE=C3D8, ELSET=solid
2, 2, 3, 6, 5, 8, 9, 12, 11
*ELSET, ELSET=EALL
fluid
solid
*NSET, NSET=wall
1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12
*SURFACE, NAME=wall, TYPE=ELEMENT
1, S3
1, S5
1, S6
2, S3
2, S5
*NSET, NSET=outlet
3, 6, 9, 12
*SURFACE, NAME=outlet, TYPE=ELEMENT
2, S4
*NSET, NSET=bottom
1, 2, 3, 4, 5, 6
*SURFACE, NAME=bottom, TYPE=ELEMENT
1, S1
2, S1
*NSET, NSET=top
7, 8, 9, 10, 11, 12
*SURFACE, NAME=top, TYPE=ELEMENT
1, S2
2, S2
*NSET, NSET=between
2, 5, 8, 11
*SURFACE, NAME=between, TYPE=ELEMENT
1, S4
)");
  EXPECT_TRUE(exported.losses.empty());
}

TEST(AbaqusHex, OrderTwoHasMiddlesOfEdgesAlone) {
  const Exported exported = abaqus_c3d(two_hexes({.order = 2, .map = bent}));
  EXPECT_NE(exported.bytes.find("*ELEMENT, TYPE=C3D20, ELSET=solid\n2, "), std::string::npos);
  EXPECT_NE(exported.bytes.find("\n32, "), std::string::npos);  // 12 corners, 20 edges
  EXPECT_EQ(exported.bytes.find("\n33, "), std::string::npos);
  ASSERT_EQ(exported.losses.size(), 1u);
  EXPECT_NE(exported.losses[0].find("nodes on faces and inside elements are not stored"), std::string::npos);
}

}  // namespace
}  // namespace quadrille::exports
