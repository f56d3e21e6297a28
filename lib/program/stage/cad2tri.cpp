#include "stage/cad2tri.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/number_list.hpp"
#include "base/options.hpp"
#include "cad/curve_names.hpp"
#include "cad/file_kind.hpp"
#include "cad/load_face.hpp"
#include "cad/periodic_sides.hpp"
#include "cad/region_names.hpp"
#include "check/check.hpp"
#include "heal/blunt_cusps.hpp"
#include "io/step_origin.hpp"
#include "offset/embed_offsets.hpp"
#include "stage/symmetry_option.hpp"
#include "stage/triangulate_face.hpp"

namespace quadrille::stage {

namespace {

/// As heal::BluntOptions::width.
double blunt_width(const std::string& text) {
  if (text == "auto") return heal::automatic_width;
  const std::optional<double> width = finite_number_of(text);
  if (!width || *width < 0)
    throw UsageError(fmt::format("--blunt {}: expected \"auto\" or a width in file units, 0 or above", text));
  return *width;
}

/// The texts of the options as what they mean.
struct Wishes {
  std::vector<NameRule> curve_names, region_names;
  std::vector<offset::OffsetRequest> offsets;
  std::vector<cad::PeriodicRequest> periodic;
  double blunt_width = 0;
  cad::SectionPlane section;
};

Wishes parsed(const Cad2triOptions& options) {
  return {cad::name_option_rules(options.curve_names),
          cad::name_option_rules(options.region_names, "--region-name"),
          offset::offset_requests(options.offsets),
          cad::periodic_options(options.periodic),
          blunt_width(options.blunt),
          cad::section_plane(options.section)};
}

// The format that the ending of the name determines.
cad::CadFormat healed_format(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending != ".step" && ending != ".stp" && ending != ".brep")
    throw UsageError("--write-healed " + path + ": the file must end in .step, .stp or .brep");
  return ending == ".brep" ? cad::CadFormat::brep : cad::CadFormat::step;
}

void report_face(const CadFace& face, Report& report) {
  int num_corners = 0;
  for (const Joint& joint : face.joints) num_corners += joint.is_corner;
  report.set("regions.count", face.num_regions());
  report.set("face.curves", face.num_curves());
  report.set("face.loops", face.num_loops());
  report.set("face.corners", num_corners);
  report.set("face.diameter", face.diameter);
  report.set("face.length_unit", face.length_unit);
  if (!face.periodic_pairs.empty()) report.set("face.periodic_pairs", face.periodic_pairs.size());
}

std::string fit_text(const CadFace& face, const std::vector<Repair>& repairs) {
  const auto count = std::count_if(repairs.begin(), repairs.end(),
                                   [](const Repair& repair) { return repair.kind == RepairKind::fit; });
  return fmt::format("fitted {} with fewer knots, by at most {:.2g} diameters",
                     count == 1 ? "1 spline" : fmt::format("{} splines", count), face.fit_distance / face.diameter);
}

// Empty if nothing was healed.
std::string repairs_text(const CadFace& face, const std::vector<Repair>& repairs) {
  std::map<RepairKind, int> counts;
  double greatest = 0;
  for (const Repair& repair : repairs)
    if (repair.kind != RepairKind::fit) ++counts[repair.kind], greatest = std::max(greatest, repair.distance);
  if (counts.empty()) return {};
  std::vector<std::string> parts;
  const auto add = [&](RepairKind kind, const char* one, const char* many) {
    if (counts[kind] > 0) parts.push_back(fmt::format("{} {}", counts[kind], counts[kind] == 1 ? one : many));
  };
  add(RepairKind::joint, "joint", "joints");
  add(RepairKind::vertex, "vertex off its edges", "vertices off their edges");
  add(RepairKind::plane, "edge off the plane", "edges off the plane");
  add(RepairKind::edge, "short edge removed", "short edges removed");
  add(RepairKind::fold, "spline unfolded", "splines unfolded");
  add(RepairKind::knot, "spline with merged knots", "splines with merged knots");
  add(RepairKind::cusp, "cusp cut off", "cusps cut off");
  const std::string unit = face.length_unit == "unknown" ? "" : ' ' + face.length_unit;
  return fmt::format("healed {}; by at most {:.2g}{} ({:.1g} diameters)", fmt::join(parts, ", "), greatest, unit,
                     greatest / face.diameter);
}

std::string regions_text(const CadFace& face) {
  int num_sides = 0;
  for (const int partner : face.partners) num_sides += partner >= 0;
  return fmt::format("sewed {} along {}", counted(face.num_regions(), "region"), counted(num_sides / 2, "curve"));
}

void report_shape(const LoadedShape& shape, Run& run) {
  report_face(shape.face, run.report());
  if (const std::string text = repairs_text(shape.face, shape.repairs); !text.empty()) run.info(text, 0);
  if (shape.face.num_regions() > 1) run.info(regions_text(shape.face));
  if (shape.face.fit_distance > 0) run.info(fit_text(shape.face, shape.repairs));
}

void report_smoothed(int num_corners, const Run& run) {
  if (num_corners > 0)
    run.info(fmt::format("{} of polylines, with small angles, start no line (--polyline-angle)",
                         counted(num_corners, "corner")));
}

}  // namespace

