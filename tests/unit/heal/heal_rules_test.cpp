#include "heal/heal_rules.hpp"

#include <gtest/gtest.h>

namespace quadrille::heal {
namespace {

HealScale scale_of(double vertex, double shape, double given = -1, double diameter = 10) {
  RawFace raw;
  raw.file = "f.step";
  raw.tolerance = vertex, raw.shape_tolerance = shape;
  return heal_scale(raw, given, diameter);
}

TEST(HealScale, ToleranceIsTwiceThatOfTheShapeBetweenItsLimits) {
  EXPECT_DOUBLE_EQ(scale_of(1e-9, 1e-9).tolerance, 10 * heal_rules.default_tolerance);
  EXPECT_DOUBLE_EQ(scale_of(1e-3, 2e-3).tolerance, 4e-3);
  EXPECT_DOUBLE_EQ(scale_of(2e-3, 1e-3).tolerance, 4e-3);
  EXPECT_DOUBLE_EQ(scale_of(1, 1).tolerance, 10 * heal_rules.most_tolerance) << "no gap of the shape is believed";
}

TEST(HealScale, AToleranceThatIsAskedForCountsAlone) {
  EXPECT_DOUBLE_EQ(scale_of(1e-3, 1e-3, 1e-4).tolerance, 1e-3);
  EXPECT_EQ(scale_of(1e-3, 1e-3, 0).tolerance, 0) << "no healing";
  EXPECT_EQ(scale_of(1e-3, 1e-3, 0).short_fraction, 0);
  EXPECT_EQ(scale_of(0, 0).short_fraction, heal_rules.default_tolerance);
}

/// What the file itself states is no fault of an edge.
TEST(HealScale, EdgesMayBeAsFarFromTheirVerticesAsTheFileStates) {
  EXPECT_DOUBLE_EQ(scale_of(0.5, 0, 0).most_off_curve, 0.5);
  EXPECT_DOUBLE_EQ(scale_of(0.5, 0, 0).most_off_plane, 0.5);
  EXPECT_DOUBLE_EQ(scale_of(0, 0).most_off_plane, 10 * heal_rules.most_tolerance);
  EXPECT_DOUBLE_EQ(scale_of(0, 0, 1e-4).most_off_plane, 1e-3);
}

TEST(Remedy, IsTheNextToleranceOfTwoDigitsThatWouldDo) {
  const HealScale scale = scale_of(0, 0);
  EXPECT_EQ(remedy(scale, 1.23e-3), " (0.00012 diameters; the tolerance is 1e-05): give --heal-tolerance 0.00013");
  EXPECT_EQ(remedy(scale, 1.2e-3), " (0.00012 diameters; the tolerance is 1e-05): give --heal-tolerance 0.00013")
      << "not the size itself, which is a tie";
}

TEST(Remedy, IsToDrawItAnewWhereHealingMovesNothingAsFar) {
  EXPECT_EQ(remedy(scale_of(0, 0), 0.5), " (0.05 diameters; healing moves nothing further than 0.005): draw it anew");
  EXPECT_NE(remedy(scale_of(0, 0), 0.045).find("give --heal-tolerance 0.0046"), std::string::npos);
}

TEST(ReportRepair, HasItsNumberInTheKeys) {
  Report report;
  report_repair({RepairKind::joint, 7, {1, 2}, 1e-3}, 4, report);
  std::vector<std::string> keys;
  for (const auto& [key, value] : report.entries()) keys.push_back(key);
  EXPECT_EQ(keys, (std::vector<std::string>{"heal.repair.4.kind", "heal.repair.4.edge", "heal.repair.4.position",
                                            "heal.repair.4.distance"}));
  EXPECT_EQ(std::get<long long>(report.entries()[1].second), 7);
}

}  // namespace
}  // namespace quadrille::heal
