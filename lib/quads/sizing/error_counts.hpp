#pragma once
// The counts of chords with the least error of a smooth solution at a given number of elements.
//
// E of mesh/element_sizes is a sum over chords, with parts s_c of all 1. With counts n' in place of n, and vertices
// that are relaxed to the sizes again (refine/relax_sizes), it is estimated as
//
//   E'/E = (sum over chords of s_c (n_c / n'_c)^e)^(2q / e),   0 < e <= 2q,
//
// whose derivative is exact. If vertices stayed, e were 2q; if chords could take over each other's lengths as they
// please, near 0. The counts sought minimise this estimate
//
//   at   sum over blocks of n'_a n'_b = N,   a and b the chords of a block.
//
// For small e the elements that a chord passes are then its part of all. Whole counts are found from real ones by steps
// of one and two. Chords that are equal in all this, as mirror images are, have one count.

#include <array>
#include <functional>
#include <vector>

#include "mesh/element_sizes.hpp"
#include "sizing/measured_layout.hpp"

namespace quadrille::sizing {

struct ErrorParts {
  std::vector<double> parts;                     ///< by chord: of E, of all 1 (mesh/element_sizes)
  std::vector<int> counts;                       ///< by chord: of the mesh with these parts
  std::vector<bool> is_fixed;                    ///< by chord: its count is prescribed
  std::vector<std::array<int, 2>> block_chords;  ///< of the blocks whose elements have a part
  double num_elems = 0;                          ///< N
  double exponent = 2;                           ///< e
  double greatest_factor = 1.5;                  ///< by which a count changes if that is more than one element
};

/// Of a mesh of these divisions, with its number of elements; no chord is fixed.
ErrorParts error_parts(const MeasuredLayout& measured, const ArcDivisions& divisions, const QuadMesh& mesh,
                       const mesh::Resolution& resolution);

/// The count of a chord for which `count` is asked: the boundary may require more.
using AchievedCount = std::function<int(int chord, int count)>;

struct ErrorCounts {
  std::vector<int> counts;  ///< by chord, as achieved
  double ratio = 1;         ///< of E N^q to that of the mesh
};

/// N is met to 5 % if whole counts allow it.
ErrorCounts least_error_counts(const ErrorParts& of, const AchievedCount& achieved);

}  // namespace quadrille::sizing
