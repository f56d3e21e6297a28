#include "galerkin/solve_phase.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <functional>
#include <numeric>

#include "../triangulate/faces.hpp"
#include "base/error.hpp"
#include "curve/chain.hpp"
#include "field/evaluate.hpp"
#include "galerkin/phase_energy.hpp"
#include "spectral/orthogonal_basis.hpp"
#include "spectral/tri_map.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::galerkin {
namespace {

using namespace testing_faces;
using Complex = std::complex<double>;

Complex complex(Vec2 a) { return {a.x, a.y}; }

// Nodes, poles and mirror images lie as near to the boundary as a tenth of the diameter.
triangulate::TriangulateOptions small_elements(const CadFace& face, double share) {
  triangulate::TriangulateOptions options;
  options.size = share * face.diameter;
  return options;
}

// A face with its mesh and the phase of order 12 on it.
class Solved {
 public:
  Solved(const CadFace& face, const PhaseNodes& nodes, const std::vector<int>& winding_offsets = {}, double share = 0.1)
      : mesh(triangulate::triangulate(face, small_elements(face, share), report_)),
        asked(nodes),
        field(solve_phase(mesh, std::vector<int>(mesh.num_elems(), 12), asked, winding_offsets, report_)),
        solution(field.phase),
        evaluator_(std::make_unique<field::FieldEvaluator>(field)) {}

  // Of v, in (-pi, pi].
  double phase(int elem, Vec2 xi, Vec2& x) const {
    Mat2 dx_dxi;
    return angle_of(evaluator_->value(elem, xi, x, dx_dxi));
  }
  double phase(Vec2 x) const {
    Vec2 value;
    EXPECT_TRUE(evaluator_->value_at(x, value)) << x.x << ", " << x.y;
    return angle_of(value);
  }
  // Calls f(x, phi) at points of all elements, edges and vertices included.
  void for_points(const std::function<void(Vec2, double)>& f) const {
    for (int e = 0; e < mesh.num_elems(); ++e) {
      for (const Vec2 xi : spectral::tri_nodes(5)) {
        Vec2 x;
        const double phi = phase(e, xi, x);
        f(x, phi);
      }
    }
  }
  double error(const std::function<double(Vec2)>& exact) const {
    double worst = 0;
    for_points([&](Vec2 x, double phi) {
      for (const PhaseNode& node : asked.nodes) {
        if (distance(x, node.position) < 1e-6) return;  // no value there
      }
      for (const CornerAngle& corner : solution.terms.corner_angles) {
        if (distance(x, corner.apex) < 1e-6) return;
      }
      worst = std::max(worst, std::abs(wrap_pi(phi - exact(x))));
    });
    return worst;
  }
  // How often phi turns on the way from angle a to b about a point.
  double turning(Vec2 centre, double radius, double a, double b) const {
    constexpr int steps = 200;
    double sum = 0, last = phase(centre + radius * unit(a));
    for (int i = 1; i <= steps; ++i) {
      const double here = phase(centre + radius * unit(a + (b - a) * i / steps));
      sum += wrap_pi(here - last);
      last = here;
    }
    return sum;
  }
  // Greatest |phi - 4 theta_t| modulo whole turns at points inside the boundary's edges, beyond what the rounding of a
  // point does to its direction from a corner.
  double misalignment() const {
    double worst = 0;
    for (const BoundaryEdge& edge : mesh.boundary_edges) {
      const Nurbs& curve = mesh.face.curves[edge.curve];
      const curve::ArcLength length(curve);
      const double begin = length.at(edge.t0), end = length.at(edge.t1);
      for (const double f : {0.1, 0.33, 0.5, 0.8}) {
        const double t = length.parameter(begin + f * (end - begin));
        Vec2 x;
        const double phi = phase(edge.elem, spectral::tri_edge_point(edge.edge, f), x);
        const double error = std::abs(wrap_pi(phi - 4 * angle_of(curve::tangent(curve, t))));
        const double to_corner = std::min(distance(x, curve.poles.front()), distance(x, curve.poles.back()));
        worst = std::max(worst, error - 4e-15 * mesh.face.diameter / to_corner);
      }
    }
    return worst;
  }
  void expect_indices() const {
    for (const PhaseNode& node : asked.nodes)
      EXPECT_NEAR(turning(node.position, 1e-3 * mesh.face.diameter, 0, 2 * pi), 2 * pi * (4 - node.valence), 1e-9);
  }
  // Along an arc about a corner of straight sides phi turns by 4 omega - 2 pi V.
  void expect_corner_valences(double tol) const {
    for (const CornerValence& corner : asked.corners) {
      const Joint& joint = mesh.face.joints[corner.joint];
      const double slack = 1e-7, from = joint.tangent_out + slack, to = from + joint.interior_angle - 2 * slack;
      const double turn = turning(joint.position, 1e-4 * mesh.face.diameter, from, to);
      EXPECT_NEAR((4 * joint.interior_angle - turn) / (2 * pi), corner.valence, tol) << "joint " << corner.joint;
    }
  }

