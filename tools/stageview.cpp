// stageview: a picture of any stage file.

#include "base/error.hpp"
#include "check/check.hpp"
#include "cli/tool_main.hpp"
#include "draw/draw.hpp"
#include "io/output_file.hpp"
#include "io/stage_files.hpp"

namespace quadrille {
namespace {

struct Settings {
  std::string input, field, output;
  DrawOptions draw;
};

Field read_valid_field(const InputFile& file) {
  Field field = read_field(file);
  require_valid(check_field(field, CheckDepth::quick), file.name);
  return field;
}

std::string draw_points(const InputFile& file, const Settings& settings) {
  const CriticalPoints points = read_critical_points(file);
  require_valid(check_critical_points(points, CheckDepth::quick), file.name);
  if (settings.field.empty()) return draw_critical_points(points, nullptr, settings.draw);
  const InputFile field_file = read_input(settings.field);
  const Field field = read_valid_field(field_file);
  require_same_origin(field_file, field.provenance, file, points.provenance);
  return draw_critical_points(points, &field, settings.draw);
}

std::string draw_stage(const Settings& settings, Session& session) {
  const InputFile file = read_input(settings.input);
  const std::string format = stage_format(file);
  if (!settings.field.empty() && format != "critical-points")
    throw UsageError("--field is only of use beside critical points; " + file.name + " is a " + format + " file");
  const auto drawn = [&](auto model, auto check, auto draw) {
    require_valid(check(model, CheckDepth::quick), file.name);
    return draw(model, settings.draw);
  };
  if (format == "tri-mesh") return drawn(read_tri_mesh(file), check_tri_mesh, draw_tri_mesh);
  if (format == "field") return drawn(read_field(file), check_field, draw_field);
  if (format == "critical-points") return draw_points(file, settings);
  if (format == "separatrix-graph")
    return drawn(read_separatrix_graph(file), check_separatrix_graph, draw_separatrix_graph);
  if (format == "block-layout") return drawn(read_block_layout(file), check_block_layout, draw_block_layout);
  if (format == "quad-mesh")
    return drawn(read_quad_mesh(file), check_quad_mesh, [&](const QuadMesh& mesh, const DrawOptions& options) {
      if (!mesh.is_valid) session.report().warn("W-QUA-001", doubt_about(mesh));
      return draw_quad_mesh(mesh, options);
    });
  throw FormatError(file.name + ": there is no picture for the format " + format);
}

}  // namespace
}  // namespace quadrille

int main(int argc, char** argv) {
  using namespace quadrille;
  Settings settings;
  Tool tool;
  tool.name = "stageview";
  tool.summary = "draws a picture (SVG) of any stage file";
  tool.description =
      "The kind of FILE is recognised by its content: triangle mesh, guiding field, critical points, separatrices, "
      "blocks or quads. Critical points are drawn over their field when it is given by --field, with error bars, "
      "clusters, what was changed and the cells of the certificate. Elements, blocks and points show their numbers and "
      "figures, changes their reasons, when the pointer rests on them in a browser.";
  tool.examples = {"stageview half_disc.quad.h5 -o half_disc.svg",
                   "stageview half_disc.field.h5 --show order -o orders.svg",
                   "stageview half_disc.crit.json --field half_disc.field.h5 -o points.svg"};
  tool.options = [&](Options& o) {
    o.input("FILE", settings.input, "a stage file");
    o.output(settings.output, "the picture");
    o.text("--field", settings.field, "FILE", "the field to draw under critical points", false);
    o.choice("--show", settings.draw.show, {"psi", "u", "v", "order"}, "what to show of a field");
    o.integer("--width", settings.draw.width, 200, 20000, "width of the picture in pixels");
  };
  tool.run = [&](Session& s) { write_output(settings.output, draw_stage(settings, s), false); };
  tool.report_writer = write_report;
  return tool_main(argc, argv, tool);
}
