#include "export/renode.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "../hand_made.hpp"
#include "../support/refined.hpp"
#include "base/error.hpp"
#include "block/extract_blocks.hpp"
#include "export/edge_numbering.hpp"
#include "refine/refine.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quad_map.hpp"
#include "spectral/quadrature.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {

namespace {

/// The square [-1, 1]^2 and its right neighbour, of any order, with nodes at the images of the reference points.
QuadMesh two_squares(int order, const std::function<Vec2(Vec2)>& map) {
  const std::vector<double>& gll = spectral::gll_points(order);
  QuadMesh mesh = two_quads();
  mesh.order = order;
  mesh.nodes.clear(), mesh.elem_nodes.clear();
  for (int j = 0; j <= order; ++j)
    for (int i = 0; i <= 2 * order; ++i) mesh.nodes.push_back(map({i <= order ? gll[i] : 2 + gll[i - order], gll[j]}));
  for (const int first : {0, order})
    for (int j = 0; j <= order; ++j)
      for (int i = 0; i <= order; ++i) mesh.elem_nodes.push_back(first + j * (2 * order + 1) + i);
  return mesh;
}

std::vector<double> even_points(int order) {
  std::vector<double> points;
  for (int i = 0; i <= order; ++i) points.push_back(-1 + 2.0 * i / order);
  return points;
}

Eigen::MatrixXd to_even(int order) {
  return spectral::interpolation_matrix(spectral::gll_points(order), even_points(order));
}

/// Of degree 2 in each variable.
Vec2 bent(Vec2 xi) { return {xi.x + 0.1 * xi.y * xi.y - 0.05 * xi.x * xi.x * xi.y, xi.y + 0.2 * xi.x * xi.x}; }

TEST(Renode, PolynomialsAreExactAtTheNewNodes) {
  for (const int order : {2, 3, 5, 8}) {
    const QuadMesh mesh = two_squares(order, bent);
    const std::vector<Vec2> moved = renoded(mesh, to_even(order));
    const std::vector<double> even = even_points(order);
    for (int elem = 0; elem < 2; ++elem)
      for (int j = 0; j <= order; ++j)
        for (int i = 0; i <= order; ++i) {
          const int node = mesh.elem_nodes[elem * mesh.nodes_per_elem() + j * (order + 1) + i];
          EXPECT_NEAR(distance(moved[node], bent({even[i] + 2 * elem, even[j]})), 0, 1e-13) << order;
        }
  }
}

TEST(Renode, VerticesKeepEveryBit) {
  const int order = 5;
  const QuadMesh mesh = two_squares(order, [](Vec2 x) { return Vec2{x.x / 3, x.y / 7}; });
  const std::vector<Vec2> moved = renoded(mesh, to_even(order));
  for (const int i : {0, order, 2 * order})
    for (const int j : {0, order}) EXPECT_EQ(moved[j * (2 * order + 1) + i], mesh.nodes[j * (2 * order + 1) + i]);
}

TEST(Renode, TheIdentityMovesNothingAndOrderOneHasNothingToMove) {
  const QuadMesh mesh = two_squares(4, bent);
  const std::vector<Vec2> same = renoded(mesh, Eigen::MatrixXd::Identity(5, 5));
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) EXPECT_NEAR(distance(same[n], mesh.nodes[n]), 0, 1e-15);
  const QuadMesh straight = two_straight_quads();
  EXPECT_EQ(renoded(straight, Eigen::MatrixXd::Zero(2, 2)), straight.nodes);
}

TEST(Renode, ASideBetweenTheSameVerticesTwiceIsMovedOnceEach) {
  // Both sides of the ring's quads between (1, 0) and (-1, 0) have nodes of their own.
  const QuadMesh ring = ring_of_two_quads();
  Eigen::MatrixXd bernstein = Eigen::MatrixXd::Identity(3, 3);
  bernstein.row(1) << -0.5, 2, -0.5;
  const std::vector<Vec2> control = renoded(ring, bernstein);
  for (const auto& [low, middle, high] : {std::array{0, 3, 6}, {6, 9, 0}, {2, 5, 8}})
    EXPECT_NEAR(distance(control[middle], 2 * ring.nodes[middle] - (ring.nodes[low] + ring.nodes[high]) / 2), 0, 1e-15);
}

/// de Casteljau on points[0 .. order * stride].
Vec2 on_curve(const Vec2* points, int order, int stride, double t) {
  std::vector<Vec2> p;
  for (int k = 0; k <= order; ++k) p.push_back(points[k * stride]);
  for (int degree = order; degree > 0; --degree)
    for (int k = 0; k < degree; ++k) p[k] = (1 - t) * p[k] + t * p[k + 1];
  return p[0];
}

std::vector<Vec2> in_plane(const QuadMesh& mesh, ElementPoints points) {
  std::vector<Vec2> result;
  for (const auto& [x, y, z] : positions(mesh, Frame(), points)) result.push_back({x, y});
  return result;
}

