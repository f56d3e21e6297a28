#include "io/size_field_io.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "io/describe.hpp"
#include "io/json_archive.hpp"
#include "io/point_table.hpp"

namespace quadrille::io {

namespace {

constexpr StageFormat size_field_version{"size-field", 1, 1, Storage::json};

void read_size(Archive& archive, double& size) {
  archive.field("size", size);
  archive.require("size", size > 0 && std::isfinite(size), "must be a length greater than 0 (SIZ-R01)");
}

/// Reads positions, of which all must have two coordinates or all three.
class PositionReader {
 public:
  explicit PositionReader(SizeSources& sources) : sources_(sources) {}

  void read(Archive& archive, const char* name, Vec3& position) {
    std::vector<double> x;
    archive.field(name, x);
    archive.require(
        name, (x.size() == 2 || x.size() == 3) && std::ranges::all_of(x, [](double c) { return std::isfinite(c); }),
        "must be two numbers, or on a curved face three");
    const bool is_in_space = x.size() == 3;
    archive.require(name, is_first_ || is_in_space == sources_.is_in_space,
                    "must have as many coordinates as the other positions");
    is_first_ = false, sources_.is_in_space = is_in_space;
    position = {x[0], x[1], is_in_space ? x[2] : 0};
  }

  void read_point(Archive& archive, SizeBall& point) {
    read(archive, "position", point.position);
    read_size(archive, point.size);
    if (!archive.has("radius")) return;
    archive.field("radius", point.radius);
    archive.require("radius", point.radius >= 0 && std::isfinite(point.radius),
                    "must be a length of at least 0 (SIZ-R01)");
  }

  void read_box(Archive& archive, SizeBox& box) {
    read(archive, "low", box.low);
    read(archive, "high", box.high);
    archive.require("high", box.low.x <= box.high.x && box.low.y <= box.high.y && box.low.z <= box.high.z,
                    "must not lie below 'low' (SIZ-R02)");
    read_size(archive, box.size);
  }

 private:
  SizeSources& sources_;
  bool is_first_ = true;
};

/// A table of points (formats/size-field.md, "As a table").
SizeSources read_size_table(const InputFile& file) {
  SizeSources sources;
  sources.is_table = true;
  const std::vector<std::string> z{"z", "points:2"}, heading = table_heading(file);
  sources.is_in_space = std::ranges::find_first_of(heading, z) != heading.end();
  std::vector<std::vector<std::string>> columns{{"x", "points:0"}, {"y", "points:1"}, {"size"}};
  if (sources.is_in_space) columns.insert(columns.begin() + 2, z);
  for (const TableRow& row : table_rows(file, columns)) {
    const double size = row.values.back();
    if (!(size > 0))
      throw FormatError(
          fmt::format("{}:{}: the size {:g} must be greater than 0 (SIZ-R01)", file.name, row.line, size));
    sources.points.push_back({{row.values[0], row.values[1], sources.is_in_space ? row.values[2] : 0}, size, 0});
  }
  return sources;
}

}  // namespace

SizeSources read_size_field(const InputFile& file) {
  if (is_point_table(file)) return read_size_table(file);
  if (file.bytes.find("<VTKFile") != std::string::npos)
    throw FormatError(fmt::format(
        "{0}: a VTU file: convert it first, by python3 -m quadrille.vtu_sizes {0} -o sizes.csv", file.name));
  JsonReader reader(file.bytes, file.name);
  Archive& root = reader.root();
  require_format(root, size_field_version, file.name, "a size field");
  if (!root.has("points") && !root.has("boxes"))
    throw FormatError(fmt::format("SIZ-R03: {}: there are neither 'points' nor 'boxes'", file.name));
  SizeSources sources;
  PositionReader positions(sources);
  if (root.has("growth")) {
    root.field("growth", sources.growth);
    root.require("growth", sources.growth > 1 && std::isfinite(sources.growth), "must be greater than 1 (SIZ-R01)");
  }
  if (root.has("points"))
    root.field("points", sources.points, [&](Archive& a, SizeBall& point) { positions.read_point(a, point); });
  if (root.has("boxes"))
    root.field("boxes", sources.boxes, [&](Archive& a, SizeBox& box) { positions.read_box(a, box); });
  return sources;
}

}  // namespace quadrille::io
