#pragma once
// Component `triangles`: the triangle mesh of a face, by CGAL. The triangulation packages of CGAL are under the GPL,
// version 3 or later: a program that links this component may be distributed only under the GPL.

#include <functional>
#include <vector>

#include "model/tri_mesh.hpp"

namespace quadrille::api {

struct TriangleSettings {
  int order = 8;    ///< shape order of the curved elements, 1 to 16
  double size = 0;  ///< greatest element size, length; 0: diameter / 4
};

/// Triangles for solving, as cad2tri makes them: every curved element is proved valid. The face is that of any stage
/// file (CAD files are read by cad2tri). Throws ComputeError (base/error.hpp) with the position if there is no mesh.
TriMesh make_triangles(const CadFace& face, const TriangleSettings& settings = {});

/// Few triangles for midpoint division: TraceSettings::coarse_mesher of component `layouts`. Those that `doubts` names
/// are refined.
TriMesh coarse_triangles(const CadFace& face, const std::function<std::vector<int>(const TriMesh&)>& doubts);

}  // namespace quadrille::api
