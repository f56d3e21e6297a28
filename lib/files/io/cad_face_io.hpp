#pragma once
// The CAD face inside every stage file that needs it (formats/cad-face.md). Private to io.

#include "io/archive.hpp"
#include "model/cad_face.hpp"
#include "model/separatrix_graph.hpp"

namespace quadrille::io {

/// Writes or reads the face as the JSON object or HDF5 group `face`.
void describe_face(Archive& archive, CadFace& face);
void describe_nurbs(Archive& archive, const char* name, std::vector<Nurbs>& curves);
/// Writes or reads the members `nodes` and `arcs` of a separatrix graph or a block layout.
void describe_graph(Archive& archive, std::vector<GraphNode>& nodes, std::vector<GraphArc>& arcs);
/// Writes or reads the member `open_curves`, where there are any.
void describe_open_curves(Archive& archive, std::vector<int>& curves);

}  // namespace quadrille::io
