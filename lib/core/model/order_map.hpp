#pragma once
// A prescribed polynomial order for every element (formats/order-map.md).

#include <vector>

namespace quadrille {

struct OrderMap {
  std::vector<int> elem_order;     ///< one for each element, in the order of the mesh
  bool of_harmonic_field = false;  ///< those of a field of kind "harmonic"
};

}  // namespace quadrille
