#include "triangulate/coarse_triangles.hpp"

namespace quadrille::triangulate {
namespace {

/// The limits of the coarse triangles: few triangles, and no more than the blocks need.
struct CoarseLimits {
  double size = 0.5;     ///< diameters
  double growth = 1;     ///< of sizes with the distance
  double curve_tol = 1;  ///< diameters: the blocks follow the curves, not the triangles
  int fan_layers = 0;    ///< small triangles at singular corners serve the field only
};

TriangulateOptions coarse_options(const CadFace& face) {
  constexpr CoarseLimits coarse;
  TriangulateOptions options;
  options.size = coarse.size * face.diameter;
  options.growth = coarse.growth;
  options.curve_tol = coarse.curve_tol;
  options.fan_layers = coarse.fan_layers;
  return options;
}

}  // namespace

TriMesh coarse_triangles(const CadFace& face, const Doubts& doubts, Report& report) {
  return triangulate(face, coarse_options(face), report, doubts);
}

}  // namespace quadrille::triangulate
