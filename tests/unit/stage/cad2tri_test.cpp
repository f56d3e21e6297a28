#include "stage/cad2tri.hpp"

#include <gtest/gtest.h>

#include "../support/test_data.hpp"
#include "../support/texts.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "cad/load_face.hpp"
#include "check/check.hpp"
#include "stage/triangulate_face.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::stage {
namespace {

struct Cad2tri : testing::Test {
  Cad2triInput input_of(const std::string& file) {
    bytes = test_bytes(file);
    return {{bytes, {file, "digest"}}, {}};
  }
  std::string bytes;
  Cad2triOptions options;
  quadrille::Run run;
};

TEST_F(Cad2tri, TheMeshIsThatOfTheParts) {
  const TriMesh mesh = cad2tri(input_of("half_disc.step"), options, run);
  Report report;
  const cad::LoadedFace loaded = cad::load_face_guarded(bytes, "half_disc.step", {radians(1), -1, "", 0, 1e-8}, report);
  const TriMesh expected = triangulate::triangulate(loaded.face, {}, report);
  EXPECT_EQ(mesh.vertices, expected.vertices);
  EXPECT_EQ(mesh.curved_nodes, expected.curved_nodes);
  ASSERT_EQ(mesh.provenance.size(), 1U);
  EXPECT_EQ(mesh.provenance[0].tool, "cad2tri");
  EXPECT_EQ(mesh.provenance[0].inputs.at(0).format, "step");
  EXPECT_EQ(mesh.provenance[0].inputs.at(0).sha256, "digest");
  expect_contains(mesh.provenance[0].options, R"("heal-tolerance":-1,"keep-joints":false,"list":false)");
}

TEST_F(Cad2tri, RegionsAreMeshedWithTheSameEdgesOnTheirCommonCurve) {
  const LoadedShape shape = load_shape(input_of("regions/disc_in_square.step"), options, run);
  const TriMesh mesh = triangulate_face(shape.face, options.elements, run);
  ASSERT_EQ(mesh.face.num_regions(), 2);
  EXPECT_EQ(mesh.region_elems.back(), mesh.num_elems());
  EXPECT_TRUE(check::check_stage(mesh, check::CheckDepth::full).empty());
}

TEST_F(Cad2tri, OptionsNameCurvesBeforeAFileOfNamesDoes) {
  Cad2triInput input = input_of("half_disc.step");
  NameRule rest;
  rest.name = "wall";
  const std::vector<NameRule> rules{rest};
  input.names.emplace(rules, FileIdentity{"names.json", "of names"});
  options.curve_names = {"axis=0"};
  const LoadedShape shape = load_shape(input, options, run);
  EXPECT_EQ(shape.face.curve_names, (std::vector<std::string>{"axis", "wall"}));
  EXPECT_EQ(shape.inputs.at(1).format, "boundary-names");
}

TEST_F(Cad2tri, WhatIsWrongIsToldBeforeTheFileIsRead) {
  const Cad2triInput no_file = input_of("half_disc.step");
  bytes = "";
  const auto refusal = [&] { return message_of<UsageError>([&] { load_shape(no_file, options, run); }); };
  options.elements.order = 17;
  EXPECT_EQ(refusal(), "--order: 17 is outside its interval (1 to 16)");
  options = {};
  options.blunt = "-1";
  EXPECT_EQ(refusal(), "--blunt -1: expected \"auto\" or a width in file units, 0 or above");
  options = {};
  options.region_names = {"core"};
  expect_contains(refusal(), "--region-name");
  options = {};
  options.healed_file = "x.iges";
  expect_contains(refusal(), "--write-healed x.iges");
  options = {};
  options.listed = "all";
  options.face = "0";
  EXPECT_EQ(refusal(), "--list and --face exclude each other");
}

TEST_F(Cad2tri, TheFaceIsWrittenInTheFormatOfTheEnding) {
  const LoadedShape shape = load_shape(input_of("half_disc.step"), options, run);
  EXPECT_EQ(cad_file_of(shape.face, "x.stp").substr(0, 12), "ISO-10303-21");
  expect_contains(cad_file_of(shape.face, "x.brep"), "CASCADE Topology");
}

TEST_F(Cad2tri, TheFacesOfAFileAreListedAndReported) {
  expect_contains(list_faces(input_of("half_disc.step").cad, {}, run), "plane");
  EXPECT_FALSE(run.report().entries().empty());
}

}  // namespace
}  // namespace quadrille::stage
