// cad2chart: makes the isothermal chart of one face of a CAD file, in which the stages after it work as in a plane.

#include "stage/cad2chart.hpp"

#include "cli/tool_main.hpp"
#include "io/stage_files.hpp"
#include "io/whole_file.hpp"

using namespace quadrille;

int main(int argc, char** argv) {
  std::string input = "-", output = "-";
  stage::Cad2chartOptions options;

  cli::Tool tool;
  tool.name = "cad2chart";
  tool.summary = "makes the chart of a curved CAD face";
  tool.description =
      "Reads one face of SHAPE (STEP, IGES or BREP), curved or planar, of a solid, a shell or an assembly, and writes "
      "its isothermal chart: an image in the plane that keeps angles, and the lengths of the outline. cad2tri reads "
      "it in place of a CAD file; the stages after it work in the chart and carry the face in space along, and "
      "quadrefine "
      "puts the nodes of its quads on the surface and the edges, exactly. Seams and poles of the surface do not show. "
      "Refused are closed faces without a boundary, faces that go round a handle, surfaces with a kink inside the "
      "face, and charts that overlap or whose scales differ too much (--scale-range): cut such faces in the CAD "
      "program. Several faces of one surface are regions of one chart, and curves inside a face that bound nothing, in "
      "wires of the face or beside it, are embedded, as those of planar faces are by cad2tri: elements end there from "
      "both sides. "
      "Curves have the names of the file; cad2tri --name renames them.";
  tool.examples = {"cad2chart half_disc.step --face 0 -o half_disc.chart.h5",
                   "cad2chart half_disc.step --closedness 1e-8 | cad2tri -o half_disc.tri.h5"};
  tool.options = [&](Options& o) {
    o.input("SHAPE", input, "CAD file: STEP, IGES or BREP");
    o.output(output, "chart to write (x.chart.h5)");
    declare(o, options);
  };
  tool.run = [&](cli::Session& s) {
    const io::InputFile file = io::read_input(input);
    io::write_stage(output, stage::cad2chart({file.bytes, file}, options, s));
  };
  tool.report_writer = io::write_report;
  return cli::tool_main(argc, argv, tool);
}
