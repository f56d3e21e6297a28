#pragma once
// Where the layers of a sweep end, as fractions of it.

#include <optional>
#include <vector>

#include "layers/wall_spec.hpp"

namespace quadrille::sweep {

struct LayerPlan {
  int layers = 0;     ///< between those of `bottom` and `top`; 0: as many as make none higher than `usual`
  double growth = 1;  ///< height of a layer over that of the one below, without `bottom` and `top`
  std::optional<layers::WallSpec> bottom, top;
};

/// From 0 to 1. `length` of the sweep and `usual`, the height of a layer, in one unit. Between the layers of bottom and
/// top the heights change by one ratio from layer to layer, as nearly as their number allows (prescribe/log_spacing);
/// if that is free, by at most the growth of bottom and top. Throws UsageError if these leave no room for another
/// layer.
std::vector<double> layer_ends(const LayerPlan& plan, double length, double usual);

}  // namespace quadrille::sweep
