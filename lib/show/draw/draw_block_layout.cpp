// Draws the blocks in pale colours with their numbers, the worst of them outlined if it is poor, irregular nodes and
// corners.

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "curve/nurbs.hpp"
#include "draw/labels.hpp"
#include "draw/marks.hpp"
#include "model/interfaces.hpp"

namespace quadrille::draw {

namespace {

PathData block_outline(const Picture& picture, const BlockLayout& layout, int block) {
  PathData path;
  for (int k = 0; k < 4; ++k)
    for (const ArcPiece& piece : side_pieces(layout, layout.block2arcs[block][k]))
      append_nurbs(path, picture, layout.curve(piece.curve), piece.t0, piece.t1);
  path.close();
  return path;
}

/// The point half way along a side, by the lengths of a fine polyline.
Vec2 side_middle(const BlockLayout& layout, int block, int k) {
  std::vector<Vec2> points;
  for (const ArcPiece& piece : side_pieces(layout, layout.block2arcs[block][k]))
    for (int i = 0; i <= 16; ++i)
      points.push_back(curve::point(layout.curve(piece.curve), std::lerp(piece.t0, piece.t1, i / 16.0)));
  double length = 0, walked = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += distance(points[i - 1], points[i]);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double step = distance(points[i - 1], points[i]);
    if (walked + step >= length / 2 && step > 0)
      return points[i - 1] + (length / 2 - walked) / step * (points[i] - points[i - 1]);
    walked += step;
  }
  return points.front();
}

/// The middle of the transfinite blend.
Vec2 block_centre(const BlockLayout& layout, int block) {
  Vec2 centre;
  for (int k = 0; k < 4; ++k)
    centre += 0.5 * side_middle(layout, block, k) - 0.25 * layout.nodes[layout.block2nodes[block][k]].position;
  return centre;
}

bool is_irregular_on_boundary(const GraphNode& node) { return node.kind == NodeKind::boundary && node.valence != 2; }

/// Also on interfaces.
bool is_irregular_inside(const GraphNode& node) {
  return node.kind == NodeKind::irregular || (node.curve >= 0 && node.is_inner() && node.valence != 4);
}

/// Draws inner nodes as polygons with one vertex per block, and boundary nodes as squares standing on a vertex.
void draw_irregular_nodes(Picture& picture, const BlockLayout& layout) {
  for (const GraphNode& node : layout.nodes) {
    const std::string about =
        fmt::format("of valence {} at {}", node.valence, position_text(node.position, layout.face.origin));
    if (is_irregular_inside(node))
      picture.add(valence_mark(picture.at(node.position), node.valence, 8, "irregular node " + about));
    if (is_irregular_on_boundary(node))
      picture.add(boundary_mark(picture.at(node.position), node.valence, 8, "irregular node on the boundary " + about));
  }
}

void legend_irregular_nodes(Picture& picture, const BlockLayout& layout) {
  std::vector<int> inside;
  std::set<int> on_boundary;
  for (const GraphNode& node : layout.nodes) {
    if (is_irregular_inside(node)) inside.push_back(node.valence);
    if (is_irregular_on_boundary(node)) on_boundary.insert(node.valence);
  }
  legend_valences(picture, inside);
  for (const int v : on_boundary)
    picture.legend_mark(boundary_mark({0, 0}, v, 7), fmt::format("on the boundary, valence {}", v));
}

/// The fill of each block.
std::vector<std::string> block_colours(const BlockLayout& layout) {
  const std::vector<int> tints = region_tints(layout.face);
  std::vector<std::string> colours;
  for (int b = 0; b < layout.num_blocks(); ++b)
    colours.push_back(layout.block_region.empty() ? quiet_colour(b) : region_colour(tints[layout.block_region[b]], b));
  return colours;
}

void draw_block(Picture& picture, const BlockLayout& layout, int block, const std::string& colour) {
  const std::string name = block < static_cast<int>(layout.block_names.size()) ? layout.block_names[block] : "";
  std::string title = fmt::format("block {}", block);
  if (!name.empty() && name != title) title += ": " + name;
  picture.add(svg_element(
      "path",
      {{"id", fmt::format("block-{}", block)}, {"fill", colour}, {"d", block_outline(picture, layout, block).str()}},
      title));
  picture.text(picture.at(block_centre(layout, block)), "label", std::to_string(block));
}

}  // namespace

std::string draw_stage(const BlockLayout& layout, const DrawOptions& options) {
  const std::set<int> chords(layout.arc_chord.begin(), layout.arc_chord.end());
  const std::vector<double>& quality = layout.block_scaled_jacobian;
  const int worst = worst_to_mark(quality);
  const auto is_irregular = [](const GraphNode& n) { return is_irregular_inside(n) || is_irregular_on_boundary(n); };
  const auto num_irregular = std::count_if(layout.nodes.begin(), layout.nodes.end(), is_irregular);
  Picture picture(shown_box(bounding_box(layout.face), layout.face.origin, options), options, "Blocks",
                  fmt::format("{}, {}, {}{}{}", counted(layout.num_blocks(), "block"), counted(chords.size(), "chord"),
                              counted(num_irregular, "irregular node"), regions_text(layout.face),
                              quality.empty() ? ""
                                              : fmt::format(", worst scaled Jacobian {:.3f}",
                                                            *std::min_element(quality.begin(), quality.end()))));
  picture.open_group("blocks");
  const std::vector<std::string> colours = block_colours(layout);
  for (int b = 0; b < layout.num_blocks(); ++b) draw_block(picture, layout, b, colours[b]);
  picture.close_group();
  for (std::size_t a = 0; a < layout.arcs.size(); ++a) {
    if (is_on_cad_curve(layout, layout.arcs[a])) continue;
    PathData path;
    for (const ArcPiece& piece : layout.arcs[a].pieces)
      append_nurbs(path, picture, layout.curve(piece.curve), piece.t0, piece.t1);
    picture.add(svg_element("path", {{"class", "edge"}, {"id", fmt::format("arc-{}", a)}, {"d", path.str()}},
                            fmt::format("arc {}, chord {}", a, layout.arc_chord.empty() ? -1 : layout.arc_chord[a])));
  }
  draw_boundary(picture, layout.face);
  if (worst >= 0)
    picture.add(path_element("worst", block_outline(picture, layout, worst).str(),
                             fmt::format("block {}, scaled Jacobian {:.4g}", worst, quality[worst])));
  draw_corners(picture, layout.face);
  draw_irregular_nodes(picture, layout);
  legend_irregular_nodes(picture, layout);
  if (worst >= 0)
    picture.legend_mark(path_element("worst", "M-6,-5H6V5H-6Z"),
                        fmt::format("the worst: scaled Jacobian {:.3f}", quality[worst]));
  legend_corner(picture, layout.face);
  legend_regions(picture, layout.face);
  label_curves(picture, layout.face, options.curve_labels);
  legend_scale(picture, layout.face);
  return picture.str();
}

}  // namespace quadrille::draw
