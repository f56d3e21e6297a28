#include "triangulate/corner_fans.hpp"

#include <gtest/gtest.h>

#include "faces.hpp"

namespace quadrille::triangulate {
namespace {

using namespace testing_faces;

struct Planned {
  explicit Planned(CadFace f, const TriangulateOptions& options = {})
      : face(std::move(f)), outline(face, 1e-13), fit(outline, 8) {
    fans = plan_fans(fit, options, {face.diameter / 4, radians(40.0), 1e-12 * face.diameter});
  }
  CadFace face;
  Outline outline;
  EdgeFit fit;
  std::vector<Fan> fans;
};

TEST(CornerFans, ASquareNeedsNone) { EXPECT_TRUE(Planned(square()).fans.empty()); }

TEST(CornerFans, ACircleNeedsNoneAtItsSeam) { EXPECT_TRUE(Planned(annulus()).fans.empty()); }

TEST(CornerFans, AnLNeedsOneAtItsReflexCorner) {
  const Planned l(l_shape());
  ASSERT_EQ(l.fans.size(), 1u);
  EXPECT_EQ(l.fans[0].junction, 3);
  EXPECT_EQ(l.fans[0].num_sectors, 5);
  EXPECT_EQ(l.fans[0].radii.size(), 8u);
}

TEST(CornerFans, AStadiumNeedsOneAtEachTangentJunction) {
  const Planned s(stadium());
  ASSERT_EQ(s.fans.size(), 4u);
  for (const Fan& fan : s.fans) {
    EXPECT_EQ(fan.num_sectors, 3);
    EXPECT_NEAR(fan.radius, s.fans[0].radius, 1e-12);
  }
}

TEST(CornerFans, RadiiFallByTheFactor) {
  TriangulateOptions options;
  options.fan_factor = 0.25;
  options.fan_layers = 4;
  const Planned h(half_disc(), options);
  ASSERT_EQ(h.fans.size(), 2u);
  for (const Fan& fan : h.fans) {
    ASSERT_EQ(fan.radii.size(), 5u);
    for (std::size_t i = 1; i < fan.radii.size(); ++i) EXPECT_NEAR(fan.radii[i - 1] / fan.radii[i], 0.25, 1e-15);
  }
}

TEST(CornerFans, SideVerticesLieOnTheirCurvesAtTheRingsDistance) {
  const Planned h(half_disc());
  for (const Fan& fan : h.fans) {
    const int out = fan.junction, in = 1 - out;
    for (std::size_t i = 0; i < fan.radii.size(); ++i) {
      const Vec2 apex = h.outline.junctions()[fan.junction].position;
      EXPECT_NEAR(distance(apex, h.outline.at(out, fan.t_out[i])), fan.radii[i], 1e-15);
      EXPECT_NEAR(distance(apex, h.outline.at(in, fan.t_in[i])), fan.radii[i], 1e-15);
    }
  }
}

TEST(CornerFans, BuiltFanHasItsTrianglesAndEdges) {
  Planned h(half_disc());
  Draft draft;
  Fan& fan = h.fans[0];
  build_fans(h.outline, std::span(h.fans).first(1), draft);
  const int rings = static_cast<int>(fan.radii.size()), sectors = fan.num_sectors;
  EXPECT_EQ(draft.vertices.size(), static_cast<std::size_t>(1 + rings * (sectors + 1)));
  EXPECT_EQ(draft.triangles.size(), static_cast<std::size_t>(sectors * (2 * rings - 1)));
  EXPECT_EQ(draft.edges.size(), static_cast<std::size_t>(2 * rings));
  EXPECT_EQ(fan.rim.size(), static_cast<std::size_t>(sectors + 1));
  for (const auto& [a, b, c] : draft.triangles)
    EXPECT_GT(cross(draft.vertices[b] - draft.vertices[a], draft.vertices[c] - draft.vertices[a]), 0);
  EXPECT_EQ(*std::max_element(draft.layers.begin(), draft.layers.end()), rings - 1);
  EXPECT_EQ(std::count(draft.layers.begin(), draft.layers.end(), 0), sectors);
}

TEST(CornerFans, ASharpCornerIsProtectedByASingleRing) {
  const Planned thin(make_face({polygon({{0, 0}, {1, -0.1}, {1, 0.1}})}), [] {
    TriangulateOptions options;
    options.fan_layers = 0;
    return options;
  }());
  ASSERT_FALSE(thin.fans.empty());
  EXPECT_EQ(thin.fans[0].junction, 0);
  EXPECT_EQ(thin.fans[0].radii.size(), 1u);
}

TEST(CornerFans, TheTipOfABodyIsProtectedWhereASlitMeetsIt) {
  // A wedge of 23 degrees, or of 90, with a wake to the right side of a box: two corners of the face at its tip.
  TriangulateOptions options;
  options.fan_layers = 0;
  const auto with_wake = [&](double half_width) {
    CadFace face = make_face({polygon(
        {{0, -2}, {4, -2}, {4, 0}, {2, 0}, {1, -half_width}, {1, half_width}, {2, 0}, {4, 0}, {4, 2}, {0, 2}})});
    pair_sides(face, 2, 6);
    return Planned(face, options);
  };
  const auto junctions = [](const Planned& planned) {
    std::vector<int> numbers;
    for (const Fan& fan : planned.fans) numbers.push_back(fan.junction);
    return numbers;
  };
  const Planned thin = with_wake(0.2);
  ASSERT_EQ(junctions(thin), (std::vector<int>{3, 6}));
  EXPECT_EQ(thin.fans[0].radii.size(), 1u);
  EXPECT_EQ(thin.fans[0].radii, thin.fans[1].radii);
  EXPECT_EQ(junctions(with_wake(1)), (std::vector<int>{4, 5})) << "its front corners of 45 degrees";
}

TEST(CornerFans, BetweenTheSectorsOfARegionThatTouchesItselfAnAcuteAngleIsProtected) {
  TriangulateOptions options;
  options.fan_layers = 0;
  // Two triangles of 53 degrees are left out of the square: sectors of 127 degrees.
  const Planned thin(make_face({polygon({{2, -2}, {2, 2}, {-2, 2}, {-2, -2}}),
                                polygon({{0, 0}, {-1, -0.5}, {-1, 0.5}, {0, 0}, {1, 0.5}, {1, -0.5}})}),
                     options);
  std::vector<int> junctions;
  for (const Fan& fan : thin.fans)
    if (distance(thin.outline.junctions()[fan.junction].position, {0, 0}) == 0) junctions.push_back(fan.junction);
  EXPECT_EQ(junctions, (std::vector<int>{4, 7}));
  EXPECT_EQ(thin.fans[0].radii, thin.fans[1].radii);
}

TEST(CornerFans, RadiiKeepAwayFromOtherParts) {
  const Planned l(make_face({polygon({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}), hole({0.8, 0.8}, 0.1)}));
  ASSERT_EQ(l.fans.size(), 1u);
  EXPECT_LE(l.fans[0].radius, (std::sqrt(0.08) - 0.1) / 3 * 1.01);
}

// A strip between the x axis and an arc of radius 1 that rises from (0, 0) at this angle.
CadFace strip_below_arc(double angle) {
  const Vec2 centre{-std::sin(angle), std::cos(angle)};
  const double end = -half_pi + angle + 0.5;
  const Vec2 top = centre + unit(end);
  return make_face({{curve::segment({0, 0}, {top.x, 0}), curve::segment({top.x, 0}, top),
                     curve::circular_arc(centre, 1, end, -half_pi + angle)}});
}

TEST(CornerFans, CurvesTurnByAtMostTheAngleOfTheirCorner) {
  for (const double angle : {0.1, 0.01, 0.001}) {
    const Planned strip(strip_below_arc(angle));
    ASSERT_FALSE(strip.fans.empty());
    EXPECT_EQ(strip.fans[0].junction, 0);
    EXPECT_LE(strip.fit.turn(2, strip.fans[0].t_in.back(), strip.face.curves[2].end()), angle * 1.01);
    EXPECT_GE(strip.fans[0].radius, angle / 2);
  }
}

TEST(CornerFans, RingsAreLargerThanRounding) {
  // A step of 7e-6 diameters between a straight side and an arc.
  const CadFace face =
      make_face({{curve::segment({0, 0}, {100, 0}), curve::segment({100, 0}, {100, 100}),
                  curve::segment({100, 100}, {40, 100}), curve::segment({40, 100}, {40, 100.001}),
                  curve::circular_arc({0, 100.001}, 40, 0, half_pi), curve::segment({0, 140.001}, {0, 0})}});
  const Planned spur(face);
  ASSERT_FALSE(spur.fans.empty());
  for (const Fan& fan : spur.fans) EXPECT_GE(fan.radii.front(), 1e-11 * face.diameter);
}

}  // namespace
}  // namespace quadrille::triangulate
