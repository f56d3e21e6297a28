#include "stage/hexsweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../chart_samples.hpp"
#include "../support/texts.hpp"
#include "base/error.hpp"
#include "base/warning_codes.hpp"

namespace quadrille::stage {
namespace {

/// The unit square, swept by the options.
struct Hexsweep : testing::Test {
  QuadMesh quads = samples::quad_mesh();
  HexsweepOptions options;
  PointList points;
  quadrille::Run run;

  HexMesh swept() { return hexsweep({{quads, {"x.quad.h5", "digest"}}}, options, run); }
  HexMesh along_curve() {
    HexsweepInput input{{quads, {"x.quad.h5", "digest"}}};
    input.curve.emplace(points, FileIdentity{"curve.csv", "digest of the curve"});
    return hexsweep(input, options, run);
  }
  HexMesh over_terrain() {
    HexsweepInput input{{quads, {"x.quad.h5", "digest"}}};
    input.terrain.emplace(points, FileIdentity{"hills.csv", "digest of the terrain"});
    return hexsweep(input, options, run);
  }
  /// About a line along y, beside the square.
  void turn(double degrees) { options.revolve = degrees, options.axis = "-1,0,-1,1"; }
  std::string refusal() {
    return message_of<UsageError>([&] { swept(); });
  }
  std::string refusal_of_options() const {
    return message_of<UsageError>([&] { options.validate(); });
  }
};

double top_of(const HexMesh& mesh) {
  return std::ranges::max_element(mesh.nodes, {}, [](Vec3 x) { return x.z; })->z;
}

/// Squares of the mean area of the quads, which are 0.5 x 1.
TEST_F(Hexsweep, WithoutAMotionLayersAreAsHighAsTheQuadsAreLong) {
  EXPECT_NEAR(top_of(swept()), std::sqrt(0.5), 1e-15);
  options.layers = 3;
  const HexMesh mesh = swept();
  EXPECT_EQ(mesh.num_layers(), 3);
  EXPECT_NEAR(top_of(mesh), 3 * std::sqrt(0.5), 1e-15);
}

TEST_F(Hexsweep, FreeLayersAreNoHigherThanTheQuadsAreLong) {
  options.height = 2;
  EXPECT_EQ(swept().num_layers(), 3);  // 2 / 0.707 = 2.8
  options.twist = 60;
  EXPECT_EQ(swept().num_layers(), 4) << "of 15 degrees";
  options = {};
  turn(90);
  EXPECT_EQ(swept().num_layers(), 6) << "of 15 degrees";
}

TEST_F(Hexsweep, TheStepNamesItsInputs) {
  options.height = 1;
  points = {{-1, -1, 0.5}, {2, -1, 0.5}, {-1, 2, 0.5}, {2, 2, 0.5}};
  const HexMesh mesh = over_terrain();
  const ProvenanceStep& step = mesh.provenance.back();
  EXPECT_EQ(step.tool, "hexsweep");
  ASSERT_EQ(step.inputs.size(), 2u);
  EXPECT_EQ(step.inputs[1].format, "terrain");
  EXPECT_EQ(step.inputs[1].sha256, "digest of the terrain");
  for (const Vec3 x : mesh.nodes) EXPECT_TRUE(x.z >= 0.5 && x.z <= 1) << x.z;
}

TEST_F(Hexsweep, TerrainMustLieBelowTheTop) {
  options.height = 0.5;
  points = {{-1, -1, 0.5}, {2, -1, 0.5}, {-1, 2, 0.5}, {2, 2, 0.5}};
  EXPECT_EQ(message_of<UsageError>([&] { over_terrain(); }),
            "--height 0.5: the terrain is up to 0.5 high: the top must lie above it");
}

TEST_F(Hexsweep, OneMotionIsGiven) {
  options.height = 1, options.along = "0,0,1";
  EXPECT_EQ(refusal_of_options(), "--height, --along: give one of them");
  options = {};
  options.revolve = 90;
  EXPECT_EQ(refusal_of_options(), "--revolve and --axis need each other");
  options = {};
  options.axis = "-1,0,-1,1";
  EXPECT_EQ(refusal_of_options(), "--revolve and --axis need each other");
}

TEST_F(Hexsweep, ListsOfNumbersMustBeThat) {
  options.along = "0,1";
  EXPECT_EQ(refusal_of_options(), "--along: '0,1' is not X,Y,Z");
  options.along = "0,0,0";
  EXPECT_EQ(refusal_of_options(), "--along: the vector must not be zero");
  turn(90);
  options.along.clear();
  options.axis = "0,0,1,0,0";
  expect_contains(refusal_of_options(), "--axis: '0,0,1,0,0' is not X1,Y1,X2,Y2");
  options.axis = "-1,0,-1,0";
  EXPECT_EQ(refusal(), "--axis: its two points must differ");
  options = {};
  options.twist = 10, options.centre = "1";
  EXPECT_EQ(refusal_of_options(), "--centre: '1' is not X,Y");
  options.twist = 0, options.centre = "1,1";
  EXPECT_EQ(refusal_of_options(), "--centre is of --twist and --taper: give one of them");
}

TEST_F(Hexsweep, AFullTurnHasNoEnds) {
  turn(-360);
  EXPECT_EQ(refusal_of_options(), "");
  options.taper = 0.5;
  expect_contains(refusal_of_options(), "its end is not its beginning");
  options.taper = 1, options.has_periodic_ends = true;
  expect_contains(refusal_of_options(), "leave out --one-layer and --periodic-ends");
  options.has_periodic_ends = false, options.top_name = "outlet";
  expect_contains(refusal_of_options(), "leave out --bottom-name and --top-name");
  options.top_name = "top", options.layers = 2;
  EXPECT_EQ(refusal(), "--layers 2: a full turn needs at least 3");
  options.layers = 3, options.allow_invalid = true;
  EXPECT_EQ(refusal(), "");
}

TEST_F(Hexsweep, TheAxisMustBeBesideTheFace) {
  turn(90);
  options.axis = "1,0,1,1";
  expect_contains(refusal(), "--revolve: the face touches the axis at (1, ");
  options.axis = "0.25,0,0.25,1";
  expect_contains(refusal(), "--revolve: the face crosses the axis, near (");
  options.axis = "1.001,0,1.001,1";
  options.allow_invalid = true;
  EXPECT_EQ(refusal(), "");
}

TEST_F(Hexsweep, LayersAtBothEndsHaveOneHeight) {
  options.bottom_layers = "first=0.01,layers=3";
  turn(90);
  expect_contains(refusal_of_options(), "with --revolve use --layer-growth");
  options.revolve = 0, options.axis.clear();
  options.layer_growth = 1.2;
  expect_contains(refusal_of_options(), "the growth follows from their number");
  options.layer_growth = 1, options.is_one_layer = true;
  expect_contains(refusal_of_options(), "--one-layer excludes --layers");
  options.is_one_layer = false, options.top_layers = "first=0";
  expect_contains(refusal_of_options(), "--top-layers");
}

TEST_F(Hexsweep, EndsThatDifferCannotBePeriodic) {
  options.is_one_layer = true;
  EXPECT_EQ(refusal_of_options(), "");
  const HexMesh mesh = swept();
  EXPECT_EQ(mesh.face_groups[4].periodic_with, 5);
  options.taper = 0.5;
  EXPECT_EQ(refusal_of_options(), "--taper: bottom and top differ in size and cannot be periodic");
  options = {};
  options.bottom_name = options.top_name = "end";
  EXPECT_EQ(refusal_of_options(), "--bottom-name and --top-name must be two different names");
}

TEST_F(Hexsweep, TerrainNeedsATopAndAStraightSweep) {
  options.terrain_file = "hills.csv";
  EXPECT_EQ(refusal_of_options(), "--terrain needs --height, that of the top");
  options.height = 1, options.twist = 5;
  expect_contains(refusal_of_options(), "--terrain excludes --twist");
}

TEST_F(Hexsweep, CurvesHavePointsApart) {
  points = {{0.5, 0.5, 0}};
  const std::string text = "--curve curve.csv: give at least two points, each apart from the next";
  EXPECT_EQ(message_of<UsageError>([&] { along_curve(); }), text);
  points = {{0.5, 0.5, 0}, {0.5, 0.5, 1}, {0.5, 0.5, 1}};
  EXPECT_EQ(message_of<UsageError>([&] { along_curve(); }), text);
  points = {{0.5, 0.5, 0}, {0.5, 0.5, 2}};
  EXPECT_NEAR(top_of(along_curve()), 2, 1e-14);
}

TEST_F(Hexsweep, SweepsThatAreRoundingErrorsAreRefused) {
  options.height = 1e-13;
  expect_contains(refusal(), "diameters of the face long: make it longer");
  options.height = 0;
  turn(1e-11);
  expect_contains(refusal(), "radians long: make it longer");
}

TEST_F(Hexsweep, CurvedFacesHaveNoOneNormal) {
  quads.face = samples::sphere_face(1, 2);
  for (Vec2& x : quads.nodes) quads.space_nodes.push_back(samples::on_sphere(x = x / 2));
  EXPECT_EQ(refusal(), "--height: this face is curved and has no one normal: give --along X,Y,Z");
  options.along = "0,0,1", options.taper = 0.5;
  EXPECT_EQ(refusal(), "--twist, --taper and --terrain are for planar faces, but this one is curved");
  options = {};
  turn(90);
  EXPECT_EQ(refusal(), "--axis: this face is curved: give two points in space, X1,Y1,Z1,X2,Y2,Z2");
}

TEST_F(Hexsweep, WhatIsNotProvedIsWrittenOnDemandOnly) {
  options.height = 0.1, options.twist = 180, options.layers = 1;
  EXPECT_THROW(swept(), ComputeError);
  options.allow_invalid = true;
  quadrille::Run other;
  const HexMesh mesh = hexsweep({{quads, {"x.quad.h5", "digest"}}}, options, other);
  EXPECT_FALSE(mesh.is_valid);
  std::vector<std::string> codes;
  for (const Report::Warning& warning : other.report().warnings()) codes.push_back(warning.code);
  EXPECT_EQ(codes, (std::vector<std::string>{warning::motion_missed, warning::mesh_not_valid}));
}

TEST_F(Hexsweep, PeriodicSidesThatNoMotionJoinsAreNamed) {
  quads.face.periodic_pairs = {{{1, 3}, 0, {-1, 0}}};
  options.height = 1, options.layers = 4, options.twist = 10;
  EXPECT_EQ(swept().face_groups[1].periodic_with, -1);
  ASSERT_EQ(run.report().warnings().size(), 1u);
  EXPECT_EQ(run.report().warnings()[0].code, warning::periodicity_lost);
  EXPECT_TRUE(run.report().warnings()[0].message.ends_with(": " + quads.face.curve_names[1]));
}

}  // namespace
}  // namespace quadrille::stage
