#include "curve/select_curves.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "../chart_samples.hpp"
#include "../hand_made.hpp"
#include "../region_samples.hpp"
#include "base/error.hpp"
#include "curve/named_places.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::curve {
namespace {

using Curves = std::vector<int>;

/// The square [0, 10]^2 around a circle of diameter 2 in one curve, one of diameter 4 in two, and half a disc.
CadFace plate() {
  const auto hole = [](Vec2 centre, double r, int pieces) {
    std::vector<Nurbs> loop;
    for (int i = 0; i < pieces; ++i)
      loop.push_back(circular_arc(centre, r, -2 * M_PI * i / pieces, -2 * M_PI * (i + 1) / pieces));
    return loop;
  };
  const std::vector<Nurbs> square{segment({0, 0}, {10, 0}), segment({10, 0}, {10, 10}), segment({10, 10}, {0, 10}),
                                  segment({0, 10}, {0, 0})};
  const std::vector<Nurbs> half{segment({4, 8}, {6, 8}), circular_arc({5, 8}, 1, 0, -M_PI)};
  CadFace face = hand_made::face({square, hole({2, 2}, 1, 1), hole({6, 3}, 2, 2), half}, std::sqrt(200.0));
  face.curve_names = {"south", "east", "north", "west", "bolt", "pin", "pin", "flat", "bow"};
  return face;
}

Curves selected(const CadFace& face, const std::string& text) { return selected_curves(face, text, "--name"); }

TEST(SelectCurves, ByNameAndWildCards) {
  CadFace face = plate();
  EXPECT_EQ(selected(face, "pin"), (Curves{5, 6}));
  EXPECT_EQ(selected(face, "*st"), (Curves{1, 3}));
  EXPECT_EQ(selected(face, "?in"), (Curves{5, 6}));
  EXPECT_EQ(selected(face, "none"), Curves{});
  face.curve_names[2] = "*st";
  EXPECT_EQ(selected(face, "*st"), Curves{2}) << "a curve of this very name comes first";
}

TEST(SelectCurves, CirclesByTheirDiameter) {
  const CadFace face = plate();
  EXPECT_EQ(selected(face, "circles(<3)"), Curves{4});
  EXPECT_EQ(selected(face, "circles(<2)"), Curves{});
  EXPECT_EQ(selected(face, "circles(2)"), Curves{4});
  EXPECT_EQ(selected(face, "circles(>3)"), (Curves{5, 6}));
  EXPECT_EQ(selected(face, "circles()"), (Curves{4, 5, 6}));
}

TEST(SelectCurves, InABoxOfThePlaneOrOfSpace) {
  CadFace face = plate();
  EXPECT_EQ(selected(face, "box(0,0,3.5,5)"), Curves{4});
  EXPECT_EQ(selected(face, "box(10,10,0,0)").size(), 9u) << "the border belongs to it, in whatever order";
  EXPECT_EQ(selected(face, "box(-1,-1,0,11)"), Curves{3});
  face.origin = {100, 0};
  EXPECT_EQ(selected(face, "box(99,-1,100,11)"), Curves{3});
  face.plane_origin = {0, 0, 5};
  EXPECT_EQ(selected(face, "box(99,-1,5,100,11,5)"), Curves{3});
  EXPECT_EQ(selected(face, "box(99,-1,0,100,11,1)"), Curves{});
}

TEST(SelectCurves, OfACurvedFaceInSpace) {
  const CadFace face = samples::sphere_face();
  EXPECT_EQ(selected(face, "box(-2,-2,-2,2,2,2)").size(), static_cast<std::size_t>(face.num_curves()));
  EXPECT_THROW(selected(face, "box(0,0,1,1)"), UsageError);
}

TEST(SelectCurves, ThatContinueACurveWithoutACorner) {
  const std::vector<Nurbs> stadium{segment({0, 0}, {2, 0}), circular_arc({2, 1}, 1, -M_PI / 2, M_PI / 2),
                                   segment({2, 2}, {0, 2}), segment({0, 2}, {0, 0})};
  CadFace face = hand_made::face({stadium}, 3);
  face.curve_names = {"a", "b", "c", "d"};
  for (const char* text : {"tangent(0)", "tangent(1)", "tangent(c)", "tangent(b*)", "tangent(box(1,0,3,2))"})
    EXPECT_EQ(selected(face, text), (Curves{0, 1, 2})) << text;
  EXPECT_EQ(selected(face, "tangent(3)"), Curves{3});
  EXPECT_EQ(selected(face, "tangent(99999999999)"), Curves{});
  EXPECT_EQ(selected(plate(), "tangent(5)"), (Curves{5, 6}));
}

TEST(SelectCurves, ThatContinueACurvePastTheEndOfAnInterface) {
  const CadFace face = samples::two_regions_face();
  EXPECT_EQ(selected(face, "tangent(0)"), (Curves{0, 4})) << "the lower sides of both squares";
  EXPECT_EQ(selected(face, "tangent(1)"), (Curves{1, 7})) << "both sides of the interface";
}

TEST(SelectCurves, RefusesWhatIsNoBoxOrCircle) {
  for (const char* text : {"box(0,0,1)", "box(0,0,1,x)", "circles(<x)", "circles(=2)", "box()", "tangent()"})
    EXPECT_THROW(selected(plate(), text), UsageError) << text;
}

TEST(NamedCurves, APatternMeansTheBoundaryIfAnyOfItFits) {
  EXPECT_EQ(named_curves(plate(), "circles(<3)", "--wall"), Curves{4});
  EXPECT_EQ(named_curves(plate(), "p*", "--wall"), (Curves{5, 6}));
  EXPECT_THROW(named_curves(plate(), "circles(<1)", "--wall"), UsageError);
}

}  // namespace
}  // namespace quadrille::curve
