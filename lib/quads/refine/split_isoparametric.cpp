#include "refine/split_isoparametric.hpp"

#include <algorithm>
#include <tuple>

#include "mesh/transfinite.hpp"
#include "model/interfaces.hpp"
#include "sizing/halved_blocks.hpp"

namespace quadrille::refine {
namespace {

/// The input from which the mesh is made.
struct SplitInput {
  const sizing::MeasuredLayout& measured;
  const sizing::ArcDivisions& divisions;
  const layers::WallPlan* walls;
  const growth::LinePlan& lines;

  const BlockLayout& layout() const { return measured.blocks(); }
};

/// An edge on a CAD curve with its position along the curve.
struct PlacedEdge {
  QuadBoundaryEdge edge;
  double t = 0;  ///< parameter of its middle on its curve
};

/// Those on the boundary, and those on interfaces from both sides.
struct PlacedEdges {
  std::vector<PlacedEdge> boundary, interfaces;
};

QuadMesh mesh_without_elements(const BlockLayout& layout, int order) {
  QuadMesh mesh;
  mesh.provenance = layout.provenance;
  mesh.face = layout.face;
  mesh.open_curves = layout.open_curves;
  mesh.order = order;
  mesh.block_names = layout.block_names;
  mesh.unnamed_blocks = layout.unnamed_blocks;
  mesh.block_region = layout.block_region;
  for (const GraphNode& node : layout.nodes) {
    mesh.nodes.push_back(node.position);
    mesh.num_irregular += node.is_inner() && node.valence != 4;
  }
  return mesh;
}

/// Positions of all nodes of a block that has layers, or whose chords continue from layers; none for other blocks.
std::vector<Vec2> layered_nodes(const SplitInput& in, int block, const std::array<ArcNodes, 4>& sides, int order) {
  const auto& arcs = in.layout().block2arcs[block];
  const auto is_graded = [&](int side) { return in.walls->is_graded[arcs[side].arc]; };
  const growth::BlockLines& lengths = in.lines.lengths;
  const bool has_lines = !lengths.empty() && !(lengths[block][0].empty() && lengths[block][1].empty());
  if (!in.walls || !(has_lines || is_graded(0) || is_graded(1))) return {};
  std::array<std::vector<double>, 4> fractions;
  for (int k = 0; k < 4; ++k) fractions[k] = sides[k].fractions;
  layers::LayeredBlock layered = layers::layered_block(*in.walls, in.measured, block, std::move(fractions));
  if (has_lines) layered.lines = lengths[block];
  if (has_lines && !in.lines.factors.empty()) layered.factors = in.lines.factors[block];
  if (!in.lines.shifts.empty()) layered.shifts = in.lines.shifts[block];
  return layers::layered_positions(layered, order, in.layout().face);
}

/// The node (i, j) inside a block: the blend of its sides, or of those of the block of the whole, where the straight
/// lines between opposite nodes cross.
Vec2 inner_node(const QuadMesh& mesh, const std::array<Vec2, 4>& corners, const std::array<ArcNodes, 4>& sides, int i,
                int j, const sizing::HalvedSide* halved) {
  sizing::SidePoints points{{}, corners, {}};
  for (int side = 0; side < 4; ++side) {
    const int k = side % 2 == 0 ? i : j;
    points.positions[side] = mesh.nodes[sides[side].ids[k]];
    points.fractions[side] = sides[side].fractions[k];
  }
  if (halved) return sizing::position_in_whole(points, *halved);
  const auto& [a, b, c, d] = points.fractions;
  const Vec2 st = mesh::crossing_parameters(a, b, c, d);
  return mesh::blend_sides(points.positions, corners, st.x, st.y);
}

/// Node ids of the whole block, along side 0 fastest; appends the nodes inside to the mesh.
std::vector<int> place_in_block(const SplitInput& in, int block, const std::array<ArcNodes, 4>& sides, QuadMesh& mesh) {
  std::array<Vec2, 4> corners;
  for (int k = 0; k < 4; ++k) corners[k] = in.layout().nodes[in.layout().block2nodes[block][k]].position;
  const int width = static_cast<int>(sides[0].ids.size()), height = static_cast<int>(sides[1].ids.size());
  const std::vector<Vec2> layered = layered_nodes(in, block, sides, mesh.order);
  const sizing::HalvedSide* halved = in.measured.halved_side(block);
  std::vector<int> grid;
  grid.reserve(width * height);
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i) {
      if (j == 0 || j == height - 1) {
        grid.push_back(sides[j == 0 ? 0 : 2].ids[i]);
      } else if (i == 0 || i == width - 1) {
        grid.push_back(sides[i == 0 ? 3 : 1].ids[j]);
      } else {
        grid.push_back(static_cast<int>(mesh.nodes.size()));
        mesh.nodes.push_back(layered.empty() ? inner_node(mesh, corners, sides, i, j, halved) : layered[j * width + i]);
      }
    }
  return grid;
}

/// Appends the elements of a block of columns x rows elements.
void append_elements(const std::vector<int>& grid, int block, int columns, int rows, QuadMesh& mesh) {
  const int order = mesh.order, width = columns * order + 1;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      mesh.elem_block.push_back(block);
      for (int b = 0; b <= order; ++b)
        for (int a = 0; a <= order; ++a) mesh.elem_nodes.push_back(grid[(j * order + b) * width + i * order + a]);
    }
}

