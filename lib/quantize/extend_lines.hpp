#pragma once
// From a T-mesh with integer lengths to a conforming graph (lib/method.md §9.7): every line that stops at a T-junction
// continues through the integer grids of the faces, until it meets a T-junction from the other side, whose line it then
// is, or the boundary. These lines and those of the T-mesh are all lines that irregular nodes launch through the
// integer grid: what they cut are its largest four-sided blocks (base complex).

#include <vector>

#include "graph/candidate_layout.hpp"
#include "quantize/t_mesh_faces.hpp"

namespace quadrille::quantize {

/// `lengths` (1 or more for each arc, opposite sides of the faces equal): of quantize(). Nodes of the T-mesh keep their
/// numbers. Throws ComputeError where the result has a face without four corners.
graph::CandidateLayout extend_lines(const graph::CandidateLayout& t_mesh, const std::vector<TFace>& faces,
                                    const std::vector<int>& lengths);

}  // namespace quadrille::quantize
