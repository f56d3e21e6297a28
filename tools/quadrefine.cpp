// Splits the blocks of a layout into the final curved quad mesh.

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/counted.hpp"
#include "check/check.hpp"
#include "cli/tool_main.hpp"
#include "curve/named_curves.hpp"
#include "io/output_file.hpp"
#include "io/size_field_io.hpp"
#include "io/stage_files.hpp"
#include "layers/layer_law.hpp"
#include "layers/wall_layers.hpp"
#include "mesh/element_sizes.hpp"
#include "model/length_scale.hpp"
#include "outline/extent.hpp"
#include "prescribe/flat_plate.hpp"
#include "refine/chosen_blocks.hpp"
#include "refine/refine.hpp"
#include "refine/validity.hpp"
#include "sizing/automatic_sizes.hpp"
#include "sizing/element_limit.hpp"
#include "sizing/make_size_field.hpp"
#include "triangulate/size_triangles.hpp"

using namespace quadrille;

namespace {

/// The walls and the flow along them in the form of the command line.
struct WallArguments {
  std::vector<std::string> walls;
  double yplus = 0;
  prescribe::PlateFlow flow;
  std::string unit = "file";
};

/// The prescribed sizes in the form of the command line.
struct SizeArguments {
  sizing::SizeOptions options;
  std::vector<std::string> near, counts, gradings;
  std::string per_curve = "auto";
  std::string path;
  std::optional<io::InputFile> file;  ///< of `path`, once it is read
  sizing::SizeRule rule = sizing::SizeRule::nearest;
};

void declare(cli::Options& o, SizeArguments& sizes) {
  o.number("--size", sizes.options.size, 0, 1e300, "length of the file; 0: diameter / 20", "prescribed edge length");
  o.text(
      "--per-curve", sizes.per_curve, "auto|N",
      "at least N elements along each boundary curve between corners or names, 3 N around a smooth closed one; sizes "
      "grow from there to --size; 0: no limit; auto: 0 if a size is prescribed, else 4, as far as that makes at most "
      "twice as many elements; with a far field (curves called farfield) however many, and elements grow by 5 % from "
      "one "
      "to the next along curves called wake");
  o.texts("--size-near", sizes.near, "NAME=H[:H2]",
          "edge length H along the boundary, interface or embedded curve NAME, growing with the distance from it; with "
          "H2 from H at its left end to H2 at the right one, as along a wake; NAME@REGION: in this region alone");
  o.input_file(
      "--size-field", sizes.path, "FILE",
      "prescribed edge lengths: points and boxes (JSON), or a table of x, y and size between whose points they "
      "are linear (CSV; quadrille.vtu_sizes in Python makes it of a VTU file) (formats/size-field.md)",
      false);
  o.number("--curvature", sizes.options.curvature, 0, 1e6, "elements per full turn of the boundary",
           "edge lengths from the curvature of the boundary; 0: none");
  o.number("--growth", sizes.options.growth, 0, 100, "1",
           "greatest ratio of adjacent edge lengths, > 1, where sizes differ; 0: that of --size-field, else 1.2");
  o.choice("--size-rule", sizes.rule,
           "the number of elements of a chord whose arcs prescribe different ones: nearest deviates least from the "
           "prescribed lengths in the mean; at-most makes no edge longer than prescribed");
  o.texts("--count", sizes.counts, "CHORD=N|NAME=N",
          "N elements across a chord, or along the boundary NAME (all its curves together), instead of the number from "
          "the sizes; the pictures of stageview BLOCKS and arc_chord in BLOCKS show the numbers of the chords");
  o.texts(
      "--grading", sizes.gradings, "NAME=FIRST:LAST",
      "lengths of the elements at both ends of the boundary NAME, in file units, in the direction in which the face "
      "is on the left (one may be left out: NAME=FIRST:); towards its middle they grow by at most --growth to the "
      "prescribed sizes, with --count as fast as the number requires");
}

void declare(cli::Options& o, WallArguments& walls) {
  o.texts("--wall", walls.walls, "NAME:first=H,growth=R,layers=N",
          "layers along the boundary NAME (or NAME,NAME; NAME@REGION: on one side of an interface): H is the height "
          "of the first one in file units (or yplus=Y in its place), R the greatest "
          "growth (default: 1.2), N their number or 'fit'; thickness=T may replace layers; "
          "law=uniform|geometric|tanh|gll (default: geometric); blocks=own: below a curve of cad2tri --offset, so that "
          "all layers fit. quadmesh makes that curve, or else moves irregular nodes away from the wall (critpoints "
          "--clearance), unless N is fit");
  o.number("--yplus", walls.yplus, 0, 1e300, "1",
           "y+ of the first layer's height for each --wall without first and yplus: y = y+ NU / u_tau, u_tau = U "
           "sqrt(c_f / 2), with the skin friction of a turbulent flat plate c_f = (2 log10 Re - 0.65)^-2.3, Re = U L / "
           "NU from 5e5 to 1e9 (H. Schlichting, Boundary-Layer Theory, 1979); 0: none");
  o.number("--velocity", walls.flow.velocity, 0, 1e300, "--unit / s", "U, of the free stream, for y+; 0: not given");
  o.number("--viscosity", walls.flow.viscosity, 0, 1e300, "--unit^2 / s", "NU, kinematic, for y+; 0: not given");
  o.number("--length", walls.flow.length, 0, 1e300, "--unit",
           "L, the distance from the leading edge at which y+ applies; 0: not given");
  std::vector<std::string> units{"file"};
  for (const LengthUnit& unit : length_units) units.emplace_back(unit.symbol);
  o.choice("--unit", walls.unit, units,
           "length unit of --velocity, --viscosity and --length, that in which quadexport --unit writes coordinates; "
           "file: that of the CAD file");
}

void parse(const WallArguments& walls, refine::RefineOptions& options) {
  for (const std::string& wall : walls.walls) options.walls.push_back(layers::parse_wall_spec(wall, walls.yplus));
  const bool has_yplus = std::any_of(options.walls.begin(), options.walls.end(),
                                     [](const layers::WallSpec& wall) { return wall.yplus > 0; });
  if (walls.yplus > 0 && !has_yplus)
    throw UsageError("--yplus is the height of wall layers: give --wall NAME:layers=N as well, without first");
  walls.flow.validate(has_yplus);
}

/// The first heights that follow from y+, in the unit of the face.
void set_first_heights(const WallArguments& walls, const CadFace& face, refine::RefineOptions& options) {
  if (walls.flow.velocity > 0)
    layers::set_first_heights(options.walls, walls.flow, 1 / length_scale(face, {walls.unit, 1, false}).factor);
}

/// The texts of the command line and the file of prescribed sizes, before the blocks are read.
void parse(SizeArguments& sizes, refine::RefineOptions& options) {
  sizes.options.per_curve = sizing::parse_per_curve(sizes.per_curve);
  options.size_rule = sizes.rule;
  for (const std::string& text : sizes.near) sizes.options.near.push_back(sizing::parse_near_size(text));
  for (const std::string& text : sizes.counts) prescribe::parse_count(text, options.counts, options.boundary_counts);
  for (const std::string& text : sizes.gradings) options.end_gradings.push_back(prescribe::parse_end_grading(text));
  options.validate();
  sizes.options.validate();
  if (sizes.path.empty()) return;
  sizes.file = io::read_input(sizes.path);
  io::read_size_field(*sizes.file, {});
}

/// With the sources of the file.
sizing::SizeOptions prescribed_sizes(const SizeArguments& sizes, const CadFace& face) {
  sizing::SizeOptions prescribed = sizes.options;
  if (sizes.file) prescribed.sources = io::read_size_field(*sizes.file, face.origin);
  if (prescribed.sources.is_table) triangulate::add_size_triangles(prescribed.sources);
  return prescribed;
}

void set_sizes(const sizing::SizeOptions& prescribed, const CadFace& face, refine::RefineOptions& options) {
  options.size_field = sizing::make_size_field(face, prescribed);
  options.end_growth = sizing::growth(prescribed);
}

/// The walls with the first heights that follow from y+, as far as these are known without the face: if the flow is
/// given in units of the file.
std::vector<layers::WallSpec> walls_of(const WallArguments& walls, std::vector<layers::WallSpec> specs) {
  if (walls.flow.velocity > 0 && walls.unit == "file") layers::set_first_heights(specs, walls.flow, 1);
  return specs;
}

/// For pipelines: "NAMES=T", one a line, for cad2tri --offset.
std::string offsets_of(const std::vector<layers::WallSpec>& walls) {
  std::string text;
  for (const layers::WallSpec& wall : walls)
    if (wall.own_blocks) text += fmt::format("{}={:.17g}\n", fmt::join(wall.names, ","), layers::block_height(wall));
  return text;
}

/// For pipelines: "NAME=T", one a line, for critpoints --clearance: the room that layers without blocks of their own
/// need below the irregular nodes. Not of walls on one side of an interface, from which nodes keep away on both.
std::string clearances_of(const std::vector<layers::WallSpec>& walls) {
  std::string text;
  for (const layers::WallSpec& wall : walls) {
    if (wall.own_blocks || wall.as_many_as_fit || !(wall.first > 0)) continue;
    for (const std::string& name : wall.names)
      if (name.find('@') == std::string::npos) text += fmt::format("{}={:.17g}\n", name, layers::node_clearance(wall));
  }
  return text;
}

/// Whether the boundaries that the options name exist, and sizes are no mistake, before there are blocks.
void check_shape(const SizeArguments& sizes, refine::RefineOptions& options, bool all_blocks, const CadFace& face) {
  set_sizes(prescribed_sizes(sizes, face), face, options);
  layers::curve_walls(options.walls, face);
  layers::require_offsets(options.walls, face);
  for (const auto& count : options.boundary_counts) curve::named_curves(face, count.boundary, "--count");
  for (const auto& grading : options.end_gradings) curve::named_curves(face, grading.boundary, "--grading");
  if (options.counts.empty() && options.boundary_counts.empty() && all_blocks)
    sizing::require_area_within(outline::area(face), options.size_field->greatest(),
                                {options.max_elements, options.order});
}

}  // namespace