void Cad2triOptions::validate() const {
  parsed(*this);
  if (!listed.empty() && !face.empty()) throw UsageError("--list and --face exclude each other");
  if (!healed_file.empty()) healed_format(healed_file);
}

namespace {

/// What is read and repaired.
void declare_face(Options& o, Cad2triOptions& cad2tri) {
  o.choice("--list", cad2tri.listed, {"all", "planar", "curved"},
           "write a table of the faces of SHAPE and their edges instead of a mesh: numbers, kinds, lengths, places "
           "in space, names, and the parts (products, solids, shells) and layers that hold the faces; of all "
           "faces, of those in a plane, or of the others");
  o.text("--face", cad2tri.face, "N|NAME",
         "the one face to read of a solid, shell or assembly: its name, or its number in --list, from 0, or the name "
         "of a part or layer that holds no other face; N.0, N.1 and so on: a piece of it, the largest first, if its "
         "boundary touches itself and separates it; N,N: several faces of one plane, as regions");
  o.text("--section", cad2tri.section, "x|y|z=VALUE|NX,NY,NZ@X,Y,Z",
         "cut the solids of SHAPE by a plane, z=0.5 or one given by its normal and a point, and read the faces of the "
         "cut, which are named like the solids, their curves like the faces of the solids, or face_N after their "
         "numbers in --list; neighbours are regions of one face; --list and --face then mean the faces of the cut");
  o.integer("--order", cad2tri.elements.order, 1, 16, "polynomial order of the curved elements");
  o.number("--corner-angle", cad2tri.corner_angle, 0, 90, "degrees",
           "tangent discontinuities greater than this are corners of the layout");
  o.number("--polyline-angle", cad2tri.polyline_angle, 0, outline::greatest_polyline_kink, "degrees",
           "tangent discontinuities up to this are no corners inside polylines (eight straight edges or more, each "
           "shorter than a fiftieth of the diameter), where there are 200 or more of them in a face of one region");
  o.number("--heal-tolerance", cad2tri.heal_tolerance, -1, 5e-3, "diameters",
           "the most that edges and vertices which do not meet, or leave the plane, are moved (lines as near as that "
           "slide to their crossing, by up to four times as much); edges shorter than this are removed; 0: no healing; "
           "-1: 1e-5, or the tolerances of the shape if they are larger");
  o.text("--blunt", cad2tri.blunt, "auto|WIDTH",
         "cut off the tips of cusps (edges that meet at an angle of zero), of corners below 0.2 degrees and of corners "
         "in which the boundary touches itself: straight edges of this length, in file units, take their place; auto: "
         "1e-3 diameters (with curves called farfield, of the box around the bodies), or half of what fits, with a "
         "warning; 0: cusps and contacts are refused");
  o.number("--fit-tolerance", cad2tri.fit_tolerance, 0, 1e-3, "diameters",
           "a spline with 32 breaks or more, such as one through many points, is replaced by one with at most half as "
           "many that is nowhere further away than this; its ends and its tangents there stay; 0: all splines stay");
  o.output_file("--write-healed", cad2tri.healed_file,
                "also write the healed face, or the sewn faces, as a CAD file: x.step or x.brep");
}

/// Names, and what names curves and regions.
void declare_names(Options& o, Cad2triOptions& cad2tri) {
  o.input_file("--boundary-names", cad2tri.names_file, "FILE",
               "new names of boundary curves, JSON: {\"old name or number\": \"new name\", \"*\": \"name of the "
               "rest\"} or [{\"near\": [x, y], \"name\": \"wall\"}] (see formats/boundary-names.md)",
               false);
  o.texts(
      "--name", cad2tri.curve_names, "NAME=LIST|NAME@X,Y",
      "name of boundary curves; LIST has their numbers (wall=1,3-6), present names, or patterns of these with the "
      "wild cards * and ? ('wall=edge_*'), box(X0,Y0,X1,Y1) for curves in a rectangle, circles(<D) for circles of a "
      "diameter below D, or tangent(N) for all that continue curve N without a corner; * alone: all other curves of "
      "the outline and of holes, interface:* those "
      "between regions and inside one (boundary: and interface: also before other patterns); NAME@X,Y: the curve "
      "nearest to this point, in file units, which must be within a tenth of the diameter (on a curved face "
      "NAME@X,Y,Z, in space); overrides "
      "--boundary-names; stageview --curve-labels draws the numbers");
  o.texts("--region-name", cad2tri.region_names, "NAME=LIST|NAME@X,Y",
          "name of regions, as --name of curves: LIST has their numbers, in the order of the faces in SHAPE, present "
          "names or patterns; NAME@X,Y: the region around this point; the name of a single region is that of the face; "
          "neighbours that get one name become one region, without the lines between them; common curves without a "
          "name of their own are called after their regions, such as fluid-solid",
          false);
  o.flag("--keep-joints", cad2tri.keep_joints,
         "keep the lines between neighbours that --region-name gives one name, and each a region: the names only group "
         "them");
  o.texts(
      "--periodic", cad2tri.periodic, "A=B[:MOTION]",
      "the sides A and B, names or patterns of curves, in one part or several, repeat each other: their nodes are "
      "images under a translation or rotation, found from the curves or given as A=B:translate=DX,DY or "
      "A=B:rotate=DEGREES[,CX,CY], in file units; on a curved face a rotation or translation in space, always found "
      "from the curves; B is replaced by the exact image of A, from which it may differ by 1e-9 diameters");
  o.texts("--offset", cad2tri.offsets, "NAME=T",
          "embed a curve at the distance T, in file units, from the boundary NAME (or NAME,NAME), on a curved face a "
          "length in space: blocks end there, so that layers of this thickness have blocks of their own; around "
          "corners, and along neighbours of NAME that meet it at more than 135 degrees, up to the first that does not; "
          "nearer where a facing wall or a bend leaves less room; the curve is called NAME_offset",
          false);
}

}  // namespace

