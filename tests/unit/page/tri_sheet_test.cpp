#include <gtest/gtest.h>

#include "../region_samples.hpp"
#include "sheet_samples.hpp"

namespace quadrille::page {
namespace {

TEST(TriSheet, EdgesAreThereOnceWithASignForTheirDirection) {
  const std::string layer = layer_of(stage_sheet(samples::tri_mesh(), frame), "mesh");
  // Four triangles round the centre 4: 0-1, 1-4, 4-0; 1-2, 2-4, 4-1 backwards; ...
  expect_contains(layer, member("ends", {0, 1, 1, 4, 4, 0, 1, 2, 2, 4, 2, 3, 3, 4, 3, 0}));
  expect_contains(layer, member("elements", {1, 2, 3, 4, 5, -2, 6, 7, -5, 8, -3, -7}));
}

TEST(TriSheet, LeastAnglesAndLayersOfFansAreQuantities) {
  TriMesh mesh = samples::tri_mesh();
  expect_counts(layer_of(stage_sheet(mesh, frame), "mesh"),
                {{R"("title":"least angle in degrees")", 1}, {"corner fan", 0}, {packed_floats({45, 45, 45, 45}), 1}});
  mesh.elem_layer = {-1, 0, 1, -1};
  EXPECT_EQ(count(layer_of(stage_sheet(mesh, frame), "mesh"), R"("title":"layer of a corner fan")"), 1);
  EXPECT_EQ(stage_sheet(mesh, frame).caption, "4 triangles, 1 of them curved (order 2)");
}

TEST(TriSheet, AFieldHasSamplesAndItsTrianglesAreHiddenAtFirst) {
  const Sheet sheet = stage_sheet(samples::field(), frame);
  EXPECT_EQ(sheet.title, "Guiding field");
  EXPECT_EQ(sheet.caption, "4 triangles, order 1 to 2");
  expect_contains(layer_of(sheet, "field"), R"("unit":false)");
  expect_contains(layer_of(sheet, "mesh"), R"("shown":false)");
  EXPECT_EQ(layer_of(sheet, "nodes"), "");
}

TEST(TriSheet, APhaseFormHasItsPrescribedNodes) {
  const Sheet sheet = stage_sheet(samples::phase_field(), frame);
  EXPECT_EQ(sheet.title, "Phase form");
  expect_contains(layer_of(sheet, "field"), R"("unit":true)");
  EXPECT_EQ(count(layer_of(sheet, "nodes"), "prescribed node of valence 3"), 1);
  EXPECT_EQ(count(layer_of(stage_sheet(samples::two_regions_phase_field(), frame), "nodes"), "prescribed node"), 2)
      << "one, and the title";
}

}  // namespace
}  // namespace quadrille::page
