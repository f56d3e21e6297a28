// One test for each rule of layers/layer_rules.hpp, by its number, and for pairs of rules that meet.
#include "layers/layer_rules.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <string>
#include <tuple>

#include "../support/texts.hpp"
#include "base/error.hpp"
#include "layers/layer_fit.hpp"
#include "layers/propagate_spacing.hpp"
#include "layers/wall_spec.hpp"
#include "line_samples.hpp"
#include "mesh/chords.hpp"
#include "sizing/interval_error.hpp"

namespace quadrille::layers {
namespace {

using namespace wall_samples;
using Names = std::vector<std::string>;

double thickness(const PlannedWalls& p, int spec) { return p.plan.heights[spec].back(); }

// ---- Which layers a side gets

TEST(LayerRules, R1_ACurveNamedTwiceOrAnUnknownNameIsAUsageError) {
  const SeparatrixGraph square = hand_made::unit_square();
  for (const Names& walls : {Names{"side_0:first=0.1,layers=1", "side_0:first=0.2,layers=1"},
                             Names{"side_0,side_0:first=0.1,layers=1"}, Names{"roof:first=0.1,layers=1"}})
    EXPECT_THROW(PlannedWalls(square, 0.2, walls), UsageError) << walls.front();
}

TEST(LayerRules, R2_ASideThatPartlyFollowsAWallHasTheLayersInFull) {
  // Curve 0 is the first third of the elbow's outer side.
  const PlannedWalls p(hand_made::elbow(), 0.3, {"0:first=0.01,layers=4"});
  ASSERT_EQ(p.plan.walls.sides.size(), 1u);
  EXPECT_NEAR(p.first_step({0, 0}, {0, 1}), 0.01, 1e-12);
  EXPECT_NEAR(p.first_step({3, 2}, {2, 2}), 0.01, 1e-9);
}

struct FinestCase {
  double first0, first1;
  int used;
};

TEST(LayerRules, R3_SidesThatContinueEachOtherHaveTheFinestLayers) {
  for (const auto& [first0, first1, used] :
       {FinestCase{0.01, 0.02, 0}, {0.02, 0.01, 1}, {0.01, 0.01 * (1 - 1e-8), 0}}) {
    const Names walls{"side_0:first=" + std::to_string(first0) + ",layers=3",
                      "side_1:first=" + std::to_string(first1) + ",layers=4"};
    const PlannedWalls p(row({1, 1}), 0.2, walls);
    EXPECT_EQ(p.spec_at(0, 0), used);
    EXPECT_EQ(p.spec_at(1, 0), used);
    EXPECT_EQ(p.plan.walls.overruled, (std::vector<std::array<int, 2>>{{1 - used, used}}));
    EXPECT_EQ(p.warnings(), Names{"W-WAL-002"});
    EXPECT_NEAR(p.first_step({2, 0}, {2, 1}), std::min(first0, first1), 1e-9);
  }
}

TEST(LayerRules, R3_OneSideAlongTwoSpecsHasTheFinest) {
  for (const int finer : {0, 1}) {
    Names walls{"0:first=0.02,layers=3", "1:first=0.02,layers=3"};
    walls[finer].replace(walls[finer].find("0.02"), 4, "0.01");
    const PlannedWalls p(hand_made::elbow(), 0.3, walls);
    ASSERT_EQ(p.plan.walls.sides.size(), 1u);
    EXPECT_EQ(p.plan.walls.sides[0].spec, finer);
    EXPECT_EQ(p.warnings(), Names{"W-WAL-002"});
  }
}

TEST(LayerRules, R3WithR10_AnOverruledSpecNeedsNoClearance) {
  // 60 layers of 0.02 are thicker than the row; they are overruled by the finer ones.
  const PlannedWalls p(row({1, 1}), 0.2, {"side_0:first=0.02,law=uniform,layers=60", "side_1:first=0.01,layers=3"});
  EXPECT_EQ(p.plan.heights[1].size(), 3u);
  EXPECT_NEAR(p.first_step({0, 0}, {0, 1}), 0.01, 1e-12);
}

TEST(LayerRules, R4_WallsThatMeetInACornerKeepTheirOwnLayers) {
  const PlannedWalls convex(hand_made::unit_square(), 0.2,
                            {"side_0:first=0.01,layers=3", "side_1:first=0.02,layers=4"});
  EXPECT_EQ(convex.spec_at(0, 0), 0);
  EXPECT_EQ(convex.spec_at(0, 1), 1);
  EXPECT_TRUE(convex.warnings().empty());
  const PlannedWalls reflex(hand_made::l_shape(), 0.3, {"side_2:first=0.01,layers=3", "side_3:first=0.02,layers=4"});
  ASSERT_EQ(reflex.plan.walls.sides.size(), 2u);
  EXPECT_NE(reflex.plan.walls.sides[0].spec, reflex.plan.walls.sides[1].spec);
  EXPECT_TRUE(reflex.plan.walls.overruled.empty());
}

TEST(LayerRules, R4_AWallEndsAtACornerWithASideThatIsNone) {
  const PlannedWalls convex(hand_made::unit_square(), 0.2, {"side_0:first=0.01,layers=3"});
  for (const double x : {0.0, 1.0}) EXPECT_NEAR(convex.first_step({x, 0}, {x, 1}), 0.01, 1e-12);
  EXPECT_GT(convex.first_step({1, 0}, {0, 0}), 0.1);
  EXPECT_GT(convex.first_step({0, 1}, {0, 0}), 0.1);
}

TEST(LayerRules, R4WithR19_BeyondAReflexCornerTheOtherSideContinuesTheLayers) {
  const PlannedWalls p(hand_made::l_shape(), 0.3, {"side_2:first=0.01,law=uniform,layers=3"});
  EXPECT_NEAR(p.first_step({1, 1}, {1, 0}), 0.01, 1e-12);
  EXPECT_LT(p.first_step({1, 1}, {1, 2}), 0.015) << "the prescribed size is 0.3";
  EXPECT_GT(p.first_step({1, 1}, {1, 2}), 0.0099);
}

TEST(LayerRules, R4WithR19_BeyondAReflexCornerTheFirstLayerIsContinuedNotTheLast) {
  const PlannedWalls p(hand_made::l_shape(), 0.3, {"side_2:first=0.01,growth=1.3,layers=8"});
  EXPECT_NEAR(p.first_step({1, 1}, {1, 0}), 0.01, 1e-12);
  EXPECT_LT(p.first_step({1, 1}, {1, 2}), 0.015) << "the last layer is 0.063 high, half of it 0.031";
}

TEST(LayerRules, R5_ClosedWallsHaveLayersAllAround) {
  for (const int cuts : {1, 2, 4}) {
    const PlannedWalls p(hand_made::cut_annulus(cuts), 0.2, {"side_1:first=0.01,layers=5"});
    EXPECT_EQ(p.plan.walls.sides.size(), static_cast<std::size_t>(cuts));
    for (int k = 0; k < cuts; ++k) {
      const Vec2 d = unit(2 * pi * k / cuts);
      EXPECT_NEAR(p.first_step(0.5 * d, d), 0.01, 1e-9);
    }
  }
}

TEST(LayerRules, R5WithR3_AClosedWallOfTwoSpecsHasTheFinest) {
  for (const int finer : {0, 1}) {
    Names walls{"side_1:first=0.02,layers=3", "side_2:first=0.02,layers=3"};
    walls[finer].replace(walls[finer].find("0.02"), 4, "0.01");
    const PlannedWalls p(annulus_of_half_circles(), 0.2, walls);
    ASSERT_EQ(p.plan.walls.sides.size(), 2u);
    for (const WallSide& side : p.plan.walls.sides) EXPECT_EQ(side.spec, finer);
    EXPECT_EQ(p.warnings(), Names{"W-WAL-002"});
  }
}

// ---- Distances (rule 7: wall_line_test; rule 9: divide_normal_line_test)

TEST(LayerRules, R6_HeightsAreMeasuredFromTheContinuingBoundaryToo) {
  const PlannedWalls p(row({1, 1, 1}), 0.3, {"side_1:first=0.01,layers=3"});
  ASSERT_EQ(p.plan.walls.sides.size(), 1u);
  const WallSide& wall = p.plan.walls.sides[0];
  EXPECT_EQ(wall.line.pieces().size(), 3u);
  EXPECT_EQ(wall.begin.piece, 1);
  EXPECT_EQ(wall.end.piece, 1);
  // At a corner with V = 1 the wall ends.
  const PlannedWalls corner(row({1, 1}), 0.3, {"side_0:first=0.01,layers=3"});
  EXPECT_EQ(corner.plan.walls.sides[0].line.pieces().size(), 2u);
  EXPECT_EQ(corner.plan.walls.sides[0].begin.piece, 0);
}

/// A quadrilateral with corners at (0, 0) and (1, 0), where the other side leads to (2, height).
SeparatrixGraph quadrilateral(double height) {
  return hand_made::one_block(hand_made::face({{curve::segment({0, 0}, {1, 0}), curve::segment({1, 0}, {2, height}),
                                                curve::segment({2, height}, {0, 2}), curve::segment({0, 2}, {0, 0})}},
                                              2),
                              {{0}, {1}, {2}, {3}});
}

TEST(LayerRules, R6_BeyondAnObtuseCornerHeightsAreMeasuredFromTheStraightContinuation) {
  const PlannedWalls obtuse(quadrilateral(1), 0.2, {"side_0:first=0.01,layers=3"});  // 135 degrees
  EXPECT_NEAR(obtuse.first_step({1, 0}, {2, 1}), 0.01 * std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(obtuse.first_step({0, 0}, {0, 2}), 0.01, 1e-9);
  const PlannedWalls other(quadrilateral(1), 0.2, {"side_1:first=0.01,layers=3"});
  EXPECT_NEAR(other.first_step({1, 0}, {0, 0}), 0.01 * std::sqrt(2.0), 1e-9);
  const PlannedWalls flat(quadrilateral(0.3), 0.2, {"side_0:first=0.01,layers=3"});  // 163 degrees
  EXPECT_NEAR(flat.first_step({1, 0}, {2, 0.3}), 0.01, 1e-9) << "distances from the corner";
}

TEST(LayerRules, R8_EachWallOfACornerCarriesTheCutsOfTheOther) {
  const PlannedWalls p(hand_made::unit_square(), 0.2, {"side_0:first=0.01,layers=3", "side_1:first=0.02,layers=4"});
  EXPECT_NEAR(p.first_step({1, 0}, {1, 1}), 0.01, 1e-12);
  EXPECT_NEAR(p.first_step({1, 0}, {0, 0}), 0.02, 1e-12);
  EXPECT_NEAR(p.first_step({0, 0}, {0, 1}), 0.01, 1e-12);
}

TEST(LayerRules, R8WithR14_WallsOnAllSidesOfABlock) {
  const PlannedWalls p(hand_made::unit_square(), 0.2,
                       {"side_0:first=0.01,layers=3", "side_1:first=0.02,layers=4", "side_2:first=0.03,layers=2",
                        "side_3:first=0.04,layers=2"});
  EXPECT_NEAR(p.first_step({0, 0}, {1, 0}), 0.04, 1e-12);
  EXPECT_NEAR(p.first_step({1, 0}, {1, 1}), 0.01, 1e-12);
  EXPECT_NEAR(p.first_step({1, 1}, {0, 1}), 0.02, 1e-12);
  EXPECT_NEAR(p.first_step({0, 1}, {0, 0}), 0.03, 1e-12);
  EXPECT_EQ(p.plan.sharing_a_chord, (std::vector<std::array<int, 2>>{{0, 2}, {1, 3}}));
  EXPECT_EQ(p.warnings(), (Names{"W-WAL-001", "W-WAL-001"}));
}

// ---- How many layers

TEST(LayerRules, R10_LayersWithoutClearanceAreRefusedWithNumberAndPlace) {
  CadFace face;
  face.origin = {10, 20};
  for (const std::string count : {"layers=11", "thickness=1.05"}) {
    const std::string message = message_of<ComputeError>(
        [&] { fitting_layers(parse({"a:first=0.1,law=uniform," + count}), {straight(0, 1, 0)}, face); });
    EXPECT_TRUE(contains(message, "(11, 22)")) << message;
    EXPECT_TRUE(contains(message, "at most 9 fit, with a thickness of 0.9")) << message;
  }
  EXPECT_EQ(fitting("a:first=0.1,law=uniform,layers=9", {straight(0, 1, 0)}), 9);
}

TEST(LayerRules, R10_AboveTheLayersAnIntervalAFifthShorterMustFit) {
  const std::string wall = "a:first=0.1,law=uniform,layers=fit";
  EXPECT_EQ(fitting(wall, {straight(0, 0.981, 0)}), 9);
  EXPECT_EQ(fitting(wall, {straight(0, 0.979, 0)}), 8);
}

TEST(LayerRules, R10_AThicknessMeansTheLeastNumberThatReachesIt) {
  EXPECT_EQ(fitting("a:first=0.1,law=uniform,thickness=0.5", {straight(0, 1, 0)}), 5);
  EXPECT_EQ(fitting("a:first=0.1,law=uniform,thickness=0.51", {straight(0, 1, 0)}), 6);
}

TEST(LayerRules, R11_FitIsTheGreatestNumberAndMustNotBeZero) {
  EXPECT_EQ(fitting("a:first=0.1,law=uniform,layers=fit", {straight(0, 1, 0)}), 9);
  const std::string message = message_of<ComputeError>([] { fitting("a:first=2,layers=fit", {straight(0, 1, 0)}); });
  EXPECT_TRUE(contains(message, "not even one fits")) << message;
}

TEST(LayerRules, R12_FacingWallsBothLoseLayers) {
  const std::vector<NormalLineSample> line{straight(0, 1, 0, 1)};
  const std::vector<int> fit = fitting_layers(
      parse({"a:first=0.05,law=uniform,layers=fit", "b:first=0.05,law=uniform,layers=fit"}), line, CadFace());
  EXPECT_EQ(fit[0], fit[1]);
  EXPECT_EQ(fit[0] + fit[1], 18);
  // A prescribed number opposite to layers=fit does not come first.
  EXPECT_THROW(fitting_layers(parse({"a:first=0.05,law=uniform,layers=12", "b:first=0.05,law=uniform,layers=fit"}),
                              line, CadFace()),
               ComputeError);
}

TEST(LayerRules, R12WithR5_BothCirclesOfARing) {
  const PlannedWalls p(hand_made::cut_annulus(3), 0.2, {"side_0,side_1:first=0.01,layers=fit"});
  EXPECT_LT(2 * thickness(p, 0), 0.5);
  EXPECT_GT(2 * thickness(p, 0), 0.25);
}

TEST(LayerRules, R13_WideBlocksTakeLayersFromNarrowOnesOfTheirChord) {
  const std::string wall = "a:first=0.01,layers=fit";
  const int alone = fitting(wall, {straight(0, 0.3, 0)});
  const int beside_wide = fitting(wall, {straight(0, 0.3, 0), straight(0, 3, 0)});
  EXPECT_LT(beside_wide, alone);
  EXPECT_EQ(fitting(wall, {straight(0, 0.3, 0), straight(1, 3, 0)}), alone) << "another chord";
}

TEST(LayerRules, R13_WhereNoNumberAvoidsCrowdingOnlyTheClearanceCounts) {
  const std::vector<NormalLineSample> narrow_and_wide{straight(0, 0.3, 0), straight(0, 30, 0), straight(1, 0.3, 1),
                                                      straight(1, 3, 1)};
  const std::string thick = "a:first=0.16,layers=fit", thin = "b:first=0.01,layers=fit";
  const int thin_alone = fitting(thin, {straight(0, 0.3, 0)});
  // For all walls alike: the thin layers are not reduced for their own wide block either.
  EXPECT_EQ(fitting_layers(parse({thick, thin}), narrow_and_wide, CadFace()), (std::vector<int>{1, thin_alone}));
  const std::string thinner = "a:first=0.02,layers=fit";
  EXPECT_LT(fitting_layers(parse({thinner, thin}), narrow_and_wide, CadFace())[1], thin_alone);
}

TEST(LayerRules, R10WithR13_APrescribedNumberThatCrowdsNarrowBlocksIsRefused) {
  const std::vector<NormalLineSample> lines{straight(0, 0.3, 0), straight(0, 3, 0)};
  const int most = fitting("a:first=0.01,layers=fit", lines);
  const auto prescribed = [&](int count) { return "a:first=0.01,layers=" + std::to_string(count); };
  EXPECT_EQ(fitting(prescribed(most), lines), most);
  const std::string message = message_of<ComputeError>([&] { fitting(prescribed(most + 1), lines); });
  EXPECT_TRUE(contains(message, "at most " + std::to_string(most) + " fit")) << message;
  EXPECT_EQ(fitting(prescribed(most + 1), {lines[0]}), most + 1) << "without the wide block";
}

TEST(LayerRules, R12WithR13_FacingWallsBothLoseLayersToTheirWideBlocks) {
  const std::vector<WallSpec> walls = parse({"a:first=0.01,layers=fit", "b:first=0.01,layers=fit"});
  const std::vector<NormalLineSample> narrow{straight(0, 0.6, 0, 1)}, both{narrow[0], straight(0, 6, 0, 1)};
  const std::vector<int> alone = fitting_layers(walls, narrow, CadFace()),
                         beside_wide = fitting_layers(walls, both, CadFace());
  EXPECT_EQ(beside_wide[0], beside_wide[1]);
  EXPECT_LT(beside_wide[0], alone[0]);
}

// ---- Divisions of chords

TEST(LayerRules, Rb_OnlyTheFirstLayersOfWallsThatAreCompressedSomewhereKeepTheirHeights) {
  // Eight layers from 0.05 are 1.2 high, and the blocks 1; six from 0.2 do not fit even if all are as high as the
  // first.
  for (const auto& [wall, fixed] :
       {std::pair{"0.05,growth=1.3,layers=8", 1}, {"0.05,growth=1.3,layers=4", 4}, {"0.2,growth=1.1,layers=6", 1}}) {
    PlannedWalls p(row({1, 1}), 1, {std::string("side_0:blocks=own,first=") + wall});
    release_compressed_layers(p.input, p.plan);
    const int arc = p.arc_between({1, 0}, {1, 1});
    EXPECT_EQ(p.plan.num_fixed[0], fixed);
    EXPECT_EQ(p.plan.requests.spacings[arc][0].layers() + p.plan.requests.spacings[arc][1].layers(), fixed);
    const double least = p.plan.least_thickness[0];
    p.divisions[arc].ends.assign(p.divisions[arc].ends.size(), 0.5);
    measure_released_layers(p.input, p.divisions, p.plan);
    EXPECT_NEAR(p.plan.least_thickness[0], fixed == 1 ? 0.5 : least, 1e-12) << "of all layers, measured on the arcs";
  }
}

TEST(LayerRules, Rb_AlsoWhereManyIntervalsAboveTheLayersAreFarShorterThanTheLast) {
  for (const auto& [size, fixed] : {std::pair{1.0, 4}, {0.05, 1}}) {  // the layers are 0.309 high, and the block 1
    PlannedWalls p(row({1, 1}), size, {"side_0:blocks=own,first=0.05,growth=1.3,layers=4"});
    release_compressed_layers(p.input, p.plan);
    EXPECT_EQ(p.plan.num_fixed[0], fixed) << size;
  }
}

TEST(LayerRules, Rb_ManyIntervalsAboveTheLayersShareTheirRoom) {
  const PlannedWalls p(row({1, 1}), 0.05, {"side_0:blocks=own,first=0.05,growth=1.3,layers=4"});  // 0.309 high
  const std::vector<double> ends = p.steps({0, 0}, {0, 1});
  const double above = (1 - ends[3]) / static_cast<double>(ends.size() - 4);
  ASSERT_GT(ends.size(), 10u);
  for (std::size_t k = 4; k < ends.size(); ++k) EXPECT_NEAR(ends[k] - ends[k - 1], above, 0.1 * above);
}

/// Two blocks with one line at the corner of 270 degrees at (1, 1), from which the curve at the distance 1 has its own.
SeparatrixGraph around_a_corner() {
  SeparatrixGraph g;
  const std::vector<Vec2> corners{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  std::vector<Nurbs> loop;
  for (std::size_t i = 0; i < corners.size(); ++i) loop.push_back(curve::segment(corners[i], corners[(i + 1) % 6]));
  g.face = hand_made::face({loop}, std::sqrt(8.0));
  for (int i = 0; i < 6; ++i) hand_made::add_joint_node(g, i, i == 3 || i == 0 ? 2 : 1);
  for (int i = 0; i < 6; ++i) hand_made::add_arc(g, i, (i + 1) % 6, true, {hand_made::whole(g, i)});
  hand_made::add_cut(g, 0, 3);
  return g;
}

TEST(LayerRules, Rd_AroundACornerLayersWithBlocksOfTheirOwnRunParallelToBothSides) {
  for (const auto& [own, height] : {std::pair{",blocks=own", 0.05 * std::sqrt(2.0)}, {"", 0.05}}) {
    const PlannedWalls p(around_a_corner(), 0.3, {std::string("side_2,side_3:first=0.05,layers=4") + own});
    EXPECT_NEAR(p.first_step({1, 1}, {0, 0}), height, 1e-9);
    EXPECT_NEAR(p.first_step({2, 1}, {2, 0}), 0.05, 1e-9);
    EXPECT_NEAR(p.first_step({1, 2}, {0, 2}), 0.05, 1e-9);
  }
}

TEST(LayerRules, R14_FacingWallsKeepTheirHeightsAndShareTheCount) {
  const PlannedWalls p(hand_made::unit_square(), 0.2, {"side_0:first=0.01,layers=3", "side_2:first=0.03,layers=2"});
  EXPECT_NEAR(p.first_step({0, 0}, {0, 1}), 0.01, 1e-12);
  EXPECT_NEAR(p.first_step({0, 1}, {0, 0}), 0.03, 1e-12);
  EXPECT_EQ(p.steps({0, 0}, {0, 1}).size(), p.steps({1, 0}, {1, 1}).size());
  EXPECT_EQ(p.plan.sharing_a_chord, (std::vector<std::array<int, 2>>{{0, 1}}));
  EXPECT_EQ(p.warnings(), Names{"W-WAL-001"});
}

TEST(LayerRules, R14_AlsoAtOneEndOfTheChordInDifferentBlocks) {
  const PlannedWalls p(row({1, 1, 1}), 0.3, {"side_0:first=0.01,layers=3", "side_2:first=0.02,layers=4"});
  EXPECT_NEAR(p.first_step({0, 0}, {0, 1}), 0.01, 1e-12);
  EXPECT_NEAR(p.first_step({3, 0}, {3, 1}), 0.02, 1e-12);
  EXPECT_EQ(p.steps({0, 0}, {0, 1}).size(), p.steps({3, 0}, {3, 1}).size());
  EXPECT_EQ(p.warnings(), Names{"W-WAL-001"});
}

TEST(LayerRules, R15_TheLeastGrowthOfAChordCounts) {
  WallSpec spec;
  for (const auto& [growth, beyond] : {std::pair{1.0, 1.1}, {1.1, 1.1}, {1.5, 1.5}}) {
    spec.growth = growth;
    EXPECT_EQ(growth_beyond(spec), beyond);
  }
  const mesh::Chord chord{{0, 1, 2}, {false, false, false}, {}};
  std::vector<ArcSpacing> spacings(3);
  EXPECT_EQ(least_growth(chord, spacings), 0);
  spacings[0][1] = {{}, 0.1, 1.4}, spacings[2][0] = {{}, 0.2, 1.15};
  EXPECT_EQ(least_growth(chord, spacings), 1.15);
}

TEST(LayerRules, R15WithR14_SlowGrowthAtOneEndHoldsAtTheOther) {
  const PlannedWalls p(hand_made::unit_square(), 0.2,
                       {"side_0:first=0.01,growth=1.5,layers=2", "side_2:first=0.01,growth=1.1,layers=2"});
  const std::vector<double> y = p.steps({0, 0}, {0, 1});
  for (std::size_t k = 3; k + 3 < y.size(); ++k) EXPECT_LE((y[k] - y[k - 1]) / (y[k - 1] - y[k - 2]), 1.1 * (1 + 1e-5));
}

TEST(LayerRules, R16_BeyondTheWallsEndAnArcReturnsToItsOwnDivisionWithTheDistance) {
  double last = 0.01;
  for (const double width : {0.05, 0.3, 1.0, 2.0}) {
    const PlannedWalls p(row({1, width}), 0.2, {"side_0:first=0.01,layers=5"});
    const double first = p.first_step({1 + width, 0}, {1 + width, 1});
    EXPECT_GT(first, last) << width;
    last = first;
  }
  const PlannedWalls far(row({1, 8}), 0.2, {"side_0:first=0.01,layers=5"});
  const std::vector<double> y = far.steps({9, 0}, {9, 1});
  EXPECT_NEAR(y.front(), 1.0 / static_cast<double>(y.size()), 1e-9);
}

TEST(LayerRules, R16_OfEquallyNearWallsTheFinestCounts) {
  const auto middle = [](const std::string& left, const std::string& right) {
    return PlannedWalls(row({1, 1, 1, 1}), 0.3, {"side_0:layers=4,first=" + left, "side_3:layers=4,first=" + right})
        .steps({2, 0}, {2, 1});
  };
  const std::vector<double> fine_left = middle("0.005", "0.02"), fine_right = middle("0.02", "0.005");
  ASSERT_EQ(fine_left.size(), fine_right.size());
  for (std::size_t k = 0; k < fine_left.size(); ++k) EXPECT_NEAR(fine_left[k], fine_right[k], 1e-9);
}

/// The unit square whose left side is two curves, "up" and "low", which meet at this height.
SeparatrixGraph split_square(double joint) {
  CadFace face =
      hand_made::face({{curve::segment({0, 0}, {1, 0}), curve::segment({1, 0}, {1, 1}), curve::segment({1, 1}, {0, 1}),
                        curve::segment({0, 1}, {0, joint}), curve::segment({0, joint}, {0, 0})}},
                      std::sqrt(2.0));
  face.curve_names[3] = "up", face.curve_names[4] = "low";
  return hand_made::one_block(std::move(face), {{0}, {1}, {2}, {3, 4}});
}

TEST(LayerRules, R18_AnIntervalEndsWhereAGivenNameEnds) {
  const PlannedWalls p(split_square(0.5), 0.2, {"side_0:first=0.01,layers=3"});
  const std::vector<double> y = p.steps({0, 0}, {0, 1});
  EXPECT_EQ(std::count_if(y.begin(), y.end(), [](double v) { return std::abs(v - 0.5) < 1e-12; }), 1);
}

TEST(LayerRules, R18WithR17_ALayerCutThatMovesTakesItsArcsExactHeightsWithIt) {
  const PlannedWalls p(split_square(0.024), 0.2, {"side_0:first=0.01,law=uniform,layers=5"});
  const std::vector<double> left = p.steps({0, 0}, {0, 1}), right = p.steps({1, 0}, {1, 1});
  EXPECT_NEAR(left[0], 0.01, 1e-12);
  EXPECT_NEAR(left[1], 0.024, 1e-12);
  EXPECT_NEAR(right[1], 0.02, 1e-12);
  EXPECT_EQ(left.size(), right.size());
  EXPECT_TRUE(p.plan.arc_nodes[p.arc_between({0, 0}, {0, 1})].empty());
  EXPECT_FALSE(p.plan.arc_nodes[p.arc_between({1, 0}, {1, 1})].empty());
}

TEST(LayerRules, R17_IntervalsOffTheBoundaryBecomeSmaller) {
  // Walls at both ends of a quarter ring: their chord runs along the arcs.
  const Names walls{"side_0:first=0.05,layers=2", "side_2:first=0.05,layers=2"};
  const auto count = [&](double tolerance) {
    const PlannedWalls p(hand_made::quarter_annulus(), 2, walls, 2, tolerance);
    const int arc = p.arc_between({2, 0}, {0, 2});
    const std::vector<double>& ends = p.divisions[arc].ends;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k)
      EXPECT_LE(sizing::interval_error(p.measured.curves(), p.measured.chain(arc), ends[k], ends[k + 1], 2), tolerance);
    return ends.size();
  };
  EXPECT_GT(count(1e-7), count(1e-2));
}

// ---- What continues the layers

TEST(LayerRules, R19_ACoarserArcBeyondTheBlockContinuesFromTheFineInterval) {
  const PlannedWalls fine(row({0.2, 2}), 0.4, {"side_4:first=0.01,layers=4"});  // side_4: the left side
  EXPECT_EQ(fine.plan.chords.size(), 2u);
  const std::vector<double> before = fine.steps({0.2, 0}, {0, 0});
  EXPECT_LE(fine.first_step({0.2, 0}, {2.2, 0}), 1.3 * before.front());
  // Nothing to continue where the block is wide enough to reach the prescribed size.
  const PlannedWalls coarse(row({2, 2}), 0.2, {"side_4:first=0.01,layers=4"});
  EXPECT_EQ(coarse.plan.chords.size(), 1u);
}

TEST(LayerRules, R19_ContinuesFromChordToChord) {
  const PlannedWalls p(row({0.1, 0.1, 0.1, 2}), 0.4, {"side_6:first=0.01,growth=1.1,layers=2"});
  EXPECT_EQ(p.plan.chords.size(), 4u);
  double last = 0.01;
  for (const double x : {0.1, 0.2, 0.3}) {
    const double next = p.first_step({x, 0}, {x > 0.25 ? 2.3 : x + 0.1, 0});
    EXPECT_GE(next, last * (1 - 1e-6)) << x;
    last = next;
  }
}

TEST(LayerRules, R19WithR16_TheContinuationOfAWallThatEndsAtACorner) {
  // Block 1 has layers on neither chord; its vertical chord is block 0's.
  const PlannedWalls p(row({0.2, 2}), 0.4, {"side_0:first=0.01,layers=4", "side_4:first=0.01,layers=4"});
  EXPECT_LE(p.first_step({0.2, 0}, {2.2, 0}), 1.3 * p.first_step({0.2, 0}, {0, 0}));
  EXPECT_NEAR(p.first_step({0.2, 0}, {0.2, 1}), 0.01, 1e-12);
  EXPECT_GT(p.first_step({2.2, 0}, {2.2, 1}), 0.01);
}

/// Two blocks, 0.2 and 2 wide and 1 high; the floor of the second is two curves that meet at x = `joint`. The left side
/// is curve 5.
SeparatrixGraph row_with_split_floor(double joint) {
  SeparatrixGraph g;
  g.face = hand_made::face(
      {{curve::segment({0, 0}, {0.2, 0}), curve::segment({0.2, 0}, {joint, 0}), curve::segment({joint, 0}, {2.2, 0}),
        curve::segment({2.2, 0}, {2.2, 1}), curve::segment({2.2, 1}, {0, 1}), curve::segment({0, 1}, {0, 0})}},
      norm(Vec2{2.2, 1}));
  const int left = hand_made::add_joint_node(g, 0), middle = hand_made::add_joint_node(g, 1, 2);
  const int right = hand_made::add_joint_node(g, 3), top_right = hand_made::add_joint_node(g, 4);
  const int top_left = hand_made::add_joint_node(g, 5), top = hand_made::add_boundary_node(g, 4, 2);
  hand_made::add_arc(g, left, middle, true, {hand_made::whole(g, 0)});
  hand_made::add_arc(g, middle, right, true, {hand_made::whole(g, 1), hand_made::whole(g, 2)});
  hand_made::add_arc(g, right, top_right, true, {hand_made::whole(g, 3)});
  hand_made::add_arc(g, top_right, top, true, {{4, 0, 2}});
  hand_made::add_arc(g, top, top_left, true, {{4, 2, 2.2}});
  hand_made::add_arc(g, top_left, left, true, {hand_made::whole(g, 5)});
  hand_made::add_cut(g, middle, top);
  return g;
}

TEST(LayerRules, R19WithR18_AnArcThatContinuesLayersEndsAnIntervalWhereANameEnds) {
  const PlannedWalls p(row_with_split_floor(0.26), 0.4, {"side_5:first=0.01,layers=4"});
  const double before = p.first_step({0.2, 0}, {0, 0});
  const std::vector<double> floor = p.steps({0.2, 0}, {2.2, 0}), top = p.steps({0.2, 1}, {2.2, 1});
  EXPECT_EQ(std::count_if(floor.begin(), floor.end(), [](double x) { return std::abs(x - 0.06) < 1e-12; }), 1);
  EXPECT_EQ(std::count_if(top.begin(), top.end(), [](double x) { return std::abs(x - 0.06) < 1e-12; }), 0);
  EXPECT_EQ(floor.size(), top.size());
  EXPECT_LE(top.front(), 1.3 * before);
  EXPECT_LE(floor.front(), 0.06);
}

struct ContinueCase {
  const char* what;
  EndSpacing end;
  double neighbour, own, growth;
  bool changes;
  double before_then, growth_then;
};

TEST(LayerRules, R19WithR20_WhenAnEndContinuesItsNeighbour) {
  const EndSpacing free, layered{{0.01}, 0.01, 1.2}, prescribed{{}, 0.02, 1.5};
  for (const ContinueCase& c : {ContinueCase{"far coarser", free, 0.01, 0.1, 1.2, true, 0.01, 1.2},
                                {"within the greatest jump", free, 0.01, 0.0129, 1.1, false, 0, 0},
                                {"just beyond it", free, 0.01, 0.0131, 1.1, true, 0.01, 1.1},
                                {"within the chord's growth", free, 0.01, 0.0149, 1.5, false, 0, 0},
                                {"has layers (20)", layered, 0.001, 0.01, 1.2, false, 0.01, 1.2},
                                {"follows a finer neighbour already", prescribed, 0.03, 0.1, 1.2, false, 0.02, 1.5},
                                {"follows a coarser one", prescribed, 0.01, 0.1, 1.2, true, 0.01, 1.2},
                                {"keeps the least growth", prescribed, 0.01, 0.1, 1.9, true, 0.01, 1.5}}) {
    EndSpacing end = c.end;
    EXPECT_EQ(continue_spacing(c.neighbour, c.own, c.growth, end), c.changes) << c.what;
    EXPECT_EQ(end.before, c.before_then) << c.what;
    EXPECT_EQ(end.growth, c.growth_then) << c.what;
    EXPECT_EQ(end.layer_ends, c.end.layer_ends) << c.what;
  }
}

TEST(LayerRules, Rc_LayersHigherThanHalfARadiusAreFreeInsideBlocksWhereTheWallBendsTowardsThem) {
  const PlannedWalls p(wall_samples::annulus_of_half_circles(), 0.3, {"side_0,side_1,side_2:first=0.01,layers=2"});
  WallPlan plan = p.plan;
  plan.heights = {{0.2, 0.49, 0.51}}, plan.num_fixed = {3};  // the outer radius is 1
  release_bent_layers(p.input, plan);
  for (const WallSide& wall : plan.walls.sides) {
    const bool is_outside = wall.line.pieces()[wall.begin.piece].curve == 0;
    EXPECT_EQ(plan.num_fixed_on(wall.block, wall.side), is_outside ? 2 : 3);
    EXPECT_EQ(plan.num_fixed_on(wall.block, (wall.side + 1) % 4), 0) << "no wall";
  }
  plan.num_fixed = {1};
  EXPECT_EQ(plan.num_fixed_on(plan.walls.sides[0].block, plan.walls.sides[0].side), 1) << "rule b";
}

TEST(LayerRules, R21_FirstIntervalsOfCrowdedArcsAreLimitedButNotNextToLayers) {
  // Ten intervals on a length of 1: the first is at most 2.5 times their mean.
  EXPECT_EQ(spaced_ends({{{{}, 0.9, 1.2}, {}}}, 1, 0.1, 10), spaced_ends({{{{}, 0.25, 1.2}, {}}}, 1, 0.1, 10));
  EXPECT_NE(spaced_ends({{{{}, 0.2, 1.2}, {}}}, 1, 0.1, 10), spaced_ends({{{{}, 0.25, 1.2}, {}}}, 1, 0.1, 10));
  EXPECT_EQ(spaced_ends({{{}, {{}, 0.9, 1.2}}}, 1, 0.1, 10), spaced_ends({{{}, {{}, 0.25, 1.2}}}, 1, 0.1, 10));
  const auto beside_layer = [](double before) { return spaced_ends({{{{0.5}, before, 1.2}, {}}}, 1, 0.1, 10); };
  EXPECT_NE(beside_layer(0.5), beside_layer(0.25));
}

TEST(LayerRules, R19WithR21_AContinuedIntervalIsLimitedOnAnArcThatIsTooShortForIt) {
  const auto continued = [](double neighbour) {
    EndSpacing end;
    EXPECT_TRUE(continue_spacing(neighbour, 2 * neighbour, 1.2, end));
    EXPECT_EQ(end.before, neighbour);
    return spaced_ends({{end, {}}}, 1, 0.1, 10);
  };
  EXPECT_EQ(continued(0.9), continued(0.25)) << "2.5 times the mean of ten intervals";
  EXPECT_NE(continued(0.2), continued(0.25));
}

TEST(LayerRules, R22_ABlockThatMeetsItselfIsNotItsOwnNeighbour) {
  const auto neighbours = [](int cuts) {
    Report report;
    return mesh::arc_neighbours(block::extract_blocks(hand_made::cut_annulus(cuts), report)).size();
  };
  EXPECT_EQ(neighbours(1), 0u);
  EXPECT_EQ(neighbours(2), 4u);
  EXPECT_EQ(neighbours(3), 6u);
}

TEST(LayerRules, R22WithR5_ARingOfOneBlockDoesNotContinueItsOwnLayers) {
  const PlannedWalls p(hand_made::cut_annulus(1), 0.3, {"side_1:first=0.01,layers=5"});
  EXPECT_EQ(p.plan.chords.size(), 1u);
  EXPECT_NEAR(p.first_step({0.5, 0}, {1, 0}), 0.01, 1e-9);
}

/// Plans the walls again, from arcs of one interval, with a prescribed count of the chord of an arc.
void plan_with_count(PlannedWalls& p, int arc, int count) {
  p.input.counts = {{p.measured.chord_of(arc), count}};
  p.divisions.assign(p.divisions.size(), {});
  plan_walls(p.input, p.divisions);
}

/// The ends of the intervals above a wall with five layers, by distance from it, on the chord across a row of blocks
/// with the prescribed count.
std::vector<double> steps_with_count(int count, double x) {
  PlannedWalls p(row({1, 2}), 0.2, {"side_0,side_1:first=0.01,growth=1.2,layers=5"});
  plan_with_count(p, p.arc_between({0, 0}, {0, 1}), count);
  return p.steps({x, 0}, {x, 1});
}

TEST(LayerRules, R23_APrescribedCountIncludesTheLayers) {
  for (const int count : {6, 9, 14, 40})
    for (const double x : {0.0, 1.0, 3.0}) {
      const std::vector<double> steps = steps_with_count(count, x);
      ASSERT_EQ(steps.size(), static_cast<std::size_t>(count));
      const std::vector<double> heights = layer_heights(parse({"0:first=0.01,growth=1.2,layers=5"})[0], 5);
      for (std::size_t k = 0; k < heights.size(); ++k) EXPECT_NEAR(steps[k], heights[k], 1e-9);
      EXPECT_NEAR(steps.back(), 1, 1e-12);
    }
}

TEST(LayerRules, R23_TheIntervalsAboveTheLayersFillTheLengthEvenly) {
  const auto ratios = [](int count) {
    const std::vector<double> steps = steps_with_count(count, 1);
    std::vector<double> result;
    for (std::size_t k = 5; k < steps.size(); ++k)
      result.push_back((steps[k] - steps[k - 1]) / (steps[k - 1] - steps[k - 2]));
    return result;
  };
  for (const double ratio : ratios(9)) EXPECT_GT(ratio, 1.2) << "few intervals grow faster than the wall's layers";
  const std::vector<double> many = ratios(40);
  for (const double ratio : many) {
    EXPECT_LT(ratio, 1.2);
    EXPECT_GT(ratio, 0.95) << "with many there is no interval of the prescribed size";
  }
}

TEST(LayerRules, R23_FewerThanTheLayersLeaveOneIntervalAboveThem) {
  EXPECT_EQ(steps_with_count(2, 0).size(), 6u);
  PlannedWalls both(row({1}), 0.2, {"side_0:first=0.01,layers=3", "side_2:first=0.01,layers=4"});
  plan_with_count(both, both.arc_between({0, 0}, {0, 1}), 4);
  EXPECT_EQ(both.steps({0, 0}, {0, 1}).size(), 8u) << "layers of both ends";
}

TEST(LayerRules, R23WithR17_APrescribedCountRisesForTheTolerance) {
  PlannedWalls p(hand_made::quarter_annulus(), 1, {"side_0:first=0.01,layers=3"}, 2, 1e-4);
  const int arc = p.arc_between({2, 0}, {0, 2});
  const auto count = [&](int prescribed) {
    plan_with_count(p, arc, prescribed);
    return p.divisions[arc].num_intervals();
  };
  EXPECT_EQ(count(40), 40);
  EXPECT_GT(count(4), 4);
  EXPECT_LT(count(4), 20) << "by no more than necessary";
}

}  // namespace
}  // namespace quadrille::layers
