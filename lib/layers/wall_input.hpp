#pragma once
// The input of the planning of wall layers.

#include <vector>

#include "layers/wall_spec.hpp"
#include "sizing/arc_division.hpp"
#include "sizing/measured_layout.hpp"
#include "sizing/size_field.hpp"

namespace quadrille::layers {

struct WallInput {
  const sizing::MeasuredLayout& measured;
  const std::vector<WallSpec>& specs;
  const sizing::SizeField& sizes;
  int order = 4;
  double tolerance = 0;    ///< as in refine/DivideOptions
  bool may_crowd = false;  ///< intervals above the layers will be made to suit them (growth/limit_growth)

  const BlockLayout& blocks() const { return measured.blocks(); }
};

}  // namespace quadrille::layers
