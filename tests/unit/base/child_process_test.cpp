#include "base/child_process.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille {

namespace {

TEST(Resources, ThoseThatAreExhaustedAreNamedWithTheirLimits) {
  EXPECT_NO_THROW(require_resources(ENOENT, "x.step"));
  EXPECT_EQ(message_of<ComputeError>([] { require_resources(EMFILE, "x.step: cannot be read"); }),
            "x.step: cannot be read: no more open files: raise their limit (ulimit -n)");
  EXPECT_EQ(message_of<ComputeError>([] { require_resources(EAGAIN, "cannot start a process"); }),
            "cannot start a process: no more processes: raise their limit (ulimit -u)");
  EXPECT_THROW(require_resources(ENOMEM, ""), ComputeError);
}

const std::string crash = "the reader crashed";

// The message of the E that `work` raises in a child; empty when it raises none.
template <class E>
std::string message_of(const std::function<std::string()>& work, int cpu_seconds = 10) {
  try {
    run_in_child(work, crash, {.cpu_seconds = cpu_seconds});
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

// A program for run_program(): prints, and exits with the code `code`; without arguments, as it is run.
std::string script(const std::string& name, const std::string& text) {
  const std::string path = testing::TempDir() + name + std::to_string(getpid());
  std::ofstream(path) << "#!/bin/sh\n" << text << "\n";
  chmod(path.c_str(), 0700);
  return path;
}

template <class E>
std::string message_of_program(const std::string& program) {
  try {
    run_program(program, "input", crash, {.cpu_seconds = 10});
  } catch (const E& e) {
    return e.what();
  }
  return {};
}

TEST(Program, gets_the_input_and_answers_by_its_output) {
  const std::string program = script("answers", "printf s; cat >$0.input; printf v; cat $0.input");
  std::string bytes(1 << 20, 'x');
  bytes[5] = '\0';
  EXPECT_EQ(run_program(program, bytes, crash), bytes);
  EXPECT_EQ(run_program(program, "", crash), "");
  const std::string counting = script("counts", "printf sv; wc -c");
  rlimit whole{};
  getrlimit(RLIMIT_FSIZE, &whole);
  const rlimit small{100, whole.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  EXPECT_EQ(run_program(counting, bytes, crash), "1048576\n");
  setrlimit(RLIMIT_FSIZE, &whole);
}

TEST(Program, a_crash_is_a_format_error) {
  EXPECT_EQ(message_of_program<FormatError>(script("crashes", "printf s; kill -SEGV $$")), crash);
  EXPECT_THROW(run_program(script("reads_nothing", "printf s; exit 1"), std::string(1 << 22, 'x'), crash), FormatError);
  EXPECT_EQ(message_of_program<FormatError>(script("fails", "printf sv; exit 1")), crash);
  EXPECT_EQ(message_of_program<FormatError>(script("silent", "printf s")), crash);
}

TEST(Program, one_that_is_missing_or_ends_before_it_starts_is_named) {
  EXPECT_EQ(message_of_program<Error>("/nowhere/reader"), "/nowhere/reader cannot be run: No such file or directory");
  for (const std::string way : {"exit 127", "kill -ABRT $$"}) {
    const std::string unloaded = script("unloaded", way);
    EXPECT_EQ(message_of_program<Error>(unloaded), unloaded + " cannot be started");
  }
}

TEST(Program, answers_with_the_result_or_the_error_of_its_work_and_prints_nothing_else) {
  const auto answer = [](const std::string& input) -> std::string {
    std::printf("a message of a library\n");
    std::fflush(stdout);
    if (input == "broken") throw FormatError("broken", "TRI-R01");
    return "<" + input + ">";
  };
  const auto answered = [&](const std::string& input) {
    std::array<int, 2> in{}, out{};
    EXPECT_EQ(pipe(in.data()) + pipe(out.data()), 0);
    EXPECT_EQ(write(in[1], input.data(), input.size()), static_cast<ssize_t>(input.size()));
    close(in[1]);
    const pid_t child = fork();
    if (child == 0) {
      dup2(in[0], STDIN_FILENO), dup2(out[1], STDOUT_FILENO);
      answer_parent(answer);
    }
    close(in[0]), close(out[1]);
    std::array<char, 100> bytes{};
    std::string text;
    for (ssize_t n = 0; (n = read(out[0], bytes.data(), bytes.size())) > 0;) text.append(bytes.data(), n);
    close(out[0]);
    waitpid(child, nullptr, 0);
    return text;
  };
  EXPECT_EQ(answered("input"), "sv<input>");
  EXPECT_EQ(answered("broken"), std::string("sfTRI-R01\0TRI-R01: broken", 25));
}

TEST(HelperProgram, is_in_libexec_beside_the_folder_of_this_program) {
  const std::string path = helper_program("reader"), end = "/../libexec/reader";
  ASSERT_GT(path.size(), end.size());
  EXPECT_EQ(path.substr(path.size() - end.size()), end);
  EXPECT_EQ(path.front(), '/');
}

}  // namespace

}  // namespace quadrille
