#pragma once
// The conforming layout of the joined regions of a face: lines continue across interfaces and periodic sides
// (lib/method.md §11).

#include <optional>

#include "base/report.hpp"
#include "couple/region_layouts.hpp"

namespace quadrille::couple {

/// A corner of an embedded curve, at which lines of the two sides hardly meet.
struct InterfaceCorner {
  int joint = 0;
  double turn = 0;  ///< of the tangent there, radians, 0 to pi
};

/// The joint at which a curve with the face on both sides turns the most, the first of equal ones, if it turns by more
/// than 45 degrees: the nearest numbers of blocks on its two sides then differ. Else std::nullopt.
std::optional<InterfaceCorner> sharpest_interface_corner(const CadFace& face);

/// Moves nodes on second sides that are nearer than 1e-8 diameters to the image of a node on the first onto it.
void snap_periodic_nodes(SeparatrixGraph& graph);

/// Divides each side where the other one has a node, and both where a periodic side ends. Returns the number of new
/// nodes: T-junctions of the layout seen across its periodic sides.
int divide_periodic_sides(graph::CandidateLayout& layout);

/// `joined`: the layout of the whole (couple/join_layouts.hpp). Lines that end near the image of an end on the other
/// one of two periodic sides are bent to match (couple/side_pairs.hpp). Where one side has a node, and where a
/// periodic side ends, the other side gets a T-junction. A layout with T-junctions is a T-mesh: integer lengths are
/// found for it, with one for an arc and its image, and every line continues across interfaces and periodic sides
/// (quantize/quantize_and_extend.hpp). If there are no lengths, line ends on periodic sides between which every integer
/// grid has no length are bent to match. Reports couple.periodic_*. Throws ComputeError if there are no integer
/// lengths.
graph::CandidateLayout conforming_layout(const RegionLayouts& regions, graph::CandidateLayout joined, Report& report);

}  // namespace quadrille::couple
