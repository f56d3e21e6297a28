#pragma once
// Other counts of chords, with a lower error of a smooth solution at about the same number of elements.
//
// E of mesh/element_sizes is a sum over chords, with parts s_c of all 1. With counts n' in place of n, and vertices
// that are relaxed to the sizes again (refine/relax_sizes), it is estimated as
//
//   E'/E = (sum over chords of s_c (n_c / n'_c)^2)^q.
//
// If vertices stayed, the powers were 2q and 1; if chords could take over each other's lengths as they please, nearly 0
// and without bound. The estimate is no more than an order in which steps are tried (refine/lower_error). Chords that
// are equal in all this, as mirror images are, have one count.

#include <array>
#include <functional>
#include <vector>

#include "mesh/element_sizes.hpp"
#include "sizing/measured_layout.hpp"

namespace quadrille::sizing {

struct ErrorParts {
  std::vector<double> parts;                     ///< by chord: of E, of all 1
  std::vector<int> counts;                       ///< by chord: those with these parts
  std::vector<bool> is_fixed;                    ///< by chord: its count is prescribed
  std::vector<std::array<int, 2>> block_chords;  ///< of the blocks whose elements have a part
  double num_elems = 0;                          ///< N, that should be met
};

/// Of a mesh with these counts, with its number of elements; no chord is fixed. `parts`: of E, by element (mesh/
/// element_sizes), in any unit.
ErrorParts error_parts(const MeasuredLayout& measured, std::vector<int> counts, const QuadMesh& mesh,
                       const std::vector<std::array<double, 2>>& parts);

/// The elements that blocks with a part have with these counts.
double num_elements(const ErrorParts& of, const std::vector<int>& counts);

/// The count of a chord for which `count` is asked: the boundary may require more.
using AchievedCount = std::function<int(int chord, int count)>;

/// A chord, and all that are equal to it, with more or fewer elements.
struct CountStep {
  int chord = 0;
  int direction = 1;        ///< 1: more, -1: fewer
  double cost = 0;          ///< estimated change of ln (E N^q), and a penalty for other N
  std::vector<int> counts;  ///< by chord, as achieved
};

/// For each chord that is not fixed (one of equal ones) a step to more elements and one to fewer, by `part` of its
/// count, by at least one; the estimated best first. A step that would miss N by more than a tenth is taken together
/// with the opposite one of another chord that is best with it; those that miss it all the same are left out, and those
/// with an estimated cost above 0.5.
std::vector<CountStep> count_steps(const ErrorParts& of, const AchievedCount& achieved, double part);

}  // namespace quadrille::sizing
