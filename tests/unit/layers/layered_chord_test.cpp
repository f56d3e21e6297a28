#include "layers/layered_chord.hpp"

#include <gtest/gtest.h>

#include "wall_samples.hpp"

namespace quadrille::layers {
namespace {

TEST(LayeredChord, SeesAllArcsInTheChordsDirection) {
  const wall_samples::PlannedWalls p(hand_made::cut_annulus(3), 0.3, {"side_1:first=0.01,layers=2"});
  std::vector<ArcSpacing> spacings(p.layout.arcs.size());
  for (std::size_t arc = 0; arc < spacings.size(); ++arc)
    for (const int end : {0, 1}) {
      const int node = end == 0 ? p.layout.arcs[arc].from : p.layout.arcs[arc].to;
      if (norm(p.layout.nodes[node].position) < 0.6) spacings[arc][end] = {{0.1}, 0.05, 1.2};  // at the inner circle
    }
  const LayeredChord chord(p.input, p.measured.chord_of(p.arc_between({1, 0}, {0.5, 0})), spacings, arc_sizes(p.input));
  ASSERT_EQ(chord.num_arcs(), 3);
  const int inner = chord.at_end(0, 0).layers() > 0 ? 0 : 1;
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(chord.at_end(i, inner).layers(), 1);
    EXPECT_TRUE(chord.at_end(i, 1 - inner).is_free());
    EXPECT_NEAR(chord.fraction(i, chord.parameter(i, 0.3)), 0.3, 1e-12);
    EXPECT_EQ(chord.own_step(i, chord.own_step(i, 2, 7), 7), 2);
  }
  EXPECT_EQ(chord.growth(), 1.2);
  EXPECT_EQ(chord.opposite_arcs().size(), 3u);
}

TEST(LayeredChord, OppositeArcsAreAsFarApartAsTheirBlockIsLong) {
  const wall_samples::PlannedWalls p(wall_samples::row({1, 3}), 0.3, {"side_0:first=0.01,layers=2"});
  const std::vector<ArcSpacing> free(p.layout.arcs.size());
  const LayeredChord chord(p.input, p.measured.chord_of(p.arc_between({0, 0}, {0, 1})), free, arc_sizes(p.input));
  ASSERT_EQ(chord.opposite_arcs().size(), 2u);
  EXPECT_NEAR(chord.opposite_arcs()[0].distance, 1, 1e-12);
  EXPECT_NEAR(chord.opposite_arcs()[1].distance, 3, 1e-12);
  EXPECT_EQ(chord.growth(), 0);
}

}  // namespace
}  // namespace quadrille::layers
