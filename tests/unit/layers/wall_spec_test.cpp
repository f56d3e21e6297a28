#include "layers/wall_spec.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "../hand_made.hpp"
#include "../support/texts.hpp"
#include "base/error.hpp"
#include "layers/wall_layers.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::layers {
namespace {

TEST(WallSpec, ReadsNamesAndKeysInAnySequence) {
  const WallSpec spec = parse_wall_spec("hole,outer side:layers=7,law=tanh,growth=1.3,first=2e-3");
  EXPECT_EQ(spec.names, (std::vector<std::string>{"hole", "outer side"}));
  EXPECT_EQ(spec.first, 2e-3);
  EXPECT_EQ(spec.growth, 1.3);
  EXPECT_EQ(spec.layers, 7);
  EXPECT_EQ(spec.law, LayerLaw::tanh);
  EXPECT_FALSE(spec.as_many_as_fit);
}

TEST(WallSpec, GrowsByAFifthGeometricallyUnlessTold) {
  const WallSpec spec = parse_wall_spec("a:first=1,thickness=5");
  EXPECT_EQ(spec.growth, 1.2);
  EXPECT_EQ(spec.law, LayerLaw::geometric);
  EXPECT_EQ(spec.thickness, 5);
  EXPECT_EQ(spec.layers, 0);
}

TEST(WallSpec, TakesAsManyLayersAsFit) { EXPECT_TRUE(parse_wall_spec("a:first=1,layers=fit").as_many_as_fit); }

TEST(WallSpec, HasAYPlusInPlaceOfTheFirstHeight) {
  const WallSpec spec = parse_wall_spec("a:yplus=2,layers=3");
  EXPECT_EQ(spec.yplus, 2);
  EXPECT_EQ(spec.first, 0);
  EXPECT_EQ(parse_wall_spec("a:layers=3", 5).yplus, 5) << "the y+ of all walls";
  EXPECT_EQ(parse_wall_spec("a:yplus=2,layers=3", 5).yplus, 2);
  EXPECT_EQ(parse_wall_spec("a:first=1,layers=3", 5).yplus, 0);
  std::vector<WallSpec> specs{spec, parse_wall_spec("b:first=1,layers=3")};
  const PlateFlow flow{30, 1.5e-5, 1};
  set_first_heights(specs, flow, 1000);
  EXPECT_NEAR(specs[0].first, 2000 * flow.height(1), 1e-12) << "in thousandths of the flow's unit";
  EXPECT_EQ(specs[1].first, 1);
}

TEST(WallSpec, MayHaveBlocksOfItsOwnAboveOneMoreLayer) {
  EXPECT_FALSE(parse_wall_spec("a:first=1,layers=2,blocks=shared").own_blocks);
  const WallSpec spec = parse_wall_spec("a:first=1,layers=3,growth=2,blocks=own");
  EXPECT_TRUE(spec.own_blocks);
  EXPECT_NEAR(block_height(spec), 15, 1e-12);
  EXPECT_NEAR(node_clearance(spec), 30, 1e-12);
  EXPECT_THROW(block_height(parse_wall_spec("a:yplus=1,layers=3,blocks=own")), UsageError);
  EXPECT_THROW(parse_wall_spec("a:first=1,layers=fit,blocks=own"), UsageError);
  CadFace face = hand_made::unit_square().face;
  EXPECT_THROW(require_offsets({parse_wall_spec("0:first=1,layers=3,blocks=own")}, face), UsageError);
  face.curve_names[2] = face.curve_names[0] + "_offset";
  EXPECT_NO_THROW(require_offsets({parse_wall_spec("0:first=1,layers=3,blocks=own")}, face));
}

TEST(WallSpec, KeepsColonsOfNames) {
  EXPECT_EQ(parse_wall_spec("wing:upper:first=1,layers=2").names, std::vector<std::string>{"wing:upper"});
}

TEST(WallSpec, MistakesAreUsageErrorsThatQuoteTheText) {
  for (const std::string text : {"a",
                                 ":first=1,layers=2",
                                 "a:",
                                 "a:layers=2",
                                 "a:first=1",
                                 "a:first=0,layers=2",
                                 "a:yplus=0,layers=2",
                                 "a:yplus=1,first=1,layers=2",
                                 "a:first=-1,layers=2",
                                 "a:first=nan,layers=2",
                                 "a:first=1x,layers=2",
                                 "a:first=1,layers=0",
                                 "a:first=1,layers=1001",
                                 "a:first=1,layers=1.5",
                                 "a:first=1,layers=2,thickness=3",
                                 "a:first=1,thickness=0",
                                 "a:first=1,layers=2,growth=0.9",
                                 "a:first=1,layers=2,growth=2.1",
                                 "a:first=1,layers=2,law=cubic",
                                 "a:first=1,layers=2,first=1",
                                 "a:first=1,layers=2,last=1",
                                 "a:first=1,layers=2,blocks=2",
                                 "a:first=1,layers"}) {
    try {
      parse_wall_spec(text);
      ADD_FAILURE() << text << " was taken";
    } catch (const UsageError& error) {
      EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
    }
  }
}

TEST(WallSpec, CurvesOfOneNameMakeOneWall) {
  CadFace face = hand_made::unit_square().face;
  face.curve_names = {"wall", "out", "wall", "in"};
  EXPECT_EQ(curve_walls({parse_wall_spec("in:first=1,layers=1"), parse_wall_spec("wall:first=1,layers=1")}, face),
            (std::vector<int>{1, -1, 1, 0}));
  EXPECT_EQ(curve_walls({parse_wall_spec("1:first=1,layers=1")}, face), (std::vector<int>{-1, 0, -1, -1}));
}

TEST(WallSpec, UnknownNamesAreRefusedWithTheKnownOnesAndNoCurveHasTwoSpecs) {
  const CadFace face = hand_made::unit_square().face;
  try {
    curve_walls({parse_wall_spec("roof:first=1,layers=1")}, face);
    ADD_FAILURE();
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("roof"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("side_2"), std::string::npos);
  }
  const WallSpec spec = parse_wall_spec("side_2:first=1,layers=1");
  EXPECT_THROW(curve_walls({spec, spec}, face), UsageError);
}

constexpr PlateFlow air{30, 1.5e-5, 1};  // Re = 2e6

TEST(FlatPlate, HeightIsThatOfSchlichtingsSkinFriction) {
  EXPECT_NEAR(air.reynolds_number(), 2e6, 1e-6);
  EXPECT_NEAR(air.skin_friction(), 3.3256e-3, 1e-7) << "(2 log10 2e6 - 0.65)^-2.3";
  EXPECT_NEAR(air.height(1), 1.2262e-5, 1e-9) << "1.5e-5 / (30 sqrt(c_f / 2))";
  EXPECT_NEAR(air.height(30) / air.height(1), 30, 1e-12);
}

TEST(FlatPlate, HeightFollowsTheUnitOfLength) {
  const PlateFlow in_millimetres{30e3, 15, 1000};
  EXPECT_NEAR(in_millimetres.height(1), 1000 * air.height(1), 1e-12);
}

TEST(FlatPlate, MissingAndUselessOptionsAreRefusedByName) {
  const auto refusal = [](const PlateFlow& flow, bool is_used) {
    return message_of<UsageError>([&] { flow.validate(is_used); });
  };
  EXPECT_EQ(refusal(air, true), "");
  EXPECT_EQ(refusal({}, false), "");
  expect_contains(refusal({30, 0, 0}, true), "--viscosity, --length");
  expect_contains(refusal({0, 1.5e-5, 1}, true), "--velocity");
  expect_contains(refusal({30, 0, 0}, false), "--velocity: used with --yplus");
  expect_contains(refusal({30, 1.5e-5, 1e-5}, true), "Reynolds number is 20");
}

TEST(FlatPlate, TheReportHasTheFlowAndAWarningOutsideTheFormulasInterval) {
  Report inside, outside;
  report_flow(air, inside);
  EXPECT_TRUE(inside.warnings().empty());
  EXPECT_EQ(inside.entries().front().first, "flow.reynolds_number");
  report_flow({30, 1.5e-5, 0.01}, outside);
  ASSERT_EQ(outside.warnings().size(), 1u);
  EXPECT_EQ(outside.warnings()[0].code, "W-SIZ-001");
}

WallSpec spec_of(LayerLaw law, double first, double growth) {
  WallSpec spec;
  spec.law = law, spec.first = first, spec.growth = growth;
  return spec;
}

TEST(LayerLaw, GeometricLayersGrowByTheirFactor) {
  const std::vector<double> heights = layer_heights(spec_of(LayerLaw::geometric, 0.5, 2), 4);
  EXPECT_EQ(heights, (std::vector<double>{0.5, 1.5, 3.5, 7.5}));
}

TEST(LayerLaw, UniformLayersAreEqual) {
  EXPECT_EQ(layer_heights(spec_of(LayerLaw::uniform, 0.25, 1.5), 3), (std::vector<double>{0.25, 0.5, 0.75}));
}

TEST(LayerLaw, TanhKeepsFirstHeightAndThicknessAndGrowsEverLess) {
  const std::vector<double> heights = layer_heights(spec_of(LayerLaw::tanh, 1e-3, 1.2), 20);
  EXPECT_EQ(heights.front(), 1e-3);
  EXPECT_NEAR(heights.back(), 1e-3 * (std::pow(1.2, 20) - 1) / 0.2, 1e-12);
  double last = 1e9;
  for (std::size_t k = 2; k < heights.size(); ++k) {
    const double below = heights[k - 1] - heights[k - 2], above = heights[k] - heights[k - 1];
    EXPECT_GT(above, below);
    EXPECT_LT(above / below, last);
    last = above / below;
  }
}

TEST(LayerLaw, TanhWithoutGrowthIsUniform) {
  EXPECT_EQ(layer_heights(spec_of(LayerLaw::tanh, 1, 1), 3), (std::vector<double>{1, 2, 3}));
}

TEST(LayerLaw, GllHeightsAreHalfASpectralGrid) {
  const std::vector<double> heights = layer_heights(spec_of(LayerLaw::gll, 2e-3, 1.2), 5);
  const std::vector<double>& points = spectral::gll_points(10);
  EXPECT_DOUBLE_EQ(heights.front(), 2e-3);
  for (int k = 1; k <= 5; ++k) EXPECT_NEAR(heights[k - 1] / heights.back(), 1 + points[k], 1e-12);
}

TEST(LayerLaw, ThicknessAsksForTheLeastNumberThatReachesIt) {
  WallSpec spec = spec_of(LayerLaw::geometric, 1, 2);
  for (const auto& [thickness, layers] : {std::pair{0.1, 1}, {1.0, 1}, {1.01, 2}, {3.0, 2}, {3.1, 3}}) {
    spec.thickness = thickness;
    EXPECT_EQ(requested_layers(spec), layers) << thickness;
  }
  spec.growth = 1, spec.thickness = 1e9;
  EXPECT_THROW(requested_layers(spec), UsageError);
}

TEST(LayerLaw, CompressedLayersAndOneMoreFillTheRoom) {
  const std::vector<double> heights{1, 3, 7};
  EXPECT_EQ(next_layer(heights), 8);
  EXPECT_EQ(compressed_heights(heights, 15), heights);
  const std::vector<double> compressed = compressed_heights(heights, 10);
  EXPECT_NEAR(compressed[0], 1, 1e-12);
  const double growth = compressed[1] - 1;
  EXPECT_NEAR(compressed[2] - compressed[1], growth * growth, 1e-9);
  EXPECT_NEAR(compressed[2] + growth * growth * growth, 10, 1e-9);
  const std::vector<double> equal = compressed_heights(heights, 2);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(equal[k], 0.5 * (k + 1), 1e-12);
}

TEST(LayerLaw, MoreIntervalsAboveLeaveLessRoomForCompressedLayers) {
  const std::vector<double> heights{1, 3, 7};
  EXPECT_EQ(compressed_heights(heights, 15, 4), heights) << "four intervals of 2 above";
  EXPECT_LT(compressed_heights(heights, 10, 4).back(), compressed_heights(heights, 10).back());
  EXPECT_NEAR(compressed_heights(heights, 10, 4).front(), 1, 1e-12);
  for (const double room : {7, 5})
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(compressed_heights(heights, room, 4)[k], k + 1, 1e-9) << room;
}

}  // namespace
}  // namespace quadrille::layers
