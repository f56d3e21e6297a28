#include "io/chain_report.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "../support/texts.hpp"
#include "base/error.hpp"
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
  EXPECT_THROW(read_object(path("deep"), "a report", "formats/report.md"), FormatError);
  EXPECT_THROW(read_object(path("list"), "a report", "formats/report.md"), FormatError);
  EXPECT_EQ(value_of({"stage", bytes_of("deep")}, "a"), std::nullopt) << "counts as empty";
}

using Json = nlohmann::json;

/// The report of a stage that took this many CPU seconds, and twice as many elapsed; `rest` begins with a comma.
StageReport stage(const std::string& name, const std::string& tool, double seconds, const std::string& rest = "") {
  const Json times{{"cpu_seconds", seconds}, {"wall_seconds", 2 * seconds}};
  return {name, R"({"tool": ")" + tool + R"(", "timings": {"work": {}, "total": )" + times.dump() + "}" + rest + "}"};
}

/// The stages of a run that made a mesh.
std::vector<StageReport> usual_stages() {
  return {stage("separatrix", "separatrix", 0.25, R"(, "certificate": {"method": "traced"})"),
          stage("quadrefine", "quadrefine", 0.5,
                R"(, "blocks": 5, "irregular_nodes": 1, "quads": 320, "valid": true, "least_scaled_jacobian": 0.87654,)"
                R"( "greatest_edge_ratio": {"value": 3.26, "element": 7})"),
          stage("quadexport", "quadexport", 0.25, R"(, "quads": 320, "unit": "mm", "scale": 1.0)")};
}

ChainFacts usual_facts() {
  ChainFacts facts;
  facts.form = "harmonic";
  facts.num_nodes = 3;
  facts.version = "9.9.9";
  facts.wall_seconds = 1.5;
  return facts;
}

Json composed(const std::vector<StageReport>& stages, const ChainFacts& facts = usual_facts()) {
  return Json::parse(ChainReport(stages, facts).text());
}

TEST(ValueOf, FindsDottedKeysAsText) {
  const StageReport report{"s", R"({"a": {"b": "text", "c": 2, "d": true, "e": null}, "f": 0.5})"};
  EXPECT_EQ(value_of(report, "a.b"), "text");
  EXPECT_EQ(value_of(report, "a.c"), "2");
  EXPECT_EQ(value_of(report, "a.d"), "true");
  EXPECT_EQ(value_of(report, "f"), "0.5");
  for (const char* key : {"a.e", "a.x", "f.x", "x", "a.b.c"}) EXPECT_EQ(value_of(report, key), std::nullopt) << key;
  for (const char* text : {"", "no JSON", "[1]"}) EXPECT_EQ(value_of({"s", text}, "a"), std::nullopt);
}

TEST(WarningsOf, HaveTheToolOfTheReportOrTheirOwn) {
  const auto warnings = warnings_of({"s", R"({"tool": "padapt", "warnings": [{"code": "W-1", "message": "odd"},)"
                                          R"( {"tool": "quadmesh", "code": "W-2", "message": "late"}]})"});
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_EQ(warnings[0].tool + warnings[0].code + warnings[0].message, "padaptW-1odd");
  EXPECT_EQ(warnings[1].tool, "quadmesh");
  EXPECT_TRUE(warnings_of({"s", ""}).empty());
}

TEST(ChainReport, IsComposedOfTheStages) {
  const Json root = composed(usual_stages());
  EXPECT_EQ(root["tool"], "quadmesh");
  EXPECT_EQ(root["version"], "9.9.9");
  EXPECT_EQ(root["form"], "harmonic");
  EXPECT_EQ(root["critical_points"], 3);
  EXPECT_EQ(root["blocks"], 5);
  EXPECT_EQ(root["quads"], 320);
  EXPECT_EQ(root["valid"], true);
  EXPECT_EQ(root["certificate"]["method"], "traced");
  EXPECT_EQ(root["unit"], "mm");
  EXPECT_EQ(root["cpu_seconds"], 1);
  EXPECT_EQ(root["wall_seconds"], 1.5);
  EXPECT_EQ(root["exit_code"], 0);
  for (const char* key : {"given_up", "remedy", "walls", "stage", "error"}) EXPECT_TRUE(root[key].is_null()) << key;
  EXPECT_TRUE(root["warnings"].empty());
}

TEST(ChainReport, WritesWholeNumbersWithoutAPoint) {
  const std::string text = ChainReport(usual_stages(), usual_facts()).text();
  expect_contains(text, "\"cpu_seconds\": 1,");
  expect_contains(text, "\"scale\": 1,");
  expect_contains(text, "\"wall_seconds\": 1.5");
}

