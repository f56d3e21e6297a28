#include "base/child_process.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

#include "base/error.hpp"

namespace quadrille {
namespace {

const std::string crash = "the reader crashed";

// The message of the E that `work` raises in a child; empty when it raises none.
template <class E>
std::string message_of(const std::function<std::string()>& work, int cpu_seconds = 10) {
  try {
    run_in_child(work, crash, cpu_seconds);
  } catch (const E& e) {
    return e.what();
  }
  return {};
}

TEST(ChildProcess, returns_all_bytes_zeros_included) {
  std::string bytes(1 << 20, 'x');
  for (size_t i = 0; i < bytes.size(); i += 7) bytes[i] = static_cast<char>(i);
  EXPECT_EQ(run_in_child([&] { return bytes; }, crash), bytes);
  EXPECT_EQ(run_in_child([] { return std::string(); }, crash), "");
}

TEST(ChildProcess, works_on_its_own_copy_of_memory) {
  int x = 1;
  run_in_child([&] { return x = 2, std::string(); }, crash);
  EXPECT_EQ(x, 1);
}

TEST(ChildProcess, rethrows_errors_with_type_message_and_rule) {
  EXPECT_EQ(message_of<ComputeError>([]() -> std::string { throw ComputeError("none"); }), "none");
  EXPECT_EQ(message_of<OutputError>([]() -> std::string { throw OutputError("full"); }), "full");
  EXPECT_EQ(message_of<UsageError>([]() -> std::string { throw UsageError("what"); }), "what");
  EXPECT_EQ(message_of<Defect>([]() -> std::string { throw std::runtime_error("odd"); }), "odd");
  try {
    run_in_child([]() -> std::string { throw FormatError("broken", "TRI-R01"); }, crash);
    FAIL();
  } catch (const FormatError& e) {
    EXPECT_STREQ(e.what(), "TRI-R01: broken");
    EXPECT_EQ(e.rule, "TRI-R01");
  }
}

TEST(ChildProcess, a_crash_is_a_format_error) {
  const auto by_signal = [](int signal) { return [signal]() -> std::string { return raise(signal), std::string(); }; };
  EXPECT_EQ(message_of<FormatError>(by_signal(SIGABRT)), crash);
  EXPECT_EQ(message_of<FormatError>(by_signal(SIGSEGV)), crash);
  EXPECT_EQ(message_of<FormatError>([]() -> std::string { _exit(3); }), crash);
  EXPECT_EQ(message_of<FormatError>([]() -> std::string { _exit(0); }), crash);
}

TEST(ChildProcess, an_endless_loop_is_ended) {
  volatile bool forever = true;
  const auto loop = [&] {
    while (forever) continue;
    return std::string();
  };
  EXPECT_EQ(message_of<FormatError>(loop, 1), crash);
}

TEST(ChildProcess, running_out_of_memory_is_a_format_error) {
  const auto endless = []() -> std::string { throw std::bad_alloc(); };
  EXPECT_EQ(message_of<FormatError>(endless), crash);
}

TEST(ChildProcess, does_not_run_the_parents_exit_handlers) {
  static int parent = getpid();
  std::atexit([] {
    if (getpid() != parent) raise(SIGKILL);
  });
  EXPECT_EQ(run_in_child([] { return std::string("done"); }, crash), "done");
}

}  // namespace
}  // namespace quadrille
