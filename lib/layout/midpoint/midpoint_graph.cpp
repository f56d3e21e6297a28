#include "midpoint/midpoint_graph.hpp"

#include <utility>

#include "base/error.hpp"
#include "midpoint/divide_triangles.hpp"
#include "midpoint/doubtful_triangles.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::midpoint {
namespace {

/// The limits of the coarse triangles: few triangles, and no more than the blocks need.
struct CoarseTriangles {
  double size = 0.5;     ///< diameters
  double growth = 1;     ///< of sizes with the distance
  double curve_tol = 1;  ///< diameters: the blocks follow the curves, not the triangles
  int fan_layers = 0;    ///< small triangles at singular corners serve the field only
};

triangulate::TriangulateOptions coarse_options(const CadFace& face) {
  constexpr CoarseTriangles coarse;
  triangulate::TriangulateOptions options;
  options.size = coarse.size * face.diameter;
  options.growth = coarse.growth;
  options.curve_tol = coarse.curve_tol;
  options.fan_layers = coarse.fan_layers;
  return options;
}

std::vector<int> doubtful(const TriMesh& mesh) { return doubtful_triangles(mesh, divide_triangles(mesh)); }

void report_triangles(const TriMesh& triangles, const char* origin, Report& report) {
  report.set("midpoint.triangles", triangles.num_elems());
  report.set("midpoint.origin", origin);
}

}  // namespace

TriMesh coarse_triangles(const CadFace& face, Report& report) {
  Report unused(report.progress());  // the report of the triangle mesh is that of another mesh
  TriMesh triangles = triangulate::triangulate(face, coarse_options(face), unused, doubtful);
  report_triangles(triangles, "coarse", report);
  return triangles;
}

SeparatrixGraph divided(const TriMesh& triangles) { return std::move(divide_triangles(triangles).graph); }

SeparatrixGraph midpoint_graph(const TriMesh& mesh, Report& report) {
  try {
    return divided(coarse_triangles(mesh.face, report));
  } catch (const ComputeError&) {
    report_triangles(mesh, "field", report);
    return divided(mesh);
  }
}

}  // namespace quadrille::midpoint
