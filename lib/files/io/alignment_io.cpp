#include "io/alignment_io.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "io/describe.hpp"
#include "io/json_archive.hpp"
#include "io/point_table.hpp"

namespace quadrille::io {

namespace {

constexpr StageFormat alignment_version{"alignment", 1, 0, Storage::json};
constexpr double degree = pi / 180;

double read_angle(Archive& archive) {
  double degrees = 0;
  archive.field("angle", degrees);
  archive.require("angle", std::isfinite(degrees), "must be a number of degrees");
  return degrees * degree;
}

void read_weights(Archive& archive, double& width, double& strength) {
  if (archive.has("width")) {
    archive.field("width", width);
    archive.require("width", width > 0 && std::isfinite(width), "must be a length greater than 0 (ALN-R01)");
  }
  if (archive.has("strength")) archive.field("strength", strength);
  archive.require("strength", strength >= 0 && std::isfinite(strength), "must be a number of at least 0 (ALN-R01)");
}

bool are_finite(const std::vector<Vec2>& points) {
  return std::ranges::all_of(points, [](Vec2 p) { return std::isfinite(p.x) && std::isfinite(p.y); });
}

void read_point(Archive& a, AlignmentFeature& point) {
  a.field("position", point.points.emplace_back());
  a.require("position", are_finite(point.points), "must be two numbers");
  point.angle = read_angle(a);
  read_weights(a, point.width, point.strength);
}

void read_curve(Archive& a, AlignmentFeature& curve) {
  a.field("positions", curve.points);
  a.require("positions", curve.points.size() > 1 && are_finite(curve.points), "must be at least two points (ALN-R02)");
  if (a.has("angle")) curve.angle = read_angle(a);
  read_weights(a, curve.width, curve.strength);
}

void read_box(Archive& a, AlignmentBox& box) {
  for (const auto& [name, corner] : {std::pair("low", &box.low), std::pair("high", &box.high)}) {
    a.field(name, *corner);
    a.require(name, are_finite({*corner}), "must be two numbers");
  }
  a.require("high", box.low.x < box.high.x && box.low.y < box.high.y, "must lie above 'low' (ALN-R02)");
  box.angle = read_angle(a);
  read_weights(a, box.width, box.strength);
}

/// Lengths and direction from the tensor M: lengths are 1 / sqrt of its eigenvalues.
MetricSample sample_of_tensor(double m11, double m12, double m22) {
  const double mean = (m11 + m22) / 2, radius = std::hypot((m11 - m22) / 2, m12);
  return {{}, 1 / std::sqrt(mean + radius), 1 / std::sqrt(mean - radius), std::atan2(2 * m12, m11 - m22) / 2};
}

enum class Columns { lengths, tensor, tensor_in_space };

Columns columns_of(const InputFile& file) {
  const std::vector<std::string> heading = table_heading(file);
  const auto has = [&](const char* name) { return std::ranges::find(heading, name) != heading.end(); };
  if (has("m33")) return Columns::tensor_in_space;
  return has("m11") ? Columns::tensor : Columns::lengths;
}

std::vector<std::vector<std::string>> column_names(Columns columns) {
  std::vector<std::vector<std::string>> names{{"x", "points:0"}, {"y", "points:1"}};
  const bool are_lengths = columns == Columns::lengths;
  for (const char* name : are_lengths ? std::array{"h1", "h2", "angle"} : std::array{"m11", "m12", "m22"})
    names.push_back({name});
  if (columns != Columns::tensor_in_space) return names;
  names.push_back({"z", "points:2"});
  for (const char* name : {"m13", "m23", "m33"}) names.push_back({name});
  return names;
}

/// With the tensor in the plane positive definite.
bool is_positive_definite(const SpaceMetricSample& sample) {
  const auto& [m11, m12, m13, m22, m23, m33] = sample.tensor;
  const double determinant =
      m11 * (m22 * m33 - m23 * m23) - m12 * (m12 * m33 - m13 * m23) + m13 * (m12 * m23 - m13 * m22);
  return determinant > 0 && std::isfinite(determinant);
}

GivenMetric read_samples(const InputFile& file) {
  const Columns columns = columns_of(file);
  GivenMetric metric;
  for (const TableRow& row : table_rows(file, column_names(columns))) {
    const std::vector<double>& v = row.values;
    MetricSample sample =
        columns == Columns::lengths ? MetricSample{{}, v[2], v[3], v[4] * degree} : sample_of_tensor(v[2], v[3], v[4]);
    bool is_positive = sample.h1 > 0 && sample.h2 > 0 && std::isfinite(sample.h1) && std::isfinite(sample.h2);
    if (columns == Columns::tensor_in_space) {
      metric.in_space.push_back({{v[0], v[1], v[5]}, {v[2], v[3], v[6], v[4], v[7], v[8]}});
      is_positive = is_positive && is_positive_definite(metric.in_space.back());
    }
    if (!is_positive)
      throw FormatError(fmt::format("{}:{}: {} (ALN-R03)", file.name, row.line,
                                    columns == Columns::lengths ? "the lengths h1 and h2 must be greater than 0"
                                                                : "the tensor must be positive definite"));
    sample.position = {v[0], v[1]};
    metric.in_plane.push_back(sample);
  }
  return metric;
}

void refuse_vtu(const InputFile& file) {
  if (file.bytes.find("<VTKFile") != std::string::npos)
    throw FormatError(fmt::format(
        "{0}: a VTU file: convert it first, by python3 -m quadrille.vtu_sizes {0} --array metric -o metric.csv",
        file.name));
}

}  // namespace

GivenMetric read_metric(const InputFile& file) {
  refuse_vtu(file);
  if (!is_point_table(file))
    throw FormatError(
        file.name +
        ": expected a table of x, y, h1, h2 and angle, or of x, y, m11, m12 and m22: a metric has lengths "
        "(directions alone are for --align)");
  return read_samples(file);
}

GivenAlignment read_alignment(const InputFile& file) {
  GivenAlignment request;
  if (is_point_table(file)) {
    GivenMetric metric = read_samples(file);
    request.metric = std::move(metric.in_plane), request.metric_in_space = std::move(metric.in_space);
    return request;
  }
  refuse_vtu(file);
  JsonReader reader(file.bytes, file.name);
  Archive& root = reader.root();
  require_format(root, alignment_version, file.name, "an alignment");
  std::vector<AlignmentFeature> points, curves;
  if (root.has("points")) root.field("points", points, read_point);
  if (root.has("curves")) root.field("curves", curves, read_curve);
  if (root.has("boxes")) root.field("boxes", request.boxes, read_box);
  request.features = std::move(points);
  request.features.insert(request.features.end(), curves.begin(), curves.end());
  if (request.features.empty() && request.boxes.empty())
    throw FormatError(fmt::format("ALN-R04: {}: there are neither 'points', 'curves' nor 'boxes'", file.name));
  return request;
}

}  // namespace quadrille::io
