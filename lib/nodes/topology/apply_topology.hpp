#pragma once
// The grid and the number of nodes that a user chooses, applied to nodes and corners that the field has.

#include "base/enum_names.hpp"
#include "model/cad_face.hpp"
#include "model/critical_points.hpp"
#include "topology/grid_kind.hpp"

namespace quadrille::topology {

/// Which irregular nodes a layout has inside. `field`: those of the field. `fewest`: none that the index sum does not
/// require for these corner valences, so that all have the same sign. `none`: corner valences are changed too, so that
/// no node is required, or as few as possible. `by_grid`: `fewest` if a kind of grid is chosen, and
/// between walls and their offset curves, where layers run; else `field`.
enum class NodeRule { by_grid, none, fewest, field };
constexpr auto enum_names(NodeRule) { return std::to_array({"auto", "none", "fewest", "field"}); }

struct TopologyOptions {
  NodeRule nodes = NodeRule::by_grid;
  GridKind grid = GridKind::by_outline;
  int max_valence = 6;  ///< nodes of opposite index that merge to a greater one become several
  LayerCorners layer_corners = LayerCorners::by_bodies;  ///< of walls with an offset curve, also in an O-grid `close`
};

/// Sets corner valences of the grid, then those without nodes, then merges nodes. Returns whether all nodes (but those
/// of divided corners) are to be placed at the least energy: true unless the nodes are those of the field, or lie in
/// the wakes of an O-grid (topology/fewest_nodes). `face` has one region; kinds of grid are not of regions between
/// walls and their offset curves. A far field's grid is not chosen if `nodes` is `field`.
bool apply_topology(const CadFace& face, const TopologyOptions& options, CriticalPoints& points);

}  // namespace quadrille::topology
