// Draws the separatrices over the face, one colour for each origin, with the nodes of the graph.

#include <fmt/format.h>

#include "draw/labels.hpp"
#include "draw/marks.hpp"
#include "draw/palette.hpp"
#include "model/interfaces.hpp"

namespace quadrille::draw {

namespace {

const char* kind_name(NodeKind kind) {
  switch (kind) {
    case NodeKind::irregular:
      return "irregular node";
    case NodeKind::corner:
      return "corner";
    case NodeKind::boundary:
      return "end on the boundary";
    case NodeKind::crossing:
      return "crossing";
    case NodeKind::cut:
      return "end of a cut";
    case NodeKind::interface:
      return "end on an interface";
    case NodeKind::junction:
      return "junction of interfaces";
  }
  return "node";
}

void append_arc(PathData& path, const Picture& picture, const SeparatrixGraph& graph, int arc) {
  for (const ArcPiece& piece : graph.arcs[arc].pieces)
    append_nurbs(path, picture, graph.curve(piece.curve), piece.t0, piece.t1);
}

void draw_line(Picture& picture, const SeparatrixGraph& graph, int id) {
  const SeparatrixLine& line = graph.lines[id];
  const std::vector<std::string>& colours = palette(Paper::light).lines;
  std::string d;
  for (const int arc : line.arcs) {
    PathData path;
    append_arc(path, picture, graph, arc);
    d += path.str();
  }
  picture.add(svg_element(
      "path",
      {{"class", "line"},
       {"id", fmt::format("line-{}", id)},
       {"stroke", colours[line.origin % colours.size()]},
       {"d", d}},
      fmt::format("separatrix {} ({}), from node {} to node {}", id, enum_name(line.kind), line.origin, line.end)));
}

/// Inner arcs that belong to no separatrix are drawn separately, as they would be missing otherwise.
void draw_loose_arcs(Picture& picture, const SeparatrixGraph& graph) {
  std::vector<bool> is_drawn(graph.arcs.size(), false);
  for (const SeparatrixLine& line : graph.lines)
    for (const int arc : line.arcs) is_drawn[arc] = true;
  for (std::size_t a = 0; a < graph.arcs.size(); ++a) {
    if (is_drawn[a] || is_on_cad_curve(graph, graph.arcs[a])) continue;
    PathData path;
    append_arc(path, picture, graph, static_cast<int>(a));
    picture.add(path_element("edge", path.str(), fmt::format("arc {}", a)));
  }
}

void draw_node(Picture& picture, const SeparatrixGraph& graph, int id) {
  const GraphNode& node = graph.nodes[id];
  const Vec2 at = picture.at(node.position);
  const std::string title = fmt::format("node {}, {}, valence {}, at {}", id, kind_name(node.kind), node.valence,
                                        position_text(node.position, graph.face.origin));
  switch (node.kind) {
    case NodeKind::irregular:
      return picture.add(valence_mark(at, node.valence, 8, title));
    case NodeKind::corner:
      return picture.add(circle_mark("corner", at, 4, title));
    default:
      return picture.add(circle_mark("dot", at, 2.6, title));
  }
}

/// "traced: 4 faces of 4 corners, index sum 4, turned by 2.3° at most".
std::string certificate_text(const LayoutCertificate& certificate) {
  std::string text = enum_name(*certificate.method) + ": ";
  for (const FaceCount& count : certificate.face_valence_histogram)
    text += fmt::format("{} of {} corners, ", counted(count.faces, "face"), count.corners);
  text += fmt::format("index sum {}", certificate.index_sum);
  if (certificate.t_junctions > 0) text += ", " + counted(certificate.t_junctions, "T-junction");
  if (certificate.merged_lines > 0) text += fmt::format(", {} merged", counted(certificate.merged_lines, "pair"));
  const int num_collapsed = certificate.collapsed_chords + certificate.shortened_spirals;
  if (num_collapsed > 0) text += fmt::format(", {} taken out", counted(num_collapsed, "strip"));
  if (certificate.method == LayoutMethod::midpoint) return text + ", triangles divided into three blocks each";
  return text + fmt::format(", turned by {:.1f}° at most", certificate.largest_deviation_degrees);
}

}  // namespace

std::string draw_stage(const SeparatrixGraph& graph, const DrawOptions& options) {
  std::string caption = fmt::format("{}, {}, {}", counted(graph.lines.size(), "line"),
                                    counted(graph.nodes.size(), "node"), counted(graph.arcs.size(), "arc")) +
                        regions_text(graph.face);
  if (graph.certificate.method) caption += "; " + certificate_text(graph.certificate);
  Picture picture(shown_box(bounding_box(graph.face), graph.face.origin, options), options, "Separatrices", caption);
  draw_face_area(picture, graph.face);
  draw_loose_arcs(picture, graph);
  for (std::size_t l = 0; l < graph.lines.size(); ++l) draw_line(picture, graph, static_cast<int>(l));
  draw_boundary(picture, graph.face);
  std::vector<int> valences;
  // Dots first: marks of irregular nodes lie above them.
  for (const bool dots : {true, false})
    for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
      const bool is_dot = graph.nodes[n].kind != NodeKind::irregular;
      if (is_dot == dots) draw_node(picture, graph, static_cast<int>(n));
      if (!is_dot && !dots) valences.push_back(graph.nodes[n].valence);
    }
  for (const int n : graph.t_junctions)
    picture.add(circle_mark("ring", picture.at(graph.nodes[n].position), 7, "T-junction"));
  legend_valences(picture, valences);
  legend_corner(picture, graph.face);
  picture.legend_mark(circle_mark("dot", {0, 0}, 3), "crossing or end");
  legend_regions(picture, graph.face);
  label_curves(picture, graph.face, options.curve_labels);
  legend_scale(picture, graph.face);
  return picture.str();
}

}  // namespace quadrille::draw
