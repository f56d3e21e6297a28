#include "io/stage_files.hpp"

#include <gtest/gtest.h>

#include "../chart_samples.hpp"
#include "../region_layout_samples.hpp"
#include "base/error.hpp"
#include "round_trip.hpp"

namespace quadrille::io {

namespace {

using StageFiles = RoundTrip;

TEST_F(StageFiles, AStructHasTheBytesAndTheIdentityOfItsFile) {
  const std::string bytes = stage_bytes(samples::field());
  write_stage(path("file"), samples::field());
  EXPECT_EQ(bytes, bytes_of("file"));
  const InputFile file = read_input(path("file"));
  const FileIdentity identity = identity_of(path("file"), bytes);
  EXPECT_EQ(identity.name, file.name);
  EXPECT_EQ(identity.sha256, file.sha256);
  EXPECT_NE(identity_of(path("file"), bytes + ' ').sha256, file.sha256);
}

TEST_F(StageFiles, TheReaderOfAStructReadsItsFormatAlone) {
  const auto expect_own_format = [](const auto& model, const std::string& format) {
    using Model = std::decay_t<decltype(model)>;
    const std::string bytes = stage_bytes(model);
    const InputFile file{{"file", ""}, bytes};
    EXPECT_EQ(stage_format(file), format);
    EXPECT_EQ(stage_bytes(read_stage<Model>(file)), bytes);
    const InputFile other{{"file", ""},
                          format == "tri-mesh" ? stage_bytes(samples::quad_mesh()) : stage_bytes(samples::tri_mesh())};
    EXPECT_THROW(read_stage<Model>(other), FormatError) << format;
  };
  expect_own_format(samples::charted_face(), "chart");
  expect_own_format(samples::tri_mesh(), "tri-mesh");
  expect_own_format(samples::field(), "field");
  expect_own_format(samples::critical_points(), "critical-points");
  expect_own_format(samples::separatrix_graph(), "separatrix-graph");
  expect_own_format(samples::block_layout(), "block-layout");
  expect_own_format(samples::quad_mesh(), "quad-mesh");
  expect_own_format(samples::hex_mesh(), "hex-mesh");
}

}  // namespace

}  // namespace quadrille::io
