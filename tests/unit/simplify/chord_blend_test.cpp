#include "simplify/chord_blend.hpp"

#include <gtest/gtest.h>

#include "../support/hall.hpp"
#include "../support/square_field.hpp"
#include "simplify/chord_collapse.hpp"

namespace quadrille::simplify {
namespace {

TEST(ChordBlend, BlendsAreFoundFromBothEnds) {
  constexpr double step = 0.1;
  const Field field = interpolated_field(square_mesh({-1, -2}, 6, 3), 1, [](Vec2) { return Vec2{1, 0}; });
  const field::FieldEvaluator evaluator(field);
  const graph::CandidateLayout layout = hall(step);
  const graph::Subdivision& subdivision = layout.subdivision;
  const graph::ChordStrip strip = thin_strip_of_hall(subdivision, step);
  const auto blends = blends_of(evaluator, subdivision, strip, {1, 1e-9});
  ASSERT_TRUE(blends);
  ASSERT_EQ(blends->size(), 1u);
  const Blend& blend = blends->front();
  EXPECT_NEAR(blend.deviation, deviation_of_hall(step), 1e-3);
  const auto same = find_blend(*blends, blend.from, blend.to);
  const auto turned = find_blend(*blends, graph::reversed_pieces(blend.to), graph::reversed_pieces(blend.from));
  ASSERT_TRUE(same && turned);
  EXPECT_EQ(curve::point(*same, same->begin()), curve::point(*turned, turned->end()));
  EXPECT_FALSE(find_blend(*blends, blend.to, blend.from));
}

TEST(ChordBlend, ACrossingWithAChainIsFoundInsideBoth) {
  const CadFace face = hand_made::face({{curve::segment({0, -1}, {0, 1})}}, 2);
  const std::vector<Nurbs> none;
  const curve::CurveTable table(face, none);
  const curve::Chain chain(table, {{0, face.curves[0].begin(), face.curves[0].end()}});
  const Nurbs across = curve::segment({-1, 0.5}, {1, 0.5}), beside = curve::segment({-1, 3}, {1, 3});
  double s = across.begin() + 0.3 * (across.end() - across.begin()), fraction = 0.5;
  ASSERT_TRUE(cross_chain(across, chain, s, fraction));
  EXPECT_NEAR(distance(curve::point(across, s), {0, 0.5}), 0, 1e-12);
  EXPECT_NEAR(fraction, 0.75, 1e-12);
  EXPECT_FALSE(cross_chain(beside, chain, s, fraction));
}

}  // namespace
}  // namespace quadrille::simplify
