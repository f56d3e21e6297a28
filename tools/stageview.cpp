// stageview: draws a picture of any stage file, or a page of several.

#include "stage/stageview.hpp"

#include "cli/tool_main.hpp"
#include "io/converted_picture.hpp"
#include "io/history.hpp"
#include "io/stage_files.hpp"

using namespace quadrille;

namespace {

struct Settings {
  std::vector<std::string> inputs;
  std::string field, output, run_report, workbench;
  stage::View view;
  stage::StageviewOptions options;
};

void run(Settings& settings, cli::Session& session) {
  stage::View& view = settings.view;
  const std::string ending = io::picture_ending(settings.output);
  view.is_data = ending == "json" && !settings.workbench.empty();
  view.is_page = ending == "html" || ending == "htm" || view.is_data;
  view.has_field = !settings.field.empty();
  const bool has_record = !settings.run_report.empty() || !settings.workbench.empty();
  stage::require_view(view, settings.inputs.size(), has_record, settings.options);
  const auto format = view.is_page ? io::PictureFormat::svg : io::picture_format(settings.output);
  session.begin_phase("read");
  std::vector<std::string> paths = settings.inputs;
  if (view.has_field) paths.insert(paths.begin(), settings.field);
  for (const std::string& path : paths) {
    const io::InputFile file = io::read_input(path);
    stage::add_to(view, io::read_any_stage(file), file, session);
  }
  if (!settings.run_report.empty())
    view.run_report = io::read_object(settings.run_report, "a report", "formats/report.md");
  if (!settings.workbench.empty())
    view.workbench = io::read_object(settings.workbench, "the state of a workbench", "pipelines/quadbench.md");
  session.begin_phase("draw");
  const bool is_page = view.is_page;
  const std::string text =
      stage::stageview(std::move(view), io::history_stem(settings.inputs.back()), settings.options);
  const std::string bytes = is_page ? text : io::converted_picture(text, format, settings.output);
  session.end_phase();
  io::write_output(settings.output, bytes, format != io::PictureFormat::svg);
}

}  // namespace

int main(int argc, char** argv) {
  Settings settings;
  cli::Tool tool;
  tool.name = "stageview";
  tool.summary = "draws any stage file: a picture (SVG, PNG, PDF) or a page that zooms (HTML)";
  tool.description =
      "The format of FILE is detected from its content: triangle mesh, guiding field, critical points, separatrices, "
      "blocks or quads. If the output ends in .html, it is a page for a browser, which needs no other file and no "
      "network: it moves and zooms, switches layers, shows number, size and quality of what is under the pointer and "
      "goes to the worst element; the key ? lists its keys. Several files of one chain become the tabs of one page. "
      "Any other output is a picture: PNG or PDF if its name ends so (made by the program rsvg-convert, which must be "
      "installed), else SVG, the ending of which may be left out. Critical points are drawn with error bars, clusters, "
      "changes and the cells of the certificate, over the field that --field names or, without it, in the outline of "
      "the face. The worst element or block is marked if its scaled Jacobian is below 0.5. In a browser, elements, "
      "blocks and points show their numbers and figures, and changes their reasons, under the mouse pointer.";
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
    o.flag("--compare", settings.view.is_comparison,
           "two files of one format, separatrices, blocks or quads, which need not be of one chain: side by side at "
           "one scale (in a page also the lines of one over the other), with a table of counts and qualities");
    o.input_file("--run-report", settings.run_report, "FILE",
                 "in a page, a tab with this report of the run (quadmesh --report), histograms of the last mesh and "
                 "the commands by which the files were made",
                 false);
    o.input_file(
        "--workbench", settings.workbench, "FILE",
        "make the page that quadbench serves, with this JSON object as its state; with -o x.json, the data of the "
        "page alone",
        false);
    declare(o, settings.options);
  };
  tool.run = [&](cli::Session& session) { run(settings, session); };
  tool.report_writer = io::write_report;
  return cli::tool_main(argc, argv, tool);
}
