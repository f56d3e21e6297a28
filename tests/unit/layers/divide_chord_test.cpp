#include "layers/divide_chord.hpp"

#include <gtest/gtest.h>

#include "layers/layer_rules.hpp"
#include "sizing/interval_error.hpp"
#include "wall_samples.hpp"

namespace quadrille::layers {
namespace {

using wall_samples::PlannedWalls;

/// The chord along the two arcs of a quarter ring, with nothing prescribed.
struct RingChord {
  explicit RingChord(double tolerance)
      : planned(hand_made::quarter_annulus(), 2, {"side_1:first=0.05,layers=1"}, 2, tolerance),
        sizes(arc_sizes(planned.input)) {
    const std::vector<ArcSpacing> free(planned.layout.arcs.size());
    divide_chord(planned.input, planned.measured.chord_of(outer), free, {}, sizes, planned.divisions);
  }

  PlannedWalls planned;
  int outer = planned.arc_between({2, 0}, {0, 2}), straight = planned.arc_between({1, 0}, {2, 0});
  ArcSizes sizes;
};

TEST(DivideChord, ShortensTheSizesOfArcsThatMissTheTolerance) {
  const RingChord loose(1), tight(1e-4);
  EXPECT_EQ(loose.sizes.scale[loose.outer], 1);
  EXPECT_EQ(loose.planned.divisions[loose.outer].num_intervals(), layer_constants.least_count);
  EXPECT_LT(tight.sizes.scale[tight.outer], 1);
  EXPECT_EQ(tight.sizes.scale[tight.straight], 1) << "another chord";
  const std::vector<double>& ends = tight.planned.divisions[tight.outer].ends;
  EXPECT_GT(ends.size(), 4u);
  for (std::size_t k = 0; k + 1 < ends.size(); ++k)
    EXPECT_LE(sizing::interval_error(tight.planned.measured.curves(), tight.planned.measured.chain(tight.outer),
                                     ends[k], ends[k + 1], 2),
              1e-4);
}

TEST(DivideChord, EndsOfIntervalsMoveOntoBreaksBeforeSizesFall) {
  // Each long side of the elbow is a line and an arc: quadratic intervals meet 5e-3 once one of them ends at the joint.
  PlannedWalls p(hand_made::elbow(), 0.5, {"2:first=0.05,layers=1"}, 2, 5e-3);
  ArcSizes sizes = arc_sizes(p.input);
  const int outer = p.arc_between({0, 0}, {3, 2});
  const std::vector<ArcSpacing> free(p.layout.arcs.size());
  divide_chord(p.input, p.measured.chord_of(outer), free, {}, sizes, p.divisions);
  EXPECT_EQ(sizes.scale[outer], 1);
}

}  // namespace
}  // namespace quadrille::layers
