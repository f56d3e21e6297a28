#include "api/files.hpp"

#include "check/check.hpp"
#include "io/stage_files.hpp"

namespace quadrille::api {
namespace {

template <class Stage, class Read, class Check>
Stage read_checked(const std::string& path, Read read, Check check) {
  const io::InputFile file = io::read_input(path);
  Stage stage = read(file);
  check::require_valid(check(stage, check::CheckDepth::quick), file.name);
  return stage;
}

std::vector<BrokenRule> as_broken_rules(const std::vector<check::Violation>& violations) {
  std::vector<BrokenRule> rules;
  for (const check::Violation& violation : violations) rules.push_back({violation.rule, violation.text});
  return rules;
}

}  // namespace

std::string format_of(const std::string& path) { return io::stage_format(io::read_input(path)); }

TriMesh read_tri_mesh(const std::string& path) {
  return read_checked<TriMesh>(path, io::read_tri_mesh, check::check_tri_mesh);
}
Field read_field(const std::string& path) { return read_checked<Field>(path, io::read_field, check::check_field); }
CriticalPoints read_critical_points(const std::string& path) {
  return read_checked<CriticalPoints>(path, io::read_critical_points, check::check_critical_points);
}
SeparatrixGraph read_separatrix_graph(const std::string& path) {
  return read_checked<SeparatrixGraph>(path, io::read_separatrix_graph, check::check_separatrix_graph);
}
BlockLayout read_block_layout(const std::string& path) {
  return read_checked<BlockLayout>(path, io::read_block_layout, check::check_block_layout);
}
QuadMesh read_quad_mesh(const std::string& path) {
  return read_checked<QuadMesh>(path, io::read_quad_mesh, check::check_quad_mesh);
}

void write(const std::string& path, const TriMesh& mesh) { io::write_stage(path, mesh); }
void write(const std::string& path, const Field& field) { io::write_stage(path, field); }
void write(const std::string& path, const CriticalPoints& points) { io::write_stage(path, points); }
void write(const std::string& path, const SeparatrixGraph& graph) { io::write_stage(path, graph); }
void write(const std::string& path, const BlockLayout& layout) { io::write_stage(path, layout); }
void write(const std::string& path, const QuadMesh& mesh) { io::write_stage(path, mesh); }

std::vector<BrokenRule> broken_rules(const TriMesh& mesh) {
  return as_broken_rules(check::check_tri_mesh(mesh, check::CheckDepth::full));
}
std::vector<BrokenRule> broken_rules(const Field& field) {
  return as_broken_rules(check::check_field(field, check::CheckDepth::full));
}
std::vector<BrokenRule> broken_rules(const CriticalPoints& points) {
  return as_broken_rules(check::check_critical_points(points, check::CheckDepth::full));
}
std::vector<BrokenRule> broken_rules(const SeparatrixGraph& graph) {
  return as_broken_rules(check::check_separatrix_graph(graph, check::CheckDepth::full));
}
std::vector<BrokenRule> broken_rules(const BlockLayout& layout) {
  return as_broken_rules(check::check_block_layout(layout, check::CheckDepth::full));
}
std::vector<BrokenRule> broken_rules(const QuadMesh& mesh) {
  return as_broken_rules(check::check_quad_mesh(mesh, check::CheckDepth::full));
}

}  // namespace quadrille::api
