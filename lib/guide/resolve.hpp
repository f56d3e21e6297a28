#pragma once
// From the field's own zeros to the irregular nodes of the layout (lib/method.md §3, §5). Each step takes what the one
// before left, changes it and says so in `changes`; the index sum stays. All lengths are in the file's unit.
//
//   find_critical_points   zeros, clusters, corners by angle or field, corners that absorb       (the field's own view)
//   line_field_points      instead of it where the data lie on one line
//   resolve_clusters       clusters become nodes
//   override_corners       valences asked for
//   divide_degenerate_corners
//   resolve_features       --feature-size
//   place_nodes            --place
//
// A step that leaves a node which is no zero of the field sets form = "phase".

#include <functional>
#include <string>
#include <vector>

#include "model/cad_face.hpp"
#include "model/critical_points.hpp"

namespace quadrille::guide {

/// Curves a and b that meet in a corner, in either sequence, and the valence asked for. Where they meet in two corners
/// (a half disc), the one where a ends and b begins, the face on the left.
struct CornerOverride {
  int curve_a = 0, curve_b = 0;
  int valence = 2;
};

/// --corner-valence "3:4=2"; throws UsageError.
CornerOverride parse_corner_override(const std::string& text);

/// Whether the valence is 0 to 4 and blocks of angle / valence are between 15 and 165 degrees (lib/method.md §5).
/// Valence 0 is admissible: it is degenerate.
bool is_admissible_valence(double angle_degrees, int valence);

/// Puts nodes for every cluster with index != 0: one of valence 4 - index where that is 3 to max_valence; else |index|
/// nodes of valence 3 or 5 about the centre, as symmetric as the face is about it (guide/node_ring has the rules). A
/// cluster of index 0 cancels. Zeros in critical_points that are members of clusters are taken out. Centres within 1e-6
/// diameters of a fixed point of the face's symmetries are put onto it, and clusters that lie in one symmetry orbit
/// are resolved alike. Nodes get the source "cluster", clusters of index 0 a change of the kind "cancel". No elements
/// are set. With any cluster, form becomes "phase".
void resolve_clusters(const CadFace& face, int max_valence, CriticalPoints& points);

/// For a face whose boundary data lie on one line (field/boundary_values, is_line_field): corner valences by rule
/// (guide/line_corners), and where no symmetric choice fits, all ties large and nodes (guide/node_ring) about the
/// rotation centre, or the most interior point that the symmetries of the face leave where it is. No elements are set.
CriticalPoints line_field_points(const CadFace& face, int max_valence);

/// Sets the valences asked for. Where all changes together add up to 0 (valences exchanged between corners), nothing
/// inside changes. Else a change from V to V' needs V' - V more index inside: nodes of the opposite index, 1 or -1, go
/// first, if they are nearer than a quarter of the diameter and nearer to this corner than to any other that needs
/// them; of nodes equally near all or none, and one that is equally near to two corners stays. For what is left, nodes
/// of valence 3 or 5 are added at equal angles in the corner's sector (one: on the bisector), at a quarter of the room
/// there. Nodes get the source "corner", each corner a change of that kind. No elements are set.
/// Throws UsageError where the curves meet in no corner, the valence is not admissible or one corner gets two.
void override_corners(const CadFace& face, const std::vector<CornerOverride>& overrides, CriticalPoints& points);

/// Midpoint division (paper; lib/method.md §3): corners of valence 0 and at least 15 degrees get valence 1 and a node
/// of valence 3 on their bisector, at a quarter of the room there or half the shorter side. Two of its lines meet the
/// corner's sides at right angles, the third runs away from the corner. Sharper corners stay degenerate. Nodes and
/// corners get the source "divide", each corner a change of that kind.
void divide_degenerate_corners(const CadFace& face, CriticalPoints& points);

}  // namespace quadrille::guide
