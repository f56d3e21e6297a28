#include "layers/align_divisions.hpp"

#include <gtest/gtest.h>

#include "wall_samples.hpp"

namespace quadrille::layers {
namespace {

using wall_samples::PlannedWalls;
using wall_samples::row;

/// The upright arcs of a row of blocks with a wall under the first one: positions 0 and 1 have its layers.
struct UprightChord {
  explicit UprightChord(const std::vector<double>& widths)
      : planned(row(widths), 0.3, {"side_0:first=0.05,law=uniform,layers=2"}), spacings(planned.layout.arcs.size()) {}

  int number() const { return planned.measured.chord_of(planned.arc_between({0, 0}, {0, 1})); }
  LayeredChord chord() const { return {planned.input, number(), spacings, arc_sizes(planned.input)}; }

  PlannedWalls planned;
  std::vector<ArcSpacing> spacings;
};

sizing::ArcDivisions divisions(const std::vector<std::vector<double>>& ends) {
  sizing::ArcDivisions result;
  for (const std::vector<double>& e : ends) result.push_back({e});
  return result;
}

TEST(AlignDivisions, DrawsNarrowBlocksTogetherAndLeavesWideOnes) {
  for (const auto& [width, least_gap, greatest_gap] :
       {std::tuple{0.05, 0.0, 0.001}, {0.5, 0.05, 0.15}, {5.0, 0.1999, 0.2}}) {
    const UprightChord upright({width});
    const LayeredChord chord = upright.chord();
    ASSERT_EQ(chord.num_arcs(), 2);
    sizing::ArcDivisions ends = divisions({{0, 0.4, 1}, {0, 0.6, 1}});
    for (const int i : {0, 1})
      if (chord.own_step(i, 0, 3) != 0) ends[i].ends[1] = 1 - ends[i].ends[1];
    align_divisions(chord, ends);
    const double gap = std::abs(chord.parameter(1, ends[1].ends[1]) - chord.parameter(0, ends[0].ends[1]));
    EXPECT_GE(gap, least_gap) << width;
    EXPECT_LE(gap, greatest_gap) << width;
  }
}

// Two opposite arcs a length apart: the gap between their divisions falls by 1 / (1 + 2 w).
TEST(AlignDivisions, WeighsLayeredArcsAsIfTwiceAsFarApart) {
  const auto gap = [](bool is_layered) {
    UprightChord upright({0.5});
    const mesh::Chord& arcs = upright.planned.measured.chords()[upright.number()];
    for (int i = 0; i < 2; ++i)
      if (is_layered) upright.spacings[arcs.arcs[i]][arcs.backwards[i] ? 1 : 0] = {{0.2}, 0.2, 1.2};
    const LayeredChord chord = upright.chord();
    sizing::ArcDivisions ends = divisions({{0, 0.2, 0.5, 1}, {0, 0.2, 0.7, 1}});
    for (const int i : {0, 1})
      if (arcs.backwards[i]) {
        for (double& f : ends[i].ends) f = 1 - f;
        std::reverse(ends[i].ends.begin(), ends[i].ends.end());
      }
    align_divisions(chord, ends);
    const auto at = [&](int i) { return chord.parameter(i, ends[i].ends[chord.own_step(i, 2, 4)]); };
    return at(1) - at(0);
  };
  EXPECT_NEAR(gap(false), 0.2 / (1 + 2 * 1.0), 1e-12);
  EXPECT_NEAR(gap(true), 0.2 / (1 + 2 / 16.0), 1e-12);
}

TEST(AlignDivisions, KeepsEqualDivisionsAndEnds) {
  const UprightChord upright({0.3, 0.2});
  const LayeredChord chord = upright.chord();
  sizing::ArcDivisions ends = divisions(std::vector<std::vector<double>>(3, {0, 0.25, 0.5, 0.75, 1}));
  align_divisions(chord, ends);
  for (const sizing::ArcDivision& division : ends)
    for (int k = 0; k <= 4; ++k) EXPECT_NEAR(division.ends[k], k / 4.0, 1e-12);
}

TEST(AlignDivisions, DoesNotMixArcsWithDifferentLayers) {
  UprightChord upright({0.05});
  const int layered = upright.planned.measured.chords()[upright.number()].arcs[0];
  upright.spacings[layered][0] = {{0.2}, 0.2, 1.2};
  const LayeredChord chord = upright.chord();
  const auto before = divisions({{0, 0.2, 0.5, 1}, {0, 0.3, 0.6, 1}});
  sizing::ArcDivisions ends = before;
  align_divisions(chord, ends);
  for (const int i : {0, 1})
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(ends[i].ends[k], before[i].ends[k], 1e-12);
}

}  // namespace
}  // namespace quadrille::layers
