#include "stage/given_positions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "../chart_samples.hpp"
#include "../support/texts.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "triangulate/size_triangles.hpp"

namespace quadrille::stage {
namespace {

SizeSources point(Vec3 position, bool is_in_space) {
  SizeSources sources;
  sources.points = {{position, 0.1, 0}};
  sources.boxes = {{position, position + Vec3{1, 1, 0}, 0.1}};
  sources.is_in_space = is_in_space;
  return sources;
}

std::string refusal(const SizeSources& sources, const CadFace& face) {
  return message_of<UsageError>([&] { sizes_on_face(sources, face, triangulate::add_size_triangles, "--size-field"); });
}

TEST(GivenPositions, OnAPlanarFaceTheyBecomeRelativeToTheOrigin) {
  CadFace face = samples::face();
  face.origin = {10, 20};
  const SizeSources sources = sizes_on_face(point({11, 22}, false), face, triangulate::add_size_triangles, "");
  EXPECT_EQ(sources.points[0].position, (Vec3{1, 2, 0}));
  EXPECT_EQ(sources.boxes[0].high, (Vec3{2, 3, 0}));
  expect_contains(refusal(point({11, 22, 3}, true), face), "this face is planar");
}

TEST(GivenPositions, OnACurvedFaceTheyStayInSpace) {
  const CadFace face = samples::sphere_face();
  EXPECT_EQ(sizes_on_face(point({1, 2, 3}, true), face, triangulate::add_size_triangles, "").points[0].position,
            (Vec3{1, 2, 3}));
  expect_contains(refusal(point({1, 2}, false), face), "--size-field: this face is curved");
  EXPECT_NO_THROW(sizes_on_face({}, face, triangulate::add_size_triangles, "")) << "no size field";
}

TEST(GivenPositions, TheColumnZOfATableHasNoEffectOnAPlanarFace) {
  SizeSources table = point({1, 2, 3}, true);
  table.boxes.clear();
  table.is_table = true;
  EXPECT_EQ(sizes_on_face(table, samples::face(), triangulate::add_size_triangles, "").points[0].position,
            in_space(Vec2{1, 2} - samples::face().origin));
}

TEST(GivenPositions, ATableOnACurvedFaceIsJoinedInTheChartWithoutPointsElsewhere) {
  SizeSources table;
  table.is_table = table.is_in_space = true;
  for (const Vec2 x : {Vec2{0.1, 0.1}, {0.4, 0.1}, {0.1, 0.4}, {0.4, 0.4}})
    table.points.push_back({samples::on_sphere(x), 0.1, 0});
  table.points.push_back({{0, 0, 0}, 1e-3, 0});  // the middle of the body
  const SizeSources joined = sizes_on_face(table, samples::sphere_face(), triangulate::add_size_triangles, "");
  EXPECT_EQ(joined.points.size(), 4u);
  EXPECT_EQ(joined.triangles.size(), 2u);
  table.points = {{{0, 0, 0}, 1e-3, 0}};
  expect_contains(refusal(table, samples::sphere_face()), "are their coordinates those of the CAD file?");
}

TEST(GivenPositions, AMetricInSpaceIsPulledBackToTheChart) {
  // Lengths 0.1 along the meridians of the sphere, 0.2 along its parallels: M = t t / 0.01 + p p / 0.04 + n n.
  GivenMetric metric;
  const Vec2 x{0.3, 0.4};
  const Vec3 n = samples::on_sphere(x), p = normalized(cross(Vec3{0, 0, 1}, n)), t = cross(p, n);
  const auto entry = [&](double Vec3::*i, double Vec3::*j) {
    return t.*i * (t.*j) / 0.01 + p.*i * (p.*j) / 0.04 + n.*i * (n.*j);
  };
  metric.in_space.push_back({n,
                             {entry(&Vec3::x, &Vec3::x), entry(&Vec3::x, &Vec3::y), entry(&Vec3::x, &Vec3::z),
                              entry(&Vec3::y, &Vec3::y), entry(&Vec3::y, &Vec3::z), entry(&Vec3::z, &Vec3::z)}});
  metric.in_plane.push_back({});
  const CadFace face = samples::sphere_face(2, 10);
  const std::vector<MetricSample> in_chart = metric_on_face(metric, face, "--metric");
  ASSERT_EQ(in_chart.size(), 1u);
  EXPECT_LE(distance(in_chart[0].position, x), 1e-7);
  const double scale = std::exp(samples::sphere_log_scale(x));
  const bool is_first = in_chart[0].h1 < in_chart[0].h2;
  EXPECT_NEAR(is_first ? in_chart[0].h1 : in_chart[0].h2, 0.1 / scale, 1e-6);
  EXPECT_NEAR(is_first ? in_chart[0].h2 : in_chart[0].h1, 0.2 / scale, 1e-6);
  const Vec2 along = unit(in_chart[0].angle + (is_first ? 0 : half_pi));
  EXPECT_NEAR(std::abs(dot(along, x)) / norm(x), 1, 1e-6) << "meridians are straight lines through the pole";
  EXPECT_EQ(metric_on_face(metric, samples::face(), "").size(), 1u);
}

TEST(GivenPositions, DirectionsOnAPlanarFaceAreRelativeToTheOriginWithTheUsualWidth) {
  CadFace face = samples::face();
  face.origin = {10, 20};
  face.diameter = 40;
  GivenAlignment given;
  given.features = {{{{11, 22}}, 0.5}, {{{10, 20}, {12, 20}}, std::nullopt, 3}};
  given.boxes = {{{10, 21}, {13, 24}, 0.5}};
  given.metric = {{{12, 23}, 1, 2, 0.5}};
  const AlignmentRequest on_face = alignment_on_face(given, face, "--align");
  EXPECT_EQ(on_face.features[0].points, std::vector<Vec2>({{1, 2}}));
  EXPECT_EQ(on_face.features[0].width, 2) << "a twentieth of the diameter";
  EXPECT_EQ(on_face.features[1].points, std::vector<Vec2>({{0, 0}, {2, 0}}));
  EXPECT_EQ(on_face.features[1].width, 3);
  EXPECT_EQ(on_face.boxes[0].low, (Vec2{0, 1}));
  EXPECT_EQ(on_face.boxes[0].high, (Vec2{3, 4}));
  EXPECT_EQ(on_face.boxes[0].width, 2);
  EXPECT_EQ(on_face.metric[0].position, (Vec2{2, 3}));
}

TEST(GivenPositions, MetricsAndAnglesOfAPlaneAreRefusedOnACurvedFace) {
  const CadFace face = samples::sphere_face();
  GivenMetric metric;
  metric.in_plane.push_back({{}, 1, 2, 0});
  expect_contains(message_of<UsageError>([&] { metric_on_face(metric, face, "--metric"); }),
                  "--metric: this face is curved: a metric on it has the columns x, y, z, m11");
  GivenAlignment alignment;
  alignment.boxes.push_back({});
  expect_contains(message_of<UsageError>([&] { alignment_on_face(alignment, face, "--align"); }),
                  "have positions and angles in a plane");
}

}  // namespace
}  // namespace quadrille::stage
