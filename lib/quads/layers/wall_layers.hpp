#pragma once
// Layers along walls: their number, their chords and their positions. layer_rules has the objective, the rules and the
// constants.
//
// The chords across the blocks along a wall get the layers at that end (request_layers). Every wall-normal line is
// divided by its distance from the wall, so that a layer has one height everywhere, however wide its block is
// (layered_block). Above the layers, and on the chords that continue them (propagate_spacing), intervals grow by at
// most the wall's growth until the prescribed size.

#include <array>
#include <vector>

#include "base/report.hpp"
#include "layers/end_spacing.hpp"
#include "layers/layered_block.hpp"
#include "prescribe/boundary_counts.hpp"

namespace quadrille::layers {

struct WallPlan {
  WallSides walls;
  std::vector<std::vector<double>> heights;    ///< by spec: upper ends of its layers
  std::vector<int> num_fixed;                  ///< by spec: layers that have their heights; all, or the first alone
  std::vector<int> num_fixed_inside;           ///< by wall side: the same inside its block, at most; empty: no limit
  std::vector<double> least_thickness;         ///< by spec: less than the thickness where layers are compressed
  LayerRequests requests;                      ///< of the arcs that start at walls
  std::vector<std::vector<double>> arc_nodes;  ///< by arc: fractions of all its nodes; empty: they follow from its ends
  std::vector<int> chords;                     ///< those divided for layers, ascending
  std::vector<bool> is_graded;                 ///< by arc: its chord is among them
  std::vector<std::array<int, 2>> sharing_a_chord;  ///< ascending pairs of specs with layers on one chord

  bool has_wall(int block) const;
  /// Layers of fixed height along a side of a block; 0 without a wall.
  int num_fixed_on(int block, int side) const;
  /// At the beginning and the end of the columns (direction 0) or rows (1) of a block.
  std::array<int, 2> num_fixed_along(int block, int direction) const {
    return {num_fixed_on(block, direction == 0 ? 0 : 3), num_fixed_on(block, direction == 0 ? 2 : 1)};
  }
  /// Fractions of all nodes of an arc.
  std::vector<double> nodes_on(int arc, const sizing::ArcDivision& division, int order) const {
    return arc_nodes[arc].empty() ? interval_nodes(division.ends, order) : arc_nodes[arc];
  }
};

/// The counts that the chords have with the layers of `input` and with no prescribed counts but those of `input`, from
/// plans without layers. Throws as plan_walls.
std::vector<prescribe::LayeredCount> layered_counts(const WallInput& input,
                                                    const std::vector<sizing::ChordPlan>& plans);

/// Replaces the divisions of the chords concerned in `divisions` (refine/divide_arcs). Throws UsageError for unknown
/// names, and ComputeError if layers do not fit, with the greatest number that fits and the position.
WallPlan plan_walls(const WallInput& input, sizing::ArcDivisions& divisions);

/// Gives up the heights of all layers but the first along walls whose layers are compressed somewhere: their intervals
/// are then free in the gap that facing walls share and around it, so that blocks beside the gap, which have as many
/// intervals as the gap, need not be as narrow.
void release_compressed_layers(const WallInput& input, WallPlan& plan);

/// Gives up the heights, inside blocks, of layers above LayerConstants::greatest_bend_height: lines towards the centre
/// of the wall's curvature would meet.
void release_bent_layers(const WallInput& input, WallPlan& plan);

/// Measures the thickness of released layers on the arcs that start at their walls.
void measure_released_layers(const WallInput& input, const sizing::ArcDivisions& divisions, WallPlan& plan);

/// Throws UsageError if a wall shall have blocks of its own and the face has no offset curve of it.
void require_offsets(const std::vector<WallSpec>& specs, const CadFace& face);

/// The input of layered_positions for a block; `fractions` of the nodes on its sides by rising s or t.
LayeredBlock layered_block(const WallPlan& plan, const sizing::MeasuredLayout& measured, int block,
                           std::array<std::vector<double>, 4> fractions);

/// Keys walls.<number>.names, .layers, .first, .thickness, .least_thickness; warnings W-WAL-001 and
/// -002 if walls meet.
void report_walls(const WallPlan& plan, const std::vector<WallSpec>& specs, Report& report);

}  // namespace quadrille::layers
