#include "zeros/edge_jumps.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../support/square_field.hpp"

namespace quadrille::zeros {
namespace {

/// The identity on two triangles; the second is shifted by `jump` along x. An orthonormal mode of degree 0 is
/// 1/sqrt(2).
Field shifted(double jump) {
  Field field = interpolated_field(square_mesh({-1, -1}, 2, 1), 2, [](Vec2 x) { return x; });
  field.u[field.coef_offsets[1]] += std::sqrt(2.0) * jump;
  return field;
}

TEST(EdgeJumps, AreNoneForAContinuousField) { EXPECT_TRUE(edge_jumps(field::FieldEvaluator(shifted(0))).empty()); }

TEST(EdgeJumps, BoundWhatIsBetweenNeighbours) {
  Field field = shifted(1e-6);
  field.method = FieldMethod::dg;
  const auto jumps = edge_jumps(field::FieldEvaluator(field));
  ASSERT_EQ(jumps.size(), 2u);
  for (const Jumps& of_elem : jumps) {
    EXPECT_EQ(std::count(of_elem.edge.begin(), of_elem.edge.end(), 0.0), 2);  // all but the diagonal are boundary
    const double diagonal = *std::max_element(of_elem.edge.begin(), of_elem.edge.end());
    EXPECT_NEAR(diagonal, 2e-6, 1e-12);
    EXPECT_NEAR(*std::max_element(of_elem.vertex.begin(), of_elem.vertex.end()), 1e-6, 1e-12);
    EXPECT_EQ(*std::min_element(of_elem.vertex.begin(), of_elem.vertex.end()), 0);
  }
}

TEST(EdgeJumps, AddUpAtAVertexOverHalfTheEdges) {
  // Four squares, eight triangles; one triangle at the middle vertex is shifted: two of its edges end there.
  Field field = interpolated_field(square_mesh({-1, -1}, 2, 2), 1, [](Vec2 x) { return x; });
  field.method = FieldMethod::dg;
  const int middle = 4;
  int elem = 0, local = 0;
  for (int e = 0; e < field.mesh.num_elems(); ++e)
    for (int k = 0; k < 3; ++k)
      if (field.mesh.elem2vertices[e][k] == middle) elem = e, local = k;
  field.u[field.coef_offsets[elem]] += std::sqrt(2.0) * 1e-3;
  const auto jumps = edge_jumps(field::FieldEvaluator(field));
  EXPECT_NEAR(jumps[elem].vertex[local], 2e-3, 1e-12);  // (2e-3 + 2e-3) / 2
}

}  // namespace
}  // namespace quadrille::zeros
