#include "stage/stagecheck.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../samples.hpp"
#include "../support/texts.hpp"
#include "base/warning_codes.hpp"

namespace quadrille::stage {
namespace {

using Lines = std::vector<std::string>;

bool is_reported(Run& run, const std::string& key) {
  return std::ranges::any_of(run.report().entries(), [&](const auto& entry) { return entry.first == key; });
}

TEST(Stagecheck, EachBrokenRuleIsALine) {
  quadrille::Run run;
  EXPECT_EQ(stagecheck(samples::tri_mesh(), "x.tri.h5", run), Lines{});
  TriMesh mesh = samples::tri_mesh();
  mesh.elem2vertices[1] = {0, 0, 4};
  const Lines lines = stagecheck(mesh, "x.tri.h5", run);
  ASSERT_FALSE(lines.empty());
  for (const std::string& line : lines) EXPECT_TRUE(line.starts_with("x.tri.h5: TRI-R")) << line;
  EXPECT_TRUE(run.report().warnings().empty());
}

TEST(Stagecheck, MeshesHaveAVerdict) {
  quadrille::Run run;
  EXPECT_EQ(stagecheck(samples::quad_mesh(), "x.quad.h5", run), Lines{});
  for (const char* key : {"resolution.ratio", "verdict.grade", "verdict.text"})
    EXPECT_TRUE(is_reported(run, key)) << key;
  EXPECT_TRUE(run.report().warnings().empty());
  QuadMesh broken = samples::quad_mesh();
  broken.elem_nodes[0] = 99;
  quadrille::Run other;
  EXPECT_FALSE(stagecheck(broken, "x.quad.h5", other).empty());
  EXPECT_FALSE(is_reported(other, "verdict.grade")) << "of numbers that mean nothing";
}

/// Its bounds are those of the elements: the second quad is folded.
TEST(Stagecheck, MeshesMarkedAsNotValidAreWarnings) {
  QuadMesh mesh = samples::quad_mesh();
  mesh.is_valid = false;
  mesh.elem_jacobian_bound[1] = mesh.least_jacobian_bound = -0.1;
  quadrille::Run run;
  EXPECT_EQ(stagecheck(mesh, "x.quad.h5", run), Lines{});
  ASSERT_EQ(run.report().warnings().size(), 1u);
  EXPECT_EQ(run.report().warnings()[0].code, warning::mesh_not_valid);
  expect_contains(run.report().warnings()[0].message, "x.quad.h5: ");
  HexMesh hexes = samples::hex_mesh();
  hexes.is_valid = false;
  hexes.elem_jacobian_bound[1] = hexes.least_jacobian_bound = -0.1;
  EXPECT_EQ(stagecheck(hexes, "x.hex.h5", run), Lines{});
  ASSERT_EQ(run.report().warnings().size(), 2u);
  expect_contains(run.report().warnings()[1].message, "x.hex.h5: ");
}

TEST(HistoryLines, ACommandOfSeveralFilesIsPrintedOnce) {
  const Provenance chain{{"cad2tri", "0.1.0", {{"step", "cad digest"}}, R"({"order":8})"}};
  Provenance longer = chain;
  longer.push_back({"fieldsolve", "0.1.0", {{"tri-mesh", "tri digest"}}, R"({"field-order":3})"});
  const Lines lines = history_lines({{"a.solve.h5", "solve digest", longer}, {"a.tri.h5", "tri digest", chain}});
  const std::string text = [&] {
    std::string all;
    for (const std::string& line : lines) all += line + '\n';
    return all;
  }();
  EXPECT_EQ(count(text, "cad2tri "), 1) << text;
  EXPECT_EQ(count(text, "fieldsolve "), 1) << text;
  EXPECT_LT(text.find("cad2tri "), text.find("fieldsolve ")) << text;
  expect_contains(text, "cad digest");
  EXPECT_EQ(count(text, "edited"), 0) << text;
}

TEST(HistoryLines, CriticalPointsMayHaveBeenEdited) {
  Provenance chain = samples::provenance();
  chain.push_back({"critpoints", "0.1.0", {{"field", "field digest"}}, "{}"});
  const Lines lines = history_lines({{"a.crit.json", "crit digest", chain}});
  ASSERT_FALSE(lines.empty());
  EXPECT_EQ(
      lines.back(),
      "# a.crit.json: SHA-256 crit digest; if the command makes another file, it was edited since: use the edited "
      "one");
}

TEST(FormatList, HasARowForEachFormatAndTool) {
  const std::string list = format_list();
  for (const StageFormat& format : stage_formats)
    EXPECT_EQ(count(list, R"({"name": ")" + std::string(format.name) + R"(", "version")"), 1) << format.name;
  for (const StageTool& tool : stage_tools)
    EXPECT_GE(count(list, R"({"name": ")" + std::string(tool.name) + R"(", "after")"), 1) << tool.name;
  expect_contains(list, R"({"name": "quad-mesh", "version": [)");
  expect_contains(list, R"("storage": "HDF5"})");
  expect_contains(list, R"("storage": "JSON"})");
}

}  // namespace
}  // namespace quadrille::stage