 private:
  Report report_;

 public:
  TriMesh mesh;
  PhaseNodes asked;
  Field field;
  const PhaseForm& solution;

 private:
  std::unique_ptr<field::FieldEvaluator> evaluator_;
};

// arg of the product of (z - a)(1 - conj(a) z).
double disc_phase(const std::vector<PhaseNode>& nodes, Vec2 x) {
  Complex product = 1;
  for (const PhaseNode& node : nodes) {
    const Complex a = complex(node.position), z = complex(x);
    product *= (z - a) * (1.0 - std::conj(a) * z);
  }
  return std::arg(product);
}

CadFace disc() { return make_face({circle({0, 0}, 1)}); }

PhaseNodes scattered_nodes() {
  return {{{{0.5, 0.1}, 3}, {{-0.2, 0.45}, 3}, {{-0.55, -0.2}, 3}, {{0.1, -0.6}, 3}}, {}, {}};
}

TEST(SolvePhase, OnTheDiscIsTheClosedForm) {
  const Solved disc_solved(disc(), scattered_nodes());
  EXPECT_LT(disc_solved.error([&](Vec2 x) { return disc_phase(disc_solved.asked.nodes, x); }), 1e-10);
  EXPECT_LT(disc_solved.misalignment(), 1e-10);
  disc_solved.expect_indices();
}

TEST(SolvePhase, OnTheHalfDiscIsTheClosedFormOfNodesAndMirrorImages) {
  const PhaseNodes asked{{{{0.4, 0.45}, 3}, {{-0.5, 0.5}, 3}}, {{0, 1}, {1, 1}}, {}};
  const Solved half(half_disc(), asked);
  std::vector<PhaseNode> all = asked.nodes;
  for (const PhaseNode& node : asked.nodes) all.push_back({{node.position.x, -node.position.y}, node.valence});
  EXPECT_LT(half.error([&](Vec2 x) { return disc_phase(all, x); }), 1e-10);
  EXPECT_TRUE(half.solution.terms.corner_angles.empty());
  half.expect_indices();
}

TEST(SolvePhase, OnTheAnnulusIsTheClosedFormForEveryHoleWinding) {
  for (const int m : {0, 1, -2}) {
    const Solved ring(annulus(), {}, {m});
    const auto exact = [m](Vec2 x) { return 4 * angle_of(x) + 2 * pi * m * std::log(norm(x)) / std::log(0.5); };
    EXPECT_LT(ring.error(exact), 1e-10) << m;
    // int |grad w|^2 = 2 pi / ln(R / r0), so the energy is 2 pi^2 m^2 times that, the period of lambda 2 pi K m / 4.
    const double k = 2 * pi / std::log(2.0);
    EXPECT_NEAR(ring.solution.hole_winding_energy, 2 * pi * pi * m * m * k, 1e-8);
    EXPECT_NEAR(ring.solution.hole_periods.at(0), pi * k * m / 2, 1e-9);
    EXPECT_NEAR(ring.solution.best_hole_winding.at(0), ring.solution.hole_winding.at(0) - m, 1e-10);
  }
}

TEST(SolvePhase, OnAPolygonHasTheCornerValencesChosen) {
  // Angles of 63, 117, 90 and 90 degrees; valence 2 at two obtuse corners, 1 and 0 else, a node of valence 5.
  const PhaseNodes asked{{{{1.2, 0.9}, 5}, {{0.8, 1.1}, 3}}, {{0, 0}, {1, 1}, {2, 2}, {3, 1}}, {}};
  const Solved plate(make_face({polygon({{0, 0}, {2, 0.2}, {2.3, 2}, {0.4, 1.7}})}), asked);
  plate.expect_indices();
  plate.expect_corner_valences(1e-3);
  EXPECT_LT(plate.misalignment(), 1e-8);
}

TEST(SolvePhase, OnAPlateWithAHoleKeepsNodesAndAlignment) {
  const CadFace face = make_face({polygon({{-2, -1}, {2, -1}, {2, 1}, {-2, 1}}), hole({0.1, 0.05}, 0.4)});
  PhaseNodes asked{{}, {{0, 1}, {1, 1}, {2, 1}, {3, 1}}, {}};
  for (int k = 0; k < 4; ++k) asked.nodes.push_back({Vec2{0.1, 0.05} + 0.65 * unit(pi / 4 + half_pi * k), 5});
  const Solved plate(face, asked, {}, 0.03);
  plate.expect_indices();
  plate.expect_corner_valences(1e-6);
  EXPECT_LT(plate.misalignment(), 1e-8);
  EXPECT_LE(std::abs(plate.solution.hole_winding.at(0) - plate.solution.best_hole_winding.at(0)), 0.5);
}

TEST(SolvePhase, AroundATriangularHoleIsSingleValued) {
  const CadFace face =
      make_face({polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}), polygon({{1.5, 1.2}, {1.8, 2.5}, {2.9, 1.7}})});
  const PhaseNodes asked{{{{3, 3}, 3}}, {{0, 1}, {1, 1}, {2, 1}, {3, 1}, {4, 4}, {5, 3}, {6, 4}}, {}};
  const Solved plate(face, asked, {}, 0.05);
  plate.expect_indices();
  plate.expect_corner_valences(1e-3);
  EXPECT_LT(plate.misalignment(), 1e-8);
}

