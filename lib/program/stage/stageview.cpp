#include "stage/stageview.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "base/error.hpp"
#include "base/number_list.hpp"
#include "base/warning_codes.hpp"
#include "check/check.hpp"
#include "check/same_origin.hpp"
#include "draw/figures.hpp"
#include "io/history.hpp"
#include "page/page.hpp"

namespace quadrille::stage {

namespace {

/// "X,Y,Z" or "iso".
draw::ViewDirection parsed_view(const std::string& text) {
  if (text == "iso") return std::nullopt;
  const std::vector<double> x = numbers_of(text);
  const Vec3 towards = x.size() == 3 ? Vec3{x[0], x[1], x[2]} : Vec3{};
  if (!(norm(towards) > 0)) throw UsageError("--view: '" + text + "' is neither iso nor X,Y,Z, a direction");
  return towards;
}

/// "X0,Y0,X1,Y1".
draw::Window parsed_window(const std::string& text) {
  const std::vector<double> x = numbers_of(text);
  if (x.size() != 4 || x[0] >= x[2] || x[1] >= x[3])
    throw UsageError("--window: '" + text + "' is not X0,Y0,X1,Y1, two corners with X0 < X1 and Y0 < Y1");
  return {{x[0], x[1]}, {x[2], x[3]}};
}

void require_comparable(const View& view, const StageModel& model, const std::string& file) {
  if (!draw::is_comparable(model))
    throw UsageError("--compare needs layouts or meshes, but " + file + " is a " + stage_formats[model.index()].name +
                     " file");
  if (!view.stages.empty() && view.stages[0].model.index() != model.index())
    throw UsageError("--compare needs two files of one format: two layouts, or two meshes");
}

/// One of the stages was made from the other, or both from one.
void require_related(const View& view, const StageModel& model, const FileIdentity& file) {
  if (view.stages.empty()) return;
  const auto is_related = [&](const View::Stage& other) {
    return check::have_same_origin(other.file, provenance_of(other.model), file, provenance_of(model));
  };
  const View::Stage& last = view.stages.back();
  if (std::none_of(view.stages.begin(), view.stages.end(), is_related))
    check::require_same_origin(last.file, provenance_of(last.model), file, provenance_of(model));
}

/// The name of a file without folders; empty for standard input.
std::string base_name(const FileIdentity& file) {
  return file.name == "standard input" ? "" : std::filesystem::path(file.name).filename().string();
}

draw::DrawOptions draw_options(const StageviewOptions& options) {
  draw::DrawOptions draw;
  draw.width = options.width;
  draw.show = options.show;
  draw.is_bare = options.is_bare;
  if (options.labels_all) draw.curve_labels = draw::CurveLabels::all;
  if (options.labels_none || options.is_bare) draw.curve_labels = draw::CurveLabels::none;
  if (!options.window.empty()) draw.window = parsed_window(options.window);
  if (!options.view.empty()) draw.view = parsed_view(options.view);
  return draw;
}

std::string picture_of(const View& view, const StageviewOptions& options) {
  draw::DrawOptions draw = draw_options(options);
  const View::Stage &first = view.stages.front(), &last = view.stages.back();
  if (view.is_comparison)
    return draw::draw_comparison(first.model, last.model, {base_name(first.file), base_name(last.file)}, draw);
  if (draw.view && !std::holds_alternative<QuadMesh>(last.model) && !std::holds_alternative<HexMesh>(last.model))
    throw UsageError("--view is for the quad mesh of a curved face and for hexahedra, but " + last.file.name +
                     " is another");
  draw.file = base_name(last.file);
  draw.field = std::get_if<Field>(&first.model);
  return std::visit([&](const auto& model) { return draw::draw_stage(model, draw); }, last.model);
}

std::string page_of(View view, const std::string& stem) {
  if (view.is_comparison)
    return page::comparison_page(view.stages[0].model, view.stages[1].model,
                                 {base_name(view.stages[0].file), base_name(view.stages[1].file)});
  const bool is_named = !base_name(view.stages.back().file).empty();
  page::RunRecord run{is_named ? stem : "", std::move(view.run_report), {}, std::move(view.workbench)};
  io::History history;
  std::vector<StageModel> stages;
  for (View::Stage& stage : view.stages) {
    if (!run.report.empty())
      for (const std::string& line : history.lines_of(provenance_of(stage.model), stage.file.sha256, stem))
        run.commands.push_back(line);
    stages.push_back(std::move(stage.model));
  }
  return view.is_data ? page::page_data(stages, run) : page::html_page(stages, run);
}

}  // namespace

void declare(Options& o, StageviewOptions& stageview) {
  o.input_file("--field", stageview.field_file, "FILE", "field to draw under critical points", false);
  o.flag("--compare", stageview.is_comparison,
         "two files of one format, separatrices, blocks or quads, which need not be of one chain: side by side at "
         "one scale (in a page also the lines of one over the other), with a table of counts and qualities");
  o.input_file("--run-report", stageview.run_report_file, "FILE",
               "in a page, a tab with this report of the run (quadmesh --report), histograms of the last mesh and "
               "the commands by which the files were made",
               false);
  o.input_file(
      "--workbench", stageview.workbench_file, "FILE",
      "make the page that quadbench serves, with this JSON object as its state; with -o x.json, the data of the "
      "page alone",
      false);
  o.choice("--show", stageview.show, {"psi", "u", "v", "order"},
           "quantity of a field to show in a picture: cross angle, a component or the polynomial order");
  o.flag("--curve-labels", stageview.labels_all,
         "in a picture, write number and name beside each boundary curve, for cad2tri --name; without it, given names "
         "only, each once for successive curves that have it");
  o.flag("--no-curve-labels", stageview.labels_none,
         "in a picture, do not write the names of boundary curves and regions");
  o.flag("--bare", stageview.is_bare,
         "in a picture of one stage in the plane, the drawing alone, without title, labels and legend, as for a small "
         "one");
  o.text("--window", stageview.window, "X0,Y0,X1,Y1",
         "the part of the plane that a picture shows: its lower left and upper right corner in the coordinates and the "
         "unit of the file",
         false);
  o.text("--view", stageview.view, "X,Y,Z|iso",
         "in a picture, the mesh of a curved face, or hexahedra, as seen in space from this direction; iso: along a "
         "diagonal of the axes, on the side of the face's normal; without it, a curved face is seen beside its chart",
         false);
  o.integer("--width", stageview.width, 200, 20000, "width of the picture in pixels");
}

View begun_view(const StageviewOptions& options, const std::string& ending, std::size_t num_files) {
  View view;
  view.is_data = ending == "json" && !options.workbench_file.empty();
  view.is_page = ending == "html" || ending == "htm" || view.is_data;
  view.is_comparison = options.is_comparison;
  view.has_field = !options.field_file.empty();
  if (!view.is_page && !view.is_comparison && num_files > 1)
    throw UsageError("several files are shown by a page only: give -o with a name that ends in .html");
  if (!options.window.empty()) static_cast<void>(parsed_window(options.window));
  if (!options.view.empty()) static_cast<void>(parsed_view(options.view));
  if (!options.view.empty() && (view.is_page || view.is_comparison || !options.window.empty()))
    throw UsageError("--view is for the picture of one mesh: give no page, --compare or --window");
  if (!options.window.empty() && view.is_page) throw UsageError("--window is for pictures: a page zooms by itself");
  if (options.is_bare && (view.is_page || view.is_comparison || !options.view.empty()))
    throw UsageError("--bare is for the picture of one stage in the plane: give no page, --compare or --view");
  if (options.labels_all && options.labels_none)
    throw UsageError("--curve-labels and --no-curve-labels exclude each other");
  if (!(options.run_report_file + options.workbench_file).empty() && (!view.is_page || view.is_comparison))
    throw UsageError(
        "--run-report and --workbench are for pages of one chain: give -o with a name that ends in .html, and no "
        "--compare");
  if (view.is_comparison && view.has_field) throw UsageError("--compare and --field exclude each other");
  if (view.is_comparison && num_files != 2) throw UsageError("--compare needs two files, layouts or meshes");
  return view;
}

void add_to(View& view, StageModel model, FileIdentity file, Run& run) {
  std::visit([&](const auto& stage) { check::require_sound(stage, file.name); }, model);
  if (const auto* mesh = std::get_if<QuadMesh>(&model); mesh && !mesh->is_valid)
    run.report().warn(warning::mesh_not_valid, check::validity_warning(*mesh));
  if (const auto* mesh = std::get_if<HexMesh>(&model); mesh && !mesh->is_valid)
    run.report().warn(warning::mesh_not_valid, check::validity_warning(*mesh));
  view.is_comparison ? require_comparable(view, model, file.name) : require_related(view, model, file);
  view.stages.push_back({std::move(model), std::move(file)});
}

std::string stageview(View view, const std::string& stem, const StageviewOptions& options) {
  const View::Stage& last = view.stages.back();
  const auto* points = std::get_if<CriticalPoints>(&last.model);
  if (view.has_field && !points)
    throw UsageError("--field needs a critical-points file, but " + last.file.name + " is another");
  if (options.labels_all && points && !view.has_field && points->face.curves.empty())
    throw UsageError("--curve-labels needs --field, as " + last.file.name + " does not contain the face");
  return view.is_page ? page_of(std::move(view), stem) : picture_of(view, options);
}

}  // namespace quadrille::stage
