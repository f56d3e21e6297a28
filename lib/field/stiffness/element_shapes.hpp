#pragma once
// Elements of the same shape. The stiffness matrices of the Laplace operator in the plane do not change with the place,
// the direction and the size of an element: similar elements share them. The rings of a fan are similar to each other,
// and so are the fans of equal corners, with which most of a mesh is made.

#include <vector>

#include "spectral/tri_map.hpp"

namespace quadrille::stiffness {

/// For each element, the first one of the same shape: a similarity transform maps it onto the other, vertex by vertex,
/// within about 1e-12 of the element's size. Mirror images count as different.
std::vector<int> first_of_shape(const std::vector<spectral::TriMap>& maps);

}  // namespace quadrille::stiffness
