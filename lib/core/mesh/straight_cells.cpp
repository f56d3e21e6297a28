#include "mesh/straight_cells.hpp"

#include <cstddef>

namespace quadrille::mesh {

namespace {

void measure_face(const StraightCells& cells, const StraightFace& face, CellGeometry& geometry) {
  Vec3 middle, area, moment;
  for (const int corner : face.corners) middle += 0.25 * cells.points[corner];
  double total = 0;
  for (int k = 0; k < 4; ++k) {
    const Vec3 from = cells.points[face.corners[k]], to = cells.points[face.corners[(k + 1) % 4]];
    const Vec3 twice_area = cross(to - from, middle - from);
    const double weight = norm(twice_area);
    area += 0.5 * twice_area;
    moment += weight * (from + to + middle);
    total += weight;
  }
  geometry.face_areas.push_back(area);
  geometry.face_centres.push_back(total > 0 ? moment / (3 * total) : middle);
}

/// By cell: the mean of its faces' centres with these weights.
template <typename Weight>
std::vector<Vec3> mean_centres(const StraightCells& cells, const CellGeometry& geometry, const Weight& weight) {
  std::vector<Vec3> sums(cells.num_cells);
  std::vector<double> totals(cells.num_cells, 0);
  for (std::size_t f = 0; f < cells.faces.size(); ++f)
    for (const int cell : {cells.faces[f].owner, cells.faces[f].neighbour}) {
      if (cell < 0) continue;
      sums[cell] += weight(f) * geometry.face_centres[f];
      totals[cell] += weight(f);
    }
  for (int cell = 0; cell < cells.num_cells; ++cell) sums[cell] = sums[cell] / totals[cell];
  return sums;
}

/// Volumes and centroids of the pyramids from `apexes`.
void add_pyramids(const StraightCells& cells, const std::vector<Vec3>& apexes, CellGeometry& geometry,
                  std::vector<Vec3>& centroids) {
  geometry.volumes.assign(cells.num_cells, 0);
  centroids.assign(cells.num_cells, {});
  for (std::size_t f = 0; f < cells.faces.size(); ++f)
    for (const int cell : {cells.faces[f].owner, cells.faces[f].neighbour}) {
      if (cell < 0) continue;
      const double sign = cell == cells.faces[f].owner ? 1 : -1;
      const double volume = sign * dot(geometry.face_areas[f], geometry.face_centres[f] - apexes[cell]) / 3;
      geometry.volumes[cell] += volume;
      centroids[cell] += volume * (0.75 * geometry.face_centres[f] + 0.25 * apexes[cell]);
    }
  for (int cell = 0; cell < cells.num_cells; ++cell)
    centroids[cell] = geometry.volumes[cell] > 0 ? centroids[cell] / geometry.volumes[cell] : apexes[cell];
}

}  // namespace

CellGeometry cell_geometry(const StraightCells& cells, CellCentre centre) {
  CellGeometry geometry;
  for (const StraightFace& face : cells.faces) measure_face(cells, face, geometry);
  const std::vector<Vec3> apexes = mean_centres(cells, geometry, [](std::size_t) { return 1.0; });
  add_pyramids(cells, apexes, geometry, geometry.centres);
  if (centre == CellCentre::surface)
    geometry.centres = mean_centres(cells, geometry, [&](std::size_t face) { return norm(geometry.face_areas[face]); });
  return geometry;
}

}  // namespace quadrille::mesh
