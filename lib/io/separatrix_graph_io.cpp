#include "io/cad_face_io.hpp"
#include "io/stage_files.hpp"
#include "io/stage_io.hpp"

namespace quadrille {

namespace {

constexpr FormatVersion separatrix_graph_version{"separatrix-graph", 1, 0};

void describe_separatrix_graph(Archive& archive, SeparatrixGraph& graph) {
  describe_graph(archive, graph.nodes, graph.arcs);
  archive.field("lines", graph.lines, [](Archive& a, SeparatrixLine& line) {
    a.field("origin", line.origin);
    a.field("end", line.end);
    a.field("kind", line.kind);
    a.field("arcs", line.arcs);
  });
  archive.field("t_junctions", graph.t_junctions);
  describe_nurbs(archive, "splines", graph.splines);
  describe_face(archive, graph.face);
}

}  // namespace

SeparatrixGraph read_separatrix_graph(const InputFile& file) {
  SeparatrixGraph graph;
  graph.provenance =
      read_json_stage(file, separatrix_graph_version, [&](Archive& a) { describe_separatrix_graph(a, graph); });
  return graph;
}

void write_separatrix_graph(const std::string& path, const SeparatrixGraph& graph) {
  SeparatrixGraph copy = graph;
  write_json_stage(path, separatrix_graph_version, graph.provenance,
                   [&](Archive& a) { describe_separatrix_graph(a, copy); });
}

}  // namespace quadrille
