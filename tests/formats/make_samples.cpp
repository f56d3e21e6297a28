// Writes tests/formats/<format>/{passed,failed}: a small valid file of every format, the same with another major
// version, and one with a broken rule (the unit tests of check break every rule in memory). Run it with the folder
// tests/formats as argument when a format changes, and look at the difference before committing it.

#include <filesystem>
#include <iostream>

#include "../unit/region_layout_samples.hpp"
#include "io/output_file.hpp"
#include "io/stage_files.hpp"
#include "io/stage_io.hpp"

using namespace quadrille;

namespace {

std::filesystem::path root;

std::string target(const std::string& format, const std::string& folder, const std::string& name) {
  std::filesystem::create_directories(root / format / folder);
  return (root / format / folder / name).string();
}

template <typename Stage>
using Write = void (*)(const std::string&, const Stage&);

/// `stage` with one rule broken; the file is called after the rule.
template <typename Stage, typename Damage>
void write_broken(const std::string& folder, const std::string& extension, Write<Stage> write, Stage stage,
                  const std::string& rule, const Damage& damage) {
  damage(stage);
  write(target(folder, "failed", rule + extension), stage);
}

template <typename Stage, typename Damage>
void write_samples(const char* format, const std::string& extension, Write<Stage> write, const Stage& stage,
                   const std::string& rule, const Damage& damage) {
  std::string folder = format;
  for (char& c : folder) c = c == '-' ? '_' : c;
  write(target(folder, "passed", "square" + extension), stage);
  write_broken(folder, extension, write, stage, rule, damage);
  const bool is_json = extension.ends_with(".json");
  for (const int major : {0, 9}) {
    const std::string name = std::string("version-") + (major == 0 ? "older" : "newer") + extension;
    const auto empty_bytes = is_json ? io::json_stage_bytes : io::hdf5_stage_bytes;
    io::write_stage_bytes(target(folder, "failed", name),
                          empty_bytes({format, major, 0}, stage.provenance, [](io::Archive&) {}));
  }
}

/// Nodes that are not the field's own zeros: a second valid file, and what else can be wrong then.
void write_resolved_points() {
  const CriticalPoints points = samples::resolved_points();
  io::write_stage(target("critical_points", "passed", "resolved.crit.json"), points);
  const auto broken = [&](const std::string& rule, const auto& damage) {
    write_broken("critical_points", ".crit.json", io::write_stage<CriticalPoints>, points, rule, damage);
  };
  broken("CRT-R12", [](CriticalPoints& c) { c.form = NodeForm::harmonic; });
  broken("CRT-R13", [](CriticalPoints& c) { c.boundary_nodes[0].curve = -1; });
  broken("CRT-R15", [](CriticalPoints& c) { c.certificate.disc_radii.clear(); });
  broken("CRT-R16", [](CriticalPoints& c) { c.changes[2].after[0].valence = 1; });
}

/// What else can be wrong with a graph: its certificate. passed/version-1.0.sep.json is a file from before it had one.
void write_wrong_certificates() {
  const auto broken = [](const std::string& rule, const auto& damage) {
    write_broken("separatrix_graph", ".sep.json", io::write_stage<SeparatrixGraph>, samples::separatrix_graph(), rule,
                 damage);
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
  io::write_stage(target("quad_mesh", "passed", "marked.quad.h5"), mesh);
  write_broken("quad_mesh", ".quad.h5", io::write_stage<QuadMesh>, mesh, "QUA-R04",
               [](QuadMesh& m) { m.is_valid = true; });
  write_broken("quad_mesh", ".quad.h5", io::write_stage<QuadMesh>, mesh, "QUA-R10",
               [](QuadMesh& m) { m.least_jacobian_bound = 0.125; });
}

void write_phase_field() {
  const Field field = samples::phase_field();
  io::write_stage(target("field", "passed", "phase.field.h5"), field);
  write_broken("field", ".field.h5", io::write_stage<Field>, field, "FLD-R09",
               [](Field& f) { f.phase.hole_winding = {1}; });
  write_broken("field", ".field.h5", io::write_stage<Field>, field, "FLD-R10",
               [](Field& f) { f.phase.prescribed.nodes[0].position.x += 0.125; });
}

/// Several regions, and a slit.
void write_regions() {
  io::write_stage(target("tri_mesh", "passed", "regions.tri.h5"), samples::two_regions_mesh());
  io::write_stage(target("tri_mesh", "passed", "slit.tri.h5"), samples::slit_mesh());
  io::write_stage(target("field", "passed", "regions.field.h5"), samples::two_regions_field());
  io::write_stage(target("field", "passed", "regions-phase.field.h5"), samples::two_regions_phase_field());
  io::write_stage(target("critical_points", "passed", "regions.crit.json"), samples::two_regions_points());
  io::write_stage(target("separatrix_graph", "passed", "regions.sep.json"), samples::two_regions_graph());
  io::write_stage(target("block_layout", "passed", "regions.blocks.h5"), samples::two_regions_layout());
  io::write_stage(target("quad_mesh", "passed", "regions.quad.h5"), samples::two_regions_quads());
  io::write_stage(target("block_layout", "passed", "open.blocks.h5"), samples::open_regions_layout());
  io::write_stage(target("quad_mesh", "passed", "open.quad.h5"), samples::open_regions_quads());
  write_broken("block_layout", ".blocks.h5", io::write_stage<BlockLayout>, samples::open_regions_layout(), "BLK-R17",
               [](BlockLayout& b) { b.open_curves.clear(); });
  write_broken("quad_mesh", ".quad.h5", io::write_stage<QuadMesh>, samples::open_regions_quads(), "QUA-R14",
               [](QuadMesh& m) { m.open_curves.clear(); });
  write_broken("block_layout", ".blocks.h5", io::write_stage<BlockLayout>, samples::two_regions_layout(), "BLK-R16",
               [](BlockLayout& b) {
                 b.block_region = {1, 0};
               });
  write_broken("quad_mesh", ".quad.h5", io::write_stage<QuadMesh>, samples::two_regions_quads(), "QUA-R13",
               [](QuadMesh& m) {
                 m.block_region = {1, 0};
               });
  const auto broken = [](const std::string& rule, const auto& damage) {
    write_broken("tri_mesh", ".tri.h5", io::write_stage<TriMesh>, samples::two_regions_mesh(), rule, damage);
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
  write_samples("tri-mesh", ".tri.h5", io::write_stage<TriMesh>, samples::tri_mesh(), "TRI-R12",
                [](TriMesh& m) { m.curved_nodes[4].y += 1e-6; });
  write_samples("field", ".field.h5", io::write_stage<Field>, samples::field(), "FLD-R02",
                [](Field& f) { f.elem_order[1] = 2; });
  write_samples("critical-points", ".crit.json", io::write_stage<CriticalPoints>, samples::critical_points(), "CRT-R05",
                [](CriticalPoints& c) { c.corners[2].valence = 2; });
  write_samples("separatrix-graph", ".sep.json", io::write_stage<SeparatrixGraph>, samples::separatrix_graph(),
                "SEP-R05", [](SeparatrixGraph& g) {
                  g.splines[0].poles[1] = {0.6, 1};
                });
  write_samples("block-layout", ".blocks.h5", io::write_stage<BlockLayout>, samples::block_layout(), "BLK-R11",
                [](BlockLayout& b) { b.arc_chord[0] = 3; });
  write_samples("quad-mesh", ".quad.h5", io::write_stage<QuadMesh>, samples::quad_mesh(), "QUA-R09", [](QuadMesh& m) {
    m.nodes[4] = {-0.1, 0.4};
  });
  write_resolved_points();
  write_wrong_certificates();
  write_phase_field();
  write_marked_mesh();
  write_regions();
}
