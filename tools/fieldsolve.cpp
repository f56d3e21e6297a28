// fieldsolve: solves for the guiding field on a triangle mesh, both Laplace problems at once.

#include "stage/fieldsolve.hpp"

#include "cli/tool_main.hpp"
#include "io/alignment_io.hpp"
#include "io/order_map_io.hpp"
#include "io/stage_files.hpp"
#include "io/whole_file.hpp"

using namespace quadrille;

int main(int argc, char** argv) {
  std::string input = "-", output = "-";
  stage::FieldsolveOptions options;

  cli::Tool tool;
  tool.name = "fieldsolve";
  tool.summary = "solves for the guiding field on a triangle mesh";
  tool.description =
      "Reads the triangle mesh TRI and writes the guiding field v = (u, v): harmonic inside, the cross (cos 4 theta, "
      "sin 4 theta) of the tangent angle theta on the boundary. The elements of the Galerkin method are continuous "
      "(cg) or discontinuous (dg, hybridised); interior modes are condensed, and one sparse factorisation serves both "
      "components. Boundary data come from the exact curves; every tangent discontinuity is represented by an exact "
      "harmonic function, so that corners do not reduce the accuracy. --corners dg leaves the discontinuities in the "
      "data, as the paper does, for comparison; only --method dg can represent them. With --nodes the field is a unit "
      "field with exactly the irregular nodes and corner valences of CRIT (the phase form, x.phase.h5), as critpoints "
      "or an editor prescribed them.";
  tool.examples = {"fieldsolve half_disc.tri.h5 -o half_disc.solve.h5",
                   "fieldsolve --field-order 12 half_disc.tri.h5 -o half_disc.solve.h5",
                   "fieldsolve --method dg half_disc.tri.h5 -o half_disc.solve.h5",
                   "fieldsolve --orders half_disc.field.h5 half_disc.tri.h5 -o half_disc.solve.h5",
                   "fieldsolve --nodes half_disc.crit.json half_disc.tri.h5 -o half_disc.phase.h5",
                   "cad2tri half_disc.step | fieldsolve | padapt -o half_disc.field.h5"};
  tool.options = [&](Options& o) {
    o.input("TRI", input, "triangle mesh (x.tri.h5)");
    o.output(output, "field to write (x.solve.h5)");
    declare(o, options);
  };
  tool.run = [&](cli::Session& s) {
    options.validate();
    const io::InputFile file = io::read_input(input);
    const TriMesh mesh = io::read_stage<TriMesh>(file);
    const int max_order = galerkin::max_field_order(options.solve.method);
    std::string orders_format;
    const auto orders = stage::prescribed(options.orders_file, io::read_input, [&](const io::InputFile& order_file) {
      orders_format = io::order_map_format(order_file);
      return io::read_order_map(order_file, mesh.num_elems(), max_order);
    });
    const auto nodes = stage::prescribed(options.nodes_file, io::read_input, io::read_stage<CriticalPoints>);
    const auto alignment = stage::prescribed(options.align_file, io::read_input, io::read_alignment);
    io::write_stage(
        output,
        stage::fieldsolve({{mesh, file}, orders.input(), orders_format, nodes.input(), alignment.input()}, options, s));
  };
  tool.report_writer = io::write_report;
  return cli::tool_main(argc, argv, tool);
}