void declare(Options& o, Cad2triOptions& cad2tri) {
  constexpr double unlimited = std::numeric_limits<double>::max();
  declare_face(o, cad2tri);
  o.number("--size", cad2tri.elements.size, 0, unlimited, "file units", "greatest element size; 0: diameter / 4");
  o.number("--growth", cad2tri.elements.growth, 0.05, 2, "size per distance",
           "growth of the element size with the distance from small features");
  o.integer("--fan-layers", cad2tri.elements.fan_layers, -1, 40,
            "layers of the triangle fans at singular corners; -1: chosen for each corner from its exponent");
  declare_names(o, cad2tri);
  declare_symmetry(o, cad2tri.symmetry);
  o.number("--fan-factor", cad2tri.elements.fan_factor, 0.01, 0.9, "ratio",
           "ratio of the radii of successive layers of a fan");
}

namespace {

cad::LoadOptions load_options(const Cad2triOptions& options) {
  const Wishes wishes = parsed(options);
  return {radians(options.corner_angle), options.heal_tolerance, options.face, wishes.blunt_width,
          options.fit_tolerance,         wishes.section};
}

LoadedShape face_of_cad(const Cad2triInput& input, const Cad2triOptions& options, Run& run) {
  const Input<std::string>& cad = input.cad;
  const std::string &name = cad.file.name, &bytes = cad.model;
  run.begin_phase("load");
  LoadedShape shape{input.face ? *input.face : cad::load_face_guarded(bytes, name, load_options(options), run.report()),
                    {cad.file.digest(cad::format_stem(cad::cad_format(bytes, name)))}};
  shape.before = io::step_origin(bytes);
  run.end_phase();
  return shape;
}

/// Its curves in space are those of the chart, one by one.
LoadedShape face_of_chart(const Input<ChartedFace>& chart, const Cad2triOptions& options) {
  const auto refuse = [](bool is_given, const char* option, const char* remedy) {
    if (is_given)
      throw UsageError(fmt::format("{} is not for charts: the curves of a curved face stay as cad2chart read them; {}",
                                   option, remedy));
  };
  const Cad2triOptions defaults;
  refuse(options.heal_tolerance != defaults.heal_tolerance, "--heal-tolerance", "give it to cad2chart");
  refuse(options.fit_tolerance != defaults.fit_tolerance, "--fit-tolerance", "leave it out");
  refuse(options.blunt != defaults.blunt, "--blunt", "cut off cusps in the CAD system");

  refuse(!options.face.empty(), "--face", "give it to cad2chart, which reads the face");
  refuse(!options.section.empty(), "--section", "give it with the CAD file");
  refuse(!options.healed_file.empty(), "--write-healed", "cad2chart reports what it moves");
  check::require_sound(chart.model, chart.file.name);
  LoadedShape shape;
  shape.face = chart.model.face;
  shape.inputs = {chart.file.digest("chart")};
  shape.before = chart.model.provenance;
  return shape;
}

}  // namespace

