#include "stage/stageview.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "../samples.hpp"
#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille::stage {
namespace {

std::string refusal(const std::function<void(StageviewOptions&)>& set, const std::string& ending = "svg",
                    std::size_t num_files = 1) {
  StageviewOptions options;
  set(options);
  return message_of<UsageError>([&] { begun_view(options, ending, num_files); });
}

TEST(BegunView, IsAPageByItsEndingAndDataWithAWorkbench) {
  StageviewOptions options;
  EXPECT_FALSE(begun_view(options, "svg", 1).is_page);
  EXPECT_TRUE(begun_view(options, "html", 3).is_page);
  EXPECT_FALSE(begun_view(options, "json", 1).is_page);
  options.workbench_file = "state.json";
  const View view = begun_view(options, "json", 3);
  EXPECT_TRUE(view.is_page && view.is_data);
  EXPECT_FALSE(begun_view(options, "html", 3).is_data);
  EXPECT_TRUE(view.stages.empty());
}

TEST(BegunView, RefusesOptionsThatExcludeEachOther) {
  const auto nothing = [](StageviewOptions&) {};
  expect_contains(refusal(nothing, "svg", 2), "several files");
  expect_contains(refusal([](auto& o) { o.is_comparison = true; }, "svg", 3), "--compare needs two files");
  expect_contains(refusal([](auto& o) { o.is_comparison = true, o.field_file = "f"; }, "svg", 2), "--field");
  expect_contains(refusal([](auto& o) { o.run_report_file = "r.json"; }), "--run-report");
  expect_contains(refusal([](auto& o) { o.workbench_file = "w.json"; }), "--workbench");
  expect_contains(refusal([](auto& o) { o.window = "0,0,1,1"; }, "html"), "--window is for pictures");
  expect_contains(refusal([](auto& o) { o.view = "iso", o.window = "0,0,1,1"; }), "--view");
  expect_contains(refusal([](auto& o) { o.labels_all = o.labels_none = true; }), "--curve-labels");
}

TEST(BegunView, RefusesWindowsAndDirectionsThatAreNone) {
  for (const char* window : {"0,0,1", "0,0,1,1,2", "1,0,0,1", "0,1,1,1", "0,0,1,x", "0,0,1,inf"})
    expect_contains(refusal([&](auto& o) { o.window = window; }), "is not X0,Y0,X1,Y1");
  for (const char* view : {"0,0,0", "1,0", "1,0,0,0", "up"})
    expect_contains(refusal([&](auto& o) { o.view = view; }), "is neither iso nor X,Y,Z");
}

TEST(Stageview, ShowsThePartOfTheWindow) {
  StageviewOptions options;
  quadrille::Run run;
  View view = begun_view(options, "svg", 1);
  add_to(view, samples::quad_mesh(), {"square.quad.h5", ""}, run);
  const std::string whole = stageview(view, "square", options);
  EXPECT_TRUE(whole.starts_with("<svg") || whole.starts_with("<?xml"));
  options.window = "100,100,101,101";
  EXPECT_THROW(stageview(view, "square", options), UsageError);
}

TEST(Stageview, RefusesAFieldBesideOtherFilesThanNodes) {
  StageviewOptions options;
  options.field_file = "square.field.h5";
  quadrille::Run run;
  View view = begun_view(options, "svg", 1);
  add_to(view, samples::quad_mesh(), {"square.quad.h5", ""}, run);
  expect_contains(message_of<UsageError>([&] { stageview(view, "square", options); }),
                  "--field needs a critical-points");
}

}  // namespace
}  // namespace quadrille::stage
