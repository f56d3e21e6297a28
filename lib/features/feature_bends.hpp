#pragma once
// Small features of a face: fillets, noses and holes below a length L.
//
// A bend is a longest stretch of boundary, over smooth joints, that is curved to one side everywhere with a radius
// below L. It is convex where the boundary turns to the left, towards the domain, and reflex where it turns away. What
// it carries is read off the RUN that it is part of: the longest stretch around it that is curved to the same side at
// all, so that a blunt nose counts with its flanks. A run that turns by tau would, as a corner of interior angle
// pi -+ tau, have the valence 2 -+ 2 tau / pi: it carries |index| = 2 tau / pi rounded, up from 0.4 on, because near
// 45 degrees either may be (lib/method.md §5: a small fillet carries the index 2 - V of its corner).
//
// A hole is small where the largest distance between two of its points is below L. It carries, with its bends, -4 less
// the index of its corners. A loop that is one bend all round is a hole or the outline, never a fillet.
// Radii and sizes within 1e-6 of L are not below it.

#include <vector>

#include "features/feature_stretch.hpp"

namespace quadrille::features {

enum class FeatureKind { convex, reflex, hole };

struct SmallFeature {
  FeatureKind kind = FeatureKind::reflex;
  Stretch stretch;
  Stretch run;        ///< of a bend; of a hole the hole
  double extent = 0;  ///< least radius of a bend, diameter of a hole
  int capacity = 0;   ///< |index| that it carries
};

/// Bends before holes, in the sequence of the loops. size > 0, in the file's unit.
std::vector<SmallFeature> small_features(const CadFace& face, double size);

/// Whole runs that carry an index, of any size: what else may have forced a node. A loop that is one run is a hole.
std::vector<SmallFeature> runs_of_any_size(const CadFace& face);

}  // namespace quadrille::features
