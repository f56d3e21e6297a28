#include "layers/layered_divisions.hpp"

#include <gtest/gtest.h>

#include "wall_samples.hpp"

namespace quadrille::layers {
namespace {

using wall_samples::PlannedWalls;

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