cad::AnyFace read_any_face(const Input<std::string>& cad, const Cad2triOptions& options, Run& run) {
  require_intervals(options);
  options.validate();
  run.begin_phase("load");
  cad::AnyFace face = cad::load_any_face_guarded(cad.model, cad.file.name, load_options(options), run.report());
  run.end_phase();
  return face;
}

LoadedShape load_shape(const Cad2triInput& input, const Cad2triOptions& options, Run& run) {
  require_intervals(options);
  options.validate();
  const Wishes wishes = parsed(options);
  const double corner_angle = radians(options.corner_angle);
  LoadedShape shape = input.chart ? face_of_chart(*input.chart, options) : face_of_cad(input, options, run);
  if (input.names) shape.inputs.push_back(input.names->file.digest("boundary-names"));
  const std::vector<int> named_regions = cad::rename_regions(shape.face, wishes.region_names);
  if (!options.keep_joints) cad::merge_regions(shape.face, named_regions, corner_angle);
  cad::rename_curves(shape.face, input.names ? input.names->model : std::vector<NameRule>(), wishes.curve_names,
                     run.report());
  if (shape.face.chart && has_far_field(shape.face))
    throw UsageError(
        "curves called farfield are the outline of an outer flow in the plane, and this face is curved: give them "
        "another name, by --name outer=farfield");
  cad::pair_periodic_sides(shape.face, wishes.periodic);
  Report of_critpoints;  // which warns of curves that are bent
  const std::vector<std::string> symmetry = checked_symmetry(shape.face, options.symmetry, of_critpoints);
  shape.face = offset::embed_offsets(shape.face, wishes.offsets, corner_angle, symmetry, run.report());
  report_smoothed(outline::smooth_polylines(shape.face, radians(options.polyline_angle)), run);
  report_shape(shape, run);
  return shape;
}

TriMesh cad2tri(const LoadedShape& shape, const Cad2triOptions& options, Run& run) {
  require_intervals(options);
  run.begin_phase("triangulate");
  TriMesh mesh = triangulate_face(shape.face, options.elements, run);
  run.end_phase();
  mesh.provenance = with_step(shape.before, "cad2tri", options, shape.inputs);
  mesh.repairs = shape.repairs;
  run.info(fmt::format("{}, {}, {} of them curved", counted(shape.face.num_curves(), "curve"),
                       counted(mesh.num_elems(), "element"), mesh.curved_elems.size()));
  return mesh;
}

TriMesh cad2tri(const Cad2triInput& input, const Cad2triOptions& options, Run& run) {
  return cad2tri(load_shape(input, options, run), options, run);
}

std::string list_faces(const Input<std::string>& file, const Cad2triOptions& options, Run& run) {
  const cad::FaceList list = cad::list_faces_guarded(file.model, file.file.name, cad::section_plane(options.section));
  cad::report_faces(list, run.report());
  const auto num_curved = std::count_if(list.faces.begin(), list.faces.end(), [](const cad::ListedFace& face) {
    return face.face.kind != "plane" && face.face.kind != "other";
  });
  if (num_curved > 0)
    run.info(fmt::format("{}: give the number of one to cad2chart --face, or to quadmesh --face",
                         counted(num_curved, "curved face")),
             0);
  return cad::face_table(list, [&](const cad::ListedFace& face) {
    const bool is_planar = face.face.kind == "plane";
    return options.listed == "planar" ? is_planar : options.listed == "curved" ? !is_planar : true;
  });
}

std::string cad_file_of(const CadFace& face, const std::string& path) {
  return cad::file_of_face(face, healed_format(path));
}

}  // namespace quadrille::stage
