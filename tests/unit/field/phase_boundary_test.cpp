#include "field/phase_boundary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <string>

#include "../support/texts.hpp"
#include "../triangulate/faces.hpp"
#include "base/angle.hpp"
#include "base/angle_sum.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::field {
namespace {

using namespace testing_faces;

struct Followed {
  LoopAngles start, end;
  std::vector<AnglePiece> pieces;
};

// The first curve of the face, which is closed, followed once.
Followed follow_circle(const CadFace& face, const std::vector<TurnCentre>& centres) {
  Followed f;
  f.start = f.end = angles_at_start(face, centres, 0);
  follow_angles(face, centres, 0, face.curves[0].begin(), face.curves[0].end(), f.end, f.pieces);
  return f;
}

CadFace disc() { return make_face({circle({0, 0}, 1)}); }

TEST(FollowedAngles, OfACircleTurnOnceForTheTangentAndForWhatIsInside) {
  const CadFace face = disc();
  const Followed f =
      follow_circle(face, {{{0.2, 0}, 1, -1}, {(1 - 1e-7) * unit(2.0), 1, -1}, {(1 + 1e-7) * unit(2.0), 1, 0}});
  EXPECT_NEAR(f.end.tangent - f.start.tangent, 2 * pi, 1e-12);
  EXPECT_NEAR(f.end.centres[0] - f.start.centres[0], 2 * pi, 1e-12);
  EXPECT_NEAR(f.end.centres[1] - f.start.centres[1], 2 * pi, 1e-12);
  EXPECT_NEAR(f.end.centres[2] - f.start.centres[2], 0, 1e-12);
}

TEST(FollowedAngles, EndWithTheTangentWhereAKnotIsNear) {
  // A small circle far from the origin: near a knot, the last poles of the trimmed curve nearly coincide.
  const CadFace face = make_face({circle({150, 45}, 0.3)});
  const Nurbs& curve = face.curves[0];
  for (const double knot : curve.knots) {
    const double t = knot + 1e-6;
    if (t >= curve.end()) continue;
    LoopAngles angles = angles_at_start(face, {}, 0);
    std::vector<AnglePiece> pieces;
    follow_angles(face, {}, 0, curve.begin(), t, angles, pieces);
    EXPECT_NEAR(wrap_pi(angles.tangent - angle_of(curve::tangent(curve, t, true))), 0, 1e-14) << t;
  }
}

TEST(FollowedAngles, DifferFromReferencesByLessThanAQuarterTurn) {
  const CadFace face = disc();
  const Vec2 near_rim = (1 - 1e-4) * unit(2.0);
  const Followed f = follow_circle(face, {{near_rim, 1, -1}});
  const Nurbs& curve = face.curves[0];
  EXPECT_EQ(f.pieces.back().t1, curve.end());
  for (std::size_t i = 0; i < f.pieces.size(); ++i) {
    const AnglePiece& piece = f.pieces[i];
    EXPECT_EQ(piece.t0, i == 0 ? curve.begin() : f.pieces[i - 1].t1);
    for (int k = 0; k <= 10; ++k) {
      const double t = piece.t0 + (piece.t1 - piece.t0) * k / 10;
      EXPECT_LT(std::abs(wrap_pi(angle_of(curve::tangent(curve, t)) - piece.reference.tangent)), half_pi);
      EXPECT_LT(std::abs(wrap_pi(angle_of(curve::point(curve, t) - near_rim) - piece.reference.centres[0])), half_pi);
    }
  }
}

TEST(FollowedAngles, SumTheTurnsAboutAllCentres) {
  const CadFace face = disc();
  const std::vector<TurnCentre> centres{{{0.3, 0.2}, 3, -1}, {{-0.7, 0.1}, -2, -1}, {{0.1, -0.4}, 0, -1}};
  const Followed f = follow_circle(face, centres);
  for (const AnglePiece& piece : f.pieces) {
    for (const std::size_t num_points : {1, 5, AngleSums::width, AngleSums::width + 3}) {
      std::vector<Vec2> x;
      for (double k = 0.5; k < static_cast<double>(num_points); ++k)
        x.push_back(
            curve::point(face.curves[0], piece.t0 + (piece.t1 - piece.t0) * k / static_cast<double>(num_points)));
      std::vector<double> sums(num_points + 1, -7);
      piece.sums_of_turns(centres, x, sums.data());
      for (std::size_t k = 0; k < num_points; ++k) {
        double sum = 0;
        for (std::size_t i = 0; i < centres.size(); ++i)
          sum += centres[i].turns * nearest_branch(piece.reference.centres[i], angle_of(x[k] - centres[i].position));
        EXPECT_NEAR(sums[k], sum, 1e-13);
      }
      EXPECT_EQ(sums.back(), -7);
    }
  }
}

TEST(FollowedAngles, FindThePieceOfAParameter) {
  const std::vector<AnglePiece> pieces{{0, 1, {}, {}}, {1, 2, {}, {}}, {2, 4, {}, {}}};
  EXPECT_EQ(&piece_at(pieces, 0, false), &pieces[0]);
  EXPECT_EQ(&piece_at(pieces, 1, false), &pieces[1]);
  EXPECT_EQ(&piece_at(pieces, 1, true), &pieces[0]);
  EXPECT_EQ(&piece_at(pieces, 3, false), &pieces[2]);
  EXPECT_EQ(&piece_at(pieces, 4, true), &pieces[2]);
}

std::string refusal_of_centres(const CadFace& face, const std::vector<TurnCentre>& centres) {
  return message_of<ComputeError>([&] { follow_circle(face, centres); });
}

TEST(FollowedAngles, RefuseNodesOnTheBoundaryAndCusps) {
  EXPECT_NE(refusal_of_centres(disc(), {{unit(1.0), 1, -1}}).find("the irregular node near (0.54"), std::string::npos);
  CadFace face = disc();
  Nurbs there_and_back;  // a parabola that runs to (1/3, 0) and back on the same line
  there_and_back.degree = 2;
  there_and_back.knots = {0, 0, 0, 1, 1, 1};
  there_and_back.poles = {{0, 0}, {1, 0}, {-1, 0}};
  there_and_back.weights = {1, 1, 1};
  face.curves[0] = there_and_back;
  EXPECT_NE(refusal_of_centres(face, {}).find("cusp near (0.333333, "), std::string::npos)
      << refusal_of_centres(face, {});
}

TEST(FollowedAngles, TakeTheNearestBranch) {
  EXPECT_NEAR(nearest_branch(4 * pi, 0.1), 4 * pi + 0.1, 1e-14);
  EXPECT_NEAR(nearest_branch(-3, 3), 3 - 2 * pi, 1e-14);
  EXPECT_EQ(round_to_turns(-4 * pi + 0.3), -2);
}
using Complex = std::complex<double>;

Complex complex(Vec2 a) { return {a.x, a.y}; }

double at(const Nurbs& curve, double f) { return curve.begin() * (1 - f) + curve.end() * f; }

std::string refusal(const CadFace& face, const PhaseNodes& asked) {
  return message_of<ComputeError>([&] { const PhaseBoundary boundary(face, asked); });
}

PhaseNodes four_nodes(double radius, double turn) {
  PhaseNodes asked;
  for (int k = 0; k < 4; ++k) asked.nodes.push_back({radius * unit(turn + half_pi * k), 3});
  return asked;
}

// A quadrilateral with a triangular and a round hole: angles of all kinds, valences that sum to 4 chi = -4.
CadFace two_holes() {
  return make_face(
      {polygon({{0, 0}, {5, 0.3}, {4, 3}, {0.5, 4}}), polygon({{1, 1}, {1.4, 2}, {2, 1.2}}), hole({3, 1.7}, 0.5)});
}

PhaseNodes asked_of_two_holes() {
  return {{{{2.6, 0.6}, 5}, {{2.2, 2.6}, 3}, {{3.9, 2.4}, 6}},
          {{0, 1}, {1, 0}, {2, 2}, {3, 1}, {4, 4}, {5, 3}, {6, 4}},
          {{7, 2.0, 3}}};
}

TEST(PhaseBoundary, RefusesAnImpossibleIndexSumWithTheArithmetic) {
  PhaseNodes asked = four_nodes(0.5, 0);
  asked.nodes.pop_back();
  const std::string message = refusal(disc(), asked);
  EXPECT_NE(message.find("3 interior nodes is 3"), std::string::npos) << message;
  EXPECT_NE(message.find("needs 4"), std::string::npos) << message;
  EXPECT_NE(refusal(annulus(), four_nodes(0.7, 0)).find("1 hole needs 0"), std::string::npos);
  EXPECT_EQ(refusal(disc(), four_nodes(0.5, 0)), "");
}

TEST(PhaseBoundary, RefusesNodesThatAreNotInside) {
  PhaseNodes asked{{{{0.75, 0}, 3}, {{0, 0.75}, 5}}, {}, {}};
  EXPECT_EQ(refusal(annulus(), asked), "");
  asked.nodes[0].position = {0.2, 0};
  EXPECT_NE(refusal(annulus(), asked).find("(0.2, 0) is in a hole"), std::string::npos);
  asked.nodes[0].position = {1.5, 0};
  EXPECT_NE(refusal(annulus(), asked).find("(1.5, 0) is outside"), std::string::npos);
  asked.nodes[0].position = unit(1.0);
  EXPECT_NE(refusal(annulus(), asked).find("on the boundary"), std::string::npos);
  asked.nodes[0].position = (1 - 1e-7) * unit(1.0);
  EXPECT_EQ(refusal(annulus(), asked), "");
}

TEST(PhaseBoundary, RefusesCornersThatDoNotExistOrTwice) {
  EXPECT_NE(refusal(square(), {{}, {{0, 1}, {1, 1}, {2, 1}, {4, 1}}, {}}).find("corner 4"), std::string::npos);
  EXPECT_NE(refusal(square(), {{}, {{0, 1}, {1, 1}, {2, 1}, {2, 1}}, {}}).find("twice"), std::string::npos);
  EXPECT_NE(refusal(square(), {{{{0.5, 0.5}, 4}}, {{0, 0}, {1, 1}, {2, 1}}, {{3, 7.0, 2}}}).find("not on curve 3"),
            std::string::npos);
}

TEST(PhaseBoundary, OfASquareWithRightCornersIsConstant) {
  const CadFace face = square();
  const PhaseBoundary boundary(face, {{}, {{0, 1}, {1, 1}, {2, 1}, {3, 1}}, {}});
  EXPECT_TRUE(boundary.terms().corner_angles.empty());
  for (int c = 0; c < 4; ++c) {
    for (const double f : {0.0, 0.3, 1.0}) EXPECT_NEAR(boundary.remainder(c, at(face.curves[c], f)), 0, 1e-14);
  }
}

class DiscNodes : public testing::TestWithParam<double> {};

// phi = sum arg((z - a)(1 - conj(a) z)), so that g + sum arg(z - a*) = sum arg(1 - conj(a) z) but for whole turns.
TEST_P(DiscNodes, LeaveTheirMirrorImages) {
  const CadFace face = disc();
  const PhaseNodes asked = four_nodes(GetParam(), 0.3);
  const PhaseBoundary boundary(face, asked);
  double constant = 0;
  for (const PhaseTurn& image : boundary.terms().images) constant += std::arg(-complex(image.position));
  const auto difference = [&](double t) {
    const Complex z = complex(curve::point(face.curves[0], t));
    double g = boundary.remainder(0, t) + constant;
    for (const PhaseTurn& image : boundary.terms().images) g += std::arg(1.0 - z / complex(image.position));
    for (const PhaseNode& node : asked.nodes) g -= std::arg(1.0 - std::conj(complex(node.position)) * z);
    return g;
  };
  const double start = difference(0);
  EXPECT_NEAR(std::remainder(start, 2 * pi), 0, 1e-12);
  // Nodes as near as 1e-6 to the rim, steps of 6e-3: unwrapping along the steps alone would lose turns.
  for (int i = 0; i <= 1000; ++i) EXPECT_NEAR(difference(at(face.curves[0], i / 1000.0)), start, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Radii, DiscNodes, testing::Values(0.0, 0.5, 0.9, 0.999, 1 - 1e-6));

TEST(PhaseBoundary, IsFourTimesTheTangentAngleModuloWholeTurns) {
  const CadFace face = two_holes();
  const PhaseBoundary boundary(face, asked_of_two_holes());
  for (int c = 0; c < face.num_curves(); ++c) {
    for (const double f : {0.0, 0.01, 0.37, 0.8, 1.0}) {
      const double t = at(face.curves[c], f);
      EXPECT_NEAR(wrap_pi(boundary.phase(c, t) - 4 * angle_of(curve::tangent(face.curves[c], t, f == 1))), 0, 1e-12);
    }
  }
}

TEST(PhaseBoundary, JumpsByTheValencesChosen) {
  const CadFace face = two_holes();
  const PhaseNodes asked = asked_of_two_holes();
  const PhaseBoundary boundary(face, asked);
  for (const CornerValence& corner : asked.corners) {
    if (corner.joint == 0 || corner.joint == 4) continue;  // where the loop closes, the whole turn comes in
    const Nurbs& before = face.curves[face.previous_in_loop(corner.joint)];
    const double in = boundary.phase(corner.joint - 1, before.end());
    const double out = boundary.phase(corner.joint, face.curves[corner.joint].begin());
    EXPECT_NEAR(out - in, 2 * pi * corner.valence - 4 * face.joints[corner.joint].interior_angle, 1e-12);
  }
  // V = 3 inside a smooth curve: 6 pi - 4 pi.
  EXPECT_NEAR(boundary.phase(7, 2.0 + 1e-9) - boundary.phase(7, 2.0 - 1e-9), 2 * pi, 1e-7);
}

TEST(PhaseBoundary, TurnsByTheIndexOfEachLoop) {
  const CadFace face = two_holes();
  const PhaseBoundary boundary(face, asked_of_two_holes());
  const std::vector<int> index_of_corners{4, -5, -1};
  for (int l = 0; l < 3; ++l) {
    const int first = face.loop_offsets[l], last = face.loop_offsets[l + 1] - 1;
    const double in = boundary.phase(last, face.curves[last].end());
    const double out = boundary.phase(first, face.curves[first].begin());
    const int valence = l == 0 ? 1 : l == 1 ? 4 : 2;
    const double jump = 2 * pi * valence - 4 * face.joints[first].interior_angle;
    EXPECT_NEAR(in + jump - out, (l == 0 ? 8 : -8) * pi - 2 * pi * index_of_corners[l], 1e-11);
  }
}

TEST(PhaseBoundary, LeavesContinuousDataOnEveryLoop) {
  const CadFace face = two_holes();
  const PhaseBoundary boundary(face, asked_of_two_holes());
  for (int c = 0; c < face.num_curves(); ++c) {
    const Nurbs& curve = face.curves[c];
    EXPECT_EQ(boundary.remainder(c, curve.end()),
              boundary.remainder(face.next_in_loop(c), face.curves[face.next_in_loop(c)].begin()));
    double last = boundary.remainder(c, curve.begin());
    for (int i = 1; i <= 20000; ++i) {
      const double g = boundary.remainder(c, at(curve, i / 20000.0));
      ASSERT_LT(std::abs(g - last), 1e-2) << "curve " << c << " at " << i;
      last = g;
    }
    for (const double near : {1e-9, 1 - 1e-9}) {
      EXPECT_NEAR(boundary.remainder(c, at(curve, near)), boundary.remainder(c, at(curve, std::round(near))), 1e-5);
    }
  }
  EXPECT_NEAR(boundary.remainder(7, 2.0 - 1e-9), boundary.remainder(7, 2.0), 1e-5);
  EXPECT_NEAR(boundary.remainder(7, 2.0 + 1e-9), boundary.remainder(7, 2.0), 1e-5);
}

TEST(PhaseBoundary, ABoundaryNodeAtTheEndOfACurveIsACorner) {
  const CadFace face = make_face({{curve::circular_arc({0, 0}, 1, 0, pi), curve::circular_arc({0, 0}, 1, pi, 2 * pi)}});
  PhaseNodes asked = four_nodes(0.5, 0.2);
  asked.nodes.push_back({{0, 0}, 3});
  PhaseNodes other = asked;
  asked.corners.push_back({1, 3});
  other.boundary_nodes.push_back({0, face.curves[0].end(), 3});
  const PhaseBoundary a(face, asked), b(face, other);
  for (int c = 0; c < 2; ++c) {
    for (const double f : {0.0, 0.4, 1.0})
      EXPECT_EQ(a.remainder(c, at(face.curves[c], f)), b.remainder(c, at(face.curves[c], f)));
  }
  ASSERT_EQ(a.terms().corner_angles.size(), 1u);
  EXPECT_NEAR(a.terms().corner_angles[0].beta, -2, 1e-12);
}

}  // namespace
}  // namespace quadrille::field
