// Writes a quad mesh, the blocks it was made from, or hexahedra, in the formats of other programs.

#include "stage/quadexport.hpp"

#include "cli/tool_main.hpp"
#include "io/stage_files.hpp"
#include "io/whole_file.hpp"

using namespace quadrille;

namespace {

// The files to write, the main one last.
std::vector<stage::OutputFile> exported(const std::string& input, const std::string& output,
                                        const stage::QuadexportOptions& options, bool is_step, cli::Session& s) {
  s.begin_phase("read");
  const io::InputFile file = io::read_input(input);
  if (is_step) return {stage::quadexport_step({file.bytes, file}, output, options, s)};
  StageModel model = io::read_any_stage(file);
  if (auto* hexes = std::get_if<HexMesh>(&model))
    return stage::quadexport(std::move(*hexes), file.name, output, options, s);
  if (auto* quads = std::get_if<QuadMesh>(&model))
    return stage::quadexport(std::move(*quads), file.name, output, options, s);
  return stage::quadexport(io::read_stage<QuadMesh>(file), file.name, output, options, s);  // which refuses it
}

}  // namespace

int main(int argc, char** argv) {
  std::string input = "-", output = "-";
  stage::QuadexportOptions options;

  cli::Tool tool;
  tool.name = "quadexport";
  tool.summary = "writes a mesh or its blocks for other programs";
  tool.description =
      "Writes a quad mesh, or hexahedra, in the format of a solver, with the names of boundaries and blocks and with "
      "the nodes that the format defines. What the format cannot represent is reported on standard error, with the "
      "magnitude of the loss. A block layout is written as a STEP model of faces that share their edges and have the "
      "names of their regions. The format follows from the ending of the output, or from --format, which lists all "
      "with their orders; standard output is MSH by default.";
  tool.examples = {
      "quadexport half_disc.quad.h5 -o half_disc.msh", "quadrefine half_disc.blocks.h5 | quadexport -o half_disc.msh",
      "quadexport --unit m half_disc.quad.h5 -o half_disc.xml", "quadexport half_disc.hex.h5 -o half_disc.vtu",
      "quadexport half_disc.blocks.h5 -o half_disc.blocks.step"};
  tool.options = [&](Options& o) {
    o.input("INPUT", input, "quad mesh (x.quad.h5) or hexahedra (x.hex.h5); for .step a block layout (x.blocks.h5)");
    o.output(output, "file to write");
    declare(o, options);
  };
  tool.files = [&](cli::RunFiles& files) {
    for (const std::string& path : stage::side_paths(output, options)) files.write(path, "--output");
  };
  tool.run = [&](cli::Session& s) {
    const std::string format = stage::format_of(output, options);
    for (const stage::OutputFile& file : exported(input, output, options, format == "step", s))
      io::write_output(file.path, file.bytes, file.is_binary);
  };
  tool.report_writer = io::write_report;
  return cli::tool_main(argc, argv, tool);
}