TEST(ChainReport, AddsTheTimesOfEqualNamesAndSkipsWhatIsNoReport) {
  const std::vector<StageReport> stages{
      stage("padapt", "padapt", 0.25), stage("padapt", "padapt", 0.5), {"fieldsolve", ""}};
  const Json root = composed(stages);
  EXPECT_EQ(root["stages"]["padapt"]["cpu_seconds"], 0.75);
  EXPECT_EQ(root["stages"]["padapt"]["wall_seconds"], 1.5);
  EXPECT_FALSE(root["stages"].contains("fieldsolve"));
}

TEST(ChainReport, NamesTheFirstFailureAfterWhichARunWentOn) {
  std::vector<StageReport> stages{stage("separatrix", "separatrix", 1, R"(, "exit_code": 1, "error": "no layout")"),
                                  stage("padapt", "padapt", 1, R"(, "exit_code": 1, "error": "no field")")};
  EXPECT_TRUE(composed(stages)["given_up"].is_null()) << "the run ended so";
  stages.push_back(stage("midpoint_separatrix", "separatrix", 1, R"(, "exit_code": 0)"));
  EXPECT_EQ(composed(stages)["given_up"], "separatrix: no layout");
}

TEST(ChainReport, ATrialHasTheFiguresOfQuadrefine) {
  const LayoutTrial trial = layout_trial(
      {"trial_quadrefine", R"({"valid": true, "greatest_edge_ratio": {"value": 2.5}, "least_scaled_jacobian": 0.75,)"
                           R"( "resolution": {"ratio": 3}, "blocks": 12})"},
      "critpoints --place energy");
  EXPECT_EQ(trial.options, "critpoints --place energy");
  EXPECT_TRUE(trial.is_valid);
  EXPECT_EQ(trial.edge_ratio, 2.5);
  EXPECT_EQ(trial.scaled_jacobian, 0.75);
  EXPECT_EQ(trial.resolution, 3);
  EXPECT_EQ(trial.blocks, 12);
  EXPECT_FALSE(layout_trial({"trial_quadrefine", R"({"valid": false})"}, "").is_valid);
  EXPECT_FALSE(layout_trial({"trial_quadrefine", ""}, "").is_valid) << "an empty report";
}

TEST(ChainReport, RunsOfRemediesThatFailedCountWithTheirTimesAlone) {
  std::vector<StageReport> stages = usual_stages();
  stages.push_back(stage("trial_separatrix", "separatrix", 2,
                         R"(, "exit_code": 1, "error": "no", "certificate": {"method": "midpoint"},)"
                         R"( "warnings": [{"code": "W-1", "message": "odd"}])"));
  const Json root = composed(stages);
  EXPECT_EQ(root["certificate"]["method"], "traced");
  EXPECT_TRUE(root["given_up"].is_null());
  EXPECT_TRUE(root["warnings"].empty());
  EXPECT_EQ(root["cpu_seconds"], 3);
  EXPECT_EQ(root["stages"]["trial_separatrix"]["wall_seconds"], 4);
  stages.back() = stage("trial_separatrix", "separatrix", 2,
                        R"(, "warnings": [{"tool": "quadmesh", "code": "W-RUN-001", "message": "stopped"}])");
  EXPECT_EQ(composed(stages)["warnings"][0]["code"], "W-RUN-001");
}

TEST(ChainReport, WarningsHaveTheToolInFront) {
  const std::vector<StageReport> stages{
      stage("critpoints", "critpoints", 1, R"(, "warnings": [{"code": "W-1", "message": "odd"}])")};
  expect_contains(ChainReport(stages, usual_facts()).text(),
                  R"({"tool": "critpoints", "code": "W-1", "message": "odd"})");
}

TEST(ChainReport, StatesWhatFailedAndTheRemedy) {
  ChainFacts facts;
  facts.exit_code = 3;
  facts.failed_stage = "cad2tri";
  facts.error = "no face";
  facts.remedy = "critpoints --ties field";
  const Json root = composed({}, facts);
  EXPECT_EQ(root["exit_code"], 3);
  EXPECT_EQ(root["stage"], "cad2tri");
  EXPECT_EQ(root["error"], "no face");
  EXPECT_EQ(root["remedy"], "critpoints --ties field");
  EXPECT_TRUE(root["form"].is_null());
  EXPECT_TRUE(root["blocks"].is_null());
}

TEST(ChainReport, TheCommandStandsInFront) {
  const ChainReport report(usual_stages(), usual_facts());
  const auto root = nlohmann::ordered_json::parse(report.text_with_command("quadmesh plate.step"));
  EXPECT_EQ(root.begin().key(), "command");
  EXPECT_EQ(root["command"], "quadmesh plate.step");
  EXPECT_EQ(root.size(), composed(usual_stages()).size() + 1);
}

