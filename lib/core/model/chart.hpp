#pragma once
// A curved face in space, and its isothermal chart: the plane in which every stage works (lib/method.md §12). Lengths
// in space are e^lambda times those in the chart, angles are the same, so that lines, blocks and scaled Jacobians of
// the chart are those of the surface.

#include <array>
#include <vector>

#include "base/vec2.hpp"
#include "base/vec3.hpp"

namespace quadrille {

/// A clamped rational B-spline curve in space; as Nurbs in the plane.
struct SpaceCurve {
  int degree = 1;
  std::vector<double> knots;
  std::vector<Vec3> poles;
  std::vector<double> weights;

  double begin() const { return knots.front(); }
  double end() const { return knots.back(); }
};

/// A clamped rational B-spline surface X(u, v): pole (i, j) is poles[i * num_poles_v() + j]. Surfaces that are closed
/// in u have X(u_begin, v) = X(u_end, v), and likewise in v.
struct NurbsSurface {
  int degree_u = 1, degree_v = 1;
  std::vector<double> knots_u, knots_v;
  std::vector<Vec3> poles;
  std::vector<double> weights;
  bool is_closed_u = false, is_closed_v = false;

  int num_poles_u() const { return static_cast<int>(knots_u.size()) - degree_u - 1; }
  int num_poles_v() const { return static_cast<int>(knots_v.size()) - degree_v - 1; }
};

/// Triangles of order P on the surface, each with its image in the chart. Local nodes: spectral/tri_map.
struct Chart {
  int order = 1;                                  ///< P
  std::vector<std::array<int, 3>> elem2vertices;  ///< counter-clockwise in the chart
  std::vector<Vec2> nodes;        ///< (P+1)(P+2)/2 per element: positions in the chart, relative to face.origin
  std::vector<Vec3> space_nodes;  ///< the same nodes on the surface, in the length unit and coordinates of the CAD file
  std::vector<Vec2> uv;           ///< the same nodes: parameters on the surface of their element
  std::vector<double> log_scale;  ///< the same nodes: lambda
  std::vector<int> elem_surface;  ///< of each element: index into surfaces
  std::vector<NurbsSurface> surfaces;
  std::vector<SpaceCurve> space_curves;  ///< one per curve of the face, with the same parameters
  double closedness = 0;  ///< |dX + i dY - e^(s - i beta) (theta1 + i theta2)| over its norm: error of angles, radians

  int nodes_per_elem() const { return (order + 1) * (order + 2) / 2; }
  int num_elems() const { return static_cast<int>(elem2vertices.size()); }
};

}  // namespace quadrille
