#include "io/stage_files.hpp"
#include "io/stage_io.hpp"

namespace quadrille {

namespace {

constexpr FormatVersion critical_points_version{"critical-points", 1, 1};

/// `id` is for people and programs that refer to an entry: its place in the list.
void describe_id(Archive& archive, std::size_t expected) {
  int id = static_cast<int>(expected);
  archive.field("id", id);
  if (id != static_cast<int>(expected)) archive.fail("id", "must be the entry's place in the list, from 0");
}

void describe_critical_points(Archive& archive, CriticalPoints& points) {
  std::size_t next = 0;
  archive.field("origin", points.origin);
  archive.field("critical_points", points.critical_points, [&](Archive& a, CriticalPoint& point) {
    describe_id(a, next++);
    a.field("position", point.position);
    a.field("index", point.index);
    a.field("valence", point.valence);
    a.field("elem", point.elem);
    a.field("xi", point.xi);
    a.field("jacobian", point.jacobian);
    if (a.has("error")) a.field("error", point.error);
  });
  archive.field("corners", points.corners, [](Archive& a, Corner& corner) {
    a.field("joint", corner.joint);
    a.field("position", corner.position);
    a.field("angle_degrees", corner.angle_degrees);
    a.field("valence", corner.valence);
    a.field("curves", corner.curves);
  });
  archive.object("index_sum", [&](Archive& a) {
    a.field("value", points.index_sum);
    a.field("expected", points.index_sum_expected);
  });
}

}  // namespace

CriticalPoints read_critical_points(const InputFile& file) {
  CriticalPoints points;
  points.provenance =
      read_json_stage(file, critical_points_version, [&](Archive& a) { describe_critical_points(a, points); });
  return points;
}

void write_critical_points(const std::string& path, const CriticalPoints& points) {
  CriticalPoints copy = points;
  write_json_stage(path, critical_points_version, points.provenance,
                   [&](Archive& a) { describe_critical_points(a, copy); });
}

}  // namespace quadrille