TEST(ChainReport, TimesAreALineForEachStageWithItsShare) {
  EXPECT_EQ(ChainReport(usual_stages(), usual_facts()).times(),
            "separatrix       0.25 s CPU, 25 %\n"
            "quadrefine       0.5 s CPU, 50 %\n"
            "quadexport       0.25 s CPU, 25 %\n"
            "all stages       1 s CPU, 1.5 s\n");
}

TEST(ChainReport, StagesWithoutTimeHaveNoShare) {
  EXPECT_EQ(ChainReport({stage("padapt", "padapt", 0)}, {}).times(),
            "padapt           0 s CPU, 0 %\n"
            "all stages       0 s CPU, 0 s\n");
}

TEST(ChainReport, TheSummaryIsOneLine) {
  const auto summary = [](const std::vector<StageReport>& stages) { return ChainReport(stages, {}).summary(); };
  const std::string usual =
      "5 blocks, 1 irregular node, 320 quads, worst scaled Jacobian 0.88, greatest edge ratio 3.3";
  std::vector<StageReport> stages = usual_stages();
  EXPECT_EQ(summary(stages), usual);
  stages[0].json = R"({"tool": "separatrix", "certificate": {"method": "midpoint"}})";
  EXPECT_EQ(summary(stages), usual + ", by midpoint division of triangles");
  stages[0].json = "";
  stages[2].json = R"({"tool": "quadexport", "unit": "m", "scale": 0.001})";
  EXPECT_EQ(summary(stages), usual + ", coordinates in m, 0.001 times those of the CAD file");
  stages[2].json = R"({"tool": "quadexport", "unit": "unknown", "scale": 2})";
  EXPECT_EQ(summary(stages), usual + ", coordinates in an unknown unit, 2 times those of the CAD file");
  EXPECT_EQ(summary({stage("quadexport", "quadexport", 1, R"(, "quads": 5)")}), "5 quads") << "blocks as STEP";
}

std::vector<StageReport> stages_with_verdict(const std::string& grade, const std::string& text) {
  std::vector<StageReport> stages = usual_stages();
  stages[1] = stage("quadrefine", "quadrefine", 0.5,
                    fmt::format(R"(, "blocks": 1, "verdict": {{"grade": "{}", "text": "{}"}})", grade, text));
  return stages;
}

TEST(ChainReport, TheSummaryEndsWithTheVerdictAndTheNodesThatWereTried) {
  ChainFacts facts;
  const auto end = [&](const std::vector<StageReport>& stages) {
    const std::string line = ChainReport(stages, facts).summary();
    return line.substr(line.find(';'));
  };
  EXPECT_EQ(end(stages_with_verdict("good", "good")), "; good");
  EXPECT_EQ(end(stages_with_verdict("usable", "usable: area jump 12")), "; usable: area jump 12");
  facts.trials = {{"", true, 2, 0.8, 8, 12}, {"critpoints --place energy", true, 2, 0.8, 9, 12}};
  EXPECT_EQ(end(stages_with_verdict("good", "good")), "; good");
  EXPECT_EQ(end(stages_with_verdict("usable", "usable: x")),
            "; usable: x; tried: critpoints --place energy (resolution ratio 9 in place of 8)");
  facts.trials.push_back({"critpoints --nodes fewest", true, 2, 0.8, 3.125, 12});
  facts.remedy = "critpoints --nodes fewest";
  const std::string tried =
      "tried: critpoints --place energy (resolution ratio 9 in place of 8), critpoints --nodes "
      "fewest (resolution ratio 3.12 in place of 8: taken)";
  EXPECT_EQ(end(stages_with_verdict("poor", "poor: x")), "; poor: x; " + tried);
  EXPECT_EQ(Json::parse(ChainReport(stages_with_verdict("poor", "poor: x"), facts).text())["verdict"]["text"],
            "poor: x; " + tried);
}

TEST(ChainReport, ReportsOfOtherProgramsMayHaveOtherTypes) {
  const StageReport odd{"padapt",
                        R"({"tool": "padapt", "exit_code": 1, "error": null, "timings": {"total": {"a": "b"}},)"
                        R"( "warnings": [1, {"code": 2}]})"};
  EXPECT_EQ(
      composed({odd, {"x", R"({"tool": 3})"}, {"y", R"({"tool": "y", "warnings": "none", "timings": 1})"}})["tool"],
      "quadmesh");
  EXPECT_NO_THROW(warnings_of(odd));
}

}  // namespace

}  // namespace quadrille::io
