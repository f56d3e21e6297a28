// fieldsolve: the guiding field on a triangle mesh, both Laplace problems at once.

#include <fmt/format.h>

#include "check/check.hpp"
#include "cli/tool_main.hpp"
#include "galerkin/solve_laplace.hpp"
#include "io/input_file.hpp"
#include "io/output_file.hpp"
#include "io/stage_files.hpp"

using namespace quadrille;

int main(int argc, char** argv) {
  std::string input = "-", output = "-";
  int order = 8;

  Tool tool;
  tool.name = "fieldsolve";
  tool.summary = "solves for the guiding field on a triangle mesh";
  tool.description =
      "Reads the triangle mesh TRI and writes the guiding field v = (u, v): harmonic inside, the cross (cos 4 theta, "
      "sin 4 theta) of the tangent angle theta on the boundary. Continuous Galerkin with a modified hierarchical basis "
      "of one order on all triangles, interior modes condensed, one sparse factorisation for both components. Boundary "
      "data come from the exact curves; every tangent jump is carried by an exact harmonic function, so corners cost "
      "no accuracy.";
  tool.examples = {"fieldsolve half_disc.tri.h5 -o half_disc.solve.h5",
                   "fieldsolve --field-order 12 half_disc.tri.h5 -o half_disc.solve.h5",
                   "cad2tri half_disc.step | fieldsolve | padapt -o half_disc.field.h5"};
  tool.options = [&](Options& o) {
    o.input("TRI", input, "triangle mesh (x.tri.h5)");
    o.output(output, "field to write (x.solve.h5)");
    o.integer("--field-order", order, 1, 20, "polynomial order of the field on every element");
  };
  tool.run = [&](Session& s) {
    const InputFile file = read_input(input);
    TriMesh mesh = read_tri_mesh(file);
    require_valid(check_tri_mesh(mesh, CheckDepth::quick), file.name);
    s.begin_phase("solve");
    Field field = solve_laplace(mesh, std::vector<int>(mesh.num_elems(), order), s.report());
    s.end_phase();
    s.report().set("solve.field_order", order);
    field.provenance = s.provenance(mesh.provenance, {file.digest("tri-mesh")});
    s.say(fmt::format("{} elements of order {}, {} liftings", mesh.num_elems(), order, field.liftings.size()));
    write_field(output, field);
  };
  tool.report_writer = write_report;
  return tool_main(argc, argv, tool);
}
