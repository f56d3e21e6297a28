#pragma once
// What a user prescribes of irregular nodes and corner valences.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/report.hpp"
#include "guide/divide_corners.hpp"
#include "guide/find_critical_points.hpp"
#include "guide/override_corners.hpp"
#include "placement/keep_clearance.hpp"
#include "placement/place_nodes.hpp"
#include "ties/choose_at_ties.hpp"
#include "topology/apply_topology.hpp"

namespace quadrille::choice {

/// What the search in a field has found with these options: nodes before any that a user chooses.
struct FoundNodes {
  guide::SearchOptions search;
  int max_valence = 0;
  ties::TiePolicy ties = ties::TiePolicy::choose;
  CriticalPoints points;
  Report report;

  bool operator==(const FoundNodes& other) const {  // whether the search is the same
    return search == other.search && max_valence == other.max_valence && ties == other.ties;
  }
};

/// The energy of nodes at their positions.
struct FoundEnergy {
  PhaseNodes nodes;
  std::vector<int> hole_winding_offsets;
  placement::NodeEnergy energy;
};

/// What choices from one field have found so far.
struct Found {
  std::optional<FoundNodes> nodes;    ///< of the last search
  std::vector<FoundEnergy> energies;  ///< in the order of their computation
};

/// The defaults are those of critpoints.
struct NodeOptions {
  guide::SearchOptions search;
  int max_valence = 6;                           ///< >= 5; clusters that would need a greater one are split
  std::vector<guide::CornerOverride> overrides;  ///< prescribed corner valences
  ties::TiePolicy ties = ties::TiePolicy::choose;
  guide::DegeneratePolicy degenerate = guide::DegeneratePolicy::divide;
  std::optional<double> feature_size;  ///< length, 0: fillets and holes keep their nodes; none: features/small_features
  topology::NodeRule nodes = topology::NodeRule::by_grid;
  topology::GridKind topology = topology::GridKind::by_outline;
  topology::LayerCorners layer_corners = topology::LayerCorners::by_bodies;
  placement::PlaceRule place = placement::PlaceRule::keep;
  placement::PlacementOptions placement;
  std::vector<placement::WallClearance> walls;  ///< from which nodes keep a distance
  /// Patterns of the names of curves on lines at which the face is one half, or a quarter, of a whole: then the nodes
  /// are those of the whole (choice/half_model.hpp). Without effect where curve/symmetry_lines.hpp finds no such lines.
  std::vector<std::string> symmetry;
  /// Shared by choices from one field, so that what is the same is computed once. Null: not shared.
  std::shared_ptr<Found> found;
};

}  // namespace quadrille::choice
