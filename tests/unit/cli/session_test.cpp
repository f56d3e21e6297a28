#include "cli/session.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>

#include "base/parallel.hpp"
#include "base/version.hpp"

namespace quadrille::cli {
namespace {

template <typename Act>
std::string errors_of(const Act& act) {
  testing::internal::CaptureStderr();
  act();
  return testing::internal::GetCapturedStderr();
}

double seconds(Session& session, const std::string& key) {
  for (const auto& [name, value] : session.report().entries())
    if (name == "timings." + key) return std::get<double>(value);
  return -1;
}

/// Uses this much CPU time.
void work(double duration) {
  const std::clock_t start = std::clock();
  while (static_cast<double>(std::clock() - start) < duration * CLOCKS_PER_SEC) {
  }
}

TEST(Session, InformationIsPrintedAtItsVerbosity) {
  const auto printed = [](int verbosity) {
    return errors_of([&] {
      const Session session("tool", "{}", verbosity);
      session.info("always", 0), session.info("more"), session.info("most", 2);
    });
  };
  EXPECT_EQ(printed(-1), "");
  EXPECT_EQ(printed(0), "tool: always\n");
  EXPECT_EQ(printed(1), "tool: always\ntool: more\n");
  EXPECT_EQ(printed(2), "tool: always\ntool: more\ntool: most\n");
}

TEST(Session, NoThreadsAreAsManyAsProcessors) {
  EXPECT_EQ(Session("tool", "{}", 0, 3).threads(), 3);
  EXPECT_EQ(Session("tool", "{}", 0, 0).threads(), available_processors());
}

TEST(Session, AStepIsAppendedToTheProvenance) {
  const Provenance before{{"cad2tri", "0.0.1", {{"step", "a"}}, "{}"}};
  const Provenance chain = Session("tool", R"({"size":1})", 0).provenance(before, {{"tri-mesh", "b"}});
  ASSERT_EQ(chain.size(), 2u);
  EXPECT_EQ(chain[0].tool, "cad2tri");
  EXPECT_EQ(chain[1].tool, "tool");
  EXPECT_EQ(chain[1].version, version);
  EXPECT_EQ(chain[1].inputs.at(0).sha256, "b");
  EXPECT_EQ(chain[1].options, R"({"size":1})");
}

TEST(Session, EachPhaseHasItsTimes) {
  Session session("tool", "{}", 0);
  session.begin_phase("first");
  work(0.02);
  session.begin_phase("second");
  session.finish();
  EXPECT_GE(seconds(session, "first.cpu_seconds"), 0.015);
  EXPECT_GE(seconds(session, "first.wall_seconds"), 0.015);
  EXPECT_GE(seconds(session, "second.cpu_seconds"), 0) << "ended by the end of the run";
  EXPECT_LT(seconds(session, "second.cpu_seconds"), seconds(session, "first.cpu_seconds"));
  EXPECT_GE(seconds(session, "total.cpu_seconds"), seconds(session, "first.cpu_seconds"));
  EXPECT_GE(seconds(session, "total.wall_seconds"), seconds(session, "first.wall_seconds"));
}

TEST(Session, PhasesArePrintedWhenMostIsAskedFor) {
  const std::string printed = errors_of([] {
    Session session("tool", "{}", 2);
    session.begin_phase("solve");
    session.end_phase();
    session.end_phase();
  });
  EXPECT_TRUE(printed.starts_with("tool: solve: ")) << printed;
  EXPECT_TRUE(printed.ends_with(" ms\n")) << printed;
  EXPECT_EQ(std::ranges::count(printed, '\n'), 1);
}

TEST(Session, EarlierWorkIsLeftOut) {
  work(0.05);
  Session session("tool", "{}", 0);
  session.leave_out_earlier_work();
  session.finish();
  EXPECT_LT(seconds(session, "total.cpu_seconds"), 0.04);
}

}  // namespace
}  // namespace quadrille::cli
