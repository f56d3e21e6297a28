#pragma once
// The layouts of the regions of a face, each of its own, before they are joined.

#include <vector>

#include "couple/boundary_place.hpp"
#include "field/evaluate.hpp"
#include "graph/candidate_layout.hpp"
#include "model/cad_face.hpp"

namespace quadrille::couple {

struct RegionLayouts {
  CadFace face;                                 ///< the whole
  std::vector<graph::CandidateLayout> layouts;  ///< one for each region; their faces are those of regions/split.hpp
  std::vector<const field::FieldEvaluator*> fields;  ///< one for each region
  std::vector<int> first_curves;                     ///< number in the whole of the first curve of each region
  std::vector<curve::Turn> turns = {};               ///< of round regions, by region; empty: none was turned

  curve::Turn turn_of(int region) const { return turns.empty() ? curve::Turn{} : turns[region]; }
  field::FieldsOfRegions field_of(int region) const {
    return field::FieldsOfRegions({fields[region]}, {turn_of(region)});
  }
  int region_of_curve(int curve) const { return face.region_of_loop(face.loop_of(curve)); }
  /// Place of a node of a region's graph that is on the boundary of the region.
  Place place_of(int region, int node) const {
    const GraphNode& n = layouts[region].graph().nodes[node];
    return place_at(face, n.curve + first_curves[region], n.t);
  }
};

}  // namespace quadrille::couple
