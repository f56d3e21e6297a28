#include "field/explicit_value.hpp"

#include <gtest/gtest.h>

#include "base/angle.hpp"

namespace quadrille::field {
namespace {

// The apex at the origin, the pole straight below it: the domain above.
Lifting lifting() {
  Lifting l;
  l.apex = {0, 0};
  l.pole = {0, -1};
  return l;
}

TEST(Lifting, AngleIsTheOneUnderWhichTheApexAndThePoleAreSeen) {
  EXPECT_NEAR(lifting_angle(lifting(), {0, 5}), 0, 1e-15);
  EXPECT_NEAR(lifting_angle(lifting(), {1, 0}), -pi / 4, 1e-15);
  EXPECT_NEAR(lifting_angle(lifting(), {-1, 0}), pi / 4, 1e-15);
  EXPECT_NEAR(lifting_angle(lifting(), {-0.5, -0.5}), half_pi, 1e-15);
}

TEST(Lifting, GradientIsTheSlopeOfTheAngle) {
  const double h = 1e-6;
  for (const Vec2 x : {Vec2{0.7, 0.3}, Vec2{-2, 1}, Vec2{0.1, 0.05}}) {
    const auto slope = [&](Vec2 step) {
      return (lifting_angle(lifting(), x + step) - lifting_angle(lifting(), x - step)) / (2 * h);
    };
    const Vec2 gradient = lifting_gradient(lifting(), x);
    EXPECT_NEAR(gradient.x, slope({h, 0}), 1e-8);
    EXPECT_NEAR(gradient.y, slope({0, h}), 1e-8);
  }
}

TEST(Lifting, AngleAtTheApexIsTheLimitAlongADirection) {
  for (const double angle : {0.1, 1.0, 2.0, 3.0})
    EXPECT_NEAR(lifting_angle_at_apex(lifting(), unit(angle)), lifting_angle(lifting(), 1e-10 * unit(angle)), 1e-9);
  EXPECT_NEAR(lifting_angle_at_apex(lifting(), {1, 0}), -half_pi, 1e-15);
}

const PhaseTerms terms{{{{0.2, 0.1}, 1}, {{-0.4, 0.3}, -1}, {{0.7, -0.2}, 2}},
                       {{{5, 5}, 3}, {{-4, 2}, 0}},
                       {{{-3, -3}, -1}},
                       {{{-1, -1}, {-2, -2.5}, -2.0 / 3}, {{1, 1}, {1.5, 1.7}, 1.25}}};

TEST(PhaseTerms, TurnOnceForEachIndexRoundItsNode) {
  const auto turns_round = [](Vec2 centre) {
    double sum = 0;
    for (int i = 0; i < 100; ++i) {
      const Vec2 a = centre + 0.01 * unit(2 * pi * i / 100), b = centre + 0.01 * unit(2 * pi * (i + 1) / 100);
      sum += wrap_pi(explicit_phase(terms, b) - explicit_phase(terms, a));
    }
    return sum / (2 * pi);
  };
  for (const PhaseTurn& node : terms.nodes) EXPECT_NEAR(turns_round(node.position), node.turns, 1e-12);
  EXPECT_NEAR(turns_round({0.5, 0.5}), 0, 1e-12);
  EXPECT_NEAR(turns_round({5, 5}), 3, 1e-12);
}

TEST(PhaseTerms, TheDirectionIsThatOfThePhase) {
  for (int i = 0; i < 50; ++i) {
    const Vec2 x = 0.9 * unit(0.37 * i) * (1 - 0.01 * i);
    EXPECT_LT(distance(explicit_direction(terms, x, {}), unit(explicit_phase(terms, x))), 1e-14);
  }
  const CornerAngle& corner = terms.corner_angles[0];
  for (const double angle : {0.0, 0.3, 1.1, half_pi}) {
    const Vec2 x = corner.apex;
    EXPECT_LT(
        distance(explicit_direction(terms, x, x + 0.2 * unit(angle)), unit(explicit_phase(terms, x, unit(angle)))),
        1e-14);
  }
}

TEST(PhaseTerms, ThePhaseIsTheSumOfPrincipalValues) {
  PhaseTerms many;
  for (int i = 0; i < 60; ++i) many.nodes.push_back({unit(0.4 * i) * (1 + 0.1 * i), i % 13 - 6});
  many.nodes.push_back({{-3, 0}, 2});
  for (const Vec2 x : {Vec2{0.1, 0.3}, Vec2{-4, 0}, Vec2{-2, 0.5}, many.nodes[7].position}) {
    double sum = 0;
    for (const PhaseTurn& turn : many.nodes) sum += turn.turns * angle_of(x - turn.position);
    EXPECT_NEAR(explicit_phase(many, x), sum, 1e-12);
  }
}

TEST(PhaseTerms, ManyTurnsStayInTheRangeOfNumbers) {
  for (const double unit_length : {1e-30, 1e30}) {
    PhaseTerms many;
    for (int i = 0; i < 200; ++i) many.holes.push_back({unit_length * Vec2{1.0 + i, 2.0}, 4});
    const Vec2 x{0, unit_length};
    EXPECT_LT(distance(explicit_direction(many, x, {}), unit(explicit_phase(many, x))), 1e-11);
  }
}

TEST(PhaseTerms, GradientMatchesDifferences) {
  const Vec2 x{0.4, 0.6};
  const double h = 1e-5;
  const Vec2 gradient = explicit_phase_gradient(terms, x);
  const auto difference = [&](Vec2 d) {
    return wrap_pi(explicit_phase(terms, x + d) - explicit_phase(terms, x - d)) / (2 * h);
  };
  EXPECT_NEAR(gradient.x, difference({h, 0}), 1e-8);
  EXPECT_NEAR(gradient.y, difference({0, h}), 1e-8);
}

TEST(PhaseTerms, AtAnApexTakeTheLimitAlongTheDirection) {
  const CornerAngle& corner = terms.corner_angles[0];
  for (const double angle : {0.0, 0.3, 1.1, half_pi}) {
    const Vec2 inward = unit(angle);
    EXPECT_NEAR(explicit_phase(terms, corner.apex, inward), explicit_phase(terms, corner.apex + 1e-6 * inward), 1e-4);
  }
}

}  // namespace
}  // namespace quadrille::field
