#include "cli/progress_line.hpp"

#include <fmt/format.h>
#include <pthread.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <system_error>
#include <utility>

#include "base/stopwatch.hpp"

namespace quadrille::cli {

namespace {

constexpr std::size_t max_columns = 240;

// For erase_progress_line, which can read nothing else: columns of the terminal's line that are not blank.
std::atomic<std::size_t> columns_on_terminal = 0;
std::atomic<bool> is_interrupted = false;

/// A longer line would continue on the next row, which \r does not lead back from.
std::size_t columns_of_terminal() {
  winsize size{};
  const bool is_known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
  return std::min<std::size_t>(is_known ? size.ws_col - 1 : 79, max_columns);
}

std::string part_text(const Progress::Count& count) {
  switch (count.kind) {
    case Progress::Total::exact:
      return fmt::format("{} {} %", count.name, 100 * std::min(count.done, count.total) / count.total);
    case Progress::Total::bound:
      return fmt::format("{} {} of at most {}", count.name, std::min(count.done, count.total), count.total);
    case Progress::Total::unknown:
      break;
  }
  return count.done > 0 ? fmt::format("{} {}", count.name, count.done) : count.name;
}

}  // namespace

std::string progress_text(const std::string& title, const std::string& phase,
                          const std::vector<Progress::Count>& counts, double seconds) {
  std::string text = title + ": " + phase;
  for (const Progress::Count& count : counts) text += ", " + part_text(count);
  return text + fmt::format(", {} s", static_cast<long long>(seconds));
}

ProgressLine::ProgressLine(const Progress& progress, ProgressStyle style, Write write)
    : progress_(progress), style_(std::move(style)), write_(std::move(write)) {}

void ProgressLine::begin_phase(const std::string& name) {
  const std::lock_guard lock(mutex_);
  const std::vector<std::string>& hidden = style_.hidden_phases;
  phase_ = std::find(hidden.begin(), hidden.end(), name) == hidden.end() ? name : "";
  if (phase_.empty()) return erase();
  if (work_begin_ < 0) work_begin_ = seconds_of(CLOCK_MONOTONIC);
  if (!is_due()) return;
  if (style_.is_terminal)
    draw();
  else
    write_(fmt::format("{}: {} ...\n", style_.title, phase_));
}

void ProgressLine::end_phase() {
  const std::lock_guard lock(mutex_);
  phase_.clear();
  erase();
}

void ProgressLine::update() {
  const std::lock_guard lock(mutex_);
  if (is_due()) draw();
}

void ProgressLine::print(const std::string& text) {
  const std::lock_guard lock(mutex_);
  erase();
  write_(text + "\n");
  if (style_.is_terminal && is_due()) draw();
}

double ProgressLine::seconds() const { return style_.seconds_before + seconds_of(CLOCK_MONOTONIC) - work_begin_; }

bool ProgressLine::is_due() const { return !phase_.empty() && seconds() >= style_.delay; }

void ProgressLine::draw() {
  auto counts = progress_.counts();
  if (!counts || is_interrupted) return;
  const double now = seconds();
  std::string text = progress_text(style_.title, phase_, *counts, now);
  if (style_.is_terminal) {
    const std::size_t columns = columns_of_terminal();
    while (text.size() > columns && !counts->empty()) {
      counts->pop_back();
      text = progress_text(style_.title, phase_, *counts, now);
    }
    text.resize(std::min(text.size(), columns));
  }
  if (text == shown_) return;
  if (style_.is_terminal) {
    const std::size_t blanks = shown_.size() - std::min(shown_.size(), text.size());
    columns_on_terminal = std::max(text.size(), shown_.size());
    write_("\r" + text + std::string(blanks, ' ') + std::string(blanks, '\b'));
    columns_on_terminal = text.size();
  } else {
    write_(text + "\n");
  }
  shown_ = std::move(text);
}

void ProgressLine::erase() {
  if (style_.is_terminal && !shown_.empty()) write_(fmt::format("\r{:{}}\r", "", shown_.size()));
  if (style_.is_terminal) columns_on_terminal = 0;
  shown_.clear();
}

ProgressTicker::ProgressTicker(ProgressLine& line, double interval) {
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);  // the thread inherits this: signals interrupt the others, as without it
  try {
    thread_ = std::jthread([&line, interval](const std::stop_token& stop) {
      std::mutex mutex;
      std::condition_variable_any wake;
      std::unique_lock lock(mutex);
      while (!stop.stop_requested()) {
        wake.wait_for(lock, stop, std::chrono::duration<double>(interval), [] { return false; });
        if (!stop.stop_requested()) line.update();
      }
    });
  } catch (const std::system_error&) {
    // No more threads can be had: the line changes with the phases only.
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

void erase_progress_line() noexcept {
  is_interrupted = true;
  const std::size_t columns = std::min(columns_on_terminal.load(), max_columns);
  if (columns == 0) return;
  char blanks[max_columns + 2];
  blanks[0] = '\r';
  for (std::size_t i = 1; i <= columns; ++i) blanks[i] = ' ';
  blanks[columns + 1] = '\r';
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, blanks, columns + 2);
}

}  // namespace quadrille::cli
