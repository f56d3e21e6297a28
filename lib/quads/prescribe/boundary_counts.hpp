#pragma once
// Numbers of elements by the name of a boundary: --count outlet=24, and --count slide=90,even of equal lengths.
//
// The elements along a boundary are the sum over its arcs of the counts of their chords. The counts n of its chords
// that are not prescribed minimise
//
//   sum m (ln n - ln t)^2   with   sum m n = N - (elements of chords with prescribed counts),
//
// m the number of the boundary's arcs in a chord, t its count by the prescribed sizes, times one factor for all. Where
// chords have wall layers, n and t are their intervals between the layers, at least one, and N is less by the layers.
// For elements of equal lengths t is the mean length of the chord's arcs along the boundary. Of an interface whose two
// sides have nodes of their own, each side has N.

#include <string>
#include <vector>

#include "base/report.hpp"
#include "prescribe/end_grading.hpp"

namespace quadrille::prescribe {

/// `count` elements along all curves of a boundary together.
struct BoundaryCount {
  std::string boundary;
  int count = 1;
  bool is_even = false;  ///< vertices at equal lengths along each of its curves (refine/even_vertices)
};

/// A chord with the layers along walls, before boundaries prescribe counts.
struct LayeredCount {
  int count = 1;   ///< layers included
  int layers = 0;  ///< at both ends of its arc that has the most of them
};

/// Adds the count that "NAME=N" or "NAME=N,even" (the last = counts) prescribes: if NAME is a number, that of this
/// chord, else that of the boundary. Throws UsageError.
void parse_count(const std::string& text, std::vector<sizing::ChordCount>& chords,
                 std::vector<BoundaryCount>& boundaries);

/// By curve, whether its elements are to be of equal lengths; empty if none are. Throws UsageError for a name that no
/// curve has.
std::vector<bool> even_curves(const CadFace& face, const std::vector<BoundaryCount>& boundaries);

/// `counts`, and those of all chords along the boundaries. Boundaries with the fewest chords that are still free come
/// first; equal ones as given. Throws UsageError if a boundary cannot have its number, with those nearest to it that it
/// can have. `layered`: by chord, with `counts`; empty: there are no walls. A boundary whose number its layers exceed
/// has the least number that leaves one interval between or above them. `gradings` with their greatest `growth`
/// (prescribe/end_grading): without walls, chords along these boundaries have more.
std::vector<sizing::ChordCount> with_boundary_counts(const sizing::MeasuredLayout& measured,
                                                     const sizing::SizeField& sizes,
                                                     std::vector<sizing::ChordCount> counts,
                                                     const std::vector<BoundaryCount>& boundaries,
                                                     const std::vector<LayeredCount>& layered = {},
                                                     const std::vector<EndGrading>& gradings = {}, double growth = 1.2);

/// Sets counts.<n>.boundary, .prescribed and .achieved; warning W-QUA-002 where they differ.
void report_boundary_counts(const sizing::MeasuredLayout& measured, const sizing::ArcDivisions& divisions,
                            const std::vector<BoundaryCount>& boundaries, const std::vector<LayeredCount>& layered,
                            Report& report);

}  // namespace quadrille::prescribe
