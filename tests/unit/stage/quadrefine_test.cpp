#include "stage/quadrefine.hpp"

#include <gtest/gtest.h>

#include "../region_layout_samples.hpp"
#include "base/error.hpp"

namespace quadrille::stage {
namespace {

struct Quadrefine : testing::Test {
  BlockLayout layout = samples::two_regions_layout();
  QuadrefineOptions options;
  quadrille::Run run;  // a fixture has a member Run

  QuadMesh quads(const std::optional<Input<SizeSources>>& sources = {}) {
    return quadrefine({{layout, {"x.blocks.h5", "digest of the blocks"}}, sources}, options, run);
  }
};

TEST_F(Quadrefine, RegionsHaveOneMesh) {
  options.sizes.size = 0.25;
  options.refine.order = 2;
  const QuadMesh mesh = quads();
  EXPECT_EQ(mesh.num_elems(), 32);
  EXPECT_EQ(mesh.order, 2);
  const ProvenanceStep& step = mesh.provenance.back();
  EXPECT_EQ(step.tool, "quadrefine");
  ASSERT_EQ(step.inputs.size(), 1u);
  EXPECT_EQ(step.inputs.front().format, "block-layout");
  EXPECT_NE(step.options.find("\"size\":0.25"), std::string::npos) << step.options;
}

TEST_F(Quadrefine, TextsAreReadAndSourcesAreAnInput) {
  options.counts = {"bottom=3"};
  options.sizes.size = 0.5;
  SizeSources sources;
  sources.points = {{{0, 0}, 0.5, 0.1}};
  const QuadMesh mesh = quads(Input<SizeSources>(sources, {"sizes.json", "digest of the sizes"}));
  EXPECT_EQ(mesh.num_elems() % 3, 0);
  ASSERT_EQ(mesh.provenance.back().inputs.size(), 2u);
  EXPECT_EQ(mesh.provenance.back().inputs.back().sha256, "digest of the sizes");
}

TEST_F(Quadrefine, OptionsOutsideTheirIntervalsAreUsageErrors) {
  for (const int order : {-1, 0, 21}) {
    options.refine.order = order;
    EXPECT_THROW(quads(), UsageError) << order;
  }
  options = {};
  options.sizes.size = -1;
  EXPECT_THROW(quads(), UsageError);
}

TEST_F(Quadrefine, TextsThatCannotBeReadAreUsageErrorsBeforeTheMesh) {
  for (const auto& [member, text] : std::vector<std::pair<std::vector<std::string> QuadrefineOptions::*, std::string>>{
           {&QuadrefineOptions::counts, "3"},
           {&QuadrefineOptions::near, "bottom"},
           {&QuadrefineOptions::gradings, "bottom"},
           {&QuadrefineOptions::walls, "bottom:first=-1,layers=2"}}) {
    QuadrefineOptions broken;
    (broken.*member) = {text};
    EXPECT_THROW(broken.validate(), UsageError) << text;
  }
  options.yplus = 1;
  EXPECT_THROW(options.validate(), UsageError) << "no wall";
}

TEST_F(Quadrefine, NamesAreLookedUpInTheFaceBeforeThereAreBlocks) {
  options.counts = {"bottom=3"};
  EXPECT_NO_THROW(require_quadrefine_of(layout.face, {}, {}, options));
  options.counts = {"nowhere=3"};
  EXPECT_THROW(require_quadrefine_of(layout.face, {}, {}, options), UsageError);
  options.counts = {};
  options.sizes.size = 1e-6;
  EXPECT_THROW(require_quadrefine_of(layout.face, {}, {}, options), ComputeError) << "far too many";
}

TEST_F(Quadrefine, WallsAskForOffsetsOrClearances) {
  options.walls = {"bottom:first=0.01,growth=1,layers=4", "top:first=0.01,growth=1,layers=4,blocks=own"};
  const std::vector<std::string> offsets = offsets_of(options), clearances = clearances_of(options);
  ASSERT_EQ(offsets.size(), 1u);
  EXPECT_TRUE(offsets.front().starts_with("top=0.0")) << offsets.front();
  ASSERT_EQ(clearances.size(), 1u);
  EXPECT_TRUE(clearances.front().starts_with("bottom=")) << clearances.front();
}

}  // namespace
}  // namespace quadrille::stage