TEST(Bezier, ControlPointsGiveTheSameMap) {
  for (const int order : {1, 2, 3, 5, 8, 10}) {
    const QuadMesh mesh = refined(hand_made::s_bend(), {1, order, 5e-7});
    const std::vector<Vec2> control = in_plane(mesh, ElementPoints::bezier);
    ASSERT_EQ(control.size(), mesh.nodes.size());
    const int count = mesh.nodes_per_elem();
    for (int elem = 0; elem < mesh.num_elems(); elem += 5) {
      std::vector<Vec2> nodes, points;
      for (int k = 0; k < count; ++k) {
        nodes.push_back(mesh.nodes[mesh.elem_nodes[elem * count + k]]);
        points.push_back(control[mesh.elem_nodes[elem * count + k]]);
      }
      for (const Vec2 xi : {Vec2{-1, -1}, Vec2{0.3, -0.8}, Vec2{-0.1, 0.55}, Vec2{1, 0.2}}) {
        std::vector<Vec2> column;
        for (int j = 0; j <= order; ++j) column.push_back(on_curve(&points[j * (order + 1)], order, 1, (1 + xi.x) / 2));
        const Vec2 x = on_curve(column.data(), order, 1, (1 + xi.y) / 2);
        EXPECT_NEAR(distance(x, spectral::quad_position(order, nodes.data(), xi)), 0, 1e-13) << order;
      }
    }
  }
}

TEST(Bezier, QuadraticArcHasItsPoleWhereTheTangentsMeet) {
  // A parabola through the arc's nodes at -1, 0, 1 has the middle pole 2 x(0) - (x(-1) + x(1)) / 2.
  const QuadMesh mesh = refined(hand_made::quarter_annulus(), {1, 2, 5e-7});
  const std::vector<Vec2> control = in_plane(mesh, ElementPoints::bezier);
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const int* ids = &mesh.elem_nodes[elem * 9];
    const Vec2 pole = 2 * mesh.nodes[ids[1]] - (mesh.nodes[ids[0]] + mesh.nodes[ids[2]]) / 2;
    EXPECT_NEAR(distance(control[ids[1]], pole), 0, 1e-15);
    EXPECT_EQ(control[ids[0]], mesh.nodes[ids[0]]);
    EXPECT_EQ(control[ids[8]], mesh.nodes[ids[8]]);
  }
}

TEST(Equispaced, NodesLieOnTheSamePolynomial) {
  for (const int order : {1, 2, 3, 4, 7, 10}) {
    const QuadMesh mesh = refined(hand_made::s_bend(), {1, order, 5e-7});
    const std::vector<Vec2> moved = in_plane(mesh, ElementPoints::equispaced);
    ASSERT_EQ(moved.size(), mesh.nodes.size());
    const int count = mesh.nodes_per_elem();
    for (int elem = 0; elem < mesh.num_elems(); elem += 7) {
      std::vector<Vec2> nodes;
      for (int k = 0; k < count; ++k) nodes.push_back(mesh.nodes[mesh.elem_nodes[elem * count + k]]);
      for (int j = 0; j <= order; ++j)
        for (int i = 0; i <= order; ++i) {
          const Vec2 exact = spectral::quad_position(order, nodes.data(), {-1 + 2.0 * i / order, -1 + 2.0 * j / order});
          const Vec2 got = moved[mesh.elem_nodes[elem * count + j * (order + 1) + i]];
          EXPECT_NEAR(distance(got, exact), 0, 1e-13);
        }
    }
  }
}

TEST(Equispaced, VerticesStayBitForBit) {
  const QuadMesh mesh = refined(hand_made::quarter_annulus(), {0.5, 5, 5e-7});
  const std::vector<Vec2> moved = in_plane(mesh, ElementPoints::equispaced);
  for (int elem = 0; elem < mesh.num_elems(); ++elem)
    for (const int corner : {0, 5, 30, 35}) {
      const int node = mesh.elem_nodes[elem * 36 + corner];
      EXPECT_EQ(moved[node], mesh.nodes[node]);
    }
}

