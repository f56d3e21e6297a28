#include "stage/quadexport.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "base/child_process.hpp"
#include "base/error.hpp"
#include "base/options.hpp"
#include "base/warning_codes.hpp"
#include "check/check.hpp"
#include "export/format_table.hpp"
#include "export/step_request.hpp"
#include "export/translate.hpp"
#include "stage/solver_check.hpp"

namespace quadrille::stage {

namespace {

constexpr const char* step = "step";

bool ends_with(const std::string& text, const std::string& ending) {
  return text.size() > ending.size() && text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

// The name of the format, of the name of a file if none is asked for.
std::string chosen_format(const std::string& output, const std::string& asked) {
  if (asked != "auto") return asked;
  if (output == "-") return "msh";
  if (ends_with(output, ".step") || ends_with(output, ".stp")) return "step";
  if (const exports::ExportFormat* format = exports::export_format_of(output)) return std::string(format->name);
  std::string endings = ".step";
  for (const exports::ExportFormat& format : exports::export_formats())
    if (!format.ending.empty() && endings.find(format.ending) == std::string::npos)
      endings += fmt::format(" {}", format.ending);
  throw UsageError(
      fmt::format("the name {} does not determine the format: end it in one of {} or give --format", output, endings));
}

/// `output` with another ending: half_disc.vtu -> half_disc.curves.vtu.
std::string beside(const std::string& output, const std::string& ending) {
  const std::size_t slash = output.rfind('/'), dot = output.rfind('.');
  const bool has_ending = dot != std::string::npos && dot > 0 && (slash == std::string::npos || dot > slash + 1);
  return output.substr(0, has_ending ? dot : output.size()) + ending;
}

std::string path_of(const exports::SideName& side, const std::string& output) {
  if (side.is_whole) return output.substr(0, output.rfind('/') + 1) + side.ending;
  return side.is_appended ? output + side.ending : beside(output, side.ending);
}

/// A message in which files beside the main one have their paths in place of * and their endings.
std::string with_paths(std::string text, const std::vector<exports::SideFile>& sides, const std::string& output) {
  for (const exports::SideFile& side : sides)
    if (const std::size_t at = text.find('*' + side.name.ending); at != std::string::npos)
      text.replace(at, 1 + side.name.ending.size(), path_of(side.name, output));
  return text;
}

/// Standard output, a pipe or a device: no side file can be written beside it.
bool takes_one_file(const std::string& output) {
  std::error_code ignored;
  const std::filesystem::file_status there = std::filesystem::status(output, ignored);
  return output == "-" || (std::filesystem::exists(there) && !std::filesystem::is_regular_file(there));
}

/// "metre" or, if that is not known, "an unknown unit"
std::string unit_text(const LengthScale& length) {
  return length.unit.empty() || length.unit == "unknown" ? "an unknown unit" : length.unit;
}

void report_length(const LengthScale& length, Run& run) {
  run.report().set("unit", length.unit);
  run.report().set("scale", length.factor);
  run.info(fmt::format(
      "coordinates in {}, {}", unit_text(length),
      length.factor == 1 ? "as in the CAD file" : fmt::format("{} times those of the CAD file", length.factor)));
}

/// Refuses a mesh that is marked as not valid, unless --allow-invalid is given.
template <typename Mesh>
void require_valid_mesh(const Mesh& mesh, bool allow_invalid, Run& run) {
  const std::string warning_text = check::validity_warning(mesh);
  if (warning_text.empty()) return;
  if (!allow_invalid) throw ComputeError(warning_text + ": give --allow-invalid to export it");
  run.report().warn(warning::mesh_not_valid, warning_text);
}

/// A line for each format: "msh: Gmsh MSH 4.1, ASCII, orders 1 to 10, hexahedra 1 to 9".
std::string format_help() {
  std::string text = "format of the file\nauto: from the ending of the output";
  for (const exports::ExportFormat& f : exports::export_formats()) {
    text += fmt::format("\n{}: {}, orders 1 to {}", f.name, f.summary, f.max_order);
    if (f.write_hex == nullptr) continue;
    text += f.max_hex_order == f.max_order ? ", hexahedra too" : fmt::format(", hexahedra 1 to {}", f.max_hex_order);
  }
  return text + fmt::format("\n{}: CAD model of the blocks", step);
}

std::vector<std::string> unit_choices() {
  std::vector<std::string> choices{"file"};
  for (const LengthUnit& unit : length_units) choices.emplace_back(unit.symbol);
  return choices;
}

exports::ExportOptions parsed(const QuadexportOptions& options) {
  return {options.length, options.frame == "3d", exports::patch_type_options(options.patch_types), options.block_groups,
          options.merge_blocks};
}

// The row of --check-for; nullptr: none. Throws UsageError for a name that is not in the table.
const SolverRow* checked_solver(const QuadexportOptions& options) {
  if (options.check_for == "none") return nullptr;
  const SolverRow* solver = find_solver(options.check_for);
  if (solver == nullptr) throw UsageError(fmt::format("--check-for: {} is not known", options.check_for));
  return solver;
}

void require_order_of_solver(const QuadexportOptions& options, ElementKind kind, int order) {
  const SolverRow* const solver = checked_solver(options);
  if (solver == nullptr) return;
  if (const std::string refusal = order_refusal(*solver, kind, order); !refusal.empty()) throw UsageError(refusal);
}

const CadFace& lengths_of(const QuadMesh& mesh) { return mesh.face; }
const HexMesh& lengths_of(const HexMesh& mesh) { return mesh; }

template <typename Mesh>
void check_for(const Mesh& mesh, const exports::ExportFormat& format, const QuadexportOptions& options, Run& run) {
  const SolverRow* const solver = checked_solver(options);
  if (solver == nullptr) return;
  run.begin_phase("check");
  const exports::ExportOptions parsed_options = parsed(options);
  check_for_solver(
      mesh, {*solver, format, parsed_options.patch_types, length_scale(lengths_of(mesh), parsed_options.length).factor},
      run);
}

// The files beside the main one, and warnings of what is lost.
std::vector<OutputFile> side_files(exports::Exported& exported, const std::string& output, Report& report) {
  const bool takes_one = takes_one_file(output);
  for (const std::string& loss : exported.losses)
    report.warn(warning::format_loss, takes_one ? loss : with_paths(loss, exported.side_files, output));
  std::vector<OutputFile> files;
  for (exports::SideFile& side : exported.side_files)
    if (takes_one)
      report.warn(warning::side_file_not_written,
                  fmt::format("*{} is not written: {} can contain one file only", side.name.ending,
                              output == "-" ? "standard output" : output));
    else
      files.push_back({path_of(side.name, output), std::move(side.bytes), side.is_binary});
  return files;
}

void warn_of_trixi(const std::string& output, const std::string& format, const QuadexportOptions& options, Run& run) {
  if (options.format == "auto" && format == "inp")
    run.report().warn(warning::ending_of_trixi,
                      fmt::format("{} is written for Trixi.jl, as --format inp: for Abaqus and CalculiX give --format "
                                  "abaqus",
                                  output));
}

/// `elements`: what its elements are called in the report.
template <typename Mesh>
std::vector<OutputFile> exported_files(Mesh mesh, const char* elements, const std::string& file,
                                       const std::string& output, const QuadexportOptions& options, Run& run) {
  require_intervals(options);
  const std::string format = format_of(output, options);
  if (format == step) throw UsageError("a STEP model is made from blocks, not from a mesh");
  check::require_sound(mesh, file);
  require_valid_mesh(mesh, options.allow_invalid, run);
  warn_of_trixi(output, format, options, run);
  const exports::ExportFormat& row = *exports::find_export_format(format);
  check_for(mesh, row, options, run);
  run.begin_phase("write");
  run.report().set("format", format);
  run.report().set(elements, mesh.num_elems());
  run.report().set("nodes", mesh.nodes.size());
  const exports::ExportOptions parsed_options = parsed(options);
  exports::translate(mesh, exports::parse_translation(options.translation), parsed_options.in_space);
  exports::Exported exported = exports::export_mesh(std::move(mesh), row, parsed_options);
  if (!row.program.empty())
    exported.bytes =
        run_program(helper_program(std::string(row.program)), exported.bytes,
                    fmt::format("{}: the file cannot be made: {} crashed or did not end", file, row.program));
  report_length(exported.length, run);
  std::vector<OutputFile> files = side_files(exported, output, run.report());
  files.push_back({output, std::move(exported.bytes), exported.is_binary});
  return files;
}

}  // namespace

void declare(Options& o, QuadexportOptions& quadexport) {
  std::vector<std::string> formats{"auto"};
  for (const exports::ExportFormat& format : exports::export_formats()) formats.emplace_back(format.name);
  formats.emplace_back(step);
  o.choice("--format", quadexport.format, formats, format_help());
  o.choice("--frame", quadexport.frame, {"2d", "3d"},
           "2d: coordinates in the plane of the face; 3d: coordinates of the CAD model");
  o.texts("--patch-type", quadexport.patch_types, "NAME=TYPE",
          "type of the OpenFOAM patches whose name fits NAME, with the wild cards * and ?: patch, wall, symmetryPlane, "
          "symmetry, empty or wedge; the last one that fits decides; without it names that begin with wall, symmetry "
          "or empty decide, and the rest is patch");
  o.text("--translate", quadexport.translation, "X,Y[,Z]",
         "add this to the coordinates, in the unit of the CAD file, before --unit and --scale: X,Y in the plane of the "
         "face, also with Z in the space of --frame 3d, curved faces and hexahedra");
  o.choice("--unit", quadexport.length.unit, unit_choices(),
           "length unit of the written coordinates; file: that of the CAD file, whose numbers are kept");
  o.optional_number(
      "--scale", quadexport.length.scale, 1e-12, 1e12, "factor",
      "multiply the coordinates by this, after --unit; without --unit, the unit of the result counts as unknown, "
      "also with 1 (for .step: a larger model in the unit of the CAD file)");
  o.flag("--block-groups", quadexport.block_groups,
         "write each block that has no name of its own as a region of its own, named by its number; without it all "
         "blocks without a name are one region (for .step: the name of a face is its region)");
  o.flag("--merge-blocks", quadexport.merge_blocks,
         "join blocks of one region to the fewest rectangular grids, none of which touches itself: for structured "
         "solvers (plot3d, cgns-structured)");
  std::vector<std::string> solvers{"none"};
  for (const SolverRow& solver : solver_rows()) solvers.emplace_back(solver.name);
  o.choice("--check-for", quadexport.check_for, solvers,
           "measure the mesh as this program has it that reads the file, by the program's own measures: warn, or write "
           "no file, where one reaches the program's limit; the file is the same");
  o.flag("--allow-invalid", quadexport.allow_invalid, "export a mesh that is marked as not valid");
}

std::string format_of(const std::string& output, const QuadexportOptions& options) {
  std::string name = chosen_format(output, options.format);
  const exports::ExportOptions parsed_options = parsed(options);
  if (name != step) {
    const exports::ExportFormat* format = exports::find_export_format(name);
    if (format == nullptr) throw UsageError(fmt::format("--format: there is no format {}", name));
    exports::require_options(*format, parsed_options);
  } else if (!parsed_options.patch_types.empty()) {
    throw UsageError("--patch-type: a STEP model has no types of boundaries");
  } else if (options.merge_blocks) {
    throw UsageError("--merge-blocks: a STEP model is made from the blocks themselves");
  } else if (!options.translation.empty()) {
    throw UsageError("--translate: a STEP model lies where the CAD file has it");
  }
  exports::parse_translation(options.translation);
  if (const SolverRow* const solver = checked_solver(options)) require_format_of_solver(*solver, name);
  return name;
}

std::vector<std::string> side_paths(const std::string& output, const QuadexportOptions& options) {
  const exports::ExportFormat* format = exports::find_export_format(format_of(output, options));
  std::vector<std::string> paths;
  if (format == nullptr || takes_one_file(output)) return paths;
  for (const exports::SideName& side : format->side_names) paths.push_back(path_of(side, output));
  return paths;
}

bool has_straight_sides(const std::string& format) {
  const exports::ExportFormat* row = exports::find_export_format(format);
  return row != nullptr && row->has_straight_sides;
}

void require_order(const std::string& format, int order, const QuadexportOptions& options) {
  const exports::ExportFormat* row = exports::find_export_format(format);
  if (row != nullptr && order > row->max_order)
    throw UsageError(
        fmt::format("--order {}: the format {} supports quads up to order {}", order, format, row->max_order));
  require_order_of_solver(options, ElementKind::quads, order);
}

void require_hexahedra(const std::string& format, int order, const QuadexportOptions& options) {
  const exports::ExportFormat* row = exports::find_export_format(format);
  if (row == nullptr) throw UsageError("--sweep: a STEP model is made from blocks, not from hexahedra");
  exports::require_hex_options(*row, parsed(options));
  if (order > row->max_hex_order)
    throw UsageError(
        fmt::format("--order {}: the format {} supports hexahedra up to order {}", order, format, row->max_hex_order));
  require_order_of_solver(options, ElementKind::hexahedra, order);
}

void require_format_in_space(const std::string& format) {
  const exports::ExportFormat* row = exports::find_export_format(format);
  if (row != nullptr && !row->holds_space) throw UsageError(exports::planar_format_text(*row));
}

void require_quadexport_of(const CadFace& face, const std::string& output, const QuadexportOptions& options) {
  require_intervals(options);
  if (face.chart) require_format_in_space(format_of(output, options));
  exports::require_translation(exports::parse_translation(options.translation), options.frame == "3d" || face.chart);
  length_scale(face, options.length);
  exports::require_boundaries(face.curve_names, parsed(options).patch_types);
}

std::vector<OutputFile> quadexport(QuadMesh mesh, const std::string& file, const std::string& output,
                                   const QuadexportOptions& options, Run& run) {
  return exported_files(std::move(mesh), "quads", file, output, options, run);
}

std::vector<OutputFile> quadexport(HexMesh mesh, const std::string& file, const std::string& output,
                                   const QuadexportOptions& options, Run& run) {
  return exported_files(std::move(mesh), "hexahedra", file, output, options, run);
}

OutputFile quadexport_step(const Input<std::string>& blocks, const std::string& output,
                           const QuadexportOptions& options, Run& run) {
  require_intervals(options);
  if (format_of(output, options) != step) throw UsageError("blocks are exported as a STEP model only: --format step");
  run.begin_phase("write");
  const std::string request =
      exports::to_bytes(exports::StepRequest{blocks.file.name, blocks.model, options.length, options.block_groups});
  exports::StepModel model = exports::step_model(
      run_program(helper_program("quadexport-step"), request,
                  blocks.file.name + ": the STEP model cannot be made: its writer crashed or did not end"));
  run.report().set("format", step);
  run.report().set("blocks", model.num_blocks);
  report_length(model.length, run);
  return {output, std::move(model.bytes), false};
}

}  // namespace quadrille::stage
