#pragma once
// Lines that leave through one of two periodic sides enter through the other (lib/method.md §11, "Periodic sides").

#include <vector>

#include "base/report.hpp"
#include "field/evaluate.hpp"
#include "graph/candidate_layout.hpp"

namespace quadrille::couple {

/// A conforming layout whose nodes on periodic sides are images of each other. Lines that end near the image of an end
/// on the other side are bent to meet, by the rule of couple/meet_stations.hpp, and so are those whose distance is zero
/// in every integer grid. Where one side has a node, and where a periodic side ends, the other side has a T-junction;
/// integer lengths are found for the T-mesh, with one for an arc and its image, and every line goes on through the
/// other side. `relative_unit`: length of an arc of integer length one, in diameters. Reports couple.periodic_*. Throws
/// ComputeError if there are no integer lengths.
graph::CandidateLayout conforming_across_periodic_sides(graph::CandidateLayout layout,
                                                        const field::FieldsOfRegions& fields, double relative_unit,
                                                        Report& report);

}  // namespace quadrille::couple
