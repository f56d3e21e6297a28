// cad2tri: makes the curved triangle mesh on which the field is solved from a CAD file with one planar face, or several
// in one plane.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>

#include "base/angle.hpp"
#include "base/counted.hpp"
#include "base/error.hpp"
#include "cad/curve_names.hpp"
#include "cad/face_table.hpp"
#include "cad/file_kind.hpp"
#include "cad/load_face.hpp"
#include "cad/name_options.hpp"
#include "cad/periodic_sides.hpp"
#include "cad/region_names.hpp"
#include "check/check.hpp"
#include "cli/tool_main.hpp"
#include "io/input_file.hpp"
#include "io/name_rules_io.hpp"
#include "io/output_file.hpp"
#include "io/stage_files.hpp"
#include "offset/embed_offsets.hpp"
#include "regions/join.hpp"
#include "regions/region_work.hpp"
#include "regions/split.hpp"
#include "triangulate/triangulate.hpp"

using namespace quadrille;

namespace {

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
  return fmt::format("healed {}; by at most {:.2g} {} ({:.1g} diameters)", fmt::join(parts, ", "), greatest,
                     face.length_unit == "unknown" ? "" : face.length_unit, greatest / face.diameter);
}

std::string regions_text(const CadFace& face) {
  int num_sides = 0;
  for (const int partner : face.partners) num_sides += partner >= 0;
  return fmt::format("sewed {} along {}", counted(face.num_regions(), "region"), counted(num_sides / 2, "curve"));
}

// The format that the ending of the name determines.
cad::CadFormat healed_format(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending != ".step" && ending != ".stp" && ending != ".brep")
    throw UsageError("--write-healed " + path + ": the file must end in .step, .stp or .brep");
  return ending == ".brep" ? cad::CadFormat::brep : cad::CadFormat::step;
}

void list_faces(const io::InputFile& file, const std::string& output, Report& report) {
  const cad::FaceList list = cad::list_faces_guarded(file.bytes, file.name);
  cad::report_faces(list, report);
  io::write_output(output, cad::face_table(list), false);
}

std::string digest_format(cad::CadFormat format) {
  return format == cad::CadFormat::step ? "step" : format == cad::CadFormat::iges ? "iges" : "brep";
}

}  // namespace

