#pragma once
// The rules of the wall layers, and their tuned constants.
//
// Objective. Along every wall the nodes of the layers lie at prescribed distances from the wall (layer_law), on all
// lines of nodes that start at it; above the layers, and on chords that continue them, neighbouring intervals differ by
// at most the wall's growth until the prescribed size is reached.
//
// Invariants, whatever the rules below decide:
//   - all arcs of a chord have one number of intervals, and their divisions rise from 0 to 1;
//   - a layer has one height on all normal lines of its wall, to round-off; except at an arc of the boundary on which a
//     cut had to move onto a break of the curve (rule 17), and where layers with blocks of their own are compressed
//     (rule a) or turn around a corner (rule d);
//   - layers lie in the first row of blocks: at its far side lie irregular nodes, where cuts cannot follow the wall;
//   - a face with a mirror symmetry gets a mesh with it.
//
// Decisions. "Side" is a block's side on the boundary, "normal line" a line of nodes that starts at a wall, "end" the
// end of an arc. tests/unit/layers/layer_rules_test.cpp has a test for each, and for rules that meet.
//
// clang-format off
//   specification of the layers of each side (wall_spec, wall_sides)
//    1 a curve named twice, or a name without a curve   UsageError
//    2 a side that follows a wall only in part          layers along the whole side
//    3 sides that continue each other (a node with      the specification with the finest first height for all of them
//      V = 2 between them) with different               (of equal ones that given first); W-WAL-002
//      specifications, or one side along such curves
//    4 walls that meet in a corner (V = 1, 3, 4)        each keeps its own specification. If only one of the sides is a
//                                                       wall, its layers divide the arc that starts at the corner, and
//                                                       the other side at most continues them (rule 19)
//    5 a closed wall                                    layers along its whole length, without ends
//
//   heights (wall_sides, layered_block)
//    6 the boundary from which heights are measured     the side and its neighbours along the boundary, walls or not,
//                                                       up to the first node with V other than 2; beyond that node,
//                                                       the distance from it, or, if it is a corner with V = 1 of at
//                                                       most 150 degrees, from the wall's straight continuation:
//                                                       lines that run along the other side cross the layers evenly
//    7 a corner below 180 degrees in that boundary      distance from the nearer of both parts
//    8 a block with walls on adjacent sides (V = 1)     the lines along one wall's normals are placed first, and those
//                                                       of the other run along them. The layers of each wall divide the
//                                                       boundary arc of the other wall
//    9 a line that turns back before its layers end     ComputeError with the position
//
//   number of layers (layer_fit)
//   10 layers=N, or thickness=T (the least number that  ComputeError with the greatest number that fits, and the
//      reaches T), if they do not fit                   position
//   11 layers=fit                                       the greatest number that fits; ComputeError if that is 0
//   12 walls at both ends of a line, if not all fit     the number at both ends is reduced by one until they fit
//   13 a number that crowds the narrow blocks of a      does not fit. If every number of layers of some wall crowds
//      chord, because its wide blocks need the count    blocks, or all numbers are prescribed and growth is limited
//                                                       (growth/limit_growth), crowding is ignored for all walls
//   a  blocks=own, on a line that ends below its layers  the first layer keeps its height; the others and all intervals
//      and one more                                     above grow less; if not even that fits, all are equal
//                                                       (compressed_heights)
//   b  a wall with such a line, or whose chord has so   only the first layer keeps its height (by rule a); all intervals
//      many intervals that those above the layers are   above it are free (wall_layers)
//      shorter than the last layer by more than
//      greatest_jump, if growth is limited
//      (growth/limit_growth)
//   c  layers higher than greatest_bend_height radii    arcs keep their heights; inside the block they are free: lines
//      of a wall that bends towards them, if growth is  towards the centre of the bend, and the layers' offset curves,
//      limited                                          end there (wall_layers)
//   d  blocks=own, a corner of more than 180 degrees    the boundary from which heights are measured (rule 6) ends
//      with V = 2                                       there, and is continued straight: layers run parallel to both
//                                                       sides, as their offset curve does, up to its corner
//
//   divisions of chords (end_spacing, layered_divisions, align_divisions, divide_chord)
//   14 walls with different specifications on one       each keeps its heights at its end; both have the same count;
//      chord                                            W-WAL-001
//   15 several growths on one chord                     the least; each is at least `least_growth`
//   16 an arc of the chord beyond the end of the wall   starts like the nearest arc with layers (of equally near ones
//                                                       the finest) and returns to its own division with the distance
//   17 a boundary interval that misses the tolerance    its nearer end moves onto a break of the curve inside it; if
//      against its CAD curve                            that does not suffice, the chord gets smaller intervals. A
//                                                       layer's end that moved keeps the exact heights of its arc
//   18 an interval in which a given name ends           as 17: no edge belongs to two names
//
//   continuation of the layers (propagate_spacing)
//   19 an arc beyond the block with layers whose first  its chord is divided again, starting with that last interval;
//      interval is far longer than the last one of its  and so on from chord to chord
//      neighbour
//      its own chord may have still finer intervals     half of the finest that is prescribed on its chord is
//      where it is narrow                               continued: else two narrow chords refine each other without end
//   20 such an arc with layers of its own at this end   no change: neighbours never change layers
//   21 an arc too short for such a first interval       the interval is limited (greatest_crowding), but not next to
//                                                       layers
//   22 a block that is adjacent to itself               is no neighbour of itself
//
//   prescribed counts (layered_divisions, divide_chord)
//   23 a chord with a prescribed count                  has it, layers included: the intervals between the layers fill
//                                                       the length, whatever size and growth that gives them. More only
//                                                       if no interval would be left between the layers of some arc,
//                                                       and for the tolerance
// clang-format on

