#pragma once
// The resolution ratio (mesh/element_sizes) that a mesh would have at other prescribed lengths, from the lengths of its
// elements alone: no mesh is made.
//
// A row is what a quad passes on across its sides: all elements of a row have the same number of parts along it. With
// the prescribed lengths h' in place of h, the element lengths x and y in units of h' and the weights w, the widths of
// elements across the row, a row is split into
//
//   k = max(1, (sum of w x^2q / sum of w)^(1 / 2q))
//
// parts, k real, and E' = sum over elements of A' ((x / k)^2q + (y / l)^2q), A' their areas in units of h'^2, in k l
// parts each. Rows are never merged: at lengths above h the present number is kept.

#include <array>
#include <vector>

#include "mesh/element_sizes.hpp"

namespace quadrille::mesh {

/// By element: the numbers of its rows along xi1 and along xi2, those of sides 0 and 1. O(n log n).
std::vector<std::array<int, 2>> element_rows(const QuadMesh& mesh);

struct ExpectedMesh {
  double resolution = 1;  ///< its resolution ratio
  double num_elems = 0;   ///< a real number; elements that do not count in the ratio are not in it
};

/// `rows`, `powers`: those of the mesh. `factors`: by element h over h', at least 1 where elements shall be shorter.
ExpectedMesh expected_mesh(const std::vector<std::array<int, 2>>& rows, const std::vector<ElementPowers>& powers,
                           const std::vector<double>& factors);

}  // namespace quadrille::mesh
