#pragma once
// The layouts of the regions of a face, each of its own, before they are joined.

#include <vector>

#include "couple/boundary_point.hpp"
#include "field/evaluate.hpp"
#include "graph/candidate_layout.hpp"
#include "model/cad_face.hpp"

namespace quadrille::couple {

struct RegionLayouts {
  CadFace face;                                 ///< the whole
  std::vector<graph::CandidateLayout> layouts;  ///< one for each region; their faces are those of regions/split.hpp
  std::vector<const field::FieldEvaluator*> fields;  ///< one for each region
  std::vector<int> first_curves;                     ///< number in the whole of the first curve of each region
  std::vector<curve::Rotation> rotations = {};       ///< of circular regions, by region; empty: none was rotated

  curve::Rotation rotation_of(int region) const { return rotations.empty() ? curve::Rotation{} : rotations[region]; }
  field::FieldsOfRegions field_of(int region) const {
    return field::FieldsOfRegions({fields[region]}, {rotation_of(region)});
  }
  int region_of_curve(int curve) const { return face.region_of_loop(face.loop_of(curve)); }
  /// The point of the whole at which a node of a region's graph lies that is on the boundary of the region.
  BoundaryPoint point_of(int region, int node) const {
    const GraphNode& n = layouts[region].graph().nodes[node];
    return boundary_point(face, n.curve + first_curves[region], n.t);
  }
};

}  // namespace quadrille::couple
