#include "stage/quadrefine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/options.hpp"
#include "check/check.hpp"
#include "curve/named_places.hpp"
#include "field/alignment_term.hpp"
#include "layers/wall_layers.hpp"
#include "layers/wall_sags.hpp"
#include "layers/wall_spec.hpp"
#include "mesh/element_sizes.hpp"
#include "model/length_scale.hpp"
#include "outline/extent.hpp"
#include "refine/chosen_blocks.hpp"
#include "refine/even_vertices.hpp"
#include "refine/refine.hpp"
#include "refine/validity.hpp"
#include "sizing/element_limit.hpp"
#include "sizing/make_size_field.hpp"
#include "sizing/report_sizes.hpp"
#include "stage/given_positions.hpp"
#include "stage/symmetry_option.hpp"

namespace quadrille::stage {

namespace {

/// The options of a mesh and its sizes, as far as they are known without the face.
struct ParsedOptions {
  refine::RefineOptions refine;
  sizing::SizeOptions sizes;
};

void parse_walls(const QuadrefineOptions& options, refine::RefineOptions& refine) {
  for (const std::string& wall : options.walls) refine.walls.push_back(layers::parse_wall_spec(wall, options.yplus));
  const bool has_yplus = std::any_of(refine.walls.begin(), refine.walls.end(),
                                     [](const layers::WallSpec& wall) { return wall.yplus > 0; });
  if (options.yplus > 0 && !has_yplus)
    throw UsageError("--yplus is the height of wall layers: give --wall NAME:layers=N as well, without first");
  options.flow.validate(has_yplus);
}

ParsedOptions parsed(const QuadrefineOptions& options) {
  ParsedOptions all{options.refine, options.sizes};
  auto& [refine, sizes] = all;
  sizes.per_curve = sizing::parse_per_curve(options.per_curve);
  refine.relax = refine::parse_relax(options.relax);
  refine.allow_invalid |= options.is_trial;
  for (const std::string& text : options.near) sizes.near.push_back(sizing::parse_near_size(text));
  for (const std::string& text : options.counts) prescribe::parse_count(text, refine.counts, refine.boundary_counts);
  for (const std::string& text : options.gradings) refine.end_gradings.push_back(prescribe::parse_end_grading(text));
  refine.validate();
  sizes.validate();
  parse_walls(options, refine);
  return all;
}

/// The first heights that follow from y+, in the unit of the face.
void set_first_heights(const QuadrefineOptions& options, const CadFace& face, refine::RefineOptions& refine) {
  if (options.flow.velocity > 0)
    layers::set_first_heights(refine.walls, options.flow, 1 / length_scale(face, {options.flow_unit, 1, false}).factor);
}

/// Of the first layer's height, straight sides of elements may be away from their wall.
constexpr double greatest_sag = 1.0 / 3;

void set_sizes(const sizing::SizeOptions& sizes, const CadFace& face, refine::RefineOptions& refine) {
  refine.size_field = sizing::make_size_field(face, sizes);
  refine.end_growth = sizing::growth(sizes);
}

/// Of the file of directions, and of the metric, more where its lengths differ more.
refine::PrescribedDirections directions_of(const QuadrefineInput& input, double strength,
                                           const sizing::SizeField& sizes) {
  // At the usual strength 20: a side that is 12 degrees from its direction has the energy of the shape of a square, 2.
  // Beyond twice that, the shape of elements would hardly count.
  constexpr double usual_weight = 20, greatest_weight = 40;
  if (!input.alignment && !input.metric) return {};
  const CadFace& face = input.layout.model.face;
  const auto alignment = std::make_shared<const Alignment>(
      input.alignment
          ? field::make_alignment(alignment_on_face(input.alignment->model, face, "--align"), strength, face.diameter)
          : Alignment{});
  const auto term = std::make_shared<const field::AlignmentTerm>(*alignment);
  return [alignment, term, sizes](Vec2 x) {
    Vec2 sum = term->empty() ? Vec2{} : usual_weight * term->at(x).pull;
    if (sizes.has_metric()) sum += usual_weight * sizing::direction_of(sizes.directed(x));
    return std::min(1.0, greatest_weight / norm(sum)) * sum;
  };
}

/// The walls with the first heights that follow from y+, as far as these are known without the face: if the flow is
/// given in units of the file.
std::vector<layers::WallSpec> walls_of(const QuadrefineOptions& options) {
  std::vector<layers::WallSpec> walls = parsed(options).refine.walls;
  if (options.flow.velocity > 0 && options.flow_unit == "file") layers::set_first_heights(walls, options.flow, 1);
  return walls;
}

void report_worst(const QuadMesh& mesh, const Run& run) {
  run.info(fmt::format("{} of order {}, the worst:", counted(mesh.num_elems(), "quad"), mesh.order));
  for (const refine::WorstElement& worst : refine::worst_elements(mesh, 5)) run.info(refine::describe(worst, mesh));
  run.info(mesh::describe(mesh::worst_element_sizes(mesh), mesh.face));
}

void declare_sizes(Options& o, QuadrefineOptions& options) {
  o.number("--size", options.sizes.size, 0, 1e300, "length of the file; 0: diameter / 20", "prescribed edge length");
  o.text(
      "--per-curve", options.per_curve, "auto|N",
      "at least N elements along each boundary curve between corners or names, 3 N around a smooth closed one; sizes "
      "grow from there to --size; 0: no limit; auto: 0 if a size is prescribed, else 4, as far as that makes at most "
      "twice as many elements; with a far field (curves called farfield) however many, and elements grow by 5 % from "
      "one to the next along curves called wake");
  declare_symmetry(o, options.symmetry);
  o.texts("--size-near", options.near, "NAME=H[:H2]",
          "edge length H along the boundary, interface or embedded curve NAME, growing with the distance from it; with "
          "H2 from H at its left end to H2 at the right one, as along a wake; NAME@REGION: in this region alone");
  o.input_file(
      "--size-field", options.size_field_file, "FILE",
      "prescribed edge lengths: points and boxes (JSON), or a table of x, y and size between whose points they "
      "are linear (CSV; quadrille.vtu_sizes in Python makes it of a VTU file); on a curved face positions have x, y "
      "and z (formats/size-field.md)",
      false);
  o.input_file(
      "--metric", options.metric_file, "FILE",
      "prescribed edge lengths that differ by direction: a table of x, y, h1, h2 and the angle of h1, or of x, "
      "y and a tensor (CSV; quadrille.vtu_sizes in Python makes it of a VTU file), as --align reads it "
      "(formats/alignment.md); other sizes limit them",
      false);
  o.input_file(
      "--align", options.align_file, "FILE",
      "directions inside the domain that the sides of elements follow where vertices move: at points, along "
      "curves, in boxes (JSON), or those of a metric (CSV); quadmesh gives them to fieldsolve too, so that the "
      "crosses and with them the blocks follow them (formats/alignment.md)",
      false);
  o.number("--align-strength", options.align_strength, 0, 1000, "1",
           "weight of these, over that of each feature of the file");
  o.number("--curvature", options.sizes.curvature, 0, 1e6, "elements per full turn of the boundary",
           "edge lengths from the curvature of the boundary; 0: none");
  o.number("--growth", options.sizes.growth, 0, 100, "1",
           "greatest ratio of adjacent edge lengths, > 1, where sizes differ; 0: that of --size-field, else 1.2");
  o.choice("--size-rule", options.refine.size_rule,
           "the number of elements of each chord: nearest deviates least from the prescribed lengths in the mean; "
           "at-most makes no edge longer than prescribed; error begins with nearest, and then moves elements from "
           "chord to chord as long as this lowers the error of a smooth solution at their number; elements are shorter "
           "only where the boundary needs it. With --wall or --blocks, or without --relax size, error is nearest");
}

void declare_counts(Options& o, QuadrefineOptions& options) {
  o.texts("--count", options.counts, "CHORD=N|NAME=N[,even]",
          "N elements across a chord, or along the boundary NAME (all its curves together; each side of an interface "
          "that has nodes of its own), instead of the number from the sizes; even: of equal lengths along each of its "
          "curves, from its start on, as both sides of a sliding band need; the pictures of stageview BLOCKS and "
          "arc_chord in BLOCKS show the numbers of the chords");
  o.texts(
      "--grading", options.gradings, "NAME=FIRST:LAST",
      "lengths of the elements at both ends of the boundary NAME, in file units, in the direction in which the face "
      "is on the left (one may be left out: NAME=FIRST:); towards its middle they grow by at most --growth to the "
      "prescribed sizes, with --count as fast as the number requires");
}

void declare_walls(Options& o, QuadrefineOptions& options) {
  o.texts("--wall", options.walls, "NAME:first=H,growth=R,layers=N",
          "layers along the boundary NAME (or NAME,NAME; NAME@REGION: on one side of an interface): H is the height "
          "of the first one in file units (or yplus=Y in its place), R the greatest "
          "growth (default: 1.2), N their number or 'fit'; thickness=T may replace layers; "
          "law=uniform|geometric|tanh|gll (default: geometric); blocks=own: below a curve of cad2tri --offset, so that "
          "all layers fit. quadmesh makes that curve, or else moves irregular nodes away from the wall (critpoints "
          "--clearance), unless N is fit");
  o.number("--yplus", options.yplus, 0, 1e300, "1",
           "y+ of the first layer's height for each --wall without first and yplus: y = y+ NU / u_tau, u_tau = U "
           "sqrt(c_f / 2), with the skin friction of a turbulent flat plate c_f = (2 log10 Re - 0.65)^-2.3, Re = U L / "
           "NU from 5e5 to 1e9 (H. Schlichting, Boundary-Layer Theory, 1979); 0: none");
  o.number("--velocity", options.flow.velocity, 0, 1e300, "--unit / s", "U, of the free stream, for y+; 0: not given");
  o.number("--viscosity", options.flow.viscosity, 0, 1e300, "--unit^2 / s", "NU, kinematic, for y+; 0: not given");
  o.number("--length", options.flow.length, 0, 1e300, "--unit",
           "L, the distance from the leading edge at which y+ applies; 0: not given");
  std::vector<std::string> units{"file"};
  for (const LengthUnit& unit : length_units) units.emplace_back(unit.symbol);
  o.choice("--unit", options.flow_unit, units,
           "length unit of --velocity, --viscosity and --length, that in which quadexport --unit writes coordinates; "
           "file: that of the CAD file");
}

void declare_limits(Options& o, refine::RefineOptions& refine) {
  o.number("--min-scaled-jacobian", refine.min_scaled_jacobian, 0, 1, "1",
           "exit with 1 if an element has a lower scaled Jacobian; 0: no limit");
  o.number(
      "--target-edge-ratio", refine.target_edge_ratio, 0, 1e300, "1",
      "where blocks are so thin that the longest side of an element exceeds its shortest by more than this factor, "
      ">= 1, elements are shorter than prescribed; 0: nowhere");
  o.number("--target-growth", refine.target_growth, 0, 100, "1",
           "with --wall, where adjacent edges along lines across blocks, from wall to wall, would differ by more than "
           "this factor, > 1, ends of elements move and chords get more elements; 0: nowhere");
  o.number("--max-edge-ratio", refine.max_edge_ratio, 0, 1e300, "1",
           "exit with 1 if the longest side of an element exceeds its shortest by more than this factor, >= 1; 0: no "
           "limit");
  o.integer(
      "--max-elements", refine.max_elements, 1, 100000000,
      "refuse sizes or counts that require more quads, with exit code 1 and an estimate of their number, before they "
      "take memory");
  o.flag("--allow-invalid", refine.allow_invalid, "also write a mesh that is not proved valid, marked as such");
}

}  // namespace

void QuadrefineOptions::validate() const { parsed(*this); }

void declare(Options& o, QuadrefineOptions& options) {
  declare_sizes(o, options);
  declare_counts(o, options);
  o.integer("--order", options.refine.order, 1, 20, "shape order of the elements");
  o.number(
      "--geometry-tol", options.refine.geometry_tol, 0, 1, "diameters",
      "greatest distance between the boundary of the mesh and the CAD curves; 0: 5e-3, 5e-4, 2e-5 at orders 1, 2, 3, "
      "else 5e-7");
  declare_walls(o, options);
  o.flag("--straight-sides", options.has_straight_sides,
         "for programs whose elements have straight sides, such as OpenFOAM: along walls with layers, and along lines "
         "on which these go on, sizes are those at which straight sides are a third of the first layer's height away "
         "from the curve; quadmesh sets it for their formats");
  o.text("--blocks", options.blocks, "ID,...",
         "numbers or names of blocks: only the chords through them are refined, all others get as few elements as "
         "possible");
  o.choice("--inner-edges", options.refine.inner_edges,
           "edges that lie on no CAD curve: straight where elements allow it, which makes solutions most accurate; "
           "curved as the blocks are; fade: curved, by half as much from row to row behind a curved boundary. Layers "
           "along walls keep their shape");
  o.text(
      "--relax", options.relax, "size|shape|none",
      "move vertices, also those on sides of blocks and irregular ones, those of boundaries and interfaces along them: "
      "size: to the prescribed edge lengths, and where the boundary is bent to those that turn by 15 degrees, but not "
      "below three quarters of the greatest; shape: to the angles of rectangles, with the lengths as they are; none: "
      "not. "
      "Layers along walls keep their vertices, and all do with --blocks");
  o.integer("--relax-sweeps", options.refine.relax_sweeps, 0, 1000, "greatest number of steps of --relax");
  o.choice(
      "--rings", options.refine.rings,
      "around holes shorter than 12/20 diameters whose radius is below the prescribed edge lengths: auto: edges that "
      "point away from the hole are shorter, from 0.9 radii on by a factor of 1.5 from row to row, and there is one "
      "row more; none: not. Not in faces of several regions, with slits, periodic sides or lines of symmetry; only "
      "with --relax size and --size-rule error, without --wall and --blocks");
  o.integer("--refine", options.refine.levels, 0, 10,
            "nested refinement, for studies of convergence: at the end each element becomes 2^N x 2^N elements of its "
            "own map, so that the geometry and all vertices stay as they are");
  declare_limits(o, options.refine);
}

QuadMesh quadrefine(const QuadrefineInput& input, const QuadrefineOptions& options, Run& run) {
  require_intervals(options);
  auto [refine, sizes] = parsed(options);
  const BlockLayout& layout = input.layout.model;
  check::require_sound(layout, input.layout.file.name);
  std::vector<InputDigest> inputs{input.layout.file.digest("block-layout")};
  if (input.sizes) {
    sizes.sources = sizes_on_face(input.sizes->model, layout.face, options.join_points, "--size-field");
    inputs.push_back(input.sizes->file.digest("size-field"));
  }
  if (input.metric) {
    sizes.sources.metric = metric_on_face(input.metric->model, layout.face, "--metric");
    inputs.push_back(input.metric->file.digest("metric"));
  }
  if (input.alignment) inputs.push_back(input.alignment->file.digest("alignment"));
  refine::require_even_alone(layout.face, refine, sizes.near);
  sizes.symmetry = refine.symmetry = symmetry_names(layout.face, options.symmetry);
  set_first_heights(options, layout.face, refine);
  sizes.scale = sizing::chart_scale(layout.face);
  const sizing::MeasuredLayout measured(layout);
  if (options.has_straight_sides && layout.face.chart)
    throw UsageError("--straight-sides: this face is curved, and so are its elements, whose sides follow the surface");
  if (options.has_straight_sides) sizes.sags = layers::wall_sags(measured, refine.walls, greatest_sag);
  const sizing::SizeOptions without_curves = sizes;
  sizes = sizing::with_curve_sizes(measured, sizes, refine.size_rule);
  set_sizes(sizes, layout.face, refine);
  refine.directions = directions_of(input, options.align_strength, *refine.size_field);
  run.report().set("sizes.per_curve", sizes.per_curve);
  run.report().set("sizes.least_along_curves", sizes.least_along_curves);
  if (options.flow.velocity > 0) layers::report_flow(options.flow, run.report());
  if (!options.blocks.empty()) refine.blocks = refine::parse_blocks(options.blocks, layout.block_names);
  layers::require_offsets(refine.walls, layout.face);
  run.begin_phase("refine");
  QuadMesh mesh = refine::refine(layout, refine, run.report());
  mesh.provenance = with_step(layout.provenance, "quadrefine", options, std::move(inputs));
  report_worst(mesh, run);
  run.info(sizing::report_verdict(measured, mesh, without_curves, sizes, run.report()));
  run.end_phase();
  return mesh;
}

void require_quadrefine_of(const CadFace& face, const SizeSources& sources, const GivenMetric& metric,
                           const QuadrefineOptions& options) {
  require_intervals(options);
  auto [refine, sizes] = parsed(options);
  sizes.sources = sizes_on_face(sources, face, options.join_points, "--size-field");
  if (!metric.in_plane.empty()) sizes.sources.metric = metric_on_face(metric, face, "--metric");
  set_first_heights(options, face, refine);
  set_sizes(sizes, face, refine);
  layers::curve_walls(refine.walls, face);
  layers::require_offsets(refine.walls, face);
  for (const auto& count : refine.boundary_counts) curve::named_curves(face, count.boundary, "--count");
  refine::require_even_alone(face, refine, sizes.near);
  for (const auto& grading : refine.end_gradings) curve::named_curves(face, grading.boundary, "--grading");
  if (refine.counts.empty() && refine.boundary_counts.empty() && options.blocks.empty())
    sizing::require_area_within(outline::area(face), refine.size_field->greatest(),
                                {refine.max_elements, refine.order});
}

std::vector<std::string> offsets_of(const QuadrefineOptions& options) {
  std::vector<std::string> offsets;
  for (const layers::WallSpec& wall : walls_of(options))
    if (wall.own_blocks)
      offsets.push_back(fmt::format("{}={:.17g}", fmt::join(wall.names, ","), layers::block_height(wall)));
  return offsets;
}

std::vector<std::string> clearances_of(const QuadrefineOptions& options) {
  std::vector<std::string> clearances;
  for (const layers::WallSpec& wall : walls_of(options)) {
    if (wall.own_blocks || wall.as_many_as_fit || !(wall.first > 0)) continue;
    for (const std::string& name : wall.names)
      if (name.find('@') == std::string::npos)
        clearances.push_back(fmt::format("{}={:.17g}", name, layers::node_clearance(wall)));
  }
  return clearances;
}

}  // namespace quadrille::stage
