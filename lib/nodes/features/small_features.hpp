#pragma once
// Small features of a face: fillets, noses and holes below the feature size L.
//
// A bend is a longest section of boundary, over smooth joints, that is curved to one side everywhere with a radius
// below L. It is convex if the boundary turns to the left, towards the domain, and reflex if it turns away. Its index
// capacity is determined by the RUN of which it is part: the longest section around it that is curved to the same side
// at all, so that a blunt nose includes its flanks. A run that turns by tau would, as a corner of interior angle
// pi -+ tau, have the valence 2 -+ 2 tau / pi: it forces nodes of |index| = 2 tau / pi in total, rounded, up from 0.4
// on, because near 45 degrees either may be (lib/method.md §5: a small fillet has the index 2 - V of its corner).
//
// A hole is small if the largest distance between two of its points is below L. It forces, with its bends, the index
// -4 less the index of its corners. A loop that is one bend all round is a hole or the outline, never a fillet.
// Radii and sizes within 1e-6 of L are not below it (base/tolerance).

#include <vector>

#include "features/loop_section.hpp"

namespace quadrille::features {

enum class FeatureKind { convex, reflex, hole };

struct SmallFeature {
  FeatureKind kind = FeatureKind::reflex;
  LoopSection section;     ///< the bend or the hole
  LoopSection run;         ///< of a bend; for a hole, the hole itself
  double extent = 0;       ///< least radius of a bend, diameter of a hole
  int index_capacity = 0;  ///< |index| of the nodes that it forces
};

/// Bends before holes, in the order of the loops. size > 0, in the file's unit.
std::vector<SmallFeature> small_features(const CadFace& face, double size);

/// Whole runs with an index capacity, of any size, which may also have forced a node. A loop that is one run is a hole.
std::vector<SmallFeature> runs_of_any_size(const CadFace& face);

/// |index| of the nodes forced by a run that turns by `turning` radians.
int index_capacity_of(double turning);

}  // namespace quadrille::features
