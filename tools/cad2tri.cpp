// cad2tri: makes the curved triangle mesh on which the field is solved from a CAD file with one planar face, or several
// in one plane.

#include "stage/cad2tri.hpp"

#include "cli/tool_main.hpp"
#include "io/name_rules_io.hpp"
#include "io/stage_files.hpp"
#include "io/whole_file.hpp"

using namespace quadrille;

int main(int argc, char** argv) {
  std::string input = "-", output = "-";
  stage::Cad2triOptions options;

  cli::Tool tool;
  tool.name = "cad2tri";
  tool.summary = "turns a planar CAD face into a curved triangle mesh";
  tool.description =
      "Reads a planar face, with any number of holes, from SHAPE (STEP, IGES or BREP) and writes the triangle mesh on "
      "which fieldsolve solves, with the exact boundary curves as NURBS. Several faces in one plane are regions of "
      "one face: edges that lie upon each other within the tolerance of healing become one curve, also where they "
      "belong to separate parts or where a corner of one face lies on an edge of another; --face takes one of them "
      "alone. Curves inside a face that bound nothing, in wires of the face or beside it, are embedded: elements end "
      "there from both sides. In a file without faces, curves of one plane that close are the boundary of one. The "
      "mesh is coarse: its elements follow the curves with polynomials of a high order, are small only where the "
      "boundary is strongly curved or two of its parts are close to each other, and are graded geometrically towards "
      "corners at which the field is singular. Every element is proved valid. Lengths are the numbers of the file, in "
      "its own unit; those of a chart are lengths in its plane.";
  tool.examples = {"cad2tri half_disc.step -o half_disc.tri.h5",
                   "cad2tri half_disc.step --size 0.3 --corner-angle 2 -o fine.tri.h5",
                   "cad2tri half_disc.step --name axis=0 --name wall@0,1 -o named.tri.h5",
                   "cad2tri --list half_disc.step",
                   "cad2tri --list planar bracket_solid.step",
                   "cad2tri bracket_solid.step --section z=0.5 -o cut.tri.h5",
                   "cad2tri half_disc.step | fieldsolve -o half_disc.solve.h5"};
  tool.options = [&](Options& o) {
    o.input("SHAPE", input, "CAD file: STEP, IGES or BREP; or the chart of a curved face (x.chart.h5)");
    o.output(output, "triangle mesh to write (x.tri.h5)");
    declare(o, options);
  };
  tool.run = [&](cli::Session& s) {
    options.validate();
    const auto names = stage::prescribed(options.names_file, io::read_input, io::read_boundary_names);
    const io::InputFile file = io::read_input(input);
    stage::Cad2triInput from{{file.bytes, file}, names.input()};
    std::optional<ChartedFace> chart;
    if (io::is_chart(file)) from.chart.emplace(chart.emplace(io::read_stage<ChartedFace>(file)), file);
    if (!options.listed.empty()) return io::write_output(output, stage::list_faces(from.cad, options, s), false);
    const stage::LoadedShape shape = stage::load_shape(from, options, s);
    if (!options.healed_file.empty())
      io::write_output(options.healed_file, stage::cad_file_of(shape.face, options.healed_file), false);
    io::write_stage(output, stage::cad2tri(shape, options, s));
  };
  tool.report_writer = io::write_report;
  return cli::tool_main(argc, argv, tool);
}
