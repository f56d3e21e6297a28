#include "refine/align_chords.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../hand_made.hpp"
#include "block/extract_blocks.hpp"

namespace quadrille::refine {
namespace {

struct Aligned {
  BlockLayout layout;
  std::vector<sizing::ArcParameter> parameters;
  double worst_slope = 0;  ///< greatest |tangent . line across| of opposite sides of block 0, 0 = upright

  explicit Aligned(const SeparatrixGraph& graph) {
    Report report;
    layout = block::extract_blocks(graph, report);
    const sizing::MeasuredLayout measured(layout);
    parameters = align_chords(measured);
    for (int k = 1; k < 100; ++k) {
      const double u = k / 100.0;
      const curve::ChainPoint a = measured.chain(0).at(parameters[0].fraction(u));
      const curve::ChainPoint b = measured.chain(2).at(parameters[2].fraction(1 - u));
      worst_slope = std::max(worst_slope, std::abs(dot(a.tangent, normalized(b.position - a.position))));
    }
  }
};

TEST(AlignChords, StraightAndConcentricBlocksKeepEqualFractions) {
  for (const SeparatrixGraph& graph : {hand_made::unit_square(), hand_made::quarter_annulus(), hand_made::l_shape(),
                                       hand_made::cut_annulus(1), hand_made::cut_annulus(3)})
    for (const sizing::ArcParameter& p : Aligned(graph).parameters) EXPECT_TRUE(p.is_identity());
}

TEST(AlignChords, ShearedBlocksKeepEqualFractions) {
  const std::vector<Nurbs> loop{curve::segment({0, 0}, {3, 0}), curve::segment({3, 0}, {4, 1}),
                                curve::segment({4, 1}, {1, 1}), curve::segment({1, 1}, {0, 0})};
  for (const sizing::ArcParameter& p :
       Aligned(hand_made::one_block(hand_made::face({loop}, 4), {{0}, {1}, {2}, {3}})).parameters)
    EXPECT_TRUE(p.is_identity());
}

TEST(AlignChords, LinesAcrossABendStandUpright) {
  const Aligned bend(hand_made::s_bend());
  EXPECT_FALSE(bend.parameters[0].is_identity());
  EXPECT_LT(bend.worst_slope, 0.1);  // 0.72 with equal fractions
}

TEST(AlignChords, HalfTurnSymmetryIsKept) {
  const Aligned bend(hand_made::s_bend());
  for (const double u : {0.1, 0.3, 0.5, 0.9})
    EXPECT_NEAR(bend.parameters[0].fraction(u), bend.parameters[2].fraction(u), 1e-12);
}

}  // namespace
}  // namespace quadrille::refine
