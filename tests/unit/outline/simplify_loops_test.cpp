#include "outline/simplify_loops.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::outline {
namespace {

/// A half disc of diameter 2: a line, and an arc through `count` + 1 points, called "arc".
heal::Loop half_disc(int count) {
  std::vector<double> parameters;
  std::vector<Vec2> points;
  for (int i = 0; i <= count; ++i) parameters.push_back(pi * i / count), points.push_back(unit(parameters.back()));
  return {{curve::segment({-1, 0}, {1, 0}), 3, "wall"},
          {curve::cubic_spline(parameters, points, {0, 1}, {0, -1}), 4, "arc"}};
}

TEST(SimplifyLoops, RecordsWhatItReplaces) {
  std::vector<heal::Loop> loops{half_disc(1000)};
  const heal::Loop old = loops[0];
  std::vector<Repair> repairs{{RepairKind::joint, 3, {1, 0}, 1e-6}};
  Report report;
  simplify_loops(loops, 1e-8, 2, repairs, report);
  EXPECT_EQ(loops[0][0].curve.poles, old[0].curve.poles);
  EXPECT_LT(loops[0][1].curve.poles.size(), 40U);
  EXPECT_EQ(loops[0][1].curve.poles.back(), old[1].curve.poles.back());
  EXPECT_EQ(loops[0][1].name, "arc");
  ASSERT_EQ(repairs.size(), 2U);
  EXPECT_EQ(repairs[1].kind, RepairKind::fit);
  EXPECT_EQ(repairs[1].cad_edge, 4);
  EXPECT_GT(repairs[1].distance, 0);
  EXPECT_LE(repairs[1].distance, 2e-8);
  const auto entry = [&](const std::string& key) {
    for (const auto& [name, value] : report.entries())
      if (name == key) return value;
    return Report::Value(std::string("absent"));
  };
  EXPECT_EQ(std::get<long long>(entry("fit.curves")), 1);
  EXPECT_EQ(std::get<long long>(entry("fit.knots_before")), 999);
  EXPECT_LT(std::get<long long>(entry("fit.knots_after")), 30);
  EXPECT_EQ(std::get<double>(entry("fit.greatest")), repairs[1].distance / 2);
  EXPECT_EQ(std::get<std::string>(entry("heal.repair.1.kind")), "fit");
  EXPECT_EQ(std::get<long long>(entry("heal.repairs")), 2);
}

TEST(SimplifyLoops, LeavesTheRestAlone) {
  for (const double tolerance : {0.0, 1e-8}) {
    std::vector<heal::Loop> loops{half_disc(tolerance == 0 ? 1000 : 20)};
    const heal::Loop old = loops[0];
    std::vector<Repair> repairs;
    Report report;
    simplify_loops(loops, tolerance, 2, repairs, report);
    for (int i = 0; i < 2; ++i) EXPECT_EQ(loops[0][i].curve.poles, old[i].curve.poles);
    EXPECT_TRUE(repairs.empty());
  }
}

}  // namespace
}  // namespace quadrille::outline
