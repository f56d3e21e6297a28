#include "draw/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/enum_names.hpp"

namespace quadrille::draw {

namespace {

std::string irregular_count(const ArcGraph& graph) {
  const auto count = std::count_if(graph.nodes.begin(), graph.nodes.end(), [](const GraphNode& n) {
    return n.kind == NodeKind::irregular || (n.kind == NodeKind::boundary && n.valence != 2);
  });
  return std::to_string(count);
}

/// The worst and the median of a measure; nothing where it is unknown.
void append_quality(std::vector<Figure>& figures, const std::string& measure, std::vector<double> values,
                    bool is_high_bad) {
  if (values.empty()) return;
  std::sort(values.begin(), values.end());
  figures.push_back({fmt::format("{} {}", is_high_bad ? "greatest" : "least", measure),
                     figure_text(is_high_bad ? values.back() : values.front())});
  figures.push_back({"median " + measure, figure_text(values[values.size() / 2])});
}

}  // namespace

std::string figure_text(double value) { return fmt::format("{:.4g}", value); }

std::vector<Figure> figures_of(const SeparatrixGraph& graph) {
  std::vector<Figure> figures{{"separatrices", std::to_string(graph.lines.size())},
                              {"irregular nodes", irregular_count(graph)},
                              {"T-junctions", std::to_string(graph.t_junctions.size())}};
  const LayoutCertificate& certificate = graph.certificate;
  if (!certificate.method) return figures;
  figures.push_back({"method", enum_name(*certificate.method)});
  figures.push_back({"merged lines", std::to_string(certificate.merged_lines)});
  figures.push_back({"collapsed chords", std::to_string(certificate.collapsed_chords)});
  figures.push_back({"largest deviation", figure_text(certificate.largest_deviation_degrees) + "°"});
  return figures;
}

std::vector<Figure> figures_of(const BlockLayout& layout) {
  const std::set<int> chords(layout.arc_chord.begin(), layout.arc_chord.end());
  return {{"blocks", std::to_string(layout.num_blocks())},
          {"chords", std::to_string(chords.size())},
          {"irregular nodes", irregular_count(layout)}};
}

std::vector<Figure> figures_of(const QuadMesh& mesh) {
  const int num_blocks =
      mesh.elem_block.empty() ? 0 : 1 + *std::max_element(mesh.elem_block.begin(), mesh.elem_block.end());
  return {{"quads", std::to_string(mesh.num_elems())},
          {"order", std::to_string(mesh.order)},
          {"mesh nodes", std::to_string(mesh.nodes.size())},
          {"blocks", std::to_string(num_blocks)},
          {"irregular nodes", std::to_string(mesh.num_irregular)},
          {"proved valid", mesh.is_valid ? "yes" : fmt::format("no: {} are not", mesh.num_unproved())}};
}

std::vector<Figure> quality_figures_of(const SeparatrixGraph&) { return {}; }

std::vector<Figure> quality_figures_of(const BlockLayout& layout) {
  std::vector<Figure> figures;
  append_quality(figures, "scaled Jacobian", layout.block_scaled_jacobian, false);
  return figures;
}

std::vector<Figure> quality_figures_of(const QuadMesh& mesh) {
  std::vector<Figure> figures;
  append_quality(figures, "scaled Jacobian", mesh.elem_scaled_jacobian, false);
  append_quality(figures, "edge-length ratio", mesh.elem_edge_ratio, true);
  append_quality(figures, "area jump", mesh.elem_area_jump, true);
  if (!mesh.elem_node_distance.empty())
    figures.push_back({"least node distance",
                       figure_text(*std::min_element(mesh.elem_node_distance.begin(), mesh.elem_node_distance.end()))});
  return figures;
}

}  // namespace quadrille::draw
