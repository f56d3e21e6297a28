#include "layers/layered_divisions.hpp"

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

using wall_samples::PlannedWalls;
using wall_samples::row;

/// The upright arcs of a row of blocks with a wall under the first one: positions 0 and 1 have its layers.
struct AlignedChord {
  explicit AlignedChord(const std::vector<double>& widths)
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
    const AlignedChord upright({width});
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
    AlignedChord upright({0.5});
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
  const AlignedChord upright({0.3, 0.2});
  const LayeredChord chord = upright.chord();
  sizing::ArcDivisions ends = divisions(std::vector<std::vector<double>>(3, {0, 0.25, 0.5, 0.75, 1}));
  align_divisions(chord, ends);
  for (const sizing::ArcDivision& division : ends)
    for (int k = 0; k <= 4; ++k) EXPECT_NEAR(division.ends[k], k / 4.0, 1e-12);
}

TEST(AlignDivisions, DoesNotMixArcsWithDifferentLayers) {
  AlignedChord upright({0.05});
  const int layered = upright.planned.measured.chords()[upright.number()].arcs[0];
  upright.spacings[layered][0] = {{0.2}, 0.2, 1.2};
  const LayeredChord chord = upright.chord();
  const auto before = divisions({{0, 0.2, 0.5, 1}, {0, 0.3, 0.6, 1}});
  sizing::ArcDivisions ends = before;
  align_divisions(chord, ends);
  for (const int i : {0, 1})
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(ends[i].ends[k], before[i].ends[k], 1e-12);
}

/// The upright chord of a row of blocks, with nothing prescribed.
struct UprightChord {
  UprightChord(const std::vector<double>& widths, double size)
      : planned(wall_samples::row(widths), size, {"side_0:first=0.01,layers=1"}),
        spacings(planned.layout.arcs.size()) {}

  int count(const std::vector<FreePart>& lines, int least_count) const {
    const int number = planned.measured.chord_of(planned.arc_between({0, 0}, {0, 1}));
    return layered_divisions({planned.input, number, spacings, arc_sizes(planned.input)}, lines, least_count)
        .front()
        .num_intervals();
  }
  EndSpacing& at(Vec2 foot) {
    const int arc = planned.arc_between(foot, foot + Vec2{0, 1});
    return spacings[arc][distance(planned.layout.nodes[planned.layout.arcs[arc].from].position, foot) < 1e-9 ? 0 : 1];
  }

  PlannedWalls planned;
  std::vector<ArcSpacing> spacings;
};

TEST(LayeredDivisions, FreeArcsMayExceedTheSizeByAQuarter) {
  EXPECT_EQ(UprightChord({1}, 1.0 / 5).count({}, 1), 4);
  EXPECT_EQ(UprightChord({1}, 1.0 / 5).count({}, 6), 6) << "the least count";
}

TEST(LayeredDivisions, TheCountSuitsEveryArcAndLine) {
  UprightChord chord({1, 1}, 0.2);
  const int free = chord.count({}, 1);
  const int with_line = chord.count({{{0.01, 0}, 1, 0.2, 3}}, 1);
  EXPECT_GT(with_line, free + 3);
  chord.at({1, 0}) = {{}, 0.01, 1.2};
  EXPECT_GT(chord.count({}, 1), free);
}

TEST(LayeredDivisions, WithoutLayersThePrescribedEndsAreSources) {
  // Nothing but the middle arc is prescribed; both neighbours start like it.
  UprightChord chord({0.05, 0.05}, 0.2);
  chord.at({0.05, 0}) = {{}, 0.01, 1.2};
  const int number = chord.planned.measured.chord_of(chord.planned.arc_between({0, 0}, {0, 1}));
  const LayeredChord layered{chord.planned.input, number, chord.spacings, arc_sizes(chord.planned.input)};
  const std::vector<sizing::ArcDivision> divisions = layered_divisions(layered, {}, 1);
  for (int i = 0; i < layered.num_arcs(); ++i) {
    const std::vector<double>& ends = divisions[i].ends;
    EXPECT_LT(std::min(ends[1], 1 - ends[ends.size() - 2]), 0.03) << i;
  }
}

// Rule 16 of layer_rules: the arc beyond the layers keeps their division but for a slope of 0.2.
TEST(LayeredDivisions, ReturnToTheFreeDivisionWithTheSlope) {
  UprightChord chord({1, 0.5}, 0.2);
  for (const double x : {0.0, 1.0}) chord.at({x, 0}) = {{0.005, 0.01}, 0.005, 1.2};
  const int number = chord.planned.measured.chord_of(chord.planned.arc_between({0, 0}, {0, 1}));
  const LayeredChord layered{chord.planned.input, number, chord.spacings, arc_sizes(chord.planned.input)};
  const std::vector<sizing::ArcDivision> divisions = layered_divisions(layered, {}, 1);
  const int count = divisions[0].num_intervals();
  const std::vector<double> kept = spaced_ends({{{{}, 0.005 / 1.2, 1.2}, {}}}, 1, 0.2, count);
  const int beyond = chord.planned.arc_between({1.5, 0}, {1.5, 1});
  const mesh::Chord& arcs = chord.planned.measured.chords()[number];
  const auto i = std::find(arcs.arcs.begin(), arcs.arcs.end(), beyond) - arcs.arcs.begin();
  const bool is_upwards = chord.planned.layout.nodes[chord.planned.layout.arcs[beyond].from].position.y < 0.5;
  double greatest = 0;
  for (int k = 0; k <= count; ++k) {
    const double y = is_upwards ? divisions[i].ends[k] : 1 - divisions[i].ends[count - k];
    greatest = std::max(greatest, std::abs(y - kept[k]));
  }
  EXPECT_NEAR(greatest, 0.2 * 0.5, 1e-12);
}

}  // namespace
}  // namespace quadrille::layers
