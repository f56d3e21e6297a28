#include "mesh/finer_elements.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "quad_row.hpp"

namespace quadrille::mesh {

namespace {

TEST(ElementRows, RunAcrossTheSidesOfElements) {
  const QuadMesh mesh = quad_row(2, {0, 1, 2, 4}, 1);
  const auto rows = element_rows(mesh);
  for (int elem = 1; elem < 3; ++elem) EXPECT_EQ(rows[elem][1], rows[0][1]) << "one height for all";
  EXPECT_NE(rows[0][0], rows[1][0]) << "each has its own width";
  EXPECT_NE(rows[0][0], rows[0][1]);
}

ExpectedMesh expected(const QuadMesh& mesh, double factor) {
  return expected_mesh(element_rows(mesh), element_powers(mesh), std::vector<double>(mesh.num_elems(), factor));
}

TEST(ExpectedMesh, IsTheMeshItselfWhereNoElementIsTooLong) {
  QuadMesh mesh = quad_row(2, {0, 1, 2}, 0.5);
  mesh.elem_prescribed_length = {1, 1};
  EXPECT_NEAR(expected(mesh, 1).resolution, resolution(mesh).ratio, 1e-12);
  EXPECT_NEAR(expected(mesh, 1).num_elems, 2, 1e-12);
  EXPECT_NEAR(expected(mesh, 0.5).num_elems, 2, 1e-12) << "rows are never merged";
}

TEST(ExpectedMesh, OfANarrowRowIsOfSquaresWhenSizesAreAsNarrow) {
  QuadMesh mesh = quad_row(2, {0, 1, 2}, 0.25);
  mesh.elem_prescribed_length = {1, 1};
  EXPECT_GT(resolution(mesh).ratio, 100);
  const ExpectedMesh squares = expected(mesh, 4), halves = expected(mesh, 2);
  EXPECT_NEAR(squares.resolution, 1, 1e-12);
  EXPECT_NEAR(squares.num_elems, 8, 1e-12);
  EXPECT_NEAR(halves.resolution, (1 + std::pow(0.5, 8)) / 2 / std::pow(0.5, 4), 1e-12) << "two parts of 1 by 1/2";
}

TEST(ExpectedMesh, ElementsInLayersDoNotCount) {
  QuadMesh mesh = quad_row(2, {0, 1, 1.01}, 1);
  mesh.elem_prescribed_length = {1, 0};
  EXPECT_NEAR(expected(mesh, 1).resolution, 1, 1e-12);
  EXPECT_NEAR(expected(mesh, 1).num_elems, 1, 1e-12);
}

}  // namespace

}  // namespace quadrille::mesh
