// Sweeps the quads of a mesh through space: extrudes, revolves, twists them into hexahedra.

#include "stage/hexsweep.hpp"

#include <string>

#include "cli/tool_main.hpp"
#include "io/point_table.hpp"
#include "io/stage_files.hpp"
#include "io/whole_file.hpp"

using namespace quadrille;

int main(int argc, char** argv) {
  std::string input = "-", output = "-";
  stage::HexsweepOptions options;

  cli::Tool tool;
  tool.name = "hexsweep";
  tool.summary = "sweeps a quad mesh into curved hexahedra";
  tool.description =
      "Reads a quad mesh and moves it through space: along its normal, by a vector, along a curve, or about an axis; "
      "on "
      "the way it may twist and narrow, or start on a terrain. Each layer of hexahedra has its nodes on the exact "
      "motion, at the Gauss-Lobatto-Legendre points of the order of the quads. Sides have the names of the curves, the "
      "ends are called bottom and top, regions stay regions, and periodic sides stay periodic where the motion allows "
      "it. Every hexahedron is proved valid by a lower bound of det J; otherwise the exit code is 1 and the message "
      "names the position, unless --allow-invalid is given.";
  tool.examples = {
      "hexsweep half_disc.quad.h5 --height 0.5 --layers 4 -o half_disc.hex.h5",
      "hexsweep half_disc.quad.h5 --height 1 --twist 90 --layers 8 -o twisted.hex.h5",
      "hexsweep half_disc.quad.h5 --revolve 90 --axis -3,0,-3,1 --layers 6 -o bend.hex.h5",
      "hexsweep half_disc.quad.h5 --height 1 --bottom-layers first=0.01,growth=1.2,layers=5 -o wall.hex.h5",
      "hexsweep half_disc.quad.h5 --one-layer -o slab.hex.h5"};
  tool.options = [&](Options& o) {
    o.input("QUADS", input, "quad mesh (x.quad.h5)");
    o.output(output, "hexahedral mesh to write (x.hex.h5)");
    declare(o, options);
  };
  tool.run = [&](cli::Session& s) {
    options.validate();
    const auto curve = stage::prescribed(options.curve_file, io::read_input, io::space_points);
    const auto terrain = stage::prescribed(options.terrain_file, io::read_input, io::space_points);
    s.begin_phase("read");
    const io::InputFile file = io::read_input(input);
    const QuadMesh quads = io::read_stage<QuadMesh>(file);
    const HexMesh mesh = stage::hexsweep({{quads, file}, curve.input(), terrain.input()}, options, s);
    s.begin_phase("write");
    io::write_stage(output, mesh);
  };
  tool.report_writer = io::write_report;
  return cli::tool_main(argc, argv, tool);
}
