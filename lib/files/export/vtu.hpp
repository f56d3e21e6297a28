#pragma once
// VTK's XML for ParaView, VisIt and PyVista: Lagrange or Bezier cells of orders 1-10, with the blocks, the names and
// the quality of the elements; curves of the boundary and of the interfaces in a side file.

#include "export/exported.hpp"
#include "export/frame.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// Of the file with the curves.
inline const SideName vtu_curves_name{".curves.vtu"};

/// The format_table's writers.
Exported vtu_lagrange(const QuadMesh& mesh, const Frame& frame);
Exported vtu_bezier(const QuadMesh& mesh, const Frame& frame);

}  // namespace quadrille::exports
