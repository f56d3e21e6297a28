#pragma once
// Reports achieved and prescribed edge lengths, and whether the mesh is good.

#include <string>
#include <vector>

#include "base/report.hpp"
#include "model/quad_mesh.hpp"
#include "sizing/grade_chords.hpp"
#include "sizing/make_size_field.hpp"

namespace quadrille::sizing {

/// Sets sizes.* (the chords as columns, sizes.chord.*) and issues a warning for prescribed counts that had to be
/// raised.
void report_sizes(const MeasuredLayout& measured, const ArcDivisions& divisions, const SizeField& sizes,
                  const std::vector<ChordCount>& prescribed, Report& report);

/// Sets resolution.* (mesh/element_sizes; each chord's part of E). xi1 and xi2 of elements run along the sides 0 and 1
/// of their blocks.
void report_resolution(const MeasuredLayout& measured, const QuadMesh& mesh, Report& report);

/// Sets verdict.* and returns the verdict in words, with the chord that has most of the error, and the advice
/// (mesh/verdict, sizing/advice, whose arguments `prescribed` and `applied` are). A mesh that is not good by the sizes
/// of its elements issues a warning.
std::string report_verdict(const MeasuredLayout& measured, const QuadMesh& mesh, const SizeOptions& prescribed,
                           const SizeOptions& applied, Report& report);

}  // namespace quadrille::sizing
