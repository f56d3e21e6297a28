#include "stage/triangulate_face.hpp"

#include <vector>

#include "regions/region_work.hpp"
#include "regions/split.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::stage {

TriMesh triangulate_face(const CadFace& face, const triangulate::TriangulateOptions& options, Run& run) {
  const std::vector<CadFace> regions = regions::split(face);
  return regions::join(
      face, regions::map_regions<TriMesh>(face, run.threads(), run.report(), [&](int region, int, Report& report) {
        return triangulate::triangulate(regions[region], options, report);
      }));
}

}  // namespace quadrille::stage
