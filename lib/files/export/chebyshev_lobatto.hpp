#pragma once
// The nodes of HOHQMesh's formats: t_j = -cos(j pi / N), j = 0 .. N, ascending in [-1, 1].

#include <vector>

namespace quadrille::exports {

/// The order + 1 Chebyshev-Gauss-Lobatto points, exactly antisymmetric about 0.
std::vector<double> chebyshev_lobatto_points(int order);

}  // namespace quadrille::exports
