#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "io/chain_report.hpp"
#include "io/whole_file.hpp"
#include "scratch.hpp"

namespace quadrille::io {
namespace {

class ReportIo : public Scratch {
 protected:
  nlohmann::ordered_json written(const Report& report) {
    write_report(path("report.json"), "tool", "1.2.3", report);
    return nlohmann::ordered_json::parse(bytes_of("report.json"));
  }
};

TEST_F(ReportIo, DottedKeysBecomeNestedObjectsInTheOrderOfTheirFirstUse) {
  Report report;
  report.set("solve.residual", 1e-12);
  report.set("count", 3);
  report.set("solve.timings.total", 2.5);
  report.set("solve.method", "cg");
  report.set("solve.residual", 0.5);
  EXPECT_EQ(written(report).dump(),
            R"({"tool":"tool","version":"1.2.3","solve":{"residual":0.5,"timings":{"total":2.5},)"
            R"("method":"cg"},"count":3,"warnings":[]})");
}

TEST_F(ReportIo, EveryKindOfValueIsWritten) {
  Report report;
  report.set("number", std::numeric_limits<double>::infinity());
  report.set("flag", true);
  report.set("list", Report::Value(std::vector<double>{1, 2.5}));
  const auto json = written(report);
  EXPECT_TRUE(json["number"].is_null()) << "JSON has no infinity";
  EXPECT_EQ(json["flag"], true);
  EXPECT_EQ(json["list"].dump(), "[1.0,2.5]");
}

TEST_F(ReportIo, WarningsAreListedWithTheirCodes) {
  Report report;
  report.warn("W-X-001", "first");
  report.warn("W-X-001", "second");
  const auto json = written(report);
  ASSERT_EQ(json["warnings"].size(), 2u);
  EXPECT_EQ(json["warnings"][1].dump(), R"({"code":"W-X-001","message":"second"})");
}

TEST_F(ReportIo, AReportThatIsReadMustBeAnObjectOfFewLevels) {
  put("deep", R"({"a":)" + std::string(1'000'000, '[') + std::string(1'000'000, ']') + '}');
  put("list", "[]");
  EXPECT_THROW(read_report(path("deep")), FormatError);
  EXPECT_THROW(read_report(path("list")), FormatError);
  EXPECT_EQ(value_of({"stage", bytes_of("deep")}, "a"), std::nullopt) << "counts as empty";
}

}  // namespace
}  // namespace quadrille::io