int main(int argc, char** argv) {
  std::string input = "-", output = "-";
  refine::RefineOptions options;
  SizeArguments sizes;
  WallArguments walls;
  std::string blocks, shape, offsets, clearances;
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
    declare(o, walls);
    o.text("--blocks", blocks, "ID,...",
           "numbers or names of blocks: only the chords through them are refined, all others get as few elements as "
           "possible");
    o.integer("--relax", options.relax, 0, 1000,
              "relaxation sweeps, which move vertices to improve the shapes of elements");
    o.integer(
        "--refine", options.levels, 0, 10,
        "nested refinement, for studies of convergence: at the end each element becomes 2^K x 2^K elements of its "
        "own map, so that the geometry and all vertices stay as they are");
    o.number("--min-scaled-jacobian", options.min_scaled_jacobian, 0, 1, "1",
             "exit with 1 if an element has a lower scaled Jacobian; 0: no limit");
    o.number(
        "--target-edge-ratio", options.target_edge_ratio, 0, 1e300, "1",
        "where blocks are so thin that the longest side of an element exceeds its shortest by more than this factor, "
        ">= 1, elements are shorter than prescribed; 0: nowhere");
    o.number(
        "--target-growth", options.target_growth, 0, 100, "1",
        "with --wall, where adjacent edges along lines across blocks, from wall to wall, would differ by more than "
        "this factor, > 1, ends of elements move and chords get more elements; 0: nowhere");
    o.number("--max-edge-ratio", options.max_edge_ratio, 0, 1e300, "1",
             "exit with 1 if the longest side of an element exceeds its shortest by more than this factor, >= 1; 0: no "
             "limit");
    o.integer(
        "--max-elements", options.max_elements, 1, 100000000,
        "refuse sizes or counts that require more quads, with exit code 1 and an estimate of their number, before they "
        "take memory");
    o.hidden_text("--check-shape", shape);
    o.hidden_text("--write-offsets", offsets);
    o.hidden_text("--write-clearances", clearances);
    o.flag("--allow-invalid", options.allow_invalid, "also write a mesh that is not proved valid, marked as such");
  };
  tool.run = [&](cli::Session& s) {
    parse(sizes, options);
    parse(walls, options);
    if (!offsets.empty()) return io::write_output(offsets, offsets_of(walls_of(walls, options.walls)), false);
    if (!clearances.empty()) return io::write_output(clearances, clearances_of(walls_of(walls, options.walls)), false);
    if (!shape.empty()) {
      const CadFace face = io::read_face(io::read_input(shape));
      set_first_heights(walls, face, options);
      return check_shape(sizes, options, blocks.empty(), face);
    }
    s.begin_phase("read");
    const io::InputFile file = io::read_input(input);
    const BlockLayout layout = io::read_block_layout(file);
    check::require_valid(check::check_block_layout(layout, check::CheckDepth::quick), file.name);
    std::vector<InputDigest> inputs{file.digest("block-layout")};
    if (sizes.file) inputs.push_back(sizes.file->digest("size-field"));
    const sizing::SizeOptions chosen = sizing::with_curve_sizes(
        sizing::MeasuredLayout(layout), prescribed_sizes(sizes, layout.face), options.size_rule);
    set_sizes(chosen, layout.face, options);
    s.report().set("sizes.per_curve", chosen.per_curve);
    s.report().set("sizes.least_along_curves", chosen.least_along_curves);
    set_first_heights(walls, layout.face, options);
    if (walls.flow.velocity > 0) prescribe::report_flow(walls.flow, s.report());
    if (!blocks.empty()) options.blocks = refine::parse_blocks(blocks, layout.block_names);
    layers::require_offsets(options.walls, layout.face);
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
