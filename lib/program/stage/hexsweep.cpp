#include "stage/hexsweep.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/name_text.hpp"
#include "base/number_list.hpp"
#include "base/tolerance.hpp"
#include "base/warning_codes.hpp"
#include "check/check.hpp"
#include "sweep/layer_ends.hpp"
#include "sweep/sweep.hpp"
#include "sweep/terrain.hpp"

namespace quadrille::stage {

namespace {

constexpr double usual_turn = 15;        ///< degrees of a layer at most, where the number of layers is free
constexpr double greatest_error = 1e-2;  ///< diameters of the body from the motion, beyond which there is a warning

/// Numbers with commas between them, as many as one of `counts`.
std::vector<double> required_numbers(const std::string& option, const std::string& text, const std::vector<int>& counts,
                                     const std::string& form) {
  std::vector<double> numbers = numbers_of(text);
  if (std::ranges::find(counts, std::ssize(numbers)) == counts.end())
    throw UsageError(fmt::format("{}: '{}' is not {}", option, text, form));
  return numbers;
}

Vec3 parsed_along(const std::string& text) {
  const std::vector<double> x = required_numbers("--along", text, {3}, "X,Y,Z");
  const Vec3 along{x[0], x[1], x[2]};
  if (!(norm(along) > 0)) throw UsageError("--along: the vector must not be zero");
  return along;
}

std::vector<double> parsed_axis(const std::string& text) {
  return required_numbers("--axis", text, {4, 6}, "X1,Y1,X2,Y2, two points in the plane of the face, nor six numbers");
}

void require_one_motion(const HexsweepOptions& options) {
  std::vector<std::string> given;
  if (options.height > 0) given.emplace_back("--height");
  if (!options.along.empty()) given.emplace_back("--along");
  if (!options.curve_file.empty()) given.emplace_back("--curve");
  if (options.revolve != 0) given.emplace_back("--revolve");
  if (given.size() > 1) throw UsageError(fmt::format("{}: give one of them", fmt::join(given, ", ")));
  if ((options.revolve != 0) == options.axis.empty()) throw UsageError("--revolve and --axis need each other");
}

/// The end of a full turn is the beginning.
void require_closed_turn(const HexsweepOptions& options) {
  constexpr double full_turn = 360;
  if (std::abs(options.revolve) != full_turn) return;
  if (options.twist != 0 || options.taper != 1)
    throw UsageError("--revolve 360 closes, and with --twist or --taper its end is not its beginning: turn by less");
  if (options.is_one_layer || options.has_periodic_ends)
    throw UsageError("--revolve 360 has no ends: leave out --one-layer and --periodic-ends");
  const HexsweepOptions unnamed;
  if (options.bottom_name != unnamed.bottom_name || options.top_name != unnamed.top_name)
    throw UsageError("--revolve 360 has no ends: leave out --bottom-name and --top-name");
}

/// Shorter sweeps have heights of layers that are rounding errors.
void require_length(const QuadMesh& quads, const sweep::SweepMotion& motion) {
  constexpr double least = 1e-12;  // diameters, or radians
  const double length = motion.shape().axis ? std::abs(motion.shape().angle) : motion.length() / quads.face.diameter;
  if (!(length >= least))
    throw UsageError(fmt::format("the sweep is only {:.3g} {} long: make it longer", length,
                                 motion.shape().axis ? "radians" : "diameters of the face"));
}

sweep::LayerPlan parsed_layers(const HexsweepOptions& options) {
  sweep::LayerPlan plan{options.is_one_layer ? 1 : options.layers, options.layer_growth, {}, {}};
  if (!options.bottom_layers.empty()) plan.bottom = layers::parse_layer_spec("--bottom-layers", options.bottom_layers);
  if (!options.top_layers.empty()) plan.top = layers::parse_layer_spec("--top-layers", options.top_layers);
  const bool has_ends = plan.bottom || plan.top;
  if (has_ends && options.revolve != 0)
    throw UsageError("--bottom-layers and --top-layers have one height everywhere: with --revolve use --layer-growth");
  if (has_ends && options.layer_growth != 1)
    throw UsageError("--layer-growth: between --bottom-layers and --top-layers the growth follows from their number");
  if (options.is_one_layer && (has_ends || options.layers > 1 || options.layer_growth != 1))
    throw UsageError("--one-layer excludes --layers, --layer-growth, --bottom-layers and --top-layers");
  return plan;
}

/// A point of the plane of the face, with face.origin.
Vec3 in_plane(const CadFace& face, double x, double y) { return sweep::in_model(face, Vec2{x, y} - face.origin); }

sweep::Axis axis_of(const CadFace& face, const std::string& text) {
  const std::vector<double> x = parsed_axis(text);
  if (x.size() == 4 && face.chart)
    throw UsageError("--axis: this face is curved: give two points in space, X1,Y1,Z1,X2,Y2,Z2");
  const Vec3 a = x.size() == 4 ? in_plane(face, x[0], x[1]) : Vec3{x[0], x[1], x[2]};
  const Vec3 b = x.size() == 4 ? in_plane(face, x[2], x[3]) : Vec3{x[3], x[4], x[5]};
  if (!(distance(a, b) > 0)) throw UsageError("--axis: its two points must differ");
  return {a, normalized(b - a)};
}

/// Nodes must be away from the axis, and all of a planar face on one side of it.
void require_off_axis(const QuadMesh& quads, const std::vector<Vec3>& nodes, const sweep::Axis& axis) {
  const Vec3 normal = quads.face.chart ? Vec3{} : sweep::normal_of(quads.face);
  bool is_left = false, is_right = false;
  double least = 1e300;
  Vec3 nearest;
  for (const Vec3 x : nodes) {
    const Vec3 velocity = cross(axis.direction, x - axis.point);
    if (norm(velocity) < least) least = norm(velocity), nearest = x;
    (dot(velocity, normal) > 0 ? is_left : is_right) = true;
  }
  const char* remedy =
      "move --axis, or cut the face off at a distance from it in the CAD program: hexahedra cannot end in a line";
  if (least <= tolerance::same_point * quads.face.diameter)
    throw UsageError(fmt::format("--revolve: the face touches the axis at {}: {}", position_text(nearest), remedy));
  if (!quads.face.chart && is_left && is_right)
    throw UsageError(fmt::format("--revolve: the face crosses the axis, near {}: {}", position_text(nearest), remedy));
}

void require_curve(const PointList& points, const std::string& file) {
  bool is_sound = points.size() >= 2;
  for (std::size_t i = 1; i < points.size(); ++i) is_sound = is_sound && distance(points[i - 1], points[i]) > 0;
  if (!is_sound) throw UsageError(fmt::format("--curve {}: give at least two points, each apart from the next", file));
}

/// The mean side of the quads.
double usual_size(const QuadMesh& quads, const std::vector<Vec3>& nodes) {
  double sum = 0;
  for (int e = 0; e < quads.num_elems(); ++e) {
    const auto corner = [&](int k) { return nodes[side_start(quads, e, k)]; };
    sum += std::sqrt(norm(cross(corner(2) - corner(0), corner(3) - corner(1))) / 2);
  }
  return sum / quads.num_elems();
}

Vec3 centre_of(const QuadMesh& quads, const std::string& text) {
  if (!text.empty()) {
    const std::vector<double> x = required_numbers("--centre", text, {2}, "X,Y");
    return in_plane(quads.face, x[0], x[1]);
  }
  Vec2 low = quads.nodes.front(), high = low;
  for (const Vec2 x : quads.nodes) {
    low = {std::min(low.x, x.x), std::min(low.y, x.y)};
    high = {std::max(high.x, x.x), std::max(high.y, x.y)};
  }
  return sweep::in_model(quads.face, (low + high) / 2);
}

sweep::SweepShape shape_of(const HexsweepInput& input, const HexsweepOptions& options, double usual) {
  const QuadMesh& quads = input.quads.model;
  sweep::SweepShape shape;
  const bool is_curved = quads.face.chart != nullptr;
  if (is_curved && !input.curve && options.revolve == 0 && options.along.empty())
    throw UsageError("--height: this face is curved and has no one normal: give --along X,Y,Z");
  if (is_curved && (options.twist != 0 || options.taper != 1 || input.terrain))
    throw UsageError("--twist, --taper and --terrain are for planar faces, but this one is curved");
  if (!is_curved) shape.normal = sweep::normal_of(quads.face), shape.centre = centre_of(quads, options.centre);
  shape.twist = radians(options.twist), shape.taper = options.taper;
  if (input.curve)
    require_curve(input.curve->model, input.curve->file.name), shape.curve = input.curve->model;
  else if (options.revolve != 0)
    shape.axis = axis_of(quads.face, options.axis), shape.angle = radians(options.revolve);
  else if (!options.along.empty())
    shape.along = parsed_along(options.along);
  else
    shape.along = (options.height > 0 ? options.height : usual * std::max(1, options.layers)) * shape.normal;
  return shape;
}

std::vector<double> ends_of(const HexsweepOptions& options, const sweep::SweepMotion& motion,
                            const std::vector<Vec3>& nodes, double usual) {
  sweep::LayerPlan plan = parsed_layers(options);
  if (!motion.shape().axis) {
    const double length = motion.length(), turns = degrees(std::abs(motion.shape().twist)) / usual_turn;
    return sweep::layer_ends(plan, length, turns > 0 ? std::min(usual, length / turns) : usual);
  }
  double sum = 0;
  const sweep::Axis& axis = *motion.shape().axis;
  for (const Vec3 x : nodes) sum += norm(cross(axis.direction, x - axis.point));
  const double angle = std::abs(motion.shape().angle);
  std::vector<double> ends =
      sweep::layer_ends(plan, angle, std::min(radians(usual_turn), usual * static_cast<double>(nodes.size()) / sum));
  constexpr std::size_t least_closed = 3;
  if (motion.is_closed() && ends.size() <= least_closed)
    throw UsageError(fmt::format("--layers {}: a full turn needs at least {}", ends.size() - 1, least_closed));
  return ends;
}

/// By node of the quads: the height of the terrain over the plane of the face.
std::vector<double> heights_of(const HexsweepInput& input, const HexsweepOptions& options) {
  if (!input.terrain) return {};
  const sweep::Terrain terrain(input.terrain->model, input.terrain->file.name);
  const QuadMesh& quads = input.quads.model;
  std::vector<double> heights;
  for (const Vec2 x : quads.nodes) heights.push_back(terrain.height(x + quads.face.origin));
  const double greatest = *std::ranges::max_element(heights);
  if (!(greatest < options.height))
    throw UsageError(fmt::format("--height {:g}: the terrain is up to {:g} high: the top must lie above it",
                                 options.height, greatest));
  return heights;
}

void declare_motion(Options& o, HexsweepOptions& options) {
  o.number("--height", options.height, 0, 1e300, "length of the file",
           "sweep along the face's normal; 0: without another motion, layers as high as the quads are long");
  o.text("--along", options.along, "X,Y,Z", "sweep by this vector, in the coordinates of the CAD model");
  o.input_file("--curve", options.curve_file, "FILE",
               "sweep along the spline through points x, y, z (a table, CSV), from the first one, about which the face "
               "turns with the tangent, and does not turn about it (formats/hex-mesh.md)",
               false);
  o.number("--revolve", options.revolve, -360, 360, "degrees", "turn about --axis; 360 closes; 0: not given");
  o.text(
      "--axis", options.axis, "X1,Y1,X2,Y2",
      "axis of --revolve by two points, in the plane of the face, or with six numbers in space; positive angles turn "
      "as a right-handed screw from the first to the second");
  o.number("--twist", options.twist, -36000, 36000, "degrees",
           "turn the face about --centre, from 0 at the bottom to this angle at the top");
  o.number("--taper", options.taper, 1e-3, 1e3, "1", "scale the face at --centre, from 1 at the bottom to this factor");
  o.text("--centre", options.centre, "X,Y", "of --twist and --taper; without it the middle of the face's box");
  o.input_file("--terrain", options.terrain_file, "FILE",
               "heights of the bottom over the plane of the face, at points x, y of a rectangular grid (a table of x, "
               "y, z, CSV), between which a spline has them; the top stays at --height, and layers lie between",
               false);
}

void declare_layers(Options& o, HexsweepOptions& options) {
  o.integer(
      "--layers", options.layers, 0, 100000,
      "layers of hexahedra, beside those of --bottom-layers and --top-layers; 0: so many that they are as high as "
      "the quads are long, and turn by at most 15 degrees");
  o.number("--layer-growth", options.layer_growth, 0.01, 100, "1", "height of a layer over that of the one below");
  o.text(
      "--bottom-layers", options.bottom_layers, "first=H,growth=R,layers=N",
      "layers at the bottom as quadrefine --wall has them: H is the height of the first one, R the growth from "
      "layer to layer (default: 1.2), N their number; thickness=T may replace layers; law=uniform|geometric|tanh|gll");
  o.text("--top-layers", options.top_layers, "first=H,growth=R,layers=N", "the same at the top");
  o.flag("--one-layer", options.is_one_layer,
         "one layer whose bottom and top are periodic, for flows that are the same in all planes");
  o.flag("--periodic-ends", options.has_periodic_ends, "bottom and top are periodic");
  o.text("--bottom-name", options.bottom_name, "NAME", "name of the faces where the sweep begins");
  o.text("--top-name", options.top_name, "NAME", "name of the faces where it ends");
  o.flag("--allow-invalid", options.allow_invalid, "also write a mesh that is not proved valid, marked as such");
}

}  // namespace

void HexsweepOptions::validate() const {
  require_intervals(*this);
  require_one_motion(*this);
  require_closed_turn(*this);
  if (!along.empty()) parsed_along(along);
  if (!axis.empty()) parsed_axis(axis);
  if (!centre.empty()) required_numbers("--centre", centre, {2}, "X,Y");
  if (!centre.empty() && twist == 0 && taper == 1)
    throw UsageError("--centre is of --twist and --taper: give one of them");
  if (!terrain_file.empty() && !(height > 0)) throw UsageError("--terrain needs --height, that of the top");
  if (!terrain_file.empty() && (twist != 0 || taper != 1 || is_one_layer || has_periodic_ends))
    throw UsageError("--terrain excludes --twist, --taper, --one-layer and --periodic-ends");
  if (taper != 1 && (is_one_layer || has_periodic_ends))
    throw UsageError("--taper: bottom and top differ in size and cannot be periodic");
  if (bottom_name.empty() || top_name.empty() || bottom_name == top_name)
    throw UsageError("--bottom-name and --top-name must be two different names");
  parsed_layers(*this);
}

void declare(Options& o, HexsweepOptions& options) {
  declare_motion(o, options);
  declare_layers(o, options);
}

HexMesh hexsweep(const HexsweepInput& input, const HexsweepOptions& options, Run& run) {
  options.validate();
  const QuadMesh& quads = input.quads.model;
  check::require_sound(quads, input.quads.file.name);
  std::vector<InputDigest> inputs{input.quads.file.digest("quad-mesh")};
  if (input.curve) inputs.push_back(input.curve->file.digest("curve"));
  if (input.terrain) inputs.push_back(input.terrain->file.digest("terrain"));
  const std::vector<Vec3> nodes = sweep::nodes_in_model(quads);
  const double usual = usual_size(quads, nodes);
  const sweep::SweepMotion motion(shape_of(input, options, usual));
  require_length(quads, motion);
  if (motion.shape().axis) require_off_axis(quads, nodes, *motion.shape().axis);
  sweep::SweepPlan plan{ends_of(options, motion, nodes, usual), heights_of(input, options),
                        options.is_one_layer || options.has_periodic_ends, options.bottom_name, options.top_name};
  run.begin_phase("sweep");
  std::vector<std::string> lost;
  HexMesh mesh = sweep::sweep(quads, motion, plan, run.threads(), run.report().progress(), lost);
  if (!lost.empty())
    run.report().warn(
        warning::periodicity_lost,
        fmt::format("periodic sides are not periodic after this sweep, which no one motion maps onto each "
                    "other: {}",
                    fmt::join(lost, ", ")));
  const double error = sweep::motion_error(quads, motion, plan.ends) / mesh.diameter;
  run.report().set("motion_error", error);
  if (error > greatest_error)
    run.report().warn(
        warning::motion_missed,
        fmt::format("the body deviates by up to {:.2g} of its diameter from the motion, which turns too far "
                    "within a layer: raise --layers, or the order of the quads",
                    error));
  sweep::report_mesh(mesh, run.report());
  if (!options.allow_invalid) sweep::require_valid_elements(mesh);
  if (!mesh.is_valid) run.report().warn(warning::mesh_not_valid, check::validity_warning(mesh));
  mesh.provenance = with_step(quads.provenance, "hexsweep", options, std::move(inputs));
  run.info(
      fmt::format("{} hexahedra of order {} in {}", mesh.num_elems(), mesh.order, counted(mesh.num_layers(), "layer")));
  run.end_phase();
  return mesh;
}

}  // namespace quadrille::stage
