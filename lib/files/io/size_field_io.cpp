#include "io/size_field_io.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "io/describe.hpp"
#include "io/json_archive.hpp"
#include "io/point_table.hpp"

namespace quadrille::io {

namespace {

constexpr StageFormat size_field_version{"size-field", 1, 0, Storage::json};

void read_size(Archive& archive, double& size) {
  archive.field("size", size);
  archive.require("size", size > 0 && std::isfinite(size), "must be a length greater than 0 (SIZ-R01)");
}

void read_position(Archive& archive, const char* name, Vec2& position, Vec2 origin) {
  archive.field(name, position);
  archive.require(name, std::isfinite(position.x) && std::isfinite(position.y), "must be two numbers");
  position -= origin;
}

void read_point(Archive& archive, SizePoint& point, Vec2 origin) {
  read_position(archive, "position", point.position, origin);
  read_size(archive, point.size);
  if (!archive.has("radius")) return;
  archive.field("radius", point.radius);
  archive.require("radius", point.radius >= 0 && std::isfinite(point.radius),
                  "must be a length of at least 0 (SIZ-R01)");
}

void read_box(Archive& archive, SizeBox& box, Vec2 origin) {
  read_position(archive, "low", box.low, origin);
  read_position(archive, "high", box.high, origin);
  archive.require("high", box.low.x <= box.high.x && box.low.y <= box.high.y, "must not lie below 'low' (SIZ-R02)");
  read_size(archive, box.size);
}

/// A table of points (formats/size-field.md, "As a table").
SizeSources read_size_table(const InputFile& file, Vec2 origin) {
  SizeSources sources;
  for (const TableRow& row : table_rows(file, {{"x", "points:0"}, {"y", "points:1"}, {"size"}})) {
    const double size = row.values[2];
    if (!(size > 0))
      throw FormatError(
          fmt::format("{}:{}: the size {:g} must be greater than 0 (SIZ-R01)", file.name, row.line, size));
    sources.points.push_back({Vec2{row.values[0], row.values[1]} - origin, size, 0});
  }
  sources.is_table = true;
  return sources;
}

}  // namespace

SizeSources read_size_field(const InputFile& file, Vec2 origin) {
  if (is_point_table(file)) return read_size_table(file, origin);
  if (file.bytes.find("<VTKFile") != std::string::npos)
    throw FormatError(fmt::format(
        "{0}: a VTU file: convert it first, by python3 -m quadrille.vtu_sizes {0} -o sizes.csv", file.name));
  JsonReader reader(file.bytes, file.name);
  Archive& root = reader.root();
  require_format(root, size_field_version, file.name, "a size field");
  if (!root.has("points") && !root.has("boxes"))
    throw FormatError(fmt::format("SIZ-R03: {}: there are neither 'points' nor 'boxes'", file.name));
  SizeSources sources;
  if (root.has("growth")) {
    root.field("growth", sources.growth);
    root.require("growth", sources.growth > 1 && std::isfinite(sources.growth), "must be greater than 1 (SIZ-R01)");
  }
  if (root.has("points"))
    root.field("points", sources.points, [&](Archive& a, SizePoint& point) { read_point(a, point, origin); });
  if (root.has("boxes"))
    root.field("boxes", sources.boxes, [&](Archive& a, SizeBox& box) { read_box(a, box, origin); });
  return sources;
}

}  // namespace quadrille::io