namespace quadrille::layers {

/// Lengths are relative to other lengths and slopes are tangents: no constant has a unit.
struct LayerConstants {
  // Clearance (layer_fit).
  /// Normal lines sampled in each block along a wall, its two sides among them. Fewer miss the narrowest position of a
  /// bulging block.
  int lines_per_block = 9;
  /// Samples on each, denser at both ends (Chebyshev points), where layers are thin. Heights between are interpolated.
  int samples_per_line = 64;
  /// The distance of irregular nodes from a wall over the height of the blocks along it. Around the holes of the plates
  /// in tests/cases, 1.6 is enough for 40 layers; with 2 edges also grow evenly above them.
  double node_distance = 2;
  /// Intervals above the layers may change by this factor at the narrowest position, if the wall's growth is less: the
  /// number of layers must not depend on one narrow position. A little above the default growth of 1.2.
  double greatest_change = 1.25;
  /// Growth beyond the layers is at least this: with less, nearly uniform layers reach the prescribed size only after
  /// dozens of intervals.
  double least_growth = 1.1;
  /// Greatest number of layers of a wall. A limit against mistyped heights.
  int max_layers = 1000;

  // Counts (layered_divisions, divide_chord).
  /// The least count of a chord with layers: a boundary that is one arc needs three intervals for its edges to differ.
  int least_count = 3;
  /// The greatest count. A limit against mistyped sizes, as in refine/divide_arcs.
  int max_intervals = 10000;
  /// Intervals of arcs without prescribed ends may exceed the prescribed size by this factor, so that a slight excess
  /// does not add an interval to a chord.
  double size_slack = 1.25;
  /// Samples of the prescribed size along an arc, for its harmonic mean.
  int size_samples = 32;

  // Beyond the end of a wall (layered_divisions).
  /// Slope, against the wall, at which lines may run from the layers' divisions to free ones. With less, needles extend
  /// far into the domain; with more, the elements beside the wall's end are skewed.
  double greatest_slope = 0.2;
  /// An arc that is crowded begins with at most this multiple of its mean interval: the shortest interval is then about
  /// a fifth of the mean.
  double greatest_crowding = 2.5;

  // Alignment of the divisions of opposite arcs (align_divisions).
  /// Weight = (length / (2 distance))^alignment_power. With the fourth power lines are nearly normal to the arcs across
  /// narrow blocks, and nearly free in blocks as wide as long.
  double alignment_power = 4;
  /// Arcs with layers are aligned as if they were this many times as far apart: their own growth matters more.
  double layered_distance_factor = 2;
  /// The greatest weight; beyond it two arcs have practically one division, and the linear system would lose digits.
  double greatest_weight = 1e6;

  // Continuation into neighbouring chords (propagate_spacing).
  /// Neighbouring intervals across a node may differ by this factor, if the chord's growth is less: a little above the
  /// default growth, so that chords are not divided again for small differences.
  double greatest_jump = 1.3;
  /// A chord propagates at least this fraction of the least spacing prescribed on it: less lets narrow chords refine
  /// each other, more leaves jumps beside narrow blocks.
  double least_propagated_fraction = 0.5;
  /// Number of passes over all chords. Every pass continues fine intervals by one block; they grow by the growth in
  /// each.
  int max_sweeps = 12;

  // The boundary's accuracy (divide_chord).
  /// Factor on the prescribed size of an arc that misses the geometric tolerance.
  double shrink = 0.8;
  /// Greatest number of such reductions: in all by 0.8^30, about 1/800.
  int max_tolerance_rounds = 30;
  /// A prescribed count with which an arc misses the tolerance rises by one and this part of itself.
  int count_steps = 16;

  // Lines inside blocks (tied_lines).
  /// The distance over which divisions of adjacent lines may change, over the length of the elements along them.
  double reach_across = 2;

  /// Height of a layer times the curvature of a wall that bends towards it, up to which the layer keeps its height
  /// inside the block if growth is limited: there the wall's offset curve is half as long as the wall.
  double greatest_bend_height = 0.5;

  // Geometry of walls (wall_sides).
  /// The sine of the angle at which a joint of a wall is a bend. Well above the angles that CAD programs have between
  /// tangent curves, well below any intended corner.
  double least_bend = 1e-3;
  /// The least sine of the angle of a corner beyond which a wall is continued straight: less steep lines would cross
  /// the layers far from it.
  double least_corner_sine = 0.5;
  /// Newton steps to the nearest point of a wall.
  int max_foot_steps = 40;
};

inline constexpr LayerConstants layer_constants;

}  // namespace quadrille::layers
