#include "mesh/cell_quality.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>

namespace quadrille::mesh {

namespace {

Vec3 turned(const SpaceMotion& motion, Vec3 x) {
  const auto& [a, b, c] = motion.matrix;
  return {dot(a, x), dot(b, x), dot(c, x)};
}

/// x = matrix^T y of a rotation.
Vec3 turned_back(const SpaceMotion& motion, Vec3 y) {
  const auto& [a, b, c] = motion.matrix;
  return y.x * a + y.y * b + y.z * c;
}

/// By face: the centre of the cell behind it, where there is one; of a coupled face where its motion has it.
struct Opposite {
  std::vector<Vec3> centres;
  std::vector<bool> exists;

  Opposite(const StraightCells& cells, const CellGeometry& geometry)
      : centres(cells.faces.size()), exists(cells.faces.size(), false) {
    for (std::size_t f = 0; f < cells.faces.size(); ++f)
      if (const int neighbour = cells.faces[f].neighbour; neighbour >= 0) set(f, geometry.centres[neighbour]);
    for (const CoupledFaces& pair : cells.coupled) {
      const Vec3 first = geometry.centres[cells.faces[pair.first].owner],
                 second = geometry.centres[cells.faces[pair.second].owner];
      set(pair.first, turned_back(pair.motion, second - pair.motion.shift));
      set(pair.second, turned(pair.motion, first) + pair.motion.shift);
    }
  }

