#include "stage/quadexport.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../samples.hpp"
#include "../support/test_data.hpp"
#include "../support/texts.hpp"
#include "base/error.hpp"
#include "export/format_table.hpp"

namespace quadrille::stage {
namespace {

std::string usage_message(const std::string& output, const QuadexportOptions& options) {
  return message_of<UsageError>([&] { format_of(output, options); });
}

TEST(Quadexport, TheFormatFollowsFromTheOutputUnlessItIsChosen) {
  QuadexportOptions options;
  EXPECT_EQ(format_of("-", options), "msh");
  EXPECT_EQ(format_of("x.vtu", options), "vtu");
  EXPECT_EQ(format_of("x.stp", options), "step");
  expect_contains(usage_message("x.unv", options), "give --format");
  options.format = "mfem";
  EXPECT_EQ(format_of("x.unv", options), "mfem");
  options.format = "unheard-of";
  EXPECT_THROW(format_of("x.msh", options), UsageError);
}

TEST(Quadexport, OptionsThatTheFormatDoesNotSupportAreRefused) {
  QuadexportOptions options;
  options.patch_types = {"wall=wall"};
  expect_contains(usage_message("x.step", options), "--patch-type");
  EXPECT_THROW(format_of("x.msh", options), UsageError);
  options = {};
  options.length.scale = 0;
  quadrille::Run run;
  EXPECT_THROW(quadexport(samples::quad_mesh(), "x.quad.h5", "x.msh", options, run), UsageError);
  EXPECT_THROW(require_order("msh", 25, {}), UsageError);
  EXPECT_NO_THROW(require_order("msh", 4, {}));
  EXPECT_NO_THROW(require_order("step", 25, {}));
}

TEST(Quadexport, TheFaceAloneTellsWhichOptionsDoNotFit) {
  CadFace face = samples::face();
  QuadexportOptions options;
  options.length.unit = "m";
  EXPECT_NO_THROW(require_quadexport_of(face, "-", options));
  face.metres_per_unit = 0;
  EXPECT_THROW(require_quadexport_of(face, "-", options), UsageError);
  options = {};
  options.patch_types = {"hole=wall"};
  EXPECT_THROW(require_quadexport_of(face, "-", options), UsageError);
}

TEST(Quadexport, TheFilesAreThoseOfTheFormatTheMainOneLast) {
  quadrille::Run run;
  const std::vector<OutputFile> files = quadexport(samples::quad_mesh(), "x.quad.h5", "out/a.vtu", {}, run);
  const exports::Exported expected =
      exports::export_mesh(samples::quad_mesh(), *exports::find_export_format("vtu"), {});
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].path, "out/a.curves.vtu");
  EXPECT_EQ(files[0].bytes, expected.side_files.at(0).bytes);
  EXPECT_EQ(files[1].path, "out/a.vtu");
  EXPECT_EQ(files[1].bytes, expected.bytes);
  EXPECT_EQ(files[1].is_binary, expected.is_binary);
}

TEST(Quadexport, StandardOutputTakesOneFileAndAWarningNamesTheOther) {
  quadrille::Run run;
  QuadexportOptions options;
  options.format = "vtu";
  EXPECT_EQ(quadexport(samples::quad_mesh(), "x.quad.h5", "-", options, run).size(), 1U);
  const std::vector<Report::Warning>& warnings = run.report().warnings();
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(),
                          [](const Report::Warning& warning) { return warning.code == "W-EXP-002"; }));
}

TEST(Quadexport, AMeshThatIsNotValidIsExportedOnlyIfThatIsAllowed) {
  QuadMesh mesh = samples::quad_mesh();
  mesh.elem_jacobian_bound[0] = mesh.least_jacobian_bound = -0.125;
  mesh.is_valid = false;
  QuadexportOptions options;
  quadrille::Run run;
  expect_contains(message_of<ComputeError>([&] { quadexport(mesh, "x.quad.h5", "x.msh", options, run); }),
                  "--allow-invalid");
  options.allow_invalid = true;
  EXPECT_EQ(quadexport(mesh, "x.quad.h5", "x.msh", options, run).back().path, "x.msh");
}

TEST(Quadexport, BlocksBecomeAStepModel) {
  const std::string bytes = test_bytes("../formats/block_layout/passed/square.blocks.h5");
  QuadexportOptions options;
  options.length.unit = "m";
  quadrille::Run run;
  const OutputFile file = quadexport_step({bytes, {"x.blocks.h5", "digest"}}, "x.step", options, run);
  EXPECT_EQ(file.bytes.substr(0, 12), "ISO-10303-21");
  const auto& entries = run.report().entries();
  const auto unit =
      std::find_if(entries.begin(), entries.end(), [](const auto& entry) { return entry.first == "unit"; });
  ASSERT_NE(unit, entries.end());
  EXPECT_EQ(std::get<std::string>(unit->second), "metre");
  EXPECT_THROW(quadexport_step({bytes, {"x.blocks.h5", "digest"}}, "x.msh", options, run), UsageError);
}

TEST(Quadexport, ABrokenBlockLayoutIsRefusedByItsName) {
  const std::string bytes = "no layout";
  quadrille::Run run;
  const auto act = [&] { quadexport_step({bytes, {"x.blocks.h5", "digest"}}, "x.step", {}, run); };
  expect_contains(message_of<FormatError>(act), "x.blocks.h5: ");
}

}  // namespace
}  // namespace quadrille::stage
