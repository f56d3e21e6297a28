#include "layers/wall_spec.hpp"

#include <gtest/gtest.h>

#include <string>

#include "../hand_made.hpp"
#include "base/error.hpp"
#include "layers/layer_law.hpp"
#include "layers/wall_layers.hpp"

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
  const prescribe::PlateFlow flow{30, 1.5e-5, 1};
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

}  // namespace
}  // namespace quadrille::layers
