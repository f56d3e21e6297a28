#pragma once
// The greatest number of elements, so that a mistyped size is refused before it exhausts the memory.

#include <vector>

#include "base/error.hpp"
#include "base/report.hpp"
#include "model/block_layout.hpp"
#include "sizing/grade_chords.hpp"

namespace quadrille::sizing {

struct ElementLimit {
  int max_elements = 1000000;
  int order = 4;  ///< shape order; meshes with more than 1e8 nodes are refused too
};

/// The message states the number of elements and by how much --size must rise.
struct TooManyElements : ComputeError {
  using ComputeError::ComputeError;
};

/// The number of elements of a mesh with the planned counts.
double num_planned(const MeasuredLayout& measured, const std::vector<ChordPlan>& plans);

/// The exact number, for the divisions of all arcs.
double num_divided(const BlockLayout& layout, const ArcDivisions& divisions);

/// For a face of that area, before there are blocks: only the order of magnitude, so that no more than four times the
/// limit is refused. `size` is the greatest prescribed edge length; nothing else may determine the counts.
void require_area_within(double area, double size, const ElementLimit& limit);
/// For the planned counts, which the tolerance of the boundary may raise: an estimate, before anything is divided.
/// It is written to the report, as estimated_quads, also when it is refused.
void require_planned_within(const MeasuredLayout& measured, const std::vector<ChordPlan>& plans,
                            const ElementLimit& limit, Report& report);
/// For a mesh of `num_elems` of which each becomes 4^levels (mesh/nested_quads).
void require_nested_within(int num_elems, int levels, const ElementLimit& limit);
/// For the divisions of all arcs. All throw TooManyElements.
void require_divided_within(const BlockLayout& layout, const ArcDivisions& divisions, const ElementLimit& limit);

}  // namespace quadrille::sizing
