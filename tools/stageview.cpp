// stageview: draws a picture of any stage file, or a page of several.

#include "stage/stageview.hpp"

#include <algorithm>

#include "cli/tool_main.hpp"
#include "io/converted_picture.hpp"
#include "io/history.hpp"
#include "io/stage_files.hpp"

using namespace quadrille;

namespace {

struct Paths {
  std::vector<std::string> inputs;
  std::string output;
};

void run(const Paths& paths, const stage::StageviewOptions& options, cli::Session& session) {
  const std::string ending = io::picture_ending(paths.output);
  stage::View view = stage::begun_view(options, ending, paths.inputs.size());
  // A page is written as it is.
  const auto format = view.is_page ? io::PictureFormat::svg : io::picture_format(paths.output);
  session.begin_phase("read");
  const auto add = [&](const std::string& path) {
    const io::InputFile file = io::read_input(path);
    stage::add_to(view, io::read_any_stage(file), file, session);
  };
  if (view.has_field) add(options.field_file);
  std::ranges::for_each(paths.inputs, add);
  if (!options.run_report_file.empty())
    view.run_report = io::read_object(options.run_report_file, "a report", "formats/report.md");
  if (!options.workbench_file.empty())
    view.workbench = io::read_object(options.workbench_file, "the state of a workbench", "pipelines/quadbench.md");
  session.begin_phase("draw");
  const std::string text = stage::stageview(std::move(view), io::history_stem(paths.inputs.back()), options);
  const std::string bytes = io::converted_picture(text, format, paths.output);
  session.end_phase();
  io::write_output(paths.output, bytes, format != io::PictureFormat::svg);
}

}  // namespace

int main(int argc, char** argv) {
  Paths paths;
  stage::StageviewOptions options;
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
    o.inputs("FILE", paths.inputs, "a stage file; for a page also several, in the order of the chain");
    o.output(paths.output,
             "picture to write (SVG; PNG or PDF if the name ends in .png or .pdf), or page (if it ends in .html)");
    declare(o, options);
  };
  tool.run = [&](cli::Session& session) { run(paths, options, session); };
  tool.report_writer = io::write_report;
  return cli::tool_main(argc, argv, tool);
}