int main(int argc, char** argv) {
  std::string input = "-", output = "-", names, healed, face_choice;
  bool is_listing = false;
  std::vector<std::string> name_options, region_options, periodic_options, offset_options;
  double corner_angle = 1, heal_tolerance = -1, blunt = 0, fit_tolerance = 1e-8;
  triangulate::TriangulateOptions options;

  cli::Tool tool;
  tool.name = "cad2tri";
  tool.summary = "turns a planar CAD face into a curved triangle mesh";
  tool.description =
      "Reads a planar face, with any number of holes, from SHAPE (STEP, IGES or BREP) and writes the triangle mesh on "
      "which fieldsolve solves, with the exact boundary curves as NURBS. Several faces in one plane are regions of one "
      "face: edges that lie upon each other within the tolerance of healing become one curve, also where they belong "
      "to "
      "separate parts or where a corner of one face lies on an edge of another; --face takes one of them alone. Curves "
      "inside a face that bound nothing, in wires of the face or beside it, are embedded: elements end there from both "
      "sides. The mesh is "
      "coarse: its elements follow the curves with polynomials of a high order, are small only where the boundary is "
      "strongly curved or two of its parts are close to each other, and are graded geometrically towards corners at "
      "which the field is singular. Every element is proved valid. Lengths are the numbers of the file, in its own "
      "unit.";
  tool.examples = {"cad2tri half_disc.step -o half_disc.tri.h5",
                   "cad2tri half_disc.step --size 0.3 --corner-angle 2 -o fine.tri.h5",
                   "cad2tri half_disc.step --name axis=0 --name wall@0,1 -o named.tri.h5",
                   "cad2tri --list half_disc.step", "cad2tri half_disc.step | fieldsolve -o half_disc.solve.h5"};
  tool.options = [&](Options& o) {
    constexpr double unlimited = std::numeric_limits<double>::max();
    o.input("SHAPE", input, "CAD file: STEP, IGES or BREP");
    o.output(output, "triangle mesh to write (x.tri.h5)");
    o.flag("--list", is_listing,
           "write a table of the faces of SHAPE and their edges instead of a mesh: numbers, kinds, lengths, places in "
           "space, names, and the parts (products, solids, shells) and layers that hold the faces");
    o.text("--face", face_choice, "N|NAME",
           "the one face to read of a solid, shell or assembly: its name, or its number in --list, from 0, or the "
           "name of a part or layer that holds no other face; N.0, N.1 and so on: a piece of it, the largest first, if "
           "its "
           "boundary touches itself and separates it");
    o.integer("--order", options.order, 1, 16, "polynomial order of the curved elements");
    o.number("--corner-angle", corner_angle, 0, 90, "degrees",
             "tangent discontinuities greater than this are corners of the layout");
    o.number("--heal-tolerance", heal_tolerance, -1, 5e-3, "diameters",
             "the most that edges and vertices which do not meet, or leave the plane, are moved (lines as near as that "
             "slide to their crossing, by up to four times as much); edges shorter than this are removed; 0: no "
             "healing; -1: 1e-5, or the tolerances of the shape if they are larger");
    o.number("--blunt", blunt, 0, unlimited, "file units",
             "cut off the tips of cusps (edges that meet at an angle of zero), of corners below 0.2 degrees and of "
             "corners in which the boundary touches itself: straight edges of this length take their place; 0: cusps "
             "and contacts are refused");
    o.number(
        "--fit-tolerance", fit_tolerance, 0, 1e-3, "diameters",
        "a spline with 32 breaks or more, such as one through many points, is replaced by one with at most half as "
        "many that is nowhere further away than this; its ends and its tangents there stay; 0: all splines stay");
    o.output_file("--write-healed", healed,
                  "also write the healed face, or the sewn faces, as a CAD file: x.step or x.brep");
    o.number("--size", options.size, 0, unlimited, "file units", "greatest element size; 0: diameter / 4");
    o.number("--growth", options.growth, 0.05, 2, "size per distance",
             "growth of the element size with the distance from small features");
    o.integer("--fan-layers", options.fan_layers, -1, 40,
              "layers of the triangle fans at singular corners; -1: chosen for each corner from its exponent");
    o.input_file(
        "--boundary-names", names, "FILE",
        "new names of boundary curves, JSON: {\"old name or number\": \"new name\", \"*\": \"name of the rest\"} or "
        "[{\"near\": [x, y], \"name\": \"wall\"}] (see formats/boundary-names.md)",
        false);
    o.texts(
        "--name", name_options, "NAME=LIST|NAME@X,Y",
        "name of boundary curves; LIST has their numbers (wall=1,3-6), present names, or patterns of these with the "
        "wild cards * and ? ('wall=edge_*'); * alone: all other curves; NAME@X,Y: the curve nearest to this point, "
        "in file units, which must be within a tenth of the diameter; overrides "
        "--boundary-names; stageview --curve-labels draws the numbers");
    o.texts("--region-name", region_options, "NAME=LIST|NAME@X,Y",
            "name of regions, as --name of curves: LIST has their numbers, in the order of the faces in SHAPE, present "
            "names or "
            "patterns; NAME@X,Y: the region around this point; the name of a single region is that of the face; common "
            "curves "
            "without a name of their own are called after their regions, such as fluid-solid",
            false);
    o.texts(
        "--periodic", periodic_options, "A=B[:MOTION]",
        "the sides A and B, names of one curve or of several that follow each other, repeat each other: their nodes "
        "are images under a translation or rotation, found from the curves or given as "
        "A=B:translate=DX,DY or A=B:rotate=DEGREES[,CX,CY], in file units; B is replaced by the exact image of A, "
        "from which it may differ by 1e-9 diameters; may be given several times");
    o.texts(
        "--offset", offset_options, "NAME=T",
        "embed a curve at the distance T, in file units, from the boundary NAME (or NAME,NAME): blocks end there, "
        "so that layers of this thickness have blocks of their own; around corners, and along neighbours of NAME "
        "that meet it at more than 135 degrees, up to the first that does not; nearer where a facing wall or a bend "
        "leaves less room; the curve is called NAME_offset; may be given several times",
        false);
    o.number("--fan-factor", options.fan_factor, 0.01, 0.9, "ratio",
             "ratio of the radii of successive layers of a fan");
  };
  tool.run = [&](cli::Session& s) {
    const std::vector<NameRule> chosen_names = cad::name_option_rules(name_options);
    const std::vector<NameRule> region_names = cad::name_option_rules(region_options, "--region-name");
    const std::vector<offset::OffsetRequest> offsets = offset::offset_requests(offset_options);
    const std::vector<cad::PeriodicRequest> periodic = cad::periodic_options(periodic_options);
    if (is_listing && !face_choice.empty()) throw UsageError("--list and --face exclude each other");
    if (!healed.empty()) healed_format(healed);  // a wrong name is told before any work
    std::optional<io::InputFile> names_file;
    if (!names.empty()) names_file = io::read_input(names);
    const std::vector<NameRule> name_rules =
        names_file ? io::read_boundary_names(*names_file) : std::vector<NameRule>();
    const io::InputFile file = io::read_input(input);
    if (is_listing) return list_faces(file, output, s.report());
    s.begin_phase("load");
    cad::LoadedFace loaded = cad::load_face_guarded(
        file.bytes, file.name, {radians(corner_angle), heal_tolerance, face_choice, blunt, fit_tolerance}, s.report());
    CadFace& face = loaded.face;
    s.end_phase();
    std::vector<InputDigest> inputs{file.digest(digest_format(cad::cad_format(file.bytes, file.name)))};
    if (names_file) inputs.push_back(names_file->digest("boundary-names"));
    cad::rename_regions(face, region_names);
    cad::rename_curves(face, name_rules, chosen_names);
    cad::pair_periodic_sides(face, periodic);
    face = offset::embed_offsets(face, offsets, radians(corner_angle), s.report());
    report_face(face, s.report());
    if (const std::string text = repairs_text(face, loaded.repairs); !text.empty()) s.info(text, 0);
    if (face.num_regions() > 1) s.info(regions_text(face));
    if (face.fit_distance > 0) s.info(fit_text(face, loaded.repairs));
    if (!healed.empty()) io::write_output(healed, cad::file_of_face(face, healed_format(healed)), false);
    s.begin_phase("triangulate");
    const std::vector<CadFace> regions = regions::split(face);
    TriMesh mesh = regions::join(
        face, regions::map_regions<TriMesh>(face, s.threads(), s.report(), [&](int region, int, Report& report) {
          return triangulate::triangulate(regions[region], options, report);
        }));
    s.end_phase();
    mesh.provenance = s.provenance({}, inputs);
    mesh.repairs = loaded.repairs;
    s.info(fmt::format("{}, {}, {} of them curved", counted(face.num_curves(), "curve"),
                       counted(mesh.num_elems(), "element"), mesh.curved_elems.size()));
    io::write_stage(output, mesh);
  };
  tool.report_writer = io::write_report;
  return cli::tool_main(argc, argv, tool);
}
