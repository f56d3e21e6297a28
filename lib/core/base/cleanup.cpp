#include "base/cleanup.hpp"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstring>

namespace quadrille {

namespace {

// A signal handler may neither allocate nor lock: hence fixed slots, each with a flag that is set last and cleared
// first.
struct Slot {
  char path[4096];
  volatile std::sig_atomic_t is_used;
};
constexpr int num_slots = 8;
Slot slots[num_slots];

}  // namespace

int register_temporary(const std::string& path) {
  if (path.size() + 1 > sizeof(Slot::path)) return -1;
  for (int i = 0; i < num_slots; ++i) {
    if (slots[i].is_used) continue;
    std::memcpy(slots[i].path, path.c_str(), path.size() + 1);
    std::atomic_signal_fence(std::memory_order_seq_cst);
    slots[i].is_used = 1;
    return i;
  }
  return -1;
}

void release_temporary(int slot) {
  if (slot >= 0 && slot < num_slots) slots[slot].is_used = 0;
}

void remove_temporaries() noexcept {
  for (Slot& slot : slots) {
    if (!slot.is_used) continue;
    slot.is_used = 0;
    unlink(slot.path);
  }
}

}  // namespace quadrille
