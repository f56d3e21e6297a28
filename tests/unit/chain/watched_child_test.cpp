#include "chain/watched_child.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "base/child_process.hpp"
#include "temporary_folder.hpp"

namespace quadrille::chain {

namespace {

using Clock = Budget::Clock;

int sleep_long() { return sleep(3600), 0; }

int work_long() {
  volatile bool forever = true;
  while (forever) continue;
  return 0;
}

int fill_memory() {
  const std::size_t size = 300 << 20;
  std::fill_n(static_cast<volatile char*>(std::malloc(size)), size, 'x');
  return sleep_long();
}

// The same work in a child of the process that is run.
std::function<int()> in_a_child(const std::function<int()>& work) {
  return [work] { return start_child(work, SIGKILL), sleep_long(); };
}

TEST(RunChild, gives_the_exit_code_within_the_limits) {
  Budget budget({.seconds = 600, .memory = std::size_t{1} << 40});
  EXPECT_EQ(run_child([] { return 0; }, budget, Share::all).code, 0);
  EXPECT_EQ(run_child([] { return 3; }, budget, Share::most).code, 3);
  EXPECT_EQ(run_child([] { return raise(SIGKILL); }, budget, Share::all).code, 137);
  EXPECT_EQ(run_child([] { return std::abort(), 0; }, budget, Share::all).code, 134);
  EXPECT_EQ(budget.runs().size(), 4);
}

TEST(RunChild, runs_without_limits) {
  Budget budget;
  const ChildEnd end = run_child([] { return 5; }, budget, Share::all);
  EXPECT_EQ(end.code, 5);
  EXPECT_EQ(end.stopped, std::nullopt);
  EXPECT_GT(end.wall_seconds, 0);
  EXPECT_EQ(budget.runs().front().wall_seconds, end.wall_seconds);
}

TEST(RunChild, writes_what_the_child_has_printed_once) {
  Budget budget;
  testing::internal::CaptureStdout();
  std::printf("before, ");
  run_child([] { return std::printf("child, "), 0; }, budget, Share::all);
  std::printf("after");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "before, child, after");
}

TEST(RunChild, is_stopped_when_the_cpu_seconds_are_used_up_in_a_descendant_too) {
  for (const auto& work : {std::function<int()>(work_long), in_a_child(work_long)}) {
    Budget budget({.seconds = 1}, Clock::now() + std::chrono::hours(1), {{0.6, 0}});  // so that only CPU seconds count
    const ChildEnd end = run_child(work, budget, Share::all);
    EXPECT_EQ(end.code, stopped_code);
    EXPECT_GT(end.cpu_seconds, 0.3);
    EXPECT_TRUE(
        matches(end.stopped.value_or(""), "stopped after .+\\... s of CPU time of all stages: --max-seconds is 1"))
        << *end.stopped;
    EXPECT_EQ(budget.runs().back().cpu_seconds, end.cpu_seconds);
  }
}

TEST(RunChild, is_stopped_when_the_seconds_have_elapsed) {
  Budget budget({.seconds = 0.2});
  const ChildEnd end = run_child(sleep_long, budget, Share::most);
  EXPECT_EQ(end.code, stopped_code);
  EXPECT_TRUE(matches(end.stopped.value_or(""),
                      "stopped after .+\\... s of all stages: --max-seconds is 0.2, and "
                      "the rest is kept for quads without a field"))
      << *end.stopped;
}

TEST(RunChild, is_not_started_when_the_seconds_are_used_up) {
  const TemporaryFolder folder;
  Budget budget({.seconds = 1}, Clock::now(), {{1, 0}, {0.5, 0}});
  const ChildEnd end = run_child([&] { return folder.touch("started"), 0; }, budget, Share::all);
  EXPECT_EQ(end.code, stopped_code);
  EXPECT_EQ(end.cpu_seconds, 0);
  EXPECT_EQ(end.stopped, "not started after 1.50 s of CPU time of all stages: --max-seconds is 1");
  EXPECT_FALSE(folder.has("started"));
  EXPECT_EQ(budget.runs().size(), 3);
}

TEST(RunChild, is_stopped_when_a_descendant_has_more_memory) {
  for (const auto& work : {std::function<int()>(fill_memory), in_a_child(fill_memory)}) {
    Budget budget({.memory = 200 << 20});
    const ChildEnd end = run_child(work, budget, Share::all);
    EXPECT_EQ(end.code, stopped_code);
    EXPECT_TRUE(matches(end.stopped.value_or(""), "stopped at .+M of memory: --max-memory is 200M")) << *end.stopped;
  }
}

TEST(RunChild, may_reserve_more_memory) {
  Budget budget({.memory = 1 << 30});  // more than this program has, also with sanitizers
  const auto reserve = [] {
    const void* memory = mmap(nullptr, std::size_t{4} << 30, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    return usleep(50000), memory == MAP_FAILED ? 1 : 0;
  };
  EXPECT_EQ(run_child(reserve, budget, Share::all).code, 0);
}

std::string part;  // a file of the next test, for its signal handler

TEST(RunChild, can_clean_up_when_it_is_stopped) {
  const TemporaryFolder folder;
  part = folder.file("part");
  Budget budget({.memory = 200 << 20, .grace = 60});
  const auto work = [&] {
    std::signal(SIGTERM, [](int) { _exit(unlink(part.c_str())); });
    folder.touch("part");
    return fill_memory();
  };
  EXPECT_EQ(run_child(work, budget, Share::all).code, stopped_code);
  EXPECT_FALSE(folder.has("part"));
}

TEST(RunChild, is_killed_with_its_descendants_if_they_do_not_end) {
  for (const auto action : {SIG_IGN, SIG_DFL}) {
    const TemporaryFolder folder;
    std::array<int, 2> ends{};  // is closed when the last process that can write has ended
    ASSERT_EQ(pipe(ends.data()), 0);
    const auto descendant = [&] { return std::signal(SIGTERM, SIG_IGN), folder.touch("started"), sleep_long(); };
    const auto work = [&] {
      std::signal(SIGTERM, action);
      start_child(descendant, 0);
      return comes_true([&] { return folder.has("started"); }) ? fill_memory() : 1;
    };
    Budget budget({.memory = 200 << 20, .grace = 0.1});
    EXPECT_EQ(run_child(work, budget, Share::all).code, stopped_code);
    close(ends[1]);
    pollfd end{ends[0], POLLIN, 0};
    EXPECT_EQ(poll(&end, 1, 60000), 1);
    close(ends[0]);
  }
}

TEST(RunChild, is_ended_by_a_signal_to_this_process_which_ends_by_it) {
  for (const std::optional<double> seconds : {std::optional<double>(), std::optional(600.0)}) {
    const TemporaryFolder folder;
    const std::string script = "trap 'rm started; exit 1' TERM; touch started; while :; do sleep 0.01; done";
    const pid_t parent = start_child(
        [&] {
          std::signal(SIGINT, SIG_DFL);  // shells may ignore it
          Budget budget({.seconds = seconds, .grace = 60});
          return run_command({"sh", "-c", "cd " + folder.path() + "; " + script}, {}, budget, Share::all).code;
        },
        SIGKILL);
    EXPECT_TRUE(comes_true([&] { return folder.has("started"); }));
    kill(parent, SIGINT);
    int status = 0;
    waitpid(parent, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT);
    EXPECT_FALSE(folder.has("started"));
  }
}

TEST(RunCommand, gets_signals_as_without_a_budget) {
  const auto signals = [](const std::string& process) {
    std::ifstream file("/proc/" + process + "/status");
    std::string found;
    for (std::string line; std::getline(file, line);)
      if (line.starts_with("SigBlk:") || line.starts_with("SigIgn:")) found += line + "\n";
    return found;
  };
  std::string found;
  Budget budget({.seconds = 600});
  const std::vector<std::string> words{"sh", "-c", "grep -E '^Sig(Blk|Ign):' /proc/self/status >&2"};
  EXPECT_EQ(run_command(words, {.errors = &found}, budget, Share::all).code, 0);
  EXPECT_EQ(found, signals("self"));
}

TEST(RunCommand, reads_the_descriptor_and_its_errors_are_captured) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> input(std::tmpfile(), std::fclose);
  const std::string text(200000, 'x');  // more than a pipe has room for
  std::fputs(text.c_str(), input.get());
  std::rewind(input.get());
  std::string errors;
  Budget budget;
  const Streams streams{.input = fileno(input.get()), .errors = &errors};
  EXPECT_EQ(run_command({"sh", "-c", "cat >&2; exit 3"}, streams, budget, Share::all).code, 3);
  EXPECT_EQ(errors, text);
}

TEST(RunCommand, that_cannot_be_started_is_named) {
  std::string errors;
  Budget budget;
  EXPECT_EQ(run_command({"/nowhere/tool"}, {.errors = &errors}, budget, Share::all).code, 127);
  EXPECT_EQ(errors, "/nowhere/tool cannot be started: No such file or directory\n");
}

// A supervisor in a process of its own, with a scratch folder that exists.
pid_t start_supervisor(const TemporaryFolder& folder, const std::function<int(bool)>& work) {
  std::filesystem::create_directory(folder.file("scratch"));
  const auto body = [&folder, work] {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) std::signal(signal, SIG_DFL);  // shells may ignore them
    return supervise(work, [&] { return folder.file("scratch"); });
  };
  return start_child(body, SIGKILL);
}