  void set(std::size_t face, Vec3 centre) { centres[face] = centre, exists[face] = true; }
};

double angle_in_degrees(Vec3 a, Vec3 b) {
  const double sizes = norm(a) * norm(b);
  const double cosine = sizes > 0 ? dot(a, b) / sizes : -1;
  return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
}

double half_width(const StraightCells& cells, const StraightFace& face, Vec3 centre, Vec3 direction, double least) {
  double width = least;
  for (const int corner : face.corners)
    width = std::max(width, std::abs(dot(direction, cells.points[corner] - centre)));
  return width;
}

/// FO, where the line from `from` along d meets the plane of the face.
Vec3 offset_of(Vec3 from, Vec3 d, Vec3 area, Vec3 centre) {
  const Vec3 to_centre = centre - from;
  const double along = dot(area, d);
  return along != 0 ? to_centre - dot(area, to_centre) / along * d : to_centre;
}

std::vector<CellSample> of_faces(const StraightCells& cells, const CellGeometry& geometry,
                                 const std::function<bool(std::size_t)>& is_measured,
                                 const std::function<double(std::size_t)>& value) {
  std::vector<CellSample> samples;
  for (std::size_t f = 0; f < cells.faces.size(); ++f)
    if (is_measured(f)) samples.push_back({value(f), cells.faces[f].owner, geometry.face_centres[f]});
  return samples;
}

bool is_inner(const StraightFace& face) { return face.neighbour >= 0; }

double aspect_of(Vec3 sums, double volume, bool is_plate) {
  const double least = is_plate ? std::min(sums.x, sums.y) : std::min({sums.x, sums.y, sums.z});
  const double greatest = is_plate ? std::max(sums.x, sums.y) : std::max({sums.x, sums.y, sums.z});
  const double ratio = least > 0 ? greatest / least : 1e300;
  if (is_plate) return ratio;
  return volume > 0 ? std::max(ratio, (sums.x + sums.y + sums.z) / (6 * std::pow(volume, 2.0 / 3))) : 1e300;
}

}  // namespace

std::vector<CellSample> face_angles(const StraightCells& cells, const CellGeometry& geometry) {
  const Opposite opposite(cells, geometry);
  return of_faces(
      cells, geometry, [&](std::size_t f) { return opposite.exists[f]; },
      [&](std::size_t f) {
        return angle_in_degrees(opposite.centres[f] - geometry.centres[cells.faces[f].owner], geometry.face_areas[f]);
      });
}

std::vector<CellSample> boundary_face_angles(const StraightCells& cells, const CellGeometry& geometry) {
  return of_faces(
      cells, geometry, [&](std::size_t f) { return !is_inner(cells.faces[f]); },
      [&](std::size_t f) {
        return angle_in_degrees(geometry.face_centres[f] - geometry.centres[cells.faces[f].owner],
                                geometry.face_areas[f]);
      });
}

std::vector<CellSample> face_skewness(const StraightCells& cells, const CellGeometry& geometry) {
  const Opposite opposite(cells, geometry);
  const auto skewness = [&](std::size_t f) {
    const Vec3 own = geometry.centres[cells.faces[f].owner], centre = geometry.face_centres[f],
               area = geometry.face_areas[f];
    const double size2 = norm2(area);
    const Vec3 d =
        opposite.exists[f] ? opposite.centres[f] - own : (size2 > 0 ? dot(area, centre - own) / size2 : 0.0) * area;
    const Vec3 offset = offset_of(own, d, area, centre);
    const double size = norm(offset);
    if (!(size > 0)) return 0.0;
    return size / half_width(cells, cells.faces[f], centre, offset / size, (opposite.exists[f] ? 0.2 : 0.4) * norm(d));
  };
  return of_faces(
      cells, geometry, [](std::size_t) { return true; }, skewness);
}

std::vector<CellSample> cell_aspects(const StraightCells& cells, const CellGeometry& geometry) {
  std::vector<Vec3> sums(cells.num_cells);
  for (std::size_t f = 0; f < cells.faces.size(); ++f)
    for (const int cell : {cells.faces[f].owner, cells.faces[f].neighbour})
      if (const Vec3 area = geometry.face_areas[f]; cell >= 0)
        sums[cell] += {std::abs(area.x), std::abs(area.y), std::abs(area.z)};
  std::vector<CellSample> samples;
  for (int cell = 0; cell < cells.num_cells; ++cell)
    samples.push_back({aspect_of(sums[cell], geometry.volumes[cell], cells.is_plate), cell, geometry.centres[cell]});
  return samples;
}

std::vector<CellSample> face_pyramids(const StraightCells& cells, const CellGeometry& geometry) {
  std::vector<CellSample> samples;
  for (std::size_t f = 0; f < cells.faces.size(); ++f)
    for (const int cell : {cells.faces[f].owner, cells.faces[f].neighbour}) {
      if (cell < 0) continue;
      const double sign = cell == cells.faces[f].owner ? 1 : -1, whole = geometry.volumes[cell];
      const double part = sign * dot(geometry.face_areas[f], geometry.face_centres[f] - geometry.centres[cell]) / 3;
      samples.push_back({whole > 0 ? 6 * part / whole : -1, cell, geometry.face_centres[f]});
    }
  return samples;
}

std::vector<CellSample> plane_deviations(const StraightCells& cells, const CellGeometry& geometry) {
  std::vector<CellSample> samples;
  for (const std::vector<int>& faces : cells.planes) {
    Vec3 mean;
    for (const int f : faces) mean += normalized(geometry.face_areas[f]) / static_cast<double>(faces.size());
    for (const int f : faces)
      samples.push_back(
          {norm(normalized(geometry.face_areas[f]) - mean), cells.faces[f].owner, geometry.face_centres[f]});
  }
  return samples;
}

std::vector<CellSample> volume_ratios(const StraightCells& cells, const CellGeometry& geometry) {
  return of_faces(
      cells, geometry, [&](std::size_t f) { return is_inner(cells.faces[f]); },
      [&](std::size_t f) {
        const double a = geometry.volumes[cells.faces[f].owner], b = geometry.volumes[cells.faces[f].neighbour];
        return std::min(a, b) > 0 ? std::max(a, b) / std::min(a, b) : 1e300;
      });
}

std::vector<CellSample> face_offsets(const StraightCells& cells, const CellGeometry& geometry) {
  return of_faces(
      cells, geometry, [&](std::size_t f) { return is_inner(cells.faces[f]); },
      [&](std::size_t f) {
        const auto [corners, owner, neighbour] = cells.faces[f];
        const Vec3 own = geometry.centres[owner], area = geometry.face_areas[f];
        const Vec3 offset = offset_of(own, geometry.centres[neighbour] - own, area, geometry.face_centres[f]);
        const double volume = std::min(geometry.volumes[owner], geometry.volumes[neighbour]);
        return volume > 0 ? 1 - std::cbrt(norm(offset) * norm(area) / volume) : -1e300;
      });
}

std::vector<CellSample> gradient_conditions(const StraightCells& cells, const CellGeometry& geometry) {
  std::vector<Eigen::Matrix3d> sums(cells.num_cells, Eigen::Matrix3d::Zero());
  for (std::size_t f = 0; f < cells.faces.size(); ++f) {
    const auto [corners, owner, neighbour] = cells.faces[f];
    const Vec3 d = neighbour >= 0 ? geometry.centres[neighbour] - geometry.centres[owner] : geometry.face_areas[f];
    if (!(norm(d) > 0)) continue;
    const Vec3 e = normalized(d);
    const Eigen::Vector3d column(e.x, e.y, e.z);
    for (const int cell : {owner, neighbour})
      if (cell >= 0) sums[cell] += column * column.transpose();
  }
  std::vector<CellSample> samples;
  for (int cell = 0; cell < cells.num_cells; ++cell) {
    const Eigen::Vector3d values =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sums[cell], Eigen::EigenvaluesOnly).eigenvalues();
    samples.push_back({values(2) > 0 ? values(0) / values(2) : 0, cell, geometry.centres[cell]});
  }
  return samples;
}

}  // namespace quadrille::mesh