TEST(ChebyshevLobatto, KnownPoints) {
  EXPECT_EQ(chebyshev_lobatto_points(1), (std::vector<double>{-1, 1}));
  EXPECT_EQ(chebyshev_lobatto_points(2), (std::vector<double>{-1, 0, 1}));
  const std::vector<double> four = chebyshev_lobatto_points(4);
  ASSERT_EQ(four.size(), 5u);
  EXPECT_NEAR(four[1], -std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(chebyshev_lobatto_points(3)[2], 0.5, 1e-15);
}

TEST(ChebyshevLobatto, AscendsAndReadsTheSameFromBothEnds) {
  for (int order = 1; order <= 30; ++order) {
    const std::vector<double> points = chebyshev_lobatto_points(order);
    EXPECT_EQ(points.back(), 1);
    for (int k = 0; k <= order; ++k) {
      EXPECT_EQ(points[k], -points[order - k]);
      if (k > 0) {
        EXPECT_LT(points[k - 1], points[k]);
      }
    }
  }
}

/// One element of order n whose nodes are f(s, t), s and t in [0, 1].
template <class Map>
QuadMesh one_quad(int order, Map f) {
  QuadMesh mesh;
  mesh.order = order;
  mesh.face.diameter = 1;
  for (const double eta : spectral::gll_points(order))
    for (const double xi : spectral::gll_points(order)) {
      mesh.elem_nodes.push_back(static_cast<int>(mesh.nodes.size()));
      mesh.nodes.push_back(f((1 + xi) / 2, (1 + eta) / 2));
    }
  mesh.elem_block = {0};
  return mesh;
}

/// Linear in t between two curved sides: a blend of its sides.
Vec2 ruled(double s, double t) { return {s + 0.1 * t * s * (1 - s), t + (1 - t) * s * s * s / 4}; }

TEST(TransfiniteLoss, BlendsOfTheirSidesLoseNothing) {
  for (const int order : {1, 2, 3, 6, 12}) {
    const QuadMesh mesh = order == 1 ? two_straight_quads() : one_quad(order, ruled);
    EXPECT_LT(transfinite_loss(mesh, RebuiltFrom::sides, "x").interior, 1e-15 * mesh.face.diameter) << order;
  }
  EXPECT_EQ(transfinite_loss(two_quads(), RebuiltFrom::sides, "x").interior, 0);
}

TEST(TransfiniteLoss, IsTheDistanceOfTheMovedNode) {
  const TransfiniteLoss loss = transfinite_loss(two_quads_with_moved_middle(), RebuiltFrom::sides, "x");
  EXPECT_DOUBLE_EQ(loss.interior, std::hypot(0.125, 0.25));
  EXPECT_EQ(loss.sides, 0);
}

TEST(TransfiniteLoss, ParabolasKeepOrderTwoAndMissOrderThree) {
  EXPECT_EQ(transfinite_loss(two_quads(), RebuiltFrom::quadratic_sides, "x").sides, 0);
  // y = s^3 / 4 against the parabola through s = 0, 1/2, 1: the difference s (s - 1/2) (s - 1) / 4 at the nodes.
  const double s = (1 + spectral::gll_points(3)[2]) / 2;
  EXPECT_NEAR(transfinite_loss(one_quad(3, ruled), RebuiltFrom::quadratic_sides, "x").sides,
              std::abs(s * (s - 0.5) * (s - 1) / 4), 1e-15);
}

TEST(TransfiniteLoss, RefusesWhatTheReaderWouldFold) {
  // The lower side reaches over the upper one, so that the blend of the sides has negative Jacobians.
  const QuadMesh folded = one_quad(4, [](double s, double t) {
    return Vec2{s, t * 0.1 + 8 * s * (1 - s) * s * (1 - s) * (1 - t)};
  });
  EXPECT_NO_THROW(
      transfinite_loss(folded, RebuiltFrom::sides, "x"));  // the mesh's own element, which its bounds have judged
  QuadMesh moved = folded;
  moved.nodes[12].y += 0.01;
  try {
    transfinite_loss(moved, RebuiltFrom::sides, "Reader");
    FAIL();
  } catch (const ComputeError& error) {
    EXPECT_NE(std::string(error.what()).find("Reader rebuilds"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("element 0 near"), std::string::npos);
  }
}

TEST(SideBlend, TellsHowFarTheMiddleWasMoved) {
  EXPECT_EQ(distance_from_side_blend(two_quads(), 0), 0);
  EXPECT_EQ(distance_from_side_blend(two_quads(), 1), 0);
  EXPECT_DOUBLE_EQ(distance_from_side_blend(two_quads_with_moved_middle(), 1), std::hypot(0.125, 0.25));
}

TEST(SideBlend, ElementsOfABlendedBlockAreBlends) {
  Report report;
  refine::RefineOptions options{0.4, 7, 5e-7};
  options.inner_edges = refine::InnerEdges::curved;  // straight ones are blended by (1 - eta)^2
  const QuadMesh mesh = refine::refine(block::extract_blocks(hand_made::elbow(), report), options, report);
  for (int elem = 0; elem < mesh.num_elems(); ++elem) EXPECT_LT(distance_from_side_blend(mesh, elem), 1e-14) << elem;
}

TEST(SideBlend, AnArcAndUnevenSpeedAreNotStraight) {
  QuadMesh mesh = two_quads();
  const EdgeNumbering numbering = number_parts(mesh);
  EXPECT_FALSE(is_straight_edge(mesh, edge_nodes(mesh, numbering.edges[6])));
  EXPECT_TRUE(is_straight_edge(mesh, edge_nodes(mesh, numbering.edges[0])));
  mesh.nodes[1].x = 1.25;
  EXPECT_FALSE(is_straight_edge(mesh, edge_nodes(mesh, numbering.edges[0])));
}

}  // namespace

}  // namespace quadrille::exports
