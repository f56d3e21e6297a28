#include "api/triangles.hpp"

#include "triangulate/triangulate.hpp"

namespace quadrille::api {

TriMesh make_triangles(const CadFace& face, const TriangleSettings& settings) {
  triangulate::TriangulateOptions options;
  options.order = settings.order;
  options.size = settings.size;
  options.validate();
  Report report;
  return triangulate::triangulate(face, options, report);
}

}  // namespace quadrille::api
