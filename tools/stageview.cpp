// stageview: draws a picture of any stage file.

#include "base/error.hpp"
#include "base/warning_codes.hpp"
#include "check/check.hpp"
#include "cli/tool_main.hpp"
#include "draw/draw.hpp"
#include "io/output_file.hpp"
#include "io/stage_files.hpp"

namespace quadrille {
namespace {

struct Settings {
  std::string input, field, output;
  draw::DrawOptions draw;
};

Field read_valid_field(const io::InputFile& file) {
  Field field = io::read_field(file);
  check::require_valid(check::check_field(field, check::CheckDepth::quick), file.name);
  return field;
}

std::string draw_points(const io::InputFile& file, const Settings& settings) {
  const CriticalPoints points = io::read_critical_points(file);
  check::require_valid(check::check_critical_points(points, check::CheckDepth::quick), file.name);
  if (settings.field.empty()) return draw::draw_critical_points(points, nullptr, settings.draw);
  const io::InputFile field_file = io::read_input(settings.field);
  const Field field = read_valid_field(field_file);
  io::require_same_origin(field_file, field.provenance, file, points.provenance);
  return draw::draw_critical_points(points, &field, settings.draw);
}

std::string draw_stage(const Settings& settings, cli::Session& session) {
  const io::InputFile file = io::read_input(settings.input);
  const std::string format = io::stage_format(file);
  session.begin_phase("draw");
  if (!settings.field.empty() && format != "critical-points")
    throw UsageError("--field needs a critical-points file, but " + file.name + " is a " + format + " file");
  const auto drawn = [&](auto model, auto check, auto draw) {
    require_valid(check(model, check::CheckDepth::quick), file.name);
    return draw(model, settings.draw);
  };
  if (format == "tri-mesh") return drawn(io::read_tri_mesh(file), check::check_tri_mesh, draw::draw_tri_mesh);
  if (format == "field") return drawn(io::read_field(file), check::check_field, draw::draw_field);
  if (format == "critical-points") return draw_points(file, settings);
  if (format == "separatrix-graph")
    return drawn(io::read_separatrix_graph(file), check::check_separatrix_graph, draw::draw_separatrix_graph);
  if (format == "block-layout")
    return drawn(io::read_block_layout(file), check::check_block_layout, draw::draw_block_layout);
  if (format == "quad-mesh")
    return drawn(io::read_quad_mesh(file), check::check_quad_mesh,
                 [&](const QuadMesh& mesh, const draw::DrawOptions& options) {
                   if (!mesh.is_valid) session.report().warn(warning::mesh_not_valid, check::validity_warning(mesh));
                   return draw::draw_quad_mesh(mesh, options);
                 });
  throw FormatError(file.name + ": there is no picture for the format " + format);
}

}  // namespace
}  // namespace quadrille

int main(int argc, char** argv) {
  using namespace quadrille;
  Settings settings;
  cli::Tool tool;
  tool.name = "stageview";
  tool.summary = "draws a picture (SVG) of any stage file";
  tool.description =
      "The format of FILE is detected from its content: triangle mesh, guiding field, critical points, separatrices, "
      "blocks or quads. Critical points are drawn over the field that --field names, with error bars, clusters, "
      "changes and the cells of the certificate. In a browser, elements, blocks and points show their numbers and "
      "figures, and changes their reasons, under the mouse pointer.";
  tool.examples = {"stageview half_disc.quad.h5 -o half_disc.svg",
                   "stageview half_disc.field.h5 --show order -o orders.svg",
                   "stageview half_disc.crit.json --field half_disc.field.h5 -o points.svg"};
  tool.options = [&](cli::Options& o) {
    o.input("FILE", settings.input, "a stage file");
    o.output(settings.output, "picture to write (SVG)");
    o.input_file("--field", settings.field, "FILE", "field to draw under critical points", false);
    o.choice("--show", settings.draw.show, {"psi", "u", "v", "order"},
             "quantity of a field to show: cross angle, a component or the polynomial order");
    o.integer("--width", settings.draw.width, 200, 20000, "width of the picture in pixels");
  };
  tool.run = [&](cli::Session& s) {
    const std::string picture = draw_stage(settings, s);
    s.end_phase();
    io::write_output(settings.output, picture, false);
  };
  tool.report_writer = io::write_report;
  return cli::tool_main(argc, argv, tool);
}
