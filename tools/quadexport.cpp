// Writes a quad mesh, or the blocks it was made from, in the formats of other programs.

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>

#include "base/child_process.hpp"
#include "base/error.hpp"
#include "base/warning_codes.hpp"
#include "check/check.hpp"
#include "cli/tool_main.hpp"
#include "export/format_table.hpp"
#include "io/output_file.hpp"
#include "io/stage_files.hpp"

using namespace quadrille;

namespace {

bool ends_with(const std::string& text, const std::string& ending) {
  return text.size() > ending.size() && text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

std::string format_of(const std::string& output, const std::string& wish) {
  if (wish != "auto") return wish;
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

/// The output of the helper until it ends.
std::string read_all(int fd) {
  std::string said;
  std::array<char, 4096> buffer{};
  for (;;) {
    const ssize_t count = read(fd, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return said;
    said.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

/// Runs the helper with these words, its name first; it inherits standard input and output. Returns what it writes to
/// standard error. Its message and exit code are passed on.
std::string run_helper(std::vector<std::string> words) {
  const std::string& helper = words.front();
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  std::array<int, 2> ends{};
  const pid_t child = pipe2(ends.data(), O_CLOEXEC) == 0 ? fork() : -1;
  if (child < 0) throw OutputError(fmt::format("{} cannot be run: {}", helper, std::strerror(errno)));
  if (child == 0) {
    prctl(PR_SET_PDEATHSIG, SIGTERM);  // the writer must end too if a signal ends this process alone
    dup2(ends[1], STDERR_FILENO);
    execv(helper.c_str(), argv.data());
    fmt::print(stderr, "{} cannot be run: {}\n", helper, std::strerror(errno));
    std::fflush(stderr);
    _exit(static_cast<int>(ExitCode::defect));
  }
  close(ends[1]);
  std::string said = read_all(ends[0]);
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status)) throw Defect(fmt::format("the STEP writer was ended by signal {}", WTERMSIG(status)));
  if (WEXITSTATUS(status) == 0) return said;
  if (const std::string name = "quadexport: "; said.starts_with(name)) said.erase(0, name.size());
  throw Error(static_cast<ExitCode>(WEXITSTATUS(status)), said.substr(0, said.find('\n')));
}

/// `output` with another ending: half_disc.vtu -> half_disc.curves.vtu.
std::string beside(const std::string& output, const std::string& ending) {
  const std::size_t slash = output.rfind('/'), dot = output.rfind('.');
  const bool has_ending = dot != std::string::npos && dot > 0 && (slash == std::string::npos || dot > slash + 1);
  return output.substr(0, has_ending ? dot : output.size()) + ending;
}

std::string path_of(const exports::SideFile& side, const std::string& output) {
  return side.is_appended ? output + side.ending : beside(output, side.ending);
}

/// A message in which files beside the main one have their paths in place of * and their endings.
std::string with_paths(std::string text, const std::vector<exports::SideFile>& sides, const std::string& output) {
  for (const exports::SideFile& side : sides)
    if (const std::size_t at = text.find('*' + side.ending); at != std::string::npos)
      text.replace(at, 1 + side.ending.size(), path_of(side, output));
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

void report_length(const LengthScale& length, cli::Session& s) {
  s.report().set("unit", length.unit);
  s.report().set("scale", length.factor);
  s.info(fmt::format(
      "coordinates in {}, {}", unit_text(length),
      length.factor == 1 ? "as in the CAD file" : fmt::format("{} times those of the CAD file", length.factor)));
}

void write_step(const std::string& input, const std::string& output, const exports::ExportOptions& options,
                cli::Session& s) {
  s.begin_phase("write");
  const ScaleRequest& request = options.length;
  std::vector<std::string> words{
      helper_program("quadexport-step"), input, "-o", output, "--unit", request.unit, "--scale",
      fmt::format("{}", request.scale)};
  if (options.block_groups) words.emplace_back("--block-groups");
  const std::string said_all = run_helper(words);
  const std::size_t last = said_all.rfind('\n', said_all.empty() ? 0 : said_all.size() - 2) + 1;  // npos + 1 is 0
  fmt::print(stderr, "{}", said_all.substr(0, last));
  std::istringstream said(said_all.substr(last));
  std::size_t blocks = 0;
  LengthScale length;
  if (!(said >> blocks >> length.factor)) throw Defect("the STEP writer does not state what it wrote");
  std::getline(said >> std::ws, length.unit);  // a damaged file may name none
  s.report().set("format", "step");
  s.report().set("blocks", blocks);
  report_length(length, s);
  s.end_phase();
}

/// Refuses a mesh that is marked as not valid, unless --allow-invalid is given.
void require_valid_mesh(const QuadMesh& mesh, bool allow_invalid, cli::Session& s) {
  const std::string warning_text = check::validity_warning(mesh);
  if (warning_text.empty()) return;
  if (!allow_invalid) throw ComputeError(warning_text + ": give --allow-invalid to export it");
  s.report().warn(warning::mesh_not_valid, warning_text);
}

void write_mesh(const std::string& input, const std::string& output, const std::string& format_name,
                const exports::ExportOptions& options, bool allow_invalid, cli::Session& s) {
  s.begin_phase("read");
  const io::InputFile file = io::read_input(input);
  QuadMesh mesh = io::read_quad_mesh(file);
  check::require_valid(check::check_quad_mesh(mesh, check::CheckDepth::quick), file.name);
  require_valid_mesh(mesh, allow_invalid, s);
  s.begin_phase("write");
  s.report().set("format", format_name);
  s.report().set("quads", mesh.num_elems());
  s.report().set("nodes", mesh.nodes.size());
  const exports::Exported exported =
      exports::export_mesh(std::move(mesh), *exports::find_export_format(format_name), options);
  report_length(exported.length, s);
  for (const std::string& loss : exported.losses)
    s.report().warn(warning::format_loss,
                    takes_one_file(output) ? loss : with_paths(loss, exported.side_files, output));
  for (const exports::SideFile& side : exported.side_files) {
    if (takes_one_file(output))
      s.report().warn(warning::side_file_not_written,
                      fmt::format("*{} is not written: {} can contain one file only", side.ending,
                                  output == "-" ? "standard output" : output));
    else
      io::write_output(path_of(side, output), side.bytes, side.is_binary);
  }
  io::write_output(output, exported.bytes, exported.is_binary);
  s.end_phase();
}

/// Before there is a mesh.
void require_order(const exports::ExportFormat& format, const std::string& mesh_order) {
  if (std::atoi(mesh_order.c_str()) > format.max_order)
    throw UsageError(fmt::format("--order {}: the format {} supports quads up to order {}", mesh_order, format.name,
                                 format.max_order));
}

/// What the options ask of the shape, before there is a mesh.
void check_shape(const CadFace& face, const exports::ExportOptions& options) {
  length_scale(face, options.length);
  exports::require_boundaries(face.curve_names, options.patch_types);
}

/// "msh: Gmsh MSH 4.1, ASCII, orders 1 to 10; ..."
std::string format_list() {
  std::string list;
  for (const exports::ExportFormat& f : exports::export_formats())
    list += fmt::format("{}{}: {}, orders 1 to {}", list.empty() ? "" : "; ", f.name, f.summary, f.max_order);
  return list;
}

std::vector<std::string> unit_choices() {
  std::vector<std::string> choices{"file"};
  for (const LengthUnit& unit : length_units) choices.emplace_back(unit.symbol);
  return choices;
}

}  // namespace

int main(int argc, char** argv) {
  std::string input = "-", output = "-", format = "auto", frame = "2d";
  std::string shape;       // of --check-shape
  std::string mesh_order;  // of the mesh that a pipeline is going to make
  bool allow_invalid = false;
  exports::ExportOptions options;
  std::vector<std::string> patch_types, formats{"auto"};
  for (const exports::ExportFormat& f : exports::export_formats()) formats.emplace_back(f.name);
  formats.emplace_back("step");
  cli::Tool tool;
  tool.name = "quadexport";
  tool.summary = "writes a mesh or its blocks for other programs";
  tool.description =
      "Writes a quad mesh in the format of a solver, with the names of boundaries and blocks and with the nodes that "
      "the format defines. What the format cannot represent is reported on standard error, with the magnitude of the "
      "loss. A block layout is written as a STEP model of faces that share their edges and have the names of their "
      "regions. The format follows from the "
      "ending of the output, or from --format; standard output is MSH by default. Formats: " +
      format_list() + ".";
  tool.examples = {"quadexport half_disc.quad.h5 -o half_disc.msh",
                   "quadrefine half_disc.blocks.h5 | quadexport -o half_disc.msh",
                   "quadexport --unit m half_disc.quad.h5 -o half_disc.xml",
                   "quadexport half_disc.blocks.h5 -o half_disc.blocks.step"};
  tool.options = [&](Options& o) {
    o.input("INPUT", input, "quad mesh (x.quad.h5); for .step a block layout (x.blocks.h5)");
    o.output(output, "file to write");
    o.choice("--format", format, formats, "auto: from the ending of the output");
    o.choice("--frame", frame, {"2d", "3d"},
             "2d: coordinates in the plane of the face; 3d: coordinates of the CAD model");
    o.texts(
        "--patch-type", patch_types, "NAME=TYPE",
        "type of the OpenFOAM patches whose name fits NAME, with the wild cards * and ?: patch, wall, symmetryPlane, "
        "symmetry, empty or wedge; the last one that fits decides; without it names that begin "
        "with wall, symmetry or empty decide, and the rest is patch");
    o.choice("--unit", options.length.unit, unit_choices(),
             "length unit of the written coordinates; file: that of the CAD file, whose numbers are kept");
    o.number("--scale", options.length.scale, 1e-12, 1e12, "factor",
             "multiply the coordinates by this, after --unit; without --unit, the unit of the result counts as unknown "
             "(for .step: a larger model in the unit of the CAD file)");
    o.flag("--block-groups", options.block_groups,
           "write each block that has no name of its own as a region of its own, named by its number; without it all "
           "blocks without a name are one region (for .step: the name of a face is its region)");
    o.hidden_text("--check-shape", shape);
    o.hidden_text("--mesh-order", mesh_order);
    o.flag("--allow-invalid", allow_invalid, "export a mesh that is marked as not valid");
  };
  tool.run = [&](cli::Session& s) {
    const std::string name = format_of(output, format);
    options.patch_types = exports::patch_type_options(patch_types);
    options.in_space = frame == "3d";
    const bool is_step = name == "step";
    if (is_step && !options.patch_types.empty())
      throw UsageError("--patch-type: a STEP model has no types of boundaries");
    if (!is_step) exports::require_options(*exports::find_export_format(name), options);
    if (!is_step && !mesh_order.empty()) require_order(*exports::find_export_format(name), mesh_order);
    if (!shape.empty()) return check_shape(io::read_face(io::read_input(shape)), options);
    if (is_step)
      write_step(input, output, options, s);
    else
      write_mesh(input, output, name, options, allow_invalid, s);
  };
  tool.report_writer = io::write_report;
  return cli::tool_main(argc, argv, tool);
}
