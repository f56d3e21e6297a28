#include "cad/load_face.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/child_process.hpp"
#include "base/error.hpp"
#include "base/warning_codes.hpp"
#include "cad/file_kind.hpp"
#include "cad/loaded_face.hpp"

namespace quadrille::cad {

namespace {

// Time limit of the program; a face with thousands of edges takes less than a second.
constexpr int most_seconds = 60;

// What the program of the format answers.
std::string answer(CadFormat format, const CadRequest& request, const std::string& crash) {
  const std::string stem = request.options.section.is_given() ? "section" : format_stem(format);
  return run_program(helper_program("cad2tri-" + stem), to_bytes(request), crash, {.cpu_seconds = most_seconds});
}

// The answer about a file, with the fault of the file in the error after a crash.
std::string answer_about_file(const CadRequest& request) {
  const CadFormat format = cad_format(request.bytes, request.name);
  const std::string crash =
      request.name + ": the file is malformed: the " + format_name(format) + " reader crashed or did not end";
  try {
    return answer(format, request, crash);
  } catch (const FormatError& e) {
    // After a crash of the reader, search the file for an error that the user can correct.
    const std::string fault =
        e.what() == crash && format == CadFormat::step ? step_fault(request.bytes) : std::string();
    if (fault.empty()) throw;
    throw FormatError(request.name + ": the file is malformed: " + fault);
  }
}

}  // namespace

LoadedFace load_face_guarded(const std::string& bytes, const std::string& name, const LoadOptions& options,
                             Report& report) {
  return from_bytes(answer_about_file({CadTask::load, name, bytes, options, CadFace()}), report);
}

SpaceFace load_space_face_guarded(const std::string& bytes, const std::string& name, const LoadOptions& options,
                                  Report& report) {
  return space_face_from_bytes(answer_about_file({CadTask::load_space, name, bytes, options, CadFace()}), report);
}

AnyFace load_any_face_guarded(const std::string& bytes, const std::string& name, const LoadOptions& options,
                              Report& report) {
  return any_face_from_bytes(answer_about_file({CadTask::load_any, name, bytes, options, CadFace()}), report);
}

std::string face_kind_guarded(const std::string& bytes, const std::string& name, const std::string& face) {
  LoadOptions options;
  options.face = face;
  return answer_about_file({CadTask::kind, name, bytes, options, CadFace()});
}

FaceList list_faces_guarded(const std::string& bytes, const std::string& name, const SectionPlane& section) {
  LoadOptions options;
  options.section = section;
  return list_from_bytes(answer_about_file({CadTask::list, name, bytes, options, CadFace()}));
}

std::string file_of_face(const CadFace& face, CadFormat format) {
  CadRequest request;
  request.task = CadTask::write;
  request.face = face;
  return answer(format, request,
                "the face cannot be written: the " + format_name(format) + " writer crashed or did not end");
}

namespace {

using Row = std::array<std::string, 9>;

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
  return {face, edge, shape.kind, fmt::format("{:.6g}", shape.length), place_text(shape.place, noise), shape.name,
          "",   "",   ""};
}

Row face_row(int number, const ListedFace& listed, double noise) {
  Row cells = row(std::to_string(number), "", listed.face, noise);
  cells[6] = listed.part, cells[7] = listed.layer, cells[8] = listed.size;
  if (listed.is_closed) cells[8] += fmt::format("{}closed: cut it to mesh it", listed.size.empty() ? "" : ", ");
  return cells;
}

std::vector<Row> rows_of(const FaceList& list, const std::function<bool(const ListedFace&)>& shows) {
  const double noise = 1e-12 * greatest_coordinate(list);
  std::vector<Row> rows{{"face", "edge", "kind", "length", "place", "name", "part", "layer", ""}};
  for (size_t f = 0; f < list.faces.size(); ++f) {
    if (!shows(list.faces[f])) continue;
    rows.push_back(face_row(static_cast<int>(f), list.faces[f], noise));
    for (size_t e = 0; e < list.faces[f].edges.size(); ++e)
      rows.push_back(row("", std::to_string(e), list.faces[f].edges[e], noise));
  }
  // Planar faces have no such column.
  if (std::any_of(rows.begin(), rows.end(), [](const Row& cells) { return !cells.back().empty(); }))
    rows.front().back() = "surface";
  return rows;
}

void report_shape(const std::string& key, const ListedShape& shape, Report& report) {
  report.set(key + "name", shape.name);
  report.set(key + "kind", shape.kind);
  report.set(key + "length", shape.length);
  report.set(key + "place", std::vector<double>(shape.place.begin(), shape.place.end()));
}

constexpr size_t most_named = 20;  // in the warning

std::string not_built_text(const std::vector<std::string>& entities) {
  const auto shown = static_cast<long>(std::min(entities.size(), most_named));
  const std::string rest = entities.size() > most_named ? fmt::format(" and {} more", entities.size() - shown) : "";
  const bool is_one = entities.size() == 1;
  return fmt::format("{} not listed, because the CAD kernel could not build {}: {}{}: repair or export {} again",
                     is_one ? "1 face is" : fmt::format("{} faces are", entities.size()), is_one ? "it" : "them",
                     fmt::join(entities.begin(), entities.begin() + shown, ", "), rest, is_one ? "it" : "them");
}

}  // namespace

std::string face_table(const FaceList& list, const std::function<bool(const ListedFace&)>& shows) {
  const std::vector<Row> rows = rows_of(list, shows);
  std::array<size_t, 9> widths{};
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
  report.set("list.not_built", list.not_built.size());
  if (!list.not_built.empty()) report.warn(warning::faces_not_built, not_built_text(list.not_built));
  for (size_t f = 0; f < list.faces.size(); ++f) {
    const std::string key = fmt::format("list.face.{}.", f);
    report_shape(key, list.faces[f].face, report);
    report.set(key + "part", list.faces[f].part);
    report.set(key + "layer", list.faces[f].layer);
    report.set(key + "size", list.faces[f].size);
    report.set(key + "closed", list.faces[f].is_closed);
    report.set(key + "edges", list.faces[f].edges.size());
    for (size_t e = 0; e < list.faces[f].edges.size(); ++e)
      report_shape(fmt::format("{}edge.{}.", key, e), list.faces[f].edges[e], report);
  }
}

}  // namespace quadrille::cad