TEST(SolvePhase, FollowsNodesNearTheBoundary) {
  // Far nearer than elements are small, beside straight sides, round holes and arcs.
  const CadFace face = make_face({{curve::segment({-2, -1}, {2, -1}), curve::circular_arc({2, 0}, 1, -half_pi, half_pi),
                                   curve::segment({2, 1}, {-2, 1}), curve::segment({-2, 1}, {-2, -1})},
                                  hole({0.3, 0.1}, 0.4)});
  for (const double depth : {1e-2, 1e-3, 1e-5}) {
    const PhaseNodes asked{{{{-0.5, -1 + depth}, 3},
                            {Vec2{2, 0} + (1 - depth) * unit(0.4), 3},
                            {Vec2{0.3, 0.1} + (0.4 + depth) * unit(2.2), 5},
                            {{0.9, 0.5}, 5},
                            {{-1.2, 0.1}, 5},
                            {{1.6, -0.3}, 5}},
                           {{0, 1}, {3, 1}},
                           {}};
    const Solved plate(face, asked, {}, 0.25);
    EXPECT_LT(plate.misalignment(), 1e-6) << depth;
    for (const PhaseNode& node : asked.nodes)
      EXPECT_NEAR(plate.turning(node.position, 0.3 * depth, 0, 2 * pi), 2 * pi * (4 - node.valence), 1e-9);
  }
}

TEST(SolvePhase, TakesANodeOnASmoothBoundaryPoint) {
  PhaseNodes asked = scattered_nodes();
  asked.nodes.push_back({{0.1, 0.2}, 3});
  asked.boundary_nodes.push_back({0, half_pi, 3});
  const Solved with(disc(), asked);
  EXPECT_NEAR(with.turning({0, 1}, 1e-3, -1e-2, -pi + 1e-2), 2 * pi, 0.1);  // clockwise through the inside: 6 pi - 4 pi
  // On |z| = 1 the product of a node is z / |z|, and (z - c)^-2 is -conj(c z) but for its size: c = i.
  const auto exact = [&](Vec2 x) {
    return disc_phase(asked.nodes, x) - 2 * std::arg(complex(x) - Complex(0, 1)) - half_pi;
  };
  EXPECT_LT(with.error(exact), 1e-9);
}

TEST(SolvePhase, TurnsWithTheFace) {
  const double angle = radians(37);
  const CadFace face = make_face({polygon({{-2, -1}, {2, -1}, {2, 1}, {-2, 1.3}}), hole({0.3, 0.05}, 0.4)});
  PhaseNodes asked{{}, {{0, 1}, {1, 1}, {2, 1}, {3, 1}}, {}};
  for (int k = 0; k < 4; ++k) asked.nodes.push_back({Vec2{0.3, 0.05} + 0.65 * unit(0.9 + half_pi * k), 5});
  const Vec2 shift{30, -20};
  const auto move = [&](Vec2 x) {
    return Vec2{std::cos(angle) * x.x - std::sin(angle) * x.y, std::sin(angle) * x.x + std::cos(angle) * x.y} + shift;
  };
  PhaseNodes turned = asked;
  for (PhaseNode& node : turned.nodes) node.position = move(node.position);
  const Solved there(moved(face, 1, angle, shift), turned);
  const Solved here(face, asked);
  double worst = 0;
  here.for_points([&](Vec2 x, double phi) {
    const double f = 1 - 1e-6;  // off the corners
    if (distance(x, {0.3, 0.05}) > 0.41)
      worst = std::max(worst, std::abs(wrap_pi(there.phase(move(f * x)) - 4 * angle - here.phase(f * x))));
    (void)phi;
  });
  EXPECT_LT(worst, 1e-8);
  EXPECT_NEAR(there.solution.hole_periods.at(0), here.solution.hole_periods.at(0), 1e-8);
}

