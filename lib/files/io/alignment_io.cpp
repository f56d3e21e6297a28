#include "io/alignment_io.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
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

void read_weights(Archive& archive, double usual_width, double& width, double& strength) {
  width = usual_width;
  if (archive.has("width")) archive.field("width", width);
  archive.require("width", width > 0 && std::isfinite(width), "must be a length greater than 0 (ALN-R01)");
  if (archive.has("strength")) archive.field("strength", strength);
  archive.require("strength", strength >= 0 && std::isfinite(strength), "must be a number of at least 0 (ALN-R01)");
}

bool are_finite(const std::vector<Vec2>& points) {
  return std::ranges::all_of(points, [](Vec2 p) { return std::isfinite(p.x) && std::isfinite(p.y); });
}

class AlignmentReader {
 public:
  AlignmentReader(Vec2 origin, double usual_width) : origin_(origin), usual_width_(usual_width) {}

  void read_point(Archive& a, AlignmentFeature& point) const {
    Vec2 position;
    a.field("position", position);
    a.require("position", are_finite({position}), "must be two numbers");
    point.points = {position - origin_};
    point.angle = read_angle(a);
    read_weights(a, usual_width_, point.width, point.strength);
  }

  void read_curve(Archive& a, AlignmentFeature& curve) const {
    a.field("positions", curve.points);
    a.require("positions", curve.points.size() > 1 && are_finite(curve.points),
              "must be at least two points (ALN-R02)");
    for (Vec2& point : curve.points) point -= origin_;
    if (a.has("angle")) curve.angle = read_angle(a);
    read_weights(a, usual_width_, curve.width, curve.strength);
  }

  void read_box(Archive& a, AlignmentBox& box) const {
    for (const auto& [name, corner] : {std::pair("low", &box.low), std::pair("high", &box.high)}) {
      a.field(name, *corner);
      a.require(name, are_finite({*corner}), "must be two numbers");
      *corner -= origin_;
    }
    a.require("high", box.low.x < box.high.x && box.low.y < box.high.y, "must lie above 'low' (ALN-R02)");
    box.angle = read_angle(a);
    read_weights(a, usual_width_, box.width, box.strength);
  }

 private:
  Vec2 origin_;
  double usual_width_;
};

/// Lengths and direction from the tensor M: lengths are 1 / sqrt of its eigenvalues.
MetricSample sample_of_tensor(double m11, double m12, double m22) {
  const double mean = (m11 + m22) / 2, radius = std::hypot((m11 - m22) / 2, m12);
  return {{}, 1 / std::sqrt(mean + radius), 1 / std::sqrt(mean - radius), std::atan2(2 * m12, m11 - m22) / 2};
}

std::vector<MetricSample> read_samples(const InputFile& file, Vec2 origin) {
  const std::vector<std::string> heading = table_heading(file);
  const bool is_tensor = std::ranges::find(heading, "m11") != heading.end();
  std::vector<std::vector<std::string>> columns{{"x", "points:0"}, {"y", "points:1"}};
  for (const char* name : is_tensor ? std::array{"m11", "m12", "m22"} : std::array{"h1", "h2", "angle"})
    columns.push_back({name});
  std::vector<MetricSample> samples;
  for (const TableRow& row : table_rows(file, columns)) {
    const std::vector<double>& v = row.values;
    MetricSample sample = is_tensor ? sample_of_tensor(v[2], v[3], v[4]) : MetricSample{{}, v[2], v[3], v[4] * degree};
    const bool is_positive = sample.h1 > 0 && sample.h2 > 0 && std::isfinite(sample.h1) && std::isfinite(sample.h2);
    if (!is_positive)
      throw FormatError(fmt::format(
          "{}:{}: {} (ALN-R03)", file.name, row.line,
          is_tensor ? "the tensor must be positive definite" : "the lengths h1 and h2 must be greater than 0"));
    sample.position = Vec2{v[0], v[1]} - origin;
    samples.push_back(sample);
  }
  return samples;
}

void refuse_vtu(const InputFile& file) {
  if (file.bytes.find("<VTKFile") != std::string::npos)
    throw FormatError(fmt::format(
        "{0}: a VTU file: convert it first, by python3 -m quadrille.vtu_sizes {0} --array metric -o metric.csv",
        file.name));
}

}  // namespace

std::vector<MetricSample> read_metric(const InputFile& file, Vec2 origin) {
  refuse_vtu(file);
  if (!is_point_table(file))
    throw FormatError(
        file.name +
        ": expected a table of x, y, h1, h2 and angle, or of x, y, m11, m12 and m22: a metric has lengths "
        "(directions alone are for --align)");
  return read_samples(file, origin);
}

AlignmentRequest read_alignment(const InputFile& file, Vec2 origin, double usual_width) {
  AlignmentRequest request;
  if (is_point_table(file)) {
    request.metric = read_samples(file, origin);
    return request;
  }
  refuse_vtu(file);
  JsonReader reader(file.bytes, file.name);
  Archive& root = reader.root();
  require_format(root, alignment_version, file.name, "an alignment");
  const AlignmentReader read(origin, usual_width);
  std::vector<AlignmentFeature> points, curves;
  if (root.has("points"))
    root.field("points", points, [&](Archive& a, AlignmentFeature& point) { read.read_point(a, point); });
  if (root.has("curves"))
    root.field("curves", curves, [&](Archive& a, AlignmentFeature& curve) { read.read_curve(a, curve); });
  if (root.has("boxes"))
    root.field("boxes", request.boxes, [&](Archive& a, AlignmentBox& box) { read.read_box(a, box); });
  request.features = std::move(points);
  request.features.insert(request.features.end(), curves.begin(), curves.end());
  if (request.features.empty() && request.boxes.empty())
    throw FormatError(fmt::format("ALN-R04: {}: there are neither 'points', 'curves' nor 'boxes'", file.name));
  return request;
}

}  // namespace quadrille::io
