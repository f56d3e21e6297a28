#pragma once
// Shorter elements where blocks are thin.
//
// Elements as long as the prescribed size in a block that is far thinner have sides of very different lengths. Where
// the ratio of an element's sides exceeds
//
//   max( R, 3 h / e ),   R the target, h the prescribed size, e the shortest boundary between two corners,
//
// its chord gets shorter elements there, down to a hundredth of the prescribed size. Away from there lengths grow back
// by the growth of the size field, or by the default growth where the size is uniform. Chords that layers divide are
// thin on purpose: they are left out, and so are chords with a prescribed count. Where vertices are placed, R alone is
// the limit (refine/best_split).

#include <vector>

#include "model/quad_mesh.hpp"
#include "sizing/grade_chords.hpp"

namespace quadrille::refine {

/// The least length of the boundary between two consecutive corners of the layout, or joints of different names
/// (name_joints); infinity if there are none. Elements there have a side as short as that at any size.
double shortest_kept_edge(const sizing::MeasuredLayout& measured);

/// By chord.
using LengthLimits = std::vector<std::vector<sizing::MaxLengthConstraint>>;

/// Adds limits for the elongated elements of a mesh made of these plans and divisions; its element sizes must be
/// measured (mesh/element_sizes). `target`: R, at least 1. `shortest`: e, shortest_kept_edge; infinity: R alone is the
/// limit. `is_left_out`: by element; empty: none is. Returns false if there is nothing to add.
bool add_length_limits(const sizing::MeasuredLayout& measured, const std::vector<sizing::ChordPlan>& plans,
                       const sizing::ArcDivisions& divisions, const QuadMesh& mesh, const sizing::SizeField& sizes,
                       double target, double shortest, const std::vector<bool>& is_left_out, LengthLimits& limits);

/// The plans of sizing/grade_chords with these limits. `limits`: one entry per chord, or none at all.
void apply_length_limits(const LengthLimits& limits, std::vector<sizing::ChordPlan>& plans);

}  // namespace quadrille::refine
