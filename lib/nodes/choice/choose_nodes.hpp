#pragma once
// The irregular nodes and corner valences of a layout, chosen from a guiding field: all steps of critpoints
// (lib/method.md §3, §5). Each changes the result of the one before and keeps the index sum:
//   find_critical_points        zeros, clusters, corners by angle or field, corners that absorb zeros
//   resolve_clusters            clusters become nodes
//   choose_at_ties              replaces both if corners lie near 45 + 90 k degrees
//   line_field_points           replaces all these if the zeros cannot be isolated
//   override_corners            prescribed valences
//   divide_degenerate_corners   corners that are too sharp for a block
//   apply_topology              the grid and the number of nodes that a user chooses
//   resolve_features            nodes of small fillets and holes
//   place_nodes                 positions of least energy
//   keep_clearance              nodes too near to walls with layers
//   complete_nodes              elements, order
// Each change is recorded. A step whose result has a node that is no zero of the field sets the form `phase`.

#include <functional>
#include <optional>
#include <vector>

#include "base/report.hpp"
#include "guide/divide_corners.hpp"
#include "guide/find_critical_points.hpp"
#include "guide/override_corners.hpp"
#include "model/critical_points.hpp"
#include "model/field.hpp"
#include "placement/keep_clearance.hpp"
#include "placement/place_nodes.hpp"
#include "ties/choose_at_ties.hpp"
#include "topology/apply_topology.hpp"

namespace quadrille::choice {

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
};

/// Called with the name of each part of the work as it begins: search, resolve, place.
using PartBegins = std::function<void(const char* name)>;

/// `field`: harmonic, with an error estimate of each element (field/error_estimate). The result has no provenance.
/// Throws UsageError for overrides that do not fit the face, ComputeError if the index sum does not hold. The report
/// gets the keys of the steps, `feature_size`, and a warning if the nodes are chosen by rule.
CriticalPoints choose_nodes(const Field& field, const NodeOptions& options, int num_threads, Report& report,
                            const PartBegins& begin = {});

}  // namespace quadrille::choice
