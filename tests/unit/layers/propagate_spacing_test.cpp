#include "layers/propagate_spacing.hpp"

#include <gtest/gtest.h>

#include <cmath>

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

using namespace wall_samples;

/// A row of blocks, 1 high, divided into equal intervals; spacings are prescribed by hand.
struct Row {
  explicit Row(const std::vector<double>& widths, double size = 0.25)
      : planned(row(widths), size, {}),
        spacings(planned.layout.arcs.size()),
        sizes(arc_sizes(planned.input)),
        lines(planned.measured.chords().size()),
        divisions(planned.divisions) {}

  void prescribe(Vec2 at, Vec2 to, double before, double growth = 1.2) {
    const int arc = planned.arc_between(at, to);
    const bool is_end = distance(planned.layout.nodes[planned.layout.arcs[arc].from].position, at) > 1e-9;
    spacings[arc][is_end ? 1 : 0] = {{}, before, growth};
  }
  /// Layers from `at`, each 1.2 times as high as the one before it.
  void prescribe_layers(Vec2 at, Vec2 to, double first, int count) {
    prescribe(at, to, first * std::pow(1.2, count - 1));
    const int arc = planned.arc_between(at, to);
    EndSpacing& end = spacings[arc][spacings[arc][0].is_free() ? 1 : 0];
    double sum = 0;
    for (int k = 0; k < count; ++k)
      end.layer_ends.push_back((sum += first * std::pow(1.2, k)) / planned.measured.length(arc));
  }
  std::vector<int> propagate() {
    std::vector<int> divided = propagate_spacing(planned.input, lines, spacings, sizes, divisions);
    planned.divisions = divisions;
    return divided;
  }
  int chord(Vec2 a, Vec2 b) const { return planned.measured.chord_of(planned.arc_between(a, b)); }

  PlannedWalls planned;
  std::vector<ArcSpacing> spacings;
  ArcSizes sizes;
  std::vector<std::vector<FreePart>> lines;
  sizing::ArcDivisions divisions;
};

TEST(PropagateSpacing, WithoutPrescribedEndsNothingIsDivided) {
  Row r({1, 1, 1});
  EXPECT_TRUE(r.propagate().empty());
}

TEST(PropagateSpacing, OnlyTheChordWithAFineEndIsDividedWhereItReachesTheSize) {
  Row r({2, 2}, 0.1);
  r.prescribe({0, 0}, {2, 0}, 0.05);
  r.prescribe({0, 1}, {2, 1}, 0.05);
  EXPECT_EQ(r.propagate(), std::vector<int>{r.chord({0, 0}, {2, 0})});
  EXPECT_LE(r.planned.first_step({0, 0}, {2, 0}), 0.05 * 1.2 * (1 + 1e-6));
  EXPECT_NEAR(r.planned.first_step({2, 0}, {4, 0}), 0.1, 1e-9) << "untouched";
}

TEST(PropagateSpacing, TheNextChordStartsFromTheIntervalThatItContinues) {
  Row r({0.1, 2});
  r.prescribe({0, 0}, {0.1, 0}, 0.01);
  const std::vector<int> divided = r.propagate();
  EXPECT_EQ(divided.size(), 2u);
  EXPECT_TRUE(std::is_sorted(divided.begin(), divided.end()));
  const double last = r.planned.first_step({0.1, 0}, {0, 0}), next = r.planned.first_step({0.1, 0}, {2.1, 0});
  EXPECT_LE(next, 1.3 * last);
  EXPECT_LT(next, 0.1);
}

TEST(PropagateSpacing, TheGrowthIsHandedOn) {
  for (const double growth : {1.15, 1.4}) {
    Row r({0.1, 3});
    r.prescribe({0, 0}, {0.1, 0}, 0.01, growth);
    r.propagate();
    const std::vector<double> ends = r.planned.steps({0.1, 0}, {3.1, 0});
    double greatest = 1;
    for (std::size_t k = 2; k < ends.size(); ++k)
      greatest = std::max(greatest, (ends[k] - ends[k - 1]) / (ends[k - 1] - (k > 1 ? ends[k - 2] : 0)));
    EXPECT_LE(greatest, growth * (1 + 1e-6)) << growth;
    EXPECT_EQ(r.spacings[r.planned.arc_between({0.1, 0}, {3.1, 0})][0].growth +
                  r.spacings[r.planned.arc_between({0.1, 0}, {3.1, 0})][1].growth,
              growth);
  }
}

TEST(PropagateSpacing, IntervalsFarFinerThanPrescribedAreNotHandedOn) {
  // The first chord has many more intervals than its arc of 0.1 needs.
  Row r({0.1, 2});
  r.prescribe({0, 0}, {0.1, 0}, 0.01);
  r.lines[r.chord({0, 0}, {0.1, 0})] = {{{0.001, 0.001}, 1, 0.1, 0}};
  r.propagate();
  EXPECT_LT(r.planned.first_step({0.1, 0}, {0, 0}), 0.004);
  EXPECT_NEAR(r.planned.first_step({0.1, 0}, {2.1, 0}), 0.005, 0.001);
}

TEST(PropagateSpacing, LayersAreContinuedFromTheFirstAtTheNodeWhereTheyBegin) {
  // As beyond a concave corner: the last layer, 0.0089, is far from there.
  Row r({1, 2});
  r.prescribe_layers({1, 0}, {0, 0}, 0.001, 13);
  r.prescribe_layers({1, 1}, {0, 1}, 0.001, 13);
  r.propagate();
  EXPECT_NEAR(r.planned.first_step({1, 0}, {0, 0}), 0.001, 1e-9);
  EXPECT_LE(r.planned.first_step({1, 0}, {3, 0}), 0.001 * 1.2 * (1 + 1e-6));
  EXPECT_GE(r.planned.first_step({1, 0}, {3, 0}), 0.001 * 0.8);
}

TEST(PropagateSpacing, HalfOfTheFirstLayerIsTheFinestThatIsHandedOn) {
  // The first chord has many more intervals between its layers and its end than its arc of 0.1 needs.
  Row r({0.1, 2});
  r.prescribe_layers({0, 0}, {0.1, 0}, 0.004, 4);
  r.lines[r.chord({0, 0}, {0.1, 0})] = {{{0.0007, 0.0007}, 1, 0.1, 0}};
  r.propagate();
  EXPECT_LT(r.planned.first_step({0.1, 0}, {0, 0}), 0.0019);
  EXPECT_NEAR(r.planned.first_step({0.1, 0}, {2.1, 0}), 0.002, 0.0004) << "half of the last layer is 0.0035";
}

TEST(PropagateSpacing, ASymmetricRowIsDividedSymmetrically) {
  Row r({2, 0.2, 2});
  r.prescribe({2, 0}, {2.2, 0}, 0.02);
  r.prescribe({2.2, 0}, {2, 0}, 0.02);
  EXPECT_EQ(r.propagate().size(), 3u);
  const std::vector<double> left = r.planned.steps({2, 0}, {0, 0}), right = r.planned.steps({2.2, 0}, {4.2, 0});
  ASSERT_EQ(left.size(), right.size());
  for (std::size_t k = 0; k < left.size(); ++k) EXPECT_NEAR(left[k], right[k], 1e-9);
}

}  // namespace
}  // namespace quadrille::layers
