#include "layers/side_table.hpp"

#include <gtest/gtest.h>

#include "../hand_made.hpp"

namespace quadrille::layers {
namespace {

TEST(SideTable, IsTheChainToRoundOff) {
  const CadFace face = hand_made::elbow().face;  // curves 0 and 1: a line and a quarter circle
  const std::vector<Nurbs> none;
  const curve::CurveTable table(face, none);
  const curve::Chain chain(table, {{0, 0, 1}, {1, face.curves[1].begin(), face.curves[1].end()}});
  const SideTable forwards(chain, false), backwards(chain, true);
  for (int k = 0; k <= 1000; ++k) {
    const double f = k / 1000.0;
    EXPECT_LE(distance(forwards.at(f), chain.at(f).position), 1e-12 * chain.length());
    EXPECT_LE(distance(backwards.at(f), chain.at(1 - f).position), 1e-12 * chain.length());
  }
  EXPECT_EQ(forwards.at(0), chain.at(0).position);
  EXPECT_EQ(forwards.at(1), chain.at(1).position);
}

}  // namespace
}  // namespace quadrille::layers
