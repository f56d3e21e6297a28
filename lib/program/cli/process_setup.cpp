#include "cli/process_setup.hpp"

#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include "base/cleanup.hpp"
#include "cli/progress_line.hpp"

namespace quadrille::cli {

namespace {

extern "C" void end_of_signal(int number) {
  remove_temporaries();
  erase_progress_line();
  // The default action is in force again (SA_RESETHAND): the signal is delivered when the handler returns.
  std::raise(number);
}

}  // namespace

void install_signal_handlers() {
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXCPU}) {
    struct sigaction action {};
    if (sigaction(number, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) continue;
    action = {};
    action.sa_handler = end_of_signal;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigemptyset(&action.sa_mask);
    sigaction(number, &action, nullptr);
  }
  std::signal(SIGXFSZ, SIG_IGN);
}

namespace {

#ifdef QUADRILLE_SANITIZE
constexpr bool is_of_sanitizer = true;  // whose heap is another, and fills what it reserves
#else
constexpr bool is_of_sanitizer = false;
#endif

constexpr std::size_t huge_page = 2 << 20, small_page = 4 << 10;
constexpr std::size_t least_reserve = 64 << 20, most_reserve = std::size_t{3} << 30;

std::string text_of(const char* path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

bool has_limit(int resource) {
  rlimit limit{};
  return getrlimit(static_cast<__rlimit_resource_t>(resource), &limit) != 0 || limit.rlim_cur != RLIM_INFINITY;
}

// Where few huge pages are free, the system spends more on making room for them than they save, so half of them are
// left to others. Where addresses are limited, or count as memory (vm.overcommit_memory is 2), few are reserved.
std::size_t reserve_size() {
  if (has_limit(RLIMIT_AS) || has_limit(RLIMIT_DATA) || text_of("/proc/sys/vm/overcommit_memory").starts_with('2'))
    return least_reserve;
  return std::clamp(free_huge_page_bytes(text_of("/proc/buddyinfo")) / 2, least_reserve, most_reserve);
}

char* next_huge_page(void* address) {
  return static_cast<char*>(address) + (huge_page - reinterpret_cast<std::uintptr_t>(address) % huge_page) % huge_page;
}

}  // namespace

std::size_t free_huge_page_bytes(std::string_view buddy_info) {
  std::size_t bytes = 0;
  std::istringstream lines{std::string(buddy_info)};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string node, number, zone, name;
    words >> node >> number >> zone >> name;
    std::size_t block = small_page;
    for (std::size_t count = 0; words >> count; block *= 2)
      if (block >= huge_page) bytes += count * block;
  }
  return bytes;
}

void set_up_heap() {
  if (is_of_sanitizer) return;
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);
  void* block = std::malloc(reserve_size());
  if (!block) block = std::malloc(least_reserve);
  char* const begin = next_huge_page(block);
  char* const end = static_cast<char*>(sbrk(0));
  if (block && begin < end) madvise(begin, static_cast<std::size_t>(end - begin), MADV_HUGEPAGE);
  std::free(block);
  mallopt(M_TOP_PAD, 1 << 20);
}

}  // namespace quadrille::cli
