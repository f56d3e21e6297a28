#pragma once
// Layers along walls: how many, on which chords, and where they are cut.
//
// The chords across the blocks along a wall get the layers at that end; each column of nodes is cut by its distance
// from the wall, so that layers have the same height everywhere, however wide the block is. Beyond, and on the chords
// that go on from them, intervals grow by at most the wall's growth until the wanted size. The first row of blocks
// holds all layers: at its far side lie irregular nodes, around which cuts cannot follow the wall.

#include <string>
#include <vector>

#include "base/report.hpp"
#include "layers/layer_columns.hpp"
#include "layers/wall_sides.hpp"
#include "layers/wall_spec.hpp"
#include "sizing/arc_division.hpp"
#include "sizing/measured_layout.hpp"
#include "sizing/size_field.hpp"

namespace quadrille::layers {

struct WallPlan {
  WallSides walls;
  std::vector<std::vector<double>> heights;    ///< by spec: upper ends of its layers
  std::vector<std::vector<double>> arc_nodes;  ///< by arc: fractions of all its nodes; empty: as its intervals say
  std::vector<int> chords;                     ///< on which intervals are graded, ascending
  std::vector<std::array<int, 2>> shared;      ///< pairs of specs that ask for one chord, ascending

  std::vector<bool> is_graded;  ///< by arc: its chord is among them

  bool has_wall(int block) const;
};

struct WallInput {
  const sizing::MeasuredLayout& measured;
  const std::vector<WallSpec>& specs;
  const sizing::SizeField& sizes;
  int order = 4;
  double tolerance = 0;  ///< as in DivideOptions
};

/// Replaces the intervals of the chords concerned in `divisions` (refine/divide_arcs). Throws UsageError for unknown
/// names, ComputeError where layers do not fit, with the largest numbers that do and the place.
WallPlan plan_walls(const WallInput& input, sizing::ArcDivisions& divisions);

/// What layered_positions needs to know of a block; `fractions` of the nodes on its sides by rising s
/// or t.
LayeredBlock layered_block(const WallPlan& plan, const sizing::MeasuredLayout& measured, int block,
                           std::array<std::vector<double>, 4> fractions);

/// Keys walls.<number>.names, .layers, .first, .thickness; warnings where walls share.
void tell_walls(const WallPlan& plan, const std::vector<WallSpec>& specs, Report& report);

}  // namespace quadrille::layers
