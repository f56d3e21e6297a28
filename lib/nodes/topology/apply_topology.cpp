#include "topology/apply_topology.hpp"

#include "guide/override_corners.hpp"
#include "model/name_rules.hpp"
#include "topology/fewest_nodes.hpp"

namespace quadrille::topology {
namespace {

/// The kind of grid of this face: none without a hole, or a slit that joins one to the outline.
GridKind grid_of(const CadFace& face, const TopologyOptions& options) {
  if ((face.num_loops() < 2 && face.partners.empty()) || is_along_walls(face)) return GridKind::none;
  if (options.grid != GridKind::by_outline) return options.grid;
  return options.nodes == NodeRule::field ? GridKind::none : kind_of_outline(face);
}

const char* reason_of(GridKind grid) {
  switch (grid) {
    case GridKind::c:
      return "makes a C-grid";
    case GridKind::o:
      return "makes an O-grid";
    default:
      return "makes an H-grid";
  }
}

}  // namespace

bool apply_topology(const CadFace& face, const TopologyOptions& options, CriticalPoints& points) {
  const GridKind grid = grid_of(face, options);
  const bool closes_layers = options.grid == GridKind::o || options.layer_corners == LayerCorners::close;
  if (is_along_walls(face) && closes_layers)
    guide::override_corners(face, closed_layer_corners(face, points), points, "closes layers around a body");
  guide::override_corners(face, grid_corners(face, grid, points), points, reason_of(grid));
  NodeRule nodes = options.nodes;
  if (nodes == NodeRule::by_grid)
    nodes = grid == GridKind::none && !is_along_walls(face) ? NodeRule::field : NodeRule::fewest;
  if (nodes == NodeRule::field) return false;
  if (nodes == NodeRule::none)
    guide::override_corners(face, corners_without_nodes(face, points), points, "needs the fewest nodes");
  keep_fewest_nodes(face, options.max_valence, points);
  return grid != GridKind::o || !set_wake_nodes(face, points);
}

}  // namespace quadrille::topology
