#include "galerkin/phase_request.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "../support/texts.hpp"
#include "../triangulate/faces.hpp"
#include "base/error.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::galerkin {
namespace {

using namespace testing_faces;

std::string refusal(const CadFace& face, const PhaseNodes& asked) {
  Report report;
  const TriMesh mesh = triangulate::triangulate(face, {}, report);
  PhaseSolver solver(mesh, std::vector<int>(mesh.num_elems(), 3));
  return message_of<FormatError>([&] { require_possible(solver, face, asked, "x.crit.json"); });
}

TEST(PhaseRequest, TakesWhatIsPossible) {
  EXPECT_EQ(refusal(square(), {{}, {{0, 1}, {1, 1}, {2, 1}, {3, 1}}, {}}), "");
  EXPECT_EQ(refusal(square(), {{{{0.5, 0.5}, 5}}, {{0, 0}, {1, 1}, {2, 1}, {3, 1}}, {}}), "");  // a degenerate corner
}

TEST(PhaseRequest, RefusesBlocksTooFlatOrTooSharpByTheirCorner) {
  EXPECT_EQ(
      refusal(square(),
              {{{{0.5, 0.5}, 3}, {{0.6, 0.5}, 3}, {{0.4, 0.5}, 3}, {{0.4, 0.6}, 3}, {{0.4, 0.7}, 3}, {{0.5, 0.7}, 3}},
               {{0, 7}, {1, 1}, {2, 1}, {3, 1}},
               {}}),
      "x.crit.json: the corner of curves 3 and 0 at (0, 0) cannot have valence 7: its angle is 90 degrees, and "
      "blocks need 15 to 165 degrees");
  EXPECT_NE(refusal(l_shape(), {{}, {{3, 1}}, {}}).find("its angle is 270 degrees"), std::string::npos);
  EXPECT_NE(refusal(square(), {{}, {}, {{1, 0.5, 1}}}).find("the boundary node on curve 1 at (1, 0.5)"),
            std::string::npos);
}

TEST(PhaseRequest, TakesOneBlockAtASharpCorner) {
  const CadFace needle = make_face({polygon({{0, 0}, {1, -0.02}, {1, 0.02}})});
  EXPECT_EQ(refusal(needle, {{{{0.3, 0}, 3}}, {{0, 1}, {1, 1}, {2, 1}}, {}}), "");
  EXPECT_NE(refusal(needle, {{{{0.3, 0}, 3}, {{0.5, 0}, 3}}, {{0, 2}, {1, 1}, {2, 1}}, {}}).find("valence 2"),
            std::string::npos);
}

TEST(PhaseRequest, RefusesWithTheArithmeticOfTheIndexSum) {
  EXPECT_NE(refusal(square(), {{{{0.5, 0.5}, 5}}, {{0, 1}, {1, 1}, {2, 1}, {3, 1}}, {}}).find("together 3"),
            std::string::npos);
}

TEST(PhaseRequest, RefusesNodesOutside) {
  EXPECT_NE(refusal(square(), {{{{1.5, 0.5}, 5}}, {{0, 0}, {1, 1}, {2, 1}, {3, 1}}, {}}).find("(1.5, 0.5) is outside"),
            std::string::npos);
}

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
