#include "sizing/measured_layout.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <utility>

#include "../hand_made.hpp"
#include "block/extract_blocks.hpp"

namespace quadrille::sizing {
namespace {

TEST(ArcParameter, IsTheIdentityByDefault) {
  const ArcParameter p;
  EXPECT_TRUE(p.is_identity());
  for (const double u : {0.0, 0.3, 1.0}) {
    EXPECT_EQ(p.fraction(u), u);
    EXPECT_EQ(p.parameter(u), u);
  }
}

TEST(ArcParameter, PassesThroughItsSamplesAndRises) {
  const ArcParameter p({0, 0.05, 0.1, 0.7, 0.75, 1});
  EXPECT_NEAR(p.fraction(0.4), 0.1, 1e-15);
  EXPECT_NEAR(p.fraction(0.6), 0.7, 1e-15);
  for (int k = 0; k < 1000; ++k) EXPECT_LT(p.fraction(k / 1000.0), p.fraction((k + 1) / 1000.0));
}

TEST(ArcParameter, InverseIsTheInverse) {
  const ArcParameter p({0, 0.2, 0.3, 0.8, 1});
  for (const double u : {0.0, 0.1, 0.25, 0.6, 0.99, 1.0}) EXPECT_NEAR(p.parameter(p.fraction(u)), u, 1e-14);
}

TEST(ArcParameter, MirroredSamplesGiveTheMirroredMap) {
  const ArcParameter p({0, 0.2, 0.3, 0.8, 1}), q({0, 0.2, 0.7, 0.8, 1});
  for (const double u : {0.1, 0.4, 0.77}) EXPECT_NEAR(p.fraction(u), 1 - q.fraction(1 - u), 1e-15);
}

BlockLayout layout_of(const SeparatrixGraph& graph) {
  Report report;
  return block::extract_blocks(graph, report);
}

TEST(MeasuredLayout, MeasuresEveryArcOfTheLayout) {
  const BlockLayout layout = layout_of(hand_made::quarter_annulus());
  const MeasuredLayout measured(layout);
  ASSERT_EQ(measured.num_arcs(), 4);
  EXPECT_NEAR(measured.length(0), 1, 1e-12);
  EXPECT_NEAR(measured.length(1), pi, 1e-10);
  EXPECT_NEAR(measured.length(3), half_pi, 1e-10);
  EXPECT_EQ(&measured.blocks(), &layout);
}

TEST(MeasuredLayout, NumbersChordsAsTheLayoutDoes) {
  for (const SeparatrixGraph& graph : {hand_made::unit_square(), hand_made::l_shape(), hand_made::cut_annulus(3)}) {
    const BlockLayout layout = layout_of(graph);
    const MeasuredLayout measured(layout);
    for (int arc = 0; arc < measured.num_arcs(); ++arc) EXPECT_EQ(measured.chord_of(arc), layout.arc_chord[arc]);
    std::size_t num_arcs = 0;
    for (const mesh::Chord& chord : measured.chords()) num_arcs += chord.arcs.size();
    EXPECT_EQ(num_arcs, layout.arcs.size());
  }
}

TEST(MeasuredLayout, KnowsWhichArcsHaveTheSameEnds) {
  const BlockLayout square = layout_of(hand_made::unit_square()), ring = layout_of(hand_made::cut_annulus(2));
  const MeasuredLayout of_square(square), of_ring(ring);
  for (int arc = 0; arc < of_square.num_arcs(); ++arc) EXPECT_FALSE(of_square.is_parallel(arc));
  for (int arc = 0; arc < of_ring.num_arcs(); ++arc)
    EXPECT_EQ(of_ring.is_parallel(arc), ring.arcs[arc].is_boundary) << "two halves of each circle";
}

TEST(MeasuredLayout, ParametersRunAlongTheChordAndFractionsAlongTheArc) {
  const BlockLayout layout = layout_of(hand_made::unit_square());
  const MeasuredLayout equal(layout);
  EXPECT_TRUE(equal.has_equal_parameters());
  std::vector<ArcParameter> parameters(4);
  parameters[0] = parameters[2] = ArcParameter({0, 0.2, 0.3, 0.8, 1});
  const MeasuredLayout measured = equal.with_parameters(parameters);
  EXPECT_FALSE(measured.has_equal_parameters());
  EXPECT_TRUE(measured.with_parameters(std::vector<ArcParameter>(measured.num_arcs())).has_equal_parameters());
  const mesh::Chord& chord = measured.chords()[measured.chord_of(0)];
  ASSERT_EQ(chord.arcs, (std::vector<int>{0, 2}));
  ASSERT_TRUE(chord.backwards[1]) << "opposite sides of a block run against each other";
  EXPECT_NEAR(measured.arc_fraction(chord, 0, 0.25), 0.2, 1e-12);
  EXPECT_NEAR(measured.arc_fraction(chord, 1, 0.25), 0.8, 1e-12);
  for (const int i : {0, 1})
    for (const double u : {0.0, 0.1, 0.6, 1.0})
      EXPECT_NEAR(measured.chord_parameter(chord, i, measured.arc_fraction(chord, i, u)), u, 1e-12);
}

TEST(MeasuredLayout, CopiesShareTheCurvesAndOutliveTheOriginal) {
  const BlockLayout layout = layout_of(hand_made::quarter_annulus());
  std::optional<MeasuredLayout> original(layout);
  const curve::CurveTable* curves = &original->curves();
  const MeasuredLayout copy = original->with_parameters(std::vector<ArcParameter>(original->num_arcs()));
  original.reset();
  EXPECT_EQ(&copy.curves(), curves);
  EXPECT_NEAR(norm(copy.chain(1).at(0.5).position), 2, 1e-12);
}

/// The joint between a line of length 1 and one of length 3, whose curves have these names; the curves of `unnamed` got
/// theirs from their numbers.
std::vector<double> joints(const std::string& first, const std::string& second, std::vector<int> unnamed = {}) {
  CadFace face = hand_made::face(
      {{curve::segment({0, 0}, {1, 0}), curve::segment({1, 0}, {4, 0}), curve::segment({4, 0}, {0, 0})}}, 4);
  face.curve_names = {first, second, "rest"};
  face.unnamed_curves = std::move(unnamed);
  const std::vector<Nurbs> no_splines;
  const curve::CurveTable table(face, no_splines);
  return name_joints(curve::Chain(table, {{0, 0, 1}, {1, 0, 3}}), face);
}

TEST(NameJoints, LieWhereAGivenNameEnds) {
  for (const std::vector<double>& found : {joints("wall", "inlet"), joints("curve_0", "inlet", {0}),
                                           joints("wall", "curve_1", {1}), joints("curve_0", "curve_1", {1})}) {
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0], 0.25, 1e-12);
  }
}

TEST(NameJoints, OneNameOnBothSidesIsNone) { EXPECT_TRUE(joints("wall", "wall").empty()); }

TEST(NameJoints, NamesThatNobodyGaveAreNone) { EXPECT_TRUE(joints("curve_0", "curve_1_", {0, 1}).empty()); }

}  // namespace
}  // namespace quadrille::sizing
