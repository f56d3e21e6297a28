#include "refine/split_isoparametric.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "mesh/chords.hpp"
#include "mesh/transfinite.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::refine {
namespace {

/// The nodes of an arc from its start to its end: every interval's Gauss-Lobatto-Legendre points, ends shared.
struct ArcNodes {
  std::vector<double> fractions;
  std::vector<int> ids;
};

std::vector<double> node_fractions(const std::vector<double>& ends, int order) {
  const std::vector<double>& gll = spectral::gll_points(order);
  std::vector<double> fractions{ends.front()};
  for (std::size_t k = 1; k < ends.size(); ++k) {
    for (int i = 1; i < order; ++i) fractions.push_back(ends[k - 1] * (1 - gll[i]) / 2 + ends[k] * (1 + gll[i]) / 2);
    fractions.push_back(ends[k]);
  }
  return fractions;
}

class Splitter {
 public:
  Splitter(const BlockLayout& layout, const std::vector<curve::Chain>& chains,
           const std::vector<std::vector<double>>& arc_ends, int order, const layers::WallPlan* walls)
      : layout_(layout), chains_(chains), arc_ends_(arc_ends), walls_(walls) {
    mesh_.provenance = layout.provenance;
    mesh_.face = layout.face;
    mesh_.order = order;
    mesh_.block_names = layout.block_names;
  }

  QuadMesh split() {
    for (const GraphNode& node : layout_.nodes) {
      mesh_.nodes.push_back(node.position);
      mesh_.num_irregular += node.curve < 0 && node.valence != 4;
    }
    for (std::size_t arc = 0; arc < layout_.arcs.size(); ++arc)
      arc_nodes_.push_back(place_on_arc(static_cast<int>(arc)));
    for (int block = 0; block < layout_.num_blocks(); ++block) split_block(block);
    sort_boundary();
    return std::move(mesh_);
  }

 private:
  ArcNodes place_on_arc(int arc) {
    const bool is_layered = walls_ && !walls_->arc_nodes[arc].empty();
    ArcNodes nodes{is_layered ? walls_->arc_nodes[arc] : node_fractions(arc_ends_[arc], mesh_.order), {}};
    nodes.ids.push_back(layout_.arcs[arc].from);
    for (std::size_t k = 1; k + 1 < nodes.fractions.size(); ++k) {
      nodes.ids.push_back(static_cast<int>(mesh_.nodes.size()));
      mesh_.nodes.push_back(chains_[arc].at(nodes.fractions[k]).position);
    }
    nodes.ids.push_back(layout_.arcs[arc].to);
    return nodes;
  }

  /// A side's nodes in the direction of rising s or t: sides 0 and 1 as they are walked, 2 and 3 against it.
  ArcNodes side_nodes(int block, int side) const {
    const HalfEdge directed = layout_.block2arcs[block][side];
    ArcNodes nodes = arc_nodes_[directed.arc];
    if (directed.is_backwards != (side >= 2)) {
      std::reverse(nodes.ids.begin(), nodes.ids.end());
      std::reverse(nodes.fractions.begin(), nodes.fractions.end());
      for (double& f : nodes.fractions) f = 1 - f;
    }
    return nodes;
  }

  void split_block(int block) {
    const std::array<ArcNodes, 4> sides{side_nodes(block, 0), side_nodes(block, 1), side_nodes(block, 2),
                                        side_nodes(block, 3)};
    const std::vector<int> grid = place_in_block(block, sides);
    const int width = static_cast<int>(sides[0].ids.size()), order = mesh_.order;
    const int columns = (width - 1) / order, rows = static_cast<int>(sides[1].ids.size() - 1) / order;
    const int first_elem = mesh_.num_elems();
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i) {
        mesh_.elem_block.push_back(block);
        for (int b = 0; b <= order; ++b)
          for (int a = 0; a <= order; ++a) mesh_.elem_nodes.push_back(grid[(j * order + b) * width + i * order + a]);
      }
    add_boundary(block, first_elem, columns, rows);
  }

