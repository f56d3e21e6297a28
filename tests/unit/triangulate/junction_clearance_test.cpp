#include "triangulate/junction_clearance.hpp"

#include <gtest/gtest.h>

#include "faces.hpp"

namespace quadrille::triangulate {
namespace {

using namespace testing_faces;

TEST(Clearance, OfASquaresCornerIsTheWayToTheSidesThatDoNotStartThere) {
  const CadFace face = square();
  const Outline outline(face, 1e-13);
  const Clearance clearance(outline);
  for (int j = 0; j < 4; ++j) EXPECT_NEAR(clearance.at_junction(j), 1, 1e-15);
}

TEST(Clearance, SeesAHoleBesideTheCorner) {
  const CadFace face = make_face({polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}), hole({0.5, 0.5}, 0.25)});
  const Outline outline(face, 1e-13);
  EXPECT_NEAR(Clearance(outline).at_junction(0), std::sqrt(0.5) - 0.25, 0.003);
}

TEST(Clearance, SeesTheSameCurveComeBack) {
  // A needle's eye: the arc leaves the corner and returns close to it.
  const double gap = 0.1;
  const Loop loop{curve::circular_arc({0, 0}, 1, gap, 2 * pi - gap), curve::segment(unit(2 * pi - gap), {3, -gap}),
                  curve::segment({3, -gap}, {3, gap}), curve::segment({3, gap}, unit(gap))};
  const CadFace face = make_face({loop});
  const Outline outline(face, 1e-13);
  EXPECT_NEAR(Clearance(outline).at_junction(0), 2 * std::sin(gap), 1e-9);
}

TEST(Clearance, ACurveThatClosesAtTheJunctionIsNoObstacle) {
  // A slit joins two whole circles of radii 1 and 0.5.
  const CadFace face = cut_annulus();
  const Outline outline(face, 1e-13);
  for (int j = 0; j < 4; ++j) EXPECT_NEAR(Clearance(outline).at_junction(j), 0.5, 1e-3) << j;
}

}  // namespace
}  // namespace quadrille::triangulate
