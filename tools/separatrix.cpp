// Traces the separatrices of a guiding field and writes the planar graph of separatrices and boundary.

#include "stage/separatrix.hpp"

#include "cli/tool_main.hpp"
#include "io/stage_files.hpp"
#include "io/whole_file.hpp"
#include "triangulate/triangulate.hpp"

using namespace quadrille;

namespace {

SeparatrixGraph graph_of(const io::InputFile& file, const std::string& points_path,
                         const stage::SeparatrixOptions& options, cli::Session& session) {
  if (io::stage_format(file) == "tri-mesh") {
    const TriMesh triangles = io::read_stage<TriMesh>(file);
    return stage::separatrix({triangles, file}, options, session);
  }
  const Field field = io::read_stage<Field>(file);
  if (options.layout == layout::LayoutChoice::midpoint) return stage::separatrix({field, file}, {}, options, session);
  const io::InputFile points_file = io::read_input(points_path);
  const CriticalPoints points = io::read_stage<CriticalPoints>(points_file);
  return stage::separatrix({field, file}, stage::Input<CriticalPoints>(points, points_file), options, session);
}

}  // namespace

int main(int argc, char** argv) {
  std::string field, points = "-", output = "-";
  stage::SeparatrixOptions options;
  options.coarse_mesher = triangulate::coarse_triangles;

  cli::Tool tool;
  tool.name = "separatrix";
  tool.summary = "traces the separatrices of a guiding field";
  tool.description =
      "Starts a separatrix in each direction of the cross at the irregular nodes and corners of CRIT, traces it "
      "through FIELD to the boundary, merges separatrices that meet head-on and writes the planar graph of "
      "separatrices and boundary. If the nodes of CRIT are not the zeros of the field, FIELD must be the phase that "
      "fieldsolve --nodes solved for them. Every face of the graph must have four corners; otherwise the exit code is "
      "1 and the message names the position, unless --layout auto or midpoint divides triangles into blocks instead, "
      "which need no field. If the face has several regions, lines go on at a right angle in the neighbouring region, "
      "and the graph is that of the whole face.";
  tool.examples = {
      "separatrix half_disc.field.h5 half_disc.crit.json -o half_disc.sep.json",
      "critpoints half_disc.field.h5 | separatrix half_disc.field.h5 - | blocksplit -o half_disc.blocks.h5",
      "separatrix --layout midpoint half_disc.tri.h5 -o half_disc.sep.json"};
  tool.options = [&](Options& o) {
    o.input("FIELD", field, "guiding field (x.field.h5, x.phase.h5 or x.solve.h5), or only triangles (x.tri.h5)", true);
    o.input("CRIT", points, "its critical points (x.crit.json); not read with --layout midpoint or for triangles");
    o.output(output, "separatrix graph to write (x.sep.json)");
    declare(o, options);
  };
  tool.run = [&](cli::Session& s) {
    s.begin_phase("read");
    const io::InputFile file = io::read_input(field);
    const SeparatrixGraph graph = graph_of(file, points, options, s);
    s.begin_phase("write");
    io::write_stage(output, graph);
  };
  tool.report_writer = io::write_report;
  return cli::tool_main(argc, argv, tool);
}
