#include "galerkin/phase_orders.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "../triangulate/faces.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::galerkin {
namespace {

using namespace testing_faces;

TriMesh mesh_of(const CadFace& face) {
  Report report;
  return triangulate::triangulate(face, {}, report);
}

TEST(PhaseOrders, AreHalfAndFiveWhereTheBoundaryIsRound) {
  const TriMesh mesh = mesh_of(annulus());
  EXPECT_EQ(phase_orders(mesh, std::vector<int>(mesh.num_elems(), 20)), std::vector<int>(mesh.num_elems(), 15));
  EXPECT_EQ(phase_orders(mesh, std::vector<int>(mesh.num_elems(), 17)), std::vector<int>(mesh.num_elems(), 14));
}

TEST(PhaseOrders, NeverExceedThoseOfTheField) {
  const TriMesh mesh = mesh_of(annulus());
  for (const int order : {1, 8, 10}) {
    const std::vector<int> orders(mesh.num_elems(), order);
    EXPECT_EQ(phase_orders(mesh, orders), orders);
  }
}

TEST(PhaseOrders, AreThoseOfTheFieldInFansAndAtStraightSides) {
  const TriMesh mesh = mesh_of(l_shape());  // a fan at its reflex corner
  std::set<int> at_sides;
  for (const BoundaryEdge& edge : mesh.boundary_edges) at_sides.insert(edge.elem);
  const std::vector<int> orders = phase_orders(mesh, std::vector<int>(mesh.num_elems(), 18));
  int num_lowered = 0;
  for (int e = 0; e < mesh.num_elems(); ++e) {
    const bool keeps = mesh.elem_layer[e] >= 0 || at_sides.count(e) > 0;
    EXPECT_EQ(orders[e], keeps ? 18 : 14) << e;
    num_lowered += !keeps;
  }
  EXPECT_GT(num_lowered, 0);
  EXPECT_GT(*std::max_element(mesh.elem_layer.begin(), mesh.elem_layer.end()), 0);
}

}  // namespace
}  // namespace quadrille::galerkin
