#include "graph/family_order.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <string>

#include "../support/square_field.hpp"
#include "base/error.hpp"
#include "curve/fit_line.hpp"
#include "trace/advance.hpp"

namespace quadrille::graph {
namespace {

TEST(FamilyOrder, ACrossingAtASmallAngleIsNamedUnlessAMergeHasMadeIt) {
  const std::vector<Crossing> crossings{{0, 1, 1, 1, {2, 3}, half_pi}, {1, 2, 1, 1, {4, 5}, 0.2}};
  EXPECT_NO_THROW(require_family_order({crossings[0]}, {false, false, false}, {}));
  EXPECT_NO_THROW(require_family_order(crossings, {false, false, true}, {}));
  EXPECT_NO_THROW(require_family_order(crossings, {false, true, false}, {}));
  try {
    require_family_order(crossings, {true, false, false}, {100, 0});
    FAIL();
  } catch (const FamilyOrderError& error) {
    EXPECT_NE(std::string(error.what()).find("(104, 5)"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("11.5 degrees"), std::string::npos) << error.what();
  }
}

// Lines from places along all sides of a square, past two nodes of valence 3 through many elements: those of one family
// keep their sequence everywhere, for any two meet at right angles or not at all.
TEST(FamilyOrder, IsKeptBesideNodes) {
  const auto value = [](Vec2 p) {
    const std::complex<double> z(p.x, p.y), v = -std::polar(1.0, 0.3) * (z * z - 0.25);
    return Vec2{v.real(), v.imag()};
  };
  const Field field = interpolated_field(square_mesh({-1, -1}, 2, 6), 2, value);
  const field::FieldEvaluator evaluator(field);
  std::vector<Nurbs> splines;
  for (int side = 0; side < 4; ++side)
    for (int i = 1; i < 12; ++i) {
      const trace::Launch launch = trace::launch_from_boundary(evaluator, side, i / 6.0);
      const trace::Streamline line =
          trace::advance(evaluator, launch, PointGrid({{-0.5, 0}, {0.5, 0}}), {1e-10, 0.1, 6, 1e-7});
      const auto along = [&](double s, Vec2& direction) { return line.at(evaluator, s, direction); };
      if (line.length() > 0.01) splines.push_back(curve::fit_line(along, line.length(), 1e-9));
    }
  const std::vector<Crossing> crossings = find_crossings(splines, 1e-9);
  EXPECT_GT(crossings.size(), 50u);
  int num_twice = 0;
  for (const Crossing& c : crossings) {
    // Launched across the boundary, not along the cross: the first step alone may bend.
    if (std::min(c.s, c.t) < 1e-3) continue;
    EXPECT_NEAR(c.angle, half_pi, 1e-4) << c.position.x << ' ' << c.position.y;
    EXPECT_FALSE(is_of_one_family(c));
    num_twice += c.a == c.b ? 1 : 0;
  }
  EXPECT_LT(num_twice, 10);
}

}  // namespace
}  // namespace quadrille::graph