  /// Node ids of the whole block, along side 0 fastest; new nodes inside, by the blend of the sides.
  std::vector<int> place_in_block(int block, const std::array<ArcNodes, 4>& sides) {
    std::array<Vec2, 4> corners;
    for (int k = 0; k < 4; ++k) corners[k] = layout_.nodes[layout_.block2nodes[block][k]].position;
    const int width = static_cast<int>(sides[0].ids.size()), height = static_cast<int>(sides[1].ids.size());
    const std::vector<Vec2> in_layers = layered_inside(block, sides);
    std::vector<int> grid;
    grid.reserve(width * height);
    for (int j = 0; j < height; ++j)
      for (int i = 0; i < width; ++i) {
        if (j == 0 || j == height - 1) {
          grid.push_back(sides[j == 0 ? 0 : 2].ids[i]);
        } else if (i == 0 || i == width - 1) {
          grid.push_back(sides[i == 0 ? 3 : 1].ids[j]);
        } else {
          grid.push_back(static_cast<int>(mesh_.nodes.size()));
          if (!in_layers.empty()) {
            mesh_.nodes.push_back(in_layers[j * width + i]);
            continue;
          }
          const Vec2 st = mesh::crossing_parameters(sides[0].fractions[i], sides[1].fractions[j], sides[2].fractions[i],
                                                    sides[3].fractions[j]);
          const std::array<Vec2, 4> on_sides{position(sides[0].ids[i]), position(sides[1].ids[j]),
                                             position(sides[2].ids[i]), position(sides[3].ids[j])};
          mesh_.nodes.push_back(mesh::blend_sides(on_sides, corners, st.x, st.y));
        }
      }
    return grid;
  }

  /// The nodes of a block along a wall, or whose chords go on from layers; none for other blocks.
  std::vector<Vec2> layered_inside(int block, const std::array<ArcNodes, 4>& sides) const {
    const std::array<HalfEdge, 4>& arcs = layout_.block2arcs[block];
    if (!walls_ || !(walls_->is_graded[arcs[0].arc] || walls_->is_graded[arcs[1].arc])) return {};
    std::array<std::vector<double>, 4> fractions;
    for (int k = 0; k < 4; ++k) fractions[k] = sides[k].fractions;
    const layers::LayeredBlock layered = layers::layered_block(*walls_, layout_, chains_, block, std::move(fractions));
    return layers::layered_positions(layered, mesh_.order, layout_.face.origin);
  }

  Vec2 position(int node) const { return mesh_.nodes[node]; }

  void add_boundary(int block, int first_elem, int columns, int rows) {
    for (int side = 0; side < 4; ++side) {
      const HalfEdge directed = layout_.block2arcs[block][side];
      const int arc = directed.arc;
      if (!layout_.arcs[arc].is_boundary) continue;
      const std::vector<double>& ends = arc_ends_[arc];
      const int count = side % 2 == 0 ? columns : rows;
      for (int k = 0; k < count; ++k) {  // k along the side as it is walked
        const int i = side == 0 ? k : side == 1 ? columns - 1 : side == 2 ? columns - 1 - k : 0;
        const int j = side == 0 ? 0 : side == 1 ? k : side == 2 ? rows - 1 : rows - 1 - k;
        const int interval = directed.is_backwards ? count - 1 - k : k;
        const curve::ChainPoint middle = chains_[arc].at((ends[interval] + ends[interval + 1]) / 2);
        const int curve = layout_.arcs[arc].pieces[middle.piece].curve;
        boundary_.push_back({curve, middle.t, {first_elem + j * columns + i, side, curve}});
      }
    }
  }

  void sort_boundary() {
    const auto walk = [](const PlacedEdge& a, const PlacedEdge& b) {
      return std::tie(a.curve, a.t, a.edge.elem) < std::tie(b.curve, b.t, b.edge.elem);
    };
    std::sort(boundary_.begin(), boundary_.end(), walk);
    for (const PlacedEdge& placed : boundary_) mesh_.boundary_edges.push_back(placed.edge);
  }

  struct PlacedEdge {
    int curve;
    double t;
    QuadBoundaryEdge edge;
  };

  const BlockLayout& layout_;
  const std::vector<curve::Chain>& chains_;
  const std::vector<std::vector<double>>& arc_ends_;
  const layers::WallPlan* walls_;
  QuadMesh mesh_;
  std::vector<ArcNodes> arc_nodes_;
  std::vector<PlacedEdge> boundary_;
};

}  // namespace

QuadMesh split_isoparametric(const BlockLayout& layout, const std::vector<curve::Chain>& chains,
                             const std::vector<std::vector<double>>& arc_ends, int order,
                             const layers::WallPlan* walls) {
  return Splitter(layout, chains, arc_ends, order, walls).split();
}

}  // namespace quadrille::refine
