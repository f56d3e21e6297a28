#include "stage/given_positions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.hpp"
#include "base/symmetric_tensor.hpp"
#include "mesh/chart_map.hpp"
#include "surface/space_extent.hpp"

namespace quadrille::stage {
namespace {

constexpr double farthest_from_face = 1e-2;  ///< diameters in space

void require_coordinates(bool is_in_space, bool is_curved, const std::string& where) {
  if (is_curved && !is_in_space)
    throw UsageError(where +
                     ": this face is curved: positions on it are those in space, with x, y and z in the coordinates of "
                     "the CAD file");
  if (!is_curved && is_in_space)
    throw UsageError(where + ": this face is planar: positions have two coordinates, x and y");
}

/// Removes the points of a table that are not at the face; of the others, the positions in the chart.
template <class Point>
std::vector<Vec2> keep_points_of(const CadFace& face, const mesh::ChartMap& map, std::vector<Point>& points,
                                 const std::string& where) {
  const double farthest = farthest_from_face * surface::diameter(*face.chart);
  std::vector<Vec2> positions;
  double least = HUGE_VAL;
  std::erase_if(points, [&](const Point& point) {
    const mesh::ChartMap::Foot foot = map.nearest(point.position);
    least = std::min(least, foot.distance);
    if (foot.distance <= farthest) positions.push_back(foot.x);
    return foot.distance > farthest;
  });
  if (points.empty())
    throw UsageError(
        fmt::format("{}: all points are {:.3g} or more away from the face, whose diameter is {:.3g}: are "
                    "their coordinates those of the CAD file?",
                    where, least, surface::diameter(*face.chart)));
  return positions;
}

}  // namespace

SizeSources sizes_on_face(SizeSources sources, const CadFace& face, const JoinPoints& join, const std::string& where) {
  if (sources.points.empty() && sources.boxes.empty()) return sources;
  const bool is_curved = face.chart != nullptr;
  if (is_curved || !sources.is_table) require_coordinates(sources.is_in_space, is_curved, where);
  std::vector<Vec2> positions;
  if (is_curved && sources.is_table) positions = keep_points_of(face, mesh::ChartMap(face), sources.points, where);
  if (!is_curved) {
    const auto move = [&](Vec3& x) { x = in_space(Vec2{x.x, x.y} - face.origin); };
    for (SizeBall& point : sources.points)
      move(point.position), positions.push_back({point.position.x, point.position.y});
    for (SizeBox& box : sources.boxes) move(box.low), move(box.high);
  }
  if (!sources.is_table) return sources;
  if (!join)
    throw UsageError(where + ": a table of sizes at points needs triangles, and no function that makes them is given");
  join(sources, positions);
  return sources;
}

std::vector<MetricSample> metric_on_face(const GivenMetric& metric, const CadFace& face, const std::string& where) {
  if (!face.chart) {
    std::vector<MetricSample> in_plane = metric.in_plane;
    for (MetricSample& sample : in_plane) sample.position -= face.origin;
    return in_plane;
  }
  if (metric.in_space.empty())
    throw UsageError(
        where +
        ": this face is curved: a metric on it has the columns x, y, z, m11, m12, m13, m22, m23 and m33, in "
        "the coordinates of the CAD file");
  const mesh::ChartMap map(face);
  std::vector<SpaceMetricSample> samples = metric.in_space;
  const std::vector<Vec2> positions = keep_points_of(face, map, samples, where);
  std::vector<MetricSample> in_chart;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto [a, b] = map.derivatives(positions[i]);
    const SpaceMetricSample& m = samples[i];
    const EigenPair of = eigen_pair({m.product(a, a), m.product(a, b), m.product(b, b)});
    in_chart.push_back({positions[i], 1 / std::sqrt(of.first), 1 / std::sqrt(of.second), of.angle});
  }
  return in_chart;
}

AlignmentRequest alignment_on_face(const GivenAlignment& alignment, const CadFace& face, const std::string& where) {
  AlignmentRequest request = alignment;
  if (face.chart && (!alignment.features.empty() || !alignment.boxes.empty()))
    throw UsageError(
        where +
        ": this face is curved, and points, curves and boxes have positions and angles in a plane: give the "
        "directions as a metric in space, a table with the columns x, y, z, m11, m12, m13, m22, m23 and m33");
  const auto complete = [&](auto& feature) {
    if (feature.width == 0) feature.width = face.diameter / 20;
  };
  for (AlignmentFeature& feature : request.features) {
    for (Vec2& point : feature.points) point -= face.origin;
    complete(feature);
  }
  for (AlignmentBox& box : request.boxes) box.low -= face.origin, box.high -= face.origin, complete(box);
  request.metric = metric_on_face({alignment.metric, alignment.metric_in_space}, face, where);
  return request;
}

}  // namespace quadrille::stage
