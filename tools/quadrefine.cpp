// Splits the blocks of a layout into the final curved quad mesh.

#include <fmt/format.h>

#include <optional>

#include "base/counted.hpp"
#include "check/check.hpp"
#include "cli/tool_main.hpp"
#include "io/output_file.hpp"
#include "io/size_field_io.hpp"
#include "io/stage_files.hpp"
#include "layers/wall_spec.hpp"
#include "mesh/element_sizes.hpp"
#include "outline/extent.hpp"
#include "refine/chosen_blocks.hpp"
#include "refine/refine.hpp"
#include "refine/validity.hpp"
#include "sizing/element_limit.hpp"
#include "sizing/make_size_field.hpp"

using namespace quadrille;

namespace {

/// The prescribed sizes in the form of the command line.
struct SizeArguments {
  sizing::SizeOptions options;
  std::vector<std::string> near, counts;
  std::string path;
  std::optional<io::InputFile> file;  ///< of `path`, once it is read
  sizing::SizeRule rule = sizing::SizeRule::nearest;
};

void declare(cli::Options& o, SizeArguments& sizes) {
  o.number("--size", sizes.options.size, 0, 1e300, "length of the file; 0: diameter / 20", "prescribed edge length");
  o.texts("--size-near", sizes.near, "NAME=H[:H2]",
          "edge length H along the boundary, interface or embedded curve NAME, growing with the distance from it; with "
          "H2 from H at its left end to H2 at the right one, as along a wake; NAME@REGION: in this region alone");
  o.input_file("--size-field", sizes.path, "FILE",
               "points and boxes with prescribed edge lengths (JSON, formats/size-field.md)", false);
  o.number("--curvature", sizes.options.curvature, 0, 1e6, "elements per full turn of the boundary",
           "edge lengths from the curvature of the boundary; 0: none");
  o.number("--growth", sizes.options.growth, 0, 100, "1",
           "greatest ratio of adjacent edge lengths, > 1, where sizes differ; 0: that of --size-field, else 1.2");
  o.choice("--size-rule", sizes.rule,
           "the number of elements of a chord whose arcs prescribe different ones: nearest deviates least from the "
           "prescribed lengths in the mean; at-most makes no edge longer than prescribed");
  o.texts("--count", sizes.counts, "CHORD=N",
          "N elements across a chord, instead of the number from the sizes; the pictures of stageview BLOCKS and "
          "arc_chord in BLOCKS show the numbers of the chords");
}

/// The texts of the command line and the file of prescribed sizes, before the blocks are read.
void parse(SizeArguments& sizes, const std::vector<std::string>& walls, refine::RefineOptions& options) {
  for (const std::string& text : sizes.near) sizes.options.near.push_back(sizing::parse_near_size(text));
  for (const std::string& text : sizes.counts) options.counts.push_back(sizing::parse_chord_count(text));
  for (const std::string& wall : walls) options.walls.push_back(layers::parse_wall_spec(wall));
  options.validate();
  sizes.options.validate();
  if (sizes.path.empty()) return;
  sizes.file = io::read_input(sizes.path);
  io::read_size_field(*sizes.file, {});
}

void set_sizes(const SizeArguments& sizes, const CadFace& face, refine::RefineOptions& options) {
  sizing::SizeOptions prescribed = sizes.options;
  if (sizes.file) prescribed.sources = io::read_size_field(*sizes.file, face.origin);
  options.size_field = sizing::make_size_field(face, prescribed);
  options.size_rule = sizes.rule;
}

/// Whether the boundaries that the options name exist, and sizes are no mistake, before there are blocks.
void check_shape(const SizeArguments& sizes, refine::RefineOptions& options, bool all_blocks, const CadFace& face) {
  set_sizes(sizes, face, options);
  layers::curve_walls(options.walls, face);
  if (options.counts.empty() && all_blocks)
    sizing::require_area_within(outline::area(face), options.size_field->greatest(),
                                {options.max_elements, options.order});
}

}  // namespace

