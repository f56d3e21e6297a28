#pragma once
// Every number that the rules about small features use (features/resolve_features). L is the feature size.

namespace quadrille::features {

struct FeatureConstants {
  // What is equal. Ties are decided together, so that rounding decides nothing and a symmetric face gets symmetric
  // nodes.
  double equal_lengths = 1e-6;  ///< of the diameter: lengths that differ by no more are equal
  double equal_sizes = 1e-6;    ///< relative: radii and diameters of features within this of L are not below it

  // What is a feature (features/curved_runs, features/small_features).
  double straight_curvature = 1e-3;  ///< curvature times diameter below which the boundary counts as straight
  int samples_per_span = 24;         ///< of curvature, on each knot span
  double index_rounding = 0.6;       ///< a run that turns by tau carries the index floor(2 tau / pi + 0.6)

  // Distances, in L.
  double first_cancellation = 1;     ///< opposite nodes nearer than this cancel before features are looked at
  double second_cancellation = 0.5;  ///< and after nodes were moved
  double spacing = 0.5;  ///< least distance between nodes in the end: nearer ones are merged or pushed apart

  // Nodes on the boundary.
  double least_block_angle = 15;     ///< degrees, of a block at a corner that takes a node (lib/method.md §5)
  int greatest_corner_valence = 4;   ///< of such a corner
  double crowded_on_bend = 0.5;      ///< of the bend's least radius: feet nearer than this are spread evenly
  double crowded_on_hole = 0.5;      ///< of the even distance: feet on a hole nearer than this are spread evenly
  double greatest_merge_detour = 2;  ///< merging nodes: length of the boundary between them by their distance

  // Nodes that move inward (features/move_inward).
  int path_steps = 64;        ///< a path is searched in steps of L / path_steps
  double farthest_rival = 4;  ///< in L: nodes farther away do not limit a path

  // Pushing apart (features/separate_nodes).
  int max_push_rounds = 400;
  double push_margin = 1e-3;      ///< relative: how far beyond the spacing a push aims
  double push_step = 0.5;         ///< part of a push that is carried out in one round
  double push_to_boundary = 0.5;  ///< greatest part of the distance to the boundary that one round may use
  double spacing_tol = 1e-9;      ///< relative: distances that lack no more than this are not reported
};

inline constexpr FeatureConstants feature_constants{};

}  // namespace quadrille::features
