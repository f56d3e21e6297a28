#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "../chart_samples.hpp"
#include "base/error.hpp"
#include "round_trip.hpp"

namespace quadrille::io {

namespace {

using ChartIo = RoundTrip;

TEST_F(ChartIo, ChartsSurviveTheRoundTrip) {
  expect_same_bytes(samples::charted_face());
  const InputFile file = read_input(path("second"));
  EXPECT_TRUE(is_chart(file));
  const CadFace face = read_stage<ChartedFace>(file).face;
  ASSERT_TRUE(face.chart);
  const ChartedFace written = samples::charted_face();
  const Chart &chart = *face.chart, &expected = *written.face.chart;
  EXPECT_EQ(chart.elem2vertices, expected.elem2vertices);
  EXPECT_EQ(chart.space_nodes, expected.space_nodes);
  EXPECT_EQ(chart.uv, expected.uv);
  EXPECT_EQ(chart.log_scale, expected.log_scale);
  EXPECT_EQ(chart.closedness, expected.closedness);
  ASSERT_EQ(chart.surfaces.size(), 1u);
  EXPECT_EQ(chart.surfaces[0].poles, expected.surfaces[0].poles);
  EXPECT_EQ(chart.surfaces[0].knots_v, expected.surfaces[0].knots_v);
  ASSERT_EQ(chart.space_curves.size(), 4u);
  EXPECT_EQ(chart.space_curves[2].poles, expected.space_curves[2].poles);
  write_stage(path("plane"), samples::tri_mesh());
  EXPECT_FALSE(is_chart(read_input(path("plane"))));
  EXPECT_FALSE(is_chart({{"file", ""}, "ISO-10303-21;"}));
}

TEST_F(ChartIo, EveryStageOfACurvedFaceCarriesItsChart) {
  const CadFace face = samples::sphere_face(1, 2);
  const auto expect_chart = [&](auto stage, auto face_of) {
    face_of(stage) = face;
    expect_same_bytes(stage);
    const auto read = read_stage<decltype(stage)>(read_input(path("second")));
    ASSERT_TRUE(face_of(read).chart);
    EXPECT_EQ(face_of(read).chart->space_nodes, face.chart->space_nodes);
    EXPECT_EQ(face_of(read).chart->space_curves[3].poles, face.chart->space_curves[3].poles);
  };
  const auto own = [](auto& stage) -> auto& { return stage.face; };
  expect_chart(samples::tri_mesh(), own);
  expect_chart(
      samples::field(), [](auto& field) -> auto& { return field.mesh.face; });
  expect_chart(samples::resolved_points(), own);
  expect_chart(samples::separatrix_graph(), own);
  expect_chart(samples::block_layout(), own);
  expect_chart(samples::quad_mesh(), own);
}

TEST_F(ChartIo, NumbersOfChartsArePackedInJson) {
  SeparatrixGraph graph = samples::separatrix_graph();
  graph.face = samples::sphere_face(1, 2);
  const std::string written = stage_bytes(graph), packed = "\"log_scale\": \"7zn6/kIu5j";  // ln 2
  ASSERT_NE(written.find(packed), std::string::npos);
  const auto replaced = [&](const std::string& by) {
    std::string bytes = written;
    return InputFile{{"a.sep.json", ""}, bytes.replace(bytes.find(packed), packed.size(), by)};
  };
  for (const char* by : {"\"log_scale\": \"7zn6/kIu5", "\"log_scale\": \"7zn6 kIu5j"})
    EXPECT_THROW(read_stage<SeparatrixGraph>(replaced(by)), FormatError) << by;
  SeparatrixGraph broken = graph;
  Chart chart = *graph.face.chart;
  chart.log_scale[0] = NAN;
  broken.face.chart = std::make_shared<const Chart>(chart);
  EXPECT_THROW(stage_bytes(broken), Defect);
}

}  // namespace

}  // namespace quadrille::io