int main(int argc, char** argv) {
  std::string input = "-", output = "-";
  refine::RefineOptions options;
  SizeArguments sizes;
  std::string blocks, shape;
  std::vector<std::string> walls;
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
  tool.examples = {"quadrefine half_disc.blocks.h5 -o half_disc.quad.h5",
                   "quadrefine --size 0.2 --order 6 half_disc.blocks.h5 -o fine.quad.h5",
                   "quadrefine --wall curve_0:first=1e-3,growth=1.3,layers=8 half_disc.blocks.h5 -o layers.quad.h5",
                   "quadrefine --size 0.2 --size-near 0=0.05 --growth 1.3 half_disc.blocks.h5 -o near.quad.h5"};
  tool.options = [&](cli::Options& o) {
    o.input("BLOCKS", input, "block layout (x.blocks.h5)");
    o.output(output, "quad mesh to write (x.quad.h5)");
    declare(o, sizes);
    o.integer("--order", options.order, 1, 20, "shape order of the elements");
    o.number(
        "--geometry-tol", options.geometry_tol, 0, 1, "diameters",
        "greatest distance between the boundary of the mesh and the CAD curves; 0: 5e-3, 5e-4, 2e-5 at orders 1, 2, 3, "
        "else 5e-7");
    o.texts("--wall", walls, "NAME:first=H,growth=R,layers=N",
            "layers along the boundary NAME (or NAME,NAME; NAME@REGION: on one side of an interface): H is the height "
            "of the first one in file units, R the greatest "
            "growth (default: 1.2), N their number or 'fit'; thickness=T may replace layers; "
            "law=uniform|geometric|tanh|gll (default: geometric)");
    o.text("--blocks", blocks, "ID,...",
           "numbers or names of blocks: only the chords through them are refined, all others get as few elements as "
           "possible");
    o.integer("--relax", options.relax, 0, 1000,
              "relaxation sweeps, which move vertices to improve the shapes of elements");
    o.number("--min-scaled-jacobian", options.min_scaled_jacobian, 0, 1, "1",
             "exit with 1 if an element has a lower scaled Jacobian; 0: no limit");
    o.number(
        "--target-edge-ratio", options.target_edge_ratio, 0, 1e300, "1",
        "where blocks are so thin that the longest side of an element exceeds its shortest by more than this factor, "
        ">= 1, elements are shorter than prescribed; 0: nowhere");
    o.number("--max-edge-ratio", options.max_edge_ratio, 0, 1e300, "1",
             "exit with 1 if the longest side of an element exceeds its shortest by more than this factor, >= 1; 0: no "
             "limit");
    o.integer(
        "--max-elements", options.max_elements, 1, 100000000,
        "refuse sizes or counts that require more quads, with exit code 1 and an estimate of their number, before they "
        "take memory");
    o.hidden_text("--check-shape", shape);
    o.flag("--allow-invalid", options.allow_invalid, "also write a mesh that is not proved valid, marked as such");
  };
  tool.run = [&](cli::Session& s) {
    parse(sizes, walls, options);
    if (!shape.empty()) return check_shape(sizes, options, blocks.empty(), io::read_face(io::read_input(shape)));
    s.begin_phase("read");
    const io::InputFile file = io::read_input(input);
    const BlockLayout layout = io::read_block_layout(file);
    check::require_valid(check::check_block_layout(layout, check::CheckDepth::quick), file.name);
    std::vector<InputDigest> inputs{file.digest("block-layout")};
    if (sizes.file) inputs.push_back(sizes.file->digest("size-field"));
    set_sizes(sizes, layout.face, options);
    if (!blocks.empty()) options.blocks = refine::parse_blocks(blocks, layout.block_names);
    s.begin_phase("refine");
    QuadMesh mesh = refine::refine(layout, options, s.report());
    mesh.provenance = s.provenance(layout.provenance, inputs);
    s.info(fmt::format("{} of order {}, the worst:", counted(mesh.num_elems(), "quad"), mesh.order));
    for (const refine::WorstElement& worst : refine::worst_elements(mesh, 5)) s.info(refine::describe(worst, mesh));
    s.info(mesh::describe(mesh::worst_element_sizes(mesh)));
    s.begin_phase("write");
    io::write_quad_mesh(output, mesh);
    s.end_phase();
  };
  tool.report_writer = io::write_report;
  return cli::tool_main(argc, argv, tool);
}
