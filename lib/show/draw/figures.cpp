#include "draw/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/enum_names.hpp"
#include "base/error.hpp"
#include "draw/embedded.hpp"
#include "draw/picture.hpp"
#include "mesh/element_sizes.hpp"

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

constexpr double table_margin = 36, table_row = 20;  // pixels

/// In the coordinates of the file.
void include_face(PictureBox& box, const CadFace& face) {
  const PictureBox own = bounding_box(face);
  if (own.empty()) return;
  box.include(own.lower + face.origin);
  box.include(own.upper + face.origin);
}

/// By a fiftieth on each side, so that the frame does not touch what it shows.
PictureBox widened(const PictureBox& box) {
  const Vec2 size = box.upper - box.lower;
  const double slack = 0.02 * std::max(size.x, size.y);
  return {box.lower - Vec2{slack, slack}, box.upper + Vec2{slack, slack}};
}

/// Rows of label, A, B: the labels of both in their order, "–" where one has no such figure.
std::vector<std::array<std::string, 3>> table_rows(const std::vector<Figure>& a, const std::vector<Figure>& b) {
  std::vector<std::array<std::string, 3>> rows{{"", "A", "B"}};
  const auto row_of = [&](const std::string& label) {
    return std::find_if(rows.begin(), rows.end(), [&](const auto& known) { return known[0] == label; });
  };
  for (const Figure& figure : a) rows.push_back({figure.label, figure.value, "–"});
  for (const Figure& figure : b) {
    const auto known = row_of(figure.label);
    if (known != rows.end())
      (*known)[2] = figure.value;
    else
      rows.push_back({figure.label, "–", figure.value});
  }
  return rows;
}

template <typename Stage>
concept Comparable =
    std::is_same_v<Stage, SeparatrixGraph> || std::is_same_v<Stage, BlockLayout> || std::is_same_v<Stage, QuadMesh>;

template <Comparable Stage>
std::vector<Figure> all_figures(const Stage& stage) {
  std::vector<Figure> figures = figures_of(stage);
  for (const Figure& figure : quality_figures_of(stage)) figures.push_back(figure);
  return figures;
}

std::string text_at(double x, double y, const std::string& anchor, const std::string& weight, const std::string& text) {
  return svg_element("text",
                     {{"x", svg_number(x)}, {"y", svg_number(y)}, {"text-anchor", anchor}, {"font-weight", weight}}, {},
                     xml_escaped(text)) +
         '\n';
}

std::string table(const std::vector<std::array<std::string, 3>>& rows, double top) {
  std::string out =
      "<g id=\"table\" font-family=\"Helvetica,Arial,'Liberation Sans',sans-serif\" font-size=\"13\" "
      "fill=\"#26323d\">\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double y = top + table_row * static_cast<double>(i);
    const bool is_head = i == 0, differs = rows[i][1] != rows[i][2];
    out += text_at(table_margin, y, "start", "normal", rows[i][0]);
    for (int k = 1; k <= 2; ++k)
      out += text_at(k == 1 ? 270 : 380, y, "end", is_head || differs ? "bold" : "normal", rows[i][k]);
    out += svg_element("line", {{"x1", svg_number(table_margin)},
                                {"x2", svg_number(380)},
                                {"y1", svg_number(y + 6)},
                                {"y2", svg_number(y + 6)},
                                {"stroke", is_head ? "#26323d" : "#dde3ea"}}) +
           '\n';
  }
  return out + "</g>\n";
}

template <Comparable Stage>
std::string drawn_pair(const std::array<const Stage*, 2>& pair, const std::array<std::string, 2>& files,
                       const DrawOptions& options) {
  PictureBox box;
  for (const Stage* stage : pair) include_face(box, stage->face);
  if (!box.empty() && !options.window) box = widened(box);
  std::array<std::string, 2> parts;
  double height = 0;
  for (int k = 0; k < 2; ++k) {
    DrawOptions own = options;
    own.width = options.width / 2;
    own.file = files[k];
    own.title_prefix = k == 0 ? "A: " : "B: ";
    if (!box.empty() && !own.window) own.window = Window{box.lower, box.upper};
    const std::string svg = draw_stage(*pair[k], own);
    height = std::max(height, height_of(svg));
    parts[k] = embedded(svg, k == 0 ? "a-" : "b-", k * own.width);
  }
  const auto rows = table_rows(all_figures(*pair[0]), all_figures(*pair[1]));
  const double top = height + table_row;
  const double whole = top + table_row * static_cast<double>(rows.size()) + 10;
  return begin_parts("Comparison", options.width, whole) + parts[0] + parts[1] + table(rows, top) + "</svg>\n";
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

int num_blocks(const QuadMesh& mesh) {
  return mesh.elem_block.empty() ? 0 : 1 + *std::max_element(mesh.elem_block.begin(), mesh.elem_block.end());
}

std::vector<Figure> figures_of(const QuadMesh& mesh) {
  return {{"quads", std::to_string(mesh.num_elems())},
          {"order", std::to_string(mesh.order)},
          {"mesh nodes", std::to_string(mesh.nodes.size())},
          {"blocks", std::to_string(num_blocks(mesh))},
          {"irregular nodes", std::to_string(mesh.num_irregular)},
          {"proved valid", mesh.is_valid ? "yes" : fmt::format("no: {} are not", mesh.num_unproved())}};
}

std::vector<Figure> figures_of(const HexMesh& mesh) {
  const auto is_unproved = [](double bound) { return !(bound > 0); };
  return {{"hexahedra", std::to_string(mesh.num_elems())},
          {"layers", std::to_string(mesh.num_layers())},
          {"order", std::to_string(mesh.order)},
          {"mesh nodes", std::to_string(mesh.nodes.size())},
          {"regions", std::to_string(mesh.region_names.size())},
          {"proved valid", mesh.is_valid ? "yes"
                                         : fmt::format("no: {} are not",
                                                       std::ranges::count_if(mesh.elem_jacobian_bound, is_unproved))}};
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
  figures.push_back({"resolution ratio", figure_text(mesh::resolution(mesh).ratio)});
  if (!mesh.elem_node_distance.empty())
    figures.push_back({"least node distance",
                       figure_text(*std::min_element(mesh.elem_node_distance.begin(), mesh.elem_node_distance.end()))});
  return figures;
}

bool is_comparable(const StageModel& stage) {
  return std::visit([]<typename Model>(const Model&) { return Comparable<Model>; }, stage);
}

std::string draw_comparison(const StageModel& a, const StageModel& b, const std::array<std::string, 2>& files,
                            const DrawOptions& options) {
  const auto drawn = [&]<typename Model>(const Model& first) -> std::string {
    if constexpr (Comparable<Model>)
      return drawn_pair<Model>({&first, &std::get<Model>(b)}, files, options);
    else
      throw Defect("draw_comparison: neither a layout nor a mesh");
  };
  return std::visit(drawn, a);
}

}  // namespace quadrille::draw