std::string handled;  // the file that the next function makes

void handle_signal(int) {
  close(creat(handled.c_str(), 0600));
  _exit(0);
}

int status_of(pid_t process) {
  int status = 0;
  waitpid(process, &status, 0);
  return status;
}

TEST(Supervise, returns_the_exit_code_and_removes_the_scratch_folder) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.file("scratch/inner"));
  EXPECT_EQ(
      supervise([&](bool is_second_try) { return is_second_try ? 1 : 3; }, [&] { return folder.file("scratch"); }), 3);
  EXPECT_FALSE(folder.has("scratch"));
  EXPECT_EQ(supervise([](bool) { return 0; }, [&] { return folder.file("none"); }), 0);
}

TEST(Supervise, repeats_work_that_crashed_in_an_empty_folder) {
  for (const int signal : {SIGKILL, SIGSEGV, SIGABRT}) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.file("scratch"));
    const auto work = [&](bool is_second_try) {
      if (is_second_try) return folder.has("scratch") && !folder.has("scratch/part") ? 5 : 6;
      folder.touch("scratch/part");
      return raise(signal);
    };
    EXPECT_EQ(supervise(work, [&] { return folder.file("scratch"); }), 5);
    EXPECT_FALSE(folder.has("scratch"));
  }
}

TEST(Supervise, ends_by_the_signal_that_ended_the_work) {
  for (const int signal : {SIGKILL, SIGXCPU}) {  // the former twice
    const TemporaryFolder folder;
    const auto work = [&](bool is_second_try) { return is_second_try && signal != SIGKILL ? 1 : raise(signal); };
    const int status = status_of(start_supervisor(folder, work));
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << status;
    EXPECT_FALSE(folder.has("scratch"));
  }
}

TEST(Supervise, passes_signals_on_waits_and_ends_by_them) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
    const TemporaryFolder folder;
    handled = folder.file("handled");
    const auto work = [&](bool) {
      std::signal(signal, handle_signal);
      folder.touch("started");
      return sleep_long();
    };
    const pid_t supervisor = start_supervisor(folder, work);
    EXPECT_TRUE(comes_true([&] { return folder.has("started"); }));
    kill(supervisor, signal);
    const int status = status_of(supervisor);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << status;
    EXPECT_TRUE(folder.has("handled"));
    EXPECT_FALSE(folder.has("scratch"));
  }
}

TEST(Supervise, work_ends_with_a_supervisor_that_is_killed) {
  const TemporaryFolder folder;
  handled = folder.file("handled");
  const auto work = [&](bool) {
    std::signal(SIGTERM, handle_signal);
    folder.touch("started");
    return sleep_long();
  };
  const pid_t supervisor = start_supervisor(folder, work);
  EXPECT_TRUE(comes_true([&] { return folder.has("started"); }));
  kill(supervisor, SIGKILL);
  status_of(supervisor);
  EXPECT_TRUE(comes_true([&] { return folder.has("handled"); }));
}

}  // namespace

}  // namespace quadrille::chain
