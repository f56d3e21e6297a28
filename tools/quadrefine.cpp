// Splits the blocks of a layout into the final curved quad mesh.

#include <fmt/format.h>

#include <algorithm>

#include "check/check.hpp"
#include "cli/tool_main.hpp"
#include "io/output_file.hpp"
#include "io/stage_files.hpp"
#include "refine/refine.hpp"

using namespace quadrille;

int main(int argc, char** argv) {
  std::string input = "-", output = "-";
  RefineOptions options;
  Tool tool;
  tool.name = "quadrefine";
  tool.summary = "splits blocks into a curved quad mesh";
  tool.description =
      "One count of elements for each chord of blocks, from --size; more where the boundary would miss --geometry-tol, "
      "with element corners moved onto joints inside a side. Each element is sampled from the exact map of its block "
      "and proved valid by a lower bound of det J, else the exit code is 1 and the message names the place.";
  tool.examples = {"quadrefine half_disc.blocks.h5 -o half_disc.quad.h5",
                   "quadrefine --size 0.2 --order 6 half_disc.blocks.h5 -o fine.quad.h5"};
  tool.options = [&](Options& o) {
    o.input("BLOCKS", input, "block layout (x.blocks.h5)");
    o.output(output, "quad mesh (x.quad.h5)");
    o.number("--size", options.size, 0, 1e300, "length of the file; 0: diameter / 20", "greatest edge length wanted");
    o.integer("--order", options.order, 1, 20, "shape order of the elements");
    o.number("--geometry-tol", options.geometry_tol, 1e-14, 1, "diameters",
             "greatest distance between the mesh's boundary and the CAD curves");
  };
  tool.run = [&](Session& s) {
    s.begin_phase("read");
    const InputFile file = read_input(input);
    const BlockLayout layout = read_block_layout(file);
    require_valid(check_block_layout(layout, CheckDepth::quick), file.name);
    s.begin_phase("refine");
    QuadMesh mesh = refine(layout, options, s.report());
    mesh.provenance = s.provenance(layout.provenance, {file.digest("block-layout")});
    s.say(fmt::format("{} quads of order {}, worst scaled Jacobian {:.3g}", mesh.num_elems(), mesh.order,
                      *std::min_element(mesh.elem_scaled_jacobian.begin(), mesh.elem_scaled_jacobian.end())));
    s.begin_phase("write");
    write_quad_mesh(output, mesh);
    s.end_phase();
  };
  tool.report_writer = write_report;
  return tool_main(argc, argv, tool);
}
