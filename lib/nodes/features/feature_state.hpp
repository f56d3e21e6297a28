#pragma once
// What the rules for small features share (features/resolve_features): their constants, and the state that they pass on
// to each other, the nodes without their data in the field. L is the feature size.

#include <optional>
#include <string>
#include <vector>

#include "model/critical_points.hpp"

namespace quadrille::features {

struct FeatureConstants {
  // Definition of features (features/small_features).
  double straight_curvature = 1e-3;  ///< curvature times diameter below which the boundary counts as straight
  int samples_per_span = 24;         ///< samples of the curvature on each knot span
  double index_rounding = 0.6;       ///< a run that turns by tau carries the index floor(2 tau / pi + 0.6)

  double automatic_size = 1.0 / 500;  ///< L if the user prescribes none, relative to the diameter

  // Distances, relative to L.
  double first_cancellation = 1;     ///< opposite nodes nearer than this cancel before the other rules
  double second_cancellation = 0.5;  ///< the same after nodes were moved
  double spacing = 0.5;              ///< least final distance between nodes: nearer ones are merged or pushed apart

  // Fillets that act as corners: on the scale of the distance between two nodes.
  double corner_radius = 0.05;  ///< relative to the distance: a fillet with a smaller radius is a corner there
  /// A node inside, at 0.31 to 0.41 radii from the boundary, with less clearance than this, relative to the distance,
  /// stays: a block without it would turn round a radius of less than a quarter of its width.
  double corner_clearance = 0.08;

  // Nodes on the boundary.
  double least_block_angle = 15;     ///< degrees, of a block at a corner into which a node moves (lib/method.md §5)
  int greatest_corner_valence = 4;   ///< greatest valence of such a corner
  double crowded_on_bend = 0.5;      ///< relative to the bend's least radius: nearer feet are spread evenly
  double crowded_on_hole = 0.5;      ///< relative to the even distance: nearer feet on a hole are spread evenly
  double greatest_merge_detour = 2;  ///< merging nodes: length of the boundary between them relative to their distance

  // Nodes that move inward (features/move_nodes).
  int path_steps = 64;        ///< a path is searched in steps of L / path_steps
  double farthest_rival = 4;  ///< relative to L: nodes farther away do not limit a path

  // Pushing apart (features/separate_nodes).
  int max_push_rounds = 400;
  double push_margin = 1e-3;      ///< relative: excess of the target distance of a push over the spacing
  double push_step = 0.5;         ///< fraction of a push that is carried out in one round
  double push_to_boundary = 0.5;  ///< greatest move in one round, relative to the distance to the boundary
};

inline constexpr FeatureConstants feature_constants{};

struct FeatureNode {
  Vec2 position;
  int valence = 4;
  NodeLocation location = NodeLocation::inside;  ///< inside or on the boundary, never a corner
  int curve = 0;                                 ///< on the boundary: its curve
  double t = 0;                                  ///< and parameter
  int origin = 0;           ///< entry of the input's critical_points or, if it was on the boundary, boundary_nodes
  std::optional<int> hole;  ///< small hole onto whose boundary it was moved
  std::optional<ChangeKind> changed_by;  ///< the last change

  bool is_inside() const { return location == NodeLocation::inside; }
  bool is_changed() const { return changed_by.has_value(); }
  int index() const { return (is_inside() ? 4 : 2) - valence; }
};

struct FeatureState {
  double size = 0;  ///< L, in the file's unit
  double tie = 0;   ///< lengths that differ by no more are equal
  std::vector<FeatureNode> nodes;
  std::vector<Corner> corners;
  std::vector<NodeChange> changes;
};

/// Removes the nodes with these indices into state.nodes, in any order; the others keep their order.
void remove_nodes(FeatureState& state, const std::vector<int>& removed);

/// The record of a node in a NodeChange.
NodeMark mark(const FeatureNode& node);

/// Adds a change of the kind `feature` or `cancel`.
void record(FeatureState& state, ChangeKind kind, const std::vector<FeatureNode>& before,
            const std::vector<FeatureNode>& after, const std::string& reason);

}  // namespace quadrille::features
