#include "chain/process_tree.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "base/child_process.hpp"
#include "temporary_folder.hpp"

namespace quadrille::chain {

namespace {

int wait_for_signal() { return pause(), 0; }

TEST(ProcessTree, finds_descendants_also_if_others_were_seen_before) {
  const pid_t root = start_child(
      [] {
        start_child(wait_for_signal, SIGKILL);
        start_child([] { return start_child(wait_for_signal, SIGKILL), wait_for_signal(); }, SIGKILL);
        return wait_for_signal();
      },
      SIGKILL);
  ProcessTree tree(root);
  EXPECT_TRUE(comes_true([&] { return tree.update(), tree.members().size() == 4; }));
  EXPECT_FALSE(tree.members().contains(getpid()));
  EXPECT_GT(tree.memory(), 0);
  tree.kill(SIGKILL);
  waitpid(root, nullptr, 0);
  tree.update();
  EXPECT_FALSE(tree.members().contains(root));
}

TEST(ProcessTree, of_a_process_that_has_ended_uses_nothing) {
  const pid_t root = start_child([] { return 0; }, SIGKILL);
  waitpid(root, nullptr, 0);
  EXPECT_EQ(ProcessTree(root).cpu_seconds(), 0);
  EXPECT_EQ(ProcessTree(root).memory(), 0);
}

}  // namespace

}  // namespace quadrille::chain
