#include "guide/find_critical_points.hpp"

#include <gtest/gtest.h>

#include <complex>

#include "../support/polygon_field.hpp"
#include "../support/square_field.hpp"
#include "../support/texts.hpp"
#include "base/error.hpp"
#include "field/explicit_value.hpp"
#include "guide/valence.hpp"

namespace quadrille::guide {
namespace {

using Complex = std::complex<double>;
using Function = std::function<Vec2(Vec2)>;

Vec2 as_vec(Complex z) { return {z.real(), z.imag()}; }
Complex as_complex(Vec2 x) { return {x.x, x.y}; }

/// Product of (z - root), conjugated roots with index -1.
Function product(std::vector<Complex> positive, std::vector<Complex> negative = {}) {
  return [=](Vec2 x) {
    Complex value = 1;
    for (const Complex root : positive) value *= as_complex(x) - root;
    for (const Complex root : negative) value *= std::conj(as_complex(x) - root);
    return as_vec(value);
  };
}

struct Search {
  explicit Search(const Field& field, const SearchOptions& options = {}) {
    points = find_critical_points(field::FieldEvaluator(field), options, report);
  }
  long long count(const std::string& key) const {
    for (const auto& [name, value] : report.entries())
      if (name == key) return std::get<long long>(value);
    return -1;
  }
  Report report;
  CriticalPoints points;
};

const SearchOptions sharp{0, 0, 1e-14};  // no clusters, nothing absorbed

CriticalPoints points_of(const Function& f, int order, int n, const SearchOptions& options = {}) {
  return Search(interpolated_field(square_mesh({-1, -1}, 2, n), order, f), options).points;
}

std::vector<CriticalPoint> zeros(const Function& f, int order, int n = 2) {
  return points_of(f, order, n, sharp).critical_points;
}

void expect_points(const std::vector<CriticalPoint>& points, const std::vector<Vec2>& places,
                   const std::vector<int>& indices, double tol = 1e-13) {
  ASSERT_EQ(points.size(), places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_NEAR(distance(points[i].position, places[i]), 0, tol);
    EXPECT_EQ(points[i].index, indices[i]);
    EXPECT_EQ(points[i].valence, 4 - indices[i]);
  }
}

TEST(FindCriticalPoints, proves_a_constant_field_empty_with_one_cell_an_element) {
  const Search search(interpolated_field(square_mesh({0, 0}, 1, 3), 4, [](Vec2) { return Vec2{0.6, 0.8}; }));
  EXPECT_TRUE(search.points.critical_points.empty());
  EXPECT_EQ(search.count("proof.cells_examined"), 18);
  EXPECT_EQ(search.count("proof.cells_excluded"), 18);
}

TEST(FindCriticalPoints, tells_the_two_signs_apart) {
  expect_points(zeros(product({{0.31, -0.17}}), 1), {{0.31, -0.17}}, {1});
  expect_points(zeros(product({}, {{0.31, -0.17}}), 1), {{0.31, -0.17}}, {-1});
}

TEST(FindCriticalPoints, records_element_reference_point_and_jacobian) {
  const Field field = interpolated_field(square_mesh({-1, -1}, 2, 2), 3, product({{0.3, 0.2}, {-0.5, 0.7}}));
  const field::FieldEvaluator evaluator(field);
  for (const CriticalPoint& p : Search(field).points.critical_points) {
    const field::FieldSample s = evaluator.sample(p.elem, p.xi);
    EXPECT_NEAR(distance(s.x, p.position), 0, 1e-14);
    EXPECT_NEAR(norm(s.value), 0, 1e-14);
    EXPECT_EQ(p.jacobian[0], s.dv_dx.xx);
    EXPECT_EQ(p.jacobian[3], s.dv_dx.yy);
  }
}

TEST(FindCriticalPoints, finds_many_zeros_in_one_element) {
  // All below the diagonal of a single square: one element.
  expect_points(zeros(product({{0.1, -0.5}, {0.4, -0.8}, {0.8, 0.3}, {0.55, -0.1}}), 6, 1),
                {{0.1, -0.5}, {0.4, -0.8}, {0.55, -0.1}, {0.8, 0.3}}, {1, 1, 1, 1});
}

TEST(FindCriticalPoints, finds_pairs_of_opposite_index) {
  const auto pair = [](Vec2 x) { return Vec2{x.x * x.x - 0.09, x.y - 0.4}; };
  expect_points(zeros(pair, 2), {{-0.3, 0.4}, {0.3, 0.4}}, {-1, 1});
  expect_points(zeros(pair, 2, 1), {{-0.3, 0.4}, {0.3, 0.4}}, {-1, 1});
}

TEST(FindCriticalPoints, finds_a_close_pair) {
  const double d = 1e-4;
  expect_points(zeros(product({{0.2 - d, 0.3}, {0.2 + d, 0.3}}), 8), {{0.2 - d, 0.3}, {0.2 + d, 0.3}}, {1, 1}, 1e-10);
  expect_points(zeros(
                    [&](Vec2 x) {
                      return Vec2{x.x * x.x - d * d, x.y - 0.4};
                    },
                    8),
                {{-d, 0.4}, {d, 0.4}}, {-1, 1}, 1e-10);
}

TEST(FindCriticalPoints, counts_a_zero_on_an_edge_once) {
  for (const Vec2 x : {Vec2{0, 0.3}, Vec2{-0.6, 0}, Vec2{0.25, 0.25}, Vec2{-0.7, -0.7}}) {
    const std::vector<CriticalPoint> points = zeros(product({as_complex(x)}, {{3, 0}}), 5);
    expect_points(points, {x}, {1});
  }
}

TEST(FindCriticalPoints, counts_a_zero_on_a_vertex_once_and_names_the_lowest_element) {
  const std::vector<CriticalPoint> points = zeros(product({}, {{0, 0}}), 4);
  expect_points(points, {{0, 0}}, {-1});
  EXPECT_EQ(points[0].elem, 0);  // the centre vertex of the 2 x 2 squares
}

TEST(FindCriticalPoints, a_zero_beyond_the_domain_is_none) {
  EXPECT_TRUE(zeros(product({{1 + 1e-6, 0.2}}), 3).empty());
  EXPECT_EQ(zeros(product({{1 - 1e-6, 0.2}}), 3).size(), 1u);
}

TEST(FindCriticalPoints, sorts_by_x_then_y_with_tolerance) {
  const std::vector<CriticalPoint> points =
      zeros(product({{0.3 + 1e-8, -0.4}, {0.3, 0.4}, {-0.5, 0.1 + 1e-9}, {-0.5 + 1e-8, -0.1}}), 5);
  expect_points(points, {{-0.5, -0.1}, {-0.5, 0.1}, {0.3, -0.4}, {0.3, 0.4}}, {1, 1, 1, 1}, 1e-7);
}

TEST(FindCriticalPoints, searches_curved_elements) {
  // y -> y + (1 - x^2)(1 - y^2) / 8 keeps the square's vertices; a quadratic field of it has degree 8 on an element.
  TriMesh mesh = square_mesh({-1, -1}, 2, 2);
  mesh.order = 4;
  const auto bend = [](Vec2 p) { return p + Vec2{0, (1 - p.x * p.x) * (1 - p.y * p.y) / 8}; };
  const std::vector<spectral::TriMap> straight = mesh::tri_maps(square_mesh({-1, -1}, 2, 2));
  for (Vec2& v : mesh.vertices) v = bend(v);
  for (int e = 0; e < mesh.num_elems(); ++e) {
    mesh.curved_elems.push_back(e);
    for (const Vec2 xi : spectral::tri_nodes(4)) mesh.curved_nodes.push_back(bend(straight[e].position(xi)));
  }
  const Field field = interpolated_field(mesh, 8, product({{0.3, 0.2}, {-0.4, 0.1}}));
  expect_points(Search(field).points.critical_points, {{-0.4, 0.1}, {0.3, 0.2}}, {1, 1});
}

TEST(FindCriticalPoints, encloses_liftings) {
  // u vanishes on the circle through apex, pole and x*, v on a line through x*: they meet once in the square.
  const Vec2 at{0.35, 0.2};
  const Lifting lifting{0, {-1, -1}, {-1.5, -1.5}, {1, 0}};
  const double angle = field::lifting_angle(lifting, at);
  Field field = interpolated_field(square_mesh({-1, -1}, 2, 2), 3, [&](Vec2 x) {
    return Vec2{-angle, x.x - at.x + x.y - at.y};
  });
  field.liftings = {lifting};
  const Search search(field);
  ASSERT_EQ(search.points.critical_points.size(), 1u);
  EXPECT_NEAR(distance(search.points.critical_points[0].position, at), 0, 1e-13);
  EXPECT_LT(search.count("proof.cells_examined"), 400);
}

TEST(FindCriticalPoints, excludes_the_cells_at_a_corner_whose_chord_misses_zero) {
  // The value jumps at the corner (-1,-1) from one side of the square to the other, past 0 at a distance.
  Field field = interpolated_field(square_mesh({-1, -1}, 2, 1), 3, [](Vec2) { return Vec2{1, 0.2}; });
  field.liftings = {{0, {-1, -1}, {-2, -2}, {-2 / half_pi, 0}}};
  EXPECT_TRUE(Search(field).points.critical_points.empty());
}

TEST(FindCriticalPoints, tells_a_pair_a_millionth_apart) {
  const double d = 1e-6;
  expect_points(zeros(product({{0.2, 0.3}, {0.2 + d, 0.3}}), 4), {{0.2, 0.3}, {0.2 + d, 0.3}}, {1, 1}, 1e-8);
  expect_points(zeros(product({{0, 0.3}, {d, 0.3}}), 4), {{0, 0.3}, {d, 0.3}}, {1, 1}, 1e-8);  // beside an edge
}

TEST(FindCriticalPoints, a_multiple_zero_is_a_cluster_with_its_place_and_index) {
  const Complex a{0.25, -0.5};
  const auto expect_cluster = [&](const Function& f, int index) {
    for (const int n : {1, 2, 3}) {
      const CriticalPoints points = points_of(f, 8, n);
      EXPECT_TRUE(points.critical_points.empty());
      ASSERT_EQ(points.clusters.size(), 1u);
      EXPECT_EQ(points.clusters[0].index, index);
      EXPECT_NEAR(distance(points.clusters[0].centre, as_vec(a)), 0, 1e-12);
      EXPECT_EQ(points.index_sum, index_sum_with_clusters(points));
      EXPECT_EQ(points.index_sum, 4 + index);  // and four corners of valence 1
    }
  };
  expect_cluster(product({a, a, a, a}), 4);
  expect_cluster(product({a, a}), 2);
  expect_cluster(product({}, {a, a}), -2);
  expect_cluster(product({}, {a, a, a}), -3);
}

TEST(FindCriticalPoints, the_centre_of_a_split_zero_is_that_of_the_multiple_one) {
  // z^4 + e, e of the size of a field's error, splits by e^(1/4); the linear term moves the centroid by nothing.
  const Complex a{0.05, 0.1};
  const auto split = [&](Vec2 x) {
    return as_vec(std::pow(as_complex(x) - a, 4) + Complex(1e-12, 3e-12) * (1.0 + 2.0 * as_complex(x)));
  };
  for (const SearchOptions& options : {SearchOptions{}, SearchOptions{2e-3, 0, 1e-14}}) {
    const CriticalPoints points = points_of(split, 6, 3, options);
    ASSERT_EQ(points.clusters.size(), 1u);
    EXPECT_EQ(points.clusters[0].index, 4);
    EXPECT_NEAR(distance(points.clusters[0].centre, as_vec(a)), 0, 1e-11);
  }
  EXPECT_EQ(points_of(split, 6, 3, sharp).critical_points.size(), 4u);
}

TEST(FindCriticalPoints, zeros_nearer_than_the_cluster_distance_are_one_cluster) {
  const double d = 0.01;
  const auto pair = [&](Vec2 x) {
    const double y = x.y - 0.4;
    return Vec2{x.x * x.x - y * y - d * d / 4, 2 * x.x * y};
  };
  const double diameter = std::sqrt(8.0);
  EXPECT_TRUE(points_of(pair, 4, 2, {0.99 * d / diameter, 0, 1e-10}).clusters.empty());
  const CriticalPoints points = points_of(pair, 4, 2, {d / diameter, 0, 1e-10});  // equal counts as nearer
  ASSERT_EQ(points.clusters.size(), 1u);
  const Cluster& cluster = points.clusters[0];
  EXPECT_EQ(cluster.index, 2);
  EXPECT_EQ(cluster.members.size(), 2u);
  EXPECT_EQ(cluster.member_indices.size(), 2u);
  EXPECT_NEAR(distance(cluster.centre, {0, 0.4}), 0, 1e-12);
  EXPECT_NEAR(cluster.radius, d / 2, 1e-12);
  EXPECT_EQ(points.zeros.size(), 2u);
  EXPECT_TRUE(points.critical_points.empty());
}

TEST(FindCriticalPoints, zeros_of_opposite_index_cancel_if_they_are_far_from_the_boundary) {
  const auto clusters_of = [](double gap, double cluster_distance) {  // the boundary is at a distance of 1
    const auto pair = [&](Vec2 x) { return Vec2{x.x * x.x - gap * gap / 4, x.y}; };
    return points_of(pair, 4, 2, {cluster_distance, 0, 1e-10}).clusters;
  };
  const double nearest = 0.4 / 1.2;  // a gap of 0.4 of the distance from either zero to the boundary
  ASSERT_EQ(clusters_of(nearest, 1e-3).size(), 1u);
  EXPECT_EQ(clusters_of(nearest, 1e-3)[0].index, 0);
  EXPECT_TRUE(clusters_of(1.01 * nearest, 1e-3).empty());
  EXPECT_TRUE(clusters_of(nearest, 0).empty());
}

TEST(FindCriticalPoints, zeros_that_an_analytic_part_outweighs_are_its_zeros) {
  // conj(z)^4 + a z: a zero of index 1, and five of index -1 at |z|^3 = a, where |z|^4 outweighs a |z| outside.
  const auto clusters_of = [](double a) {
    const auto w = [a](Vec2 x) {
      const std::complex<double> z(x.x, x.y), value = std::pow(std::conj(z), 4) + a * z;
      return Vec2{value.real(), value.imag()};
    };
    return points_of(w, 4, 4, {1e-3, 0, 1e-10}).clusters;
  };
  ASSERT_EQ(clusters_of(std::pow(0.39, 3)).size(), 1u);
  const Cluster cluster = clusters_of(std::pow(0.39, 3))[0];
  EXPECT_EQ(cluster.index, -4);
  EXPECT_EQ(cluster.members.size(), 6u);
  EXPECT_TRUE(cluster.is_far_from_boundary);
  EXPECT_NEAR(norm(cluster.centre), 0, 1e-9);
  EXPECT_TRUE(clusters_of(std::pow(0.41, 3)).empty());  // from 0 the boundary is at a distance of 1
}

TEST(FindCriticalPoints, a_corner_absorbs_what_is_near_only_if_its_blocks_stay_admissible) {
  // At a right angle |V - 1| <= 0.75 leaves no other valence.
  const CriticalPoints points = points_of(product({{-0.999, -0.999}}), 2, 2);
  EXPECT_EQ(points.critical_points.size(), 1u);
  EXPECT_TRUE(points.changes.empty());
}

TEST(FindCriticalPoints, the_certificate_holds_what_the_search_did) {
  const CriticalPoints points = points_of(product({{0.31, -0.17}, {-0.5, 0.2}}), 3, 2);
  const Certificate& c = points.certificate;
  EXPECT_EQ(c.elements, 8);
  EXPECT_GE(c.cells_examined, c.cells_excluded + c.cells_isolated);
  ASSERT_EQ(c.cells.size(), 2u);
  for (const CertificateCell& cell : c.cells) {
    EXPECT_EQ(cell.verdict, CellVerdict::zero);
    const auto& v = cell.vertices;
    const Vec2 p0{v[0], v[1]}, p1{v[2], v[3]}, p2{v[4], v[5]};
    EXPECT_GT(cross(p1 - p0, p2 - p0), 0);
    const auto is_left = [](Vec2 a, Vec2 b, Vec2 x) { return cross(b - a, x - a) > -1e-9; };
    EXPECT_TRUE(std::any_of(points.critical_points.begin(), points.critical_points.end(), [&](const CriticalPoint& p) {
      return is_left(p0, p1, p.position) && is_left(p1, p2, p.position) && is_left(p2, p0, p.position);
    }));
  }
}

TEST(SearchOptions, lie_in_their_intervals) {
  EXPECT_NO_THROW(SearchOptions{}.validate());
  EXPECT_THROW((SearchOptions{-1e-3, 0, 1e-10}.validate()), UsageError);
  EXPECT_THROW((SearchOptions{0, 0.2, 1e-10}.validate()), UsageError);
  EXPECT_THROW((SearchOptions{0, 0, 1e-15}.validate()), UsageError);
}

TEST(FindCriticalPoints, gives_up_on_a_curve_of_zeros) {
  const auto crease = [](Vec2 x) { return Vec2{x.x - 0.3, 0}; };
  EXPECT_PRED2(contains, message_of<ComputeError>([&] { points_of(crease, 4, 2); }), "on a whole curve");
}

TEST(FindCriticalPoints, corners_of_a_square_close_the_index_sum) {
  const Search search(interpolated_field(square_mesh({0, 0}, 1, 1), 1, [](Vec2) { return Vec2{1, 0}; }));
  ASSERT_EQ(search.points.corners.size(), 4u);
  for (int j = 0; j < 4; ++j) {
    EXPECT_EQ(search.points.corners[j].joint, j);
    EXPECT_EQ(search.points.corners[j].valence, 1);
    EXPECT_EQ(search.points.corners[j].curves, (std::array<int, 2>{(j + 3) % 4, j}));
  }
  EXPECT_EQ(search.points.index_sum, 4);
  EXPECT_EQ(search.points.index_sum_expected, 4);
  EXPECT_NO_THROW(require_index_sum(search.points, CadFace()));
}

/// Hand-made zeros beside the corner of 135 degrees at the lower left of a square: only places and indices count.
struct AbsorbTest : testing::Test {
  Field field = interpolated_field(square_mesh({0, 0}, 1, 1), 1, [](Vec2) { return Vec2{1, 0}; });
  field::FieldEvaluator evaluator{field};
  CriticalPoints points;
  std::vector<Corner>& corners = points.corners;
  std::vector<NodeChange>& changes = points.changes;