/// The curve and the parameter of a point of an arc as a side of a block sees them: on the curve of its own region.
PartnerPoint point_on_own_curve(const BlockLayout& layout, HalfEdge side, const curve::ChainPoint& at) {
  const GraphArc& arc = layout.arcs[side.arc];
  const ArcPiece& piece = arc.pieces[at.piece];
  const bool is_left_of_curve = side.is_backwards != (piece.t0 < piece.t1);
  if (arc.is_boundary || is_left_of_curve) return {piece.curve, at.t};
  return partner_point(layout.face, piece.curve, at.t);
}

/// Appends the edges of a block's elements on the boundary and on interfaces.
void append_edges(const SplitInput& in, int block, int first_elem, int columns, int rows, PlacedEdges& edges) {
  for (int side = 0; side < 4; ++side) {
    const HalfEdge directed = in.layout().block2arcs[block][side];
    const int arc = directed.arc;
    if (!is_on_cad_curve(in.layout(), in.layout().arcs[arc])) continue;
    std::vector<PlacedEdge>& own = in.layout().arcs[arc].is_boundary ? edges.boundary : edges.interfaces;
    const int count = side % 2 == 0 ? columns : rows;
    for (int k = 0; k < count; ++k) {  // k in the direction of the side
      const int i = side == 0 ? k : side == 1 ? columns - 1 : side == 2 ? columns - 1 - k : 0;
      const int j = side == 0 ? 0 : side == 1 ? k : side == 2 ? rows - 1 : rows - 1 - k;
      const int interval = directed.is_backwards ? count - 1 - k : k;
      const curve::ChainPoint middle = in.measured.chain(arc).at(in.divisions[arc].middle(interval));
      const PartnerPoint on_curve = point_on_own_curve(in.layout(), directed, middle);
      own.push_back({{first_elem + j * columns + i, side, on_curve.curve}, on_curve.t});
    }
  }
}

/// In the direction of the loops.
std::vector<QuadBoundaryEdge> sorted_along_curves(std::vector<PlacedEdge> edges) {
  std::sort(edges.begin(), edges.end(), [](const PlacedEdge& a, const PlacedEdge& b) {
    return std::tie(a.edge.curve, a.t, a.edge.elem) < std::tie(b.edge.curve, b.t, b.edge.elem);
  });
  std::vector<QuadBoundaryEdge> sorted;
  for (const PlacedEdge& placed : edges) sorted.push_back(placed.edge);
  return sorted;
}

}  // namespace

ArcNodes place_on_arc(const sizing::MeasuredLayout& measured, int arc, const sizing::ArcDivision& division,
                      const layers::WallPlan* walls, QuadMesh& mesh) {
  ArcNodes nodes{walls ? walls->nodes_on(arc, division, mesh.order) : layers::interval_nodes(division.ends, mesh.order),
                 {measured.blocks().arcs[arc].from}};
  for (std::size_t k = 1; k + 1 < nodes.fractions.size(); ++k) {
    nodes.ids.push_back(static_cast<int>(mesh.nodes.size()));
    mesh.nodes.push_back(measured.chain(arc).position(nodes.fractions[k]));
  }
  nodes.ids.push_back(measured.blocks().arcs[arc].to);
  return nodes;
}

std::array<ArcNodes, 4> side_nodes(const BlockLayout& layout, int block, const std::vector<ArcNodes>& arc_nodes) {
  std::array<ArcNodes, 4> sides;
  for (int side = 0; side < 4; ++side) {
    const HalfEdge directed = layout.block2arcs[block][side];
    sides[side] = arc_nodes[directed.arc];
    if (directed.is_backwards == (side >= 2)) continue;
    std::ranges::reverse(sides[side].ids);
    sizing::reverse_fractions(sides[side].fractions);
  }
  return sides;
}

QuadMesh split_isoparametric(const sizing::MeasuredLayout& measured, const sizing::ArcDivisions& divisions, int order,
                             const layers::WallPlan* walls, const growth::LinePlan& lines) {
  const SplitInput in{measured, divisions, walls, lines};
  QuadMesh mesh = mesh_without_elements(in.layout(), order);
  std::vector<ArcNodes> arc_nodes;
  for (int arc = 0; arc < measured.num_arcs(); ++arc)
    arc_nodes.push_back(place_on_arc(measured, arc, divisions[arc], walls, mesh));
  PlacedEdges edges;
  for (int block = 0; block < in.layout().num_blocks(); ++block) {
    const std::array<ArcNodes, 4> sides = side_nodes(in.layout(), block, arc_nodes);
    const int columns = static_cast<int>(sides[0].ids.size() - 1) / order;
    const int rows = static_cast<int>(sides[1].ids.size() - 1) / order, first_elem = mesh.num_elems();
    append_elements(place_in_block(in, block, sides, mesh), block, columns, rows, mesh);
    append_edges(in, block, first_elem, columns, rows, edges);
  }
  mesh.boundary_edges = sorted_along_curves(std::move(edges.boundary));
  mesh.interface_edges = sorted_along_curves(std::move(edges.interfaces));
  return mesh;
}

}  // namespace quadrille::refine
