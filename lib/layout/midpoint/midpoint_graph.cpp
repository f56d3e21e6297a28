#include "midpoint/midpoint_graph.hpp"

#include <utility>

#include "base/error.hpp"
#include "midpoint/divide_triangles.hpp"
#include "midpoint/doubtful_triangles.hpp"

namespace quadrille::midpoint {
namespace {

std::vector<int> doubtful(const TriMesh& mesh) { return doubtful_triangles(mesh, divide_triangles(mesh)); }

void require(const CoarseMesher& mesher) {
  if (!mesher) throw ComputeError("midpoint division needs a mesher of coarse triangles, and this program has none");
}

void report_triangles(const TriMesh& triangles, const char* origin, Report& report) {
  report.set("midpoint.triangles", triangles.num_elems());
  report.set("midpoint.origin", origin);
}

}  // namespace

TriMesh coarse_triangles(const CadFace& face, const CoarseMesher& mesher, Report& report) {
  require(mesher);
  Report unused(report.progress());  // the report of the triangle mesh is that of another mesh
  TriMesh triangles = mesher(face, doubtful, unused);
  report_triangles(triangles, "coarse", report);
  return triangles;
}

SeparatrixGraph divided(const TriMesh& triangles) { return std::move(divide_triangles(triangles).graph); }

SeparatrixGraph midpoint_graph(const TriMesh& mesh, const CoarseMesher& mesher, Report& report) {
  require(mesher);
  try {
    return divided(coarse_triangles(mesh.face, mesher, report));
  } catch (const ComputeError&) {
    report_triangles(mesh, "field", report);
    return divided(mesh);
  }
}

}  // namespace quadrille::midpoint
