// Writes tests/formats/<format>/{passed,failed}: a small valid file of every format, the same with another major
// version, and one with a broken rule (the unit tests of check break every rule in memory). Run it with the folder
// tests/formats as argument when a format changes, and look at the difference before committing it.

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "../unit/chart_samples.hpp"
#include "../unit/region_layout_samples.hpp"
#include "io/describe.hpp"
#include "io/stage_files.hpp"
#include "io/whole_file.hpp"

using namespace quadrille;

namespace {

std::filesystem::path root;

/// The path of a sample of a struct: its folder has the name of the format, its ending is that of the last tool that
/// writes the format.
template <typename Model>
std::string target(const std::string& folder, const std::string& name) {
  std::string format = format_of<Model>().name;
  std::string_view ending;
  for (const StageTool& tool : stage_tools)
    if (tool.writes == format) ending = tool.ending;
  std::replace(format.begin(), format.end(), '-', '_');
  std::filesystem::create_directories(root / format / folder);
  return (root / format / folder / (name + '.' + std::string(ending))).string();
}

template <typename Model>
void write_valid(const std::string& name, const Model& stage) {
  io::write_stage(target<Model>("passed", name), stage);
}

/// `stage` with one rule broken; the file is called after the rule.
template <typename Model, typename Damage>
void write_broken(Model stage, const std::string& rule, const Damage& damage) {
  damage(stage);
  io::write_stage(target<Model>("failed", rule), stage);
}

template <typename Model, typename Damage>
void write_samples(const Model& stage, const std::string& rule, const Damage& damage) {
  write_valid("square", stage);
  write_broken(stage, rule, damage);
  const StageFormat& present = format_of<Model>();
  for (const auto& [name, major] :
       {std::pair("version-older", present.major - 1), {"version-newer", present.major + 1}})
    io::write_stage_bytes(target<Model>("failed", name), io::described_bytes({present.name, major, 0, present.storage},
                                                                             stage.provenance, [](io::Archive&) {}));
}

/// Nodes that are not the field's own zeros: a second valid file, and what else can be wrong then.
void write_resolved_points() {
  const CriticalPoints points = samples::resolved_points();
  write_valid("resolved", points);
  const auto broken = [&](const std::string& rule, const auto& damage) { write_broken(points, rule, damage); };
  broken("CRT-R12", [](CriticalPoints& c) { c.form = NodeForm::harmonic; });
  broken("CRT-R13", [](CriticalPoints& c) { c.boundary_nodes[0].curve = -1; });
  broken("CRT-R15", [](CriticalPoints& c) { c.certificate.disc_radii.clear(); });
  broken("CRT-R16", [](CriticalPoints& c) { c.changes[2].after[0].valence = 1; });
}

/// What else can be wrong with a graph: its certificate.
void write_wrong_certificates() {
  const auto broken = [](const std::string& rule, const auto& damage) {
    write_broken(samples::separatrix_graph(), rule, damage);
  };
  broken("SEP-R11", [](SeparatrixGraph& g) { g.certificate.merged_lines = -1; });
  broken("SEP-R12", [](SeparatrixGraph& g) { g.certificate.index_sum = 3; });
  broken("SEP-R13", [](SeparatrixGraph& g) { g.certificate.face_valence_histogram = {{4, 3}}; });
  broken("SEP-R14", [](SeparatrixGraph& g) { g.certificate.face_valence_histogram = {{3, 1}, {5, 1}}; });
}

/// A mesh that is not valid and says so. passed/version-1.0.quad.h5 is a file from before meshes could.
void write_marked_mesh() {
  QuadMesh mesh = samples::quad_mesh();
  mesh.nodes[4] = {-0.1, 0.4};
  mesh.elem_jacobian_bound[0] = mesh.least_jacobian_bound = -0.0425;
  mesh.elem_scaled_jacobian[0] = -1;
  mesh.is_valid = false;
  write_valid("marked", mesh);
  write_broken(mesh, "QUA-R04", [](QuadMesh& m) { m.is_valid = true; });
  write_broken(mesh, "QUA-R10", [](QuadMesh& m) { m.least_jacobian_bound = 0.125; });
}

void write_phase_field() {
  const Field field = samples::phase_field();
  write_valid("phase", field);
  write_broken(field, "FLD-R09", [](Field& f) { f.phase.hole_winding = {1}; });
  write_broken(field, "FLD-R10", [](Field& f) { f.phase.prescribed.nodes[0].position.x += 0.125; });
}

void write_aligned_field() {
  Field field = samples::field();
  field.alignment = {{{0.5, 0.375}, 0.25, 16, 0.5}};
  write_valid("aligned", field);
  write_broken(field, "FLD-R11", [](Field& f) { f.alignment[0].width = 0; });
}

/// Several regions, and a slit.
void write_regions() {
  write_valid("regions", samples::two_regions_mesh());
  write_valid("slit", samples::slit_mesh());
  write_valid("regions", samples::two_regions_field());
  write_valid("regions-phase", samples::two_regions_phase_field());
  write_valid("regions", samples::two_regions_points());
  write_valid("regions", samples::two_regions_graph());
  write_valid("regions", samples::two_regions_layout());
  write_valid("regions", samples::two_regions_quads());
  write_valid("open", samples::open_regions_layout());
  write_valid("open", samples::open_regions_quads());
  write_broken(samples::open_regions_layout(), "BLK-R17", [](BlockLayout& b) { b.open_curves.clear(); });
  write_broken(samples::open_regions_quads(), "QUA-R14", [](QuadMesh& m) { m.open_curves.clear(); });
  write_broken(samples::two_regions_layout(), "BLK-R16", [](BlockLayout& b) { b.block_region = {1, 0}; });
  write_broken(samples::two_regions_quads(), "QUA-R13", [](QuadMesh& m) { m.block_region = {1, 0}; });
  const auto broken = [](const std::string& rule, const auto& damage) {
    write_broken(samples::two_regions_mesh(), rule, damage);
  };
  broken("FAC-R11", [](TriMesh& m) { m.face.partners[7] = -1; });
  broken("FAC-R12", [](TriMesh& m) { m.face.periodic_pairs[0].shift = {0, 1.5}; });
  broken("TRI-R14", [](TriMesh& m) { m.region_elems = {0, 3, 8}; });
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: make_format_samples tests/formats\n";
    return 2;
  }
  root = argv[1];
  write_samples(samples::charted_face(), "CHA-R05", [](ChartedFace& c) {
    Chart chart = *c.face.chart;
    chart.space_curves[1].poles.back().z += 1e-3;
    c.face.chart = std::make_shared<const Chart>(chart);
  });
  write_valid("cap", samples::charted_cap());
  write_samples(samples::tri_mesh(), "TRI-R12", [](TriMesh& m) { m.curved_nodes[4].y += 1e-6; });
  write_samples(samples::field(), "FLD-R02", [](Field& f) { f.elem_order[1] = 2; });
  write_samples(samples::critical_points(), "CRT-R05", [](CriticalPoints& c) { c.corners[2].valence = 2; });
  write_samples(samples::separatrix_graph(), "SEP-R05", [](SeparatrixGraph& g) { g.splines[0].poles[1] = {0.6, 1}; });
  write_samples(samples::block_layout(), "BLK-R11", [](BlockLayout& b) { b.arc_chord[0] = 3; });
  write_samples(samples::quad_mesh(), "QUA-R09", [](QuadMesh& m) { m.nodes[4] = {-0.1, 0.4}; });
  write_samples(samples::hex_mesh(), "HEX-R09", [](HexMesh& m) {
    m.nodes[10].x = -0.1;
    m.face_groups[4].periodic_with = -1;
  });
  write_broken(samples::hex_mesh(), "HEX-R04", [](HexMesh& m) { m.elem_scaled_jacobian[0] = 2; });
  write_broken(samples::hex_mesh(), "HEX-R10", [](HexMesh& m) { m.face_groups[4].motion.shift.z = 0.25; });
  write_resolved_points();
  write_wrong_certificates();
  write_phase_field();
  write_aligned_field();
  write_marked_mesh();
  write_regions();
}
