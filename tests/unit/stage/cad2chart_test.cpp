#include "stage/cad2chart.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../chart/space_faces.hpp"
#include "../support/texts.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"

namespace quadrille::stage {
namespace {

using quadrille::tests::face_of, quadrille::tests::line, quadrille::tests::revolved;

/// A part of a cylinder of radius 2, two radians wide and 3 high.
SpaceFace cylinder() { return face_of(revolved(line({2, 0, 0}, {2, 0, 3}), 0, 2), {{0, 1, 2, 3}}, 12, 5); }

struct Cad2chart : testing::Test {
  std::string bytes = "ISO-10303-21;\nEND-ISO-10303-21;\n";
  Cad2chartOptions options;
  quadrille::Run run;

  ChartedFace charted(const SpaceFace& face) {
    return cad2chart(face, {bytes, {"shape.step", "digest"}}, options, run);
  }
  std::string failure(const SpaceFace& face) {
    return message_of<ComputeError>([&] { charted(face); });
  }
};

TEST_F(Cad2chart, TheStepIsRecorded) {
  const ChartedFace cylinder_chart = charted(cylinder());
  EXPECT_NEAR(cylinder_chart.face.diameter, std::sqrt(25.0), 1e-6);  // unrolled: 4 x 3
  ASSERT_EQ(cylinder_chart.provenance.size(), 1u);
  const ProvenanceStep& step = cylinder_chart.provenance[0];
  EXPECT_EQ(step.tool, "cad2chart");
  ASSERT_EQ(step.inputs.size(), 1u);
  EXPECT_EQ(step.inputs[0].format, "step");
  EXPECT_EQ(step.inputs[0].sha256, "digest");
  expect_contains(step.options, R"("scale-range":1000)");
  EXPECT_TRUE(run.report().warnings().empty());
}

TEST_F(Cad2chart, CracksAreEmbedded) {
  SpaceFace face = cylinder();
  const auto at = [](double z) { return Vec3{2 * std::cos(1), 2 * std::sin(1), z}; };
  face.inner_curves = {{line(at(1), at(2)), "crack", 7, {0, 0}}};
  face.curve_faces.assign(face.curves.size(), 0);
  face.tolerance = 1e-6;
  const CadFace chart = charted(face).face;
  ASSERT_EQ(chart.num_curves(), 6);
  EXPECT_TRUE(chart.is_slit_loop(1));
  EXPECT_EQ(chart.curve_names[4], "crack");
  EXPECT_EQ(chart.curve_cad_edges[5], 7);
  EXPECT_NEAR(distance(chart.curves[4].poles.front(), chart.curves[4].poles.back()), 1, 1e-6);
}

TEST_F(Cad2chart, FailuresNameTheFileAndTheFace) {
  options.scale_range = 1.5, options.closedness = 1e-3;
  const SpaceFace tube = face_of(revolved(line({1, 0, 0}, {1, 0, 1}), 0, 2 * pi), {{0}, {2}}, 36, 8);
  const std::string failed = failure(tube);
  EXPECT_TRUE(failed.starts_with("shape.step: ")) << failed;
  options.face = "lid";
  EXPECT_EQ(failure(tube), "shape.step: face lid" + failed.substr(10));
}

/// A flat cone is unrolled to a sector of 2 pi sin(45 degrees) * 1.5.
TEST_F(Cad2chart, ChartsThatOverlapThemselvesAreRefused) {
  options.closedness = 1e-3;
  NurbsSurface ramp = revolved(line({1, 0, 1}, {3, 0, 1.2}), 0, 3 * pi);
  ramp.is_closed_u = false;
  expect_contains(failure(face_of(ramp, {{0, 1, 2, 3}}, 60, 5)), "overlaps itself");
}

TEST_F(Cad2chart, OptionsOutsideTheirIntervalsAreRefused) {
  options.closedness = 0.1;
  EXPECT_EQ(message_of<UsageError>([&] { charted(cylinder()); }),
            "--closedness: 0.1 is outside its interval (1e-12 to 0.001)");
  options = {};
  options.scale_range = 1;
  EXPECT_THROW(charted(cylinder()), UsageError);
}

}  // namespace
}  // namespace quadrille::stage
