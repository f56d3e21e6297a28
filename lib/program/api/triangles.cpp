#include "api/triangles.hpp"

#include "stage/triangulate_face.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::api {

TriMesh make_triangles(const CadFace& face, const TriangleSettings& settings) {
  triangulate::TriangulateOptions options;
  options.order = settings.order;
  options.size = settings.size;
  options.validate();
  Run run;
  return stage::triangulate_face(face, options, run);
}

TriMesh coarse_triangles(const CadFace& face, const std::function<std::vector<int>(const TriMesh&)>& doubts) {
  Report report;
  return triangulate::coarse_triangles(face, doubts, report);
}

}  // namespace quadrille::api
