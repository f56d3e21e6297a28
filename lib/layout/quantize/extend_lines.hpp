#pragma once
// Extends a T-mesh with integer lengths to a conforming graph (lib/method.md §9.7): every line that stops at a
// T-junction continues through the integer grids of the faces, until it meets the boundary, or a T-junction from the
// other side, whose line it joins. These lines and the lines of the T-mesh are all lines that start at irregular nodes
// in the integer grid: they bound its largest four-sided blocks (base complex).

#include <vector>

#include "graph/candidate_layout.hpp"
#include "quantize/t_mesh_faces.hpp"

namespace quadrille::quantize {

/// `lengths` (1 or more for each arc, opposite sides of the faces equal): of quantize(). Nodes of the T-mesh keep their
/// numbers. `same`, of each arc (model/periodic.hpp): of arcs of periodic sides, the one that it is the image of; lines
/// that leave through one enter through the other, at equal fractions; both must have one length. Throws ComputeError
/// if the result has a face without four corners, or if lines run across each other at a node (faces that are much
/// thinner than their sides are curved).
graph::CandidateLayout extend_lines(const graph::CandidateLayout& t_mesh, const std::vector<TFace>& faces,
                                    const std::vector<int>& lengths, const std::vector<HalfEdge>& same = {});

}  // namespace quadrille::quantize
