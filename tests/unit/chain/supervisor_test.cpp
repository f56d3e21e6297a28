#include "chain/supervisor.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <functional>
#include <string>

#include "base/child_process.hpp"
#include "temporary_folder.hpp"

namespace quadrille::chain {
namespace {

int sleep_long() { return sleep(3600), 0; }

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