TEST(SolvePhase, ASolverReusedGivesTheSameBits) {
  Report report;
  const CadFace face =
      make_face({circle({0, 0}, 1), hole({-0.4, 0}, 0.1), hole({0.4, 0.1}, 0.15), hole({0, 0.5}, 0.1)});
  const TriMesh mesh = triangulate::triangulate(face, {}, report);
  const std::vector<int> low(mesh.num_elems(), 5), high(mesh.num_elems(), 9);
  PhaseNodes first, second;
  for (int k = 0; k < 8; ++k) {
    first.nodes.push_back({0.8 * unit(k + 0.1), 5});
    second.nodes.push_back({0.75 * unit(k + 0.3), 5});
  }
  PhaseSolver solver(mesh, low, 2);
  const Field a = solver.solve(first, {}, report), b = solver.solve(second, {1, 0, -1}, report);
  solver.set_orders(high);
  const Field c = solver.solve(first, {}, report);
  EXPECT_EQ(a.phase.s, solve_phase(mesh, low, first, report).phase.s);
  EXPECT_EQ(b.phase.s, solve_phase(mesh, low, second, {1, 0, -1}, report).phase.s);
  EXPECT_EQ(c.phase.s, solve_phase(mesh, high, first, report).phase.s);
  EXPECT_EQ(c.phase.hole_winding, a.phase.hole_winding);
  EXPECT_GT(b.phase.hole_winding_energy, 1);
  const PhaseEnergy energy = PhaseSolver(mesh, high).energy(first), same = solver.energy(first);
  EXPECT_EQ(energy.value, same.value);
}

TEST(SolvePhase, EnergiesAreThoseOfTheNodesOrdersAndWindingAskedFor) {
  Report report;
  const TriMesh mesh = triangulate::triangulate(annulus(), {}, report);
  const std::vector<int> low(mesh.num_elems(), 4), high(mesh.num_elems(), 6);
  const auto nodes = [](double radius) {
    return PhaseNodes{{{radius * unit(0.3), 3}, {radius * unit(2.4), 5}}, {}, {}};
  };
  const auto fresh = [&](const std::vector<int>& orders, double radius, int offset) {
    return PhaseSolver(mesh, orders).energy(nodes(radius), {offset}).value;
  };
  PhaseSolver solver(mesh, low);
  const auto known = [&](double radius, int offset) { return solver.energy(nodes(radius), {offset}).value; };
  EXPECT_EQ(known(0.7, 0), fresh(low, 0.7, 0));
  EXPECT_EQ(known(0.7, 0), fresh(low, 0.7, 0));
  EXPECT_EQ(known(0.7, 1), fresh(low, 0.7, 1));
  EXPECT_EQ(known(0.8, 1), fresh(low, 0.8, 1));
  solver.set_orders(high);
  EXPECT_EQ(known(0.8, 1), fresh(high, 0.8, 1));
  EXPECT_NE(fresh(low, 0.8, 1), fresh(high, 0.8, 1));
}

TEST(SolvePhase, HarmonicPartsHaveTheOrdersOfTheSolver) {
  Report report;
  const TriMesh mesh = triangulate::triangulate(annulus(), {}, report);
  PhaseSolver solver(mesh, std::vector<int>(mesh.num_elems(), 4));
  const PhaseNodes nodes{{{{0.7, 0}, 3}, {{0, 0.7}, 5}}, {}, {}};
  const double before = solver.energy(nodes).value;
  const std::vector<field::LiftedData> constant{{[](int, double) { return Vec2{1, 2}; }, {}}};
  for (const int order : {4, 6}) {
    solver.set_orders(std::vector<int>(mesh.num_elems(), order));
    const std::vector<field::HarmonicPart> parts = solver.harmonic_parts(constant);
    ASSERT_EQ(parts.size(), 1u);
    const std::vector<int>& num_modes = parts[0].num_modes;
    EXPECT_EQ(num_modes.size(), static_cast<std::size_t>(mesh.num_elems()));
    EXPECT_EQ(parts[0].u.size(), static_cast<std::size_t>(std::accumulate(num_modes.begin(), num_modes.end(), 0)));
    EXPECT_LE(*std::max_element(num_modes.begin(), num_modes.end()), spectral::num_tri_modes(order));
  }
  solver.set_orders(std::vector<int>(mesh.num_elems(), 4));
  EXPECT_EQ(solver.energy(nodes).value, before);
}

TEST(SolvePhase, RefusesOffsetsThatDoNotFitTheHoles) {
  Report report;
  const TriMesh mesh = triangulate::triangulate(disc(), {}, report);
  EXPECT_THROW(solve_phase(mesh, std::vector<int>(mesh.num_elems(), 4), scattered_nodes(), {1}, report), UsageError);
}

}  // namespace
}  // namespace quadrille::galerkin
