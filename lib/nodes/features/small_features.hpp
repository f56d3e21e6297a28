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

#include <optional>
#include <string>
#include <vector>

#include "features/feature_state.hpp"
#include "features/loop_section.hpp"
#include "model/cad_face.hpp"

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

/// A node of a feature and its foot on the feature's section.
struct OwnedNode {
  int node = 0;
  SectionFoot foot;
};

/// Rule "own": for each feature its nodes, nearest first. An inner node of index 1 (convex bends) or -1 (reflex bends
/// and holes) belongs to the nearest feature of its sign that is nearer than L. It belongs to none
///   - if two features are equally near, unless their nearest points coincide (a hole and a bend of it: then to the
///     bend, which is listed first),
///   - if a run of any size of that sign that is not part of the feature is nearer (curved_runs): that run forced the
///     node.
/// A feature has no more nodes than its index capacity: the nearest, nodes equally near together or not at all.
std::vector<std::vector<OwnedNode>> nodes_of_features(const CadFace& face, const FeatureState& state,
                                                      const std::vector<SmallFeature>& features);

/// The feature size if the user prescribes none: a five-hundredth of the diameter: blocks of that size at the usual
/// element sizes (a twentieth) have elements of edge ratios near 100. In a far field (model/name_rules) the diameter
/// is that of the box around the bodies, unless curves at a distance from walls are embedded. At most half the mean
/// width of the face, which is its area divided by half its perimeter. It depends on the face alone, never on element
/// sizes, so that refinement keeps the blocks.
double automatic_feature_size(const CadFace& face);

/// "auto", which gives std::nullopt, or a length, 0 for none. Throws UsageError.
std::optional<double> parse_feature_size(const std::string& text);

}  // namespace quadrille::features
