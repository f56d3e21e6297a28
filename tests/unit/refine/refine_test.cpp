#include "refine/refine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "../hand_made.hpp"
#include "../support/refined.hpp"
#include "base/error.hpp"
#include "curve/project.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"
#include "split_samples.hpp"

namespace quadrille::refine {
namespace {

/// Green's formula over the boundary polynomials, exact by a Gauss rule of sufficient degree.
double area(const QuadMesh& mesh) {
  const int n = mesh.order, width = n + 1;
  const spectral::Quadrature rule = spectral::gauss_legendre(n + 1);
  const Eigen::MatrixXd value = spectral::interpolation_matrix(spectral::gll_points(n), rule.points);
  const Eigen::MatrixXd slope = value * spectral::differentiation_matrix(spectral::gll_points(n));
  const std::array<int, 4> starts{0, n, width * width - 1, width * n}, strides{1, width, -1, -width};
  double twice = 0;
  for (const QuadBoundaryEdge& e : mesh.boundary_edges)
    for (int q = 0; q <= n; ++q) {
      Vec2 x, d;
      for (int k = 0; k <= n; ++k) {
        const Vec2 node = mesh.nodes[mesh.elem_nodes[e.elem * width * width + starts[e.side] + k * strides[e.side]]];
        x += value(q, k) * node, d += slope(q, k) * node;
      }
      twice += rule.weights[q] * cross(x, d);
    }
  return twice / 2;
}

/// Greatest distance of densely sampled boundary points from the CAD curve that each edge follows or its neighbours.
double boundary_distance(const QuadMesh& mesh) {
  const int n = mesh.order, width = n + 1;
  std::vector<double> points;
  for (int i = 0; i <= 40; ++i) points.push_back(-1 + i / 20.0);
  const Eigen::MatrixXd value = spectral::interpolation_matrix(spectral::gll_points(n), points);
  const std::array<int, 4> starts{0, n, width * width - 1, width * n}, strides{1, width, -1, -width};
  double worst = 0;
  for (const QuadBoundaryEdge& e : mesh.boundary_edges)
    for (int q = 0; q <= 40; ++q) {
      Vec2 x;
      for (int k = 0; k <= n; ++k)
        x += value(q, k) * mesh.nodes[mesh.elem_nodes[e.elem * width * width + starts[e.side] + k * strides[e.side]]];
      double nearest = 1e300;
      for (const int c : {e.curve, mesh.face.next_in_loop(e.curve), mesh.face.previous_in_loop(e.curve)})
        nearest = std::min(nearest, curve::project(mesh.face.curves[c], x).distance);
      worst = std::max(worst, nearest);
    }
  return worst;
}

double least(const std::vector<double>& values) { return *std::min_element(values.begin(), values.end()); }

TEST(Refine, SquareIsCutIntoEqualSquares) {
  const QuadMesh mesh = refined(hand_made::unit_square(), {0.25, 3, 5e-7});
  EXPECT_EQ(mesh.num_elems(), 16);
  EXPECT_EQ(mesh.nodes.size(), 13u * 13u);
  EXPECT_EQ(mesh.boundary_edges.size(), 16u);
  for (const double bound : mesh.elem_jacobian_bound) EXPECT_NEAR(bound, 1.0 / 64, 1e-12);
  EXPECT_NEAR(least(mesh.elem_scaled_jacobian), 1, 1e-12);
  EXPECT_NEAR(area(mesh), 1, 1e-14);
  EXPECT_EQ(mesh.num_irregular, 0);
}

TEST(Refine, CountsBelongToChords) {
  // L of three unit squares: two chords of two blocks each, none shared by all.
  const QuadMesh mesh = refined(hand_made::l_shape(), {0.5, 1, 5e-7});
  EXPECT_EQ(mesh.num_elems(), 12);
  EXPECT_EQ(mesh.nodes.size(), 21u);
  EXPECT_NEAR(area(mesh), 3, 1e-14);
}

TEST(Refine, SharedNodesAreSharedAndNoTwoCoincide) {
  for (const SeparatrixGraph& graph : {hand_made::l_shape(), hand_made::cut_annulus(1), hand_made::cut_annulus(4)}) {
    const QuadMesh mesh = refined(graph, {0.3, 4, 5e-7});
    std::set<std::pair<double, double>> places;
    for (const Vec2 x : mesh.nodes) places.insert({x.x, x.y});
    EXPECT_EQ(places.size(), mesh.nodes.size());
    // Euler: V - E + F = chi of the face, with edges from their (sorted) corners.
    const int n = mesh.order, width = n + 1;
    std::set<int> vertices;
    std::map<std::pair<int, int>, int> edges;
    for (int e = 0; e < mesh.num_elems(); ++e) {
      const int* ids = &mesh.elem_nodes[e * width * width];
      const std::array<int, 4> c{ids[0], ids[n], ids[width * width - 1], ids[width * n]};
      for (int k = 0; k < 4; ++k) {
        vertices.insert(c[k]);
        ++edges[{std::min(c[k], c[(k + 1) % 4]), std::max(c[k], c[(k + 1) % 4])}];
      }
    }
    const int chi = static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) + mesh.num_elems();
    EXPECT_EQ(chi, mesh.face.euler_characteristic());
    int single = 0;
    for (const auto& [ends, count] : edges) {
      EXPECT_LE(count, 2);
      single += count == 1;
    }
    EXPECT_EQ(single, static_cast<int>(mesh.boundary_edges.size()));
  }
}

TEST(Refine, QuarterAnnulusHasItsAreaAndStaysOnItsArcs) {
  for (const int order : {2, 4, 7}) {
    const RefineOptions options{.size = 2, .order = order, .geometry_tol = 5e-7, .relax = Relax::none};
    const QuadMesh mesh = refined(hand_made::quarter_annulus(), options);
    const double tolerance = options.geometry_tol * mesh.face.diameter;
    EXPECT_LE(boundary_distance(mesh), tolerance) << order;
    EXPECT_NEAR(area(mesh), pi / 4 * 3, 5 * tolerance) << order;
    EXPECT_GT(least(mesh.elem_scaled_jacobian), 0.999) << order;
  }
}

TEST(Refine, SingleCutAnnulusClosesOnItself) {
  const QuadMesh mesh = refined(hand_made::cut_annulus(1), {10.0, 4, 0.1});
  EXPECT_EQ(mesh.num_elems(), 3);
  EXPECT_GT(least(mesh.elem_jacobian_bound), 0);
  const QuadMesh fine = refined(hand_made::cut_annulus(1), {0.2, 4, 5e-7});
  EXPECT_NEAR(area(fine), pi * 0.75, 5e-6);
  EXPECT_LE(boundary_distance(fine), 1e-6);
}

TEST(Refine, JointInsideASideBecomesAVertex) {
  for (const int order : {2, 4, 8}) {
    const RefineOptions options{0.7, order, 5e-7};
    const QuadMesh mesh = refined(hand_made::elbow(), options);
    EXPECT_LE(boundary_distance(mesh), options.geometry_tol * mesh.face.diameter) << order;
    EXPECT_GT(least(mesh.elem_jacobian_bound), 0);
    EXPECT_NEAR(area(mesh), 1 + 0.75 * pi, 2e-5) << order;
  }
}

TEST(Refine, CountsAreRaisedUntilTheToleranceIsMet) {
  const SeparatrixGraph graph = hand_made::quarter_annulus();
  const auto count = [&](double tol) { return refined(graph, {10, 4, tol}).num_elems(); };
  EXPECT_EQ(count(1e-2), 1);
  EXPECT_GT(count(1e-9), count(1e-6));
}

TEST(Refine, MirroredFaceGivesAMirroredMesh) {
  // The S bend is its own image under a half turn; so must its mesh be.
  const QuadMesh mesh = refined(hand_made::s_bend(), {0.45, 4, 5e-7});
  EXPECT_GT(least(mesh.elem_jacobian_bound), 0);
  const Vec2 ends = curve::point(mesh.face.curves[5], mesh.face.curves[5].end()) + mesh.face.joints[0].position;
  for (const Vec2 x : mesh.nodes) {
    double nearest = 1e300;
    for (const Vec2 y : mesh.nodes) nearest = std::min(nearest, distance(ends - x, y));
    EXPECT_LE(nearest, 1e-12);
  }
}

TEST(Refine, BentDuctHasUprightElementsAtEveryOrder) {
  for (const int order : {1, 2, 4, 9}) {
    const RefineOptions options{.order = order, .geometry_tol = 1e-5, .relax = Relax::none};
    EXPECT_GT(least(refined(hand_made::s_bend(), options).elem_scaled_jacobian), 0.95) << order;
  }
}

TEST(Refine, BoundaryEdgesWalkTheLoops) {
  const QuadMesh mesh = refined(hand_made::cut_annulus(4), {0.3, 3, 5e-7});
  const int n = mesh.order, width = n + 1;
  const std::array<int, 4> corners{0, n, width * width - 1, width * n};
  const auto end = [&](const QuadBoundaryEdge& e, int k) {
    return mesh.elem_nodes[e.elem * width * width + corners[(e.side + k) % 4]];
  };
  for (std::size_t k = 1; k < mesh.boundary_edges.size(); ++k)
    if (mesh.boundary_edges[k].curve == mesh.boundary_edges[k - 1].curve) {
      EXPECT_EQ(end(mesh.boundary_edges[k], 0), end(mesh.boundary_edges[k - 1], 1));
    }
}

TEST(Refine, FoldedBlockIsRefusedWithItsPlace) {
  try {
    refined(folded_block(), {0.2, 2, 5e-7});
    FAIL() << "a folded block was accepted";
  } catch (const ComputeError& error) {
    EXPECT_NE(std::string(error.what()).find("block_0"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("("), std::string::npos);
  }
}

/// Distances from the origin of the vertices next to those on curve 1.
std::vector<double> first_row_radii(const QuadMesh& mesh) {
  std::vector<double> radii;
  for (const QuadBoundaryEdge& edge : mesh.boundary_edges)
    if (edge.curve == 1) radii.push_back(norm(mesh.nodes[side_start(mesh, edge.elem, (edge.side + 2) % 4)]));
  return radii;
}

TEST(Refine, RingsMakeTheFirstRowsAroundSmallHolesThin) {
  const SeparatrixGraph graph = hand_made::cut_annulus(4, 0.1);
  RefineOptions options{.size = 0.25, .order = 3, .geometry_tol = 1e-3};
  const QuadMesh with = refined(graph, options);
  options.rings = Rings::none;
  const QuadMesh without = refined(graph, options);
  EXPECT_EQ(with.num_elems(), without.num_elems() + std::ssize(first_row_radii(with)));
  for (const double radius : first_row_radii(with)) EXPECT_LT(radius, 0.2);
  for (const double radius : first_row_radii(without)) EXPECT_GT(radius, 0.25);
  for (const sizing::SizeRule rule : {sizing::SizeRule::nearest, sizing::SizeRule::at_most}) {
    RefineOptions other{.size = 0.25, .order = 3, .geometry_tol = 1e-3, .size_rule = rule};
    const QuadMesh ringed = refined(graph, other);
    other.rings = Rings::none;
    EXPECT_EQ(ringed.num_elems(), refined(graph, other).num_elems());
  }
}

/// Meshes with other counts that are tried on a quarter of an annulus with this inner radius; at least one.
long long num_trials(double inner, double size) {
  Report report;
  const RefineOptions options{.size = size, .order = 3, .geometry_tol = 5e-2};
  refine(block::extract_blocks(hand_made::quarter_annulus(inner), report), options, report);
  for (const auto& [key, value] : report.entries())
    if (key == "count_trials") return std::get<long long>(value);
  return 0;
}

TEST(Refine, NoCountsAreTriedTwice) {
  // Of few elements a quarter is one: the steps of the second kind were tried already.
  EXPECT_EQ(num_trials(0.2, 0.55), 2);
}

TEST(Refine, CountsAreSoughtAgainOnlyAfterSeveralSteps) {
  // That of the mesh, the step that is taken, and one from there; none on the mesh with these counts.
  EXPECT_EQ(num_trials(0.1, 0.55), 3);
}

TEST(Refine, MeshesBeyondMeasureAreRefused) {
  EXPECT_THROW(refined(hand_made::unit_square(), {2e-4, 20, 5e-7}), ComputeError);
}

TEST(Refine, OptionsOutsideTheirIntervalsAreUsageErrors) {
  const SeparatrixGraph graph = hand_made::unit_square();
  EXPECT_THROW(refined(graph, {-1, 4, 5e-7}), UsageError);
  EXPECT_THROW(refined(graph, {0.1, 0, 5e-7}), UsageError);
  EXPECT_THROW(refined(graph, {0.1, 21, 5e-7}), UsageError);
  EXPECT_THROW(refined(graph, {0.1, 4, -1}), UsageError);
}

}  // namespace
}  // namespace quadrille::refine
