#include "cli/outcome.hpp"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>

namespace quadrille::cli {

namespace {

TEST(OutcomeOf, WorkThatEndsIsASuccess) {
  bool is_done = false;
  const Outcome outcome = outcome_of([&] { is_done = true; });
  EXPECT_TRUE(is_done && outcome.is_success());
  EXPECT_EQ(outcome.message, "");
}

TEST(OutcomeOf, EachErrorHasItsCodeAndKeepsItsMessage) {
  const auto expect = [](const std::function<void()>& work, ExitCode code, const std::string& message) {
    const Outcome outcome = outcome_of(work);
    EXPECT_EQ(outcome.code, code) << message;
    EXPECT_EQ(outcome.message, message);
    EXPECT_FALSE(outcome.is_success());
  };
  expect([] { throw ComputeError("no layout"); }, ExitCode::no_result, "no layout");
  expect([] { throw UsageError("no shape given"); }, ExitCode::usage, "no shape given");
  expect([] { throw FormatError("a hole", "TRI-R01"); }, ExitCode::bad_input, "TRI-R01: a hole");
  expect([] { throw OutputError("disc is full"); }, ExitCode::bad_output, "disc is full");
  expect([] { throw Defect("no face"); }, ExitCode::defect, "internal error, please report it: no face");
  expect([] { throw std::out_of_range("at"); }, ExitCode::defect, "internal error, please report it: at");
  expect([] { throw 1; }, ExitCode::defect, "internal error, please report it: unknown exception");
}

TEST(OutcomeOf, WithoutMemoryThereIsNoResult) {
  const Outcome outcome = outcome_of([] { throw std::bad_alloc(); });
  EXPECT_EQ(outcome.code, ExitCode::no_result);
  EXPECT_TRUE(outcome.message.starts_with("out of memory, at ")) << outcome.message;
}

TEST(ErrorText, TellsHowToGetHelpAfterAMistakeOnTheCommandLine) {
  EXPECT_EQ(error_text("padapt", {ExitCode::no_result, "no field"}), "padapt: no field\n");
  EXPECT_EQ(error_text("padapt", {ExitCode::usage, "no field"}), "padapt: no field\ntry 'padapt --help'\n");
}

}  // namespace

}  // namespace quadrille::cli
