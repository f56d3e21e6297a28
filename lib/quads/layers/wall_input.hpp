#pragma once
// The input of the planning of wall layers.

#include <vector>

#include "layers/wall_spec.hpp"
#include "sizing/arc_division.hpp"
#include "sizing/grade_chords.hpp"
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
  std::vector<sizing::ChordCount> counts = {};  ///< prescribed, layers included; of several for one chord the last

  /// 0: none.
  int prescribed_count(int chord) const {
    int count = 0;
    for (const sizing::ChordCount& one : counts)
      if (one.chord == chord) count = one.count;
    return count;
  }
  const BlockLayout& blocks() const { return measured.blocks(); }
};

}  // namespace quadrille::layers
