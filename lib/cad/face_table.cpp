#include "cad/face_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace quadrille::cad {
namespace {

using Row = std::array<std::string, 6>;

double greatest_coordinate(const FaceList& list) {
  double greatest = 0;
  for (const ListedFace& face : list.faces)
    for (const double x : face.face.place) greatest = std::max({greatest, std::abs(x), face.face.length});
  return greatest;
}

// Coordinates below `noise` are rounding errors of a placement and are shown as 0.
std::string place_text(std::array<double, 3> place, double noise) {
  for (double& x : place) x = std::abs(x) <= noise ? 0 : x;
  return fmt::format("({:.6g})", fmt::join(place, ", "));
}

Row row(const std::string& face, const std::string& edge, const ListedShape& shape, double noise) {
  return {face, edge, shape.kind, fmt::format("{:.6g}", shape.length), place_text(shape.place, noise), shape.name};
}

std::vector<Row> rows_of(const FaceList& list) {
  const double noise = 1e-12 * greatest_coordinate(list);
  std::vector<Row> rows{{"face", "edge", "kind", "length", "place", "name"}};
  for (size_t f = 0; f < list.faces.size(); ++f) {
    rows.push_back(row(std::to_string(f), "", list.faces[f].face, noise));
    for (size_t e = 0; e < list.faces[f].edges.size(); ++e)
      rows.push_back(row("", std::to_string(e), list.faces[f].edges[e], noise));
  }
  return rows;
}

void report_shape(const std::string& key, const ListedShape& shape, Report& report) {
  report.set(key + "name", shape.name);
  report.set(key + "kind", shape.kind);
  report.set(key + "length", shape.length);
  report.set(key + "place", std::vector<double>(shape.place.begin(), shape.place.end()));
}

}  // namespace

std::string face_table(const FaceList& list) {
  const std::vector<Row> rows = rows_of(list);
  std::array<size_t, 6> widths{};
  for (const Row& cells : rows)
    for (size_t i = 0; i < cells.size(); ++i) widths[i] = std::max(widths[i], cells[i].size());
  std::string table;
  for (const Row& cells : rows) {
    std::string line;
    for (size_t i = 0; i + 1 < cells.size(); ++i) line += fmt::format("{:<{}}  ", cells[i], widths[i]);
    line += cells.back();
    line.erase(line.find_last_not_of(' ') + 1);
    table += line + "\n";
  }
  return table;
}

void report_faces(const FaceList& list, Report& report) {
  report.set("list.length_unit", list.length_unit);
  report.set("list.faces", list.faces.size());
  for (size_t f = 0; f < list.faces.size(); ++f) {
    const std::string key = fmt::format("list.face.{}.", f);
    report_shape(key, list.faces[f].face, report);
    report.set(key + "edges", list.faces[f].edges.size());
    for (size_t e = 0; e < list.faces[f].edges.size(); ++e)
      report_shape(fmt::format("{}edge.{}.", key, e), list.faces[f].edges[e], report);
  }
}

}  // namespace quadrille::cad
