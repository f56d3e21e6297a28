#include "guide/tie_measures.hpp"

#include <gtest/gtest.h>

#include "../hand_made.hpp"

namespace quadrille::guide {
namespace {

TEST(TieMeasures, TheAngleDefectIsZeroForBlocksOfRightAngles) {
  for (int valence = 1; valence <= 4; ++valence) EXPECT_NEAR(angle_defect(valence * half_pi, valence), 0, 1e-15);
  EXPECT_NEAR(angle_defect(radians(135), 1), 0.25, 1e-15);
  EXPECT_NEAR(angle_defect(radians(135), 2), 0.125, 1e-15) << "the larger valence is the better one at a tie";
}

TEST(TieMeasures, ASideIsMeasuredBetweenItsEnds) {
  const CadFace face = hand_made::quarter_annulus(1, 2).face;
  EXPECT_NEAR(side_length(face, 0), 1, 1e-15);
  EXPECT_NEAR(side_length(face, 1), 2 * std::sqrt(2.0), 1e-14) << "the chord of the arc";
  EXPECT_NEAR(side_length(face, 3), std::sqrt(2.0), 1e-14) << "the last curve ends where the first one starts";
}

}  // namespace
}  // namespace quadrille::guide
