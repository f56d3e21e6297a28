#pragma once
// Boundary data from functions of the plane, and solutions evaluated, for the tests of both discretisations.

#include <algorithm>
#include <functional>
#include <vector>

#include "curve/nurbs.hpp"
#include "galerkin/dirichlet.hpp"
#include "galerkin/discretization.hpp"
#include "spectral/orthogonal_basis.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::galerkin {

using PlaneFunction = std::function<Vec2(Vec2)>;

/// The function on the boundary of the mesh, which must outlive the result.
inline BoundaryData on_boundary(const TriMesh& mesh, PlaneFunction f) {
  return [&mesh, f](int curve, double t) { return f(curve::point(mesh.face.curves[curve], t)); };
}

/// Real and imaginary part of z^3: harmonic polynomials of degree 3.
inline Vec2 cube(Vec2 x) { return {x.x * x.x * x.x - 3 * x.x * x.y * x.y, 3 * x.x * x.x * x.y - x.y * x.y * x.y}; }

/// The greatest distance of the solution from the function, at points of every element.
inline double greatest_error(const MeshContext& context, const std::vector<int>& orders,
                             const std::vector<Eigen::MatrixXd>& coefs, const PlaneFunction& f) {
  double greatest = 0;
  for (std::size_t e = 0; e < coefs.size(); ++e)
    for (const Vec2 xi : spectral::tri_nodes(4)) {
      Eigen::VectorXd modes(coefs[e].rows());
      spectral::orthogonal_values(orders[e], xi, modes.data());
      const Eigen::RowVector2d value = modes.transpose() * coefs[e];
      greatest = std::max(greatest, distance({value[0], value[1]}, f(context.maps[e].position(xi))));
    }
  return greatest;
}

}  // namespace quadrille::galerkin
