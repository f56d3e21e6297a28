#pragma once
// Numbers of elements by the name of a boundary: --count outlet=24.
//
// The elements along a boundary are the sum over its arcs of the counts of their chords. The counts n of its chords
// that are not prescribed minimise
//
//   sum m (ln n - ln t)^2   with   sum m n = N - (elements of chords with prescribed counts),
//
// m the number of the boundary's arcs in a chord, t its count by the prescribed sizes, times one factor for all.

#include <string>
#include <vector>

#include "base/report.hpp"
#include "sizing/arc_division.hpp"
#include "sizing/grade_chords.hpp"
#include "sizing/measured_layout.hpp"
#include "sizing/size_field.hpp"

namespace quadrille::prescribe {

/// `count` elements along all curves of a boundary together.
struct BoundaryCount {
  std::string boundary;
  int count = 1;
};

/// Adds the count that "NAME=N" (the last = counts) prescribes: if NAME is a number, that of this chord, else that of
/// the boundary. Throws UsageError.
void parse_count(const std::string& text, std::vector<sizing::ChordCount>& chords,
                 std::vector<BoundaryCount>& boundaries);

/// `counts`, and those of all chords along the boundaries. Boundaries with the fewest chords that are still free come
/// first; equal ones as given. Throws UsageError if a boundary cannot have its number, with those nearest to it that it
/// can have.
std::vector<sizing::ChordCount> with_boundary_counts(const sizing::MeasuredLayout& measured,
                                                     const sizing::SizeField& sizes,
                                                     std::vector<sizing::ChordCount> counts,
                                                     const std::vector<BoundaryCount>& boundaries);

/// Sets counts.<n>.boundary, .prescribed and .achieved.
void report_boundary_counts(const sizing::MeasuredLayout& measured, const sizing::ArcDivisions& divisions,
                            const std::vector<BoundaryCount>& boundaries, Report& report);

}  // namespace quadrille::prescribe
