#include "field/followed_angles.hpp"

#include <gtest/gtest.h>

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

std::string refusal(const CadFace& face, const std::vector<TurnCentre>& centres) {
  return message_of<ComputeError>([&] { follow_circle(face, centres); });
}

TEST(FollowedAngles, RefuseNodesOnTheBoundaryAndCusps) {
  EXPECT_NE(refusal(disc(), {{unit(1.0), 1, -1}}).find("the irregular node near (0.54"), std::string::npos);
  CadFace face = disc();
  Nurbs there_and_back;  // a parabola that runs to (1/3, 0) and back on the same line
  there_and_back.degree = 2;
  there_and_back.knots = {0, 0, 0, 1, 1, 1};
  there_and_back.poles = {{0, 0}, {1, 0}, {-1, 0}};
  there_and_back.weights = {1, 1, 1};
  face.curves[0] = there_and_back;
  EXPECT_NE(refusal(face, {}).find("cusp near (0.333333, "), std::string::npos) << refusal(face, {});
}

TEST(FollowedAngles, TakeTheNearestBranch) {
  EXPECT_NEAR(nearest_branch(4 * pi, 0.1), 4 * pi + 0.1, 1e-14);
  EXPECT_NEAR(nearest_branch(-3, 3), 3 - 2 * pi, 1e-14);
  EXPECT_EQ(round_to_turns(-4 * pi + 0.3), -2);
}

}  // namespace
}  // namespace quadrille::field
