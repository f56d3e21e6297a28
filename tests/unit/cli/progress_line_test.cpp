#include "cli/progress_line.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <regex>

#include "cli/messages.hpp"

namespace quadrille::cli {
namespace {

/// The lines that a terminal shows after `written`, without blanks at their ends.
std::vector<std::string> screen(const std::string& written) {
  std::vector<std::string> lines{""};
  std::size_t column = 0;
  for (const char c : written) {
    std::string& line = lines.back();
    if (c == '\r') {
      column = 0;
    } else if (c == '\b') {
      --column;
    } else if (c == '\n') {
      lines.emplace_back();
      column = 0;
    } else {
      line.resize(std::max(line.size(), column + 1), ' ');
      line[column++] = c;
    }
  }
  for (std::string& line : lines) line.erase(line.find_last_not_of(' ') + 1);
  return lines;
}

/// The present line of the terminal, whatever the seconds.
std::string shown(const std::string& written) {
  return std::regex_replace(screen(written).back(), std::regex("[0-9]+ s$"), "N s");
}

struct Shown {
  explicit Shown(ProgressStyle style)
      : line(progress, std::move(style), [this](const std::string& text) {
          written += text;
          ++writes;
        }) {}

  Progress progress;
  std::string written;
  int writes = 0;
  ProgressLine line;
};

ProgressStyle terminal() {
  ProgressStyle style;
  style.is_terminal = true;
  style.delay = 0;
  style.title = "sample";
  return style;
}

TEST(ProgressText, HasAShareWhereTheTotalIsKnown) {
  using Total = Progress::Total;
  EXPECT_EQ(progress_text("padapt", "adapt", {}, 12.9), "padapt: adapt, 12 s");
  EXPECT_EQ(progress_text("t", "p", {{"elements", 999, 1000, Total::exact}}, 0), "t: p, elements 99 %, 0 s");
  EXPECT_EQ(progress_text("t", "p", {{"elements", 1001, 1000, Total::exact}}, 0), "t: p, elements 100 %, 0 s");
  EXPECT_EQ(progress_text("t", "p", {{"solutions", 3, 20, Total::bound}}, 0), "t: p, solutions 3 of at most 20, 0 s");
  EXPECT_EQ(progress_text("t", "p", {{"choices", 7, 0, Total::unknown}}, 0), "t: p, choices 7, 0 s");
  EXPECT_EQ(progress_text("t", "p", {{"boundary", 0, 0, Total::unknown}}, 0), "t: p, boundary, 0 s");
  EXPECT_EQ(progress_text("t", "p", {{"a", 1, 2, Total::bound}, {"b", 1, 4, Total::exact}}, 60),
            "t: p, a 1 of at most 2, b 25 %, 60 s");
}

TEST(ProgressLine, IsOneLineThatIsOverwrittenAndErased) {
  Shown s(terminal());
  s.line.begin_phase("work");
  EXPECT_EQ(shown(s.written), "sample: work, N s");
  {
    const Progress::Part part(&s.progress, "elements", 4);
    part.advance();
    s.line.update();
    EXPECT_EQ(shown(s.written), "sample: work, elements 25 %, N s");
  }
  s.line.update();
  EXPECT_EQ(shown(s.written), "sample: work, N s");
  s.line.end_phase();
  EXPECT_EQ(screen(s.written), std::vector<std::string>{""});
  s.line.update();
  s.line.begin_phase("more");
  EXPECT_EQ(shown(s.written), "sample: more, N s");
}

TEST(ProgressLine, IsErasedAtTheEnd) {
  std::string written;
  {
    const Progress progress;
    ProgressLine line(progress, terminal(), [&](const std::string& text) { written += text; });
    line.begin_phase("work");
    EXPECT_NE(screen(written).back(), "");
  }
  EXPECT_EQ(screen(written), std::vector<std::string>{""});
}

TEST(ProgressLine, MessagesStandAboveIt) {
  Shown s(terminal());
  s.line.begin_phase("work");
  s.line.print("hello");
  ASSERT_EQ(screen(s.written).size(), 2u);
  EXPECT_EQ(screen(s.written)[0], "hello");
  EXPECT_EQ(shown(s.written), "sample: work, N s");
  s.line.end_phase();
  s.line.print("bye");
  EXPECT_EQ(screen(s.written), (std::vector<std::string>{"hello", "bye", ""}));
}

TEST(ProgressLine, IsNeverLongerThanTheTerminal) {
  ProgressStyle style = terminal();
  style.title = std::string(1000, 'x');
  Shown s(style);
  s.line.begin_phase("work");
  EXPECT_LT(screen(s.written).back().size(), 1000u);
  EXPECT_GT(screen(s.written).back().size(), 0u);
}

TEST(ProgressLine, InnerPartsAreLeftOutWhereItIsTooLong) {
  Shown s(terminal());
  const Progress::Part outer(&s.progress, "solutions", 20, Progress::Total::bound);
  const Progress::Part inner(&s.progress, "elements of which there are very many, as the length of this name shows", 4);
  s.line.begin_phase("work");
  EXPECT_EQ(shown(s.written), "sample: work, solutions 0 of at most 20, N s");
}

TEST(ProgressLine, ComesAfterTheDelayOnly) {
  ProgressStyle style = terminal();
  style.delay = 1e9;
  Shown late(style);
  late.line.begin_phase("work");
  late.line.update();
  late.line.print("hello");
  late.line.end_phase();
  EXPECT_EQ(late.written, "hello\n");
  style.seconds_before = 1e9;  // of the earlier stages of a pipeline
  Shown now(style);
  now.line.begin_phase("work");
  EXPECT_EQ(screen(now.written).back().substr(0, 22), "sample: work, 10000000");
}

TEST(ProgressLine, HiddenPhasesShowNothing) {
  ProgressStyle style = terminal();
  style.hidden_phases = {"read"};
  Shown s(style);
  s.line.begin_phase("read");
  s.line.update();
  EXPECT_EQ(s.written, "");
  s.line.begin_phase("work");
  EXPECT_EQ(shown(s.written), "sample: work, N s");
  s.line.begin_phase("read");
  s.line.update();
  EXPECT_EQ(screen(s.written), std::vector<std::string>{""});
}

TEST(ProgressLine, ElsewhereEachStateIsALine) {
  ProgressStyle style = terminal();
  style.is_terminal = false;
  Shown s(style);
  s.line.begin_phase("work");
  EXPECT_EQ(s.written, "sample: work ...\n");
  {
    const Progress::Part part(&s.progress, "elements", 4);
    s.line.update();
  }
  s.line.end_phase();
  EXPECT_EQ(std::regex_replace(s.written, std::regex("[0-9]+ s\n$"), "N s\n"),
            "sample: work ...\nsample: work, elements 0 %, N s\n");
}

TEST(ProgressLine, WhatDoesNotChangeIsNotWrittenAgain) {
  ProgressStyle style = terminal();
  style.seconds_before = 0.1;
  Shown s(style);
  s.line.begin_phase("work");
  for (int i = 0; i < 1000; ++i) s.line.update();
  EXPECT_LT(s.writes, 500);  // the seconds may change
}

TEST(ProgressTicker, UpdatesTheLineWithoutBeingAsked) {
  Progress progress;
  const Progress::Part part(&progress, "steps");
  std::mutex mutex;
  std::condition_variable changed;
  std::string written;
  ProgressLine line(progress, terminal(), [&](const std::string& text) {
    const std::lock_guard lock(mutex);
    written += text;
    changed.notify_all();
  });
  const ProgressTicker ticker(line, 1e-3);
  line.begin_phase("work");
  part.advance(5);
  std::unique_lock lock(mutex);
  EXPECT_TRUE(
      changed.wait_for(lock, std::chrono::seconds(60), [&] { return shown(written) == "sample: work, steps 5, N s"; }));
}

TEST(ProgressLine, ASignalErasesIt) {
  const auto interrupted = [] {
    const Progress progress;
    ProgressLine line(progress, terminal(), write_to_terminal);
    line.begin_phase("work");
    erase_progress_line();
    line.update();
    _exit(0);
  };
  EXPECT_EXIT(interrupted(), testing::ExitedWithCode(0), "^\rsample: work, [0-9]+ s\r +\r$");
}

}  // namespace
}  // namespace quadrille::cli
