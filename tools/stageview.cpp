// stageview: draws a picture of any stage file, or a page of several.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "base/error.hpp"
#include "base/warning_codes.hpp"
#include "check/check.hpp"
#include "check/same_origin.hpp"
#include "cli/tool_main.hpp"
#include "draw/comparison.hpp"
#include "draw/draw.hpp"
#include "io/converted_picture.hpp"
#include "io/history.hpp"
#include "io/output_file.hpp"
#include "io/stage_files.hpp"
#include "page/page.hpp"

namespace quadrille {
namespace {

struct Settings {
  std::vector<std::string> inputs;
  std::string field, output, window, run_report;
  bool is_comparison = false, labels_all = false, labels_none = false;
  draw::DrawOptions draw;
};

/// "X0,Y0,X1,Y1".
draw::Window parsed_window(const std::string& text) {
  std::array<double, 4> numbers{};
  const char* at = text.c_str();
  bool is_sound = true;
  for (std::size_t k = 0; k < 4 && is_sound; ++k) {
    char* end = nullptr;
    numbers[k] = std::strtod(at, &end);
    is_sound = end != at && std::isfinite(numbers[k]) && *end == (k < 3 ? ',' : '\0');
    at = end + 1;
  }
  if (!is_sound || !(numbers[0] < numbers[2]) || !(numbers[1] < numbers[3]))
    throw UsageError("--window: '" + text + "' is not X0,Y0,X1,Y1, two corners with X0 < X1 and Y0 < Y1");
  return {{numbers[0], numbers[1]}, {numbers[2], numbers[3]}};
}

/// The struct of a stage file after its quick checks.
StageModel read_stage(const io::InputFile& file, cli::Session& session) {
  StageModel stage = io::read_any_stage(file);
  std::visit([&](const auto& model) { check::require_sound(model, file.name); }, stage);
  if (const auto* mesh = std::get_if<QuadMesh>(&stage); mesh && !mesh->is_valid)
    session.report().warn(warning::mesh_not_valid, check::validity_warning(*mesh));
  return stage;
}

const Provenance& provenance_of(const StageModel& stage) {
  return std::visit([](const auto& model) -> const Provenance& { return model.provenance; }, stage);
}

/// A stage with the file that it was read from.
struct Read {
  io::InputFile file;
  StageModel stage;
};

/// Reads a file that was made from one of `others`, or one of them from it.
Read read_related(const std::string& path, const std::vector<Read>& others, cli::Session& session) {
  io::InputFile file = io::read_input(path);
  StageModel stage = read_stage(file, session);
  const auto is_related = [&](const Read& other) {
    return check::have_same_origin(other.file, provenance_of(other.stage), file, provenance_of(stage));
  };
  if (!others.empty() && std::none_of(others.begin(), others.end(), is_related))
    check::require_same_origin(others.back().file, provenance_of(others.back().stage), file, provenance_of(stage));
  file.bytes = {};
  return {std::move(file), std::move(stage)};
}

std::vector<Read> read_all(const Settings& settings, cli::Session& session) {
  std::vector<std::string> paths = settings.inputs;
  if (!settings.field.empty()) paths.insert(paths.begin(), settings.field);
  std::vector<Read> all;
  for (const std::string& path : paths) all.push_back(read_related(path, all, session));
  if (settings.field.empty() || std::holds_alternative<CriticalPoints>(all.back().stage)) return all;
  throw UsageError("--field needs a critical-points file, but " + all.back().file.name + " is another");
}

/// The name of a file without folders; empty for standard input.
std::string base_name(const std::string& path) {
  return path == "-" ? "" : std::filesystem::path(path).filename().string();
}

draw::DrawOptions draw_options(const Settings& settings) {
  draw::DrawOptions options = settings.draw;
  if (settings.labels_all) options.curve_labels = draw::CurveLabels::all;
  if (settings.labels_none) options.curve_labels = draw::CurveLabels::none;
  if (!settings.window.empty()) options.window = parsed_window(settings.window);
  return options;
}

/// The picture of the last of the files; with --field, the field is the first of two.
std::string picture_of(const std::vector<Read>& files, const Settings& settings) {
  const StageModel& stage = files.back().stage;
  draw::DrawOptions options = draw_options(settings);
  if (!settings.inputs.empty()) options.file = base_name(settings.inputs.back());
  options.field = std::get_if<Field>(&files.front().stage);
  return std::visit([&](const auto& model) { return draw::draw_stage(model, options); }, stage);
}

/// Whether a picture of two of them can be drawn.
bool is_comparable(const StageModel& stage) {
  return std::visit([]<typename Model>(const Model&) { return draw::Comparable<Model>; }, stage);
}

/// Two layouts or meshes; they need not be of one chain.
std::array<StageModel, 2> read_pair(const Settings& settings, cli::Session& session) {
  if (settings.inputs.size() != 2) throw UsageError("--compare needs two files, layouts or meshes");
  std::array<StageModel, 2> stages;
  for (std::size_t k = 0; k < 2; ++k) {
    const io::InputFile file = io::read_input(settings.inputs[k]);
    StageModel& stage = stages[k] = read_stage(file, session);
    if (!is_comparable(stage))
      throw UsageError("--compare needs layouts or meshes, but " + file.name + " is a " +
                       stage_formats[stage.index()].name + " file");
  }
  if (stages[0].index() != stages[1].index())
    throw UsageError("--compare needs two files of one format: two layouts, or two meshes");
  return stages;
}

std::string picture_of_pair(const std::array<StageModel, 2>& pair, const Settings& settings) {
  const auto drawn = [&]<typename Model>(const Model& first) -> std::string {
    if constexpr (draw::Comparable<Model>)
      return draw::draw_comparison<Model>({&first, &std::get<Model>(pair[1])},
                                          {base_name(settings.inputs[0]), base_name(settings.inputs[1])},
                                          draw_options(settings));
    else
      throw Defect("a picture of two files that read_pair refuses");
  };
  return std::visit(drawn, pair[0]);
}

/// The report with the commands by which the files were made, named after the last of them.
page::RunRecord run_of(const std::vector<Read>& files, const Settings& settings) {
  if (settings.run_report.empty()) return {};
  page::RunRecord run{io::read_report(settings.run_report), {}};
  io::History history;
  for (const Read& read : files)
    for (const std::string& line :
         history.lines_of(provenance_of(read.stage), read.file.sha256, io::history_stem(settings.inputs.back())))
      run.commands.push_back(line);
  return run;
}

std::string page_of(std::vector<Read> files, const Settings& settings) {
  const page::RunRecord run = run_of(files, settings);
  std::vector<StageModel> stages;
  for (Read& read : files) stages.push_back(std::move(read.stage));
  return page::html_page(stages, run);
}

/// What command line and names tell before a file is read.
void check_usage(const Settings& settings, bool is_page) {
  if (!is_page && !settings.is_comparison && settings.inputs.size() > 1)
    throw UsageError("several files are shown by a page only: give -o with a name that ends in .html");
  if (!settings.window.empty()) static_cast<void>(parsed_window(settings.window));
  if (!settings.window.empty() && is_page) throw UsageError("--window is for pictures: a page zooms by itself");
  if (settings.labels_all && settings.labels_none)
    throw UsageError("--curve-labels and --no-curve-labels exclude each other");
  if (!settings.run_report.empty() && (!is_page || settings.is_comparison))
    throw UsageError(
        "--run-report is for pages of one chain: give -o with a name that ends in .html, and no --compare");
  if (settings.is_comparison && !settings.field.empty()) throw UsageError("--compare and --field exclude each other");
}

/// The SVG or the HTML of what is asked for.
std::string drawn(const Settings& settings, bool is_page, cli::Session& session) {
  session.begin_phase("read");
  if (settings.is_comparison) {
    const std::array<StageModel, 2> pair = read_pair(settings, session);
    session.begin_phase("draw");
    return is_page ? page::comparison_page(pair[0], pair[1]) : picture_of_pair(pair, settings);
  }
  std::vector<Read> files = read_all(settings, session);
  const auto* points = std::get_if<CriticalPoints>(&files.back().stage);
  if (settings.labels_all && points && settings.field.empty() && points->face.curves.empty())
    throw UsageError("--curve-labels needs --field, as " + files.back().file.name + " does not contain the face");
  session.begin_phase("draw");
  return is_page ? page_of(std::move(files), settings) : picture_of(files, settings);
}

void run(const Settings& settings, cli::Session& session) {
  const std::string ending = io::picture_ending(settings.output);
  const bool is_page = ending == "html" || ending == "htm";
  check_usage(settings, is_page);
  const io::PictureFormat format = is_page ? io::PictureFormat::svg : io::picture_format(settings.output);
  const std::string text = drawn(settings, is_page, session);
  const std::string bytes = is_page ? text : io::converted_picture(text, format, settings.output);
  session.end_phase();
  io::write_output(settings.output, bytes, format != io::PictureFormat::svg);
}

}  // namespace
}  // namespace quadrille