  AbsorbTest() { corners = {{0, {0, 0}, 135, 2, {3, 0}}, {1, {1, 0}, 90, 1, {0, 1}}}; }

  static zeros::FoundZero zero(Vec2 x, int index) {
    zeros::FoundZero result;
    result.x = x;
    result.index = index;
    return result;
  }
  std::vector<bool> absorb(const std::vector<zeros::FoundZero>& zeros, double length = 0.01) {
    return absorb_into_corners(field.mesh.face, zeros, length, points);
  }
};

TEST_F(AbsorbTest, a_node_within_the_length_goes_into_the_valence_and_is_told) {
  EXPECT_EQ(absorb({zero({0.006, 0.008}, 1)}), std::vector<bool>{true});  // exactly as far as the length
  EXPECT_EQ(corners[0].valence, 1);
  EXPECT_EQ(corners[0].source, NodeSource::absorb);
  ASSERT_EQ(changes.size(), 1u);
  const NodeChange& change = changes[0];
  EXPECT_EQ(change.kind, ChangeKind::absorb);
  ASSERT_EQ(change.before.size(), 2u);
  EXPECT_EQ(change.before[0].valence, 2);
  EXPECT_EQ(change.before[0].location, NodeLocation::corner);
  EXPECT_EQ(change.before[1].valence, 3);
  EXPECT_EQ(change.before[1].location, NodeLocation::inside);
  ASSERT_EQ(change.after.size(), 1u);
  EXPECT_EQ(change.after[0].valence, 1);
}

TEST_F(AbsorbTest, one_beyond_or_with_a_valence_that_is_not_admissible_stays) {
  EXPECT_EQ(absorb({zero({0.007, 0.008}, 1)}), std::vector<bool>{false});
  EXPECT_EQ(absorb({zero({0.001, 0.001}, -1)}), std::vector<bool>{false});  // would be 3 at 135 degrees
  EXPECT_EQ(absorb({zero({0.999, 0.001}, 1)}), std::vector<bool>{false});   // would be 0 at a right angle
  EXPECT_EQ(absorb({zero({0.001, 0.001}, 1)}, 0), std::vector<bool>{false});
  EXPECT_TRUE(changes.empty());
  EXPECT_EQ(corners[0].valence, 2);
}

TEST_F(AbsorbTest, nodes_as_near_go_together_or_not_at_all) {
  EXPECT_EQ(absorb({zero({0.001, 0.002}, 1), zero({0.002, 0.001}, 1)}), (std::vector<bool>{false, false}));
  EXPECT_EQ(absorb({zero({0.001, 0.002}, 1), zero({0.003, 0.001}, -1)}), (std::vector<bool>{true, true}));
  EXPECT_EQ(corners[0].valence, 2);
  EXPECT_EQ(changes.size(), 2u);
}

TEST_F(AbsorbTest, a_node_as_near_to_two_corners_goes_to_neither) {
  corners[1].angle_degrees = 135;
  corners[1].valence = 2;
  EXPECT_EQ(absorb({zero({0.5, 0.001}, 1)}, 0.6), std::vector<bool>{false});
  EXPECT_EQ(absorb({zero({0.499, 0.001}, 1)}, 0.6), std::vector<bool>{true});
  EXPECT_EQ(corners[0].valence, 1);
}

TEST(Absorb, the_length_alone_decides_beside_a_corner_near_a_tie) {
  const double excess = 1e-4;  // off 135 degrees
  const Field field =
      adapted_field(polygon_face({{0, 0}, {2, 0}, {2, 0.7}, {1.7, 0.7 + 0.3 * std::tan(pi / 4 + excess)}, {0, 1.4}}));
  const field::FieldEvaluator evaluator(field);
  Report report;
  const CriticalPoints free = find_critical_points(evaluator, {0, 0, 1e-10}, report);
  ASSERT_EQ(free.critical_points.size(), 1u);
  EXPECT_EQ(free.corners[2].valence, 2);
  EXPECT_EQ(free.corners[2].source, NodeSource::angle);
  EXPECT_TRUE(free.zeros.empty());
  const double share = distance(free.critical_points[0].position, {2, 0.7}) / field.mesh.face.diameter;
  for (const double length : {0.99 * share, 1.01 * share}) {
    const CriticalPoints points = find_critical_points(evaluator, {0, length, 1e-10}, report);
    const bool absorbed = length > share;
    EXPECT_EQ(points.corners[2].valence, absorbed ? 1 : 2);
    EXPECT_EQ(points.critical_points.size(), absorbed ? 0u : 1u);
    EXPECT_EQ(points.zeros.size(), absorbed ? 1u : 0u);
    EXPECT_EQ(points.changes.size(), absorbed ? 1u : 0u);
    EXPECT_EQ(points.index_sum, 4);
  }
}

}  // namespace
}  // namespace quadrille::guide
