#include "chart/surface_poisson.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "surface_samples.hpp"

namespace quadrille::chart {
namespace {

constexpr int order = 3;

/// A face with its forms.
struct PoissonSample {
  explicit PoissonSample(SpaceFace of)
      : sample(std::move(of)), mesh(sample.lifted(order)), forms(surface_forms(mesh, sample.face.face.loop_offsets)) {}

  /// The loads of a polynomial u, given by its values at nodes.
  template <class Function>
  ElementColumns loads_of(const Function& u) const {
    ElementColumns loads;
    for (int e = 0; e < mesh.num_elems(); ++e) {
      Eigen::VectorXd values(mesh.nodes_per_elem());
      for (Eigen::Index i = 0; i < values.size(); ++i) values[i] = u(mesh.nodes[mesh.nodes_per_elem() * e + i]);
      loads.push_back(
          products_with_gradients(tables, forms.elems[e], {tables.nodes_xi1 * values, tables.nodes_xi2 * values}));
    }
    return loads;
  }
  /// Checks solutions at the nodes.
  template <class Function>
  void expect_values(const ElementColumns& modes, const Function& u) const {
    for (int e = 0; e < mesh.num_elems(); ++e) {
      const Eigen::VectorXd values = tables.nodes_from_modes * modes[e];
      for (Eigen::Index i = 0; i < values.size(); ++i)
        EXPECT_NEAR(values[i], u(mesh.nodes[mesh.nodes_per_elem() * e + i]), 1e-9);
    }
  }

  SurfaceSample sample;
  SurfaceMesh mesh;
  SurfaceForms forms;
  const ElementTables& tables = element_tables(order);
};

TEST(SurfacePoisson, WithoutLoadsTheSolutionIsZero) {
  const PoissonSample on(cap());
  const SurfacePoisson poisson(on.mesh, on.forms);
  const ElementColumns none(on.mesh.num_elems(), Eigen::MatrixXd::Zero(on.tables.from_modes.cols(), 2));
  for (const Eigen::MatrixXd& modes : poisson.solve_dirichlet(none, 1)) {
    EXPECT_EQ(modes.cols(), 2);
    EXPECT_LT(modes.norm(), 1e-13);
  }
}

/// A function of space that vanishes on the outline, the rim z = 0.6, is a polynomial of no element, but its
/// interpolant is the solution of its own loads.
TEST(SurfacePoisson, OfGivenValuesTheSolutionIsTheFunctionOfTheLoads) {
  const PoissonSample on(cap());
  const SurfacePoisson poisson(on.mesh, on.forms);
  const auto u = [](Vec3 x) { return (x.z - 0.6) * (1 + x.x); };
  on.expect_values(poisson.solve_dirichlet(on.loads_of(u), 1), u);
}

TEST(SurfacePoisson, WithoutGivenValuesItIsThatOfZeroAtVertexZero) {
  const PoissonSample on(cylinder_patch());
  const SurfacePoisson poisson(on.mesh, on.forms);
  const Vec3 first = on.sample.fine.vertices[0];
  const auto u = [](Vec3 x) { return x.z + 2 * x.y; };
  on.expect_values(poisson.solve_neumann(on.loads_of(u)), [&](Vec3 x) { return u(x) - u(first); });
}

/// Of a tube loop 0 alone has given values: the height above it is a solution.
TEST(SurfacePoisson, HolesAreFree) {
  const PoissonSample on(tube());
  const SurfacePoisson poisson(on.mesh, on.forms);
  const auto height = [](Vec3 x) { return x.z; };
  on.expect_values(poisson.solve_dirichlet(on.loads_of(height), 1), height);
}

}  // namespace
}  // namespace quadrille::chart
