#include "io/alignment_io.hpp"

#include <gtest/gtest.h>

#include <string>

#include "../support/texts.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"

namespace quadrille::io {
namespace {

GivenAlignment read(const std::string& text) { return read_alignment({{"align.json", ""}, text}); }

std::string alignment(const std::string& members) {
  return R"({"format": "alignment", "version": [1, 0], )" + members + "}";
}

bool says(const std::string& text, const std::string& part) {
  return contains(message_of<FormatError>([&] { read(text); }), part);
}

TEST(AlignmentIo, PointsCurvesAndBoxesAreRead) {
  const AlignmentRequest request = read(alignment(R"("points": [{"position": [1, 2], "angle": 90, "width": 0.1}],
    "curves": [{"positions": [[0, 0], [1, 1]], "strength": 2}],
    "boxes": [{"low": [0, 0], "high": [2, 3], "angle": -45}])"));
  ASSERT_EQ(request.features.size(), 2u);
  const AlignmentFeature &point = request.features[0], &curve = request.features[1];
  EXPECT_EQ(point.points, std::vector<Vec2>({{1, 2}}));
  EXPECT_EQ(point.angle, half_pi);
  EXPECT_EQ(point.width, 0.1);
  EXPECT_EQ(point.strength, 1);
  EXPECT_EQ(curve.points, std::vector<Vec2>({{0, 0}, {1, 1}}));
  EXPECT_FALSE(curve.angle);
  EXPECT_EQ(curve.width, 0) << "the usual one";
  EXPECT_EQ(curve.strength, 2);
  ASSERT_EQ(request.boxes.size(), 1u);
  EXPECT_EQ(request.boxes[0].high, (Vec2{2, 3}));
  EXPECT_EQ(request.boxes[0].angle, -pi / 4);
}

TEST(AlignmentIo, RulesAreNamed) {
  EXPECT_TRUE(says(alignment(R"("points": [{"position": [0, 0], "angle": 0, "width": 0}])"), "ALN-R01"));
  EXPECT_TRUE(says(alignment(R"("points": [{"position": [0, 0], "angle": 0, "strength": -1}])"), "ALN-R01"));
  EXPECT_TRUE(says(alignment(R"("curves": [{"positions": [[0, 0]]}])"), "ALN-R02"));
  EXPECT_TRUE(says(alignment(R"("boxes": [{"low": [0, 1], "high": [1, 1], "angle": 0}])"), "ALN-R02"));
  EXPECT_TRUE(says(alignment(R"("points": [])"), "ALN-R04"));
  EXPECT_TRUE(says(R"({"format": "size-field", "version": [1, 0]})", "not an alignment"));
  EXPECT_TRUE(says(alignment(R"("points": [{"position": [0, 0]}])"), "points[0]"));
}

TEST(AlignmentIo, AMetricIsReadAsLengthsAndAsTensors) {
  const AlignmentRequest lengths = read("x,y,h1,h2,angle\n0,0,0.1,0.2,30\n1,0,0.1,0.3,0\n");
  ASSERT_EQ(lengths.metric.size(), 2u);
  EXPECT_EQ(lengths.metric[1].position, (Vec2{1, 0}));
  EXPECT_EQ(lengths.metric[0].h2, 0.2);
  EXPECT_NEAR(lengths.metric[0].angle, pi / 6, 1e-15);
  // R diag(1 / 0.1^2, 1 / 0.2^2) R^T at 30 degrees
  const AlignmentRequest tensors = read("x y m11 m12 m22\n0 0 81.25 32.475952641916445 43.75\n");
  EXPECT_NEAR(tensors.metric[0].h1, 0.1, 1e-12);
  EXPECT_NEAR(tensors.metric[0].h2, 0.2, 1e-12);
  EXPECT_NEAR(tensors.metric[0].angle, pi / 6, 1e-12);
  EXPECT_EQ(read("0 0 0.1 0.2 30").metric.size(), 1u) << "lengths without a heading";
}

TEST(AlignmentIo, AMetricInSpaceHasSixComponents) {
  const std::string heading = "x,y,z,m11,m12,m13,m22,m23,m33\n";
  const GivenMetric metric = read_metric({{"metric.csv", ""}, heading + "1,2,3,4,0.5,0.25,5,0.125,6\n"});
  ASSERT_EQ(metric.in_space.size(), 1u);
  EXPECT_EQ(metric.in_space[0].position, (Vec3{1, 2, 3}));
  EXPECT_EQ(metric.in_space[0].tensor, (std::array<double, 6>{4, 0.5, 0.25, 5, 0.125, 6}));
  EXPECT_EQ(metric.in_space[0].product({1, 0, 0}, {0, 0, 1}), 0.25);
  EXPECT_EQ(metric.in_plane[0].position, (Vec2{1, 2})) << "for a planar face";
  EXPECT_EQ(read(heading + "1,2,3,4,0.5,0.25,5,0.125,6\n").metric_in_space.size(), 1u);
  EXPECT_TRUE(says(heading + "1,2,3,1,0,2,1,0,1\n", "align.json:2: the tensor must be positive definite"));
}

TEST(AlignmentIo, AMetricThatIsNoneIsRefusedWithItsLine) {
  EXPECT_TRUE(says("x,y,h1,h2,angle\n0,0,1,1,0\n0,0,0,1,0\n", "align.json:3: the lengths"));
  EXPECT_TRUE(says("x,y,m11,m12,m22\n0,0,1,2,1\n", "align.json:2: the tensor"));
  EXPECT_TRUE(says("x,y,m11,m12\n0,0,1,2\n", "there is no column m22"));
  EXPECT_TRUE(says("<VTKFile type=\"UnstructuredGrid\">", "quadrille.vtu"));
}

TEST(AlignmentIo, LengthsAreReadFromTablesOnly) {
  const auto metric = [](const std::string& text) { return read_metric({{"metric.csv", ""}, text}); };
  ASSERT_EQ(metric("0 0 0.1 0.2 30\n").in_plane.size(), 1u);
  EXPECT_EQ(metric("x,y,m11,m12,m22\n1,2,4,0,1\n").in_plane[0].position, (Vec2{1, 2}));
  const auto refuses = [&](const std::string& text, const std::string& part) {
    return contains(message_of<FormatError>([&] { metric(text); }), part);
  };
  EXPECT_TRUE(refuses(alignment(R"("points": [{"position": [0, 0], "angle": 0}])"), "a metric has lengths"));
  EXPECT_TRUE(refuses("<VTKFile type=\"UnstructuredGrid\">", "vtu_sizes"));
  EXPECT_TRUE(refuses("x,y,h1,h2,angle\n0,0,0.1,-1,0\n", "ALN-R03"));
}

}  // namespace
}  // namespace quadrille::io
