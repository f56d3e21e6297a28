#include "sizing/report_sizes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "../hand_made.hpp"
#include "block/extract_blocks.hpp"
#include "refine/refine.hpp"

namespace quadrille::sizing {
namespace {

Report report_of(const SeparatrixGraph& graph, const refine::RefineOptions& options) {
  Report report;
  const BlockLayout layout = block::extract_blocks(graph, report);
  Report result;
  refine::refine(layout, options, result);
  return result;
}

const Report::Value& value(const Report& report, const std::string& key) {
  const auto found = std::find_if(report.entries().begin(), report.entries().end(),
                                  [&](const auto& entry) { return entry.first == key; });
  if (found == report.entries().end()) throw std::runtime_error("no " + key);
  return found->second;
}
double number(const Report& report, const std::string& key) { return std::get<double>(value(report, key)); }
double of_chord(const Report& report, const std::string& key, std::size_t chord) {
  return std::get<std::vector<double>>(value(report, "sizes.chord." + key)).at(chord);
}

TEST(ReportSizes, PartsOfTheErrorAreThoseOfChords) {
  refine::RefineOptions options;
  options.relax = refine::Relax::size;
  options.counts = {{0, 2}, {1, 20}};
  const Report report = report_of(hand_made::unit_square(), options);
  EXPECT_NEAR(number(report, "resolution.ratio") / ((1 + 1e-8) / (2 * 1e-4)), 1, 1e-6);
  EXPECT_NEAR(std::get<std::vector<double>>(value(report, "resolution.chord.part"))[0], 1, 1e-6);
}

/// The verdict on the unit square with these counts, where an element has this scaled Jacobian.
Report verdict_on(int count0, int count1, double scaled_jacobian = 1) {
  Report report;
  const BlockLayout layout = block::extract_blocks(hand_made::unit_square(), report);
  refine::RefineOptions options;
  options.counts = {{0, count0}, {1, count1}};
  QuadMesh mesh = refine::refine(layout, options, report);
  mesh.elem_scaled_jacobian.front() = scaled_jacobian;
  SizeOptions sizes;
  sizes.per_curve = 0;
  Report result;
  report_verdict(MeasuredLayout(layout), mesh, sizes, sizes, result);
  return result;
}

TEST(ReportSizes, TheVerdictIsReportedWithWhatLimitsTheMesh) {
  Report report = verdict_on(4, 12);
  EXPECT_EQ(std::get<std::string>(value(report, "verdict.grade")), "usable");
  EXPECT_EQ(std::get<std::string>(value(report, "verdict.limit")), "resolution ratio");
  EXPECT_NEAR(number(report, "verdict.value"), 40.5, 0.1);
  EXPECT_EQ(std::get<std::vector<double>>(value(report, "verdict.position")).size(), 2U);
  ASSERT_EQ(report.warnings().size(), 1U);
  EXPECT_EQ(report.warnings()[0].code, "W-QUA-005");
  EXPECT_EQ(report.warnings()[0].message, "the mesh is " + std::get<std::string>(value(report, "verdict.text")));
  EXPECT_NE(report.warnings()[0].message.find(" prescribed lengths, chord 0 has 100 % of the error"),
            std::string::npos);
  report = verdict_on(12, 4);
  EXPECT_NE(report.warnings().at(0).message.find(", chord 1 has 100 % of the error"), std::string::npos);
  report = verdict_on(4, 4);
  EXPECT_TRUE(report.warnings().empty());
  EXPECT_EQ(std::get<std::string>(value(report, "verdict.text")), "good");
  EXPECT_THROW(value(report, "verdict.limit"), std::runtime_error);
}

TEST(ReportSizes, UnequalSizesAreAWarningAlsoWhereAnglesAreWorse) {
  Report report = verdict_on(4, 12, 0.1);
  EXPECT_EQ(std::get<std::string>(value(report, "verdict.limit")), "least scaled Jacobian");
  ASSERT_EQ(report.warnings().size(), 1U);
  EXPECT_EQ(report.warnings()[0].code, "W-QUA-005");
  EXPECT_TRUE(verdict_on(4, 4, 0.1).warnings().empty());
}

TEST(ReportSizes, EqualEdgesDeviateByTheirRatio) {
  refine::RefineOptions options;
  options.size = 0.3;  // three edges to a side
  const Report report = report_of(hand_made::unit_square(), options);
  for (const char* key : {"sizes.mean_ratio", "sizes.least_ratio", "sizes.greatest_ratio"})
    EXPECT_NEAR(number(report, key), 1 / 0.9, 1e-12) << key;
  EXPECT_NEAR(number(report, "sizes.deviation"), -std::log(0.9), 1e-12);
  EXPECT_NEAR(number(report, "sizes.prescribed"), 0.3, 1e-15);
  EXPECT_EQ(of_chord(report, "count", 1), 3);
  EXPECT_NEAR(of_chord(report, "least_edge", 0), 1.0 / 3, 1e-15);
}

TEST(ReportSizes, ChordsAreReportedOneByOne) {
  // Arcs of length pi and pi / 2 share ten elements: 0.314 and 0.157 where 0.2 is wanted; the straight sides have five.
  refine::RefineOptions options;
  options.size = 0.2;
  options.counts = {{1, 10}};
  const Report report = report_of(hand_made::quarter_annulus(), options);
  EXPECT_EQ(of_chord(report, "id", 1), 1);
  EXPECT_NEAR(of_chord(report, "deviation", 0), 0, 1e-12);
  const double outer = std::log(pi / 2), inner = std::log(pi / 4);
  EXPECT_NEAR(std::log(of_chord(report, "mean_ratio", 1)), (2 * outer + inner) / 3, 1e-10);
  EXPECT_NEAR(of_chord(report, "deviation", 1), std::sqrt((2 * outer * outer + inner * inner) / 3), 1e-10);
  EXPECT_NEAR(of_chord(report, "least_edge", 1), pi / 20, 1e-10);
  EXPECT_NEAR(of_chord(report, "greatest_edge", 1), pi / 10, 1e-10);
}

std::ptrdiff_t num_missed(const Report& report) {
  return std::ranges::count(report.warnings(), "W-QUA-002", &Report::Warning::code);
}

TEST(ReportSizes, CountsThatHadToRiseAreWarnedOf) {
  refine::RefineOptions options;
  options.counts = {{1, 1}};
  options.geometry_tol = 1e-9;
  const Report report = report_of(hand_made::quarter_annulus(), options);
  EXPECT_GT(of_chord(report, "count", 1), 1);
  EXPECT_EQ(num_missed(report), 1);
  options.geometry_tol = 1;
  EXPECT_EQ(num_missed(report_of(hand_made::quarter_annulus(), options)), 0);
}

}  // namespace
}  // namespace quadrille::sizing
