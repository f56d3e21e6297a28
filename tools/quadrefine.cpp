// Splits the blocks of a layout into the final curved quad mesh.

#include "stage/quadrefine.hpp"

#include "cli/tool_main.hpp"
#include "io/alignment_io.hpp"
#include "io/size_field_io.hpp"
#include "io/stage_files.hpp"
#include "io/whole_file.hpp"
#include "triangulate/size_triangles.hpp"

using namespace quadrille;

int main(int argc, char** argv) {
  std::string input = "-", output = "-";
  stage::QuadrefineOptions options;
  options.join_points = triangulate::add_size_triangles;

  cli::Tool tool;
  tool.name = "quadrefine";
  tool.summary = "splits blocks into a curved quad mesh";
  tool.description =
      "Reads a block layout and chooses one number of elements for each chord (blocks that are linked through opposite "
      "sides), so that the logarithms of the edge lengths deviate least from those of the prescribed ones, in the mean "
      "square over the length of the chord's arcs. Where several sizes are prescribed at one point, finer ones are "
      "weighted more (by the sixth power) and so determine the result; sizes grow from there to --size at the rate "
      "--growth. More elements are used where the boundary would deviate by more than --geometry-tol, and where blocks "
      "are so thin that the ratio of the sides of an element would exceed --target-edge-ratio; element "
      "corners are moved onto joints inside a side. --report lists the prescribed and the achieved sizes of each "
      "chord. Each element is sampled from the exact map of its block and proved valid by a lower bound of det J; "
      "otherwise the exit code is 1 and the message names the position, unless --allow-invalid is given. --report and "
      "-v list the worst elements and their positions.";
  tool.examples = {
      "quadrefine half_disc.blocks.h5 -o half_disc.quad.h5",
      "quadrefine --size 0.2 --order 6 half_disc.blocks.h5 -o fine.quad.h5",
      "quadrefine --wall curve_0:first=1e-3,growth=1.3,layers=8 half_disc.blocks.h5 -o layers.quad.h5",
      "quadrefine --wall 0:yplus=1,layers=8 --velocity 30 --viscosity 1e-5 --length 1 half_disc.blocks.h5 >y.h5",
      "quadrefine --count curve_0=16 --refine 1 half_disc.blocks.h5 -o counted.quad.h5",
      "quadrefine --size 0.2 --size-near 0=0.05 --growth 1.3 half_disc.blocks.h5 -o near.quad.h5",
      "quadrefine --metric metric.csv half_disc.blocks.h5 -o stretched.quad.h5"};
  tool.options = [&](Options& o) {
    o.input("BLOCKS", input, "block layout (x.blocks.h5)");
    o.output(output, "quad mesh to write (x.quad.h5)");
    declare(o, options);
  };
  tool.run = [&](cli::Session& s) {
    options.validate();
    // Read before BLOCKS, which may be made for long.
    const auto sizes = stage::prescribed(options.size_field_file, io::read_input, io::read_size_field);
    const auto metric = stage::prescribed(options.metric_file, io::read_input, io::read_metric);
    const auto alignment = stage::prescribed(options.align_file, io::read_input, io::read_alignment);
    s.begin_phase("read");
    const io::InputFile file = io::read_input(input);
    const BlockLayout layout = io::read_stage<BlockLayout>(file);
    const QuadMesh mesh =
        stage::quadrefine({{layout, file}, sizes.input(), metric.input(), alignment.input()}, options, s);
    s.begin_phase("write");
    io::write_stage(output, mesh);
  };
  tool.report_writer = io::write_report;
  return cli::tool_main(argc, argv, tool);
}