int main(int argc, char** argv) {
  using namespace quadrille;
  Settings settings;
  cli::Tool tool;
  tool.name = "stageview";
  tool.summary = "draws any stage file: a picture (SVG, PNG, PDF) or a page that zooms (HTML)";
  tool.description =
      "The format of FILE is detected from its content: triangle mesh, guiding field, critical points, separatrices, "
      "blocks or quads. If the output ends in .html, it is a page for a browser, which needs no other file and no "
      "network: it moves and zooms, switches layers, shows number, size and quality of what is under the pointer and "
      "goes to the worst element; the key ? lists its keys. Several files of one chain become the tabs of one page. "
      "Any "
      "other output is a picture: PNG or PDF if its name ends so (made by the program rsvg-convert, which must be "
      "installed), else SVG, the ending of which may be left out. Critical points are drawn with error bars, clusters, "
      "changes and the cells of the "
      "certificate, over the field that --field names or, without it, in the outline of the face. The worst element or "
      "block is marked if its scaled Jacobian is below 0.5. In a browser, "
      "elements, blocks and points show their numbers and "
      "figures, and changes their reasons, under the mouse pointer.";
  tool.examples = {"stageview half_disc.quad.h5 -o half_disc.svg",
                   "stageview half_disc.field.h5 --show order -o orders.svg",
                   "stageview half_disc.tri.h5 --curve-labels -o curves.svg",
                   "stageview half_disc.blocks.h5 -o blocks.pdf",
                   "stageview half_disc.quad.h5 --window 0.5,0,1,0.5 -o corner.png",
                   "stageview half_disc.crit.json --field half_disc.field.h5 -o points.svg",
                   "stageview half_disc.sep.json half_disc.blocks.h5 half_disc.quad.h5 -o half_disc.html",
                   "stageview --compare half_disc.quad.h5 half_disc.quad.h5 --width 1400 -o both.svg"};
  tool.options = [&](Options& o) {
    o.inputs("FILE", settings.inputs, "a stage file; for a page also several, in the order of the chain");
    o.output(settings.output,
             "picture to write (SVG; PNG or PDF if the name ends in .png or .pdf), or page (if it ends in .html)");
    o.input_file("--field", settings.field, "FILE", "field to draw under critical points", false);
    o.flag(
        "--compare", settings.is_comparison,
        "two files of one format, separatrices, blocks or quads, which need not be of one chain: side by side at one "
        "scale (in a page also the lines of one over the other), with a table of counts and qualities");
    o.input_file(
        "--run-report", settings.run_report, "FILE",
        "in a page, a tab with this report of the run (quadmesh --report), histograms of the last mesh and the "
        "commands by which the files were made",
        false);
    o.choice("--show", settings.draw.show, {"psi", "u", "v", "order"},
             "quantity of a field to show in a picture: cross angle, a component or the polynomial order");
    o.flag("--curve-labels", settings.labels_all,
           "in a picture, write number and name beside each boundary curve, for cad2tri --name; without it, given "
           "names only, each once for successive curves that have it");
    o.flag("--no-curve-labels", settings.labels_none,
           "in a picture, do not write the names of boundary curves and regions");
    o.text(
        "--window", settings.window, "X0,Y0,X1,Y1",
        "the part of the plane that a picture shows: its lower left and upper right corner in the coordinates and the "
        "unit of the file",
        false);
    o.integer("--width", settings.draw.width, 200, 20000, "width of the picture in pixels");
  };
  tool.run = [&](cli::Session& session) { run(settings, session); };
  tool.report_writer = io::write_report;
  return cli::tool_main(argc, argv, tool);
}
